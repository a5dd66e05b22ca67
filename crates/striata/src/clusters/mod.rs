//! Clusters: a hierarchy of small groups of triangles from which levels of detail are put together.
//!
//! Engines that draw meshlets choose the level of detail cluster by cluster. A cluster has at most
//! [`ClusterOptions::max_triangles`] triangles. Neighboring clusters form a **group**, and each group is simplified
//! to half of its triangles, which are divided into new clusters. The border of a group stays, so that neighbors fit
//! together whichever of the two forms they have. The new clusters are grouped again, with other neighbors, and so on:
//!
//! ```text
//! clusters      [] [] [] []   [] [] [] []      full detail
//!                \  \ /  /     \  \ /  /
//! groups          group 0       group 1        simplified, each with an error and a bounding sphere
//!                  /  \          /   \
//! clusters        []   []      []    []        half of the triangles
//!                  |    \      /      |
//! groups        group 2   group 3   ...
//! ```
//!
//! A group decides for all of its clusters: if its simplified form is [good enough](ClusterDag::cut), the clusters
//! that it made are drawn, or something coarser; otherwise its own clusters are, or something finer. Errors and spheres
//! nest, so every cluster decides on its own, without the others. The structure is that of Nanite [Karis 2021] and of
//! meshoptimizer's `clusterlod.h`; the simplifier is this library's, and errors are measured from the vertices of the
//! original mesh.
//!
//! [`ClusterDag`] refers to vertices of the mesh that it is built from: there is a single vertex buffer, and attributes,
//! skins and morph targets hold at all levels.
//!
//! ```
//! use striata::clusters::{ClusterDag, ClusterOptions};
//! use striata::mesh::shapes;
//!
//! let mesh = shapes::torus(128, 64, 1.0, 0.4);
//! let dag = ClusterDag::build(&mesh, &ClusterOptions::default())?;
//! for group in &dag.groups {
//!     for cluster in &dag.clusters[group.clusters.clone()] {
//!         encode(&dag.triangles[cluster.triangles.clone()]); // indices of the vertices of `mesh`
//!     }
//! }
//! let drawn = dag.cut_for_error(0.01); // within a hundredth of a unit everywhere
//! println!("{} of {} clusters", drawn.len(), dag.clusters.len());
//! # fn encode(_: &[[u32; 3]]) {}
//! # Ok::<(), striata::simplify::SimplifyError>(())
//! ```

mod bounds;
mod build;
mod divide;
mod grouping;
mod measure;

use std::ops::Range;

use crate::mesh::IndexedMesh;
use crate::setters::setters;
use crate::simplify::{SequenceOptions, SimplifyError};
use crate::view::{Camera, Sphere};
use crate::{ProgressFn, ignore_progress};

/// Options of [`ClusterDag::build`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClusterOptions {
    /// Costs, weights and rules of the simplification. Coarser levels are only made while more than
    /// [`SequenceOptions::base_triangle_count`] triangles are left. No finite error exceeds
    /// [`SequenceOptions::max_error`]. [`SequenceOptions::pair_distance`] is ignored.
    pub sequence: SequenceOptions,
    /// Largest number of triangles of a cluster, at least 2; default 128.
    pub max_triangles: usize,
    /// Largest number of vertices of a cluster, at least 6; default 255.
    pub max_vertices: usize,
    /// Number of clusters of a group, at least 2; default 24. Groups of a mesh differ from it by a few.
    pub group_size: usize,
}

impl Default for ClusterOptions {
    fn default() -> Self {
        Self { sequence: SequenceOptions::default(), max_triangles: 128, max_vertices: 255, group_size: 24 }
    }
}

impl ClusterOptions {
    setters! {
        with_sequence, sequence: SequenceOptions;
        with_max_triangles, max_triangles: usize;
        with_max_vertices, max_vertices: usize;
        with_group_size, group_size: usize;
    }

    /// Checks that every option is within its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] with the first option that is out of range.
    pub fn check(&self) -> Result<(), SimplifyError> {
        self.sequence.check()?;
        let limits = [
            ("max_triangles", self.max_triangles, 2, "at least 2"),
            ("max_vertices", self.max_vertices, 6, "at least 6"),
            ("group_size", self.group_size, 2, "at least 2"),
        ];
        match limits.into_iter().find(|&(_, value, least, _)| value < least) {
            None => Ok(()),
            Some((option, value, _, expected)) => {
                Err(SimplifyError::Option { option, value: value.to_string(), expected })
            }
        }
    }
}

