//! Clusters of meshoptimizer's clusterlod, in the form of ours.

use meshopt::VertexDataAdapter;
use meshopt::clusterlod::{ClodMesh, clod_build, clod_default_config};
use striata::clusters::{Cluster, ClusterDag, ClusterGroup};
use striata::mesh::IndexedMesh;
use striata::view::Sphere;
use striata_lab::cpu_secs;

use super::{BuiltDag, REFERENCE};
use striata_command::failure::Failure;

/// Builds both variants: the default, and the one that keeps folds.
///
/// # Errors
/// If meshoptimizer refuses the vertices.
pub(super) fn build(mesh: &IndexedMesh) -> Result<[BuiltDag; 2], Failure> {
    let variant = |name: &'static str, keeps_folds: bool| -> Result<BuiltDag, Failure> {
        let started = cpu_secs();
        let dag = clusters(mesh, keeps_folds)?;
        Ok(BuiltDag { name, dag, secs: cpu_secs() - started })
    };
    Ok([variant(REFERENCE, true)?, variant("clusterlod", false)?])
}

fn clusters(mesh: &IndexedMesh, keeps_folds: bool) -> Result<ClusterDag, Failure> {
    let bytes: Vec<u8> = mesh.positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    let vertices = VertexDataAdapter::new(&bytes, 12, 0);
    let vertices = vertices.map_err(|error| Failure::internal(format!("meshoptimizer: {error}")))?;
    let mut config = clod_default_config(128);
    config.simplify_preserve_folds = keeps_folds;
    let mut dag = ClusterDag::default();
    let input = ClodMesh::new(mesh.triangles.as_flattened(), &vertices);
    clod_build(config, &input, |group, clusters| {
        let (number, first) = (dag.groups.len(), dag.clusters.len());
        for cluster in clusters {
            let from = dag.triangles.len();
            dag.triangles.extend_from_slice(cluster.indices.as_chunks().0);
            dag.clusters.push(Cluster {
                triangles: from..dag.triangles.len(),
                group: number,
                refines: usize::try_from(cluster.refined).ok(),
                mesh_group: 0,
                sphere: Sphere { center: cluster.bounds.center, radius: cluster.bounds.radius },
            });
        }
        let bounds = group.simplified;
        dag.groups.push(ClusterGroup {
            clusters: first..dag.clusters.len(),
            depth: usize::try_from(group.depth).unwrap_or(0),
            sphere: Sphere { center: bounds.center, radius: bounds.radius },
            // The largest number stands for groups without a simplified form.
            error: if bounds.error < f32::MAX { bounds.error } else { f32::INFINITY },
        });
        number as i32
    });
    Ok(dag)
}
