//! Random splits, written and read with the same models.

use striata::mesh::{IndexedMesh, Random, shapes};

use super::*;
use crate::entropy::{RangeReader, RangeWriter};
use crate::refine::walk::BatchWalk;
use crate::topology::surface::{Surface, previous};

const MAX_PATCH: u32 = 15;

/// A minimal refiner with made-up coordinates.
struct TestRefiner {
    surface: Surface,
    grid_points: Vec<[i32; 3]>,
    walk: BatchWalk,
    model: ConnectivityModel,
    corners: Vec<u32>,
    visited_count: usize,
}

impl TestRefiner {
    fn new(surface: Surface, grid_points: Vec<[i32; 3]>) -> Self {
        let model = ConnectivityModel::new();
        Self {
            surface,
            grid_points,
            walk: BatchWalk::default(),
            model,
            corners: Vec::new(),
            visited_count: 0,
        }
    }

    /// Codes one batch in which `choose` selects the splits. Returns the decoded splits; they are applied
    /// in pairs.
    fn batch<C: Coder>(
        &mut self,
        coder: &mut C,
        mut choose: impl FnMut(&SplitContext<'_>, u32) -> Option<Cut>,
    ) -> Vec<Cut> {
        self.walk.begin(&self.surface);
        self.model.begin_batch(&self.surface);
        let (mut all, mut pending) = (Vec::new(), Vec::new());
        loop {
            let vertex = self.walk.next_vertex();
            if pending.len() == 2 || vertex.is_none() {
                self.split(&pending);
                all.append(&mut pending);
            }
            let Some(vertex) = vertex else { return all };
            let (surface, grid_points, walk) = (&self.surface, self.grid_points.as_slice(), &self.walk);
            let split_context = SplitContext { surface, grid_points, walk, max_patch: MAX_PATCH };
            let actual = choose(&split_context, vertex);
            self.corners = self.surface.ring(vertex).collect();
            let star = SplitStar { vertex, corners: self.corners.as_slice() };
            let cut = self.model.code(coder, &split_context, star, actual);
            self.walk.record_visit(vertex, cut.is_some());
            self.visited_count += 1;
            for corner in cut.into_iter().flat_map(|cut| run(&self.surface, cut)).collect::<Vec<_>>() {
                self.surface.set_mark(triangle_of(corner), self.walk.batch());
            }
            pending.extend(cut);
        }
    }

    fn split(&mut self, cuts: &[Cut]) {
        for &cut in cuts {
            let patch = run(&self.surface, cut);
            self.walk.record_split(self.surface.vertex(patch[0]));
            let v = self.surface.split(&patch);
            let made = self.surface.triangle_count() as u32;
            (made - 2..made).for_each(|t| self.surface.set_mark(t, self.walk.batch()));
            // Coordinates between two of its neighbors.
            let is_known = |w: &u32| *w < v && !self.surface.is_virtual(*w);
            let ring: Vec<u32> =
                self.surface.ring(v).map(|c| self.surface.vertex(next(c))).filter(is_known).collect();
            let [a, b] = [0, ring.len() / 2].map(|i| self.grid_points.get(ring[i] as usize).copied());
            let (a, b) = (a.unwrap_or_default(), b.unwrap_or_default());
            self.grid_points
                .push([0, 1, 2].map(|i| a[i].midpoint(b[i]).wrapping_add((v as i32 * 37 + i as i32) % 5)));
        }
    }
}

/// Builds a closed surface from its triangles.
pub(super) fn surface_of(triangles: &[[u32; 3]], vertex_count: usize, virtual_count: u32) -> Surface {
    let edge = |c: usize| [1, 2].map(|i| triangles[c / 3][(c % 3 + i) % 3]);
    let corners = 0..3 * triangles.len();
    let across = |c: usize| corners.clone().find(|&d| edge(d) == [edge(c)[1], edge(c)[0]]);
    let opposite: Vec<u32> = corners.clone().map(|c| across(c).unwrap() as u32).collect();
    Surface::from_closed(triangles, &opposite, vertex_count, virtual_count).unwrap()
}

/// Returns the corners of a cut.
fn run(surface: &Surface, cut: Cut) -> Vec<u32> {
    let corners = std::iter::successors(Some(cut.first), |&c| Some(surface.swing(c)));
    corners.take(cut.length as usize).collect()
}

/// Returns a random cut around a vertex, sometimes a long one; `None` for some vertices, or if the cut is
/// not free.
fn random_cut(split_context: &SplitContext<'_>, vertex: u32, random: &mut Random) -> Option<Cut> {
    let corners: Vec<u32> = split_context.surface.ring(vertex).collect();
    let n = corners.len();
    if n < 2 || random.below(4) != 0 {
        return None;
    }
    let most = (MAX_PATCH as usize).min(n - 1);
    let shortest = if most > MAX_RUN { MAX_RUN } else { 0 };
    let length = 1 + shortest as u32 + random.below(most.min(shortest + 4) as u32 - shortest as u32);
    let cut = Cut { first: corners[random.below(n as u32) as usize], length };
    let run = run(split_context.surface, cut);
    let is_free = run.iter().all(|&c| !split_context.is_claimed(triangle_of(c)));
    let is_virtual = |&c: &u32| split_context.surface.is_virtual(split_context.surface.vertex(next(c)));
    (is_free && !run[1..].iter().any(is_virtual)).then_some(cut)
}

/// Makes a mesh in which two vertices have many triangles each.
fn double_cone(side_count: u32) -> IndexedMesh {
    let rim = (0..side_count).map(|i| [(i as f32 - 9.5).abs() - 5.0, (i as f32 - 4.5).abs() - 5.0, 0.0]);
    let positions = [[0.0, 0.0, 4.0], [0.0, 0.0, -4.0]].into_iter().chain(rim).collect();
    let sides = (0..side_count).map(|i| [2 + i, 2 + (i + 1) % side_count]);
    IndexedMesh::new(positions, sides.flat_map(|[a, b]| [[0, a, b], [1, b, a]]).collect())
}

fn closed(mesh: &IndexedMesh) -> (Surface, Vec<[i32; 3]>) {
    let closed = crate::topology::cutting::close(&mesh.triangles, mesh.positions.len());
    let virtual_points = (0..closed.surface.virtual_count()).map(|_| [0; 3]);
    let grid_points =
        closed.vertex_of_copy.iter().map(|&v| mesh.positions[v as usize].map(|x| (x * 900.0) as i32));
    let grid_points = virtual_points.chain(grid_points).collect();
    (closed.surface, grid_points)
}

/// Result of writing random splits.
struct EncodedSplits {
    bytes: Vec<u8>,
    batches: Vec<Vec<Cut>>,
    refiner: TestRefiner,
}

fn write(surface: &Surface, grid_points: &[[i32; 3]], seed: u64) -> EncodedSplits {
    let mut random = Random::new(seed);
    let mut refiner = TestRefiner::new(surface.clone(), grid_points.to_vec());
    let mut writer = RangeWriter::new();
    let batches = (0..7)
        .map(|_| {
            refiner.batch(&mut writer, |split_context, vertex| random_cut(split_context, vertex, &mut random))
        })
        .collect();
    EncodedSplits { bytes: writer.finish().0, batches, refiner }
}

#[test]
fn random_splits_round_trip() {
    let meshes =
        [double_cone(20), shapes::torus(9, 6, 1.0, 0.4), shapes::grid(6, 5), shapes::icosphere(1, 1.0)];
    for (seed, mesh) in meshes.iter().enumerate() {
        let (surface, grid_points) = closed(mesh);
        let EncodedSplits { bytes, batches, refiner } = write(&surface, &grid_points, seed as u64);
        assert!(batches.iter().all(|batch| batch.len() > 2), "almost no vertex splits");
        assert!(batches.iter().flatten().any(|cut| cut.length as usize > MAX_RUN) || seed > 0);
        let mut reader = RangeReader::new(&bytes, true);
        let mut other = TestRefiner::new(surface.clone(), grid_points.clone());
        for batch in &batches {
            assert_eq!(&other.batch(&mut reader, |_, _| None), batch);
        }
        assert_eq!(other.visited_count, refiner.visited_count);
    }
}

#[test]
fn histories_match_the_surface() {
    let (surface, grid_points) = closed(&shapes::grid(6, 5));
    let EncodedSplits { refiner, .. } = write(&surface, &grid_points, 8);
    for vertex in refiner.surface.virtual_count()..refiner.surface.vertex_count() as u32 {
        let valence = refiner.surface.ring(vertex).count();
        let free = refiner.surface.ring(vertex);
        let free = free.filter(|&c| refiner.surface.mark(triangle_of(c)) != refiner.walk.batch()).count();
        let vertex_history = refiner.model.history.of(vertex);
        assert_eq!(usize::from(vertex_history.valence), valence, "valence of {vertex}");
        // The free triangles of vertices that split are not tracked any more in the batch.
        if vertex_history.since_split > 0 {
            assert_eq!(usize::from(vertex_history.free), free, "free triangles of {vertex}");
        }
    }
}

#[test]
fn streams_are_the_same_on_every_machine() {
    let (surface, grid_points) = closed(&shapes::grid(9, 7));
    let EncodedSplits { bytes, .. } = write(&surface, &grid_points, 3);
    assert_eq!((bytes.len(), crc32fast::hash(&bytes)), (211, 99_952_167));
}

#[test]
fn arbitrary_bytes_split_any_surface() {
    let pillow = surface_of(&[[0, 1, 2], [0, 2, 1]], 3, 0);
    let holes = surface_of(&[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], 4, 2);
    let (grid, grid_points) = closed(&shapes::grid(4, 4));
    let far = [1 << 24, -(1 << 24), 0, i32::MAX, i32::MIN];
    let mut random = Random::new(77);
    for (at, surface) in [pillow, holes, grid].into_iter().enumerate() {
        for _ in 0..20 {
            let bytes: Vec<u8> = (0..400).map(|_| random.next_u64() as u8).collect();
            let mut grid_points = grid_points.clone();
            if at < 2 || random.below(2) == 0 {
                let mut number = || far[random.below(5) as usize];
                grid_points = (0..surface.vertex_count()).map(|_| [number(), number(), number()]).collect();
            }
            let mut reader = RangeReader::new(&bytes, true);
            let mut refiner = TestRefiner::new(surface.clone(), grid_points);
            for _ in 0..6 {
                for cut in refiner.batch(&mut reader, |_, _| None) {
                    assert!((1..=MAX_PATCH).contains(&cut.length));
                }
            }
        }
    }
}

#[test]
fn regular_splits_become_cheap() {
    // Every vertex with an even index loses the two triangles at its longest edge.
    let (surface, grid_points) = closed(&shapes::torus(40, 20, 1.0, 0.4));
    let mut refiner = TestRefiner::new(surface, grid_points);
    let mut writer = RangeWriter::new();
    let cuts = refiner.batch(&mut writer, |split_context, vertex| {
        let corners: Vec<u32> = split_context.surface.ring(vertex).collect();
        let square = |c: u32| {
            let [a, b] = [vertex, split_context.surface.vertex(next(c))]
                .map(|v| split_context.grid_points[v as usize]);
            (0..3).map(|i| i64::from(a[i] - b[i]).pow(2)).sum::<i64>()
        };
        let longest = corners.iter().copied().max_by_key(|&c| (square(c), c))?;
        let cut = Cut { first: previous(split_context.surface.opposite(previous(longest))), length: 2 };
        let is_free =
            run(split_context.surface, cut).iter().all(|&c| !split_context.is_claimed(triangle_of(c)));
        (is_free && vertex.is_multiple_of(2)).then_some(cut)
    });
    let bits = writer.finish().0.len() as f64 * 8.0;
    assert!(cuts.len() > 100, "{} splits", cuts.len());
    // Without a model: one of about twenty runs, and a flag for each vertex.
    assert!(bits / cuts.len() as f64 <= 6.5, "{} bits a split", bits / cuts.len() as f64);
}

#[test]
fn histories_follow_renumbered_vertices() {
    let (surface, grid_points) = closed(&shapes::grid(6, 5));
    let EncodedSplits { mut refiner, .. } = write(&surface, &grid_points, 8);
    let count = refiner.surface.vertex_count() as u32;
    let history = &mut refiner.model.history;
    history.begin_batch(&refiner.surface);
    let densities: Vec<u8> = (0..count).map(|v| history.of(v).density).collect();
    // As if the rebuilt surface had vertices 3 and 5 swapped, and a new vertex 4.
    let old_of_new: Vec<u32> = (0..count)
        .map(|v| match v {
            3 => 5,
            4 => crate::topology::surface::NONE,
            5 => 3,
            _ => v,
        })
        .collect();
    history.renumber(&old_of_new);
    history.begin_batch(&refiner.surface);
    for vertex in 0..count {
        let vertex_history = history.of(vertex);
        assert_eq!(usize::from(vertex_history.valence), refiner.surface.ring(vertex).count());
        let old = old_of_new[vertex as usize];
        assert_eq!(vertex_history.density, densities.get(old as usize).copied().unwrap_or(40));
        assert_eq!(history.age(vertex), 3);
    }
}
