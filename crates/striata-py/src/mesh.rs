//! The class `MeshData`: an indexed mesh, shared between threads.

use std::sync::Arc;

use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use striata::mesh::{AttributeLayer, Image, IndexedMesh, LayerData, Semantic};

use crate::arrays::{flat_to_array, rows_of, rows_to_array, signed_rows};
use crate::errors::{Outcome, value_error};

/// An immutable mesh.
#[pyclass(frozen, module = "striata._striata", name = "MeshData")]
#[derive(Clone, Debug)]
pub(crate) struct PyMeshData {
    pub mesh: Arc<IndexedMesh>,
}

/// Values of a layer, with a row for each vertex.
#[derive(FromPyObject)]
enum LayerArray<'py> {
    F32(PyReadonlyArray2<'py, f32>),
    U8(PyReadonlyArray2<'py, u8>),
    U16(PyReadonlyArray2<'py, u16>),
    U32(PyReadonlyArray2<'py, u32>),
    I8(PyReadonlyArray2<'py, i8>),
    I16(PyReadonlyArray2<'py, i16>),
    I32(PyReadonlyArray2<'py, i32>),
    F64(PyReadonlyArray2<'py, f64>),
}

/// A layer: kind, number of the set, name, whether integers stand for fractions, values.
type LayerArguments<'py> = (String, u16, String, bool, LayerArray<'py>);

#[pymethods]
impl PyMeshData {
    #[new]
    fn new(
        points: PyReadonlyArray2<'_, f32>,
        faces: PyReadonlyArray2<'_, u32>,
        layers: Vec<LayerArguments<'_>>,
    ) -> Outcome<Self> {
        let mut mesh = IndexedMesh::new(rows_of(&points, "points")?, rows_of(&faces, "faces")?);
        mesh.layers = layers.into_iter().map(layer_of).collect::<Outcome<_>>()?;
        mesh.check().map_err(value_error)?;
        Ok(Self::from(mesh))
    }

    #[getter]
    fn georeference(&self) -> &str {
        &self.mesh.appearance.georeference
    }

    #[getter]
    fn point_count(&self) -> usize {
        self.mesh.vertex_count()
    }

    #[getter]
    fn face_count(&self) -> usize {
        self.mesh.triangle_count()
    }

    #[getter]
    fn diagonal(&self) -> f64 {
        self.mesh.diagonal()
    }

    fn points<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        file_points(py, &self.mesh)
    }

    fn faces<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i32>> {
        signed_rows(py, self.mesh.triangles.clone())
    }

    /// Layers as tuples of kind, set, name, whether normalized, and values.
    fn layers<'py>(&self, py: Python<'py>) -> Vec<LayerTuple<'py>> {
        layer_tuples(py, &self.mesh.layers)
    }

    /// Layers of faces, like [`layers`](Self::layers).
    fn face_layers<'py>(&self, py: Python<'py>) -> Vec<LayerTuple<'py>> {
        layer_tuples(py, &self.mesh.triangle_layers)
    }

    /// The mesh with these layers of faces.
    fn with_face_layers(&self, layers: Vec<LayerArguments<'_>>) -> Outcome<Self> {
        let mut mesh = IndexedMesh::clone(&self.mesh);
        mesh.triangle_layers = layers.into_iter().map(layer_of).collect::<Outcome<_>>()?;
        mesh.check().map_err(value_error)?;
        Ok(Self::from(mesh))
    }

    /// Groups as tuples of name, material (or `None`), first triangle and number of triangles.
    fn groups(&self) -> Vec<(String, Option<u32>, u32, u32)> {
        self.mesh.groups.iter().map(|g| (g.name.clone(), g.material, g.first, g.count)).collect()
    }

    /// Materials as tuples of name and glTF object.
    fn materials(&self) -> Vec<(String, String)> {
        let materials = &self.mesh.appearance.materials;
        materials.iter().map(|material| (material.name.clone(), material.gltf_json.clone())).collect()
    }

    /// Images as tuples of name, location, MIME type and contents.
    fn images<'py>(&self, py: Python<'py>) -> Vec<ImageTuple<'py>> {
        image_tuples(py, &self.mesh.appearance.images)
    }

    /// The mesh without layers that exist only for simplification.
    fn stored(&self) -> Self {
        match self.mesh.layers.iter().any(is_internal) {
            true => Self::from(without_internal_layers(&self.mesh)),
            false => self.clone(),
        }
    }

    /// The mesh with its origin moved by an offset.
    fn moved(&self, offset: [f64; 3]) -> Self {
        if offset == [0.0; 3] {
            return self.clone();
        }
        let mut mesh = IndexedMesh::clone(&self.mesh);
        move_origin(&mut mesh, offset);
        Self::from(mesh)
    }

    /// The mesh with its points in double precision, which outputs use as they are.
    fn with_exact_points(&self, points: PyReadonlyArray2<'_, f64>) -> Outcome<Self> {
        let mut mesh = IndexedMesh::clone(&self.mesh);
        mesh.exact_positions = rows_of(&points, "points")?;
        mesh.check().map_err(value_error)?;
        Ok(Self::from(mesh))
    }

    /// The mesh with its points relative to the origin of another one.
    fn relative_to(&self, other: &Self) -> Self {
        if self.mesh.origin == other.mesh.origin {
            return self.clone();
        }
        let mut mesh = IndexedMesh::clone(&self.mesh);
        mesh.set_origin(other.mesh.origin);
        Self::from(mesh)
    }
}

