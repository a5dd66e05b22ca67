//! Report on the cost of strips, shared by all verbs: indices, restarts and vertex cache misses.

use serde::Serialize;
use striata::mesh::{IndexedMesh, MeshError};
use striata::strip::{RESTART, fifo_cache_cost, lru_cache_cost};
use striata_strip::strip_count_bound;

use crate::output::{Table, format_count, format_duration};
use crate::strip_chain::{StripChain, TimedStrips};

/// Costs of the strips of a mesh.
#[derive(Clone, Debug, Serialize)]
pub struct StripReport {
    /// Name of the stripifiers that made the strips.
    pub algorithm: String,
    /// Number of triangles in strips.
    pub triangle_count: usize,
    /// Number of triangles with two equal corners, which are in no strip.
    pub degenerate_triangle_count: usize,
    /// Number of connected parts of the mesh.
    pub component_count: usize,
    /// Number of strips.
    pub strip_count: usize,
    /// Lower bound on the number of strips; given if the last stripifier minimizes that number.
    pub strip_count_bound: Option<usize>,
    /// Number of indices repeated to turn a strip.
    pub swap_count: usize,
    /// Number of restart indices between strips.
    pub restart_count: usize,
    /// Number of indices, including restarts.
    pub index_count: usize,
    /// Indices per triangle, including restarts.
    pub indices_per_triangle: f64,
    /// Number of indices of the longest strip.
    pub longest_strip: usize,
    /// Number of vertex cache entries for the next four figures.
    pub cache_size: usize,
    /// Misses per triangle with a FIFO cache.
    pub acmr: f64,
    /// Misses per vertex with a FIFO cache.
    pub atvr: f64,
    /// Misses per triangle with an LRU cache.
    pub acmr_lru: f64,
    /// Misses per vertex with an LRU cache.
    pub atvr_lru: f64,
    /// Misses per triangle with a FIFO cache of 16 entries, regardless of `cache_size`.
    pub acmr_16: f64,
    /// Misses per vertex with a FIFO cache of 16 entries.
    pub atvr_16: f64,
    /// Misses per triangle with an LRU cache of 16 entries.
    pub acmr_lru_16: f64,
    /// Misses per vertex with an LRU cache of 16 entries.
    pub atvr_lru_16: f64,
    /// Time spent by the stripifiers, seconds.
    pub stripify_secs: f64,
}

impl StripReport {
    /// Measures the strips that `algorithm` made of a mesh, with vertex caches of `cache_size` entries.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub fn new(
        algorithm: String,
        mesh: &IndexedMesh,
        stripped: &TimedStrips,
        cache_size: usize,
    ) -> Result<Self, MeshError> {
        let cost = stripped.strips.cost();
        let indices = stripped.strips.to_restart_indices().indices;
        let caches = |size| {
            let fifo = fifo_cache_cost(&indices, cost.triangle_count, size);
            (fifo, lru_cache_cost(&indices, cost.triangle_count, size))
        };
        let (fifo_16, lru_16) = caches(16);
        let (fifo, lru) = if cache_size == 16 { (fifo_16, lru_16) } else { caches(cache_size) };
        Ok(Self {
            algorithm,
            triangle_count: cost.triangle_count,
            degenerate_triangle_count: mesh.triangle_count() - cost.triangle_count,
            component_count: mesh.component_count()?,
            strip_count: cost.strip_count,
            strip_count_bound: None,
            swap_count: cost.swap_count,
            restart_count: indices.iter().filter(|&&index| index == RESTART).count(),
            index_count: cost.index_count,
            indices_per_triangle: cost.indices_per_triangle,
            longest_strip: cost.longest_strip,
            cache_size,
            acmr: fifo.acmr,
            atvr: fifo.atvr,
            acmr_lru: lru.acmr,
            atvr_lru: lru.atvr,
            acmr_16: fifo_16.acmr,
            atvr_16: fifo_16.atvr,
            acmr_lru_16: lru_16.acmr,
            atvr_lru_16: lru_16.atvr,
            stripify_secs: stripped.secs,
        })
    }

    /// Adds a lower bound on the number of strips if the last stripifier minimizes that number.
    pub fn with_strip_count_bound(self, chain: &StripChain, mesh: &IndexedMesh) -> Self {
        Self { strip_count_bound: chain.minimizes_strip_count().then(|| strip_count_bound(mesh)), ..self }
    }

    /// Formats the report as a table.
    pub fn to_text(&self) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        row("algorithm", self.algorithm.clone());
        row("triangles", format_count(self.triangle_count));
        if self.degenerate_triangle_count > 0 {
            row("degenerate triangles skipped", format_count(self.degenerate_triangle_count));
        }
        row("connected parts", format_count(self.component_count));
        row("strips", format_count(self.strip_count));
        if let Some(bound) = self.strip_count_bound {
            row("strips, lower bound", format_count(bound));
        }
        row("swaps", format_count(self.swap_count));
        row("restarts", format_count(self.restart_count));
        row("indices", format_count(self.index_count));
        row("indices per triangle", format!("{:.4}", self.indices_per_triangle));
        row("indices of longest strip", format_count(self.longest_strip));
        let size = self.cache_size;
        row(&format!("misses per triangle, FIFO {size}"), format!("{:.4}", self.acmr));
        row(&format!("misses per vertex, FIFO {size}"), format!("{:.4}", self.atvr));
        row(&format!("misses per triangle, LRU {size}"), format!("{:.4}", self.acmr_lru));
        row(&format!("misses per vertex, LRU {size}"), format!("{:.4}", self.atvr_lru));
        row("stripification time", format_duration(self.stripify_secs));
        table.to_text()
    }
}
