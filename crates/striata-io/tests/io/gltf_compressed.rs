//! Quantized and compressed glTF: what the encoders of other crates write is read back, and damage gives an
//! error or a consistent mesh.

use crate::meshes::{read, refused, sheet};
use serde_json::{Value, json};
use striata::mesh::{IndexedMesh, LayerData, Semantic};

/// Bytes and views of a GLB under construction; all data are in buffer 0.
#[derive(Clone, Default)]
struct Glb {
    binary: Vec<u8>,
    root: Value,
}

impl Glb {
    fn new(extension: &str) -> Self {
        let root = json!({
            "asset": { "version": "2.0" },
            "extensionsUsed": [extension],
            "extensionsRequired": [extension],
            "buffers": [{ "byteLength": 0 }],
            "bufferViews": [],
            "accessors": [],
        });
        Self { binary: Vec::new(), root }
    }

    /// Appends bytes to the buffer, and returns where.
    fn push(&mut self, bytes: &[u8]) -> usize {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        self.binary.extend_from_slice(bytes);
        self.binary.len() - bytes.len()
    }

    fn add(&mut self, array: &str, value: Value) -> usize {
        let entries = self.root[array].as_array_mut().unwrap();
        entries.push(value);
        entries.len() - 1
    }

    /// Adds a plain view, with an accessor of its bytes.
    fn plain(&mut self, bytes: &[u8], stride: usize, mut accessor: Value) -> usize {
        let offset = self.push(bytes);
        let view =
            json!({ "buffer": 0, "byteOffset": offset, "byteLength": bytes.len(), "byteStride": stride });
        accessor["bufferView"] = json!(self.add("bufferViews", view));
        self.add("accessors", accessor)
    }

    fn with_mesh(mut self, primitive: &Value) -> Self {
        self.root["meshes"] = json!([{ "primitives": [primitive] }]);
        self
    }

    fn bytes(&self) -> Vec<u8> {
        let mut root = self.root.clone();
        root["buffers"][0]["byteLength"] = json!(self.binary.len());
        let mut json = root.to_string().into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut binary = self.binary.clone();
        binary.resize(binary.len().next_multiple_of(4), 0);
        let mut out = b"glTF".to_vec();
        for word in [2, 12 + 16 + json.len() + binary.len(), json.len()] {
            out.extend_from_slice(&(word as u32).to_le_bytes());
        }
        out.extend_from_slice(b"JSON");
        out.extend_from_slice(&json);
        out.extend_from_slice(&(binary.len() as u32).to_le_bytes());
        out.extend_from_slice(b"BIN\0");
        out.extend_from_slice(&binary);
        out
    }

    fn read(&self) -> IndexedMesh {
        read("x.glb", &self.bytes()).unwrap()
    }

    fn refused(&self) -> String {
        refused("x.glb", &self.bytes())
    }
}

fn f32s(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|x| x.to_le_bytes()).collect()
}

fn floats<'a>(mesh: &'a IndexedMesh, semantic: &Semantic) -> &'a [f32] {
    match &mesh.layer(semantic).unwrap().data {
        LayerData::F32(numbers) => numbers,
        data => panic!("{semantic} is stored as {data:?}"),
    }
}

/// Turns triangles so that their smallest vertex is first; codecs may rotate them.
#[cfg(any(feature = "meshopt", feature = "draco"))]
fn turned(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let turn = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap();
    triangles.iter().map(turn).collect()
}

/// Panics unless a damaged file is an error or a consistent mesh, and no larger than it may be.
#[cfg(any(feature = "meshopt", feature = "draco"))]
fn assert_survives(bytes: &[u8]) {
    if let Ok(mesh) = read("x.glb", bytes) {
        let is_consistent = mesh.triangles.iter().flatten().all(|&v| (v as usize) < mesh.vertex_count());
        assert!(is_consistent, "a damaged file was read as a broken mesh");
    }
}