impl From<IndexedMesh> for PyMeshData {
    fn from(mesh: IndexedMesh) -> Self {
        Self { mesh: Arc::new(mesh) }
    }
}

/// Moves the origin of a mesh, and with it all points.
pub(crate) fn move_origin(mesh: &mut IndexedMesh, offset: [f64; 3]) {
    let exact = mesh.exact_positions.iter_mut().chain(std::iter::once(&mut mesh.origin));
    for (x, offset) in exact.flat_map(|point| point.iter_mut().zip(offset)) {
        *x += offset;
    }
}

/// The points of a mesh in the coordinates of its file: single precision if that holds them.
pub(crate) fn file_points<'py>(py: Python<'py>, mesh: &IndexedMesh) -> Bound<'py, PyAny> {
    if !mesh.needs_doubles() {
        return rows_to_array(py, mesh.positions.clone()).into_any();
    }
    let points: Vec<[f64; 3]> = (0..mesh.vertex_count()).map(|vertex| mesh.file_position(vertex)).collect();
    rows_to_array(py, points).into_any()
}

/// Kind, set, name, whether normalized, and values of a layer.
type LayerTuple<'py> = (&'static str, u16, String, bool, Bound<'py, PyAny>);

fn layer_tuples<'py>(py: Python<'py>, layers: &[AttributeLayer]) -> Vec<LayerTuple<'py>> {
    let tuple = |layer: &AttributeLayer| {
        let (kind, set, name) = described(&layer.semantic);
        (kind, set, name, layer.normalized, values_of(py, layer))
    };
    layers.iter().map(tuple).collect()
}

/// Name, location, MIME type and contents of an image.
pub(crate) type ImageTuple<'py> = (String, String, String, Bound<'py, PyBytes>);

/// Images as tuples.
pub(crate) fn image_tuples<'py>(py: Python<'py>, images: &[Image]) -> Vec<ImageTuple<'py>> {
    let tuple = |image: &Image| {
        let bytes = PyBytes::new(py, &image.bytes);
        (image.name.clone(), image.uri.clone(), image.mime_type.clone(), bytes)
    };
    images.iter().map(tuple).collect()
}

/// Color sets from this number on only count in the cost; the Python half makes them.
const FIRST_COST_SET: u8 = 200;
/// Prefix of layers that only tell vertices apart; the Python half makes them.
const ID_PREFIX: &str = "striata:id:";

/// Whether a layer exists only for simplification, so that files must not store it.
pub(crate) fn is_internal(layer: &AttributeLayer) -> bool {
    match &layer.semantic {
        Semantic::Color(set) => *set >= FIRST_COST_SET,
        Semantic::Generic(name) => name.starts_with(ID_PREFIX),
        _ => false,
    }
}

/// A copy of a mesh without layers that exist only for simplification.
pub(crate) fn without_internal_layers(mesh: &IndexedMesh) -> IndexedMesh {
    let mut mesh = mesh.clone();
    mesh.layers.retain(|layer| !is_internal(layer));
    mesh
}

