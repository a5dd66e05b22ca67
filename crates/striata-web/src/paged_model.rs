//! A paged file whose bytes the page fetches.
//!
//! Every method that shows a level returns whether all bytes were there. If not, the page fetches what is
//! [wanted](PagedModel::take_wants), supplies it, and calls the method again. The levels are those of the library:
//! only pages that a level needs are read, and pages of earlier levels are forgotten if memory runs out.

use striata::mesh::{Bounds, IndexedMesh};
use striata::view::{Criterion, DetailBox};
use striata_paged::{
    HeadDefect, PagedCut, PagedError, PagedFile, StoredPlace, SuppliedStore, Want, image_path, leaving,
    page_path,
};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::shown_level::ShownLevel;
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, coloring, normals};

/// Most vertices of the pages in memory, about 250 MB.
const MAX_CACHED_VERTICES: u64 = 4_000_000;
/// Most triangles of a level: beyond them, tolerances are relaxed, whatever was asked for.
const MAX_TRIANGLES: u64 = 4_000_000;
/// Factor by which they are relaxed at a time.
const RELAXATION_STEP: f32 = 1.5;

/// Bytes of a paged file that are missing.
#[wasm_bindgen]
#[derive(Clone, Debug, PartialEq)]
pub struct PagedWant {
    want: Want,
}

#[wasm_bindgen]
impl PagedWant {
    /// Path of the object in the folder of the file, such as `2/17.page`; empty for the file itself.
    #[wasm_bindgen(getter)]
    pub fn path(&self) -> String {
        match self.want.place {
            StoredPlace::Head => String::new(),
            StoredPlace::Page(id) => page_path(id),
            StoredPlace::Image(index) => image_path(index),
        }
    }

    /// First byte.
    #[wasm_bindgen(getter)]
    pub fn from(&self) -> f64 {
        self.want.range.start as f64
    }

    /// Byte after the last one; may lie beyond the end of a small file.
    #[wasm_bindgen(getter)]
    pub fn to(&self) -> f64 {
        self.want.range.end as f64
    }
}

/// A paged file. [Open](Self::open) it, and show levels of it.
#[wasm_bindgen]
pub struct PagedModel {
    store: SuppliedStore,
    file: Option<PagedFile>,
    mesh: IndexedMesh,
    shown: ShownLevel,
    /// Damage that has not been taken.
    damage: Option<Failure>,
}

