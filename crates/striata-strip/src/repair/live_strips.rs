//! Strips of the current level, and their moves to other levels.

use std::borrow::Cow;

use striata::mesh::{CollapseSequence, NO_TWIN, RefinableMesh, is_proper};
use striata::strip::{StripLinks, StripSet, strip_triangles, write_strips};

use super::changed_triangles::ChangedTriangles;
use super::error::LiveStripsError;
use super::live_graph::LiveGraph;
use super::options::{RepairGoal, RepairOptions, RepairReport};
use super::scratch::RepairScratch;
use super::tunnel_search::TunnelSearch;

/// Strips of one level of a mesh, which can follow it to any other level.
///
/// Each step changes the mesh by a collapse or a vertex split, continues strips across triangles that were
/// removed or restored, and then searches for tunnels around the change. The strips of a level depend on
/// the path that led there; its triangles do not.
///
/// ```
/// use striata::mesh::shapes;
/// use striata::simplify::{SequenceOptions, build_sequence};
/// use striata_strip::{LiveStrips, RepairOptions, StripOptions, stripify};
///
/// let mesh = shapes::icosphere(3, 1.0);
/// let refinable = build_sequence(&mesh, &SequenceOptions::default())?.refinable;
/// let full = refinable.sequence.step_count();
/// let strips = stripify(&refinable.mesh, &StripOptions::default())?;
/// let mut live = LiveStrips::new(&refinable, full, &strips, &RepairOptions::default())?;
/// let report = live.move_to(full / 2);
/// assert_eq!(report.collapse_count, full - full / 2);
/// assert_eq!(live.to_strip_set().cost().triangle_count, refinable.sequence.triangle_count_at(full / 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct LiveStrips<'a> {
    pub(super) sequence: Cow<'a, CollapseSequence>,
    split_count: usize,
    pub(super) graph: LiveGraph,
    /// Solid bits of every triangle; the graph has the twins.
    pub(super) solid: Vec<u8>,
    pub(super) triangle_count: usize,
    pub(super) solid_count: usize,
    pub(super) goal: RepairGoal,
    /// Number of rings around a step from which repair searches.
    pub(super) reach: u32,
    pub(super) search: TunnelSearch,
    pub(super) scratch: RepairScratch,
    /// Triangles whose strips have changed since a buffer last asked.
    pub(super) changes: ChangedTriangles,
}

impl<'a> LiveStrips<'a> {
    /// Starts with the given strips of the level at `split_count`; the full mesh is at
    /// `refinable.sequence.step_count()`.
    ///
    /// The strips are kept, except that they are cut at edges that the dual graph does not link.
    ///
    /// # Errors
    /// Returns [`LiveStripsError`] if there is no such level, if the strips contain other triangles than
    /// the level, or if the mesh is inconsistent.
    pub fn new(
        refinable: &'a RefinableMesh,
        split_count: usize,
        strips: &StripSet,
        options: &RepairOptions,
    ) -> Result<Self, LiveStripsError> {
        let (mesh, sequence) = (&refinable.mesh, &refinable.sequence);
        mesh.check()?;
        let (found, expected) = (sequence.positions().vertex_count(), mesh.vertex_count());
        if found != expected {
            return Err(LiveStripsError::VertexCount { found, expected });
        }
        let step_count = sequence.step_count();
        if split_count > step_count {
            return Err(LiveStripsError::SplitCount { found: split_count, step_count });
        }
        let mut live = Self {
            sequence: Cow::Borrowed(sequence),
            split_count,
            graph: LiveGraph::new(mesh),
            solid: Vec::new(),
            triangle_count: 0,
            solid_count: 0,
            goal: options.goal,
            reach: options.reach,
            search: TunnelSearch::new(options),
            scratch: RepairScratch::default(),
            changes: ChangedTriangles::default(),
        };
        let mut dying = Vec::new();
        for vertex in (sequence.vertex_count_at(split_count)..mesh.vertex_count()).rev() {
            let (vertex, target) = (vertex as u32, sequence.target(vertex as u32));
            live.graph.dying_into(vertex, target, &mut dying);
            live.graph.collapse(vertex, target, &dying);
        }
        live.take_strips(strips)?;
        Ok(live)
    }