/// Damages the binary chunk: truncations, with the counts left as they are, and changed bytes.
#[cfg(any(feature = "meshopt", feature = "draco"))]
fn assert_damage_is_survived(glb: &Glb) {
    for length in 0..glb.binary.len() {
        let mut cut = glb.clone();
        cut.binary.truncate(length);
        assert_survives(&cut.bytes());
        // The missing bytes are replaced, so that only the decoder can notice.
        cut.binary.resize(glb.binary.len(), 0);
        assert_survives(&cut.bytes());
    }
    for place in 0..glb.binary.len() {
        for change in [1, 2, 4, 8, 16, 32, 64, 128, 255] {
            let mut damaged = glb.clone();
            damaged.binary[place] ^= change;
            assert_survives(&damaged.bytes());
        }
    }
}

#[test]
fn quantized_attributes_are_converted() {
    let mut glb = Glb::new("KHR_mesh_quantization");
    let i16s = |values: &[i16]| values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let i8s = |values: &[i8]| values.iter().map(|&x| x as u8).collect::<Vec<u8>>();
    let positions = i16s(&[-4, 0, 2, 0, 4, 0, 2, 0, 0, 8, -2, 0]);
    let position = glb.plain(&positions, 8, json!({ "componentType": 5122, "count": 3, "type": "VEC3" }));
    let normals = i8s(&[0, 0, 127, 0, 0, 127, 0, 0, -128, 0, 0, 0]);
    let accessor = |component: u32, normalized: bool, kind: &str| {
        let mut accessor = json!({ "componentType": component, "count": 3, "type": kind });
        accessor["normalized"] = json!(normalized);
        accessor
    };
    let normal = glb.plain(&normals, 4, accessor(5120, true, "VEC3"));
    let tangents = i8s(&[127, 0, 0, -127, 0, 0, 127, 127, 127, 0, 0, 127]);
    let tangent = glb.plain(&tangents, 4, accessor(5120, true, "VEC4"));
    let texcoords = [0u16, 65535, 13107, 26214, 65535, 0].iter().flat_map(|x| x.to_le_bytes());
    let texcoord = glb.plain(&texcoords.collect::<Vec<u8>>(), 4, accessor(5123, true, "VEC2"));
    let plain_texcoord = glb.plain(&[0, 1, 0, 0, 2, 3, 0, 0, 4, 255, 0, 0], 4, accessor(5121, false, "VEC2"));
    let signed_texcoord =
        glb.plain(&i16s(&[-32767, 32767, 0, 0, -32768, 0]), 4, accessor(5122, true, "VEC2"));
    let morph = glb.plain(&i8s(&[1, 2, 3, 0, -1, 0, 0, 0, 0, 0, 0, 0]), 4, accessor(5120, false, "VEC3"));
    let mut glb = glb.with_mesh(&json!({
        "attributes": {
            "POSITION": position, "NORMAL": normal, "TANGENT": tangent,
            "TEXCOORD_0": texcoord, "TEXCOORD_1": plain_texcoord, "TEXCOORD_2": signed_texcoord,
        },
        "targets": [{ "POSITION": morph }],
    }));
    glb.root["nodes"] = json!([{ "mesh": 0, "scale": [0.5, 0.5, 0.5], "translation": [10.0, 0.0, 0.0] }]);
    let mesh = glb.read();
    assert_eq!(mesh.positions, [[8.0, 0.0, 1.0], [12.0, 0.0, 1.0], [10.0, 4.0, -1.0]]);
    assert_eq!(floats(&mesh, &Semantic::Normal), [0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0]);
    let tangents = [1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0];
    assert_eq!(floats(&mesh, &Semantic::Tangent), tangents);
    let texcoords = mesh.layer(&Semantic::TexCoord(0)).unwrap();
    assert_eq!((texcoords.get(0, 1), texcoords.get(1, 0), texcoords.get(1, 1)), (1.0, 0.2, 0.4));
    assert_eq!(floats(&mesh, &Semantic::TexCoord(1)), [0.0, 1.0, 2.0, 3.0, 4.0, 255.0]);
    assert_eq!(floats(&mesh, &Semantic::TexCoord(2)), [-1.0, 1.0, 0.0, 0.0, -1.0, 0.0]);
    assert_eq!(floats(&mesh, &Semantic::MorphPosition(0))[..6], [0.5, 1.0, 1.5, -0.5, 0.0, 0.0]);
}

