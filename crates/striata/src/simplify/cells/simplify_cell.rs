//! The cell task: simplifies the inside of a cell, and numbers its steps and survivors.

use super::trace::CellTrace;
use super::union::{BORDER, CellUnion, append};
use super::{Cell, CellMesh, CellOptions, CellSteps, SimplifiedCell};
use crate::ignore_progress;
use crate::mesh::{AttributeLayer, gather_layers};
use crate::simplify::collapse::refinement_order::CollapseRecord;
use crate::simplify::collapse::simplifier::Simplifier;
use crate::simplify::{SequenceOptions, SimplifyError, StopReason};

const NONE: u32 = u32::MAX;

/// Simplifies the triangles inside a cell. Those at its border do not change, and lock their corners.
///
/// # Errors
/// [`SimplifyError`] if the cell is inconsistent or an option is out of range.
pub fn simplify_cell(cell: &Cell, options: &CellOptions) -> Result<SimplifiedCell, SimplifyError> {
    options.sequence.check()?;
    let union = CellUnion::new(cell, &options.materials)?;
    let inside_count = union.inside_of.iter().filter(|&&t| t != BORDER).count();
    let border_count = union.inside_of.len() - inside_count;
    let share = (inside_count as f64 * options.keep.clamp(0.0, 1.0)) as usize;
    let kept = share.max(options.sequence.base_triangle_count);
    let sequence = SequenceOptions {
        base_triangle_count: border_count + kept,
        locked_vertices: union.locked_vertices.clone(),
        // Errors of finer levels count, too, which the simplifier does not know.
        max_error: None,
        // A contraction could connect the cell to another one.
        pair_distance: None,
        ..options.sequence.clone()
    };
    let scale = if options.diagonal > 0.0 { options.diagonal } else { 1.0 };
    let simplifier = Simplifier::of_cell(&union.welded, &sequence, scale);
    let (mut record, mut stop_reason) = simplifier.run(&mut ignore_progress)?;
    let targets = targets_within(&union, &record);
    let mut trace = CellTrace::new(&union, &cell.inside);
    trace.run(&record, &targets, scale);
    let is_kept = trace.within(options.sequence.max_error.unwrap_or(f64::INFINITY));
    if is_kept.contains(&false) {
        record.retain(&is_kept);
        stop_reason = StopReason::ErrorLimit;
        trace = CellTrace::new(&union, &cell.inside);
        trace.run(&record, &targets, scale);
    }
    let numbering = Numbering::new(&union, &record);
    let steps = cell_steps(
        &CellParts { cell, union: &union, record: &record, numbering: &numbering },
        &trace,
        &targets,
    );
    let survivors =
        survivors(&CellParts { cell, union: &union, record: &record, numbering: &numbering }, &trace);
    Ok(SimplifiedCell { steps, survivors, stop_reason })
}

/// Targets of the record; those outside of the cell are replaced by neighbors within it.
///
/// What replaces a vanished part may be any near surface, but another cell may remove a position outside.
fn targets_within(union: &CellUnion, record: &CollapseRecord) -> Vec<u32> {
    let positions = &union.welded.positions;
    let mut targets = record.targets.clone();
    if union.is_within.iter().all(|&is_within| is_within) {
        return targets;
    }
    let mut replacement = vec![NONE; union.is_within.len()];
    for (t, corners) in union.welded.mesh.triangles.iter().enumerate() {
        if union.inside_of[t] != BORDER {
            continue;
        }
        let within = corners.iter().copied().find(|&v| union.is_within[positions.position_of(v) as usize]);
        for &v in corners {
            let p = positions.position_of(v) as usize;
            if !union.is_within[p]
                && let Some(w) = within
                && replacement[p] == NONE
            {
                replacement[p] = positions.first_vertex(positions.position_of(w));
            }
        }
    }
    for v in record.removed.iter().flat_map(|&p| positions.wedges(p)) {
        let target = &mut targets[v as usize];
        let other = replacement[positions.position_of(*target) as usize];
        if other != NONE {
            *target = other;
        }
    }
    targets
}

/// Everything that the results are numbered from.
struct CellParts<'a> {
    cell: &'a Cell,
    union: &'a CellUnion,
    record: &'a CollapseRecord,
    numbering: &'a Numbering,
}

/// Numbers of the vertices of the steps.
struct Numbering {
    /// First owned vertex of each removed position, in reverse order of removal; then their number.
    first: Vec<u32>,
    /// Number of each welded vertex among those owned; `NONE` for others.
    owned: Vec<u32>,
    /// Owned vertices: index of a welded vertex, or that of a lone input vertex plus the welded count.
    sources: Vec<u32>,
}

impl Numbering {
    fn new(union: &CellUnion, record: &CollapseRecord) -> Self {
        let positions = &union.welded.positions;
        let welded_count = positions.vertex_count() as u32;
        let mut numbering =
            Self { first: vec![0], owned: vec![NONE; welded_count as usize], sources: Vec::new() };
        for &p in record.removed.iter().rev() {
            for v in positions.wedges(p) {
                numbering.owned[v as usize] = numbering.sources.len() as u32;
                numbering.sources.push(v);
            }
            numbering.sources.extend(lone_at(union, p).map(|v| v + welded_count));
            numbering.first.push(numbering.sources.len() as u32);
        }
        numbering
    }
}

