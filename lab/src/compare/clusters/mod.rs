//! Compares clusters with those of meshoptimizer's clusterlod and with a cut at single vertices: triangles of a view
//! at equal measured error, reported against measured errors, and build time.
//!
//! Positions only: every contender gets the welded mesh without its attributes. Nothing is culled, so that triangle
//! counts are those of the whole cut.

#[cfg(feature = "peers")]
mod peer;
mod views;

use serde::Serialize;
use striata::clusters::{ClusterDag, ClusterOptions};
use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance, weld};
use striata_lab::cpu_secs;

use self::views::{SurfacePoints, ViewCuts, ViewPoint};
use super::page::{PageBlock, PageSection};
use striata_command::failure::Failure;

/// Shares of the triangles at which reported errors are compared with measured ones.
const SHARES: [f64; 4] = [0.25, 0.1, 0.03, 0.01];

/// The contender that triangles are compared with. Without folds, clusterlod is worse.
const REFERENCE: &str = "clusterlod-folds";

/// How to read the table.
const READING: &str = "Triangles: those of a cut divided by those of clusterlod with folds whose visible points have \
    the same error on the screen (root mean square, 99th percentile, largest); geometric means over four cameras and \
    pixel tolerances of .5 to 4. Reported / measured: errors of uniform cuts of 25, 10, 3 and 1 % of the triangles, \
    divided by the largest distance between the cut and the mesh. Times are those of one thread on a processor.";

/// A hierarchy that was built, and the CPU time that it took.
struct BuiltDag {
    name: &'static str,
    dag: ClusterDag,
    secs: f64,
}

/// Figures of a mesh.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ClustersReport {
    rows: Vec<ClusterRow>,
}

/// Figures of a contender; those of a hierarchy are absent for the cut at vertices.
#[derive(Clone, Debug, Serialize)]
struct ClusterRow {
    contender: &'static str,
    /// Triangles relative to the reference at equal error: RMS, 99th percentile, maximum.
    triangles_at_equal_error: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    hierarchy: Option<HierarchyFigures>,
}

#[derive(Clone, Debug, Serialize)]
struct HierarchyFigures {
    /// Reported over measured errors at each of the shares.
    reported_over_measured: Vec<f64>,
    cluster_count: usize,
    triangles_per_cluster: f64,
    group_count: usize,
    /// Clusters of the coarsest cut: 1 if no group is stuck.
    coarsest_cluster_count: usize,
    /// Millions of triangles of the mesh per second.
    rate: f64,
}

/// Builds all hierarchies of a mesh and measures their cuts.
///
/// # Errors
/// If the mesh has no triangles or is inconsistent.
pub(super) fn measure(mesh: &IndexedMesh, say: &dyn Fn(&str)) -> Result<ClustersReport, Failure> {
    let mesh = weld(&IndexedMesh::new(mesh.positions.clone(), mesh.triangles.clone()))?.mesh;
    if mesh.triangles.is_empty() {
        return Err(Failure::user("the mesh has no triangles".to_owned()));
    }
    say("clusters");
    let built = built_dags(&mesh)?;
    say("vertices");
    let lod = striata::Lod::build(&mesh, &striata::LodOptions::default())?;
    say("views");
    let points = SurfacePoints::new(&mesh)?;
    let views = ViewPoint::all(&mesh, &points)?;
    let cuts: Vec<ViewCuts> = built
        .iter()
        .map(|built| ViewCuts::of_clusters(&mesh, &built.dag, &views))
        .collect::<Result<_, _>>()?;
    let of_vertices = ViewCuts::of_vertices(&lod, &views)?;
    let reference = built.iter().position(|built| built.name == REFERENCE).map(|index| &cuts[index]);
    let relative = |own: &ViewCuts| reference.map(|reference| own.relative_to(reference));
    say("errors");
    let mut rows = Vec::new();
    for (built, cuts) in built.iter().zip(&cuts) {
        rows.push(ClusterRow {
            contender: built.name,
            triangles_at_equal_error: relative(cuts),
            hierarchy: Some(HierarchyFigures::new(&mesh, built)?),
        });
    }
    rows.push(ClusterRow {
        contender: "striata-vertices",
        triangles_at_equal_error: relative(&of_vertices),
        hierarchy: None,
    });
    Ok(ClustersReport { rows })
}

