//! Makes one mesh with levels of loaded pages.

use striata::mesh::{CollapseSequence, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts};

use crate::loaded::{LoadedPages, VertexPlace, coarse_vertices};
use crate::mesh_parts::{Triangles, appearance, gathered_layers, grouped};
use crate::replaced::Replaced;
use crate::{Metadata, Page, PagedError};

const NONE: u32 = u32::MAX;

/// Loaded pages as one mesh.
#[derive(Clone, Debug)]
pub struct Assembled {
    /// The mesh with its levels. Its full detail is the full detail of the pages.
    pub refinable: RefinableMesh,
    /// Key of each step, never increasing.
    pub keys: Vec<f32>,
    /// Error of the surface without each step alone, in mesh units; the sequence has the largest of these and all
    /// later ones.
    pub step_errors: Vec<f32>,
    /// Index of the page that each vertex comes from.
    pub page_of_vertex: Vec<u32>,
}

impl Assembled {
    /// Number of steps whose keys are at least `key`.
    pub fn split_count_for_key(&self, key: f32) -> usize {
        self.keys.partition_point(|&other| other >= key)
    }
}

/// Assembles pages, each with its index in the directory.
///
/// # Errors
/// [`PagedError::Mismatch`] if a parent of a page is absent or the pages do not fit together.
pub fn assemble(pages: &[(u32, &Page)], metadata: &Metadata) -> Result<Assembled, PagedError> {
    let loaded = LoadedPages::new(pages)?;
    let order = PositionOrder::new(&loaded);
    let (groups, triangles, triangle_layers) = grouped(full_triangles(&loaded, &order), metadata);
    let sequence = sequence(&order, order.targets(&loaded), &triangles)?;
    let mesh = IndexedMesh {
        triangle_layers,
        positions: order
            .vertices
            .iter()
            .map(|at| loaded.page(at.slot).positions[at.vertex as usize])
            .collect(),
        layers: gathered_layers(&loaded, &order.vertices, metadata),
        triangles,
        groups,
        appearance: appearance(metadata),
        origin: metadata.origin,
        exact_positions: Vec::new(),
    };
    Ok(Assembled {
        keys: order.keys(&loaded),
        step_errors: order.errors,
        page_of_vertex: order.vertices.iter().map(|at| loaded.index_of(at.slot)).collect(),
        refinable: RefinableMesh { mesh, sequence },
    })
}

/// The refinement order of all positions.
struct PositionOrder {
    /// Slot and number of each position; those of the base come first.
    positions: Vec<(u32, u32)>,
    base_position_count: usize,
    /// Vertices of each position.
    index: PositionIndex,
    /// Page and number of each vertex.
    vertices: Vec<VertexPlace>,
    /// Place in this order of each vertex as the loaded pages number it.
    rank: Vec<u32>,
    /// Error of each step.
    errors: Vec<f32>,
}

impl PositionOrder {
    fn new(loaded: &LoadedPages<'_>) -> Self {
        let mut positions = Vec::new();
        for (slot, page) in (0..).zip(loaded.pages()) {
            positions.extend((0..page.first.len().saturating_sub(1) as u32).map(|p| (slot, p)));
        }
        // The base page has no keys, and comes first.
        let key = |&(slot, p): &(u32, u32)| {
            loaded.page(slot).keys.get(p as usize).copied().unwrap_or(f32::INFINITY)
        };
        positions.sort_by(|a, b| key(b).total_cmp(&key(a)).then(a.cmp(b)));
        let base_position_count = positions.partition_point(|at| key(at) == f32::INFINITY);
        let (mut first, mut vertices) = (vec![0], Vec::with_capacity(loaded.vertex_count()));
        let mut rank = vec![NONE; loaded.vertex_count()];
        for &(slot, p) in &positions {
            let page = loaded.page(slot);
            for vertex in page.first[p as usize]..page.first[p as usize + 1] {
                let place = VertexPlace { slot, vertex };
                rank[loaded.number(place) as usize] = vertices.len() as u32;
                vertices.push(place);
            }
            first.push(vertices.len() as u32);
        }
        let steps = positions[base_position_count..].iter();
        let errors = steps.map(|&(slot, p)| loaded.page(slot).errors[p as usize]).collect();
        Self {
            positions,
            base_position_count,
            index: PositionIndex::from_first(first),
            vertices,
            rank,
            errors,
        }
    }