fn layer_of((kind, set, name, normalized, values): LayerArguments<'_>) -> Outcome<AttributeLayer> {
    let (columns, data) = match values {
        LayerArray::F32(array) => flat(&array).map(|(n, values)| (n, LayerData::F32(values)))?,
        LayerArray::U8(array) => flat(&array).map(|(n, values)| (n, LayerData::U8(values)))?,
        LayerArray::U16(array) => flat(&array).map(|(n, values)| (n, LayerData::U16(values)))?,
        LayerArray::U32(array) => flat(&array).map(|(n, values)| (n, LayerData::U32(values)))?,
        LayerArray::I8(array) => flat(&array).map(|(n, values)| (n, LayerData::I8(values)))?,
        LayerArray::I16(array) => flat(&array).map(|(n, values)| (n, LayerData::I16(values)))?,
        LayerArray::I32(array) => flat(&array).map(|(n, values)| (n, LayerData::I32(values)))?,
        LayerArray::F64(array) => flat(&array).map(|(n, values)| (n, LayerData::F64(values)))?,
    };
    let component_count = u8::try_from(columns).ok().filter(|&n| n > 0).ok_or_else(|| {
        value_error(format!("attribute {name:?} has {columns} columns, but a layer has 1 to 255"))
    })?;
    Ok(AttributeLayer { semantic: semantic_of(&kind, set, name)?, component_count, normalized, data })
}

fn flat<T: numpy::Element + Copy>(array: &PyReadonlyArray2<'_, T>) -> Outcome<(usize, Vec<T>)> {
    use numpy::PyUntypedArrayMethods as _;
    let values = array.as_slice().map_err(|_| value_error("a layer is not contiguous"))?;
    Ok((array.shape()[1], values.to_vec()))
}

fn values_of<'py>(py: Python<'py>, layer: &AttributeLayer) -> Bound<'py, PyAny> {
    let columns = layer.component_count as usize;
    match &layer.data {
        LayerData::F32(values) => flat_to_array(py, values.clone(), columns).into_any(),
        LayerData::U8(values) => flat_to_array(py, values.clone(), columns).into_any(),
        LayerData::U16(values) => flat_to_array(py, values.clone(), columns).into_any(),
        LayerData::U32(values) => flat_to_array(py, values.clone(), columns).into_any(),
        LayerData::I8(values) => flat_to_array(py, values.clone(), columns).into_any(),
        LayerData::I16(values) => flat_to_array(py, values.clone(), columns).into_any(),
        LayerData::I32(values) => flat_to_array(py, values.clone(), columns).into_any(),
        LayerData::F64(values) => flat_to_array(py, values.clone(), columns).into_any(),
    }
}

/// Kind, set and name of a meaning, as `semantic_of` takes them.
fn described(semantic: &Semantic) -> (&'static str, u16, String) {
    match semantic {
        Semantic::Normal => ("normal", 0, String::new()),
        Semantic::Tangent => ("tangent", 0, String::new()),
        Semantic::TexCoord(set) => ("texcoord", u16::from(*set), String::new()),
        Semantic::Color(set) => ("color", u16::from(*set), String::new()),
        Semantic::Joints(set) => ("joints", u16::from(*set), String::new()),
        Semantic::Weights(set) => ("weights", u16::from(*set), String::new()),
        Semantic::MorphPosition(target) => ("morph_position", *target, String::new()),
        Semantic::MorphNormal(target) => ("morph_normal", *target, String::new()),
        Semantic::MorphTangent(target) => ("morph_tangent", *target, String::new()),
        Semantic::Generic(name) => ("generic", 0, name.clone()),
    }
}

fn semantic_of(kind: &str, set: u16, name: String) -> Outcome<Semantic> {
    let small = u8::try_from(set).map_err(|_| value_error(format!("{kind} set {set} is above 255")));
    Ok(match kind {
        "normal" => Semantic::Normal,
        "tangent" => Semantic::Tangent,
        "texcoord" => Semantic::TexCoord(small?),
        "color" => Semantic::Color(small?),
        "joints" => Semantic::Joints(small?),
        "weights" => Semantic::Weights(small?),
        "morph_position" => Semantic::MorphPosition(set),
        "morph_normal" => Semantic::MorphNormal(set),
        "morph_tangent" => Semantic::MorphTangent(set),
        "generic" => Semantic::Generic(name),
        _ => return Err(value_error(format!("unknown kind of layer {kind:?}"))),
    })
}