#[test]
fn extensions_of_materials_may_be_required() {
    let materials =
        ["KHR_texture_transform", "EXT_texture_webp", "KHR_texture_basisu", "KHR_materials_unlit"];
    for extension in materials {
        assert_eq!(Glb::new(extension).read().triangle_count(), 0);
    }
    for extension in ["VENDOR_shapes", "KHR_meshopt", "KHR_draco"] {
        assert!(Glb::new(extension).refused().contains(&format!("requires the glTF extension {extension}")));
    }
}

/// A document of plain data in which an extension is used, but not required.
#[cfg(not(all(feature = "meshopt", feature = "draco")))]
fn optional(extension: &str, positions: &[[f32; 3]]) -> Glb {
    let mut glb = Glb::new(extension);
    glb.root.as_object_mut().unwrap().remove("extensionsRequired");
    let accessor = json!({ "componentType": 5126, "count": positions.len(), "type": "VEC3" });
    let position = glb.plain(&f32s(positions.as_flattened()), 12, accessor);
    glb.with_mesh(&json!({ "attributes": { "POSITION": position } }))
}

#[cfg(not(feature = "meshopt"))]
#[test]
fn without_meshopt_the_fallback_is_read() {
    let message = Glb::new("EXT_meshopt_compression").refused();
    assert!(message.contains("the feature `meshopt` is off"), "{message}");
    let positions = &sheet(1).positions[..3];
    let mut glb = optional("EXT_meshopt_compression", positions);
    glb.root["bufferViews"][0]["extensions"] = json!({ "EXT_meshopt_compression": {} });
    assert_eq!(glb.read().positions, positions);
    glb.add("buffers", json!({ "byteLength": 36 }));
    glb.root["bufferViews"][0]["buffer"] = json!(1);
    assert!(glb.refused().contains("the feature `meshopt` is off"));
}

