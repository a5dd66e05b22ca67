//! Meshes for Neuroglancer, read by a reader of their own: no cracks within a level, and what viewers rely on.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read as _;
use std::path::Path;

use crate::common::{built, try_built, try_built_with};
use draco_core::{
    AttributeValueIndex, DataType, DecoderBuffer, GeometryAttributeType, MeshDecoder, PointIndex,
};
use serde_json::Value;
use striata::ignore_progress;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, shapes};
use striata_paged::PagedFile;
use striata_testing::meshes::nasty;
use striata_tiles::{
    NeuroglancerOptions, NeuroglancerReport, NeuroglancerWriter, ShardHash, Sharding, TilesError, VertexBits,
};

type Point = [i64; 3];

/// A level of detail, on its lattice.
struct LodTriangles {
    scale: f32,
    cells: Vec<[u32; 3]>,
    /// Triangles of each fragment.
    fragments: Vec<Vec<[Point; 3]>>,
}

struct Segment {
    bits: u32,
    chunk: f32,
    origin: [f32; 3],
    lods: Vec<LodTriangles>,
}

fn info(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join("info")).unwrap()).unwrap()
}

/// Triangles of a fragment, in steps from its corner.
fn decoded(bytes: &[u8]) -> Vec<[Point; 3]> {
    let mut mesh = draco_core::Mesh::new();
    MeshDecoder::new().decode(&mut DecoderBuffer::new(bytes), &mut mesh).unwrap();
    let id = mesh.named_attribute_id(GeometryAttributeType::Position);
    let positions = mesh.attribute(id);
    assert_eq!((positions.data_type(), positions.num_components()), (DataType::Int32, 3));
    assert_eq!(positions.size(), mesh.num_points(), "viewers expect one value per vertex");
    let point = |p: PointIndex| {
        let AttributeValueIndex(value) = positions.mapped_index(p);
        let mut bytes = [0; 12];
        positions.buffer().read(value as usize * 12, &mut bytes);
        let number = |i: usize| i32::from_le_bytes(bytes[i * 4..i * 4 + 4].try_into().unwrap());
        [0, 1, 2].map(|i| i64::from(number(i)))
    };
    mesh.faces().iter().map(|face| face.map(point)).collect()
}

/// Takes numbers from bytes.
struct Numbers<'a>(&'a [u8]);

impl Numbers<'_> {
    fn word(&mut self) -> [u8; 4] {
        let (word, rest) = self.0.split_at(4);
        self.0 = rest;
        word.try_into().unwrap()
    }

    fn floats<const N: usize>(&mut self) -> [f32; N] {
        [0; N].map(|_| f32::from_le_bytes(self.word()))
    }

    fn integers(&mut self, count: usize) -> Vec<u32> {
        (0..count).map(|_| u32::from_le_bytes(self.word())).collect()
    }
}

impl Segment {
    fn read(folder: &Path, id: u64) -> Self {
        let info = info(folder);
        let bits = info["vertex_quantization_bits"].as_u64().unwrap() as u32;
        let (manifest, data) = match info.get("sharding") {
            None => {
                let read = |name: String| fs::read(folder.join(name)).unwrap();
                (read(format!("{id}.index")), read(id.to_string()))
            }
            Some(sharding) => sharded(folder, sharding, id),
        };
        let mut numbers = Numbers(&manifest);
        let chunk = numbers.floats::<3>();
        assert_eq!([chunk[0]; 3], chunk);
        let origin = numbers.floats::<3>();
        let lod_count = numbers.integers(1)[0] as usize;
        let scales: Vec<f32> = (0..lod_count).map(|_| numbers.floats::<1>()[0]).collect();
        assert_eq!(numbers.integers(3 * lod_count), vec![0; 3 * lod_count]);
        let counts = numbers.integers(lod_count);
        let mut at = 0;
        let mut lods = Vec::new();
        let mut manifest_of = |scale: f32, count: u32| {
            let rows = [0; 3].map(|_| numbers.integers(count as usize));
            let cells: Vec<[u32; 3]> =
                (0..count as usize).map(|i| [rows[0][i], rows[1][i], rows[2][i]]).collect();
            let fragment = |size: u32| {
                let bytes = &data[at..at + size as usize];
                at += size as usize;
                if bytes.is_empty() { Vec::new() } else { decoded(bytes) }
            };
            let fragments = numbers.integers(count as usize).into_iter().map(fragment).collect();
            LodTriangles { scale, cells, fragments }
        };
        lods.extend(scales.into_iter().zip(counts).map(|(scale, count)| manifest_of(scale, count)));
        assert_eq!((at, numbers.0.len()), (data.len(), 0));
        Self { bits, chunk: chunk[0], origin, lods }
    }

