//! Pairs of points of the original and of a level.
//!
//! Samples of the original are the centroids of its triangles, or of every n-th one if there are many more than
//! in the level; those of the level are three points of each triangle. Borders have samples of their own: a point
//! beyond the end of a surface is at no distance from the plane of a triangle, and where texture coordinates or
//! materials change, a surface that slides along itself shows the wrong side.

use glam::DVec3;

use super::surface::{FitPoint, FitSurface, share_along};
use crate::mesh::{
    Adjacency, AttributeLayer, Edge, IndexedMesh, MeshError, Semantic, TriangleSearch, TriangleTree,
    ZOrderCurve, index_positions,
};
use crate::parallel;

/// Samples of the original for each triangle of the level.
const SAMPLES: f64 = 4.0;
/// Number of samples whose partners one thread finds in order, so that each search can begin at the partner found before.
const CHUNK: usize = 1 << 12;
/// Points of a triangle of the level, each for a third of its area.
const POINTS: [[f64; 3]; 3] =
    [[2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0], [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 1.0 / 6.0, 2.0 / 3.0]];
/// Factor by which the squared distances of a triangle may grow.
const WORSE: f64 = 1.5;
/// Points of a border edge, each for half of its length.
const EDGE_POINTS: [f64; 2] = [0.2, 0.8];
/// Samples of each border for each triangle of the level. Only triangles that share few edges have more.
const BORDER_SAMPLES: f64 = 1.0;
/// Distance from a border edge beyond which a border is another one, as a share of the edge's length.
const BORDER_REACH: f64 = 0.5;
/// Multiple of the distance to the nearest border edge within which one that leads the same way is looked for.
const SAME_PLACE: f64 = 1.5;
/// Cosine between two border edges above which they are parts of the same border.
const SAME_EDGE: f64 = 0.5;

/// A point of the level, and the point of the original that it should coincide with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub level: FitPoint,
    pub original: FitPoint,
    /// Position of the point of the original.
    pub target: DVec3,
    /// Area that the pair stands for.
    pub area: f64,
}

/// A pair on the borders, whose area is as wide as the level's edge is long.
#[derive(Clone, Copy, Debug)]
pub(super) struct BorderPair {
    pub pair: Pair,
    /// Direction of the level's edge, a unit vector.
    pub along: DVec3,
}

/// All pairs between a level and the original.
pub(super) struct FitPairs {
    pub of_surfaces: Vec<Pair>,
    pub of_borders: Vec<BorderPair>,
}

impl FitPairs {
    /// The pairs of surfaces and borders.
    pub(super) fn all(&self) -> impl Iterator<Item = &Pair> {
        self.of_surfaces.iter().chain(self.of_borders.iter().map(|border| &border.pair))
    }
}

/// Distances of each triangle of a level from the original, measured by its pairs.
pub(super) struct FitDistances {
    /// Sum of squares, weighted by area.
    squares: Vec<f64>,
    /// Area of the pairs.
    areas: Vec<f64>,
    /// The largest square.
    worst: Vec<f64>,
}

impl FitDistances {
    pub(super) fn mean_square(&self) -> f64 {
        self.squares.iter().sum::<f64>() / self.areas.iter().sum::<f64>().max(f64::MIN_POSITIVE)
    }

    /// Returns which triangles are farther away than in an earlier state of the level: farther than any triangle
    /// was, or much farther than both the triangle itself and the mean were. `noise` is a distance that does not
    /// matter.
    pub(super) fn worse_than(&self, before: &Self, noise: f64) -> Vec<bool> {
        let limit = before.worst.iter().copied().fold(noise * noise, f64::max);
        let mean = before.mean_square().max(noise * noise);
        let is_worse = |t: usize| {
            self.worst[t] > limit || self.squares[t] > WORSE * before.squares[t].max(mean * self.areas[t])
        };
        (0..self.worst.len()).map(is_worse).collect()
    }
}

/// A sample of one surface, and the point of the other that it was last paired with.
struct PairedSample {
    point: FitPoint,
    area: f64,
    partner: Option<FitPoint>,
}

impl PairedSample {
    fn new(triangle: usize, shares: [f64; 3], area: f64) -> Self {
        Self { point: FitPoint { triangle: triangle as u32, shares }, area, partner: None }
    }

    /// Finds the partner on the other surface.
    fn find(&mut self, own: &FitSurface, other: &FitSurface, search: &mut TriangleSearch) {
        let normal = own.normals[self.point.triangle as usize];
        self.partner = other.nearest(own.at(self.point), normal, search, self.partner);
    }
}

