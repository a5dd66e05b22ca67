//! Oracle for models of fragments: the faces of `fragment_faces` at every level and for any closed set of
//! steps.

use std::fmt::Debug;

use striata::mesh::{
    FragmentSequence, FragmentedMesh, canonical_triangles, fragment_faces, replay_fragments, shapes,
};
use striata::model::LodModel;

use super::oracle::follows_levels;
use super::{Random, grid, random_removals};

/// Checks a model of fragments, as [`follows_the_oracle`](super::follows_the_oracle) checks a model of
/// collapses.
pub fn follows_the_fragments<M>(mesh: &FragmentedMesh, model: &M, stride: usize)
where
    M: LodModel,
    M::State: Clone + Debug + PartialEq,
{
    let level_of = |split_count| replay_fragments(mesh, split_count);
    follows_levels(model, mesh.fragments.step_count(), stride, |split_count| split_count, level_of);
}

/// Checks that triangles are those of a closed set of steps, in any order.
pub fn assert_shows_set(
    fragments: &FragmentSequence,
    triangles: &[[u32; 3]],
    is_refined: impl Fn(u32) -> bool,
) {
    let faces = fragment_faces(fragments, is_refined);
    let expected: Vec<[u32; 3]> =
        faces.iter().map(|&face| fragments.faces()[face as usize].corners).collect();
    assert_eq!(canonical_triangles(triangles), canonical_triangles(&expected));
}

/// Returns the smallest closed set that contains each step with a probability of `percent`.
pub fn random_closed_set(fragments: &FragmentSequence, percent: usize, random: &mut Random) -> Vec<bool> {
    let mut is_refined: Vec<bool> =
        (0..fragments.step_count()).map(|_| random.below(100) < percent).collect();
    for step in (0..is_refined.len()).rev() {
        if is_refined[step] {
            for creating_step in
                fragments.floor(step as u32).iter().filter_map(|&face| fragments.creating_step(face))
            {
                is_refined[creating_step as usize] = true;
            }
        }
    }
    is_refined
}

/// Enumerates all closed sets as bit masks by brute force; for short sequences only.
pub fn closed_sets(fragments: &FragmentSequence) -> Vec<u32> {
    let step_count = fragments.step_count();
    assert!(step_count <= 16, "{step_count} steps have too many sets");
    let needs: Vec<u32> = (0..step_count as u32)
        .map(|step| {
            let makers = fragments.floor(step).iter().filter_map(|&face| fragments.creating_step(face));
            makers.fold(0, |all, maker| all | 1 << maker)
        })
        .collect();
    let has_needs = |set: u32| (0..step_count).all(|s| set >> s & 1 == 0 || needs[s] & !set == 0);
    (0..1u32 << step_count).filter(|&set| has_needs(set)).collect()
}

/// Returns the smallest closed set without a replaceable face that is too coarse; panics if it is not
/// contained in all other such sets. For a step without a floor, `is_coarse` is called without a face.
pub fn smallest_set(
    fragments: &FragmentSequence,
    closed_sets: &[u32],
    is_coarse: impl Fn(Option<u32>, u32) -> bool,
) -> u32 {
    let replaced_by = fragments.replacing_steps();
    let base_count = fragments.base_face_count() as u32;
    let is_refined = |set: u32, step: u32| set >> step & 1 == 1;
    let is_fine = |set: u32| {
        let is_shown =
            |face: u32| face < base_count || is_refined(set, fragments.creating_step(face).unwrap());
        let mut faces = (0..replaced_by.len() as u32).filter(|&face| is_shown(face));
        let has_coarse_face = faces.any(|face| {
            let upper = replaced_by[face as usize];
            upper != FragmentSequence::NO_STEP && !is_refined(set, upper) && is_coarse(Some(face), upper)
        });
        let mut floorless =
            (0..fragments.step_count() as u32).filter(|&step| fragments.floor(step).is_empty());
        !has_coarse_face && floorless.all(|step| is_refined(set, step) || !is_coarse(None, step))
    };
    let fine: Vec<u32> = closed_sets.iter().copied().filter(|&set| is_fine(set)).collect();
    let smallest = fine.iter().copied().min_by_key(|set| set.count_ones()).expect("the full mesh is fine");
    assert!(fine.iter().all(|set| set & smallest == smallest), "several sets are smallest");
    smallest
}

/// Surfaces with and without boundary, with random vertex removals and random triangulations of the holes.
pub fn fragment_cases() -> impl Iterator<Item = (u64, FragmentedMesh)> {
    let mut holed = grid(9, false);
    holed.triangles.retain(|t| !(t.contains(&34) && t.contains(&35) || t.contains(&66) && t.contains(&76)));
    let meshes = [
        grid(8, true),
        grid(9, false),
        holed,
        shapes::icosphere(2, 1.0),
        shapes::terrain(12, 3),
        shapes::torus(9, 7, 2.0, 1.0),
    ];
    meshes.into_iter().flat_map(|mesh| {
        (1..5).map(move |seed| (seed, random_removals(&mesh, usize::MAX, &mut Random::new(seed))))
    })
}