#[cfg(not(feature = "draco"))]
#[test]
fn without_draco_the_plain_accessors_are_read() {
    let message = Glb::new("KHR_draco_mesh_compression").refused();
    assert!(message.contains("the feature `draco` is off"), "{message}");
    let positions = &sheet(1).positions[..3];
    let mut glb = optional("KHR_draco_mesh_compression", positions);
    let extensions = json!({ "KHR_draco_mesh_compression": { "bufferView": 0 } });
    glb.root["meshes"][0]["primitives"][0]["extensions"] = extensions;
    assert_eq!(glb.read().positions, positions);
    glb.root["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    assert!(glb.refused().contains("the feature `draco` is off"));
}

#[cfg(feature = "meshopt")]
mod meshopt {
    use std::time::Instant;

    use meshoptimizer_rs::codec::{self, ExpMode, IndexEncoding, VertexEncoding};
    use meshoptimizer_rs::{Limits, Workspace};

    use super::*;

    const EXT: &str = "EXT_meshopt_compression";
    const KHR: &str = "KHR_meshopt_compression";

    fn workspace() -> Workspace {
        Workspace::new(Limits::default())
    }

    fn vertices(bytes: &[u8], stride: usize, version: u8) -> Vec<u8> {
        let encoding = VertexEncoding::new(version, 2).unwrap();
        codec::encode_vertex_buffer(bytes, bytes.len() / stride, stride, encoding, &mut workspace()).unwrap()
    }

    impl Glb {
        /// Starts a document whose buffer 1 is a placeholder for uncompressed data.
        fn packed(extension: &str) -> Self {
            let mut glb = Self::new(extension);
            let fallback =
                json!({ "byteLength": 1 << 20, "extensions": { extension: { "fallback": true } } });
            glb.add("buffers", fallback);
            glb
        }

        /// Adds a compressed view and its accessor; `how` has the mode, and perhaps a filter.
        fn pack(
            &mut self,
            packed: &[u8],
            [count, stride]: [usize; 2],
            how: &Value,
            accessor: Value,
        ) -> usize {
            let mut how = how.clone();
            let offset = self.push(packed);
            how["buffer"] = json!(0);
            how["byteOffset"] = json!(offset);
            how["byteLength"] = json!(packed.len());
            how["byteStride"] = json!(stride);
            how["count"] = json!(count);
            let extension = self.root["extensionsUsed"][0].as_str().unwrap().to_owned();
            let mut view = json!({ "buffer": 1, "byteLength": count * stride });
            view["extensions"] = json!({ extension: how });
            if how["mode"] == "ATTRIBUTES" {
                view["byteStride"] = json!(stride);
            }
            let mut accessor = accessor;
            accessor["bufferView"] = json!(self.add("bufferViews", view));
            accessor["count"] = json!(count);
            self.add("accessors", accessor)
        }

        fn pack_positions(&mut self, mesh: &IndexedMesh, version: u8) -> usize {
            let packed = vertices(&f32s(mesh.positions.as_flattened()), 12, version);
            let how = json!({ "mode": "ATTRIBUTES" });
            self.pack(
                &packed,
                [mesh.vertex_count(), 12],
                &how,
                json!({ "componentType": 5126, "type": "VEC3" }),
            )
        }

        fn pack_triangles(&mut self, mesh: &IndexedMesh, stride: usize) -> usize {
            let indices = mesh.triangles.as_flattened();
            let packed =
                codec::encode_index_buffer(indices, IndexEncoding::DEFAULT, &mut workspace()).unwrap();
            let accessor =
                json!({ "componentType": if stride == 2 { 5123 } else { 5125 }, "type": "SCALAR" });
            self.pack(&packed, [indices.len(), stride], &json!({ "mode": "TRIANGLES" }), accessor)
        }
    }

    fn compressed(mesh: &IndexedMesh, extension: &str, version: u8) -> Glb {
        let mut glb = Glb::packed(extension);
        let position = glb.pack_positions(mesh, version);
        let indices = glb.pack_triangles(mesh, 2);
        glb.with_mesh(&json!({ "attributes": { "POSITION": position }, "indices": indices }))
    }

    #[test]
    fn compressed_meshes_are_read_exactly() {
        let mesh = sheet(20);
        for (extension, version) in [(EXT, 0), (EXT, 1), (KHR, 0), (KHR, 1)] {
            let found = compressed(&mesh, extension, version).read();
            assert_eq!(found.positions, mesh.positions);
            assert_eq!(turned(&found.triangles), turned(&mesh.triangles));
        }
    }

    #[test]
    fn index_sequences_keep_the_order() {
        let mesh = sheet(9);
        let mut glb = Glb::packed(EXT);
        let position = glb.pack_positions(&mesh, 0);
        let indices = mesh.triangles.as_flattened();
        let packed = codec::encode_index_sequence(indices, IndexEncoding::DEFAULT, &mut workspace()).unwrap();
        let accessor = json!({ "componentType": 5125, "type": "SCALAR" });
        let indices = glb.pack(&packed, [indices.len(), 4], &json!({ "mode": "INDICES" }), accessor);
        let found =
            glb.with_mesh(&json!({ "attributes": { "POSITION": position }, "indices": indices })).read();
        assert_eq!((found.positions, found.triangles), (mesh.positions, mesh.triangles));
    }

    #[test]
    fn filters_are_undone() {
        let mesh = sheet(3);
        let n = mesh.vertex_count();
        let direction = |i: usize| {
            let (sin, cos) = (i as f32 * 0.37).sin_cos();
            [sin * 0.6, cos * 0.6, if i.is_multiple_of(2) { 0.8 } else { -0.8 }, 1.0]
        };
        let directions: Vec<f32> = (0..n).flat_map(direction).collect();
        let colors: Vec<f32> = (0..n).flat_map(|i| [i as f32 / n as f32, 0.5, 1.0, 0.25]).collect();
        let rotations: Vec<f32> = (0..n).flat_map(|i| direction(i).map(|x| x / 2f32.sqrt())).collect();
        let points: Vec<f32> = mesh.positions.as_flattened().to_vec();
        let work = &mut workspace();
        let parts = [
            (
                "POSITION",
                "EXPONENTIAL",
                12,
                5126,
                codec::encode_filter_exp(n, 12, 20, &points, ExpMode::SharedVector, work),
            ),
            ("NORMAL", "OCTAHEDRAL", 4, 5120, codec::encode_filter_oct(n, 4, 8, &directions, work)),
            ("_OCT16", "OCTAHEDRAL", 8, 5122, codec::encode_filter_oct(n, 8, 16, &directions, work)),
            ("_ROTATION", "QUATERNION", 8, 5122, codec::encode_filter_quat(n, 8, 16, &rotations, work)),
            ("COLOR_0", "COLOR", 4, 5121, codec::encode_filter_color(n, 4, 8, &colors, work)),
            ("_COLOR16", "COLOR", 8, 5123, codec::encode_filter_color(n, 8, 16, &colors, work)),
        ];
        let mut glb = Glb::packed(KHR);
        let mut attributes = json!({});
        for (name, filter, stride, component, filtered) in parts {
            let kind = if matches!(name, "POSITION" | "NORMAL") { "VEC3" } else { "VEC4" };
            let accessor =
                json!({ "componentType": component, "type": kind, "normalized": component != 5126 });
            let how = json!({ "mode": "ATTRIBUTES", "filter": filter });
            let packed = vertices(&filtered.unwrap(), stride, 1);
            attributes[name] = json!(glb.pack(&packed, [n, stride], &how, accessor));
        }
        let indices = glb.pack_triangles(&mesh, 4);
        let found = glb.with_mesh(&json!({ "attributes": attributes, "indices": indices })).read();
        let near = |found: &[f32], expected: &[f32], tolerance: f32| {
            assert_eq!(found.len(), expected.len());
            let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= tolerance);
            assert!(is_near, "{found:?} is not {expected:?}");
        };
        near(found.positions.as_flattened(), &points, 1e-4);
        let normals: Vec<f32> = directions.chunks(4).flat_map(|d| d[..3].to_vec()).collect();
        near(floats(&found, &Semantic::Normal), &normals, 0.02);
        let generic = |name: &str| {
            let layer = found.layer(&Semantic::Generic(name.to_owned())).unwrap();
            (0..n).flat_map(|v| (0..4).map(move |c| layer.get(v, c))).collect::<Vec<f32>>()
        };
        near(&generic("OCT16"), &directions, 1e-3);
        near(&generic("COLOR16"), &colors, 1e-3);
        let layer = found.layer(&Semantic::Color(0)).unwrap();
        near(&(0..4 * n).map(|i| layer.get(i / 4, i % 4)).collect::<Vec<f32>>(), &colors, 0.02);
        // A rotation and its negative are the same.
        for (a, b) in generic("ROTATION").chunks(4).zip(rotations.chunks(4)) {
            let dot: f32 = a.iter().zip(b).map(|(a, b)| a * b).sum();
            let square: f32 = b.iter().map(|x| x * x).sum();
            assert!((dot.abs() - square.sqrt()).abs() < 1e-3, "{a:?} is not {b:?}");
        }
    }

    #[test]
    fn fallback_buffers_are_not_needed() {
        let mesh = sheet(4);
        let mut glb = compressed(&mesh, EXT, 0);
        glb.root["buffers"][1]["uri"] = json!("not_there.bin");
        assert_eq!(glb.read().positions, mesh.positions);
        // Without the extension, a view into the placeholder is an error.
        glb.root["bufferViews"][0].as_object_mut().unwrap().remove("extensions");
        let message = glb.refused();
        assert!(message.contains("bufferViews[0]: bytes 0 + 300 of a buffer of 0 bytes"), "{message}");
    }

    #[test]
    fn damaged_data_are_survived() {
        let mesh = sheet(4);
        for version in [0, 1] {
            assert_damage_is_survived(&compressed(&mesh, KHR, version));
        }
        let mut glb = Glb::packed(EXT);
        let position = glb.pack_positions(&mesh, 0);
        let indices = mesh.triangles.as_flattened();
        let packed = codec::encode_index_sequence(indices, IndexEncoding::DEFAULT, &mut workspace()).unwrap();
        let accessor = json!({ "componentType": 5123, "type": "SCALAR" });
        let indices = glb.pack(&packed, [indices.len(), 2], &json!({ "mode": "INDICES" }), accessor);
        assert_damage_is_survived(
            &glb.with_mesh(&json!({ "attributes": { "POSITION": position }, "indices": indices })),
        );
    }

    #[test]
    fn counts_that_lie_are_refused_at_once() {
        let start = Instant::now();
        let glb = compressed(&sheet(4), EXT, 0);
        let how = |view: usize, key: &str, value: Value| {
            let mut glb = glb.clone();
            glb.root["bufferViews"][view]["extensions"][EXT][key] = value;
            glb.refused()
        };
        let place = format!("bufferViews[0].extensions.{EXT}");
        for (key, value, reason) in [
            ("count", json!(24), "24 elements of 12 bytes, in a view of 300 bytes"),
            ("count", json!(u64::MAX / 2), "elements of 12 bytes, in a view of 300 bytes"),
            ("byteStride", json!(0), "byteStride 0 is not valid for the mode ATTRIBUTES"),
            ("byteStride", json!(1000), "byteStride 1000 is not valid"),
            ("byteLength", json!(1u64 << 40), "bytes 0 + 1099511627776 of a buffer"),
            ("buffer", json!(7), "buffers[7] does not exist"),
            ("mode", json!("SPLINES"), "no compression mode is called `SPLINES`"),
            ("filter", json!("BLUR"), "no compression filter is called `BLUR`"),
            ("filter", json!("QUATERNION"), "the filter QUATERNION cannot follow ATTRIBUTES"),
        ] {
            let message = how(0, key, value);
            assert!(message.contains(&place) && message.contains(reason), "{message}");
        }
        assert!(how(1, "count", json!(95)).contains("95 indices are not whole triangles"));
        assert!(how(1, "filter", json!("OCTAHEDRAL")).contains("cannot follow TRIANGLES"));
        let mut big = glb.clone();
        for count in [1u64 << 20, 1 << 24, 1 << 40] {
            big.root["bufferViews"][0]["byteLength"] = json!(count * 12);
            big.root["bufferViews"][0]["extensions"][EXT]["count"] = json!(count);
            let message = big.refused();
            let is_refused = message.contains("are damaged") || message.contains("the data expand to");
            assert!(is_refused, "{message}");
        }
        assert!(start.elapsed().as_secs() < 5, "{:?}", start.elapsed());
    }
}