/// Runs a function for many samples, with a search that continues from sample to sample.
fn for_each_sample(
    samples: &mut [PairedSample],
    find: impl Fn(&mut PairedSample, &mut TriangleSearch) + Sync,
) {
    let mut chunks: Vec<&mut [PairedSample]> = samples.chunks_mut(CHUNK).collect();
    parallel::for_each(&mut chunks, |chunk| {
        let mut search = TriangleSearch::new();
        chunk.iter_mut().for_each(|sample| find(sample, &mut search));
    });
}

/// Finds the pairs of a level while its vertices move.
pub(super) struct Pairing {
    pub original: FitSurface,
    /// The level as it was when pairs were last found.
    pub level: FitSurface,
    borders: Borders,
    level_borders: Borders,
    border_hints: [Vec<usize>; 2],
    of_original: Vec<PairedSample>,
    of_level: Vec<PairedSample>,
}

impl Pairing {
    /// # Errors
    /// [`MeshError`] if a mesh is inconsistent.
    pub(super) fn new(
        original: &IndexedMesh,
        level: &IndexedMesh,
        adjacency: &Adjacency,
    ) -> Result<Self, MeshError> {
        let of_level = || -> Result<_, MeshError> {
            let surface = FitSurface::new(level)?.with_neighbors(adjacency);
            Ok((surface, Borders::new(level, &border_sides(level, adjacency))))
        };
        let borders = || {
            let adjacency = adjacency_of(original);
            (Borders::new(original, &border_sides(original, &adjacency)), of_level())
        };
        let (surface, (borders, level_parts)) = parallel::join(|| FitSurface::new(original), borders);
        let (surface, (level_surface, level_borders)) = (surface?, level_parts?);
        let samples = SAMPLES * level.triangle_count() as f64;
        let stride = (surface.normals.len() as f64 / samples).max(1.0);
        let (mut of_original, mut area, mut next) = (Vec::new(), 0.0, 0.5 * (stride - 1.0));
        for (t, normal) in surface.normals.iter().enumerate() {
            area += 0.5 * normal.length();
            if t as f64 >= next {
                next += stride;
                of_original.push(PairedSample::new(t, [1.0 / 3.0; 3], std::mem::take(&mut area)));
            }
        }
        let of_level =
            (0..level.triangle_count()).flat_map(|t| POINTS.map(|shares| PairedSample::new(t, shares, 0.0)));
        let mut of_level: Vec<PairedSample> = of_level.collect();
        if let Some(curve) = ZOrderCurve::of(original) {
            // So that neighbors follow each other, whatever the order of the triangles.
            let sort = |samples: &mut [PairedSample], surface: &FitSurface| {
                let place = |sample: &PairedSample| {
                    let [first, ..] = surface.corners[sample.point.triangle as usize];
                    (curve.code(first.as_vec3().to_array()), sample.point.triangle)
                };
                samples.sort_by_cached_key(place);
            };
            parallel::join(|| sort(&mut of_original, &surface), || sort(&mut of_level, &level_surface));
        }
        Ok(Self {
            original: surface,
            level: level_surface,
            borders,
            level_borders,
            border_hints: Default::default(),
            of_original,
            of_level,
        })
    }

    /// The distances of pairs of the level as it was when they were found.
    pub(super) fn distances(&self, pairs: &FitPairs) -> FitDistances {
        let count = self.level.triangles.len();
        let mut found =
            FitDistances { squares: vec![0.0; count], areas: vec![0.0; count], worst: vec![0.0; count] };
        for pair in &pairs.of_surfaces {
            let t = pair.level.triangle as usize;
            let square = self.level.at(pair.level).distance_squared(pair.target);
            found.squares[t] += pair.area * square;
            found.areas[t] += pair.area;
            found.worst[t] = found.worst[t].max(square);
        }
        found
    }

    /// Finds the pairs of the level that this was made for, whose vertices may have moved.
    pub(super) fn pairs(&mut self, level: &IndexedMesh) -> FitPairs {
        let has_moved = self.level.move_vertices(&level.positions);
        let (original, surface) = (&self.original, &self.level);
        for_each_sample(&mut self.of_original, |sample, search| {
            if sample.partner.is_none_or(|partner| has_moved[partner.triangle as usize]) {
                sample.find(original, surface, search);
            }
        });
        let mut of_surfaces = Vec::with_capacity(self.of_original.len() + self.of_level.len());
        let mut near_triangles = vec![u32::MAX; level.triangle_count()];
        for sample in &self.of_original {
            let Some(found) = sample.partner else { continue };
            near_triangles[found.triangle as usize] = sample.point.triangle;
            let target = original.at(sample.point);
            of_surfaces.push(Pair { level: found, original: sample.point, target, area: sample.area });
        }
        for_each_sample(&mut self.of_level, |sample, search| {
            let own = sample.point.triangle as usize;
            if sample.partner.is_none() || has_moved[own] {
                if near_triangles[own] != u32::MAX {
                    search.triangle = near_triangles[own] as usize;
                }
                sample.find(surface, original, search);
            }
        });
        for sample in &self.of_level {
            let Some(found) = sample.partner else { continue };
            let area = surface.normals[sample.point.triangle as usize].length() / (2 * POINTS.len()) as f64;
            let target = original.at(found);
            of_surfaces.push(Pair { level: sample.point, original: found, target, area });
        }
        self.level_borders.move_vertices(level);
        let of_borders =
            self.borders.pairs_with(&self.level_borders, &mut self.border_hints, level.triangle_count());
        FitPairs { of_surfaces, of_borders }
    }
}

