//! A fan before and after a step, with its entry in the table \[Cor01, 3.6\].

use glam::DVec2;
use striata::mesh::{RefinableMesh, replay};
use striata::model::Fans;
use striata::simplify::{SequenceOptions, build_sequence};
use striata_command::failure::Failure;

use super::patch::MeshPatch;
use super::sheet::{FigureSheet, GRAY, LineStyle, SIZE, TextAlign, color, panels, tint};

/// Number of vertices whose masks are listed; there is no room for more lines.
const LISTED: usize = 2;

/// Draws the picture; returns whether there is a fan that a step changes.
pub(super) fn draw(patch: &MeshPatch, sheet: &mut FigureSheet) -> Result<bool, Failure> {
    let refinable = build_sequence(&patch.mesh, &SequenceOptions::default())?.refinable;
    let fans = Fans::build_without_bounds(&refinable);
    // The entry that says most: some arcs hold always, and few steps change the others.
    let best = fans.table_fans().filter(|fan| fan.makers().count() > 0).max_by_key(|fan| {
        let has_permanent = fan.permanent_arcs() != 0;
        let is_short = fan.makers().count() <= LISTED && fan.node_count() <= 9;
        (is_short, has_permanent, fan.node_count())
    });
    let Some(fan) = best else { return Ok(false) };
    let makers: Vec<_> = fan.makers().collect();
    let Some(maker) = makers.iter().max_by_key(|maker| maker.step) else { return Ok(false) };
    let points = patch.seen(&refinable.mesh.positions);
    let nodes: Vec<u32> = fan.nodes().collect();
    for (panel, is_refined) in panels(2, &points).into_iter().zip([true, false]) {
        let split_count = maker.step as usize + usize::from(is_refined);
        for triangle in &replay(&refinable, split_count).triangles {
            sheet.outline(&panel.corners(&points, triangle), LineStyle::solid(GRAY, 1));
        }
        let own = makers.iter().filter(|maker| maker.step as usize >= split_count);
        let active = own.fold(fan.permanent_arcs(), |arcs, maker| arcs | maker.arcs);
        for arc in (0..nodes.len()).filter(|arc| active >> arc & 1 == 1) {
            let triangle = [fan.vertex(), nodes[arc], nodes[(arc + 1) % nodes.len()]];
            let corners = panel.corners(&points, &triangle);
            sheet.area(&corners, tint(color(if fan.permanent_arcs() >> arc & 1 == 1 { 0 } else { 1 })));
            sheet.outline(&corners, LineStyle::solid(color(0), 2));
        }
        for &v in nodes.iter().chain([&fan.vertex()]) {
            sheet.number(panel.at(points[v as usize]), v);
        }
        let removed = removed_vertex(&refinable, maker.step);
        let state = if is_refined { "before" } else { "after" };
        sheet.text(
            DVec2::new(panel.middle, 490.0),
            format!("{state} vertex {removed} is removed"),
            TextAlign::Center,
        );
    }
    let mut lines = vec![format!("Entry of vertex {} in the table: ring {}", fan.vertex(), list(&nodes))];
    let arc_count = if fan.is_closed() { nodes.len() } else { nodes.len() - 1 };
    let mask = |arcs: u32| list(&(0..arc_count).map(|arc| arcs >> arc & 1).collect::<Vec<_>>());
    lines.push(format!("triangles {}: always (blue)", mask(fan.permanent_arcs())));
    for maker in makers.iter().take(LISTED) {
        let removed = removed_vertex(&refinable, maker.step);
        lines.push(format!("triangles {}: while vertex {removed} is removed", mask(maker.arcs)));
    }
    if makers.len() > LISTED {
        let rest = makers.len() - LISTED;
        lines.push(format!("and masks of {rest} more vertices"));
    }
    sheet.lines(SIZE.y - 26.0 * lines.len() as f64, &lines);
    Ok(true)
}

/// The first vertex that a step removes.
fn removed_vertex(refinable: &RefinableMesh, step: u32) -> u32 {
    refinable.sequence.step_vertices(step as usize).start
}

fn list(numbers: &[u32]) -> String {
    numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")
}
