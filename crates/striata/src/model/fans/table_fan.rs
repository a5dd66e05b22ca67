//! The table as others may read it, fan by fan: to store it in another way, as a GPU wants it, say.

use super::Fans;
use super::table::FanView;

/// A fan of the table: all triangles that a vertex may show in one run around it, and what has to be so that each shows.
#[derive(Clone, Copy, Debug)]
pub struct TableFan<'t> {
    view: FanView<'t>,
    own_step: Option<u32>,
}

/// A step that makes some arcs of a fan: they are there once it has been taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArcMaker {
    /// The step.
    pub step: u32,
    /// Its arcs, a bit each, the first arc the lowest.
    pub arcs: u32,
}

impl Fans {
    /// All fans of the table, by rising vertices; those of one vertex in the order in which they are drawn.
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
    /// The vertex that it is around.
    pub fn vertex(&self) -> u32 {
        self.view.vertex
    }

    /// The step that takes the vertex away, and all of the fan with it; none takes one of the base.
    pub fn own_step(&self) -> Option<u32> {
        self.own_step
    }

    /// The group of its triangles.
    pub fn group(&self) -> u32 {
        self.view.group
    }

    /// The vertices around, in their order: the n-th arc is between the n-th and the next.
    pub fn nodes(&self) -> impl Iterator<Item = u32> + use<'t> {
        self.view.nodes()
    }

    /// How many there are: one more than arcs, or as many where it is closed.
    pub fn node_count(&self) -> usize {
        self.view.node_count
    }

    /// Whether the last arc leads back to the first node.
    pub fn is_closed(&self) -> bool {
        self.view.is_closed
    }

    /// Arcs that are there as long as the vertex is, a bit each.
    pub fn lasting_arcs(&self) -> u32 {
        self.view.always
    }

    /// The steps that make the other arcs.
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
    fn the_fans_of_the_table_tell_all_that_an_instance_shows() {
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
                    let made = fan.makers().filter(|maker| !instance.is_refined(maker.step));
                    let arcs = made.fold(fan.lasting_arcs(), |all, maker| all | maker.arcs);
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