    /// Checks what viewers rely on.
    fn check(&self) {
        let largest = (1i64 << self.bits) - 1;
        assert!(self.lods[0].scale > 0.0);
        assert!(self.lods.is_sorted_by(|a, b| a.scale <= b.scale));
        assert_eq!(self.lods.last().unwrap().cells, [[0; 3]], "one fragment is the root");
        for (number, lod) in self.lods.iter().enumerate() {
            let order = |cell: &[u32; 3]| -> u64 {
                (0..21)
                    .map(|bit| (0..3).map(|a| u64::from(cell[a] >> bit & 1) << (3 * bit + a)).sum::<u64>())
                    .sum()
            };
            assert!(lod.cells.is_sorted_by(|a, b| order(a) < order(b)), "z-order, without duplicates");
            if let Some(parents) = self.lods.get(number + 1) {
                let parents: BTreeSet<_> = parents.cells.iter().collect();
                assert!(lod.cells.iter().all(|cell| parents.contains(&cell.map(|x| x >> 1))));
            }
            for corners in lod.fragments.iter().flatten() {
                assert!(corners.iter().flatten().all(|x| (0..=largest).contains(x)), "{corners:?}");
                assert!((0..3).all(|i| corners[i] != corners[(i + 1) % 3]));
                let middle = 1 << (self.bits - 1);
                let is_whole = |a: usize| {
                    corners.iter().all(|p| p[a] <= middle) || corners.iter().all(|p| p[a] >= middle)
                };
                assert!(number == 0 || (0..3).all(is_whole), "{corners:?} belongs to two eighths");
            }
        }
    }

    /// Triangles of a level on its lattice.
    fn triangles(&self, lod: usize) -> impl Iterator<Item = [Point; 3]> {
        let side = (1i64 << self.bits) - 1;
        let LodTriangles { cells, fragments, .. } = &self.lods[lod];
        cells.iter().zip(fragments).flat_map(move |(cell, triangles)| {
            let shifted = move |p: Point| [0, 1, 2].map(|a| p[a] + i64::from(cell[a]) * side);
            triangles.iter().map(move |corners| corners.map(shifted))
        })
    }