/// The edges at which a surface, a chart or a material ends, once for each triangle.
struct Borders {
    edges: Vec<OpenEdge>,
    /// The edges as triangles without area.
    tree: TriangleTree,
}

struct OpenEdge {
    ends: [DVec3; 2],
    triangle: u32,
    /// Corner of the triangle at which the edge begins.
    corner: usize,
}

impl OpenEdge {
    /// Ends of the side of a triangle that begins at a corner.
    fn ends_in(mesh: &IndexedMesh, triangle: u32, corner: usize) -> [DVec3; 2] {
        [corner, (corner + 1) % 3]
            .map(|k| mesh.triangles[triangle as usize][k])
            .map(|v| DVec3::from(mesh.positions[v as usize].map(f64::from)))
    }

    fn as_triangle(&self) -> [[f32; 3]; 3] {
        let [a, b] = self.ends.map(|end| end.to_array().map(|x| x as f32));
        [a, b, b]
    }

    /// Point with this share of the end.
    fn point(&self, share: f64) -> FitPoint {
        let mut shares = [0.0; 3];
        (shares[self.corner], shares[(self.corner + 1) % 3]) = (1.0 - share, share);
        FitPoint { triangle: self.triangle, shares }
    }

    fn side(&self) -> DVec3 {
        self.ends[1] - self.ends[0]
    }

    fn is_parallel(&self, other: &Self) -> bool {
        let (a, b) = (self.side(), other.side());
        a.dot(b) > SAME_EDGE * (a.length_squared() * b.length_squared()).sqrt()
    }
}

/// The adjacency of a mesh by position.
fn adjacency_of(mesh: &IndexedMesh) -> Adjacency {
    let position_of = index_positions(&mesh.positions);
    let triangles = mesh.triangles.iter().map(|t| t.map(|v| position_of[v as usize])).collect();
    Adjacency::of_triangles(triangles, position_of.len())
}

/// Sides of triangles at which the surface ends, or at which texture coordinates or materials change.
fn border_sides(mesh: &IndexedMesh, adjacency: &Adjacency) -> Vec<u32> {
    let position_at =
        |side: u32, next: usize| adjacency.triangles()[side as usize / 3][(side as usize + next) % 3];
    let materials = materials_of(mesh);
    let is_texcoord = |layer: &&AttributeLayer| matches!(layer.semantic, Semantic::TexCoord(_));
    let texcoords: Vec<&AttributeLayer> = mesh.layers.iter().filter(is_texcoord).collect();
    let vertex_at = |side: u32, next: usize| mesh.triangles[side as usize / 3][(side as usize + next) % 3];
    let is_same = |a: u32, b: u32| {
        let is_same_in = |layer: &&AttributeLayer| {
            (0..usize::from(layer.component_count))
                .all(|k| layer.get(a as usize, k) == layer.get(b as usize, k))
        };
        a == b || texcoords.iter().all(is_same_in)
    };
    let is_seam = |edge: &Edge<'_>| {
        let [one, other] = *edge.sides().collect::<Vec<u32>>() else { return false };
        let is_opposite = position_at(one, 0) == position_at(other, 1);
        let ends = if is_opposite { [1, 0] } else { [0, 1] };
        materials[one as usize / 3] != materials[other as usize / 3]
            || (0..2).any(|end| !is_same(vertex_at(one, end), vertex_at(other, ends[end])))
    };
    let borders = adjacency.edges().filter(|edge| is_boundary(adjacency, edge) || is_seam(edge));
    borders.flat_map(|edge| edge.sides().collect::<Vec<_>>()).collect()
}

/// Whether the surface ends at an edge. The triangles of a sheet that is modeled from both sides coincide.
pub(super) fn is_boundary(adjacency: &Adjacency, edge: &Edge<'_>) -> bool {
    let third = |side: u32| adjacency.triangles()[side as usize / 3][(side as usize + 2) % 3];
    let mut thirds = edge.sides().map(third);
    let first = thirds.next();
    thirds.all(|other| Some(other) == first)
}