#[cfg(feature = "draco")]
mod draco {
    use std::time::Instant;

    use draco_core::{
        DataType, EncoderBuffer, EncoderOptions, GeometryAttributeType, Mesh, MeshEncoder, PointAttribute,
        PointIndex,
    };

    use super::*;

    const DRACO: &str = "KHR_draco_mesh_compression";

    fn attribute(
        kind: GeometryAttributeType,
        width: u8,
        data_type: DataType,
        bytes: &[u8],
    ) -> PointAttribute {
        let mut attribute = PointAttribute::new();
        let count = bytes.len() / (width as usize * data_type.byte_length());
        attribute.init(kind, width, data_type, false, count);
        attribute.buffer_mut().write(0, bytes);
        attribute
    }

    /// Compresses positions, a texture coordinate and joints of a mesh; `method` is 0 for sequential coding
    /// and 1 for edgebreaker.
    fn encoded(mesh: &IndexedMesh, method: i32, position_bits: i32) -> Vec<u8> {
        let mut draco = Mesh::new();
        draco.set_num_points(mesh.vertex_count());
        let positions = f32s(mesh.positions.as_flattened());
        draco.add_attribute(attribute(GeometryAttributeType::Position, 3, DataType::Float32, &positions));
        let texcoords = f32s(&texcoords(mesh));
        draco.add_attribute(attribute(GeometryAttributeType::TexCoord, 2, DataType::Float32, &texcoords));
        let joints = joints(mesh);
        draco.add_attribute(attribute(GeometryAttributeType::Generic, 4, DataType::Uint8, &joints));
        for triangle in &mesh.triangles {
            draco.add_face(triangle.map(PointIndex));
        }
        let mut options = EncoderOptions::new();
        options.set_encoding_method(method);
        if position_bits > 0 {
            options.set_attribute_quantization(0, position_bits);
        }
        let (mut encoder, mut out) = (MeshEncoder::new(), EncoderBuffer::new());
        encoder.set_mesh(draco);
        encoder.encode(&options, &mut out).unwrap();
        out.data().to_vec()
    }

