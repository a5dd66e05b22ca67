//! Read access to the table, fan by fan, for storing it in another layout such as that of a GPU.

use super::Fans;
use super::table::FanView;

/// A fan of the table: triangles around a vertex that form a run, and the steps on which each of them
/// depends.
#[derive(Clone, Copy, Debug)]
pub struct TableFan<'t> {
    pub(super) view: FanView<'t>,
    own_step: Option<u32>,
}

/// A step that creates some arcs of a fan: they are active once the step has been collapsed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArcMaker {
    /// Index of the step.
    pub step: u32,
    /// Bit mask of the arcs; the lowest bit is the first arc.
    pub arcs: u32,
}

impl Fans {
    /// Returns all fans of the table by ascending vertex; the fans of one vertex come in the order in
    /// which they are drawn.
    pub fn table_fans(&self) -> impl Iterator<Item = TableFan<'_>> {
        let base = (0..self.vertices.base_vertex_count).map(|vertex| (vertex, None));
        let steps = 0..self.step_count as u32;
        let above = steps
            .flat_map(|step| self.vertices.of_step(step as usize).map(move |vertex| (vertex, Some(step))));
        base.chain(above).flat_map(|(vertex, own_step)| {
            let entry = self.table.entry(vertex, own_step.map_or(0, |step| step + 1));
            entry.map(move |view| TableFan { view, own_step })
        })
    }
}

impl<'t> TableFan<'t> {
    /// Returns the vertex at the center of the fan.
    pub fn vertex(&self) -> u32 {
        self.view.vertex
    }

    /// Returns the step that removes the vertex together with the fan, or `None` for a base vertex.
    pub fn own_step(&self) -> Option<u32> {
        self.own_step
    }

    /// Returns the group of the fan's triangles.
    pub fn group(&self) -> u32 {
        self.view.group
    }

    /// Returns the vertices around the center in order; arc `n` connects node `n` with the next.
    pub fn nodes(&self) -> impl Iterator<Item = u32> + use<'t> {
        self.view.nodes()
    }

    /// Number of nodes: one more than arcs, or as many as arcs if the fan is closed.
    pub fn node_count(&self) -> usize {
        self.view.node_count
    }

    /// Whether the last arc leads back to the first node.
    pub fn is_closed(&self) -> bool {
        self.view.is_closed
    }

    /// Bit mask of the arcs that are active whenever the vertex is.
    pub fn permanent_arcs(&self) -> u32 {
        self.view.permanent
    }

    /// Returns the steps that create the other arcs.
    pub fn makers(&self) -> impl Iterator<Item = ArcMaker> + use<'t> {
        self.view.creators().map(|creator| ArcMaker { step: creator.step, arcs: creator.mask })
    }
}

#[cfg(test)]
mod tests {
    use super::super::FanInstance;
    use super::*;
    use crate::mesh::shapes;
    use crate::simplify::build_sequence;

    #[test]
    fn table_fans_give_the_triangles_of_any_instance() {
        for mesh in [shapes::icosphere(2, 1.0), shapes::uv_cylinder(9, 4), shapes::two_material_sphere(6, 8)]
        {
            let built = build_sequence(&mesh, &Default::default()).unwrap();
            let fans = Fans::build(&built.refinable);
            for split_count in 0..=fans.step_count {
                let instance = FanInstance::uniform(&fans, split_count);
                let mut found = vec![Vec::new(); fans.group_count()];
                for fan in fans.table_fans() {
                    if fan.own_step().is_some_and(|step| !instance.is_refined(step)) {
                        continue;
                    }
                    let active = fan.makers().filter(|maker| !instance.is_refined(maker.step));
                    let arcs = active.fold(fan.permanent_arcs(), |all, maker| all | maker.arcs);
                    let nodes: Vec<u32> = fan.nodes().collect();
                    assert_eq!(nodes.len(), fan.node_count());
                    let ends = nodes.iter().skip(1).chain(fan.is_closed().then_some(&nodes[0]));
                    for (arc, (&a, &b)) in nodes.iter().zip(ends).enumerate() {
                        if arcs >> arc & 1 != 0 {
                            found[fan.group() as usize].extend([fan.vertex(), a, b]);
                        }
                    }
                }
                let mut expected = Vec::new();
                instance.indices_into(&fans, &mut expected);
                assert_eq!(found.concat(), expected, "{split_count}");
            }
        }
    }
}