#[wasm_bindgen]
impl PagedModel {
    /// Creates a model of a file of which nothing is known; errors show the name.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str) -> Self {
        let (mesh, shown) = (IndexedMesh::default(), ShownLevel::default());
        Self { store: SuppliedStore::new(name), file: None, mesh, shown, damage: None }
    }

    /// Takes the first damage that was found since the last call. Pages that are damaged are withheld: levels stay
    /// coarse there.
    pub fn take_damage(&mut self) -> Option<Failure> {
        self.damage.take()
    }

    /// Takes the list of bytes that the last call lacked.
    pub fn take_wants(&self) -> Vec<PagedWant> {
        self.store.take_wants().into_iter().map(|want| PagedWant { want }).collect()
    }

    /// Supplies bytes that were wanted; fewer if the file ends before.
    pub fn supply(&self, want: PagedWant, bytes: Vec<u8>) {
        self.store.supply(want.want, bytes);
    }

    /// Reads the head.
    ///
    /// # Errors
    /// If it is damaged.
    pub fn open(&mut self) -> Result<bool, Failure> {
        let opened = PagedFile::with_store(Box::new(self.store.clone()));
        let Some(file) = arrived(&self.store, opened)? else { return Ok(false) };
        self.file = Some(file.with_max_vertices(MAX_CACHED_VERTICES));
        self.store.clear();
        Ok(true)
    }

    /// Shows the coarsest level whose error is at most this, mesh units.
    ///
    /// # Errors
    /// If pages contradict each other.
    pub fn show_error(&mut self, limit: f32) -> Result<bool, Failure> {
        self.show(|file| level_for(file, limit, |factor| everywhere(limit * factor)))
    }

    /// Shows a level with at most this many triangles.
    ///
    /// # Errors
    /// If pages contradict each other.
    pub fn show_triangles(&mut self, limit: u32) -> Result<bool, Failure> {
        let limit = u64::from(limit).min(MAX_TRIANGLES);
        self.show(|file| match file.metadata().triangle_count <= limit {
            // Flat parts, too, whose steps have no error.
            true => file.level_for(&everywhere(-1.0)),
            false => Ok(file.level_for_box(&everywhere(f32::INFINITY), limit as usize)?.cut),
        })
    }

    /// Refines for a view, with its tolerance multiplied by `factor`. Factors above 1 also leave small errors
    /// around the eye, which no tolerance allows and which are in most of the pages of a view from within.
    ///
    /// # Errors
    /// If pages contradict each other, or the camera sees nothing.
    pub fn show_view(&mut self, view: &View, factor: f32) -> Result<bool, Failure> {
        let criterion = view.criterion()?.relaxed(factor);
        let limit = view.triangle_limit as usize;
        self.show(|file| match limit {
            0 => {
                let left = file.reader().passing_error(factor);
                level_for(file, 1.0, |factor| leaving(criterion.clone().relaxed(factor), left))
            }
            limit => Ok(file.level_for_view(&criterion, Some(limit))?.cut),
        })
    }

    /// Number of triangles of the full mesh.
    #[wasm_bindgen(getter)]
    pub fn full_triangle_count(&self) -> f64 {
        self.file.as_ref().map_or(0.0, |file| file.metadata().triangle_count as f64)
    }

    /// Number of vertices of the full mesh.
    #[wasm_bindgen(getter)]
    pub fn full_vertex_count(&self) -> f64 {
        self.file.as_ref().map_or(0.0, |file| file.metadata().vertex_count as f64)
    }

    /// Number of vertex splits from the base mesh to the full mesh.
    #[wasm_bindgen(getter)]
    pub fn step_count(&self) -> f64 {
        self.file.as_ref().map_or(0.0, |file| file.metadata().position_count as f64)
    }

    /// Minimum and maximum coordinates of the full mesh; empty before the head has arrived.
    pub fn bounds(&self) -> Vec<f32> {
        self.full_bounds().map_or(Vec::new(), |bounds| [bounds.min, bounds.max].as_flattened().to_vec())
    }

    /// Whether z is up: the mesh is a terrain with a georeference, or as flat along z as one.
    #[wasm_bindgen(getter)]
    pub fn is_z_up(&self) -> bool {
        let is_georeferenced = |file: &PagedFile| file.metadata().georeference.is_some();
        self.file.as_ref().is_some_and(is_georeferenced)
            || self.full_bounds().is_some_and(|bounds| bounds.lies_flat())
    }

    /// Diagonal of these bounds, mesh units.
    #[wasm_bindgen(getter)]
    pub fn diagonal(&self) -> f64 {
        self.full_bounds().map_or(0.0, |bounds| bounds.diagonal())
    }

    /// The vertices of the shown level.
    pub fn vertices(&self) -> Vertices {
        Vertices::new(&self.mesh.positions, &self.mesh.layers, 0, self.mesh.appearance.color_space)
    }

    /// Number of vertices of the shown level.
    #[wasm_bindgen(getter)]
    pub fn vertex_count(&self) -> usize {
        self.mesh.vertex_count()
    }

    /// Normals of the shown level, computed from its triangles.
    pub fn smooth_normals(&self) -> Vec<f32> {
        let own: Vec<u32> = (0..=self.mesh.vertex_count() as u32).collect();
        normals::of_vertices(&self.mesh.positions, &self.shown.triangles, &own).into_flattened()
    }

    /// Stripifies the shown triangles, reorders them by strip, and returns the strip number of each.
    ///
    /// # Errors
    /// If the triangles cannot be stripified.
    pub fn color_strips(&mut self) -> Result<Vec<u32>, Failure> {
        coloring::by_strips(&mut self.shown, self.mesh.vertex_count())
    }

    /// Returns the fan number of each shown triangle: the vertex that it pivots around.
    pub fn color_fans(&self) -> Vec<u32> {
        coloring::by_pivots(&self.shown)
    }

    /// Corners of the shown triangles, group by group.
    pub fn indices(&self) -> Vec<u32> {
        self.shown.triangles.as_flattened().to_vec()
    }

    /// Number of shown triangles in each group.
    pub fn group_counts(&self) -> Vec<u32> {
        self.shown.group_counts.clone()
    }

    /// Number of vertex splits of the shown level.
    #[wasm_bindgen(getter)]
    pub fn shown_split_count(&self) -> usize {
        self.shown.split_count
    }

    /// Largest error of the shown level, mesh units.
    #[wasm_bindgen(getter)]
    pub fn shown_error(&self) -> f32 {
        self.shown.error
    }
}

