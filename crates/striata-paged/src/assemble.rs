//! Makes one mesh with levels of loaded pages.

use std::collections::HashMap;

use serde_json::Value;
use striata::mesh::{
    Appearance, CollapseSequence, Image, IndexedMesh, Material, PositionIndex, RefinableMesh, SequenceParts,
    TriangleGroup,
};

use crate::hash::IndexHash;
use crate::{Metadata, Page, PagedError};

const NONE: u32 = u32::MAX;

/// Loaded pages as one mesh.
#[derive(Clone, Debug)]
pub struct Assembled {
    /// The mesh with its levels. Its full detail is all that the pages contain.
    pub refinable: RefinableMesh,
    /// Key of each step, never increasing.
    pub keys: Vec<f32>,
    /// Error of the surface without each step alone, in mesh units; the sequence has the largest of these and all
    /// later ones.
    pub step_errors: Vec<f32>,
    /// Index of the page that each vertex comes from.
    pub page_of_vertex: Vec<u32>,
}

impl Assembled {
    /// Number of steps whose keys are at least `key`.
    pub fn split_count_for_key(&self, key: f32) -> usize {
        self.keys.partition_point(|&other| other >= key)
    }
}

/// Assembles pages, each with its index in the directory.
///
/// # Errors
/// [`PagedError::Mismatch`] if a parent of a page is absent or the pages do not fit together.
pub fn assemble(pages: &[(u32, &Page)], metadata: &Metadata) -> Result<Assembled, PagedError> {
    let mut pages = pages.to_vec();
    pages.sort_by_key(|&(index, _)| index);
    let order = Order::new(&pages)?;
    let targets = order.targets(&pages)?;
    let mut triangles = Triangles::default();
    for (slot, &(_, page)) in pages.iter().enumerate() {
        triangles.load(page, &order.numbers(&pages, slot)?)?;
    }
    let (groups, corners) = triangles.by_group(metadata);
    let sequence = sequence(&order, targets, &corners)?;
    let mut mesh = IndexedMesh {
        positions: order.gather(&pages, |page, v| page.positions[v as usize]),
        triangles: corners,
        layers: Vec::new(),
        groups,
        appearance: appearance(metadata),
    };
    mesh.layers = order.layers(&pages, metadata);
    let page_of_vertex = order.vertices.iter().map(|&(slot, _)| pages[slot as usize].0).collect();
    Ok(Assembled {
        keys: order.keys(&pages),
        step_errors: order.errors,
        page_of_vertex,
        refinable: RefinableMesh { mesh, sequence },
    })
}

/// The refinement order of all positions.
struct Order {
    /// Page (its place in the list) and number of each position; those of the base come first.
    positions: Vec<(u32, u32)>,
    base_position_count: usize,
    /// First vertex of each position, then the number of vertices.
    first: Vec<u32>,
    /// Page and number of each vertex.
    vertices: Vec<(u32, u32)>,
    /// Number of each owned vertex of each page.
    number: Vec<Vec<u32>>,
    /// Error of each step.
    errors: Vec<f32>,
    slot_of: HashMap<u32, u32>,
}

impl Order {
    fn new(pages: &[(u32, &Page)]) -> Result<Self, PagedError> {
        let mut positions = Vec::new();
        for (slot, (_, page)) in (0..).zip(pages) {
            positions.extend((0..page.first.len().saturating_sub(1) as u32).map(|p| (slot, p)));
        }
        let key = |&(slot, p): &(u32, u32)| {
            // The base page has no keys: it is before everything.
            pages[slot as usize].1.keys.get(p as usize).copied().unwrap_or(f32::INFINITY)
        };
        positions.sort_by(|a, b| key(b).total_cmp(&key(a)).then(a.cmp(b)));
        let base_position_count = positions.partition_point(|at| key(at) == f32::INFINITY);
        let mut order = Self {
            base_position_count,
            first: vec![0],
            vertices: Vec::new(),
            number: pages.iter().map(|(_, page)| vec![NONE; page.positions.len()]).collect(),
            errors: Vec::new(),
            slot_of: pages.iter().zip(0..).map(|(&(index, _), slot)| (index, slot)).collect(),
            positions,
        };
        for &(slot, p) in &order.positions {
            let page = pages[slot as usize].1;
            for v in page.first[p as usize]..page.first[p as usize + 1] {
                order.number[slot as usize][v as usize] = order.vertices.len() as u32;
                order.vertices.push((slot, v));
            }
            order.first.push(order.vertices.len() as u32);
        }
        order.errors = order.positions[base_position_count..]
            .iter()
            .map(|&(slot, p)| pages[slot as usize].1.errors[p as usize])
            .collect();
        Ok(order)
    }

