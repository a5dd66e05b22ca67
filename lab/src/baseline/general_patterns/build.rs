//! Builds the model from the steps, in the order of simplification.

use striata::mesh::{FragmentSequence, FragmentedMesh};
use striata::model::{ModelError, StepVertices};

use super::GeneralPatterns;
use super::records::{MAX_LOOPS, PatternHead, PatternLink, PatternRecords};
use super::rule::{PatternRuleFinder, PatternShape};

const NO_STEP: u32 = FragmentSequence::NO_STEP;

impl GeneralPatterns {
    /// Builds the model.
    ///
    /// # Errors
    /// [`ModelError`] with the first step that no rule can represent; if there are several groups, seams,
    /// more than 31 loops through a fragment or 65,536 rules.
    pub fn build(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        let fragments = &mesh.fragments;
        let levels = fragments.levels();
        if mesh.mesh.groups.len() > 1 {
            let (found, limit) = (mesh.mesh.groups.len() as u64, 1);
            return Err(ModelError::Form { what: "group of triangles", found, limit });
        }
        let vertices = StepVertices::of_levels(levels);
        let corners = |face: u32| fragments.faces()[face as usize].corners;
        let mut rules = PatternRuleFinder::default();
        let mut shapes = Vec::with_capacity(levels.step_count());
        for step in 0..levels.step_count() as u32 {
            let ceiling: Vec<_> = fragments.ceiling(step).map(corners).collect();
            let floor: Vec<_> = fragments.floor(step).iter().map(|&face| corners(face)).collect();
            let own = vertices.of_step(step as usize);
            let shape = PatternShape::of(own, &ceiling, &floor)
                .map_err(|reason| ModelError::Step { step: step as usize, reason })?;
            shapes.push((rules.index_of(shape.code), shape.vertices));
        }
        let (rules, new_indices) = rules.finish()?;
        let replaced_by = fragments.replacing_steps();
        let (heads, links) = loops_of(fragments, &replaced_by)?;
        let mut records = PatternRecords::default();
        for ((down, links), (rule, vertices)) in heads.into_iter().zip(&links).zip(&shapes) {
            let rule = new_indices[*rule as usize];
            let (&[a, b], listed) = vertices.split_first_chunk().expect("a fragment has two anchors");
            records.push(&PatternHead { anchors: [a, b], rule, down }, links, listed);
        }
        let base_count = fragments.base_face_count();
        let mut base_covers: Vec<u32> = replaced_by[..base_count].to_vec();
        base_covers.retain(|&cover| cover != NO_STEP);
        base_covers.extend((0..fragments.step_count() as u32).filter(|&s| fragments.floor(s).is_empty()));
        base_covers.sort_unstable();
        base_covers.dedup();
        let base = (0..base_count as u32).map(corners).collect();
        Ok(Self { vertices, base, base_covers, rules, records })
    }
}

/// The link down of each fragment, and its links in the loops of those that cover it.
fn loops_of(
    fragments: &FragmentSequence,
    replaced_by: &[u32],
) -> Result<(Vec<PatternLink>, Vec<Vec<PatternLink>>), ModelError> {
    let step_count = fragments.step_count() as u32;
    let mut downs: Vec<PatternLink> = (0..step_count).map(PatternLink::back_to).collect();
    let mut links = vec![Vec::new(); step_count as usize];
    for step in (0..step_count).rev() {
        let mut covers: Vec<u32> = fragments.ceiling(step).map(|face| replaced_by[face as usize]).collect();
        covers.retain(|&cover| cover != NO_STEP);
        covers.sort_unstable();
        covers.dedup();
        if covers.len() > MAX_LOOPS {
            let (found, limit) = (covers.len() as u64, MAX_LOOPS as u64);
            return Err(ModelError::Form { what: "loops through one fragment", found, limit });
        }
        for (index, cover) in covers.into_iter().enumerate() {
            links[step as usize]
                .push(std::mem::replace(&mut downs[cover as usize], PatternLink::to(step, index)));
        }
    }
    Ok((downs, links))
}
