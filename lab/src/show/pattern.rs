//! A fragment with its anchors, and the overlap with a fragment below it \[KG98, 3\].

use std::collections::HashSet;

use glam::DVec2;
use striata::mesh::{FragmentedMesh, replay_fragments};
use striata::simplify::{RemovalOptions, build_fragments};
use striata_command::failure::Failure;
use striata_lab::baseline::LoopPatterns;

use super::patch::MeshPatch;
use super::sheet::{DARK, FigureSheet, GRAY, LineStyle, SIZE, SheetPanel, TextAlign, color, panels, tint};

/// Draws the picture; returns whether there are two fragments that overlap.
pub(super) fn draw(patch: &MeshPatch, sheet: &mut FigureSheet) -> Result<bool, Failure> {
    let mesh = build_fragments(&patch.mesh, &RemovalOptions::default())?.fragmented;
    let model = LoopPatterns::build(&mesh).map_err(|error| Failure::user(error.to_string()))?;
    let fragments = &mesh.fragments;
    // The largest of the overlaps, seen in the largest fragment.
    let steps = 0..fragments.step_count() as u32;
    let pairs = steps.flat_map(|upper| model.covered(upper).map(move |lower| (upper, lower)));
    let shared = |&(upper, lower): &(u32, u32)| shared_faces(&mesh, upper, lower).len();
    let best = pairs.max_by_key(|pair| (shared(pair).min(2), fragments.ceiling(pair.0).len()));
    let Some((upper, lower)) = best else { return Ok(false) };
    let points = patch.seen(&mesh.mesh.positions);
    let [ceiling, floor, overlap] = *panels(3, &points) else { return Ok(false) };
    let ceiling_faces: Vec<u32> = fragments.ceiling(upper).collect();
    let removed = ceiling_faces.iter().flat_map(|&f| fragments.faces()[f as usize].corners).max();

    let picture = |panel| FragmentPicture { mesh: &mesh, points: &points, panel };
    let fine = picture(ceiling);
    fine.draw_level(upper as usize + 1, sheet);
    fine.draw_faces(&ceiling_faces, 0, sheet);
    fine.draw_vertices(removed.into_iter(), sheet);
    title(ceiling, format!("ceiling of fragment {upper}"), sheet);

    let coarse = picture(floor);
    coarse.draw_level(upper as usize, sheet);
    coarse.draw_faces(fragments.floor(upper), 1, sheet);
    let anchors = model.anchors(upper);
    let ends = anchors.map(|v| floor.at(points[v as usize]));
    sheet.path(&ends, LineStyle::solid(DARK, 4));
    coarse.draw_vertices(anchors.into_iter(), sheet);
    title(floor, "its floor, with two anchors".to_owned(), sheet);

    let both = picture(overlap);
    both.draw_level(upper as usize, sheet);
    both.draw_faces(&fragments.ceiling(lower).collect::<Vec<_>>(), 2, sheet);
    both.draw_faces(fragments.floor(upper), 1, sheet);
    both.draw_faces(&shared_faces(&mesh, upper, lower), 3, sheet);
    title(overlap, format!("overlap with fragment {lower}"), sheet);

    let rings = fragments.floor(upper).len() + 2;
    let lines = [
        format!(
            "Fragment {upper} replaces the triangles of its floor by those around the inserted vertex. A rule says how the"
        ),
        format!(
            "floor divides the ring of {rings} vertices; two anchors say where it lies. Right: the floor contains triangles (purple)"
        ),
        format!(
            "that fragment {lower} creates (with the green ones), so {lower} must be inserted before {upper}."
        ),
    ];
    sheet.lines(SIZE.y - 26.0 * lines.len() as f64 - 20.0, &lines);
    Ok(true)
}

/// Faces of the upper fragment's floor that the lower fragment creates.
fn shared_faces(mesh: &FragmentedMesh, upper: u32, lower: u32) -> Vec<u32> {
    let ceiling: HashSet<u32> = mesh.fragments.ceiling(lower).collect();
    mesh.fragments.floor(upper).iter().copied().filter(|face| ceiling.contains(face)).collect()
}

fn title(panel: SheetPanel, text: String, sheet: &mut FigureSheet) {
    sheet.text(DVec2::new(panel.middle, 490.0), text, TextAlign::Center);
}

/// A level with some of its fragments, in a panel.
struct FragmentPicture<'a> {
    mesh: &'a FragmentedMesh,
    points: &'a [DVec2],
    panel: SheetPanel,
}

impl FragmentPicture<'_> {
    fn draw_level(&self, split_count: usize, sheet: &mut FigureSheet) {
        for triangle in &replay_fragments(self.mesh, split_count).triangles {
            sheet.outline(&self.panel.corners(self.points, triangle), LineStyle::solid(GRAY, 1));
        }
    }

    fn draw_faces(&self, faces: &[u32], index: usize, sheet: &mut FigureSheet) {
        for &face in faces {
            let corners =
                self.panel.corners(self.points, &self.mesh.fragments.faces()[face as usize].corners);
            sheet.area(&corners, tint(color(index)));
            sheet.outline(&corners, LineStyle::solid(color(index), 2));
        }
    }

    fn draw_vertices(&self, vertices: impl Iterator<Item = u32>, sheet: &mut FigureSheet) {
        for v in vertices {
            sheet.number(self.panel.at(self.points[v as usize]), v);
        }
    }
}
