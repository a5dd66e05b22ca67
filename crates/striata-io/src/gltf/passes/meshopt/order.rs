//! Order of triangles and vertices that compresses well and suits the caches of a GPU.
//!
//! Primitives that share vertices are sorted together. Triangles change their order within a primitive;
//! vertices follow in the order of their first use. Whatever cannot be moved safely keeps its order: data
//! with other users, primitives without indices, and those whose extensions may count vertices. Triangles that are
//! blended are drawn over each other in their order, and keep it.

use std::collections::{BTreeMap, BTreeSet};

use meshoptimizer_rs::{Limits, Workspace, optimize_vertex_cache_strip};

use super::roles::{AccessorRole, AccessorUse};
use crate::contacts::Sets;
use crate::gltf::accessor::accessor;
use crate::gltf::document::GltfDocument;
use crate::gltf::passes::extensions::are_free_of_order;
use crate::gltf::passes::primitives::PassPrimitive;

/// New order of everything that may be moved.
#[derive(Debug, Default)]
pub(super) struct MeshoptOrder {
    /// Number of the order of each accessor of vertices.
    number_of: BTreeMap<u64, usize>,
    /// Old vertices in their new order.
    orders: BTreeMap<usize, Vec<u32>>,
    /// Indices in their new order, for the new vertices.
    indices: BTreeMap<u64, Vec<u32>>,
}

impl MeshoptOrder {
    /// Returns the old vertices in their new order; [`None`] if they keep it.
    pub(super) fn vertices(&self, accessor: u64) -> Option<&[u32]> {
        self.number_of.get(&accessor).and_then(|number| self.orders.get(number)).map(Vec::as_slice)
    }

    /// Returns new indices; [`None`] if they are unchanged.
    pub(super) fn indices(&self, accessor: u64) -> Option<&[u32]> {
        self.indices.get(&accessor).map(Vec::as_slice)
    }
}

pub(super) type Roles = BTreeMap<u64, Option<AccessorRole>>;

/// Returns a workspace without limits; what is sorted and compressed is in memory already.
pub(super) fn workspace() -> Workspace {
    Workspace::new(Limits { max_bytes: usize::MAX, max_work: u64::MAX })
}

/// Finds a better order of the triangles and vertices of all primitives.
pub(super) fn order(
    document: &GltfDocument<'_>,
    primitives: &[PassPrimitive],
    roles: &Roles,
) -> MeshoptOrder {
    let accessors: BTreeSet<u64> = primitives.iter().flat_map(PassPrimitive::vertex_accessors).collect();
    let accessors: Vec<u64> = accessors.into_iter().collect();
    let place = |accessor: u64| accessors.binary_search(&accessor).unwrap_or_default();
    let mut sets = Sets::new(accessors.len());
    for primitive in primitives {
        let mut own = primitive.vertex_accessors();
        if let Some(first) = own.next() {
            own.for_each(|other| sets.join(place(first), place(other)));
        }
    }
    let number_of: BTreeMap<u64, usize> =
        accessors.iter().map(|&accessor| (accessor, sets.find(place(accessor)))).collect();
    let groups: Vec<Option<usize>> = primitives
        .iter()
        .map(|primitive| primitive.vertex_accessors().next().map(|accessor| number_of[&accessor]))
        .collect();
    let counts = vertex_counts(document, &number_of, roles);
    let (indices, fixed) = sorted_triangles(document, primitives, &groups, &counts, roles);
    let mut order = MeshoptOrder { number_of, orders: BTreeMap::new(), indices };
    order.sort_vertices(primitives, &groups, &counts, &fixed);
    order
}

fn is_free(roles: &Roles, accessor: u64) -> bool {
    roles.get(&accessor).is_some_and(|role| role.as_ref().is_some_and(|role| role.is_free))
}

