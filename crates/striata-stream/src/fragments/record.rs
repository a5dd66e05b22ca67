//! Codes fragments one after another; writer and reader run the same code.

use std::collections::HashMap;

use striata::mesh::Face;

use super::faces::{LevelFaces, sides_of};
use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Part, Rate, code_uniform};

/// Most vertices that a step restores.
const MOST_OWN: u32 = 1 << 16;

/// A fragment as both sides know it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct CodedFragment {
    /// Number of vertices that the step restores; they follow those of the level.
    pub own_count: u32,
    /// Numbers of the triangles that it replaces.
    pub floor: Vec<u32>,
    /// The triangles that it creates.
    pub ceiling: Vec<Face>,
}

/// Why bits are no fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoFragment;

/// Models of fragments, and the level that they refine.
#[derive(Clone, Debug)]
pub(crate) struct FragmentCoder {
    pub faces: LevelFaces,
    marks: FloorMarks,
    /// How many triangles floors and ceilings may still have: a bound for the work that few bytes can ask for.
    triangles_left: u64,
    vertex_count: u32,
    group_count: u32,
    own_count: AdaptiveNumber,
    has_more_floor: [AdaptiveBit; 2],
    /// By the number of triangles that the floor has so far, and by the number of sides that wait.
    continues: [[AdaptiveBit; 8]; 9],
    is_listed: AdaptiveBit,
    /// Whether a side of the border gets no triangle: by whether there is a triangle across, and whether the side before
    /// got one.
    is_bare: [[AdaptiveBit; 2]; 2],
    is_same_vertex: AdaptiveBit,
    /// Whether triangles join restored vertices where the border passes from one to the next.
    has_bridges: AdaptiveBit,
    is_same_group: AdaptiveBit,
    listed_count: AdaptiveNumber,
    is_elsewhere: AdaptiveBit,
}

/// A directed side of the border of a floor, and the group of the triangle inside.
#[derive(Clone, Copy, Debug)]
struct BorderSide {
    side: [u32; 2],
    group: u32,
    has_neighbor: bool,
}