    /// Targets of all vertices that are not in the base.
    fn targets(&self, loaded: &LoadedPages<'_>) -> Vec<u32> {
        let base = self.base_vertex_count() as usize;
        let mut targets = vec![NONE; self.vertices.len() - base];
        for (slot, page) in (0..).zip(loaded.pages()) {
            let rank = |v: u32| self.rank[loaded.number_in(slot, v) as usize];
            for (v, &target) in (0..).zip(&page.targets) {
                targets[rank(v) as usize - base] = rank(target);
            }
        }
        targets
    }

    /// Number of vertices of the base.
    fn base_vertex_count(&self) -> u32 {
        self.index.first_vertex(self.base_position_count as u32)
    }

    /// Position of a vertex as the loaded pages number it.
    fn position_of(&self, number: u32) -> u32 {
        self.index.position_of(self.rank[number as usize])
    }

    fn keys(&self, loaded: &LoadedPages<'_>) -> Vec<f32> {
        let steps = &self.positions[self.base_position_count..];
        steps.iter().map(|&(slot, p)| loaded.page(slot).keys[p as usize]).collect()
    }
}

/// All triangles at the full detail of the pages: those of each page that no finer page replaces.
fn full_triangles(loaded: &LoadedPages<'_>, order: &PositionOrder) -> Triangles {
    let mut replaced: Vec<Replaced> = (0..loaded.len()).map(|_| Replaced::default()).collect();
    let mut runs = Vec::with_capacity(loaded.len());
    for slot in (0..loaded.len() as u32).rev() {
        let page = loaded.page(slot);
        let owned = page.positions.len() as u32;
        let coarse = coarse_vertices(page);
        let mut own = std::mem::take(&mut replaced[slot as usize]);
        let mut run = Vec::with_capacity(page.triangles.len());
        let mut places = Vec::new();
        for (t, corners) in page.triangles.iter().enumerate() {
            let tag = page.tag_of(t);
            let numbers = corners.map(|v| loaded.number_in(slot, v));
            if own.is_empty() || !own.take(numbers, tag) {
                run.push((numbers.map(|v| order.rank[v as usize]), page.group_of(t)));
                places.push(t as u32);
            }
            if page.targets.is_empty() {
                continue;
            }
            let coarse = corners.map(|v| if v < owned { coarse[v as usize] } else { v });
            let owner = coarse.map(|v| loaded.imports_of(slot)[(v - owned) as usize].slot);
            let numbers = coarse.map(|v| loaded.number_in(slot, v));
            let [a, b, c] = numbers.map(|v| order.position_of(v));
            if a != b && b != c && c != a {
                replaced[owner[0].max(owner[1]).max(owner[2]) as usize].add(numbers, tag);
            }
        }
        runs.push((run, (page, places)));
    }
    let mut triangles = Triangles::default();
    for (run, (page, places)) in runs.into_iter().rev() {
        triangles.extend(run, page, &places);
    }
    triangles
}

/// The sequence of steps, with the number of triangles that each removes.
fn sequence(
    order: &PositionOrder,
    targets: Vec<u32>,
    triangles: &[[u32; 3]],
) -> Result<CollapseSequence, PagedError> {
    let positions = &order.index;
    let base = order.base_position_count as u32;
    let base_vertex = order.base_vertex_count();
    let mut counts = vec![0u32; order.errors.len()];
    for corners in triangles {
        let mut corners = corners.map(|v| (positions.position_of(v), v));
        loop {
            let [a, b, c] = corners.map(|(p, _)| p);
            let finest = usize::from(b > a && b >= c) + 2 * usize::from(c > a && c > b);
            let (p, v) = corners[finest];
            if p < base {
                break;
            }
            let target = targets[(v - base_vertex) as usize];
            let at = positions.position_of(target);
            if at >= p {
                // The pages do not match; the sequence will be refused.
                break;
            }
            if corners.iter().enumerate().any(|(i, &(other, _))| i != finest && other == at) {
                counts[(p - base) as usize] += 1;
                break;
            }
            corners[finest] = (at, target);
        }
    }
    Ok(CollapseSequence::from_parts(SequenceParts {
        positions: order.index.clone(),
        base_position_count: order.base_position_count,
        targets,
        errors: level_errors(&order.errors),
        // A step of a cell removes at most 255 triangles; more are an error of the pages.
        removed_triangle_counts: counts.into_iter().map(|count| count.min(255) as u8).collect(),
        triangle_count: triangles.len(),
    })?)
}

/// The error of each level: it covers all steps that are not taken.
fn level_errors(step_errors: &[f32]) -> Vec<f32> {
    let mut errors = step_errors.to_vec();
    let mut worst = 0.0f32;
    for error in errors.iter_mut().rev() {
        worst = worst.max(*error);
        *error = worst;
    }
    errors
}
