//! Builds clusters level by level: groups them, simplifies each group, and divides what is left.

use super::bounds::enclosing;
use super::divide::Division;
use super::grouping::SharedPositions;
use super::measure::{GroupSurface, RemovedVertex, keep_farthest};
use super::{Cluster, ClusterDag, ClusterGroup, ClusterOptions};
use crate::mesh::{Appearance, IndexedMesh, Material, PositionIndex, TriangleGroup, Welded, is_proper, weld};
use crate::parallel::map;
use crate::simplify::{
    CarriedWitness, LockedPatch, SequenceOptions, SimplifiedPatch, SimplifyError, is_scan, locked_positions,
};
use crate::view::Sphere;
use crate::{Progress, ProgressFn};

/// Factor on errors that are measured at vertices: between vertices, and from the simplified form to the original one,
/// distances are a little larger. Measured with samples, 19 of 20 reported errors are then .94 to 1.25 of the true ones.
const MARGIN: f32 = 1.2;
/// A group is kept for the next level, with other neighbors, if more than this share of its triangles is left.
const MAX_LEFT: f64 = 0.85;
/// Levels end once one of them leaves more than this share of the triangles.
const MAX_LEFT_OF_LEVEL: f64 = 0.97;

/// A cluster that is not part of a group yet.
struct OpenCluster {
    /// Vertices of the welded mesh.
    triangles: Vec<[u32; 3]>,
    mesh_group: usize,
    refines: Option<usize>,
    sphere: Sphere,
    /// Vertices whose nearest triangles it has.
    removed: Vec<RemovedVertex>,
}

/// Result of simplifying a group.
struct SimplifiedGroup {
    clusters: Vec<OpenCluster>,
    error: f32,
}

/// The level that is being built.
struct Builder<'a> {
    options: &'a ClusterOptions,
    sequence: SequenceOptions,
    welded: Welded,
    diagonal: f64,
    is_scan: bool,
    /// Whether each position must stay on all levels.
    is_locked: Vec<bool>,
    clusters: Vec<OpenCluster>,
    dag: ClusterDag,
}

