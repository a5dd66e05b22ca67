//! Stores which pieces of the original surface are assigned to each current triangle.

use super::polygon::Polygon;

pub(super) const NONE: u32 = u32::MAX;

/// First whole triangle and first part in the lists of a face.
#[derive(Clone, Copy)]
struct FaceHeads {
    whole: u32,
    part: u32,
}

const EMPTY: FaceHeads = FaceHeads { whole: NONE, part: NONE };

/// Entry of a linked list.
struct ListNode<T> {
    triangle: u32,
    next: u32,
    piece: T,
}

/// Entries of all lists, and a list of free ones.
struct ListPool<T> {
    nodes: Vec<ListNode<T>>,
    free: u32,
}

impl<T> ListPool<T> {
    fn take(&mut self, node: ListNode<T>) -> u32 {
        if self.free == NONE {
            self.nodes.push(node);
            self.nodes.len() as u32 - 1
        } else {
            let at = self.free;
            self.free = std::mem::replace(&mut self.nodes[at as usize], node).next;
            at
        }
    }

    fn drop_list(&mut self, head: u32) {
        let mut last = head;
        if last == NONE {
            return;
        }
        while self.nodes[last as usize].next != NONE {
            last = self.nodes[last as usize].next;
        }
        self.nodes[last as usize].next = std::mem::replace(&mut self.free, head);
    }

    fn for_each(&self, mut at: u32, mut f: impl FnMut(u32, &T)) {
        while at != NONE {
            let node = &self.nodes[at as usize];
            f(node.triangle, &node.piece);
            at = node.next;
        }
    }
}

/// Pieces by face: whole original triangles and parts of some.
pub(super) struct Pieces {
    heads: Vec<FaceHeads>,
    wholes: ListPool<()>,
    parts: ListPool<Polygon>,
}

impl Pieces {
    /// Assigns each original triangle to the face with the same index.
    pub(super) fn new(triangle_count: usize) -> Self {
        let node = |triangle| ListNode { triangle, next: NONE, piece: () };
        Self {
            heads: (0..triangle_count as u32).map(|t| FaceHeads { whole: t, ..EMPTY }).collect(),
            wholes: ListPool { nodes: (0..triangle_count as u32).map(node).collect(), free: NONE },
            parts: ListPool { nodes: Vec::new(), free: NONE },
        }
    }

    pub(super) fn for_each_whole(&self, face: u32, mut f: impl FnMut(u32)) {
        let head = self.heads.get(face as usize).unwrap_or(&EMPTY);
        self.wholes.for_each(head.whole, |triangle, ()| f(triangle));
    }

    pub(super) fn for_each_part(&self, face: u32, f: impl FnMut(u32, &Polygon)) {
        let head = self.heads.get(face as usize).unwrap_or(&EMPTY);
        self.parts.for_each(head.part, f);
    }

    pub(super) fn clear(&mut self, face: u32) {
        if let Some(head) = self.heads.get_mut(face as usize) {
            let head = std::mem::replace(head, EMPTY);
            self.wholes.drop_list(head.whole);
            self.parts.drop_list(head.part);
        }
    }

    pub(super) fn push_whole(&mut self, face: u32, triangle: u32) {
        let next = self.head(face).whole;
        self.head(face).whole = self.wholes.take(ListNode { triangle, next, piece: () });
    }

    pub(super) fn push_part(&mut self, face: u32, triangle: u32, piece: Polygon) {
        let next = self.head(face).part;
        self.head(face).part = self.parts.take(ListNode { triangle, next, piece });
    }

    fn head(&mut self, face: u32) -> &mut FaceHeads {
        if self.heads.len() <= face as usize {
            self.heads.resize(face as usize + 1, EMPTY);
        }
        &mut self.heads[face as usize]
    }

    /// Largest number of entries ever in use, for whole triangles and for parts.
    #[cfg(test)]
    pub(super) fn peak(&self) -> [usize; 2] {
        [self.wholes.nodes.len(), self.parts.nodes.len()]
    }
}
