//! The dual graph with its strips, before and after the links of a tunnel are complemented \[PS03, 3.1\].

use glam::DVec2;
use striata::mesh::{DualGraph, IndexedMesh, NO_TWIN};
use striata::strip::StripLinks;
use striata_command::failure::Failure;
use striata_lab::stripifiers::{
    EndOrder, Identities, TunnelOptions, Visits, join_along_one_tunnel, join_along_tunnels,
};

use super::patch::MeshPatch;
use super::sheet::{DARK, FigureSheet, GRAY, LineStyle, SheetPanel, TextAlign, color, panels, tint};

/// Lengths of tunnels that are shown, the best ones first; one link would only join two ends.
const LENGTHS: [u32; 3] = [5, 7, 3];
/// Number of searches for each length.
const SEEDS: u64 = 100;
/// The color of the tunnel, which no strip has.
const TUNNEL: usize = 5;

/// Draws the picture; returns whether there is a tunnel.
pub(super) fn draw(patch: &MeshPatch, sheet: &mut FigureSheet) -> Result<bool, Failure> {
    let mesh = &patch.mesh;
    let graph = DualGraph::of_vertices(mesh);
    let found = LENGTHS.iter().find_map(|&max_length| {
        (0..SEEDS).find_map(|seed| {
            let options = |max_length| TunnelOptions {
                max_length,
                order: EndOrder::Random,
                identities: Identities::Dynamic,
                visits: Visits::OncePerPath,
                seed,
            };
            let mut before = StripLinks::new(&graph);
            join_along_tunnels(&mesh.triangles, &mut before, &options(1));
            let mut after = before.clone();
            let tunnel = join_along_one_tunnel(&mesh.triangles, &mut after, &options(max_length))?;
            (tunnel.len() == max_length as usize).then_some((tunnel, before, after))
        })
    });
    let Some((tunnel, before, after)) = found else { return Ok(false) };
    let points = patch.seen(&mesh.positions);
    for (panel, links) in panels(2, &points).into_iter().zip([&before, &after]) {
        let picture = GraphPicture { mesh, points: &points, links, panel };
        picture.draw_strips(sheet);
        for &side in &tunnel {
            let line = if links.is_solid(side) { LineStyle::solid } else { LineStyle::dashed };
            sheet.path(&picture.link(side), line(color(TUNNEL), 5));
        }
        picture.draw_nodes(sheet);
        let strip_count = mesh.triangle_count() - links.solid_count();
        let strips = if strip_count == 1 { "strip" } else { "strips" };
        sheet.text(DVec2::new(panel.middle, 490.0), format!("{strip_count} {strips}"), TextAlign::Center);
    }
    let count = tunnel.len();
    let lines = [
        format!(
            "In red, a tunnel of {count} links, dashed and solid in turn, from the end of one strip to the end"
        ),
        "of another. Complementing its links joins the two strips.".to_owned(),
        "Dots are triangles; solid links lead along strips, dashed links between them.".to_owned(),
    ];
    sheet.lines(530.0, &lines);
    Ok(true)
}

/// A dual graph with strips, in a panel.
struct GraphPicture<'a> {
    mesh: &'a IndexedMesh,
    points: &'a [DVec2],
    links: &'a StripLinks<'a>,
    panel: SheetPanel,
}

impl GraphPicture<'_> {
    /// Draws triangles in the colors of their strips, and all links.
    fn draw_strips(&self, sheet: &mut FigureSheet) {
        for (triangle, strip) in self.mesh.triangles.iter().zip(strips_of_triangles(self.links)) {
            let corners = self.panel.corners(self.points, triangle);
            sheet.area(&corners, tint(color(if strip >= TUNNEL { strip + 1 } else { strip })));
            sheet.outline(&corners, LineStyle::solid(GRAY, 1));
        }
        for (side, &twin) in (0..).zip(self.links.twins()) {
            if twin != NO_TWIN && side < twin {
                let line = if self.links.is_solid(side) {
                    LineStyle::solid(DARK, 3)
                } else {
                    LineStyle::dashed(GRAY, 1)
                };
                sheet.path(&self.link(side), line);
            }
        }
    }

    fn draw_nodes(&self, sheet: &mut FigureSheet) {
        for triangle in 0..self.mesh.triangle_count() {
            sheet.dot(self.node(triangle), 4, DARK);
        }
    }

    fn node(&self, triangle: usize) -> DVec2 {
        let [a, b, c] = self.panel.corners(self.points, &self.mesh.triangles[triangle]);
        (a + b + c) / 3.0
    }

    /// The link across a side, through the middle of the edge.
    fn link(&self, side: u32) -> [DVec2; 3] {
        let (triangle, k) = (side as usize / 3, side as usize % 3);
        let corners = self.panel.corners(self.points, &self.mesh.triangles[triangle]);
        let middle = 0.5 * (corners[k] + corners[(k + 1) % 3]);
        [self.node(triangle), middle, self.node(self.links.twins()[side as usize] as usize / 3)]
    }
}

/// Returns the index of each triangle's strip.
fn strips_of_triangles(links: &StripLinks<'_>) -> Vec<usize> {
    let mut strip_of = vec![usize::MAX; links.triangle_count()];
    let mut count = 0;
    for start in 0..links.triangle_count() {
        if strip_of[start] != usize::MAX {
            continue;
        }
        let mut open = vec![start];
        while let Some(triangle) = open.pop() {
            strip_of[triangle] = count;
            let sides = (3 * triangle..3 * triangle + 3).filter(|&side| links.is_solid(side as u32));
            let beyond = sides.map(|side| links.twins()[side] as usize / 3);
            open.extend(beyond.filter(|&next| strip_of[next] == usize::MAX));
        }
        count += 1;
    }
    strip_of
}
