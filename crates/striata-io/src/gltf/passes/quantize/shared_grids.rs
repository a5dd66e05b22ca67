//! One grid for meshes that touch, so that their borders still meet after rounding.
//!
//! Grids have the same step, a power of two, and origins that are multiples of it in the space of the scene, so
//! that a point of two meshes is rounded to the same point. That is possible for meshes whose transforms differ
//! only by a move.

use std::collections::BTreeMap;

use glam::DVec3;

use super::grid::{Box3, Grids, MeshGrid, bounding_box, positions_of};
use crate::contacts::{Contacts, Sets, Spot};
use crate::gltf::document::GltfDocument;
use crate::gltf::node_tree::placed_nodes;
use crate::gltf::passes::extensions::are_free_of_values;
use crate::gltf::passes::parts::index_at;
use crate::gltf::passes::primitives::PassPrimitive;
use crate::{GridScope, QuantizeOptions};

/// Largest number of grid steps along a side.
const MOST_STEPS: f64 = 65534.0;

/// How much coarser than its own a grid of a mesh may be that touches others: a gap is worse than one bit less.
const COARSER: f64 = 2.001;

/// A set of meshes with a grid of its own so far.
struct Member {
    set: usize,
    offset: DVec3,
    bounds: Box3,
    step: f64,
}

/// Finds meshes that share positions, and a grid for each set of them.
pub(in crate::gltf::passes) fn grids(
    document: &GltfDocument<'_>,
    primitives: &[PassPrimitive],
    are_read: &[bool],
    options: &QuantizeOptions,
) -> Grids {
    let mut sets = Sets::new(are_read.len());
    let mut owners = BTreeMap::new();
    for primitive in primitives {
        let targets = primitive.targets.iter().flatten();
        let positions = primitive.attributes.iter().chain(targets).filter(|(name, _)| name == "POSITION");
        for &(_, accessor) in positions {
            let &mut owner = owners.entry(accessor).or_insert(primitive.mesh);
            sets.join(owner, primitive.mesh);
        }
    }
    let of_mesh: Vec<usize> = (0..are_read.len()).map(|mesh| sets.find(mesh)).collect();
    let mut boxes: Vec<Option<Box3>> = are_read.iter().map(|_| Some(Box3::EMPTY)).collect();
    for (mesh, _) in are_read.iter().enumerate().filter(|&(_, is_read)| !is_read) {
        boxes[of_mesh[mesh]] = None;
    }
    let mut known = BTreeMap::new();
    for primitive in primitives {
        let set = of_mesh[primitive.mesh];
        let of_primitive =
            primitive.attribute("POSITION").filter(|_| are_free_of_values(&primitive.extensions));
        let of_primitive = of_primitive
            .and_then(|accessor| *known.entry(accessor).or_insert_with(|| bounding_box(document, accessor)));
        boxes[set] = boxes[set].zip(of_primitive).map(|(a, b)| a.joined(b));
    }
    if let Some(exponent) = options.step_log2 {
        let grid = |bounds: &Option<Box3>| {
            Member { set: 0, offset: DVec3::ZERO, bounds: (*bounds)?, step: 0.0 }.grid(2f64.powi(exponent))
        };
        return Grids { grids: boxes.iter().map(grid).collect(), of_mesh };
    }
    let mut grids: Vec<Option<MeshGrid>> =
        boxes.iter().map(|bounds| bounds.as_ref()?.grid(options.position_bits)).collect();
    MeshSets { document, primitives, of_mesh: &of_mesh }.share(&mut grids, &boxes, options.grid);
    Grids { grids, of_mesh }
}

/// Meshes in sets that share positions.
struct MeshSets<'a> {
    document: &'a GltfDocument<'a>,
    primitives: &'a [PassPrimitive],
    /// The set of each mesh.
    of_mesh: &'a [usize],
}