pub(super) fn build(
    mesh: &IndexedMesh,
    options: &ClusterOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<ClusterDag, SimplifyError> {
    options.check()?;
    options.sequence.check_locked(mesh.vertex_count())?;
    let mut builder = Builder::new(weld(mesh)?, options);
    builder.divide_all();
    let total = builder.triangle_count() as u64;
    while builder.clusters.len() > 1 {
        let before = builder.triangle_count();
        if before <= options.sequence.base_triangle_count {
            break;
        }
        builder.add_level()?;
        let left = builder.triangle_count();
        Progress { phase: "cluster", done: total - left as u64, total }.report(progress)?;
        if left as f64 > MAX_LEFT_OF_LEVEL * before as f64 {
            break;
        }
    }
    Ok(builder.finish())
}

impl<'a> Builder<'a> {
    fn new(welded: Welded, options: &'a ClusterOptions) -> Self {
        let SequenceOptions { locked_vertices, group_borders, .. } = &options.sequence;
        let is_locked = locked_positions(&welded, locked_vertices, *group_borders);
        let diagonal = welded.mesh.bounds().map_or(0.0, |bounds| bounds.diagonal());
        let sequence = SequenceOptions {
            pair_distance: None,
            // What says so otherwise is known for the whole mesh only.
            height_field: Some(
                options.sequence.height_field.unwrap_or(!welded.mesh.appearance.georeference.is_empty()),
            ),
            locked_vertices: Vec::new(),
            ..options.sequence.clone()
        };
        Self {
            options,
            sequence,
            diagonal: if diagonal > 0.0 { diagonal } else { 1.0 },
            is_scan: is_scan(&welded),
            is_locked,
            clusters: Vec::new(),
            dag: ClusterDag::default(),
            welded,
        }
    }

    fn triangle_count(&self) -> usize {
        self.clusters.iter().map(|c| c.triangles.len()).sum()
    }

    /// Divides the full mesh.
    fn divide_all(&mut self) {
        let mesh = &self.welded.mesh;
        for (mesh_group, group) in mesh.groups_or_whole().iter().enumerate() {
            let triangles = &mesh.triangles[group.range()];
            let clusters = Division::new(mesh, triangles, self.options).divide();
            let open = clusters.iter().map(|cluster| self.open_cluster(cluster, triangles, mesh_group));
            self.clusters.extend(open.collect::<Vec<_>>());
        }
    }

    /// A cluster of some triangles of a list, which belong to one group of the mesh.
    fn open_cluster(&self, cluster: &[u32], triangles: &[[u32; 3]], mesh_group: usize) -> OpenCluster {
        let triangles: Vec<[u32; 3]> = cluster.iter().map(|&t| triangles[t as usize]).collect();
        let mut vertices = triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let places = vertices.iter().map(|&v| Sphere::point(self.welded.mesh.positions[v as usize]));
        let sphere = enclosing(&places.collect::<Vec<_>>());
        OpenCluster { sphere, triangles, mesh_group, refines: None, removed: Vec::new() }
    }

    /// Groups all clusters, and replaces those of each group by its simplified form, if it has one.
    fn add_level(&mut self) -> Result<(), SimplifyError> {
        let position_count = self.welded.positions.position_count();
        let positions_of = |i: usize| self.positions_of(&self.clusters[i].triangles);
        let shared = SharedPositions::new(&map(0..self.clusters.len(), positions_of), position_count);
        let groups = shared.group(self.options.group_size);
        let mut group_of = vec![0; self.clusters.len()];
        for (number, group) in (0..).zip(&groups) {
            group.iter().for_each(|&c| group_of[c as usize] = number);
        }
        let mut is_border = self.is_locked.clone();
        shared.between_groups(&group_of).for_each(|p| is_border[p as usize] = true);
        let simplified = map(0..groups.len(), |number| self.simplified(&groups[number], &is_border));
        let open = std::mem::take(&mut self.clusters);
        let mut open: Vec<Option<OpenCluster>> = open.into_iter().map(Some).collect();
        for (group, simplified) in groups.iter().zip(simplified) {
            let taken = group.iter().filter_map(|&c| open[c as usize].take()).collect();
            match simplified? {
                None => self.clusters.extend::<Vec<_>>(taken),
                Some(simplified) => self.replace(taken, simplified),
            }
        }
        Ok(())
    }

    /// Positions of triangles, in ascending order.
    fn positions_of(&self, triangles: &[[u32; 3]]) -> Vec<u32> {
        let of = |&v: &u32| self.welded.positions.position_of(v);
        let mut positions: Vec<u32> = triangles.as_flattened().iter().map(of).collect();
        positions.sort_unstable();
        positions.dedup();
        positions
    }

    /// Simplifies the clusters of a group to half of their triangles; [`None`] if that is not possible within the limits.
    fn simplified(
        &self,
        group: &[u32],
        is_border: &[bool],
    ) -> Result<Option<SimplifiedGroup>, SimplifyError> {
        let clusters = || group.iter().map(|&c| &self.clusters[c as usize]);
        let cut_out = CutOut::new(&self.welded, clusters());
        let count = cut_out.welded.mesh.triangle_count();
        let removed = cut_out.removed(clusters());
        let witnesses: Vec<CarriedWitness> = removed
            .chunk_by(|a, b| a.position == b.position)
            .map(|run| CarriedWitness {
                position: run[0].position,
                place: run[0].place,
                distance: run[0].distance,
            })
            .collect();
        let local = 0..cut_out.positions.len() as u32;
        let locked = local.filter(|&p| is_border[cut_out.positions[p as usize] as usize]);
        let limit = self.sequence.max_error.unwrap_or(f64::INFINITY);
        let options = SequenceOptions {
            base_triangle_count: count / 2,
            max_error: self.sequence.max_error.map(|limit| limit / f64::from(MARGIN)),
            locked_vertices: locked.map(|p| cut_out.welded.positions.first_vertex(p)).collect(),
            ..self.sequence.clone()
        };
        let error_of = |c: &OpenCluster| c.refines.map_or(0.0, |finer| self.dag.groups[finer].error);
        let patch = LockedPatch {
            welded: &cut_out.welded,
            diagonal: self.diagonal,
            is_scan: self.is_scan,
            witnesses: &witnesses,
            error: clusters().map(error_of).fold(0.0, f32::max),
        };
        let result = patch.simplify(&options)?;
        let left = cut_out.triangles_left(&result.targets);
        let left_count: usize = left.iter().map(Vec::len).sum();
        // How far a group that vanishes is from what is left is not known.
        if left_count == 0 || left_count as f64 > MAX_LEFT * count as f64 {
            return Ok(None);
        }
        let (error, measured) = cut_out.measure(&result, removed);
        if f64::from(error * MARGIN) > limit {
            return Ok(None);
        }
        let mut made: Vec<OpenCluster> = Vec::new();
        let mut cluster_of = Vec::with_capacity(left_count);
        for (triangles, &mesh_group) in left.iter().zip(&cut_out.mesh_groups) {
            let first = cluster_of.len();
            cluster_of.resize(first + triangles.len(), 0);
            for cluster in Division::new(&self.welded.mesh, triangles, self.options).divide() {
                cluster.iter().for_each(|&t| cluster_of[first + t as usize] = made.len());
                made.push(self.open_cluster(&cluster, triangles, mesh_group));
            }
        }
        for (triangle, removed) in measured {
            let position = cut_out.positions[removed.position as usize];
            made[cluster_of[triangle]].removed.push(RemovedVertex { position, ..removed });
        }
        made.iter_mut().for_each(|cluster| keep_farthest(&mut cluster.removed));
        Ok(Some(SimplifiedGroup { clusters: made, error }))
    }

    /// Adds a group with its clusters to the result, and its simplified form to the next level.
    fn replace(&mut self, clusters: Vec<OpenCluster>, simplified: SimplifiedGroup) {
        let group = self.add_group(clusters, simplified.error);
        let refines = Some(group);
        self.clusters.extend(simplified.clusters.into_iter().map(|c| OpenCluster { refines, ..c }));
    }

    /// Adds a group with its clusters to the result; returns its number.
    fn add_group(&mut self, clusters: Vec<OpenCluster>, error: f32) -> usize {
        let number = self.dag.groups.len();
        let first = self.dag.clusters.len();
        let finer = |c: &OpenCluster| c.refines.map(|finer| &self.dag.groups[finer]);
        let spheres: Vec<Sphere> =
            clusters.iter().map(|c| finer(c).map_or(c.sphere, |group| group.sphere)).collect();
        let depth = clusters.iter().filter_map(|c| finer(c).map(|group| group.depth + 1)).max().unwrap_or(0);
        for OpenCluster { triangles, mesh_group, refines, sphere, .. } in clusters {
            let from = self.dag.triangles.len();
            let source = |v: u32| self.welded.source_vertex[v as usize];
            self.dag.triangles.extend(triangles.into_iter().map(|t| t.map(source)));
            let triangles = from..self.dag.triangles.len();
            self.dag.clusters.push(Cluster { triangles, group: number, refines, mesh_group, sphere });
        }
        let clusters = first..self.dag.clusters.len();
        self.dag.groups.push(ClusterGroup { clusters, depth, sphere: enclosing(&spheres), error });
        number
    }

    /// Adds a group of all that is left.
    fn finish(mut self) -> ClusterDag {
        let rest = std::mem::take(&mut self.clusters);
        if !rest.is_empty() {
            self.add_group(rest, f32::INFINITY);
        }
        for group in &mut self.dag.groups {
            group.error *= MARGIN;
        }
        self.dag
    }
}

/// The triangles of a group, as a mesh of their own.
struct CutOut {
    welded: Welded,
    /// Vertex of the whole mesh for each vertex.
    vertices: Vec<u32>,
    /// Position of the whole mesh for each position, ascending.
    positions: Vec<u32>,
    /// Group of the whole mesh for each group of triangles.
    mesh_groups: Vec<usize>,
}

impl CutOut {
    fn new<'a>(whole: &Welded, clusters: impl Iterator<Item = &'a OpenCluster> + Clone) -> Self {
        let mut sorted: Vec<&OpenCluster> = clusters.collect();
        sorted.sort_by_key(|c| c.mesh_group);
        let triangle_count = sorted.iter().map(|c| c.triangles.len()).sum();
        let mut triangles: Vec<[u32; 3]> = Vec::with_capacity(triangle_count);
        let (mut groups, mut mesh_groups) = (Vec::new(), Vec::new());
        for run in sorted.chunk_by(|a, b| a.mesh_group == b.mesh_group) {
            let first = triangles.len() as u32;
            run.iter().for_each(|c| triangles.extend(&c.triangles));
            let material = whole.mesh.groups.get(run[0].mesh_group).and_then(|group| group.material);
            let count = triangles.len() as u32 - first;
            groups.push(TriangleGroup { name: String::new(), material, first, count });
            mesh_groups.push(run[0].mesh_group);
        }
        // Wedges of a position are consecutive, and stay so.
        let mut vertices = triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let number = |v: u32| vertices.binary_search(&v).unwrap_or_default() as u32;
        triangles.iter_mut().flatten().for_each(|v| *v = number(*v));
        let position_of = |v: &u32| whole.positions.position_of(*v);
        let is_first = |i: &usize| *i == 0 || position_of(&vertices[i - 1]) != position_of(&vertices[*i]);
        let mut first: Vec<u32> = (0..vertices.len()).filter(is_first).map(|i| i as u32).collect();
        first.push(vertices.len() as u32);
        let positions = PositionIndex::from_first(first);
        let material_count = whole.mesh.appearance.materials.len();
        let mesh = IndexedMesh {
            layers: whole.mesh.layers.iter().map(|layer| layer.gather(&vertices)).collect(),
            groups,
            appearance: Appearance {
                materials: vec![Material::default(); material_count],
                ..Appearance::default()
            },
            ..IndexedMesh::new(
                vertices.iter().map(|&v| whole.mesh.positions[v as usize]).collect(),
                triangles,
            )
        };
        let welded = Welded {
            mesh,
            source_vertex: Vec::new(),
            position_of_source: (0..vertices.len() as u32).map(|v| positions.position_of(v)).collect(),
            positions,
            degenerate_triangle_count: 0,
            merged_vertex_count: 0,
        };
        let of_first = |&v: &u32| position_of(&vertices[v as usize]);
        let first = &welded.positions.first_vertices()[..welded.positions.position_count()];
        Self { positions: first.iter().map(of_first).collect(), welded, vertices, mesh_groups }
    }

    /// The removed vertices of clusters, with positions of this mesh, by position and falling distance.
    fn removed<'a>(&self, clusters: impl Iterator<Item = &'a OpenCluster>) -> Vec<RemovedVertex> {
        let local = |p: u32| self.positions.binary_search(&p).unwrap_or_default() as u32;
        let all = clusters.flat_map(|c| &c.removed);
        let mut removed: Vec<RemovedVertex> =
            all.map(|r| RemovedVertex { position: local(r.position), ..*r }).collect();
        keep_farthest(&mut removed);
        removed
    }

    /// The triangles that are left after vertices became others, as those of the whole mesh, for each of its groups.
    fn triangles_left(&self, targets: &[u32]) -> Vec<Vec<[u32; 3]>> {
        let (mesh, positions) = (&self.welded.mesh, &self.welded.positions);
        let is_left = |t: &[u32; 3]| is_proper(&t.map(|v| positions.position_of(v)));
        let of_group = |group: &TriangleGroup| {
            let moved = mesh.triangles[group.range()].iter().map(|t| t.map(|v| targets[v as usize]));
            moved.filter(is_left).map(|t| t.map(|v| self.vertices[v as usize])).collect()
        };
        mesh.groups.iter().map(of_group).collect()
    }

    /// Measures the vertices that have been removed now or, as in the list, before. Returns the largest distance, at
    /// least the error of the result, and the vertices with the triangles that they are near to.
    fn measure(
        &self,
        result: &SimplifiedPatch,
        before: Vec<RemovedVertex>,
    ) -> (f32, Vec<(usize, RemovedVertex)>) {
        let (mesh, positions) = (&self.welded.mesh, &self.welded.positions);
        let target = |p: u32| positions.position_of(result.targets[positions.first_vertex(p) as usize]);
        let moved = |t: &[u32; 3]| t.map(|v| positions.position_of(result.targets[v as usize]));
        let triangles: Vec<[u32; 3]> = mesh.triangles.iter().map(moved).filter(is_proper).collect();
        let first = &positions.first_vertices()[..positions.position_count()];
        let places: Vec<[f32; 3]> = first.iter().map(|&v| mesh.positions[v as usize]).collect();
        let mut surface = GroupSurface::new(&triangles, &places, result.error);
        let is_removed = |p: &u32| target(*p) != *p;
        let now = (0..places.len() as u32).filter(is_removed);
        let now =
            now.map(|position| RemovedVertex { position, place: places[position as usize], distance: 0.0 });
        let near_target = |r: RemovedVertex| RemovedVertex { position: target(r.position), ..r };
        let measured = now.chain(before).filter_map(|r| surface.measure(near_target(r))).collect();
        (surface.error, measured)
    }
}