    fn texcoords(mesh: &IndexedMesh) -> Vec<f32> {
        mesh.positions.iter().flat_map(|[x, y, _]| [x / 16.0, y / 16.0]).collect()
    }

    fn joints(mesh: &IndexedMesh) -> Vec<u8> {
        (0..mesh.vertex_count() as u32).flat_map(|v| [v % 7, v % 5, 0, v % 251].map(|x| x as u8)).collect()
    }

    /// A document of the compressed mesh, with a plain attribute besides.
    fn document(mesh: &IndexedMesh, packed: &[u8]) -> Glb {
        let mut glb = Glb::new(DRACO);
        let n = mesh.vertex_count();
        let offset = glb.push(packed);
        let view = json!({ "buffer": 0, "byteOffset": offset, "byteLength": packed.len() });
        let view = glb.add("bufferViews", view);
        let mut declare = |kind: u32, shape: &str, count: usize| {
            glb.add("accessors", json!({ "componentType": kind, "type": shape, "count": count }))
        };
        let (position, texcoord) = (declare(5126, "VEC3", n), declare(5126, "VEC2", n));
        let (joints, indices) =
            (declare(5121, "VEC4", n), declare(5125, "SCALAR", 3 * mesh.triangle_count()));
        let heat: Vec<f32> = (0..n).map(|v| v as f32).collect();
        let heat = glb.plain(&f32s(&heat), 4, json!({ "componentType": 5126, "count": n, "type": "SCALAR" }));
        glb.with_mesh(&json!({
            "attributes": { "POSITION": position, "TEXCOORD_0": texcoord, "JOINTS_0": joints, "_HEAT": heat },
            "indices": indices,
            "extensions": { DRACO: {
                "bufferView": view,
                "attributes": { "POSITION": 0, "TEXCOORD_0": 1, "JOINTS_0": 2 },
            } },
        }))
    }