impl MeshSets<'_> {
    /// Replaces the grids of sets of meshes that touch, or of all that can share one, given the grid and the box of
    /// each set.
    fn share(&self, grids: &mut [Option<MeshGrid>], boxes: &[Option<Box3>], scope: GridScope) {
        if scope == GridScope::Mesh {
            return;
        }
        let mut spaces: BTreeMap<[u64; 9], Vec<Member>> = BTreeMap::new();
        for (set, spot) in self.spots() {
            let (Some(grid), Some(bounds)) = (grids[set], boxes[set]) else { continue };
            let member = Member { set, offset: spot.offset, bounds, step: f64::from(grid.step) };
            spaces.entry(spot.space).or_default().push(member);
        }
        for members in spaces.into_values().filter(|members| members.len() > 1) {
            let groups = match scope {
                GridScope::Scene => vec![members],
                _ => self.touching(members),
            };
            for group in groups {
                for (set, grid) in shared_grids(&group, scope) {
                    grids[set] = Some(grid);
                }
            }
        }
    }

    /// Returns the spot of each set of meshes that one node shows, or several with the same transform.
    fn spots(&self) -> BTreeMap<usize, Spot> {
        let mut found: BTreeMap<usize, Option<Spot>> = BTreeMap::new();
        for placed in placed_nodes(&self.document.root).unwrap_or_default() {
            let mesh = index_at(placed.node.value, "mesh");
            let Some(&set) = mesh.and_then(|mesh| self.of_mesh.get(mesh)) else { continue };
            let is_plain = placed.node.value.get("skin").is_none() && placed.node.get("extensions").is_none();
            let own = Spot::new(placed.matrix).filter(|_| is_plain);
            found
                .entry(set)
                .and_modify(|known| *known = known.filter(|known| Some(*known) == own))
                .or_insert(own);
        }
        found.into_iter().filter_map(|(set, spot)| Some((set, spot?))).collect()
    }

    /// Divides sets of meshes into groups that are connected by common vertices.
    fn touching(&self, members: Vec<Member>) -> Vec<Vec<Member>> {
        let number_of: BTreeMap<usize, usize> = members.iter().enumerate().map(|(i, m)| (m.set, i)).collect();
        let finest = members.iter().map(|member| member.step).fold(f64::INFINITY, f64::min);
        let mut contacts = Contacts::new(members.len(), 0.25 * finest);
        for primitive in self.primitives {
            let Some(&number) = number_of.get(&self.of_mesh[primitive.mesh]) else { continue };
            let Some(accessor) = primitive.attribute("POSITION") else { continue };
            let numbers = positions_of(self.document, accessor).unwrap_or_default();
            contacts.add(number, members[number].offset, numbers.as_chunks().0);
        }
        let mut members: Vec<_> = members.into_iter().map(Some).collect();
        let mut taken =
            |group: Vec<usize>| group.into_iter().filter_map(|number| members[number].take()).collect();
        contacts.groups().into_iter().map(&mut taken).collect()
    }
}

/// Returns grids with a common step: that of the finest member, unless another one is too large for it.
/// Members that would become coarser keep their own grids.
fn shared_grids(group: &[Member], scope: GridScope) -> Vec<(usize, MeshGrid)> {
    let mut sides: Vec<&Member> = group.iter().collect();
    // A mesh much larger than its neighbors keeps its own, coarser grid.
    loop {
        let finest = sides.iter().map(|member| member.step).fold(f64::INFINITY, f64::min);
        let mut step = power_of_two(finest);
        let largest = sides.iter().map(|member| member.bounds.side()).fold(0.0, f64::max);
        while largest / step > MOST_STEPS {
            step *= 2.0;
        }
        let is_coarser = |member: &&&Member| step > COARSER * member.step;
        if scope == GridScope::Scene || !sides.iter().any(|member| is_coarser(&member)) {
            return sides.iter().filter_map(|member| Some((member.set, member.grid(step)?))).collect();
        }
        // Leave out the largest member and try again.
        let Some(place) = sides.iter().position(|member| member.bounds.side() == largest) else {
            return Vec::new();
        };
        sides.remove(place);
        if sides.len() < 2 {
            return Vec::new();
        }
    }
}

/// Largest power of two up to a positive number.
fn power_of_two(number: f64) -> f64 {
    f64::from_bits(number.to_bits() & 0x7ff0_0000_0000_0000)
}

impl Member {
    fn grid(&self, step: f64) -> Option<MeshGrid> {
        let [min, max] =
            [self.bounds.min, self.bounds.max].map(|corner| DVec3::from_array(corner.map(f64::from)));
        let first = ((min + self.offset) / step).floor();
        let last = (((max + self.offset) / step).ceil() - first).max_element();
        let (origin, step) = (first * step - self.offset, step as f32);
        let is_fit = last <= 65535.0 && origin.is_finite() && step >= f32::MIN_POSITIVE;
        is_fit.then(|| MeshGrid {
            origin: origin.to_array(),
            step,
            last: last.max(1.0) as u32,
            is_shared: true,
        })
    }
}
