//! Meshes that touch: they have vertices in common where the scene shows them.

use std::collections::{BTreeMap, HashMap};

use glam::{DMat3, DMat4, DVec3};
use striata::mesh::IndexedMesh;

use crate::Scene;

/// Transform with which a scene shows a mesh, split into a linear part and a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// Bits of the transform without its move: the same for all meshes of a space.
    pub space: [u64; 9],
    /// Move of the mesh before that, in its own units.
    pub offset: DVec3,
}

impl Spot {
    /// Returns [`None`] for a transform without an inverse.
    pub(crate) fn new(matrix: DMat4) -> Option<Self> {
        let linear = DMat3::from_mat4(matrix);
        let offset = linear.inverse() * matrix.w_axis.truncate();
        // Both zeros are the same number.
        let space = linear.to_cols_array().map(|number| (number + 0.0).to_bits());
        offset.is_finite().then_some(Self { space, offset })
    }
}

/// Disjoint sets of numbers.
#[derive(Debug)]
pub(crate) struct Sets(Vec<usize>);

impl Sets {
    /// Creates one set for each number.
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// Returns the smallest number of a set.
    pub(crate) fn find(&mut self, mut member: usize) -> usize {
        while self.0[member] != member {
            self.0[member] = self.0[self.0[member]];
            member = self.0[member];
        }
        member
    }

    /// Joins two sets.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b)] = a.min(b);
    }
}

/// Meshes of a space that are connected by common points.
pub(crate) struct Contacts {
    sets: Sets,
    /// First mesh with a point in each cell.
    first_in: HashMap<[i64; 3], usize>,
    cell: f64,
}

impl Contacts {
    /// Points in one cell of a lattice count as equal: coordinates that nodes move differ by rounding.
    pub(crate) fn new(mesh_count: usize, cell: f64) -> Self {
        Self { sets: Sets::new(mesh_count), first_in: HashMap::new(), cell }
    }

    pub(crate) fn add(&mut self, mesh: usize, offset: DVec3, points: &[[f32; 3]]) {
        for point in points {
            let point = (DVec3::from_array(point.map(f64::from)) + offset) / self.cell;
            let key = point.round().to_array().map(|x| x as i64);
            self.sets.join(*self.first_in.entry(key).or_insert(mesh), mesh);
        }
    }

    /// Returns groups of two or more.
    pub(crate) fn groups(mut self) -> Vec<Vec<usize>> {
        let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for mesh in 0..self.sets.0.len() {
            groups.entry(self.sets.find(mesh)).or_default().push(mesh);
        }
        groups.into_values().filter(|group| group.len() > 1).collect()
    }
}

impl Scene {
    /// Returns the meshes that have vertices in common, in groups: the number of each mesh, and its move in the
    /// space of the group, in mesh units.
    ///
    /// `meshes` has those of the scene, which may have been moved elsewhere. Vertices count as equal if they are closer than about `cell`, in mesh units. Only meshes that are shown once,
    /// without a skin, and that the same transform takes from the space to the scene are compared.
    pub fn touching_meshes(&self, meshes: &[Option<&IndexedMesh>], cell: f64) -> Vec<Vec<(usize, [f64; 3])>> {
        let mut spots: BTreeMap<usize, Option<Spot>> = BTreeMap::new();
        for instance in self.instances() {
            let spot = Spot::new(DMat4::from_cols_array(&instance.transform));
            let spot = spot.filter(|_| instance.skin.is_none());
            spots.entry(instance.mesh).and_modify(|known| *known = None).or_insert(spot);
        }
        let mut spaces: BTreeMap<[u64; 9], Vec<(usize, DVec3, &IndexedMesh)>> = BTreeMap::new();
        for (number, spot) in spots {
            let Some((spot, mesh)) = spot.zip(meshes.get(number).copied().flatten()) else { continue };
            spaces.entry(spot.space).or_default().push((number, spot.offset, mesh));
        }
        let mut found = Vec::new();
        for meshes in spaces.into_values().filter(|meshes| meshes.len() > 1) {
            let mut contacts = Contacts::new(meshes.len(), cell);
            for (place, (_, offset, mesh)) in meshes.iter().enumerate() {
                contacts.add(place, *offset, &mesh.positions);
            }
            let groups = contacts.groups().into_iter();
            let with_offset = |place: usize| (meshes[place].0, meshes[place].1.to_array());
            found.extend(groups.map(|group| group.into_iter().map(with_offset).collect::<Vec<_>>()));
        }
        found
    }
}
