//! A general step as both sides see it: a position splits off another one, takes some of its triangles over, and brings new ones.

use std::ops::Range;

/// A triangle that a step brings: of the new position, the one that splits, and a third.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Born {
    /// The third position.
    pub(crate) third: u32,
    /// Whether it is (new, split, third) rather than (new, third, split).
    pub(crate) is_forward: bool,
}

impl Born {
    /// In the order of the triangle's corners, given what is meant by the new one, the split one and the third.
    pub(crate) fn ordered(self, [new, split, third]: [u32; 3]) -> [u32; 3] {
        if self.is_forward { [new, split, third] } else { [new, third, split] }
    }
}

/// What a writer knows of a triangle that a step brings.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KnownBorn {
    /// Its form.
    pub(crate) born: Born,
    /// The vertex of the mesh that is given that its corner at the new position shows.
    pub(crate) own: u32,
    /// The vertices of the stream that its other corners show: at the split position, and at the third.
    pub(crate) others: [u32; 2],
    /// Its group.
    pub(crate) group: u32,
}

/// What a writer knows of a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct KnownStep {
    /// The position that splits.
    pub(crate) split: u32,
    /// Corners at it that go to the new position, and the vertices of the mesh that is given that they show then; ascending.
    pub(crate) moved: Vec<(u32, u32)>,
    /// Triangles that come.
    pub(crate) born: Vec<KnownBorn>,
    /// Vertices of the new position, of the mesh that is given.
    pub(crate) wedges: Range<u32>,
    /// The vertex of the stream that each of them collapses to.
    pub(crate) targets: Vec<u32>,
    /// Where it is on the grid.
    pub(crate) place: [i32; 3],
    /// Where it is exactly, mesh units.
    pub(crate) exact: [f32; 3],
}

impl KnownStep {
    /// Whether a corner goes to the new position.
    pub(crate) fn moves(&self, corner: u32) -> bool {
        self.moved.binary_search_by_key(&corner, |moved| moved.0).is_ok()
    }

    /// The vertex of the stream that a vertex of the new position collapses to.
    pub(crate) fn target_of(&self, wedge: u32) -> Option<u32> {
        self.targets.get(wedge.checked_sub(self.wedges.start)? as usize).copied()
    }

    /// The vertex of the mesh that is given that a corner shows afterwards.
    pub(crate) fn shown(&self, corner: u32) -> Option<u32> {
        let at = self.moved.binary_search_by_key(&corner, |moved| moved.0).ok()?;
        Some(self.moved[at].1)
    }
}

/// A step as it was coded.
#[derive(Clone, Debug, Default)]
pub(crate) struct CodedStep {
    /// The position that splits.
    pub(crate) split: u32,
    /// Corners that go to the new position, in the order of the complex.
    pub(crate) moved: Vec<u32>,
    /// The same corners, neighbors after each other where there are any.
    pub(crate) fan: Vec<u32>,
    /// Triangles that come.
    pub(crate) born: Vec<Born>,
    /// For each of them, which of a writer's triangles it is.
    pub(crate) known: Vec<usize>,
    /// Where the new position is on the grid.
    pub(crate) place: [i32; 3],
    /// The vertex of the stream that each wedge of the new position collapses to.
    pub(crate) targets: Vec<u32>,
    /// What a writer calls the wedges.
    pub(crate) named: Vec<u32>,
    /// The wedge at each corner of the fan, then at the new corner of each triangle that comes.
    pub(crate) wedges: Vec<u32>,
    /// The vertices that the other corners of each triangle that comes show: at the split position, and at the third.
    pub(crate) others: Vec<[u32; 2]>,
    /// The groups of the triangles that come.
    pub(crate) groups: Vec<u32>,
}

impl CodedStep {
    /// What corners show where each position is one vertex, of the same number, and there are no groups.
    pub(crate) fn show_positions(&mut self) {
        self.targets = vec![self.split];
        self.wedges = vec![0; self.fan.len() + self.born.len()];
        self.others = self.born.iter().map(|born| [self.split, born.third]).collect();
        self.groups = vec![0; self.born.len()];
    }
}
