//! Costs of collapses: the trait that every cost implements, and the list of all costs.
//!
//! The evaluator computes what any cost needs: the quadratic form of the current star, the distance of the
//! removed vertex from the new fan, how far the fan sticks out, attributes. A cost says how much of that
//! counts, and adds what it knows of the geometry removed before. To add one, implement [`CollapseCost`] in a
//! file of its own and give it an entry in the list below; options, command and Python read that list.

mod accumulated;
mod collapse_cost;
mod tracked;

use accumulated::Accumulated;
use collapse_cost::Memoryless;
pub(in crate::simplify) use collapse_cost::{CollapseCost, CostRules};
use tracked::Tracked;
pub(in crate::simplify) use tracked::{RemovedVertices, TrackedVertex, nearest};

/// Defines [`CostFunction`] from its entries: name, name in options, short description, implementation.
macro_rules! cost_functions {
    ($($(#[$doc:meta])* $variant:ident, $name:literal, $help:literal, $cost:ty;)*) => {
        /// Cost function that orders the collapses.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum CostFunction {
            $($(#[$doc])* $variant,)*
        }

        impl CostFunction {
            /// All cost functions.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Returns the name as options of the command and of Python spell it.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// Returns a short description for help texts.
            pub const fn help(self) -> &'static str {
                match self { $(Self::$variant => $help,)* }
            }

            /// Creates the cost, to be [started](CollapseCost::begin).
            pub(in crate::simplify) fn create(self) -> Box<dyn CollapseCost> {
                match self { $(Self::$variant => Box::new(<$cost>::default()),)* }
            }
        }
    };
}

cost_functions! {
    /// Memoryless quadrics with volume and distance terms over the current mesh: fast, and the best at
    /// mild levels.
    #[default]
    Memoryless, "memoryless", "current mesh only", Memoryless;
    /// Accumulated quadrics \[GH97\], the classic.
    Accumulated, "accumulated", "sum of all quadrics", Accumulated;
    /// Distances of all removed vertices from the current mesh: slower, and the best at coarse levels.
    Tracked, "tracked", "distance of every removed vertex; slower, best at coarse levels", Tracked;
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use super::collapse_cost::LOCAL;
    use super::*;
    use crate::ignore_progress;
    use crate::mesh::{IndexedMesh, shapes, weld};
    use crate::simplify::SequenceOptions;
    use crate::simplify::collapse::cost_evaluator::CostEvaluator;
    use crate::simplify::collapse::simplifier::Simplifier;
    use crate::simplify::collapse::star::Star;
    use crate::simplify::scaled_space::ScaledSpace;

    /// Squared length of the edge, with a list of the merged positions and the number of tracked ones.
    #[derive(Clone, Debug, Default)]
    struct EdgeLength {
        merged: Arc<Mutex<Vec<[u32; 2]>>>,
        collapsed: Arc<Mutex<Vec<u32>>>,
    }

    impl CollapseCost for EdgeLength {
        fn rules(&self) -> CostRules {
            CostRules { counts_fan: false, bound_factor: 1.0, follows_triangles: true, ..LOCAL }
        }

        fn fill(&self, star: &mut Star, _positions: &[[f32; 4]], _v: u32) {
            for k in 0..star.ring.ids.len() {
                star.costs[k] = star.offset(k).length_squared();
            }
        }

        fn merge(&mut self, v: u32, u: u32) {
            self.merged.lock().expect("no thread panics").push([v, u]);
        }

        fn collapse(&mut self, star: &mut Star, _positions: &[[f32; 4]], v: u32, k: usize) -> Option<f32> {
            assert_eq!(
                star.ring.triangles.len(),
                star.ring.triangle_count(),
                "the star has the indices of triangles"
            );
            assert!(k < star.ring.ids.len());
            self.collapsed.lock().expect("no thread panics").push(v);
            Some(0.25)
        }
    }

    #[test]
    fn any_cost_orders_the_steps_and_is_told_of_them() {
        let torus = IndexedMesh { layers: Vec::new(), ..shapes::torus(24, 10, 1.0, 0.4) };
        let welded = weld(&torus).expect("the mesh is valid");
        let options = SequenceOptions::default();
        let space = ScaledSpace::of(&welded.mesh);
        let cost = EdgeLength::default();
        let evaluator = CostEvaluator::with_cost(&welded, &options, space, Box::new(cost.clone()));
        let simplifier = Simplifier::with_evaluator(&welded, &options, evaluator);
        let (record, _) = simplifier.run(&mut ignore_progress).expect("nothing cancels");
        let merged = cost.merged.lock().expect("no thread panics");
        assert_eq!(*cost.collapsed.lock().expect("no thread panics"), record.removed);
        assert_eq!(merged.iter().map(|[v, _]| *v).collect::<Vec<_>>(), record.removed);
        let length = |[v, u]: [u32; 2]| {
            let [v, u] = [v, u].map(|p| welded.mesh.positions[p as usize].map(f64::from));
            (0..3).map(|axis| (v[axis] - u[axis]) * (v[axis] - u[axis])).sum::<f64>().sqrt()
        };
        let edges = welded.mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let shortest = edges.map(length).fold(f64::INFINITY, f64::min);
        assert!(length(merged[0]) <= shortest + 1e-6, "{} is not {shortest}", length(merged[0]));
        // The error is the distance that the cost reports.
        let error = (0.25f64).sqrt() * space.scale;
        assert!((f64::from(record.errors[0]) - error).abs() < 1e-6 * error, "{}", record.errors[0]);
    }

    #[test]
    fn names_and_descriptions_are_unique() {
        for (i, cost) in CostFunction::ALL.iter().enumerate() {
            assert!(!cost.name().is_empty() && !cost.help().is_empty());
            assert!(CostFunction::ALL[..i].iter().all(|other| other.name() != cost.name()));
        }
        assert_eq!(CostFunction::default().name(), "memoryless");
    }
}