impl FragmentCoder {
    /// Starts at a base mesh with this number of vertices and, if there are several, groups.
    pub(crate) fn new(base: impl IntoIterator<Item = Face>, vertex_count: u32, group_count: u32) -> Self {
        let mut faces = LevelFaces::default();
        for face in base {
            faces.push(face);
        }
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            triangles_left: 0,
            marks: FloorMarks::default(),
            faces,
            vertex_count,
            group_count: group_count.max(1),
            own_count: AdaptiveNumber::new(1, Rate::Steady),
            has_more_floor: [bit; 2],
            continues: [[bit; 8]; 9],
            is_listed: bit,
            is_bare: [[bit; 2]; 2],
            is_same_vertex: bit,
            has_bridges: bit,
            is_same_group: bit,
            listed_count: AdaptiveNumber::new(1, Rate::Steady),
            is_elsewhere: bit,
        }
    }

    /// Allows floors and ceilings this many triangles in all, besides 4096.
    pub(crate) fn with_triangle_limit(mut self, triangles: u64) -> Self {
        self.triangles_left = triangles.saturating_add(4096);
        self
    }

    /// Codes the next fragment, which [`apply`](Self::apply) then applies. A reader passes a default fragment.
    ///
    /// # Errors
    /// If the bits are no fragment of the level.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        actual: &CodedFragment,
    ) -> Result<CodedFragment, NoFragment> {
        coder.part(Part::Connectivity);
        let own_count = self.own_count.unsigned(coder, 0, actual.own_count.wrapping_sub(1)).wrapping_add(1);
        if own_count == 0 || own_count > MOST_OWN || own_count > u32::MAX - self.vertex_count {
            return Err(NoFragment);
        }
        let floor = self.code_floor(coder, &actual.floor)?;
        let border = self.border_of(&floor);
        let owns: Vec<u32> = (self.vertex_count..self.vertex_count + own_count).collect();
        let star = if C::READS { None } else { star_of(&border, &owns, &actual.ceiling) };
        let ceiling = if self.is_listed.code(coder, star.is_none()) {
            self.code_list(coder, &border, &owns, &actual.ceiling)?
        } else {
            self.code_star(coder, &border, &owns, star.unwrap_or_default())
        };
        Ok(CodedFragment { own_count, floor, ceiling })
    }

    /// Replaces triangles of the level as a fragment says that was coded last.
    pub(crate) fn apply(&mut self, fragment: &CodedFragment) {
        fragment.floor.iter().for_each(|&face| self.faces.remove(face));
        for &face in &fragment.ceiling {
            self.faces.push(face);
        }
        self.vertex_count += fragment.own_count;
        let triangles = (fragment.floor.len() + fragment.ceiling.len()) as u64;
        self.triangles_left = self.triangles_left.saturating_sub(triangles);
    }

    /// Codes which triangles a fragment replaces: connected parts, each from one of its triangles on.
    fn code_floor<C: Coder>(&mut self, coder: &mut C, actual: &[u32]) -> Result<Vec<u32>, NoFragment> {
        let mut floor: Vec<u32> = Vec::new();
        self.marks.begin(actual);
        let mut left = actual.iter();
        loop {
            let next = left.find(|&&face| !self.marks.is_found(face)).copied();
            let has_more = self.has_more_floor[usize::from(!floor.is_empty())].code(coder, next.is_some());
            if !has_more {
                return Ok(floor);
            }
            if self.faces.len() == 0 {
                return Err(NoFragment);
            }
            let place = next.map_or(0, |face| self.faces.place_of(face));
            let first = self.faces.in_place(code_uniform(coder, self.faces.len(), place));
            if self.marks.is_found(first) {
                return Err(NoFragment);
            }
            self.marks.find(first);
            floor.push(first);
            let mut waiting: Vec<[u32; 2]> = sides_of(self.faces.get(first).corners).to_vec();
            let mut next = 0;
            while let Some(&[a, b]) = waiting.get(next) {
                next += 1;
                let across = self.faces.with_side([b, a]).filter(|&face| !self.marks.is_found(face));
                let Some(across) = across else { continue };
                let known = floor.len().min(8);
                let more = (waiting.len() - next).min(7);
                if !self.continues[known][more].code(coder, self.marks.is_wanted(across)) {
                    continue;
                }
                if floor.len() as u64 >= self.triangles_left {
                    return Err(NoFragment);
                }
                self.marks.find(across);
                floor.push(across);
                let sides = sides_of(self.faces.get(across).corners).into_iter();
                waiting.extend(sides.filter(|&side| side != [b, a]));
            }
        }
    }

    /// The sides of a floor that no other triangle of it has, in the order of its triangles.
    fn border_of(&self, floor: &[u32]) -> Vec<BorderSide> {
        let mut inner: Vec<[u32; 2]> =
            floor.iter().flat_map(|&face| sides_of(self.faces.get(face).corners)).collect();
        inner.sort_unstable();
        let mut border: Vec<BorderSide> = Vec::new();
        for &face in floor {
            let Face { corners, group } = self.faces.get(face);
            for side @ [a, b] in sides_of(corners) {
                if inner.binary_search(&[b, a]).is_err() {
                    border.push(BorderSide {
                        side,
                        group,
                        has_neighbor: self.faces.with_side([b, a]).is_some(),
                    });
                }
            }
        }
        chained(border)
    }

    /// Codes a ceiling in which sides of the border get a triangle with a restored vertex; `actual` has the triangle of
    /// each side, if there is one.
    fn code_star<C: Coder>(
        &mut self,
        coder: &mut C,
        border: &[BorderSide],
        owns: &[u32],
        actual: CeilingStar,
    ) -> Vec<Face> {
        let mut star = Vec::with_capacity(border.len());
        let (mut was_bare, mut last) = (false, owns[0]);
        for (number, side) in border.iter().enumerate() {
            let known = actual.sides.get(number).copied().flatten();
            let contexts = &mut self.is_bare[usize::from(side.has_neighbor)];
            was_bare = contexts[usize::from(was_bare)].code(coder, known.is_none());
            if was_bare {
                star.push(None);
                continue;
            }
            let [a, b] = side.side;
            let wanted = known.and_then(|face| face.corners.into_iter().find(|&v| v >= owns[0]));
            if owns.len() > 1 && !self.is_same_vertex.code(coder, wanted == Some(last)) {
                let index = wanted.map_or(0, |v| v - owns[0]);
                last = owns[0] + code_uniform(coder, owns.len() as u32, index);
            }
            let group = self.code_group(coder, side.group, known.map(|face| face.group));
            star.push(Some(Face { corners: [a, b, last], group }));
        }
        let has_bridges = owns.len() > 1 && self.has_bridges.code(coder, actual.has_bridges);
        let bridges = if has_bridges { bridges_of(&star) } else { Vec::new() };
        star.into_iter().flatten().chain(bridges).collect()
    }

    /// Codes a ceiling corner by corner.
    fn code_list<C: Coder>(
        &mut self,
        coder: &mut C,
        border: &[BorderSide],
        owns: &[u32],
        actual: &[Face],
    ) -> Result<Vec<Face>, NoFragment> {
        let count = self.listed_count.unsigned(coder, 0, actual.len() as u32) as usize;
        if count as u64 > self.triangles_left {
            return Err(NoFragment);
        }
        let mut known = KnownVertices::default();
        owns.iter().copied().chain(border.iter().map(|side| side.side[0])).for_each(|v| known.add(v));
        let mut ceiling = Vec::new();
        for number in 0..count {
            let face = actual.get(number).copied();
            let mut corners = [0; 3];
            for (k, corner) in corners.iter_mut().enumerate() {
                let wanted = face.map(|face| face.corners[k]);
                let place = wanted.and_then(|v| known.place_of.get(&v).copied());
                if self.is_elsewhere.code(coder, place.is_none()) {
                    if self.vertex_count == 0 {
                        return Err(NoFragment);
                    }
                    *corner = code_uniform(coder, self.vertex_count, wanted.unwrap_or(0));
                    known.add(*corner);
                } else {
                    let place = code_uniform(coder, known.all.len() as u32, place.unwrap_or(0));
                    *corner = known.all[place as usize];
                }
            }
            let [a, b, c] = corners;
            if a == b || b == c || c == a || a.max(b).max(c) < owns[0] || coder.overran() {
                return Err(NoFragment);
            }
            let near = border.first().map_or(0, |side| side.group);
            ceiling.push(Face { corners, group: self.code_group(coder, near, face.map(|face| face.group)) });
        }
        Ok(ceiling)
    }

    fn code_group<C: Coder>(&mut self, coder: &mut C, near: u32, actual: Option<u32>) -> u32 {
        if self.group_count == 1 || self.is_same_group.code(coder, actual == Some(near)) {
            return near;
        }
        code_uniform(coder, self.group_count, actual.unwrap_or(0))
    }
}

