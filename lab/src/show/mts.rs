//! The graph of a strip over all its levels \[BRR02, 3.1\].

use std::f64::consts::PI;

use glam::DVec2;
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::{RESTART, stripify};
use striata_command::failure::Failure;
use striata_lab::{MtsGraph, MtsNode};

use super::patch::MeshPatch;
use super::sheet::{DARK, FigureSheet, GRAY, LineStyle, SIZE, SheetPanel, TextAlign, color, tint};

/// Pixels of the mesh on the left.
const MESH_WIDTH: f64 = 380.0;
/// Height of the columns, in pixels from the top.
const BASELINE: f64 = 250.0;
/// Largest height of an arc.
const MAX_ARC: f64 = 190.0;
/// Points of an arc.
const ARC_POINTS: usize = 24;
/// Levels whose strips are listed.
const LISTED: usize = 5;

/// Draws the picture; returns whether there is a strip.
pub(super) fn draw(patch: &MeshPatch, sheet: &mut FigureSheet) -> Result<bool, Failure> {
    let refinable = build_sequence(&patch.mesh, &SequenceOptions::default())?.refinable;
    let strips = stripify(&refinable.mesh)?;
    let graph = MtsGraph::build(&refinable, &strips)?;
    let Some(strip) = (0..graph.strip_count()).max_by_key(|&strip| graph.columns(strip).count()) else {
        return Ok(false);
    };
    let points = patch.seen(&refinable.mesh.positions);
    draw_mesh(&refinable.mesh.triangles, &points, &graph.strip_at(strip, 0), sheet);
    draw_graph(&graph, strip, sheet);
    let levels = refinable.sequence.step_count() as u32;
    let mut listed: Vec<(u32, Vec<u32>)> = Vec::new();
    for level in 0..=levels {
        let indices = graph.strip_at(strip, level);
        if listed.last().is_none_or(|(_, last)| *last != indices) {
            listed.push((level, indices));
        }
    }
    let stride = listed.len().div_ceil(LISTED).max(1);
    let texts = listed.iter().step_by(stride).map(|(level, indices)| {
        let shown = |&index: &u32| if index == RESTART { "|".to_owned() } else { index.to_string() };
        let strip: Vec<String> = indices.iter().map(shown).collect();
        let strip = if strip.is_empty() { "the strip is gone".to_owned() } else { strip.join(" ") };
        format!("level {level}: {strip}")
    });
    let texts: Vec<String> = texts.collect();
    sheet.lines(SIZE.y - 26.0 * texts.len() as f64 - 8.0, &texts);
    Ok(true)
}

/// Draws all triangles, the strip and the numbers of its vertices.
fn draw_mesh(triangles: &[[u32; 3]], points: &[DVec2], strip: &[u32], sheet: &mut FigureSheet) {
    let panel = SheetPanel::new(0.0..MESH_WIDTH, points);
    for triangle in triangles {
        sheet.outline(&panel.corners(points, triangle), LineStyle::solid(GRAY, 1));
    }
    for triangle in strip.windows(3).filter(|corners| !corners.contains(&RESTART)) {
        let triangle = [triangle[0], triangle[1], triangle[2]];
        sheet.area(&panel.corners(points, &triangle), tint(color(0)));
    }
    let path: Vec<DVec2> =
        strip.iter().filter(|&&v| v != RESTART).map(|&v| panel.at(points[v as usize])).collect();
    sheet.path(&path, LineStyle::solid(color(0), 2));
    for &v in strip.iter().filter(|&&v| v != RESTART) {
        sheet.number(panel.at(points[v as usize]), v);
    }
}

/// Draws the columns, and an arc for each entry of their rows.
fn draw_graph(graph: &MtsGraph, strip: usize, sheet: &mut FigureSheet) {
    let columns: Vec<_> = graph.columns(strip).collect();
    let spacing = (SIZE.x - MESH_WIDTH - 80.0) / (columns.len().max(2) - 1) as f64;
    let place = |column: usize| DVec2::new(MESH_WIDTH + 40.0 + spacing * column as f64, BASELINE);
    for (from, (_, row)) in columns.iter().enumerate() {
        for (entry, arc) in row.iter().enumerate() {
            match arc.node {
                MtsNode::Column(to) => {
                    let line = LineStyle::solid(color(entry), 2);
                    let top = draw_arc(place(from), place(to), line, sheet);
                    sheet.label(top, format!("≤{}", arc.res), color(entry));
                }
                special => {
                    let name = match special {
                        MtsNode::SameVertex => "-1",
                        MtsNode::NewVertex => "-2",
                        _ => "end",
                    };
                    let at = place(from) + DVec2::new(0.0, 30.0);
                    sheet.path(&[place(from), at], LineStyle::dashed(GRAY, 1));
                    sheet.label(at + DVec2::new(0.0, 12.0), format!("{name} ≤{}", arc.res), GRAY);
                }
            }
        }
    }
    for (column, (vertex, _)) in columns.iter().enumerate() {
        sheet.number(place(column), *vertex);
    }
    for begin in graph.begins(strip) {
        if let MtsNode::Column(column) = begin.node {
            let at = place(column) - DVec2::new(0.0, 26.0);
            sheet.path(&[at, place(column)], LineStyle::solid(DARK, 2));
            sheet.label(at - DVec2::new(0.0, 10.0), format!("begin ≤{}", begin.res), DARK);
        }
    }
    let middle = 0.5 * (MESH_WIDTH + SIZE.x);
    let text = "An arc holds for levels up to its number; 0 is the full mesh. Arcs above lead forward.";
    sheet.text(DVec2::new(middle, 490.0), text, TextAlign::Center);
}

/// Draws half an ellipse, above if it leads forward; returns its apex.
fn draw_arc(from: DVec2, to: DVec2, line: LineStyle, sheet: &mut FigureSheet) -> DVec2 {
    let center = 0.5 * (from + to);
    let half = 0.5 * (to.x - from.x);
    let height = (0.8 * half.abs()).clamp(16.0, MAX_ARC);
    let up = if half >= 0.0 { -height } else { height };
    let point = |i: usize| {
        let angle = PI * i as f64 / (ARC_POINTS - 1) as f64;
        center + DVec2::new(-half * angle.cos(), up * angle.sin())
    };
    sheet.path(&(0..ARC_POINTS).map(point).collect::<Vec<_>>(), line);
    center + DVec2::new(0.0, up * 1.0 - 9.0_f64.copysign(-up))
}
