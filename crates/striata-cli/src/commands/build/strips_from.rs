//! Strips of another stripifier, for models that are made of strips.

use std::collections::HashMap;
use std::path::Path;

use striata::mesh::IndexedMesh;
use striata::strip::{StripSet, strip_triangles};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;
use striata_strip::strips_in_order;

/// A triangle by the positions of its corners.
type Corners = [[u32; 3]; 3];

/// Triangles in the order of the strips of a file.
#[derive(Clone, Debug)]
pub(crate) struct StripsFrom {
    name: String,
    triangles: Vec<Corners>,
    /// Whether the strips stay as they are, and are not the start of a search.
    pub are_final: bool,
}

impl StripsFrom {
    /// Reads strips: a text with the vertices of a strip of `mesh` in each line, or any file whose triangles are in
    /// the order of strips. Says how many of the triangles are in strips.
    ///
    /// # Errors
    /// If the file cannot be read, or none of its triangles is one of `mesh`.
    pub(crate) fn read(
        path: &Path,
        input: &Input,
        mesh: &IndexedMesh,
        are_final: bool,
        output: &Output,
    ) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let triangles = match text_of(path) {
            Some(text) => {
                let positions = positions_of(&text, mesh)
                    .or_else(|| input.obj_text().and_then(|text| positions_of(text, mesh)));
                let strips = strips_of_text(&text, &name, positions.as_deref().unwrap_or(&mesh.positions))?;
                strips.iter().flat_map(|strip| triangles_of(strip)).collect::<Vec<_>>()
            }
            None => {
                let file = Input::open(path)?.mesh(output)?;
                let shift: [f64; 3] = std::array::from_fn(|axis| file.origin[axis] - mesh.origin[axis]);
                let place = |v: u32| {
                    let position = file.positions[v as usize];
                    std::array::from_fn(|axis| (f64::from(position[axis]) + shift[axis]) as f32)
                };
                file.triangles.iter().map(|triangle| corners_of(triangle.map(place))).collect()
            }
        };
        let from = Self { name, triangles, are_final };
        let found = from.order(mesh).len();
        let (all, name) = (from.triangles.len(), &from.name);
        if found == 0 {
            return Err(Failure::user(format!("{name}: none of its triangles is one of {}", input.name))
                .with_hint("strips must have the vertices of the input, at the same positions"));
        }
        if found < all {
            output.say(&format!(
                "warning: {name}: {} of {all} triangles are not in {}",
                all - found,
                input.name
            ));
        }
        let count = mesh.triangle_count();
        if found < count {
            output.say(&format!("note: {} of {count} triangles are in no strip of {name}", count - found));
        }
        Ok(from)
    }

    /// The name of the file.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// The strips as those of a mesh with triangles at the same positions.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub(super) fn strips_of(&self, mesh: &IndexedMesh) -> Result<StripSet, Failure> {
        Ok(strips_in_order(mesh, &self.order(mesh))?)
    }

    /// The triangles of a mesh in the order of the file, without those that it does not have.
    fn order(&self, mesh: &IndexedMesh) -> Vec<u32> {
        let mut numbers: HashMap<Corners, Vec<u32>> = HashMap::new();
        for (number, triangle) in mesh.triangles.iter().enumerate().rev() {
            let corners = corners_of(triangle.map(|v| mesh.positions[v as usize]));
            numbers.entry(corners).or_default().push(number as u32);
        }
        self.triangles.iter().filter_map(|corners| numbers.get_mut(corners)?.pop()).collect()
    }
}

/// A triangle that begins with its smallest corner; -0 is 0.
fn corners_of(positions: [[f32; 3]; 3]) -> Corners {
    let mut corners = positions.map(|position| position.map(|x| (x + 0.0).to_bits()));
    let first = (0..3).min_by_key(|&k| corners[k]).unwrap_or(0);
    corners.rotate_left(first);
    corners
}

/// The triangles of a strip, given by positions.
fn triangles_of(strip: &[[f32; 3]]) -> impl Iterator<Item = Corners> {
    let numbers: Vec<u32> = (0..strip.len() as u32).collect();
    let triangles: Vec<[u32; 3]> = strip_triangles(&numbers).collect();
    let corners = triangles.into_iter().map(|triangle| corners_of(triangle.map(|v| strip[v as usize])));
    let is_proper = |t: &Corners| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    corners.filter(is_proper).collect::<Vec<_>>().into_iter()
}

/// The text of a file that lists strips by their vertices; `None` for other files.
fn text_of(path: &Path) -> Option<String> {
    let text = String::from_utf8(std::fs::read(path).ok()?).ok()?;
    let is_gap = |c: char| c.is_whitespace() || c == ',';
    let words = || text.lines().filter_map(|line| line.split(is_gap).find(|word| !word.is_empty()));
    let is_number = |word: &str| word.parse::<u32>().is_ok();
    let is_known =
        |word: &str| word.starts_with('#') || ["t", "q", "v", "vn", "vt"].contains(&word) || is_number(word);
    let is_list = words().any(|word| word == "t" || is_number(word)) && words().all(is_known);
    is_list.then_some(text)
}

/// The vertices of an OBJ text, relative to the origin of a mesh.
fn positions_of(text: &str, mesh: &IndexedMesh) -> Option<Vec<[f32; 3]>> {
    let position = |line: &str| {
        let mut numbers = line.strip_prefix("v ")?.split_whitespace().map(str::parse::<f64>);
        let mut next = |axis: usize| Some((numbers.next()?.ok()? - mesh.origin[axis]) as f32);
        Some([next(0)?, next(1)?, next(2)?])
    };
    let positions: Vec<_> = text.lines().filter_map(position).collect();
    (!positions.is_empty()).then_some(positions)
}

/// Strips of a text by the positions of their vertices. Lines of numbers count from 0; lines that begin with `t`, and
/// with `q` where they go on, from 1.
fn strips_of_text(text: &str, name: &str, positions: &[[f32; 3]]) -> Result<Vec<Vec<[f32; 3]>>, Failure> {
    let mut strips: Vec<Vec<[f32; 3]>> = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.split('#').next().unwrap_or_default().trim();
        let (first, rest) = match line.split_once(char::is_whitespace) {
            Some(("t" | "q", rest)) => (1, rest),
            Some(("v" | "vn" | "vt", _)) => continue,
            _ => (0, line),
        };
        if !line.starts_with('q') {
            strips.push(Vec::new());
        }
        for word in rest.split([' ', '\t', ',']).filter(|word| !word.is_empty()) {
            let vertex = word.parse::<usize>().ok().and_then(|vertex| vertex.checked_sub(first));
            let Some(&position) = vertex.and_then(|vertex| positions.get(vertex)) else {
                let hint = match positions.len() {
                    0 => "the input has no vertices".to_owned(),
                    count => format!("vertices are {first} to {}", count - 1 + first),
                };
                return Err(Failure::user(format!("{name}: line {number}: no vertex {word}")).with_hint(hint));
            };
            if strips.is_empty() {
                strips.push(Vec::new());
            }
            strips.last_mut().into_iter().for_each(|strip| strip.push(position));
        }
    }
    Ok(strips)
}
