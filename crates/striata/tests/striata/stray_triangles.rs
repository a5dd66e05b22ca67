//! A triangle far away from a mesh does not change what is left of the mesh.

use striata::mesh::{IndexedMesh, shapes};
use striata::{Lod, LodOptions, Target};

/// Volume of a closed mesh, in mesh units cubed.
fn volume(mesh: &IndexedMesh) -> f64 {
    let corner = |v: u32| mesh.positions[v as usize].map(f64::from);
    let sixth = |[a, b, c]: [[f64; 3]; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    mesh.triangles.iter().map(|t| sixth(t.map(corner)) / 6.0).sum()
}

/// A sphere of 5,120 triangles, and one triangle at a distance.
fn with_stray(distance: f32) -> IndexedMesh {
    let mut mesh = shapes::icosphere(4, 1.0);
    let first = mesh.positions.len() as u32;
    let corners = [[0.0, 0.0], [0.01, 0.0], [0.0, 0.01]];
    mesh.positions.extend(corners.map(|[x, y]| [distance + x, distance + y, distance]));
    mesh.triangles.push([first, first + 1, first + 2]);
    mesh
}

#[test]
fn a_stray_triangle_does_not_erode_the_rest() {
    let level = |mesh: &IndexedMesh| {
        let lod = Lod::build(mesh, &LodOptions::default()).unwrap();
        let mut level = lod.level(Target::Triangles(600)).to_mesh();
        // The stray triangle has no volume of its own to speak of, only a large distance.
        level.triangles.retain(|t| t.iter().all(|&v| level.positions[v as usize][0] < 100.0));
        volume(&level)
    };
    let alone = level(&shapes::icosphere(4, 1.0));
    for exponent in [4, 6, 8, 10, 12] {
        let kept = level(&with_stray(10f32.powi(exponent))) / alone;
        assert!((kept - 1.0).abs() < 0.01, "1e{exponent}: {kept} of the volume");
    }
}
