//! What makes a collapse better or worse for a coder, beyond its error.
//!
//! A coder foretells what is regular: triangles of even size and kept vertices of few triangles. So long edges and high
//! valences cost extra. Most of a stream belongs to the finest batches, while the error of a level is made by the
//! last collapses before it: the extra fades as the mesh shrinks, in proportion to the positions that are left. Over four
//! meshes that gave 0.1 bits a vertex for the same RMS at a quarter of the triangles, and less of it from there on.

use crate::simplify::collapse::links::Links;
use crate::simplify::collapse::star::Star;

use super::options::BatchOptions;
use super::surface;

/// How much the coder's preferences count at present.
#[derive(Clone, Copy, Debug)]
pub(super) struct Taste {
    /// Square of the shape step in scaled units.
    shape: f32,
    fair_valence: usize,
    valence_weight: f32,
    /// Share of the positions that are left.
    left: f32,
}

impl Taste {
    /// For a mesh one of whose scaled units is `scale` mesh units.
    pub(super) fn new(options: &BatchOptions, scale: f64) -> Self {
        let step = (options.shape_step.unwrap_or(0.0) / scale) as f32;
        Self {
            shape: step * step,
            fair_valence: options.fair_valence,
            valence_weight: options.valence_weight as f32,
            left: 1.0,
        }
    }

    /// Fades the preferences to `left` positions of `all`.
    pub(super) fn fade(&mut self, left: usize, all: usize) {
        self.left = left as f32 / all.max(1) as f32;
    }

    /// Raises the costs of the targets of `v`.
    pub(super) fn adjust(self, links: &Links, star: &mut Star, v: u32) {
        let own = surface::valence(links, v);
        for k in 0..star.ids.len() {
            // Where the target is not manifold this counts its other parts too, which does no harm to a preference.
            let valence = (surface::valence(links, star.ids[k]) + own).saturating_sub(4);
            let excess = valence.saturating_sub(self.fair_valence) as f32;
            let shape = self.left * self.shape * star.offset(k).length_squared();
            star.costs[k] = (star.costs[k] + shape) * (1.0 + self.left * self.valence_weight * excess);
        }
    }
}
