//! Tightness of guaranteed errors: the ratio of the guaranteed to the measured distance from the original
//! to the level.
//!
//! Guarantees are for collapses in the default order, certified for levels and for any state, and for
//! removals; distances are measured at samples of the original.

use std::io::Write;

use striata::mesh::{
    DistanceOptions, FragmentedMesh, IndexedMesh, LevelTable, replay_fragments, surface_distance,
};
use striata::simplify::{
    RemovalOptions, SequenceOptions, build_welded_fragments, build_welded_sequence, certify,
    certify_collapses,
};

use super::table::Table;
use super::{Fallible, Request, Subject};

/// Percentages of the triangles at which levels are measured.
const PERCENTS: [usize; 6] = [75, 50, 25, 10, 5, 2];
/// Distances below this share of the diagonal count as zero, and have no meaningful ratio.
const NEGLIGIBLE: f64 = 1e-9;

pub(crate) fn report(request: &Request, subjects: &[Subject], out: &mut dyn Write) -> Fallible<()> {
    let head = ["mesh".to_owned(), "guaranteed for".to_owned()];
    let mut table = Table::new(head.into_iter().chain(PERCENTS.map(|percent| format!("{percent} %"))));
    let mut ratios: [Vec<f64>; 3] = Default::default();
    for subject in subjects {
        let built = build_welded_sequence(subject.welded.clone(), &SequenceOptions::default())?;
        let collapses = FragmentedMesh::from_collapses(&built.refinable);
        let for_levels = certify_collapses(&built.refinable).sequence.levels().clone();
        let for_any = certify(&collapses).fragments.levels().clone();
        let options = RemovalOptions::default();
        let removals = build_welded_fragments(subject.welded.clone(), &options)?.fragmented;
        let guaranteed = [
            ("levels of collapses", &collapses, &for_levels),
            ("any state of collapses", &collapses, &for_any),
            ("any state of removals", &removals, removals.fragments.levels()),
        ];
        for ((name, mesh, levels), ratios) in guaranteed.into_iter().zip(&mut ratios) {
            let row = row(request, subject.mesh(), mesh, levels, ratios)?;
            table.push([subject.name.clone(), name.to_owned()].into_iter().chain(row).collect());
        }
    }
    table.print(out)?;
    for ratios in &mut ratios {
        ratios.sort_by(f64::total_cmp);
        if let (Some(min), Some(max)) = (ratios.first(), ratios.last()) {
            let median = ratios[ratios.len() / 2];
            writeln!(out, "median {median:.3}, from {min:.3} to {max:.3}")?;
        }
    }
    Ok(())
}

/// The ratio at each level, and the guaranteed error in 1e-5 of the diagonal.
fn row(
    request: &Request,
    original: &IndexedMesh,
    mesh: &FragmentedMesh,
    levels: &LevelTable,
    ratios: &mut Vec<f64>,
) -> Fallible<Vec<String>> {
    let diagonal = original.diagonal();
    let options = DistanceOptions::default().with_sample_count(request.sample_count);
    let mut cells = Vec::new();
    for percent in PERCENTS {
        let split_count = levels.split_count_for_triangles(original.triangle_count() * percent / 100);
        let level = replay_fragments(mesh, split_count).without_unused_vertices();
        let measured = surface_distance(original, &level, &options)?.a_to_b.max;
        let guaranteed = f64::from(levels.error_at(split_count));
        if measured < NEGLIGIBLE * diagonal {
            cells.push(format!("- ({:.3})", 1e5 * guaranteed / diagonal));
            continue;
        }
        ratios.push(guaranteed / measured);
        cells.push(format!("{:.2} ({:.1})", guaranteed / measured, 1e5 * guaranteed / diagonal));
    }
    Ok(cells)
}