    /// All corners as positions, texture coordinates and joints, in the order of the triangles.
    fn corners(mesh: &IndexedMesh, texcoords: &[f32], joints: &[u8]) -> Vec<Vec<f32>> {
        let corner = |&v: &u32| {
            let v = v as usize;
            let joints = joints[4 * v..4 * v + 4].iter().map(|&x| f32::from(x));
            mesh.positions[v].into_iter().chain(texcoords[2 * v..2 * v + 2].to_vec()).chain(joints).collect()
        };
        turned(&mesh.triangles).iter().flatten().map(corner).collect()
    }

    fn corners_read(mesh: &IndexedMesh) -> Vec<Vec<f32>> {
        let LayerData::U8(joints) = &mesh.layer(&Semantic::Joints(0)).unwrap().data else { panic!() };
        corners(mesh, floats(mesh, &Semantic::TexCoord(0)), joints)
    }

    #[test]
    fn sequential_meshes_are_read_exactly() {
        let mesh = sheet(12);
        let found = document(&mesh, &encoded(&mesh, 0, 0)).read();
        assert_eq!((&found.positions, &found.triangles), (&mesh.positions, &mesh.triangles));
        assert_eq!(corners_read(&found), corners(&mesh, &texcoords(&mesh), &joints(&mesh)));
        let heat = floats(&found, &Semantic::Generic("HEAT".to_owned()));
        assert!(heat.iter().enumerate().all(|(v, &x)| x == v as f32));
    }