/// The vertices that a list of triangles can name by their places.
#[derive(Clone, Debug, Default)]
struct KnownVertices {
    all: Vec<u32>,
    place_of: HashMap<u32, u32>,
}

impl KnownVertices {
    /// Adds a vertex, unless it is there.
    fn add(&mut self, vertex: u32) {
        let next = self.all.len() as u32;
        if *self.place_of.entry(vertex).or_insert(next) == next {
            self.all.push(vertex);
        }
    }
}

/// Marks of triangles for the floor of one fragment after another.
#[derive(Clone, Debug, Default)]
struct FloorMarks {
    fragment: u32,
    /// For each triangle, the last fragment that wants it in its floor, and the last one that it was found for.
    of_faces: Vec<[u32; 2]>,
}

impl FloorMarks {
    fn begin(&mut self, wanted: &[u32]) {
        self.fragment += 1;
        wanted.iter().for_each(|&face| self.slot(face)[0] = self.fragment);
    }

    fn slot(&mut self, face: u32) -> &mut [u32; 2] {
        if self.of_faces.len() <= face as usize {
            self.of_faces.resize(face as usize + 1, [0; 2]);
        }
        &mut self.of_faces[face as usize]
    }

    fn find(&mut self, face: u32) {
        let fragment = self.fragment;
        self.slot(face)[1] = fragment;
    }

    fn is_wanted(&self, face: u32) -> bool {
        self.of_faces.get(face as usize).is_some_and(|marks| marks[0] == self.fragment)
    }

    fn is_found(&self, face: u32) -> bool {
        self.of_faces.get(face as usize).is_some_and(|marks| marks[1] == self.fragment)
    }
}

/// Orders sides so that each begins where the one before ends, as far as possible, and otherwise as they are.
fn chained(sides: Vec<BorderSide>) -> Vec<BorderSide> {
    let mut from: HashMap<u32, Vec<usize>> = HashMap::new();
    for (at, side) in sides.iter().enumerate().rev() {
        from.entry(side.side[0]).or_default().push(at);
    }
    let mut is_out = vec![false; sides.len()];
    let mut out: Vec<BorderSide> = Vec::with_capacity(sides.len());
    for first in 0..sides.len() {
        let mut next = (!is_out[first]).then_some(first);
        while let Some(at) = next {
            is_out[at] = true;
            out.push(sides[at]);
            let after = from.get_mut(&sides[at].side[1]);
            next = after.and_then(|places| {
                while places.last().is_some_and(|&place| is_out[place]) {
                    places.pop();
                }
                places.pop()
            });
        }
    }
    out
}

