//! Accessors: typed arrays in buffers, optionally interleaved or sparse. Every bound is checked before a
//! byte is read.

use std::ops::Deref;

use super::component_type::GltfComponentType;
use super::document::GltfDocument;
use super::json::JsonNode;
use crate::error::{Fault, Place};

/// Number and types of an accessor's elements.
#[derive(Clone)]
pub(crate) struct AccessorShape {
    pub count: usize,
    pub component_count: usize,
    pub(super) component: GltfComponentType,
    pub(super) normalized: bool,
    path: String,
}

/// Checked accessor: all its elements lie within `bytes`.
pub(crate) struct Accessor<'a> {
    pub(super) shape: AccessorShape,
    /// Bytes from the first element on, or [`None`] if all elements are initially zero.
    pub(super) bytes: Option<&'a [u8]>,
    pub(super) stride: usize,
    pub(super) sparse: Option<Sparse<'a>>,
}

/// Replacements for some elements of the array.
pub(super) struct Sparse<'a> {
    pub count: usize,
    pub index_type: GltfComponentType,
    indices: &'a [u8],
    pub values: &'a [u8],
    element_bytes: usize,
}

/// Reads and checks accessor `index`; `from` is the value that refers to it.
pub(super) fn accessor<'a>(
    document: &'a GltfDocument<'_>,
    index: u64,
    from: &JsonNode<'_>,
) -> Result<Accessor<'a>, Fault> {
    let at = document.item("accessors", index, from)?;
    let shape = AccessorShape::parse(document, &at)?;
    let (bytes, stride) = match at.unsigned("bufferView")? {
        Some(view) => {
            let (bytes, stride) = document.view(view, &at)?;
            let (offset, stride) = shape.place(&at, bytes.len() as u64, stride)?;
            (Some(&bytes[offset..]), stride)
        }
        None => (None, shape.element_bytes()),
    };
    let sparse = at.get("sparse").map(|at| sparse(document, &at, &shape)).transpose()?;
    Ok(Accessor { shape, bytes, stride, sparse })
}

impl AccessorShape {
    pub(super) fn parse(document: &GltfDocument<'_>, at: &JsonNode<'_>) -> Result<Self, Fault> {
        let component = component_type(at)?;
        let component_count = component_count(at, component)?;
        let count = at.required_unsigned("count")?;
        let Some(count) = usize::try_from(count).ok().filter(|_| count <= document.max_elements) else {
            return Err(at.fault(format!("{count} elements are more than can be handled")));
        };
        if at.get("bufferView").is_none() && count as u64 > document.input_bytes {
            let reason = format!("{count} zeros in a file of {} bytes", document.input_bytes);
            return Err(at.fault(reason));
        }
        let (normalized, path) = (at.flag("normalized"), at.path.clone());
        Ok(Self { count, component_count, component, normalized, path })
    }

    /// Creates a fault at this accessor.
    pub(crate) fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::Malformed(Place::Json(self.path.clone()), reason.into())
    }

    /// Returns the size of an element in bytes.
    pub(super) fn element_bytes(&self) -> usize {
        self.component_count * self.component.bytes()
    }

    /// Returns the place of the first element in a view of `view_bytes`, and the distance of two elements, if
    /// all elements fit into the view.
    pub(super) fn place(
        &self,
        at: &JsonNode<'_>,
        view_bytes: u64,
        stride: Option<usize>,
    ) -> Result<(usize, usize), Fault> {
        let element_bytes = self.element_bytes();
        let stride = stride.unwrap_or(element_bytes);
        if stride < element_bytes {
            let reason = format!("elements of {element_bytes} bytes overlap at a stride of {stride}");
            return Err(at.fault(reason));
        }
        let offset = elements(at, view_bytes, self.count, [stride, element_bytes])?;
        Ok((offset, stride))
    }
}

impl Deref for Accessor<'_> {
    type Target = AccessorShape;

    fn deref(&self) -> &AccessorShape {
        &self.shape
    }
}

fn component_type(at: &JsonNode<'_>) -> Result<GltfComponentType, Fault> {
    let number = at.required_unsigned("componentType")?;
    GltfComponentType::from_number(number)
        .ok_or_else(|| at.fault(format!("no component type is numbered {number}")))
}

