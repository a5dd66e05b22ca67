//! Arrays of a Zarr v3 store: one shard each, with chunks that are compressed one by one.
//!
//! ```text
//!  c/0/0: chunk | chunk | ... | place and size of each chunk | checksum of these
//! ```

use std::io::{self, Write as _};

use flate2::Compression;
use flate2::write::GzEncoder;
use rayon::prelude::*;
use serde_json::{Value, json};
use striata::mesh::LayerData;

use crate::sink::FolderSink;

/// Rows of a chunk, by which prefixes are read.
const CHUNK_ROWS: usize = 4096;
/// Compression of chunks, from 0 to 9.
const LEVEL: u32 = 6;

/// Numbers in rows, and what describes them.
pub(super) struct ZarrArray {
    /// Number of numbers in a row; `None` for a list of numbers.
    width: Option<usize>,
    data: LayerData,
    attributes: Value,
}

impl ZarrArray {
    /// A list of numbers.
    pub(super) fn list(data: LayerData) -> Self {
        Self { width: None, data, attributes: json!({}) }
    }

    /// Rows of numbers.
    pub(super) fn rows(data: LayerData, width: usize) -> Self {
        Self { width: Some(width), data, attributes: json!({}) }
    }

    pub(super) fn with_attributes(self, attributes: Value) -> Self {
        Self { attributes, ..self }
    }

    /// Writes the array to a folder of the store.
    pub(super) fn put(&self, sink: &mut FolderSink, path: &str) -> io::Result<()> {
        let count = self.data.len() / self.width.unwrap_or(1).max(1);
        let shape = |rows: usize| [Some(rows), self.width].into_iter().flatten().collect::<Vec<_>>();
        let fill = if self.data.is_float() { json!(0.0) } else { json!(0) };
        let little = json!({ "name": "bytes", "configuration": { "endian": "little" } });
        let gzip = json!({ "name": "gzip", "configuration": { "level": LEVEL } });
        let shards = json!({
            "chunk_shape": shape(CHUNK_ROWS),
            "codecs": [little, gzip],
            "index_codecs": [little, { "name": "crc32c" }],
            "index_location": "end",
        });
        let shard_rows = count.max(1).next_multiple_of(CHUNK_ROWS);
        let node = json!({
            "zarr_format": 3,
            "node_type": "array",
            "shape": shape(count),
            "data_type": data_type(&self.data),
            "chunk_grid": { "name": "regular", "configuration": { "chunk_shape": shape(shard_rows) } },
            "chunk_key_encoding": { "name": "default", "configuration": { "separator": "/" } },
            "fill_value": fill,
            "codecs": [{ "name": "sharding_indexed", "configuration": shards }],
            "attributes": self.attributes,
        });
        sink.open(&format!("{path}/zarr.json"))?.write_all(node.to_string().as_bytes())?;
        if count == 0 {
            return Ok(());
        }
        let key = if self.width.is_some() { "c/0/0" } else { "c/0" };
        sink.open(&format!("{path}/{key}"))?.write_all(&self.shard(count)?)
    }

    fn shard(&self, count: usize) -> io::Result<Vec<u8>> {
        let bytes = self.data.as_bytes();
        let chunk_bytes = bytes.len() / count * CHUNK_ROWS;
        let compressed = |chunk: &[u8]| {
            let mut encoder = GzEncoder::new(Vec::new(), Compression::new(LEVEL));
            encoder.write_all(chunk)?;
            // Chunks are complete, whatever the number of rows.
            encoder.write_all(&vec![0; chunk_bytes - chunk.len()])?;
            encoder.finish()
        };
        let chunks: Vec<io::Result<Vec<u8>>> = bytes.par_chunks(chunk_bytes).map(compressed).collect();
        let (mut shard, mut index) = (Vec::new(), Vec::new());
        for chunk in chunks {
            let chunk = chunk?;
            index.extend([shard.len() as u64, chunk.len() as u64].into_iter().flat_map(u64::to_le_bytes));
            shard.extend(chunk);
        }
        shard.extend(&index);
        shard.extend(crc32c(&index).to_le_bytes());
        Ok(shard)
    }
}

fn data_type(data: &LayerData) -> &'static str {
    match data {
        LayerData::F32(_) => "float32",
        LayerData::F64(_) => "float64",
        LayerData::U8(_) => "uint8",
        LayerData::I8(_) => "int8",
        LayerData::U16(_) => "uint16",
        LayerData::I16(_) => "int16",
        LayerData::U32(_) => "uint32",
        LayerData::I32(_) => "int32",
    }
}

/// Checksum of the index of a shard (Castagnoli), which is short.
fn crc32c(bytes: &[u8]) -> u32 {
    let step = |crc: u32| if crc & 1 == 1 { crc >> 1 ^ 0x82f6_3b78 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), |crc, _| step(crc)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checksums_are_those_of_castagnoli() {
        assert_eq!(crc32c(b"123456789"), 0xe306_9283);
    }
}