/// A ceiling whose triangles follow from the border.
#[derive(Clone, Debug, Default)]
struct CeilingStar {
    /// For each side of the border, its triangle with a restored vertex as the last corner, if there is one.
    sides: Vec<Option<Face>>,
    has_bridges: bool,
}

/// Returns a ceiling as a star, if it is one.
fn star_of(border: &[BorderSide], owns: &[u32], ceiling: &[Face]) -> Option<CeilingStar> {
    let mut with_side: HashMap<[u32; 2], Vec<usize>> = HashMap::new();
    for (at, face) in ceiling.iter().enumerate() {
        sides_of(face.corners).into_iter().for_each(|side| with_side.entry(side).or_default().push(at));
    }
    let mut is_left = vec![true; ceiling.len()];
    let mut sides = Vec::with_capacity(border.len());
    for &BorderSide { side, .. } in border {
        let third =
            |at: usize| ceiling[at].corners.into_iter().find(|v| !side.contains(v)).filter(|&v| v >= owns[0]);
        let places = with_side.get(&side).map_or(&[][..], Vec::as_slice);
        let found = places.iter().find_map(|&at| Some((at, third(at).filter(|_| is_left[at])?)));
        sides.push(found.map(|(at, third)| {
            is_left[at] = false;
            Face { corners: [side[0], side[1], third], group: ceiling[at].group }
        }));
    }
    let left: Vec<Face> =
        ceiling.iter().zip(&is_left).filter(|(_, is_left)| **is_left).map(|(face, _)| *face).collect();
    let has_bridges = !left.is_empty();
    if has_bridges {
        let mut bridges = bridges_of(&sides);
        let is_bridge = |face: &Face| {
            let equal = |bridge: &Face| {
                bridge.group == face.group && rotations(face.corners).contains(&bridge.corners)
            };
            bridges.iter().position(equal).map(|at| bridges.swap_remove(at)).is_some()
        };
        if !left.iter().all(is_bridge) || !bridges.is_empty() {
            return None;
        }
    }
    Some(CeilingStar { sides, has_bridges })
}

/// Returns the triangles that join the restored vertices of a star: one wherever the border passes from one vertex to
/// another, and the triangle of three vertices that it passes in turn.
fn bridges_of(sides: &[Option<Face>]) -> Vec<Face> {
    let mut bridges = Vec::new();
    let mut passed = Vec::new();
    for (at, side) in sides.iter().enumerate() {
        let (Some(face), Some(next)) = (side, sides[(at + 1) % sides.len()]) else { continue };
        let ([_, end, from], [start, _, to]) = (face.corners, next.corners);
        if end == start && from != to {
            bridges.push(Face { corners: [from, end, to], group: face.group });
            passed.push(from);
        }
    }
    if let &[a, b, c] = &passed[..] {
        bridges.push(Face { corners: [a, b, c], group: bridges[0].group });
    }
    bridges
}