/// A cluster: a few triangles that are drawn together.
#[derive(Clone, Debug, PartialEq)]
pub struct Cluster {
    /// Its triangles, in [`ClusterDag::triangles`].
    pub triangles: Range<usize>,
    /// The group that it belongs to, in [`ClusterDag::groups`].
    pub group: usize,
    /// The group whose simplified form it is part of; [`None`] at full detail.
    pub refines: Option<usize>,
    /// Group of the mesh that its triangles come from, in [`IndexedMesh::groups_or_whole`]. It has their material.
    pub mesh_group: usize,
    /// Contains its vertices.
    pub sphere: Sphere,
}

/// Clusters that are replaced together.
#[derive(Clone, Debug, PartialEq)]
pub struct ClusterGroup {
    /// Its clusters, in [`ClusterDag::clusters`].
    pub clusters: Range<usize>,
    /// Number of times that the finest of its clusters have been simplified; 0 at full detail.
    pub depth: usize,
    /// Contains the spheres of all groups that its clusters refine, or its vertices.
    pub sphere: Sphere,
    /// Largest distance of the original mesh from the simplified form, in mesh units; infinite if there is none. It is
    /// an estimate from the original vertices, at least the errors of all groups that its clusters refine.
    pub error: f32,
}

/// Clusters of all levels of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClusterDag {
    /// The clusters of each group in turn. Clusters at full detail are not necessarily the first.
    pub clusters: Vec<Cluster>,
    /// The groups, finest first: the groups that the clusters of a group refine come before it.
    pub groups: Vec<ClusterGroup>,
    /// Vertices of the triangles of each cluster in turn: those of the mesh that the clusters are built from.
    pub triangles: Vec<[u32; 3]>,
}

impl ClusterDag {
    /// Builds the clusters of all levels of a mesh. Time O(n log n).
    ///
    /// Triangles with two corners at one position, which are invisible, are left out.
    ///
    /// # Errors
    /// [`SimplifyError`] if the mesh is invalid or an option is out of range.
    pub fn build(mesh: &IndexedMesh, options: &ClusterOptions) -> Result<Self, SimplifyError> {
        Self::build_with_progress(mesh, options, &mut ignore_progress)
    }

    /// Runs [`build`](Self::build) and reports progress; the callback can cancel.
    ///
    /// # Errors
    /// See [`build`](Self::build); also [`SimplifyError::Cancelled`] if the callback cancels.
    pub fn build_with_progress(
        mesh: &IndexedMesh,
        options: &ClusterOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, SimplifyError> {
        build::build(mesh, options, progress)
    }

    /// Returns the clusters to draw if the function says of each group whether its simplified form is good enough.
    ///
    /// If it says so of a group, it must say so of all groups that the clusters of the group refine. It does if it
    /// compares the projected error with a limit, because errors and spheres nest. It is not asked about
    /// groups without a simplified form.
    pub fn cut(&self, mut is_good_enough: impl FnMut(&ClusterGroup) -> bool) -> Vec<usize> {
        let is_coarse: Vec<bool> =
            self.groups.iter().map(|g| g.error.is_finite() && is_good_enough(g)).collect();
        let is_drawn = |c: &Cluster| !is_coarse[c.group] && c.refines.is_none_or(|finer| is_coarse[finer]);
        (0..).zip(&self.clusters).filter(|(_, c)| is_drawn(c)).map(|(i, _)| i).collect()
    }

    /// Returns the clusters of the coarsest cut whose error is nowhere above a limit, in mesh units.
    pub fn cut_for_error(&self, error: f32) -> Vec<usize> {
        self.cut(|group| group.error <= error)
    }

    /// Returns the visible clusters of the coarsest cut whose error is nowhere above `pixels`.
    pub fn cut_for_camera(&self, camera: &Camera, pixels: f32) -> Vec<usize> {
        let mut cut = self.cut(|group| camera.error_px(group.error, &group.sphere) <= pixels);
        cut.retain(|&cluster| camera.may_see(&self.clusters[cluster].sphere));
        cut
    }

    /// Returns the triangles of some clusters, in their order.
    pub fn triangles_of(&self, clusters: &[usize]) -> Vec<[u32; 3]> {
        clusters.iter().flat_map(|&c| &self.triangles[self.clusters[c].triangles.clone()]).copied().collect()
    }
}

#[cfg(test)]
mod tests;
