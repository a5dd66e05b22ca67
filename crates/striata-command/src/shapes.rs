//! Built-in shapes, which can be used instead of a mesh file under the name `shape:NAME`.

use std::path::Path;

use striata::mesh::{IndexedMesh, shapes};

use crate::failure::Failure;

/// Prefix of the names of shapes; files with such a name can be read as `./shape:...`.
const PREFIX: &str = "shape:";

/// A built-in mesh.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    name: &'static str,
    make: fn() -> IndexedMesh,
}

/// All shapes; those used in the papers come first.
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
    /// Returns the shape that an input name stands for; `None` if it is the name of a file.
    ///
    /// # Errors
    /// If the name has the prefix, but there is no such shape.
    pub fn from_input_name(input: &Path) -> Result<Option<Self>, Failure> {
        let Some(name) = input.to_str().and_then(|input| input.strip_prefix(PREFIX)) else { return Ok(None) };
        if let Some(&shape) = SHAPES.iter().find(|shape| shape.name == name) {
            return Ok(Some(shape));
        }
        let names: Vec<&str> = SHAPES.iter().map(|shape| shape.name).collect();
        Err(Failure::usage(format!("there is no shape {name:?}")).with_hint(format!(
            "there are: {}; to read a file with this name, write ./{PREFIX}{name}",
            names.join(", ")
        )))
    }

    /// Returns the name without the prefix.
    pub fn name(self) -> &'static str {
        self.name
    }

    /// Creates the mesh; it is the same every time.
    pub fn mesh(self) -> IndexedMesh {
        (self.make)()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_is_a_consistent_mesh() {
        for shape in SHAPES {
            let named =
                Shape::from_input_name(Path::new(&format!("{PREFIX}{}", shape.name))).unwrap().unwrap();
            let mesh = named.mesh();
            assert!(mesh.check().is_ok() && mesh.triangle_count() >= 4, "{}", shape.name);
        }
        assert_eq!(SHAPES[0].mesh().triangle_count(), 30_624, "the papers' sphere");
    }

    #[test]
    fn file_names_are_not_shapes_and_unknown_shapes_fail() {
        for file in ["sphere", "./shape:sphere", "meshes/shape:sphere", "Shape:sphere"] {
            assert!(matches!(Shape::from_input_name(Path::new(file)), Ok(None)), "{file}");
        }
        for wrong in ["shape:", "shape:ball", "shape:Sphere"] {
            assert!(Shape::from_input_name(Path::new(wrong)).is_err(), "{wrong}");
        }
    }
}