fn rotations([a, b, c]: [u32; 3]) -> [[u32; 3]; 3] {
    [[a, b, c], [b, c, a], [c, a, b]]
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use striata::mesh::{
        FragmentSequence, FragmentedMesh, IndexedMesh, canonical_triangles, replay_fragments, shapes,
    };
    use striata::simplify::{PlacedOptions, RemovalOptions, build_fragments, build_placed_fragments};
    use striata_testing::meshes;

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};

    /// Encodes all fragments; returns the bytes.
    fn encoded(fragmented: &FragmentedMesh) -> Vec<u8> {
        let fragments = &fragmented.fragments;
        let mut coder = new_coder(fragmented);
        // Number of each face of the sequence for the coder, which creates ceilings in an order of its own.
        let mut number_of: HashMap<[u32; 4], Vec<u32>> = HashMap::new();
        for (number, face) in base_of(fragments).zip(0..).map(|(face, number)| (number, face)) {
            number_of.entry(key(face)).or_default().push(number);
        }
        let mut writer = RangeWriter::new();
        let mut next = fragments.base_face_count() as u32;
        for step in 0..fragments.step_count() as u32 {
            let face = |face: u32| fragments.faces()[face as usize];
            let number = |at: &u32| {
                number_of.get_mut(&key(face(*at))).and_then(Vec::pop).expect("a face of the level")
            };
            let actual = CodedFragment {
                own_count: fragments.levels().step_vertices(step as usize).len() as u32,
                floor: fragments.floor(step).iter().map(number).collect(),
                ceiling: fragments.ceiling(step).map(face).collect(),
            };
            let coded = coder.code(&mut writer, &actual).expect("a fragment");
            coder.apply(&coded);
            for &created in &coded.ceiling {
                number_of.entry(key(created)).or_default().push(next);
                next += 1;
            }
        }
        writer.finish().0
    }

    fn key(face: Face) -> [u32; 4] {
        let [a, b, c] = canonical_triangles(&[face.corners])[0];
        [a, b, c, face.group]
    }

    fn base_of(fragments: &FragmentSequence) -> impl Iterator<Item = Face> {
        fragments.faces()[..fragments.base_face_count()].iter().copied()
    }

    fn new_coder(fragmented: &FragmentedMesh) -> FragmentCoder {
        let fragments = &fragmented.fragments;
        let vertex_count = fragments.levels().vertex_count_at(0) as u32;
        let triangles = fragments.faces().len() as u64;
        FragmentCoder::new(base_of(fragments), vertex_count, fragmented.mesh.groups.len() as u32)
            .with_triangle_limit(2 * triangles)
    }

    fn check(name: &str, fragmented: &FragmentedMesh) -> f64 {
        let bytes = encoded(fragmented);
        let mut coder = new_coder(fragmented);
        let mut reader = RangeReader::new(&bytes, true);
        let steps = fragmented.fragments.step_count();
        for step in 0..steps {
            let fragment = coder.code(&mut reader, &CodedFragment::default()).expect("a fragment");
            coder.apply(&fragment);
            if steps < 300 || step % 97 == 0 || step + 1 == steps {
                let shown: Vec<[u32; 3]> = (0..coder.faces.len())
                    .map(|at| coder.faces.get(coder.faces.in_place(at)).corners)
                    .collect();
                let expected = replay_fragments(fragmented, step + 1);
                assert_eq!(
                    canonical_triangles(&shown),
                    canonical_triangles(&expected.triangles),
                    "{name}, step {step}"
                );
            }
        }
        8.0 * bytes.len() as f64 / steps.max(1) as f64
    }

    fn removals(mesh: &IndexedMesh) -> FragmentedMesh {
        build_fragments(mesh, &RemovalOptions::default()).expect("a sound mesh").fragmented
    }

    #[test]
    fn removals_come_back_in_fewer_bits_than_published() {
        for (name, mesh) in [
            ("sphere", shapes::icosphere(4, 1.0)),
            ("torus", shapes::torus(48, 32, 1.0, 0.4)),
            ("terrain", shapes::terrain(40, 3)),
        ] {
            let bits = check(name, &removals(&mesh));
            eprintln!("{name}: {bits:.1} bits a fragment");
            assert!(bits < 30.0, "{name}: {bits} bits, 44 are published");
        }
    }

    #[test]
    fn seams_groups_and_nasty_meshes_come_back() {
        check("two materials", &removals(&shapes::two_material_sphere(12, 16)));
        for (name, mesh) in meshes::nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok()) {
            if let Ok(built) = build_fragments(&mesh, &RemovalOptions::default()) {
                check(name, &built.fragmented);
            }
        }
    }

    #[test]
    fn new_vertices_come_back() {
        for mesh in [shapes::icosphere(2, 1.0), shapes::terrain(12, 3)] {
            let built = build_placed_fragments(&mesh, &PlacedOptions::default()).expect("a sound mesh");
            let bits = check("placed", &built.fragmented);
            eprintln!("new vertices: {bits:.1} bits a fragment");
            assert!(bits < 40.0, "{bits} bits; the rules of new vertices take 331 in memory");
        }
    }

    #[test]
    fn any_bits_are_fragments_or_an_error() {
        let fragmented = removals(&shapes::torus(12, 8, 1.0, 0.4));
        let bytes = encoded(&fragmented);
        for at in 0..bytes.len() {
            for bit in 0..8 {
                let mut damaged = bytes.clone();
                damaged[at] ^= 1 << bit;
                let mut coder = new_coder(&fragmented);
                let mut reader = RangeReader::new(&damaged[..], false);
                for _ in 0..fragmented.fragments.step_count() {
                    match coder.code(&mut reader, &CodedFragment::default()) {
                        Ok(fragment) if !reader.overran() => coder.apply(&fragment),
                        _ => break,
                    }
                }
            }
        }
    }
}