/// Returns the vertex count of each group whose vertices may be moved.
fn vertex_counts(
    document: &GltfDocument<'_>,
    number_of: &BTreeMap<u64, usize>,
    roles: &Roles,
) -> BTreeMap<usize, usize> {
    let mut counts: BTreeMap<usize, Option<usize>> = BTreeMap::new();
    for (&index, &number) in number_of {
        let source = accessor(document, index, &document.root).ok();
        let own = source.map(|source| source.count).filter(|_| is_free(roles, index));
        counts.entry(number).and_modify(|count| *count = count.filter(|_| *count == own)).or_insert(own);
    }
    counts.into_iter().filter_map(|(number, count)| Some((number, count?))).collect()
}

/// Returns index lists, with sorted triangles where possible, and the groups whose vertices must stay.
fn sorted_triangles(
    document: &GltfDocument<'_>,
    primitives: &[PassPrimitive],
    groups: &[Option<usize>],
    counts: &BTreeMap<usize, usize>,
    roles: &Roles,
) -> (BTreeMap<u64, Vec<u32>>, BTreeSet<usize>) {
    let mut users: BTreeMap<u64, Vec<usize>> = BTreeMap::new();
    let mut fixed = BTreeSet::new();
    for (number, primitive) in primitives.iter().enumerate() {
        match primitive.indices {
            Some(indices) => users.entry(indices).or_default().push(number),
            None => fixed.extend(groups[number]),
        }
    }
    let mut lists = BTreeMap::new();
    for (indices, users) in users {
        let is_movable = is_free(roles, indices)
            && users.iter().all(|&user| are_free_of_order(&primitives[user].extensions));
        let group = groups[users[0]];
        let is_of_one = users.iter().all(|&user| groups[user] == group);
        let count = group.filter(|_| is_of_one && is_movable).and_then(|group| counts.get(&group));
        let list = accessor(document, indices, &document.root).ok().and_then(|source| source.integers());
        match (list, count) {
            (Some(list), Some(&count)) if list.iter().all(|&v| (v as usize) < count) => {
                let is_triangles =
                    roles[&indices].as_ref().is_some_and(|role| role.usage == AccessorUse::Triangles);
                let is_blended = users.iter().any(|&user| primitives[user].is_blended);
                let list = if is_triangles && !is_blended { sorted(list, count) } else { list };
                lists.insert(indices, list);
            }
            _ => fixed.extend(users.iter().filter_map(|&user| groups[user])),
        }
    }
    (lists, fixed)
}

fn sorted(list: Vec<u32>, vertex_count: usize) -> Vec<u32> {
    optimize_vertex_cache_strip(&list, vertex_count, &mut workspace()).unwrap_or(list)
}

impl MeshoptOrder {
    /// Numbers vertices by first use; unused ones come last.
    fn sort_vertices(
        &mut self,
        primitives: &[PassPrimitive],
        groups: &[Option<usize>],
        counts: &BTreeMap<usize, usize>,
        fixed: &BTreeSet<usize>,
    ) {
        const UNSEEN: u32 = u32::MAX;
        let mut new_numbers: BTreeMap<usize, (Vec<u32>, u32)> = BTreeMap::new();
        let mut renumbered = BTreeSet::new();
        for (primitive, group) in primitives.iter().zip(groups) {
            let Some(group) = group.filter(|group| !fixed.contains(group)) else { continue };
            let (Some(&count), Some(indices)) = (counts.get(&group), primitive.indices) else { continue };
            if !renumbered.insert(indices) {
                continue;
            }
            let (numbers, next) = new_numbers.entry(group).or_insert_with(|| (vec![UNSEEN; count], 0));
            for vertex in self.indices.get_mut(&indices).into_iter().flatten() {
                let number = &mut numbers[*vertex as usize];
                if *number == UNSEEN {
                    *number = *next;
                    *next += 1;
                }
                *vertex = *number;
            }
        }
        for (group, (numbers, used)) in new_numbers {
            let mut order = vec![0; numbers.len()];
            let mut next = used;
            for (old, number) in numbers.into_iter().enumerate() {
                let is_unseen = number == UNSEEN;
                order[if is_unseen { next } else { number } as usize] = old as u32;
                next += u32::from(is_unseen);
            }
            self.orders.insert(group, order);
        }
    }
}
