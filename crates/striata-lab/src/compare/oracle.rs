//! Holds models to the oracle: a comparison is worth nothing where a model shows something else.

use striata::mesh::{RefinableMesh, canonical_triangles, replay_into};

use super::contenders::Contender;
use striata_command::failure::Failure;

/// Levels that are looked at, on the way down and on the way up.
const LEVEL_COUNT: usize = 10;

/// A model and what it is called.
pub(super) struct Checked<'c> {
    /// Its name.
    pub(super) name: &'static str,
    /// Whether it may show a coarser level than it is asked for.
    pub(super) has_few_levels: bool,
    /// The model.
    pub(super) contender: &'c mut dyn Contender,
}

/// Moves all models through the same levels, down and up, and compares what they show with plain substitution.
///
/// # Errors
/// Where a model shows something else; names the model and the level.
pub(super) fn check(models: &mut [Checked<'_>], refinable: &RefinableMesh) -> Result<(), Failure> {
    let step_count = refinable.sequence.step_count();
    let mut levels: Vec<usize> =
        (0..LEVEL_COUNT).map(|i| i * step_count / (LEVEL_COUNT - 1).max(1)).collect();
    levels.dedup();
    for &level in levels.iter().rev().chain(&levels) {
        let wanted = at(refinable, level);
        for model in &mut *models {
            check_level(model, refinable, level, &wanted)?;
        }
    }
    Ok(())
}

fn at(refinable: &RefinableMesh, split_count: usize) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    replay_into(refinable, split_count, &refinable.mesh.triangles, &mut triangles);
    canonical_triangles(&triangles)
}

fn check_level(
    model: &mut Checked<'_>,
    refinable: &RefinableMesh,
    level: usize,
    wanted: &[[u32; 3]],
) -> Result<(), Failure> {
    let Checked { name, has_few_levels, contender } = model;
    let wrong = |what: &str| Err(Failure::internal(format!("{name} at split count {level}: {what}")));
    contender.move_to(level);
    let shown = contender.split_count();
    if shown != level && !*has_few_levels {
        return wrong(&format!("it says that it shows split count {shown}"));
    }
    let mut triangles = Vec::new();
    contender.triangles_into(&mut triangles);
    let found = canonical_triangles(&triangles);
    let is_right = if shown == level { found == wanted } else { found == at(refinable, shown) };
    if !is_right {
        return wrong(&format!("its {} triangles are not those of split count {shown}", found.len()));
    }
    let mut indices = Vec::new();
    contender.indices_into(&mut indices);
    let announced = contender.draw_counts().index_count;
    if indices.len() != announced {
        return wrong(&format!("it draws {} indices and announces {announced}", indices.len()));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use striata::mesh::{FragmentedMesh, shapes};
    use striata::simplify::{SequenceOptions, TopologyRule, build_sequence};
    use striata_strip::{StripOptions, stripify};

    use super::super::contenders::{Given, compared_models, entries};
    use super::*;

    #[test]
    fn a_model_that_shows_something_else_is_named_with_its_level() {
        // Some of the models are for manifolds only.
        let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
        let built = build_sequence(&shapes::torus(12, 8, 1.0, 0.4), &options);
        let right = built.unwrap().refinable;
        let mut wrong = right.clone();
        wrong.mesh.triangles[0].swap(0, 1);
        let level_strips = StripOptions::default();
        let strips = stripify(&right.mesh, &level_strips).unwrap();
        let fragmented = FragmentedMesh::from_collapses(&right);
        let given = Given {
            refinable: &right,
            fragmented: &fragmented,
            strips: &strips,
            level_strips: &level_strips,
        };
        for entry in entries(&compared_models().collect::<Vec<_>>()).unwrap() {
            let mut contender = entry.build(given).unwrap();
            let (name, has_few_levels) = (entry.name, entry.has_few_levels);
            let mut check_with = |refinable| {
                check(&mut [Checked { name, has_few_levels, contender: &mut *contender }], refinable)
            };
            assert!(check_with(&right).is_ok(), "{name}");
            let said = format!("{:?}", check_with(&wrong).unwrap_err());
            let place = format!("{name} at split count {}: ", right.sequence.step_count());
            assert!(said.contains(&place), "{said}");
        }
    }
}