    /// Numbers of all vertices that a page mentions: owned, then imports.
    fn numbers(&self, pages: &[(u32, &Page)], slot: usize) -> Result<Vec<u32>, PagedError> {
        let page = pages[slot].1;
        let mut numbers = self.number[slot].clone();
        for import in &page.imports {
            let owner = self.slot_of.get(&import.page).filter(|_| import.page < pages[slot].0);
            let number = owner.and_then(|&slot| self.number[slot as usize].get(import.vertex as usize));
            let reason = "a vertex that it imports is not there";
            numbers.push(*number.ok_or(PagedError::Mismatch { id: page.id, reason })?);
        }
        Ok(numbers)
    }

    /// Targets of all vertices that are not in the base.
    fn targets(&self, pages: &[(u32, &Page)]) -> Result<Vec<u32>, PagedError> {
        let base = self.first[self.base_position_count] as usize;
        let mut targets = vec![NONE; self.vertices.len() - base];
        for (slot, (_, page)) in pages.iter().enumerate() {
            let numbers = self.numbers(pages, slot)?;
            for (v, &target) in page.targets.iter().enumerate() {
                targets[numbers[v] as usize - base] = numbers[target as usize];
            }
        }
        Ok(targets)
    }

    fn gather<T>(&self, pages: &[(u32, &Page)], value: impl Fn(&Page, u32) -> T) -> Vec<T> {
        self.vertices.iter().map(|&(slot, v)| value(pages[slot as usize].1, v)).collect()
    }

    fn keys(&self, pages: &[(u32, &Page)]) -> Vec<f32> {
        let steps = &self.positions[self.base_position_count..];
        steps.iter().map(|&(slot, p)| pages[slot as usize].1.keys[p as usize]).collect()
    }

    fn layers(&self, pages: &[(u32, &Page)], metadata: &Metadata) -> Vec<striata::mesh::AttributeLayer> {
        let mut firsts = Vec::with_capacity(pages.len());
        let mut count = 0;
        for (_, page) in pages {
            firsts.push(count);
            count += page.positions.len() as u32;
        }
        let order: Vec<u32> = self.vertices.iter().map(|&(slot, v)| firsts[slot as usize] + v).collect();
        let layers = metadata.empty_layers().into_iter().enumerate().map(|(i, mut all)| {
            pages.iter().for_each(|(_, page)| append(&mut all.data, &page.layers[i].data));
            all.gather(&order)
        });
        layers.filter(|layer| !Metadata::is_material_layer(layer)).collect()
    }
}

fn append(data: &mut striata::mesh::LayerData, more: &striata::mesh::LayerData) {
    use striata::mesh::LayerData::{F32, U8, U16, U32};
    match (data, more) {
        (F32(a), F32(b)) => a.extend_from_slice(b),
        (U8(a), U8(b)) => a.extend_from_slice(b),
        (U16(a), U16(b)) => a.extend_from_slice(b),
        (U32(a), U32(b)) => a.extend_from_slice(b),
        // Pages have the layers of the metadata.
        _ => {}
    }
}

/// Triangles of the pages loaded so far.
#[derive(Default)]
struct Triangles {
    /// Corners and group; triangles that a finer page has replaced have no group.
    all: Vec<([u32; 3], u32)>,
    /// The last of all triangles with these corners and group.
    last: HashMap<[u32; 4], u32, IndexHash>,
    /// The one before, among equal triangles.
    before: Vec<u32>,
}

impl Triangles {
    /// Replaces what the triangles of a page become by these triangles; `numbers` are those of its vertices.
    fn load(&mut self, page: &Page, numbers: &[u32]) -> Result<(), PagedError> {
        let owned = page.positions.len() as u32;
        let coarse = coarse_vertices(page);
        let group = |t: usize| page.groups.get(t).copied().unwrap_or(0);
        for (t, corners) in page.triangles.iter().enumerate().filter(|_| !page.targets.is_empty()) {
            let coarse = corners.map(|v| if v < owned { coarse[v as usize] } else { v });
            let [a, b, c] = coarse.map(|v| numbers[v as usize]);
            if a != b && b != c && c != a && !self.remove([a, b, c], group(t)) {
                // Its imports may be wedges of one position: then nothing is there to be replaced.
                continue;
            }
        }
        for (t, corners) in page.triangles.iter().enumerate() {
            self.add(corners.map(|v| numbers[v as usize]), group(t));
        }
        Ok(())
    }

    fn add(&mut self, corners: [u32; 3], group: u32) {
        let number = self.all.len() as u32;
        self.all.push((corners, group));
        let before = self.last.insert(key_of(corners, group), number);
        self.before.push(before.unwrap_or(NONE));
    }

