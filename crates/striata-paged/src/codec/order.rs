//! The order of a page: triangles as a region grows over edges, vertices as the triangles meet them.

use std::collections::{HashMap, VecDeque};

use crate::Page;
use crate::hash::IndexHash;

const NONE: u32 = u32::MAX;

impl Page {
    /// Brings the page into the order in which it is stored; returns the new number of each owned vertex.
    ///
    /// Triangles are sorted so that most share an edge with an earlier one. Positions, their wedges, and imports
    /// are numbered in the order in which the triangles meet them. The result depends on the surface and its
    /// first triangle; a page in this order is not changed.
    pub fn normalize(&mut self) -> Vec<u32> {
        let owned = self.positions.len();
        let mut node_of: Vec<u32> = vec![0; owned + self.imports.len()];
        let position_count = self.first.len().saturating_sub(1);
        for (p, wedges) in self.first.windows(2).enumerate() {
            node_of[wedges[0] as usize..wedges[1] as usize].fill(p as u32);
        }
        for import in 0..self.imports.len() {
            node_of[owned + import] = (position_count + import) as u32;
        }
        let order = grown(&self.triangles, &node_of);
        let triangles: Vec<[u32; 3]> =
            order.iter().map(|&(t, turn)| rotated(self.triangles[t as usize], turn)).collect();
        if !self.triangle_layers.is_empty() {
            let order: Vec<u32> = order.iter().map(|&(t, _)| t).collect();
            self.triangle_layers = self.triangle_rows(&order);
        }
        if !self.groups.is_empty() {
            self.groups = order.iter().map(|&(t, _)| self.groups[t as usize]).collect();
        }
        self.renumber(&triangles, &node_of)
    }

    /// Numbers vertices in the order in which triangles meet them.
    fn renumber(&mut self, triangles: &[[u32; 3]], node_of: &[u32]) -> Vec<u32> {
        let owned = self.positions.len() as u32;
        let position_count = self.first.len().saturating_sub(1);
        let mut wedges: Vec<Vec<u32>> = vec![Vec::new(); position_count];
        let (mut positions, mut imports) = (Vec::new(), Vec::new());
        let mut is_met = vec![false; node_of.len()];
        let mut meet = |v: u32| {
            if std::mem::replace(&mut is_met[v as usize], true) {
                return;
            }
            if v >= owned {
                imports.push(v);
                return;
            }
            let p = node_of[v as usize] as usize;
            if wedges[p].is_empty() {
                positions.push(p);
            }
            wedges[p].push(v);
        };
        triangles.as_flattened().iter().for_each(|&v| meet(v));
        // Vertices that no triangle uses come last.
        (0..owned).for_each(&mut meet);
        self.targets.iter().for_each(|&v| meet(v));
        (owned..node_of.len() as u32).for_each(meet);
        let mut number = vec![NONE; node_of.len()];
        let mut first = vec![0];
        let mut order = Vec::with_capacity(owned as usize);
        for &p in &positions {
            for &v in &wedges[p] {
                number[v as usize] = order.len() as u32;
                order.push(v);
            }
            first.push(order.len() as u32);
        }
        for (i, &v) in (0..).zip(&imports) {
            number[v as usize] = owned + i;
        }
        self.first = first;
        self.triangles = triangles.iter().map(|t| t.map(|v| number[v as usize])).collect();
        self.positions = order.iter().map(|&v| self.positions[v as usize]).collect();
        self.layers = self.layers.iter().map(|layer| layer.gather(&order)).collect();
        if !self.targets.is_empty() {
            self.targets = order.iter().map(|&v| number[self.targets[v as usize] as usize]).collect();
            self.keys = positions.iter().map(|&p| self.keys[p]).collect();
            self.errors = positions.iter().map(|&p| self.errors[p]).collect();
        }
        self.imports = imports.iter().map(|&v| self.imports[(v - owned) as usize]).collect();
        number.truncate(owned as usize);
        number
    }
}

fn rotated(t: [u32; 3], turn: u8) -> [u32; 3] {
    let turn = turn as usize;
    [t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]]
}

/// Grows a region over edges: triangles in order, each with the corner that comes first.
fn grown(triangles: &[[u32; 3]], node_of: &[u32]) -> Vec<(u32, u8)> {
    let nodes = |t: u32| triangles[t as usize].map(|v| node_of[v as usize]);
    // Triangles by directed edge, as linked lists in ascending order.
    let mut head: HashMap<(u32, u32), u32, IndexHash> = HashMap::default();
    head.reserve(3 * triangles.len());
    let mut next = vec![NONE; 3 * triangles.len()];
    for t in (0..triangles.len() as u32).rev() {
        let n = nodes(t);
        for i in (0..3).rev() {
            let corner = 3 * t + i;
            if let Some(other) = head.insert((n[i as usize], n[(i as usize + 1) % 3]), corner) {
                next[corner as usize] = other;
            }
        }
    }
    let mut is_done = vec![false; triangles.len()];
    let mut order = Vec::with_capacity(triangles.len());
    let mut gates: VecDeque<(u32, u32)> = VecDeque::new();
    for seed in 0..triangles.len() as u32 {
        if is_done[seed as usize] {
            continue;
        }
        let mut found = Some((seed, 0));
        loop {
            if let Some((t, turn)) = found.take() {
                is_done[t as usize] = true;
                order.push((t, turn));
                let [a, b, c] = rotated(nodes(t), turn);
                let is_seed = gates.is_empty() && t == seed;
                if is_seed {
                    gates.push_back((a, b));
                }
                gates.push_back((b, c));
                gates.push_back((c, a));
            }
            let Some((a, b)) = gates.pop_front() else { break };
            let mut corner = head.get(&(b, a)).copied().unwrap_or(NONE);
            while corner != NONE && is_done[corner as usize / 3] {
                corner = next[corner as usize];
            }
            if corner != NONE {
                found = Some((corner / 3, (corner % 3) as u8));
            }
        }
    }
    order
}
