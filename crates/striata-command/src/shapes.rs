//! Meshes that need no file: `shape:NAME` wherever a mesh is read.

use std::path::Path;

use striata::mesh::{IndexedMesh, shapes};

use crate::failure::Failure;

/// What the name of a shape begins with; a file of that name can be read as `./shape:...`.
const PREFIX: &str = "shape:";

/// A mesh that is made, not read.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    name: &'static str,
    make: fn() -> IndexedMesh,
}

/// All shapes by name; those of the papers come first.
const SHAPES: [Shape; 11] = [
    Shape { name: "sphere", make: shapes::paper_sphere },
    Shape { name: "torus", make: || shapes::torus(192, 96, 1.0, 0.4) },
    Shape { name: "terrain", make: || shapes::terrain(129, 0) },
    Shape { name: "icosphere", make: || shapes::icosphere(5, 1.0) },
    Shape { name: "grid", make: || shapes::grid(64, 64) },
    Shape { name: "cylinder", make: || shapes::uv_cylinder(96, 64) },
    Shape { name: "two-materials", make: || shapes::two_material_sphere(48, 96) },
    Shape { name: "moebius", make: || shapes::moebius_strip(64) },
    Shape { name: "klein-bottle", make: || shapes::klein_bottle(64, 32) },
    Shape { name: "cube", make: shapes::cube },
    Shape { name: "tetrahedron", make: shapes::tetrahedron },
];

impl Shape {
    /// The shape that an input's name asks for; `None` where it is the name of a file.
    ///
    /// # Errors
    /// Where there is no such shape.
    pub fn named(input: &Path) -> Result<Option<Self>, Failure> {
        let Some(name) = input.to_str().and_then(|input| input.strip_prefix(PREFIX)) else { return Ok(None) };
        if let Some(&shape) = SHAPES.iter().find(|shape| shape.name == name) {
            return Ok(Some(shape));
        }
        let names: Vec<&str> = SHAPES.iter().map(|shape| shape.name).collect();
        Err(Failure::user(format!("there is no shape {name:?}"))
            .with_hint(format!("there are: {}; a file of that name is ./{PREFIX}{name}", names.join(", "))))
    }

    /// The name, without what it begins with.
    pub fn name(self) -> &'static str {
        self.name
    }

    /// The mesh; the same every time.
    pub fn mesh(self) -> IndexedMesh {
        (self.make)()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_is_a_mesh_that_fits_together() {
        for shape in SHAPES {
            let named = Shape::named(Path::new(&format!("{PREFIX}{}", shape.name))).unwrap().unwrap();
            let mesh = named.mesh();
            assert!(mesh.check().is_ok() && mesh.triangle_count() >= 4, "{}", shape.name);
        }
        assert_eq!(SHAPES[0].mesh().triangle_count(), 30_624, "the papers' sphere");
    }

    #[test]
    fn files_and_unknown_shapes_are_told_apart() {
        for file in ["sphere", "./shape:sphere", "meshes/shape:sphere", "Shape:sphere"] {
            assert!(matches!(Shape::named(Path::new(file)), Ok(None)), "{file}");
        }
        for wrong in ["shape:", "shape:ball", "shape:Sphere"] {
            assert!(Shape::named(Path::new(wrong)).is_err(), "{wrong}");
        }
    }
}
