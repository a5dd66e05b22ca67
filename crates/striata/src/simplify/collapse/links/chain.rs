//! Orders the edges of a link into a ring, if they form one cycle or one path.

use super::edge::{LinkEdge, LinkKind};

/// Scratch for ordering link edges, and the result.
#[derive(Debug, Default)]
pub(super) struct LinkChain {
    pub entries: Vec<u32>,
    pub triangles: Vec<u32>,
    order: Vec<u32>,
}

impl LinkChain {
    /// Orders the edges head to tail; falls back to an edge list if that does not give a single cycle
    /// or path.
    pub(super) fn order(&mut self, edges: &[LinkEdge]) -> LinkKind {
        self.entries.clear();
        self.triangles.clear();
        if edges.is_empty() {
            return LinkKind::Empty;
        }
        let kind = if edges.len() <= 24 { self.order_few(edges) } else { self.order_many(edges) };
        if kind == LinkKind::Edges {
            self.entries.clear();
            self.triangles.clear();
            for e in edges {
                self.entries.extend([e.a, e.b]);
                self.triangles.extend([e.triangle; 2]);
            }
        }
        kind
    }

    /// Orders few edges by quadratic search: the usual six need no map.
    fn order_few(&mut self, edges: &[LinkEdge]) -> LinkKind {
        let n = edges.len();
        let mut start = 0;
        let mut start_count = 0;
        for (i, e) in edges.iter().enumerate() {
            let mut has_predecessor = false;
            for (j, f) in edges.iter().enumerate() {
                // Two edges may not leave the same neighbor, nor enter it.
                if i != j && (e.a == f.a || e.b == f.b) {
                    return LinkKind::Edges;
                }
                has_predecessor |= e.a == f.b;
            }
            if !has_predecessor {
                start = i;
                start_count += 1;
            }
        }
        if start_count > 1 {
            return LinkKind::Edges;
        }
        let mut e = edges[start];
        for _ in 0..n {
            self.entries.push(e.a);
            self.triangles.push(e.triangle);
            match edges.iter().find(|f| f.a == e.b) {
                Some(f) => e = *f,
                None => break,
            }
            // Back at the start too early: there is a second cycle.
            if e == edges[start] {
                break;
            }
        }
        self.close(n, start_count, edges[start], e)
    }

    /// Orders many edges by a sorted list of their tails, for the hubs of large fans.
    fn order_many(&mut self, edges: &[LinkEdge]) -> LinkKind {
        if edges.windows(2).any(|w| w[0].a == w[1].a || w[0].b == w[1].b) {
            // Many triangles at one edge are usually listed one after another; this saves sorting them.
            return LinkKind::Edges;
        }
        self.order.clear();
        self.order.extend(0..edges.len() as u32);
        self.order.sort_unstable_by_key(|&i| (edges[i as usize].a, i));
        let tail = |&i: &u32| edges[i as usize].a;
        if self.order.windows(2).any(|w| tail(&w[0]) == tail(&w[1])) {
            return LinkKind::Edges;
        }
        let mut heads: Vec<u32> = edges.iter().map(|e| e.b).collect();
        heads.sort_unstable();
        if heads.windows(2).any(|w| w[0] == w[1]) {
            return LinkKind::Edges;
        }
        let mut starts = edges.iter().filter(|e| heads.binary_search(&e.a).is_err());
        let start = starts.next().copied();
        let start_count = usize::from(start.is_some()) + starts.count();
        if start_count > 1 {
            return LinkKind::Edges;
        }
        let first = start.unwrap_or(edges[0]);
        let mut e = first;
        for _ in 0..edges.len() {
            self.entries.push(e.a);
            self.triangles.push(e.triangle);
            match self.order.binary_search_by_key(&e.b, tail) {
                Ok(i) => e = edges[self.order[i] as usize],
                Err(_) => break,
            }
            if e == first {
                break;
            }
        }
        self.close(edges.len(), start_count, first, e)
    }

    fn close(&mut self, n: usize, start_count: usize, first: LinkEdge, last: LinkEdge) -> LinkKind {
        if self.entries.len() != n {
            return LinkKind::Edges;
        }
        if start_count == 1 {
            self.entries.push(last.b);
            self.triangles.push(last.triangle);
            return LinkKind::Open;
        }
        // A cycle of two is a triangle and its reverse, not a ring.
        if n < 3 || last != first { LinkKind::Edges } else { LinkKind::Closed }
    }
}
