//! What strips cost, in the keys and rows that every verb tells it in.

use serde::Serialize;
use striata::mesh::{IndexedMesh, MeshError};
use striata::strip::{RESTART, fifo_cache_cost, lru_cache_cost};
use striata_strip::strip_count_bound;

use crate::output::{Table, format_count, format_duration};
use crate::strip_chain::{StripChain, TimedStrips};

/// What strips cost.
#[derive(Clone, Debug, Serialize)]
pub struct StripReport {
    /// What made the strips.
    pub algorithm: String,
    /// Triangles of the mesh.
    pub triangle_count: usize,
    /// Triangles with two equal corners, which are in no strip.
    pub degenerate_triangle_count: usize,
    /// Connected parts of the mesh.
    pub component_count: usize,
    /// Strips.
    pub strip_count: usize,
    /// Told where few strips are what was wanted.
    pub strip_count_bound: Option<usize>,
    /// Indices repeated to turn a strip.
    pub swap_count: usize,
    /// Restart indices between strips.
    pub restart_count: usize,
    /// Indices, restarts included.
    pub index_count: usize,
    /// Indices, restarts included, for each triangle.
    pub indices_per_triangle: f64,
    /// Indices of the longest strip.
    pub longest_strip: usize,
    /// Entries of the vertex cache that the next four figures hold for.
    pub cache_size: usize,
    /// Misses per triangle, first in first out.
    pub acmr: f64,
    /// Misses per vertex, first in first out.
    pub atvr: f64,
    /// Misses per triangle, least recently used out.
    pub acmr_lru: f64,
    /// Misses per vertex, least recently used out.
    pub atvr_lru: f64,
    /// For 16 entries, whatever the cache asked for.
    pub acmr_16: f64,
    /// Misses per vertex with 16 entries, first in first out.
    pub atvr_16: f64,
    /// Misses per triangle with 16 entries, least recently used out.
    pub acmr_lru_16: f64,
    /// Misses per vertex with 16 entries, least recently used out.
    pub atvr_lru_16: f64,
    /// Time that the stripifier took, seconds.
    pub stripify_secs: f64,
}

impl StripReport {
    /// Measures the strips of a mesh; `algorithm` is what made them, and vertex caches have `cache_size` entries.
    ///
    /// # Errors
    /// Where the mesh's parts do not fit together.
    pub fn new(
        algorithm: String,
        mesh: &IndexedMesh,
        stripped: &TimedStrips,
        cache_size: usize,
    ) -> Result<Self, MeshError> {
        let cost = stripped.strips.cost();
        let drawn = stripped.strips.to_restart_indices().indices;
        let caches = |size| {
            let fifo = fifo_cache_cost(&drawn, cost.triangle_count, size);
            (fifo, lru_cache_cost(&drawn, cost.triangle_count, size))
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
            restart_count: drawn.iter().filter(|&&index| index == RESTART).count(),
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

    /// Adds how many strips along the edges of the mesh there are at least, where the chain ends with fewest strips.
    pub fn with_bound(self, chain: &StripChain, mesh: &IndexedMesh) -> Self {
        Self { strip_count_bound: chain.wants_few_strips().then(|| strip_count_bound(mesh)), ..self }
    }

    /// The same for people.
    pub fn to_text(&self) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        row("algorithm", self.algorithm.clone());
        row("triangles", format_count(self.triangle_count));
        if self.degenerate_triangle_count > 0 {
            row("degenerate, left out", format_count(self.degenerate_triangle_count));
        }
        row("components", format_count(self.component_count));
        row("strips", format_count(self.strip_count));
        if let Some(bound) = self.strip_count_bound {
            row("strips, at the very least", format_count(bound));
        }
        row("swaps", format_count(self.swap_count));
        row("restarts", format_count(self.restart_count));
        row("indices", format_count(self.index_count));
        row("indices a triangle", format!("{:.4}", self.indices_per_triangle));
        row("longest strip, indices", format_count(self.longest_strip));
        let size = self.cache_size;
        row(&format!("misses a triangle, FIFO {size}"), format!("{:.4}", self.acmr));
        row(&format!("misses a vertex, FIFO {size}"), format!("{:.4}", self.atvr));
        row(&format!("misses a triangle, LRU {size}"), format!("{:.4}", self.acmr_lru));
        row(&format!("misses a vertex, LRU {size}"), format!("{:.4}", self.atvr_lru));
        row("time of the stripifier", format_duration(self.stripify_secs));
        table.to_text()
    }
}
