//! Meshes that break algorithms: one for each thing that can be wrong with a mesh.

use striata::mesh::shapes::{
    book, bow_tie, closed_fan, cube, hard_cube, klein_bottle, many_components, moebius_strip, needle,
    random_soup, tetrahedron, torus, triangle_fan, two_material_sphere, uv_cylinder,
};
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, TriangleGroup};

/// One small mesh for each thing that can be wrong with a mesh, with a description.
///
/// Consistent meshes come first, however odd they are, followed by those for which [`IndexedMesh::check`]
/// fails. No function of this library may panic on any of them.
pub fn nasty() -> Vec<(&'static str, IndexedMesh)> {
    let mut list = nearly_empty();
    list.extend(badly_connected());
    list.extend(badly_positioned());
    list.extend(with_attributes());
    list.extend(inconsistent());
    list
}

const SQUARE: [[f32; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];

fn square(triangles: &[[u32; 3]]) -> IndexedMesh {
    IndexedMesh::new(SQUARE.to_vec(), triangles.to_vec())
}

fn nearly_empty() -> Vec<(&'static str, IndexedMesh)> {
    vec![
        ("empty", IndexedMesh::default()),
        ("vertices without triangles", square(&[])),
        ("one triangle", square(&[[0, 1, 2]])),
        ("one triangle, all corners one vertex", square(&[[2, 2, 2]])),
        ("two corners one vertex", square(&[[0, 1, 1], [0, 1, 2], [3, 0, 3]])),
        ("unused vertices", square(&[[1, 2, 3]])),
        ("closed tetrahedron", tetrahedron()),
        ("two components", many_components(2)),
        ("many tiny components", many_components(300)),
    ]
}

fn badly_connected() -> Vec<(&'static str, IndexedMesh)> {
    let mut reversed = cube();
    reversed.triangles[5].swap(0, 1);
    let mut pinched = torus(6, 5, 2.0, 1.0);
    // Two distant vertices become one: a bow-tie on a closed surface.
    for v in pinched.triangles.iter_mut().flatten().filter(|v| **v == 17) {
        *v = 2;
    }
    vec![
        ("duplicate triangles", square(&[[0, 1, 2], [0, 1, 2], [1, 2, 0], [0, 2, 3]])),
        ("opposite duplicates", square(&[[0, 1, 2], [0, 2, 1]])),
        ("three copies and one opposite", square(&[[0, 1, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]])),
        ("three triangles on an edge", book(3)),
        ("seven triangles on an edge", book(7)),
        ("bow-tie", bow_tie()),
        ("bow-tie on a torus", pinched),
        ("moebius strip", moebius_strip(9)),
        ("klein bottle", klein_bottle(6, 7)),
        ("reversed triangle", reversed),
        ("open fan of 300", triangle_fan(300)),
        ("closed fan of 300", closed_fan(300)),
        ("soup of 40", random_soup(40, 1)),
        ("soup of 400", random_soup(400, 2)),
    ]
}

fn badly_positioned() -> Vec<(&'static str, IndexedMesh)> {
    let moved = |mesh: IndexedMesh, scale: f32, offset: f32| IndexedMesh {
        positions: mesh.positions.iter().map(|p| p.map(|x| x * scale + offset)).collect(),
        ..mesh
    };
    let line = (0..10).map(|i| [i as f32, 2.0 * i as f32, -(i as f32)]).collect();
    let along: Vec<[u32; 3]> = (0..8).map(|i| [i, i + 1, i + 2]).collect();
    let mut split = tetrahedron();
    split.positions = split.triangles.iter().flatten().map(|&v| split.positions[v as usize]).collect();
    split.triangles = vec![[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]];
    vec![
        ("needle", needle()),
        ("all vertices on a line", IndexedMesh::new(line, along.clone())),
        ("all vertices in one point", IndexedMesh::new(vec![[1.0, 2.0, 3.0]; 10], along)),
        ("every corner its own vertex", split),
        ("folded flat", square(&[[0, 1, 2], [0, 2, 1], [0, 2, 3]])),
        ("coordinates around 1e7", moved(cube(), 8.0, 1e7)),
        ("coordinates around 1e-7", moved(cube(), 1e-7, 0.0)),
        ("subnormal coordinates", moved(cube(), 1e-42, 0.0)),
        ("coordinates around 1e38", moved(cube(), 3e38, 0.0)),
    ]
}

fn with_attributes() -> Vec<(&'static str, IndexedMesh)> {
    let mut not_a_number = uv_cylinder(4, 1);
    not_a_number.layers[1] =
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, vec![f32::NAN; 2 * not_a_number.vertex_count()]);
    let mut empty_groups = square(&[[0, 1, 2], [0, 2, 3]]);
    let group = |first, count| TriangleGroup { first, count, ..TriangleGroup::default() };
    empty_groups.groups = vec![group(0, 0), group(0, 1), group(1, 0), group(1, 1), group(2, 0)];
    vec![
        ("seam of a cylinder", uv_cylinder(8, 3)),
        ("hard edges", hard_cube()),
        ("two materials", two_material_sphere(3, 6)),
        ("attributes not a number", not_a_number),
        ("groups without triangles", empty_groups),
    ]
}

/// Meshes for which [`IndexedMesh::check`] fails.
fn inconsistent() -> Vec<(&'static str, IndexedMesh)> {
    let with = |change: &dyn Fn(&mut IndexedMesh)| {
        let mut mesh = square(&[[0, 1, 2], [0, 2, 3]]);
        change(&mut mesh);
        mesh
    };
    let group = |first, count, material| TriangleGroup { first, count, material, ..TriangleGroup::default() };
    vec![
        ("coordinate not a number", with(&|m| m.positions[2][1] = f32::NAN)),
        ("coordinate infinite", with(&|m| m.positions[0][0] = f32::NEG_INFINITY)),
        ("every coordinate not a number", with(&|m| m.positions.fill([f32::NAN; 3]))),
        ("index out of range", with(&|m| m.triangles[1][2] = 4)),
        ("index of a restart", with(&|m| m.triangles[0] = [u32::MAX; 3])),
        ("triangles without vertices", with(&|m| m.positions.clear())),
        (
            "layer too short",
            with(&|m| m.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, vec![0.0; 11]))),
        ),
        ("group past the end", with(&|m| m.groups.push(group(0, 3, None)))),
        ("group past all numbers", with(&|m| m.groups.push(group(u32::MAX, u32::MAX, None)))),
        ("groups with a gap", with(&|m| m.groups = vec![group(0, 0, None), group(1, 1, None)])),
        ("material out of range", with(&|m| m.groups.push(group(0, 2, Some(0))))),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inconsistent_meshes_come_last_and_names_are_unique() {
        let list = nasty();
        let first_bad = list.len() - inconsistent().len();
        for (i, (name, mesh)) in list.iter().enumerate() {
            assert_eq!(mesh.check().is_err(), i >= first_bad, "{name}");
            assert!(list[..i].iter().all(|(other, _)| other != name), "{name} twice");
        }
    }
}