    /// Number of edges of a level with an odd number of triangles.
    fn open_edge_count(&self, lod: usize) -> usize {
        let mut counts: BTreeMap<[Point; 2], usize> = BTreeMap::new();
        for corners in self.triangles(lod) {
            for i in 0..3 {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                *counts.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
        counts.values().filter(|&count| count % 2 == 1).count()
    }

    /// Corners of a level in the units of the mesh.
    fn places(&self, lod: usize) -> impl Iterator<Item = [f64; 3]> {
        let step = f64::from(self.chunk) * f64::from(1 << lod) / f64::from((1 << self.bits) - 1);
        let place = move |p: Point| [0, 1, 2].map(|a| f64::from(self.origin[a]) + p[a] as f64 * step);
        self.triangles(lod).flatten().map(place)
    }
}

/// The manifest and the fragments of a segment in shards.
fn sharded(folder: &Path, sharding: &Value, id: u64) -> (Vec<u8>, Vec<u8>) {
    assert_eq!(sharding["@type"], "neuroglancer_uint64_sharded_v1");
    let number = |name: &str| sharding[name].as_u64().unwrap();
    assert_eq!(sharding["hash"], "identity", "the reader knows no other");
    let hash = id >> number("preshift_bits");
    let [minishards, shards] = ["minishard_bits", "shard_bits"].map(|name| 1 << number(name));
    let digits = number("shard_bits").div_ceil(4) as usize;
    let name = format!("{:0digits$x}.shard", hash / minishards % shards);
    let bytes = fs::read(folder.join(name)).unwrap();
    let word = |bytes: &[u8], i: usize| u64::from_le_bytes(bytes[i * 8..i * 8 + 8].try_into().unwrap());
    let minishard = (hash % minishards) as usize;
    let data = &bytes[minishards as usize * 16..];
    let range = [0, 1].map(|i| word(&bytes, 2 * minishard + i) as usize);
    let mut index = Vec::new();
    flate2::read::GzDecoder::new(&data[range[0]..range[1]]).read_to_end(&mut index).unwrap();
    let count = index.len() / 24;
    let (mut found, mut at) = (0u64, 0u64);
    for i in 0..count {
        found = found.wrapping_add(word(&index, i));
        at = at.wrapping_add(word(&index, count + i));
        let size = word(&index, 2 * count + i);
        if found == id {
            let manifest = data[at as usize..(at + size) as usize].to_vec();
            let fragment_bytes = fragment_bytes(&manifest);
            return (manifest, data[at as usize - fragment_bytes..at as usize].to_vec());
        }
        at += size;
    }
    panic!("segment {id} is not in its shard");
}

/// Number of bytes of all fragments.
fn fragment_bytes(manifest: &[u8]) -> usize {
    let mut numbers = Numbers(manifest);
    numbers.floats::<6>();
    let lod_count = numbers.integers(1)[0] as usize;
    numbers.integers(4 * lod_count);
    let counts = numbers.integers(lod_count);
    let sizes = |count: u32| numbers.integers(4 * count as usize)[3 * count as usize..].to_vec();
    counts.into_iter().flat_map(sizes).map(|size| size as usize).sum()
}

fn options(fragment_triangles: u64, bits: VertexBits) -> NeuroglancerOptions {
    let mut options = NeuroglancerOptions::default();
    (options.fragment_triangles, options.bits) = (fragment_triangles, bits);
    options
}

fn written(mesh: &IndexedMesh, options: NeuroglancerOptions) -> (Segment, NeuroglancerReport) {
    let (folder, mut file) = built(mesh);
    written_of(folder.path(), &mut file, options)
}

fn written_of(
    folder: &Path,
    file: &mut PagedFile,
    options: NeuroglancerOptions,
) -> (Segment, NeuroglancerReport) {
    let output = folder.join("meshes");
    let mut writer = NeuroglancerWriter::new(&output, options).unwrap();
    writer.add(7, file, &mut ignore_progress).unwrap();
    let report = writer.finish().unwrap();
    (Segment::read(&output, 7), report)
}

#[test]
fn a_closed_surface_has_no_open_edge_at_any_level() {
    let torus = shapes::torus(80, 60, 1.0, 0.4);
    let on_grid = |mesh: &IndexedMesh| try_built_with(mesh, false).unwrap();
    for bits in [VertexBits::Ten, VertexBits::Sixteen] {
        // The grid of a file moves vertices out of the bounds of the input.
        for (folder, mut file) in [built(&torus), on_grid(&torus), built(&shapes::icosphere(5, 3.0))] {
            let (segment, report) = written_of(folder.path(), &mut file, options(500, bits));
            segment.check();
            assert!(segment.lods.len() >= 3 && segment.lods[0].cells.len() > 20);
            for lod in 0..segment.lods.len() {
                assert_eq!(segment.open_edge_count(lod), 0, "level {lod}");
                let triangles = segment.triangles(lod).count() as u64;
                assert_eq!(report.levels[lod].triangles, triangles);
                assert_eq!(report.levels[lod].error as f32, segment.lods[lod].scale);
            }
            let step = report.step;
            assert_eq!(segment.lods[0].scale, step as f32);
        }
    }
}

#[test]
fn scales_are_the_errors_of_levels() {
    let (segment, report) = written(&shapes::icosphere(5, 3.0), options(500, VertexBits::Sixteen));
    let mut largest = 0f64;
    for (lod, LodTriangles { scale, .. }) in segment.lods.iter().enumerate() {
        let off = |p: [f64; 3]| (p.iter().map(|x| x * x).sum::<f64>().sqrt() - 3.0).abs();
        // Centers of the triangles; those of the input are inside of the sphere already.
        let places: Vec<[f64; 3]> = segment.places(lod).collect();
        let center = |c: &[[f64; 3]]| [0, 1, 2].map(|a| (c[0][a] + c[1][a] + c[2][a]) / 3.0);
        let error = (places.chunks(3).map(center).map(off).fold(0.0, f64::max) - 9e-4).max(0.0);
        assert!(error <= f64::from(*scale), "level {lod}: {error} > {scale}");
        largest = largest.max(error / f64::from(*scale));
    }
    assert!(largest > 0.2, "scales are not far larger than the errors: {largest}");
    // The coarsest fragment is hardly larger than the mesh.
    let width = f64::from(segment.chunk) * f64::from(1 << (segment.lods.len() - 1));
    assert!((6.0..6.1).contains(&width), "{width} {report:?}");
}

#[test]
fn the_finest_level_is_the_input() {
    let mesh = shapes::torus(50, 40, 1.0, 0.4);
    let (segment, report) = written(&mesh, options(500, VertexBits::Sixteen));
    let places: Vec<[f64; 3]> = segment.places(0).collect();
    for p in &mesh.positions {
        let near = |q: &[f64; 3]| (0..3).all(|a| (f64::from(p[a]) - q[a]).abs() <= 0.51 * report.step + 1e-7);
        assert!(places.iter().any(near), "{p:?}");
    }
}

#[test]
fn segments_share_an_origin_and_shards() {
    let folder = tempfile::tempdir().unwrap();
    let shape = |id: u64| {
        let mut mesh = shapes::icosphere(2, 1.0 + id as f32);
        mesh.origin = [1e6 + id as f64 * 10.0, 0.0, -5.0];
        mesh
    };
    let ids = [3u64, 4, 9, 1 << 40, u64::MAX];
    let shards = |minishard_bits, shard_bits| {
        Some(Sharding { hash: ShardHash::Identity, preshift_bits: 1, minishard_bits, shard_bits })
    };
    let sizes: Vec<u64> = [None, shards(0, 0), shards(2, 1), shards(1, 5)]
        .into_iter()
        .map(|sharding| {
            let output = folder.path().join("meshes");
            let mut options = options(100, VertexBits::Sixteen);
            options.sharding = sharding;
            let mut writer = NeuroglancerWriter::new(&output, options).unwrap();
            for (place, id) in (0..).zip(ids) {
                let (_folder, mut file) = built(&shape(place));
                writer.add(id, &mut file, &mut ignore_progress).unwrap();
            }
            let report = writer.finish().unwrap();
            let x = info(&output)["transform"][3].as_f64().unwrap();
            for (place, id) in (0..).zip(ids) {
                let segment = Segment::read(&output, id);
                segment.check();
                let corner = x + f64::from(segment.origin[0]);
                let expected = 1e6 + f64::from(place) * 10.0 - 1.0 - f64::from(place);
                assert!((corner - expected).abs() < 1e-3, "{corner} {expected}");
                assert!((0..segment.lods.len()).all(|lod| segment.open_edge_count(lod) == 0));
            }
            assert_eq!((report.segments, report.left_out.len()), (5, 0));
            let names = fs::read_dir(&output).unwrap().count();
            assert_eq!(names, if sharding.is_none() { 12 } else { 2 + shard_count(sharding, &ids) });
            report.bytes
        })
        .collect();
    assert_eq!(sizes, [sizes[0]; 4]);
}

fn shard_count(sharding: Option<Sharding>, ids: &[u64]) -> usize {
    let Some(Sharding { minishard_bits, shard_bits, preshift_bits, .. }) = sharding else { return 0 };
    let shard = |id: &u64| id >> preshift_bits >> minishard_bits & ((1 << shard_bits) - 1);
    ids.iter().map(shard).collect::<BTreeSet<_>>().len()
}

#[test]
fn what_is_left_out_is_named() {
    let mut mesh = shapes::torus(10, 10, 1.0, 0.4);
    let count = mesh.positions.len();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, [0.0, 0.0, 1.0].repeat(count)));
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, [0.5, 0.0, 1.0].repeat(count)));
    let (segment, report) = written(&mesh, options(1000, VertexBits::Ten));
    assert_eq!(segment.lods.len(), 1);
    assert_eq!(
        report.left_out,
        [
            "left out: color_0 of vertices; meshes of Neuroglancer are positions and triangles",
            "left out: normal of vertices; meshes of Neuroglancer are positions and triangles"
        ]
    );
}

