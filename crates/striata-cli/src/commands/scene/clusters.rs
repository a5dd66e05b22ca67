//! `build --clusters`: a plain glTF file with the clusters of all levels.

use std::path::Path;

use serde::Serialize;
use striata::ProgressFn;
use striata::clusters::{ClusterDag, ClusterOptions};
use striata_command::args::SequenceArgs;
use striata_command::clock::{Phases, peak_rss_bytes};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Table, format_bytes, format_count, format_duration};
use striata_command::save::{display_name, write_bytes};
use striata_io::Scene;
use striata_scene::{ClusteredScene, MeshWeight};

/// Builds the clusters of a scene.
///
/// # Errors
/// If a mesh is inconsistent, or a flag is for one mesh only.
pub(super) fn clustered(
    input: &Input,
    scene: Scene,
    args: &SequenceArgs,
    max_triangles: usize,
    progress: &mut ProgressFn<'_>,
) -> Result<ClusteredScene, Failure> {
    let sequence = args.scene_options(&scene, false)?.sequence;
    let options = ClusterOptions::default().with_sequence(sequence).with_max_triangles(max_triangles);
    let failed = |error| Failure::user(format!("{}: {error}", input.name));
    ClusteredScene::build_with_progress(scene, &options, progress).map_err(failed)
}

/// Contents of a file with clusters; counts are sums over the meshes of the document.
#[derive(Serialize)]
pub(super) struct ClusterReport {
    path: String,
    mesh_count: usize,
    /// Number of triangles at full detail.
    triangle_count: usize,
    cluster_count: usize,
    group_count: usize,
    /// Number of triangles of all clusters.
    cluster_triangle_count: usize,
    /// Number of triangles of the coarsest cut.
    base_triangle_count: usize,
    /// Error of the coarsest cut, the largest over all meshes, scene units.
    error_max: f64,
    /// Size of the file without the extension.
    plain_bytes: usize,
    /// Bytes of the extension.
    cluster_bytes: usize,
    output_bytes: usize,
    #[serde(flatten)]
    pub phases: Phases,
    peak_rss_bytes: Option<u64>,
}

impl ClusterReport {
    /// Writes the file; an existing one is left unchanged if that fails.
    ///
    /// # Errors
    /// If the scene cannot be stored, or the file cannot be written.
    pub(super) fn write(
        clustered: &ClusteredScene,
        path: &Path,
        mut phases: Phases,
    ) -> Result<Self, Failure> {
        let glb = clustered.to_glb().map_err(|error| Failure::user(error.to_string()))?;
        write_bytes(&glb.bytes, path)?;
        phases.leave();
        let dags = || clustered.dags().iter().flatten();
        let triangles = |dag: &ClusterDag, cut: Vec<usize>| dag.triangles_of(&cut).len();
        let weights = MeshWeight::of_scene(clustered.scene());
        let errors = clustered.dags().iter().zip(&weights).flat_map(|(dag, weight)| {
            let groups = dag.iter().flat_map(|dag| &dag.groups);
            groups.map(|group| f64::from(group.error) * weight.scale)
        });
        Ok(Self {
            path: display_name(path),
            mesh_count: dags().count(),
            triangle_count: dags().map(|dag| triangles(dag, dag.cut(|_| false))).sum(),
            cluster_count: dags().map(|dag| dag.clusters.len()).sum(),
            group_count: dags().map(|dag| dag.groups.len()).sum(),
            cluster_triangle_count: dags().map(|dag| dag.triangles.len()).sum(),
            base_triangle_count: dags().map(|dag| triangles(dag, dag.cut(|_| true))).sum(),
            error_max: errors.filter(|error| error.is_finite()).fold(0.0, f64::max),
            plain_bytes: glb.plain_bytes,
            cluster_bytes: glb.bytes.len() - glb.plain_bytes,
            output_bytes: glb.bytes.len(),
            phases,
            peak_rss_bytes: peak_rss_bytes(),
        })
    }

    pub(super) fn to_text(&self) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        row("meshes", format_count(self.mesh_count));
        let [full, base] = [self.triangle_count, self.base_triangle_count].map(format_count);
        row("triangles", format!("{full} down to {base}"));
        let [clusters, groups] = [self.cluster_count, self.group_count].map(format_count);
        row("clusters", format!("{clusters} in {groups} groups, with errors (estimated)"));
        let share = 100.0 * self.cluster_bytes as f64 / self.plain_bytes.max(1) as f64;
        row(
            "size of clusters",
            format!("{} (+{share:.1} % of the plain file)", format_bytes(self.cluster_bytes)),
        );
        row("file", format!("{} ({})", self.path, format_bytes(self.output_bytes)));
        row("time", format_duration(self.phases.total_secs()));
        table.to_text()
    }
}