/// Builds the hierarchies of all contenders, each on one thread.
fn built_dags(mesh: &IndexedMesh) -> Result<Vec<BuiltDag>, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.map_err(|error| Failure::internal(error.to_string()))?;
    let own = pool.install(|| {
        let started = cpu_secs();
        let dag = ClusterDag::build(mesh, &ClusterOptions::default())?;
        Ok::<_, Failure>(BuiltDag { name: "striata", dag, secs: cpu_secs() - started })
    });
    Ok(std::iter::once(own?).chain(peer_dags(mesh)?).collect())
}

#[cfg(feature = "peers")]
fn peer_dags(mesh: &IndexedMesh) -> Result<Vec<BuiltDag>, Failure> {
    Ok(peer::build(mesh)?.into())
}

#[cfg(not(feature = "peers"))]
fn peer_dags(_: &IndexedMesh) -> Result<Vec<BuiltDag>, Failure> {
    Ok(Vec::new())
}

impl HierarchyFigures {
    fn new(mesh: &IndexedMesh, built: &BuiltDag) -> Result<Self, Failure> {
        let BuiltDag { dag, secs, .. } = built;
        Ok(Self {
            reported_over_measured: reported_over_measured(mesh, dag)?,
            cluster_count: dag.clusters.len(),
            triangles_per_cluster: dag.triangles.len() as f64 / dag.clusters.len() as f64,
            group_count: dag.groups.len(),
            coarsest_cluster_count: dag.cut(|_| true).len(),
            rate: mesh.triangle_count() as f64 / 1e6 / secs,
        })
    }
}

/// Reported error of a uniform cut of each share of the triangles, divided by its measured error.
fn reported_over_measured(mesh: &IndexedMesh, dag: &ClusterDag) -> Result<Vec<f64>, Failure> {
    let mut errors: Vec<f32> = dag.groups.iter().map(|group| group.error).filter(|e| e.is_finite()).collect();
    errors.sort_by(f32::total_cmp);
    let mut ratios = Vec::new();
    for share in SHARES {
        let wanted = share * mesh.triangle_count() as f64;
        let is_too_fine = |error: &f32| {
            let cut = dag.cut_for_error(*error);
            cut.iter().map(|&c| dag.clusters[c].triangles.len()).sum::<usize>() as f64 > wanted
        };
        let Some(&error) = errors.get(errors.partition_point(is_too_fine)) else { continue };
        let triangles = dag.triangles_of(&dag.cut_for_error(error));
        let level = IndexedMesh::new(mesh.positions.clone(), triangles).without_unused_vertices();
        let measured = surface_distance(mesh, &level, &DistanceOptions::default());
        let measured = measured.map_err(|error| Failure::internal(error.to_string()))?.max;
        if measured > 0.0 {
            ratios.push(f64::from(error) / measured);
        }
    }
    Ok(ratios)
}

/// The table of the text report, with an explanation of its columns.
pub(super) fn to_text(report: &ClustersReport, text_of: impl Fn(Vec<Vec<String>>) -> String) -> String {
    format!("Clusters. {READING}\n{}", text_of(table(report)))
}

/// The section of the page.
pub(super) fn section(report: &ClustersReport) -> PageSection {
    PageSection {
        title: "Clusters".to_owned(),
        intro: READING.to_owned(),
        blocks: vec![PageBlock::WideTable(table(report))],
    }
}

fn table(report: &ClustersReport) -> Vec<Vec<String>> {
    let header = [
        "contender",
        "triangles, RMS",
        "99 %",
        "maximum",
        "reported / measured",
        "clusters",
        "triangles each",
        "groups",
        "coarsest clusters",
        "M triangles/s",
    ];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    let dash = || "-".to_owned();
    for ClusterRow { contender, triangles_at_equal_error, hierarchy } in &report.rows {
        let mut row = vec![(*contender).to_owned()];
        match triangles_at_equal_error {
            Some(ratios) => row.extend(ratios.map(|ratio| format!("{ratio:.2}"))),
            None => row.extend([dash(), dash(), dash()]),
        }
        match hierarchy {
            None => row.extend(std::iter::repeat_with(dash).take(6)),
            Some(figures) => {
                let ratios = figures.reported_over_measured.iter().map(|ratio| format!("{ratio:.2}"));
                row.extend([
                    ratios.collect::<Vec<_>>().join(" "),
                    figures.cluster_count.to_string(),
                    format!("{:.0}", figures.triangles_per_cluster),
                    figures.group_count.to_string(),
                    figures.coarsest_cluster_count.to_string(),
                    format!("{:.2}", figures.rate),
                ]);
            }
        }
        rows.push(row);
    }
    rows
}
