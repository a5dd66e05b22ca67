//! The codecs of meshoptimizer followed by zstd, as its author recommends.

use std::time::Instant;

use striata::mesh::{Bounds, IndexedMesh};

use super::coded::{CodedMesh, fastest};
use striata_command::failure::Failure;

/// Name of its files in the report.
pub(super) const NAME: &str = "meshoptimizer + zstd";

const ZSTD_LEVEL: i32 = 19;

/// A position as integers; the codecs require vertices of a multiple of four bytes.
type Vertex = [u16; 4];

/// Encodes positions and triangles, in the order that suits the codecs best.
///
/// # Errors
/// If a codec fails.
pub(super) fn code(mesh: &IndexedMesh, bits: u32) -> Result<CodedMesh, Failure> {
    let started = Instant::now();
    let bounds = mesh.bounds().unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
    let extent = (0..3).map(|i| f64::from(bounds.max[i]) - f64::from(bounds.min[i])).fold(0.0, f64::max);
    let step = (extent / f64::from((1u32 << bits) - 1)).max(f64::MIN_POSITIVE);
    let quantized = |p: &[f32; 3]| {
        let coordinate = |i: usize| ((f64::from(p[i]) - f64::from(bounds.min[i])) / step).round() as u16;
        [coordinate(0), coordinate(1), coordinate(2), 0]
    };
    let vertices: Vec<Vertex> = mesh.positions.iter().map(quantized).collect();
    let indices = meshopt::optimize_vertex_cache(mesh.triangles.as_flattened(), vertices.len());
    let remap = meshopt::optimize_vertex_fetch_remap(&indices, vertices.len());
    let indices = meshopt::remap_index_buffer(Some(&indices), indices.len(), &remap);
    let vertices = meshopt::remap_vertex_buffer(&vertices, vertices.len(), &remap);
    let parts = [
        meshopt::encode_vertex_buffer(&vertices).map_err(failed)?,
        meshopt::encode_index_buffer(&indices, vertices.len()).map_err(failed)?,
    ];
    let packed = parts.map(|part| zstd::bulk::compress(&part, ZSTD_LEVEL).map(|bytes| (bytes, part.len())));
    let [points, corners] = packed;
    let (points, corners) = (points.map_err(failed)?, corners.map_err(failed)?);
    let encode_secs = started.elapsed().as_secs_f64();
    let decode = || -> Result<(Vec<Vertex>, Vec<u32>), Failure> {
        let unpacked =
            |(bytes, length): &(Vec<u8>, usize)| zstd::bulk::decompress(bytes, *length).map_err(failed);
        let points = meshopt::decode_vertex_buffer(&unpacked(&points)?, vertices.len()).map_err(failed)?;
        let corners = meshopt::decode_index_buffer(&unpacked(&corners)?, indices.len()).map_err(failed)?;
        Ok((points, corners))
    };
    let decode_secs = fastest(|| {
        let started = Instant::now();
        decode().map(|_| started.elapsed().as_secs_f64())
    })?;
    let (vertices, indices) = decode()?;
    let position =
        |v: &Vertex| std::array::from_fn(|i| (f64::from(bounds.min[i]) + f64::from(v[i]) * step) as f32);
    let mesh = IndexedMesh {
        positions: vertices.iter().map(position).collect(),
        triangles: indices.as_chunks().0.to_vec(),
        ..IndexedMesh::default()
    };
    Ok(CodedMesh { bytes: points.0.len() + corners.0.len(), mesh, encode_secs, decode_secs })
}

fn failed(error: impl std::fmt::Display) -> Failure {
    Failure::internal(format!("{NAME}: {error}"))
}