    /// Copies the collapse sequence, so that nothing is borrowed any more.
    pub fn into_owned(self) -> LiveStrips<'static> {
        LiveStrips {
            sequence: Cow::Owned(self.sequence.into_owned()),
            split_count: self.split_count,
            graph: self.graph,
            solid: self.solid,
            triangle_count: self.triangle_count,
            solid_count: self.solid_count,
            goal: self.goal,
            reach: self.reach,
            search: self.search,
            scratch: self.scratch,
            changes: self.changes,
        }
    }

    /// Makes the links of the given strips solid, after checking that they fit the level.
    fn take_strips(&mut self, strips: &StripSet) -> Result<(), LiveStripsError> {
        let (split_count, triangles) = (self.split_count, self.graph.numbered_triangles());
        let mut expected = vec![0; self.graph.group_ends().len()];
        for (i, _) in triangles.iter().enumerate().filter(|&(_, t)| is_proper(t)) {
            expected[self.graph.group_of(i as u32) as usize] += 1;
        }
        if strips.group_count() != expected.len() {
            let (found, expected) = (strips.group_count(), expected.len());
            return Err(LiveStripsError::GroupCount { found, expected });
        }
        let mut links = StripLinks::from_bits(self.graph.twins(), vec![0; triangles.len()]);
        if let Some((strip, triangle)) = links.join_along(&triangles, strips) {
            return Err(LiveStripsError::Triangle { strip, triangle, split_count });
        }
        for (group, &expected) in expected.iter().enumerate() {
            let found = strips.group_strips(group).map(|s| strip_triangles(strips.strip(s)).count()).sum();
            if found != expected {
                return Err(LiveStripsError::TriangleCount { group, found, expected, split_count });
            }
        }
        self.triangle_count = expected.iter().sum();
        self.solid_count = links.solid_count();
        self.solid = links.into_bits();
        Ok(())
    }

    /// Returns the split count of the current level.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Returns the number of steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.sequence.step_count()
    }

    /// Returns the number of triangles of the level.
    pub fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Returns the number of strips of the level.
    pub fn strip_count(&self) -> usize {
        self.triangle_count - self.solid_count
    }

    /// Whether a triangle of the full mesh belongs to a strip of the level.
    pub(super) fn is_shown(&self, triangle: u32) -> bool {
        let corners = self.graph.corners(triangle);
        let vertex_count = self.sequence.vertex_count_at(self.split_count);
        // A dead triangle keeps its last corners, and so a vertex that has collapsed.
        is_proper(&corners) && corners.iter().all(|&vertex| (vertex as usize) < vertex_count)
    }

    /// Counts the links of the level's dual graph, solid and dashed; linear in the size of the full mesh.
    pub fn link_count(&self) -> usize {
        self.graph.twins().iter().filter(|&&twin| twin != NO_TWIN).count() / 2
    }

    /// Appends the triangles of the level, in the order of the full mesh.
    pub fn triangles_into(&self, out: &mut Vec<[u32; 3]>) {
        out.extend(self.graph.numbered_triangles().into_iter().filter(is_proper));
    }

    /// Returns the strips of the level, with the groups of the mesh; linear in the size of the full mesh.
    pub fn to_strip_set(&self) -> StripSet {
        let triangles = self.graph.numbered_triangles();
        let links = StripLinks::from_bits(self.graph.twins(), self.solid.clone());
        debug_assert_eq!(links.solid_count(), self.solid_count, "links are counted as they come and go");
        debug_assert_eq!(links.clone().cut_loops(), 0, "a loop was closed");
        let mut first = 0;
        let groups = self.graph.group_ends().iter().map(|&end| {
            let group = first..end as usize;
            first = group.end;
            group
        });
        let mut out = StripSet::new();
        write_strips(&triangles, &links, groups, &mut out);
        out
    }

    /// Returns the number of bytes that it owns, without the full mesh and its sequence.
    pub fn bytes(&self) -> usize {
        self.graph.bytes() + self.solid.len() + self.changes.bytes()
    }

    /// Moves to a level step by step, and repairs the strips around each step.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn move_to(&mut self, split_count: usize) -> RepairReport {
        let step_count = self.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        let mut report = RepairReport::default();
        while self.split_count > split_count {
            self.split_count -= 1;
            self.coarsen(&mut report);
        }
        while self.split_count < split_count {
            self.refine(&mut report);
            self.split_count += 1;
        }
        report
    }
}