    fn remove(&mut self, corners: [u32; 3], group: u32) -> bool {
        let key = key_of(corners, group);
        let Some(&number) = self.last.get(&key) else { return false };
        self.all[number as usize].1 = NONE;
        match self.before[number as usize] {
            NONE => self.last.remove(&key),
            before => self.last.insert(key, before),
        };
        true
    }

    /// All triangles by group.
    fn by_group(self, metadata: &Metadata) -> (Vec<TriangleGroup>, Vec<[u32; 3]>) {
        let mut left: Vec<([u32; 3], u32)> =
            self.all.into_iter().filter(|&(_, group)| group != NONE).collect();
        left.sort_by_key(|&(_, group)| group);
        let mut groups: Vec<TriangleGroup> = Vec::new();
        let mut first = 0;
        for (index, group) in (0..).zip(&metadata.groups) {
            let count = left.iter().filter(|&&(_, other)| other == index).count() as u32;
            groups.push(TriangleGroup { name: group.name.clone(), material: group.material, first, count });
            first += count;
        }
        let is_plain = metadata.groups.len() < 2
            && metadata.groups.iter().all(|group| group.name.is_empty() && group.material.is_none());
        let corners = left.into_iter().map(|(corners, _)| corners).collect();
        (if is_plain { Vec::new() } else { groups }, corners)
    }
}

/// The import that each owned vertex becomes when all steps of its page are undone.
fn coarse_vertices(page: &Page) -> Vec<u32> {
    let owned = page.positions.len() as u32;
    let mut coarse: Vec<u32> = page.targets.clone();
    for v in 0..coarse.len() {
        // Targets have larger keys, so this ends.
        let mut at = coarse[v];
        while at < owned {
            at = coarse[at as usize];
        }
        coarse[v] = at;
    }
    coarse
}

/// Corners beginning with the smallest, and the group.
fn key_of([a, b, c]: [u32; 3], group: u32) -> [u32; 4] {
    if a <= b && a <= c {
        [a, b, c, group]
    } else if b <= a && b <= c {
        [b, c, a, group]
    } else {
        [c, a, b, group]
    }
}

/// The sequence of steps, with the number of triangles that each removes.
fn sequence(
    order: &Order,
    targets: Vec<u32>,
    triangles: &[[u32; 3]],
) -> Result<CollapseSequence, PagedError> {
    let positions = PositionIndex::from_first(order.first.clone());
    let base = order.base_position_count as u32;
    let base_vertex = order.first[order.base_position_count];
    let mut counts = vec![0u32; order.errors.len()];
    for corners in triangles {
        let mut corners = corners.map(|v| (positions.position_of(v), v));
        loop {
            let [a, b, c] = corners.map(|(p, _)| p);
            let finest = usize::from(b > a && b >= c) + 2 * usize::from(c > a && c > b);
            let (p, v) = corners[finest];
            if p < base {
                break;
            }
            let target = targets[(v - base_vertex) as usize];
            let at = positions.position_of(target);
            if at >= p {
                // Pages that do not fit together; the sequence will be refused.
                break;
            }
            if corners.iter().enumerate().any(|(i, &(other, _))| i != finest && other == at) {
                counts[(p - base) as usize] += 1;
                break;
            }
            corners[finest] = (at, target);
        }
    }
    Ok(CollapseSequence::from_parts(SequenceParts {
        positions,
        base_position_count: order.base_position_count,
        targets,
        errors: level_errors(&order.errors),
        // A step of a cell removes at most 255 triangles; more are an error of the pages.
        removed_triangle_counts: counts.into_iter().map(|count| count.min(255) as u8).collect(),
        triangle_count: triangles.len(),
    })?)
}

/// The error of each level: it covers all steps that are not taken.
fn level_errors(step_errors: &[f32]) -> Vec<f32> {
    let mut errors = step_errors.to_vec();
    let mut worst = 0.0f32;
    for error in errors.iter_mut().rev() {
        worst = worst.max(*error);
        *error = worst;
    }
    errors
}

/// Materials and images of the metadata.
fn appearance(metadata: &Metadata) -> Appearance {
    let list =
        |name: &str| metadata.appearance.get(name).and_then(Value::as_array).cloned().unwrap_or_default();
    let text =
        |value: &Value, name: &str| value.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
    let material = |value: &Value| Material { name: text(value, "name"), gltf_json: value.to_string() };
    let image =
        |value: &Value| Image { name: text(value, "name"), uri: text(value, "uri"), ..Image::default() };
    Appearance {
        materials: list("materials").iter().map(material).collect(),
        images: list("images").iter().map(image).collect(),
        textures_json: list("textures").iter().map(Value::to_string).collect(),
        samplers_json: list("samplers").iter().map(Value::to_string).collect(),
        ..Appearance::default()
    }
}
