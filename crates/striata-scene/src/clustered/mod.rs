//! Scenes of clusters: for engines that draw meshlets and choose the level of detail of each.
//!
//! [`ClusteredScene::build`] makes a [`ClusterDag`] of each mesh, and [`ClusteredScene::to_glb`] writes a glTF file that
//! any viewer opens at full detail: see `docs/STRIATA_clusters.md`.

use std::borrow::Cow;

use serde_json::{Value, json};
use striata::clusters::{ClusterDag, ClusterGroup, ClusterOptions};
use striata::mesh::IndexedMesh;
use striata::{ProgressFn, ignore_progress};
use striata_io::{Scene, WriteError};

use crate::error::BuildError;
use crate::extended_glb::{ExtendedGlb, ExtendedPrimitive};
use crate::mesh_simplifier::MeshSimplifier;

/// Name of the extension.
pub const CLUSTER_EXTENSION: &str = "STRIATA_clusters";

/// A scene with the clusters of all levels of each of its meshes.
#[derive(Clone, Debug)]
pub struct ClusteredScene {
    scene: Scene,
    dags: Vec<Option<ClusterDag>>,
}

/// A GLB file with the extension `STRIATA_clusters`.
#[derive(Clone, Debug, PartialEq)]
pub struct ClusteredGlb {
    /// The file.
    pub bytes: Vec<u8>,
    /// Size of the file without the extension.
    pub plain_bytes: usize,
}

impl ClusteredScene {
    /// Builds the clusters of each mesh of a scene.
    ///
    /// Lengths in the options are in units of the scene. Textures and poses count as for
    /// [`LodScene::build`](crate::LodScene::build), but the errors of groups are those of the mesh as it is stored.
    ///
    /// # Errors
    /// [`BuildError`] if a mesh is inconsistent or an option is out of range.
    pub fn build(scene: Scene, options: &ClusterOptions) -> Result<Self, BuildError> {
        Self::build_with_progress(scene, options, &mut ignore_progress)
    }

    /// Builds the clusters like [`build`](Self::build) and reports progress; the callback can cancel.
    ///
    /// # Errors
    /// See [`build`](Self::build); also if the callback cancels.
    pub fn build_with_progress(
        scene: Scene,
        options: &ClusterOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, BuildError> {
        let simplifier = MeshSimplifier::new(&scene);
        let build = |index: usize, mesh: &IndexedMesh, progress: &mut ProgressFn<'_>| {
            simplifier.clusters(index, mesh, options, progress)
        };
        let dags = simplifier.for_each_mesh(&options.sequence, build, progress)?;
        drop(simplifier);
        Ok(Self { scene, dags })
    }

    /// The scene, at full detail.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Clusters of each mesh of the document; [`None`] for a mesh without triangles.
    pub fn dags(&self) -> &[Option<ClusterDag>] {
        &self.dags
    }

    /// Encodes the scene as a GLB file at full detail with the extension `STRIATA_clusters`: each mesh has its groups, and
    /// each triangle primitive the indices of all clusters, with a table of them.
    ///
    /// Primitives without triangles of any area are left out; points and lines stay as they are.
    ///
    /// # Errors
    /// [`WriteError`] if a mesh contains numbers that glTF cannot store, or the file would be larger than 4 GiB.
    pub fn to_glb(&self) -> Result<ClusteredGlb, WriteError> {
        Ok(ClusteredGlb { bytes: self.glb(true)?, plain_bytes: self.glb(false)?.len() })
    }

    fn glb(&self, has_extension: bool) -> Result<Vec<u8>, WriteError> {
        let mut file = ExtendedGlb::new(&self.scene, CLUSTER_EXTENSION);
        for (index, (mesh, dag)) in self.scene.meshes().iter().zip(&self.dags).enumerate() {
            let Some((mesh, dag)) = mesh.as_ref().zip(dag.as_ref()) else { continue };
            if has_extension
                && !dag.groups.is_empty()
                && let Some(slot) = file.mesh_extension(index)
            {
                *slot = json!({ "groups": dag.groups.iter().map(group_row).collect::<Vec<_>>() });
            }
            let are_blended = self.scene.are_blended(index);
            let groups = mesh.groups_or_whole().into_iter().zip(are_blended).enumerate();
            let primitives = groups.map(|(number, (group, is_blended))| {
                let made = extended(dag, number, has_extension);
                if is_blended { made.showing(&mesh.triangles[group.range()]) } else { made }
            });
            file.put_mesh(index, mesh, primitives.collect());
        }
        file.into_glb()
    }
}

/// Row of a group: depth, center, radius and error. The last group, which has no simplified form, has the largest
/// number in single precision.
fn group_row(group: &ClusterGroup) -> Value {
    let [x, y, z] = group.sphere.center;
    let numbers = [x, y, z, group.sphere.radius.min(f32::MAX), group.error.min(f32::MAX)];
    let row = numbers.map(|number| json!(crate::ordered::shortest(number)));
    Value::Array(std::iter::once(json!(group.depth)).chain(row).collect())
}

/// A primitive with all of its clusters, those at full detail first.
fn extended<'m>(dag: &ClusterDag, mesh_group: usize, has_extension: bool) -> ExtendedPrimitive<'m> {
    let own = || dag.clusters.iter().filter(|cluster| cluster.mesh_group == mesh_group);
    let full = own().filter(|cluster| cluster.refines.is_none());
    let shown = full.clone().map(|cluster| cluster.triangles.len()).sum();
    let (mut triangles, mut rows) = (Vec::new(), Vec::new());
    for cluster in full.chain(own().filter(|cluster| cluster.refines.is_some())) {
        triangles.extend_from_slice(&dag.triangles[cluster.triangles.clone()]);
        let refines = cluster.refines.map_or(0, |group| group as u32 + 1);
        rows.extend([cluster.triangles.len() as u32, cluster.group as u32, refines]);
    }
    ExtendedPrimitive {
        triangles: Cow::Owned(triangles),
        shown,
        extension: has_extension.then(|| json!({ "indices": null })),
        numbers: vec![("clusters", Cow::Owned(rows))],
    }
}