fn component_count(at: &JsonNode<'_>, component: GltfComponentType) -> Result<usize, Fault> {
    let count = match at.text("type") {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" | "MAT2" => 4,
        "MAT3" => 9,
        "MAT4" => 16,
        other => {
            return Err(at.fault(format!("no accessor type is called `{}`", super::uri::shortened(other))));
        }
    };
    if at.text("type").starts_with("MAT") && component.bytes() < 4 {
        // Columns of such matrices are padded.
        let what = "a matrix of small integers".to_owned();
        return Err(Fault::Unsupported(Place::Json(at.path.clone()), what));
    }
    Ok(count)
}

/// Returns the offset that `at` declares, if `count` elements fit into the bytes of its view from there on.
fn elements(
    at: &JsonNode<'_>,
    view_bytes: u64,
    count: usize,
    [stride, element_bytes]: [usize; 2],
) -> Result<usize, Fault> {
    let offset = at.unsigned("byteOffset")?.unwrap_or(0);
    let length = if count == 0 { 0 } else { (count as u64 - 1) * stride as u64 + element_bytes as u64 };
    match offset.checked_add(length).filter(|&end| end <= view_bytes) {
        Some(_) => Ok(offset as usize),
        None => {
            let reason = format!(
                "{count} elements from byte {offset} on take {length} bytes, but the view has {view_bytes}"
            );
            Err(at.fault(reason))
        }
    }
}

fn sparse<'a>(
    document: &'a GltfDocument<'_>,
    at: &JsonNode<'_>,
    shape: &AccessorShape,
) -> Result<Sparse<'a>, Fault> {
    let count = at.required_unsigned("count")?;
    if count > shape.count as u64 {
        return Err(at.fault(format!("{count} replacements for {} elements", shape.count)));
    }
    let count = count as usize;
    let part = |key: &str| at.get(key).ok_or_else(|| at.fault(format!("`{key}` is missing")));
    let (index_at, value_at) = (part("indices")?, part("values")?);
    let index_type = component_type(&index_at)?;
    if !matches!(index_type, GltfComponentType::U8 | GltfComponentType::U16 | GltfComponentType::U32) {
        return Err(index_at.fault("indices must be unsigned integers"));
    }
    let bytes_of = |at: &JsonNode<'_>, size: usize| {
        let (bytes, _) = document.view(at.required_unsigned("bufferView")?, at)?;
        elements(at, bytes.len() as u64, count, [size, size]).map(|offset| &bytes[offset..])
    };
    let indices = bytes_of(&index_at, index_type.bytes())?;
    let values = bytes_of(&value_at, shape.element_bytes())?;
    let element_bytes = shape.element_bytes();
    let sparse = Sparse { count, index_type, indices, values, element_bytes };
    if let Some(index) = sparse.indices().find(|&index| index >= shape.count) {
        return Err(index_at.fault(format!("element {index} of {} does not exist", shape.count)));
    }
    Ok(sparse)
}

/// Characters of JSON that a sparse accessor takes in addition to those of another one.
const SPARSE_JSON_BYTES: usize = 200;

impl Sparse<'_> {
    /// Bytes of the numbers of the elements.
    pub(super) fn index_bytes(&self) -> &[u8] {
        &self.indices[..self.count * self.index_type.bytes()]
    }

    /// Bytes of the elements.
    pub(super) fn value_bytes(&self) -> &[u8] {
        &self.values[..self.count * self.element_bytes]
    }

    /// Whether it takes fewer bytes than all elements of its accessor, and its numbers rise as they must.
    pub(super) fn is_smaller_than(&self, shape: &AccessorShape) -> bool {
        let bytes = self.index_bytes().len() + self.value_bytes().len() + SPARSE_JSON_BYTES;
        bytes < shape.count * shape.element_bytes() && self.indices().is_sorted_by(|a, b| a < b)
    }

    /// Returns the numbers of the elements that are replaced.
    pub(super) fn indices(&self) -> impl Iterator<Item = usize> {
        let size = self.index_type.bytes();
        self.indices.chunks_exact(size).take(self.count).map(move |chunk| {
            let mut word = [0; 4];
            word[..size].copy_from_slice(chunk);
            u32::from_le_bytes(word) as usize
        })
    }
}