/// Lone vertices of the inside part at a position.
fn lone_at(union: &CellUnion, p: u32) -> impl Iterator<Item = u32> + '_ {
    let from = union.lone.partition_point(|&(q, _)| q < p);
    union.lone[from..].iter().take_while(move |&&(q, _)| q == p).map(|&(_, v)| v)
}

/// Copies vertices, given as in [`Numbering::sources`].
fn gather(parts: &CellParts<'_>, sources: &[u32]) -> (Vec<[f32; 3]>, Vec<AttributeLayer>) {
    let CellParts { cell, union, .. } = parts;
    let mesh = &union.welded.mesh;
    let welded_count = mesh.vertex_count() as u32;
    let position = |&v: &u32| match v.checked_sub(welded_count) {
        None => mesh.positions[v as usize],
        Some(lone) => cell.inside.positions[lone as usize].map(|x| x + 0.0),
    };
    let layers = mesh.layers.iter().enumerate().map(|(i, layer)| {
        let mut out = layer.gather(&[]);
        for run in sources.chunk_by(|a, b| (*a < welded_count) == (*b < welded_count)) {
            if run[0] < welded_count {
                append(&mut out.data, &layer.gather(run).data);
            } else {
                let lone: Vec<u32> = run.iter().map(|v| v - welded_count).collect();
                append(&mut out.data, &cell.inside.layers[i].gather(&lone).data);
            }
        }
        out
    });
    (sources.iter().map(position).collect(), layers.collect())
}

fn cell_steps(parts: &CellParts<'_>, trace: &CellTrace<'_>, targets: &[u32]) -> CellSteps {
    let CellParts { cell, union, record, numbering } = parts;
    let mesh = &union.welded.mesh;
    let welded_count = mesh.vertex_count() as u32;
    let mut sources = numbering.sources.clone();
    let mut number = numbering.owned.clone();
    let mut number_of = |v: u32, sources: &mut Vec<u32>| {
        if number[v as usize] == NONE {
            number[v as usize] = sources.len() as u32;
            sources.push(v);
        }
        number[v as usize]
    };
    let mut steps = CellSteps { first: numbering.first.clone(), ..CellSteps::default() };
    for (i, &p) in record.removed.iter().enumerate().rev() {
        let first = targets[union.welded.positions.first_vertex(p) as usize];
        let at = record.removed.len() - 1 - i;
        for &source in &numbering.sources[steps.first[at] as usize..steps.first[at + 1] as usize] {
            // A wedge without triangles may become any wedge of the target.
            let target = if source < welded_count { targets[source as usize] } else { first };
            steps.targets.push(number_of(target, &mut sources));
        }
        steps.keys.push(trace.steps[i].key);
        steps.errors.push(trace.steps[i].error);
    }
    let mut stems_from = Vec::new();
    for (t, corners) in mesh.triangles.iter().enumerate() {
        if corners.iter().any(|&v| numbering.owned[v as usize] != NONE) {
            steps.triangles.push(corners.map(|v| number_of(v, &mut sources)));
            steps.groups.extend(cell.inside.groups.get(union.inside_of[t] as usize));
            stems_from.push(union.inside_of[t]);
        }
    }
    steps.triangle_layers = gather_layers(&cell.inside.triangle_layers, &stems_from);
    (steps.positions, steps.layers) = gather(parts, &sources);
    steps
}

fn survivors(parts: &CellParts<'_>, trace: &CellTrace<'_>) -> CellMesh {
    let CellParts { cell, union, record, .. } = parts;
    let positions = &union.welded.positions;
    let mut number = vec![NONE; positions.vertex_count()];
    let mut sources = Vec::new();
    let mut number_of = |v: u32, sources: &mut Vec<u32>| {
        if number[v as usize] == NONE {
            number[v as usize] = sources.len() as u32;
            sources.push(v);
        }
        number[v as usize]
    };
    let mut out = CellMesh::default();
    let mut stems_from = Vec::new();
    for (t, &inside) in union.inside_of.iter().enumerate() {
        if inside != BORDER && trace.is_alive[t] {
            out.triangles.push(trace.corners[t].map(|v| number_of(v, &mut sources)));
            out.groups.extend(cell.inside.groups.get(inside as usize));
            out.histories.push(trace.history(t));
            stems_from.push(inside);
        }
    }
    out.triangle_layers = gather_layers(&cell.inside.triangle_layers, &stems_from);
    let mut is_left = union.is_within.clone();
    for &p in &record.removed {
        is_left[p as usize] = false;
    }
    // Wedges that lost their triangles; those of the border come with its triangles.
    let mut is_known = vec![false; positions.vertex_count()];
    for (t, corners) in union.welded.mesh.triangles.iter().enumerate() {
        if union.inside_of[t] == BORDER {
            corners.iter().for_each(|&v| is_known[v as usize] = true);
        }
    }
    for p in (0..is_left.len() as u32).filter(|&p| is_left[p as usize]) {
        for v in positions.wedges(p).filter(|&v| !is_known[v as usize]) {
            number_of(v, &mut sources);
        }
        let wait = trace.waits[p as usize];
        if wait.key > 0.0 {
            let v = number_of(positions.first_vertex(p), &mut sources);
            out.waits.push((v, wait));
        }
    }
    let welded_count = positions.vertex_count() as u32;
    sources.extend(union.lone.iter().filter(|&&(p, _)| is_left[p as usize]).map(|&(_, v)| v + welded_count));
    (out.positions, out.layers) = gather(parts, &sources);
    out
}