impl Borders {
    /// The borders that consist of these sides, `3 * triangle + corner`.
    fn new(mesh: &IndexedMesh, sides: &[u32]) -> Self {
        let edge = |&side: &u32| OpenEdge {
            ends: OpenEdge::ends_in(mesh, side / 3, side as usize % 3),
            triangle: side / 3,
            corner: side as usize % 3,
        };
        let edges: Vec<OpenEdge> = sides.iter().map(edge).collect();
        let tree = TriangleTree::of_triangles(edges.iter().map(OpenEdge::as_triangle).collect());
        Self { edges, tree }
    }

    /// Follows vertices that have moved a little.
    fn move_vertices(&mut self, mesh: &IndexedMesh) {
        for edge in &mut self.edges {
            edge.ends = OpenEdge::ends_in(mesh, edge.triangle, edge.corner);
        }
        self.tree.move_corners(self.edges.iter().map(OpenEdge::as_triangle));
    }

    /// The edge nearest to a point of an edge that leads the same way: the triangles of both lie on the same side.
    fn nearest(&self, point: DVec3, edge: &OpenEdge, search: &mut TriangleSearch) -> Option<&OpenEdge> {
        let point = point.to_array();
        let distance = self.tree.searched_distance(point, search);
        let mut found = self.edges.get(search.triangle)?;
        if !found.is_parallel(edge) {
            // The other side of a seam is as near.
            let mut least = SAME_PLACE * distance;
            self.tree.visit_searched(point, least, search, |candidate, away| {
                if away <= least && self.edges[candidate].is_parallel(edge) {
                    (found, least) = (&self.edges[candidate], away);
                }
                least
            });
        }
        Some(found).filter(|found| found.is_parallel(edge))
    }

    /// Pairs points of these borders of the original with those of a level of `triangle_count` triangles.
    /// `last_found` keeps the edges that were found for the samples of either.
    fn pairs_with(
        &self,
        level: &Self,
        last_found: &mut [Vec<usize>; 2],
        triangle_count: usize,
    ) -> Vec<BorderPair> {
        let mut pairs = Vec::new();
        // From shares of both edges, and the length that the pair stands for.
        let mut add = |(edge, share): (&OpenEdge, f64), (own, along): (&OpenEdge, f64), length: f64| {
            let target = own.ends[0].lerp(own.ends[1], along);
            let width = edge.side().length();
            if edge.ends[0].lerp(edge.ends[1], share).distance(target) <= BORDER_REACH * width {
                let (level, original) = (edge.point(share), own.point(along));
                let pair = Pair { level, original, target, area: length * width };
                pairs.push(BorderPair { pair, along: edge.side().normalize_or_zero() });
            }
        };
        let stride = |edges: &[OpenEdge]| {
            let step =
                (edges.len() as f64 / (BORDER_SAMPLES * triangle_count as f64)).floor().max(1.0) as usize;
            // The sides of a triangle follow each other, so a multiple of three would meet one of them only.
            if step.is_multiple_of(3) { step + 1 } else { step }
        };
        let mut search = TriangleSearch::new();
        let [of_own, of_level] = last_found;
        let step = stride(&self.edges);
        of_own.resize(self.edges.len().div_ceil(step), usize::MAX);
        for (own, last) in self.edges.iter().step_by(step).zip(of_own) {
            let middle = 0.5 * (own.ends[0] + own.ends[1]);
            search.triangle = if *last == usize::MAX { search.triangle } else { *last };
            let found = level.nearest(middle, own, &mut search);
            *last = search.triangle;
            let Some(edge) = found else { continue };
            let share = share_along(middle, edge.ends[0], edge.ends[1]);
            add((edge, share), (own, 0.5), step as f64 * own.side().length());
        }
        search.triangle = usize::MAX;
        let step = stride(&level.edges);
        of_level.resize(EDGE_POINTS.len() * level.edges.len().div_ceil(step), usize::MAX);
        let samples =
            level.edges.iter().step_by(step).flat_map(|edge| EDGE_POINTS.map(|share| (edge, share)));
        for ((edge, share), last) in samples.zip(of_level) {
            let point = edge.ends[0].lerp(edge.ends[1], share);
            search.triangle = if *last == usize::MAX { search.triangle } else { *last };
            let found = self.nearest(point, edge, &mut search);
            *last = search.triangle;
            let Some(own) = found else { continue };
            let along = share_along(point, own.ends[0], own.ends[1]);
            add((edge, share), (own, along), 0.5 * step as f64 * edge.side().length());
        }
        pairs
    }
}

/// Material of each triangle plus one, 0 for none.
pub(super) fn materials_of(mesh: &IndexedMesh) -> Vec<u32> {
    let mut materials = vec![0; mesh.triangles.len()];
    for group in &mesh.groups {
        materials[group.range()].fill(group.material.map_or(0, |material| material + 1));
    }
    materials
}
