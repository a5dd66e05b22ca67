//! What every model of fragments is held to: the faces of `fragment_faces` at every level and for any closed set of steps.

use std::fmt::Debug;

use striata::mesh::{
    FragmentSequence, FragmentedMesh, canonical_triangles, fragment_faces, replay_fragments, shapes,
};
use striata::model::LodModel;

use super::oracle::follows_levels;
use super::{Random, grid, random_removals};

/// Does as [`follows_the_oracle`](super::follows_the_oracle) for a model of fragments.
pub fn follows_the_fragments<M>(mesh: &FragmentedMesh, model: &M, stride: usize)
where
    M: LodModel,
    M::State: Clone + Debug + PartialEq,
{
    let level_of = |split_count| replay_fragments(mesh, split_count);
    follows_levels(model, mesh.fragments.step_count(), stride, |split_count| split_count, level_of);
}

/// Holds triangles to those that a closed set of steps shows, in any order.
pub fn shows_a_set(fragments: &FragmentSequence, triangles: &[[u32; 3]], is_taken: impl Fn(u32) -> bool) {
    let faces = fragment_faces(fragments, is_taken);
    let expected: Vec<[u32; 3]> =
        faces.iter().map(|&face| fragments.faces()[face as usize].corners).collect();
    assert_eq!(canonical_triangles(triangles), canonical_triangles(&expected));
}

/// The smallest closed set with some percent of all steps, each chosen by chance.
pub fn random_closed_set(fragments: &FragmentSequence, percent: usize, random: &mut Random) -> Vec<bool> {
    let mut is_taken: Vec<bool> = (0..fragments.step_count()).map(|_| random.below(100) < percent).collect();
    for step in (0..is_taken.len()).rev() {
        if is_taken[step] {
            for maker in fragments.floor(step as u32).iter().filter_map(|&face| fragments.creating_step(face))
            {
                is_taken[maker as usize] = true;
            }
        }
    }
    is_taken
}

/// All closed sets, as bits, by trying all sets: for sequences of few steps.
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

/// The smallest of the closed sets in which no face is there that is too coarse, where something can replace it; fails
/// where it is not part of all others. A step without a floor is asked for with no face.
pub fn smallest_set(
    fragments: &FragmentSequence,
    closed_sets: &[u32],
    is_coarse: impl Fn(Option<u32>, u32) -> bool,
) -> u32 {
    let replaced_by = fragments.replacing_steps();
    let base_count = fragments.base_face_count() as u32;
    let is_taken = |set: u32, step: u32| set >> step & 1 == 1;
    let is_fine = |set: u32| {
        let is_there = |face: u32| face < base_count || is_taken(set, fragments.creating_step(face).unwrap());
        let mut faces = (0..replaced_by.len() as u32).filter(|&face| is_there(face));
        let has_coarse_face = faces.any(|face| {
            let upper = replaced_by[face as usize];
            upper != FragmentSequence::NO_STEP && !is_taken(set, upper) && is_coarse(Some(face), upper)
        });
        let mut floorless =
            (0..fragments.step_count() as u32).filter(|&step| fragments.floor(step).is_empty());
        !has_coarse_face && floorless.all(|step| is_taken(set, step) || !is_coarse(None, step))
    };
    let fine: Vec<u32> = closed_sets.iter().copied().filter(|&set| is_fine(set)).collect();
    let smallest = fine.iter().copied().min_by_key(|set| set.count_ones()).expect("the full mesh is fine");
    assert!(fine.iter().all(|set| set & smallest == smallest), "several sets are smallest");
    smallest
}

/// Surfaces with and without borders, with random removals and any triangulations of the holes.
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