impl<'a> Accessor<'a> {
    /// Creates an accessor of decompressed elements, which are tightly packed.
    pub(super) fn packed(
        count: usize,
        [component_count, stride]: [usize; 2],
        component: GltfComponentType,
        bytes: &'a [u8],
        path: &str,
    ) -> Self {
        let shape =
            AccessorShape { count, component_count, component, normalized: false, path: path.to_owned() };
        Self { shape, bytes: Some(bytes), stride, sparse: None }
    }
}

impl Accessor<'_> {
    /// Returns all numbers as floats, normalized integers as fractions.
    pub(crate) fn floats(&self) -> Vec<f32> {
        let one = |x: f32, most: f32| if self.normalized { (x / most).max(-1.0) } else { x };
        match self.component {
            GltfComponentType::F32 => self.read::<4, _>(f32::from_le_bytes),
            GltfComponentType::I8 => self.read::<1, _>(|[b]| one(f32::from(b as i8), 127.0)),
            GltfComponentType::U8 => self.read::<1, _>(|[b]| one(f32::from(b), 255.0)),
            GltfComponentType::I16 => self.read::<2, _>(|b| one(f32::from(i16::from_le_bytes(b)), 32767.0)),
            GltfComponentType::U16 => self.read::<2, _>(|b| one(f32::from(u16::from_le_bytes(b)), 65535.0)),
            GltfComponentType::U32 => self.read::<4, _>(|b| u32::from_le_bytes(b) as f32),
        }
    }

    /// Returns all numbers as integers, or [`None`] if they are signed or floats.
    pub(super) fn integers(&self) -> Option<Vec<u32>> {
        Some(match self.component {
            GltfComponentType::U8 => self.read::<1, _>(|[b]| u32::from(b)),
            GltfComponentType::U16 => self.read::<2, _>(|b| u32::from(u16::from_le_bytes(b))),
            GltfComponentType::U32 => self.read::<4, _>(u32::from_le_bytes),
            GltfComponentType::I8 | GltfComponentType::I16 | GltfComponentType::F32 => return None,
        })
    }

    /// Returns the bytes of all elements, without gaps.
    pub(super) fn packed_bytes(&self) -> Vec<u8> {
        match self.component.bytes() {
            1 => self.read::<1, _>(|[byte]| byte),
            2 => self.read::<2, _>(|bytes| bytes).into_flattened(),
            _ => self.read::<4, _>(|bytes| bytes).into_flattened(),
        }
    }

    /// Returns all numbers in their own type; `SIZE` must be the component's size.
    pub(super) fn read<const SIZE: usize, T: Clone>(&self, number: impl Fn([u8; SIZE]) -> T) -> Vec<T> {
        debug_assert_eq!(SIZE, self.component.bytes(), "numbers are read in their own size");
        let n = self.component_count;
        let mut out = Vec::with_capacity(self.count * n);
        match self.bytes {
            None => out.resize(self.count * n, number([0; SIZE])),
            Some(bytes) if self.stride == n * SIZE => {
                let (chunks, _) = bytes[..self.count * self.stride].as_chunks::<SIZE>();
                out.extend(chunks.iter().map(|&chunk| number(chunk)));
            }
            Some(bytes) => {
                for element in bytes.chunks(self.stride).take(self.count) {
                    let (chunks, _) = element[..n * SIZE].as_chunks::<SIZE>();
                    out.extend(chunks.iter().map(|&chunk| number(chunk)));
                }
            }
        }
        if let Some(sparse) = &self.sparse {
            let (values, _) = sparse.values.as_chunks::<SIZE>();
            for (index, value) in sparse.indices().zip(values.chunks_exact(n)) {
                for (slot, &chunk) in out[index * n..(index + 1) * n].iter_mut().zip(value) {
                    *slot = number(chunk);
                }
            }
        }
        out
    }
}
