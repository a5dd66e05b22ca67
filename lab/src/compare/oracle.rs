//! Checks models against the oracle: a comparison is worthless if a model shows wrong triangles.

use striata::mesh::{RefinableMesh, canonical_triangles, replay_into};

use super::contenders::Contender;
use striata_command::failure::Failure;

/// Number of levels that are checked, on the way down and again on the way up.
const LEVEL_COUNT: usize = 10;

/// A model and its name.
pub(super) struct Checked<'c> {
    /// Name of the model.
    pub name: &'static str,
    /// Whether it may show a coarser level than requested.
    pub has_few_levels: bool,
    /// The model.
    pub contender: &'c mut dyn Contender,
}

/// Moves all models through the same levels, down and up, and compares their triangles with plain
/// substitution.
///
/// # Errors
/// If a model shows wrong triangles; the error names the model and the level.
pub(super) fn check(models: &mut [Checked<'_>], refinable: &RefinableMesh) -> Result<(), Failure> {
    let step_count = refinable.sequence.step_count();
    let mut levels: Vec<usize> =
        (0..LEVEL_COUNT).map(|i| i * step_count / (LEVEL_COUNT - 1).max(1)).collect();
    levels.dedup();
    for &level in levels.iter().rev().chain(&levels) {
        let expected = at(refinable, level);
        for model in &mut *models {
            check_level(model, refinable, level, &expected)?;
        }
    }
    Ok(())
}

fn at(refinable: &RefinableMesh, split_count: usize) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    replay_into(&refinable.sequence, split_count, &refinable.mesh.triangles, &mut triangles);
    canonical_triangles(&triangles)
}

fn check_level(
    model: &mut Checked<'_>,
    refinable: &RefinableMesh,
    level: usize,
    expected: &[[u32; 3]],
) -> Result<(), Failure> {
    let Checked { name, has_few_levels, contender } = model;
    let wrong = |what: &str| Err(Failure::internal(format!("{name} at split count {level}: {what}")));
    contender.move_to(level);
    let shown = contender.split_count();
    if shown != level && !*has_few_levels {
        return wrong(&format!("it reports split count {shown}"));
    }
    let mut triangles = Vec::new();
    contender.triangles_into(&mut triangles);
    let found = canonical_triangles(&triangles);
    let is_right = if shown == level { found == expected } else { found == at(refinable, shown) };
    if !is_right {
        return wrong(&format!("its {} triangles are not those of split count {shown}", found.len()));
    }
    let mut indices = Vec::new();
    contender.indices_into(&mut indices);
    let reported = contender.draw_counts().index_count;
    if indices.len() != reported {
        return wrong(&format!("it draws {} indices but reports {reported}", indices.len()));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use striata::mesh::{FragmentedMesh, shapes};
    use striata::simplify::{SequenceOptions, TopologyRule, build_sequence};
    use striata_strip::{StripOptions, stripify};

    use super::super::contenders::{ModelInputs, compared_models, entries};
    use super::*;

    #[test]
    fn wrong_triangles_are_reported_with_model_and_level() {
        // Some of the models require manifolds.
        let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
        let built = build_sequence(&shapes::torus(12, 8, 1.0, 0.4), &options);
        let right = built.unwrap().refinable;
        let mut wrong = right.clone();
        wrong.mesh.triangles[0].swap(0, 1);
        let level_strips = StripOptions::default();
        let strips = stripify(&right.mesh, &level_strips).unwrap();
        let fragmented = FragmentedMesh::from_collapses(&right);
        let inputs = ModelInputs {
            refinable: &right,
            fragmented: &fragmented,
            strips: &strips,
            level_strips: &level_strips,
        };
        for entry in entries(&compared_models().collect::<Vec<_>>()).unwrap() {
            let mut contender = entry.build(inputs).unwrap();
            let (name, has_few_levels) = (entry.name, entry.has_few_levels);
            let mut check_with = |refinable| {
                check(&mut [Checked { name, has_few_levels, contender: &mut *contender }], refinable)
            };
            assert!(check_with(&right).is_ok(), "{name}");
            let message = format!("{:?}", check_with(&wrong).unwrap_err());
            let prefix = format!("{name} at split count {}: ", right.sequence.step_count());
            assert!(message.contains(&prefix), "{message}");
        }
    }
}
