//! The triangles of a level while fragments replace them.

use std::collections::HashMap;

use striata::mesh::Face;

/// The triangles of a level. Replaced triangles keep their numbers, which are never used again.
#[derive(Clone, Debug, Default)]
pub(crate) struct LevelFaces {
    all: Vec<Face>,
    /// Numbers of the triangles of the level, in no order.
    present: Vec<u32>,
    /// For each triangle, its place in `present`.
    places: Vec<u32>,
    /// For each directed side, how many triangles have it, and all their numbers combined by exclusive or.
    sides: HashMap<[u32; 2], (u32, u32)>,
}

/// Place of a triangle that is not present.
const ABSENT: u32 = u32::MAX;

impl LevelFaces {
    /// Number of triangles of the level.
    pub(crate) fn len(&self) -> u32 {
        self.present.len() as u32
    }

    /// The triangle in a place below [`len`](Self::len).
    pub(crate) fn in_place(&self, place: u32) -> u32 {
        self.present[place as usize]
    }

    /// The place of a triangle of the level.
    pub(crate) fn place_of(&self, face: u32) -> u32 {
        self.places[face as usize]
    }

    /// A triangle that is or was present.
    pub(crate) fn get(&self, face: u32) -> Face {
        self.all[face as usize]
    }

    /// The only triangle that has a directed side.
    pub(crate) fn with_side(&self, side: [u32; 2]) -> Option<u32> {
        self.sides.get(&side).filter(|(count, _)| *count == 1).map(|&(_, face)| face)
    }

    /// Adds a triangle and returns its number.
    pub(crate) fn push(&mut self, face: Face) -> u32 {
        let number = self.all.len() as u32;
        for side in sides_of(face.corners) {
            let (count, faces) = self.sides.entry(side).or_default();
            (*count, *faces) = (*count + 1, *faces ^ number);
        }
        self.places.push(self.present.len() as u32);
        self.present.push(number);
        self.all.push(face);
        number
    }

    /// Removes a triangle of the level.
    pub(crate) fn remove(&mut self, face: u32) {
        for side in sides_of(self.get(face).corners) {
            if let Some((count, faces)) = self.sides.get_mut(&side) {
                (*count, *faces) = (*count - 1, *faces ^ face);
                if *count == 0 {
                    self.sides.remove(&side);
                }
            }
        }
        let place = std::mem::replace(&mut self.places[face as usize], ABSENT) as usize;
        self.present.swap_remove(place);
        if let Some(&moved) = self.present.get(place) {
            self.places[moved as usize] = place as u32;
        }
    }
}

/// The directed sides of a triangle.
pub(crate) fn sides_of([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
