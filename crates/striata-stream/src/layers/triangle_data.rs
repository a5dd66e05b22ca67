//! Layers of triangles: coded without loss after the last chunk, when all triangles are known.
//!
//! The rows are in the order of [`sorted_triangle_order`], which depends on the vertices of a stream only, so a
//! reader brings them into the order of its triangles. Each number is coded as the difference from the one before
//! it, since triangles in this order are close to each other.

use striata::mesh::{AttributeLayer, IndexedMesh, layers_from_sorted, sorted_triangle_order};

use super::form::LayerForm;
use super::options::LayerOptions;
use crate::entropy::{QuickNumber, RangeReader, RangeWriter, Rate};
use crate::format::error::StreamDefect;

/// `n` bytes contain at most `n + 1` times this number of integers. A writer that needs fewer bytes appends zeros.
const MAX_NUMBERS_PER_BYTE: u64 = 256;

/// Entry of the header: the layers and where their bytes end.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TriangleData {
    /// Kinds of the layers; all are exact.
    pub forms: Vec<LayerForm>,
    /// Number of bytes after the last chunk.
    pub bytes: u32,
    /// CRC-32 of these bytes.
    pub checksum: u32,
}

/// Codes the layers of the triangles of a mesh whose vertices are in the order of the stream.
pub(crate) fn encode(mesh: &IndexedMesh) -> Option<(TriangleData, Vec<u8>)> {
    if mesh.triangle_layers.is_empty() {
        return None;
    }
    let options = LayerOptions::default().with_lossless(true);
    let order = sorted_triangle_order(mesh);
    let mut writer = RangeWriter::new();
    let mut forms = Vec::with_capacity(mesh.triangle_layers.len());
    let mut number_count = 0;
    for layer in &mesh.triangle_layers {
        let form = LayerForm::of(layer, &options);
        let integers = form.integers(&layer.gather(&order));
        let width = form.integer_count();
        let mut model = QuickNumber::new(width, Rate::Quick);
        for (at, &value) in integers.iter().enumerate() {
            let before = at.checked_sub(width).map_or(0, |before| integers[before]);
            model.signed(&mut writer, at % width, i64::from(value) - i64::from(before));
        }
        number_count += integers.len() as u64;
        forms.push(form);
    }
    let (mut bytes, _) = writer.finish();
    bytes.resize(bytes.len().max((number_count / MAX_NUMBERS_PER_BYTE) as usize), 0);
    let checksum = crc32fast::hash(&bytes);
    let length = u32::try_from(bytes.len()).ok()?;
    Some((TriangleData { forms, bytes: length, checksum }, bytes))
}

impl TriangleData {
    /// Decodes the layers, in sorted order.
    ///
    /// # Errors
    /// [`StreamDefect`] if the checksum differs, or the bytes are too few for the number of triangles.
    pub(crate) fn decode(
        &self,
        bytes: &[u8],
        triangle_count: usize,
        chunk: usize,
        offset: u64,
    ) -> Result<Vec<AttributeLayer>, StreamDefect> {
        let found = crc32fast::hash(bytes);
        if found != self.checksum {
            return Err(StreamDefect::Checksum { chunk, offset, found, expected: self.checksum });
        }
        let width: usize = self.forms.iter().map(LayerForm::integer_count).sum();
        let most = (bytes.len() as u64 + 1).saturating_mul(MAX_NUMBERS_PER_BYTE);
        let expected = (width as u64).saturating_mul(triangle_count as u64);
        if expected > most {
            return Err(StreamDefect::Count { what: "numbers of triangles", found: most, expected });
        }
        let mut reader = RangeReader::new(bytes, true);
        Ok(self.forms.iter().map(|form| decode_layer(form, &mut reader, triangle_count)).collect())
    }
}

fn decode_layer(form: &LayerForm, reader: &mut RangeReader<'_>, triangle_count: usize) -> AttributeLayer {
    let width = form.integer_count();
    let mut model = QuickNumber::new(width, Rate::Quick);
    let mut integers: Vec<i32> = Vec::with_capacity(width * triangle_count);
    for at in 0..width * triangle_count {
        let before = at.checked_sub(width).map_or(0, |before| integers[before]);
        integers.push(i64::from(before).wrapping_add(model.signed(reader, at % width, 0)) as i32);
    }
    let mut layer = form.empty_layer();
    form.append(&integers, &mut layer.data);
    layer
}

/// Gives a decoded mesh the layers.
pub(crate) fn attach(mesh: &mut IndexedMesh, sorted: &[AttributeLayer]) {
    if !sorted.is_empty() {
        mesh.triangle_layers = layers_from_sorted(mesh, sorted);
    }
}