impl PagedModel {
    fn full_bounds(&self) -> Option<Bounds> {
        let metadata = self.file.as_ref()?.metadata();
        Some(Bounds { min: metadata.min, max: metadata.max })
    }

    fn show(
        &mut self,
        level: impl Fn(&mut PagedFile) -> Result<PagedCut, PagedError>,
    ) -> Result<bool, Failure> {
        let Some(file) = &mut self.file else { return Err(Failure::unsupported("the file is not open")) };
        let mut found = level(file);
        while let Err(error) = &found
            && error.page().is_some_and(|page| file.withhold(page))
        {
            self.damage.get_or_insert_with(|| {
                Failure::corrupt(error).with_hint("its part of the mesh stays coarse")
            });
            found = level(file);
        }
        let Some(cut) = arrived(&self.store, found)? else { return Ok(false) };
        self.store.clear();
        let PagedCut { mut mesh, refined_count, error, .. } = cut;
        let triangles = std::mem::take(&mut mesh.triangles);
        let group_counts = match mesh.groups.as_slice() {
            [] => vec![triangles.len() as u32],
            groups => groups.iter().map(|group| group.count).collect(),
        };
        self.shown = ShownLevel { triangles, group_counts, split_count: refined_count, error };
        self.mesh = mesh;
        Ok(true)
    }
}

impl std::fmt::Debug for PagedModel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PagedModel").field("store", &self.store).finish_non_exhaustive()
    }
}

/// The result of reading; nothing if bytes were missing.
fn arrived<T>(store: &SuppliedStore, result: Result<T, PagedError>) -> Result<Option<T>, Failure> {
    match result {
        Ok(found) => Ok(Some(found)),
        Err(_) if store.lacks_bytes() => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// The criterion of levels with one error.
fn everywhere(error: f32) -> DetailBox {
    // No part reaches this box.
    DetailBox { min: [f32::MAX; 3], max: [f32::MAX; 3], error_outside: error }
}

/// The level for a criterion, relaxed until its pages do not have far too many triangles.
fn level_for<C: Criterion + Sync>(
    file: &mut PagedFile,
    tolerance: f32,
    criterion: impl Fn(f32) -> C,
) -> Result<PagedCut, PagedError> {
    let mut factor = 1.0;
    loop {
        let relaxed = criterion(factor);
        let pages = file.select(|bound| relaxed.weigh(&bound.part()).should_refine())?;
        let added =
            |page: &u32| file.reader().entry(*page).map_or(0, |entry| u64::from(entry.added_triangle_count));
        // An exact level of a large file does not fit, and no factor relaxes a tolerance of zero.
        if pages.iter().map(added).sum::<u64>() <= MAX_TRIANGLES {
            return file.level_for(&relaxed);
        }
        if tolerance == 0.0 {
            return Ok(file.level_for_box(&everywhere(f32::INFINITY), MAX_TRIANGLES as usize)?.cut);
        }
        factor *= RELAXATION_STEP;
    }
}

impl From<PagedError> for Failure {
    fn from(error: PagedError) -> Self {
        match &error {
            PagedError::Head(HeadDefect::Magic) => Self::format(error),
            PagedError::Head(HeadDefect::Version(_)) => Self::unsupported(error),
            _ => Self::corrupt(error),
        }
    }
}
