//! Paged files of meshes.

use striata::ignore_progress;
use striata::mesh::IndexedMesh;
use striata_paged::PagedFile;
use striata_paged::build::{BuildInput, BuildOptions, BuildPaths, PagedPlan, run_all};
use tempfile::TempDir;

/// A paged file of a mesh with its exact positions, unless no file can hold it.
pub(crate) fn try_built(mesh: &IndexedMesh) -> Option<(TempDir, PagedFile)> {
    try_built_with(mesh, true)
}

/// A paged file of a mesh, with its exact positions or those of a grid.
pub(crate) fn try_built_with(mesh: &IndexedMesh, exact: bool) -> Option<(TempDir, PagedFile)> {
    let folder = tempfile::tempdir().unwrap();
    let (input, output) = (folder.path().join("mesh.glb"), folder.path().join("mesh.striata"));
    striata_io::write(&input, mesh, &striata_io::WriteOptions::default()).ok()?;
    let work = folder.path().join("work");
    let options = BuildOptions { cell: 2000, exact, ..BuildOptions::default() };
    let paths = BuildPaths { output: &output, folder: &work };
    let plan =
        PagedPlan::make(BuildInput::Files(vec![input]), options, paths, 1, &mut ignore_progress).ok()?;
    run_all(&plan, 1, &mut ignore_progress).ok()?;
    plan.remove_work().unwrap();
    let file = PagedFile::open(output.to_str().unwrap()).unwrap();
    Some((folder, file))
}

pub(crate) fn built(mesh: &IndexedMesh) -> (TempDir, PagedFile) {
    try_built(mesh).expect("the mesh can be built")
}