    #[test]
    fn edgebreaker_reorders_but_keeps_the_surface() {
        let mesh = sheet(12);
        let found = document(&mesh, &encoded(&mesh, 1, 14)).read();
        assert_eq!((found.vertex_count(), found.triangle_count()), (169, 288));
        // Every triangle is found again: its corners, rounded to the quantization, in any rotation.
        let rounded = |corners: Vec<Vec<f32>>| {
            let round = |x: &f32| (x * 50.0).round() as i32;
            let mut triangles: Vec<Vec<Vec<i32>>> = corners
                .chunks(3)
                .map(|t| {
                    let t: Vec<Vec<i32>> = t.iter().map(|c| c.iter().map(round).collect()).collect();
                    let turns = (0..3).map(|k| [&t[k..], &t[..k]].concat());
                    turns.min().unwrap()
                })
                .collect();
            triangles.sort();
            triangles
        };
        let expected = corners(&mesh, &texcoords(&mesh), &joints(&mesh));
        assert_eq!(rounded(corners_read(&found)), rounded(expected));
    }

    #[test]
    fn shared_meshes_share_vertices() {
        let mesh = sheet(5);
        let mut glb = document(&mesh, &encoded(&mesh, 0, 0));
        let primitive = glb.root["meshes"][0]["primitives"][0].clone();
        glb.root["meshes"][0]["primitives"] = json!([primitive, primitive]);
        let found = glb.read();
        assert_eq!((found.vertex_count(), found.triangle_count()), (36, 100));
    }

    #[test]
    fn damaged_data_are_survived() {
        let mesh = sheet(4);
        for (method, bits) in [(0, 0), (0, 11), (1, 11)] {
            assert_damage_is_survived(&document(&mesh, &encoded(&mesh, method, bits)));
        }
    }

    #[test]
    fn wrong_references_are_refused_at_once() {
        let start = Instant::now();
        let mesh = sheet(4);
        let glb = document(&mesh, &encoded(&mesh, 1, 11));
        let change = |key: &str, value: Value| {
            let mut glb = glb.clone();
            glb.root["meshes"][0]["primitives"][0]["extensions"][DRACO][key] = value;
            glb.refused()
        };
        let place = format!("meshes[0].primitives[0].extensions.{DRACO}");
        let ids = |position: u64| json!({ "POSITION": position, "TEXCOORD_0": 1, "JOINTS_0": 2 });
        for (key, value, reason) in [
            ("bufferView", json!(9), "bufferViews[9] does not exist"),
            ("bufferView", json!(1), "the compressed data are damaged"),
            ("attributes", ids(5), "the compressed mesh has no attribute 5"),
            ("attributes", ids(1 << 40), "attribute 1099511627776 does not exist"),
        ] {
            let message = change(key, value);
            assert!(message.contains(&place) && message.contains(reason), "{message}");
        }
        assert!(change("attributes", ids(1)).contains("POSITION must be VEC3"));
        // A plain attribute of another length than the compressed ones.
        let mut short = glb.clone();
        short.root["accessors"][4]["count"] = json!(24);
        assert!(short.refused().contains("accessors[4]: 24 elements for 25 vertices"));
        assert!(start.elapsed().as_secs() < 5, "{:?}", start.elapsed());
    }
}