#[test]
fn segments_are_written_together_or_not_at_all() {
    let (folder, mut file) = built(&shapes::torus(10, 10, 1.0, 0.4));
    let output = folder.path().join("meshes");
    let begin = || NeuroglancerWriter::new(&output, options(100, VertexBits::Ten)).unwrap();
    let mut writer = begin();
    writer.add(5, &mut file, &mut ignore_progress).unwrap();
    let twice = writer.add(5, &mut file, &mut ignore_progress).unwrap_err();
    assert_eq!(twice.to_string(), "segment 5: there are two meshes of this segment");
    drop(writer);
    assert!(!output.exists());
    let mut writer = begin();
    writer.add(5, &mut file, &mut ignore_progress).unwrap();
    writer.finish().unwrap();
    let archive = NeuroglancerWriter::new(&folder.path().join("a.3tz"), NeuroglancerOptions::default());
    assert!(matches!(archive, Err(TilesError::Place { .. })));
    // Its own output may be replaced, and nothing else.
    let mut writer = begin();
    let stopped = writer.add(6, &mut file, &mut |_| std::ops::ControlFlow::Break(()));
    assert!(matches!(stopped, Err(TilesError::Cancelled(_))));
    drop(writer);
    Segment::read(&output, 5).check();
    fs::write(output.join("info"), "{}").unwrap();
    let refused = NeuroglancerWriter::new(&output, NeuroglancerOptions::default());
    assert!(matches!(refused, Err(TilesError::Place { .. })));
    let hidden = |name: &std::ffi::OsString| name.to_string_lossy().starts_with(".striata");
    assert!(!fs::read_dir(folder.path()).unwrap().any(|file| hidden(&file.unwrap().file_name())));
}

#[test]
fn nasty_meshes_become_valid_segments() {
    for (name, mesh) in nasty() {
        let Some((folder, mut file)) = try_built(&mesh) else { continue };
        for (fragment_triangles, bits) in [(20, VertexBits::Ten), (100, VertexBits::Sixteen)] {
            let output = folder.path().join("meshes");
            let mut writer = NeuroglancerWriter::new(&output, options(fragment_triangles, bits)).unwrap();
            match writer.add(1, &mut file, &mut ignore_progress) {
                Ok(()) => {
                    writer.finish().unwrap();
                    Segment::read(&output, 1).check();
                }
                Err(TilesError::Empty { .. }) => {}
                Err(error) => assert_eq!(name, "coordinates around 1e38", "{error}"),
            }
        }
    }
}
