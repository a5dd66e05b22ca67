//! GeoTIFF rasters: strips and tiles of integers or floats, decoded as they are needed.

use std::collections::VecDeque;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::sync::{Arc, Mutex};

use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;

use super::raster::{Raster, RasterPlacement, malformed};
use crate::ReadError;

/// Strips and tiles that stay decoded.
const MAX_CHUNKS: usize = 64;
/// Keys of the geo directory.
const MODEL_TYPE: u64 = 1024;
const RASTER_TYPE: u64 = 1025;
const GEOGRAPHIC_TYPE: u64 = 2048;
const PROJECTED_TYPE: u64 = 3072;
/// Metadata of GDAL, as XML.
const GDAL_METADATA: Tag = Tag::Unknown(42_112);
/// Larger heights stand for none in files that do not name a value for that, such as -3.4e38.
const LARGEST_HEIGHT: f32 = 1e30;

/// Samples that often stand for none in files that do not say so. They are kept, since they may be heights.
const USUAL_SENTINELS: [f32; 3] = [-9999.0, -32_767.0, -32_768.0];

/// Number of different values beyond that which stand for no height.
const MAX_SENTINELS: usize = 2;

/// A GeoTIFF file.
pub(super) struct GeoTiff {
    name: String,
    size: [u64; 2],
    /// Size of a strip or tile, and how many there are in a row.
    chunk: [u64; 2],
    chunks_across: u64,
    /// Samples that stand for no height: what the file says, and what the user says.
    nodata: [Option<f64>; 2],
    /// Factor and summand that make heights of samples.
    scale: [f64; 2],
    /// Whether the first row of the file is the southernmost.
    is_from_south: bool,
    placement: RasterPlacement,
    state: Mutex<State>,
}

struct State {
    decoder: Decoder<BufReader<File>>,
    /// Decoded chunks, the last used first.
    chunks: VecDeque<(u32, Arc<TiffChunk>)>,
    /// Samples found so far that are too large for heights, and taken for none.
    sentinels: Vec<f32>,
    /// Which of [`USUAL_SENTINELS`] have been found.
    has_usual: [bool; USUAL_SENTINELS.len()],
}

struct TiffChunk {
    width: u64,
    values: Vec<f32>,
}

impl GeoTiff {
    pub(super) fn open(path: &Path, nodata: Option<f64>) -> Result<Self, ReadError> {
        let name = path.display().to_string();
        let file = File::open(path).map_err(|source| ReadError::Io { file: name.clone(), source })?;
        let wrong = |error: tiff::TiffError| malformed(&name, error.to_string());
        let mut decoder = Decoder::new(BufReader::new(file)).map_err(wrong)?;
        let (width, height) = decoder.dimensions().map_err(wrong)?;
        let samples = decoder.find_tag_unsigned::<u16>(Tag::SamplesPerPixel).map_err(wrong)?.unwrap_or(1);
        if samples != 1 {
            return Err(malformed(&name, format!("{samples} values per pixel; heights have one")));
        }
        let bits = decoder.find_tag_unsigned::<u16>(Tag::BitsPerSample).map_err(wrong)?.unwrap_or(1);
        if bits < 8 {
            return Err(malformed(&name, format!("{bits} bits per sample; heights have 8, 16, 32 or 64")));
        }
        if width < 2 || height < 2 {
            return Err(malformed(&name, format!("{width} by {height} samples are no surface")));
        }
        let (chunk_width, chunk_height) = decoder.chunk_dimensions();
        let size = [u64::from(width), u64::from(height)];
        let chunk = [u64::from(chunk_width.max(1)), u64::from(chunk_height.max(1))];
        let own = decoder.get_tag_ascii_string(Tag::GdalNodata).ok();
        let own = own.and_then(|text| text.trim_matches(['\0', ' ']).parse().ok());
        let (placement, is_from_south) = placement(&mut decoder, &name, size)?;
        let items = decoder.get_tag_ascii_string(GDAL_METADATA).unwrap_or_default();
        let scale = [item(&items, "scale").unwrap_or(1.0), item(&items, "offset").unwrap_or(0.0)];
        if !(scale[0] != 0.0 && scale.iter().all(|x| x.is_finite())) {
            let reason =
                format!("heights are samples times {} plus {}, which is no height", scale[0], scale[1]);
            return Err(malformed(&name, reason));
        }
        Ok(Self {
            scale,
            is_from_south,
            nodata: [own, nodata],
            chunks_across: size[0].div_ceil(chunk[0]),
            name,
            size,
            chunk,
            placement,
            state: Mutex::new(State {
                decoder,
                chunks: VecDeque::new(),
                sentinels: Vec::new(),
                has_usual: [false; 3],
            }),
        })
    }

    /// Takes a sample that is too large for a height for none. Programs write one or two such values; more of
    /// them are damage.
    fn sentinels_with(&self, value: f32, [column, row]: [u64; 2]) -> Result<Vec<f32>, ReadError> {
        let failed = || malformed(&self.name, "another thread failed while it read the file");
        let known = &mut self.state.lock().map_err(|_| failed())?.sentinels;
        let is_named = self.nodata.iter().flatten().any(|&named| named as f32 == value);
        if !is_named && !known.contains(&value) {
            if known.len() == MAX_SENTINELS {
                let reason =
                    format!("the sample in column {column}, row {row} is {value:e}, which is no height");
                return Err(malformed(&self.name, reason));
            }
            known.push(value);
        }
        Ok(known.iter().copied().chain(is_named.then_some(value)).collect())
    }

    /// A decoded strip or tile.
    fn chunk(&self, index: u32) -> Result<Arc<TiffChunk>, ReadError> {
        let failed = || malformed(&self.name, "another thread failed while it read the file");
        let mut state = self.state.lock().map_err(|_| failed())?;
        if let Some(at) = state.chunks.iter().position(|(known, _)| *known == index)
            && let Some(entry) = state.chunks.remove(at)
        {
            let chunk = Arc::clone(&entry.1);
            state.chunks.push_front(entry);
            return Ok(chunk);
        }
        let wrong = |error: tiff::TiffError| malformed(&self.name, format!("block {index}: {error}"));
        let (width, _) = state.decoder.chunk_data_dimensions(index);
        let values = values(state.decoder.read_chunk(index).map_err(wrong)?)
            .ok_or_else(|| malformed(&self.name, "its samples have a type that heights do not have"))?;
        let chunk = Arc::new(TiffChunk { width: u64::from(width), values });
        state.chunks.push_front((index, Arc::clone(&chunk)));
        state.chunks.truncate(MAX_CHUNKS);
        Ok(chunk)
    }
}

/// Samples as floats; `None` for types other than those of heights.
fn values(result: DecodingResult) -> Option<Vec<f32>> {
    Some(match result {
        DecodingResult::U8(v) => v.into_iter().map(f32::from).collect(),
        DecodingResult::I8(v) => v.into_iter().map(f32::from).collect(),
        DecodingResult::U16(v) => v.into_iter().map(f32::from).collect(),
        DecodingResult::I16(v) => v.into_iter().map(f32::from).collect(),
        DecodingResult::U32(v) => v.into_iter().map(|x| x as f32).collect(),
        DecodingResult::I32(v) => v.into_iter().map(|x| x as f32).collect(),
        DecodingResult::F32(v) => v,
        DecodingResult::F64(v) => v.into_iter().map(|x| x as f32).collect(),
        _ => return None,
    })
}

/// The number of the item with a role in the metadata of GDAL.
fn item(xml: &str, role: &str) -> Option<f64> {
    let (_, after) = xml.split_once(&format!("role=\"{role}\""))?;
    let (_, content) = after.split_once('>')?;
    content.split_once('<')?.0.trim().parse().ok()
}

/// Reads the place of the samples, and whether rows begin in the south; one unit apart if the file does not say.
fn placement(
    decoder: &mut Decoder<BufReader<File>>,
    name: &str,
    size: [u64; 2],
) -> Result<(RasterPlacement, bool), ReadError> {
    let scale = decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).ok();
    let tie = decoder.get_tag_f64_vec(Tag::ModelTiepointTag).ok();
    // The identity is what programs write that know no place.
    let is_identity = |t: &[f64]| matches!(t, [1.0, 0.0, _, 0.0, 0.0, 1.0, _, 0.0, ..]);
    let transform = decoder.get_tag_f64_vec(Tag::ModelTransformationTag).ok();
    let transform = transform.filter(|transform| !is_identity(transform));
    let keys = decoder.get_tag_u64_vec(Tag::GeoKeyDirectoryTag).unwrap_or_default();
    let key = |id: u64| keys.chunks_exact(4).skip(1).find(|entry| entry[0] == id).map(|entry| entry[3]);
    let is_geographic = key(MODEL_TYPE) == Some(2);
    let epsg = if is_geographic { key(GEOGRAPHIC_TYPE) } else { key(PROJECTED_TYPE) };
    let epsg = epsg.filter(|&code| code > 0 && code < 32_767).map(|code| code as u32);
    let (west, north, step) = match (scale.as_deref(), tie.as_deref(), transform.as_deref()) {
        (Some([sx, sy, ..]), Some([i, j, _, x, y, ..]), _) => (x - i * sx, y + j * sy, [*sx, *sy]),
        (_, _, Some([a, b, _, x, c, d, _, y, ..])) => {
            if *b != 0.0 || *c != 0.0 {
                return Err(malformed(name, "the raster is rotated, which is not supported"));
            }
            (*x, *y, [*a, -d])
        }
        _ => (0.0, (size[1] - 1) as f64, [1.0; 2]),
    };
    let is_from_south = step[1] < 0.0;
    // The first row is then the southernmost.
    let north = if is_from_south { north - step[1] * (size[1] - 1) as f64 } else { north };
    let step = [step[0], step[1].abs()];
    if !(step.iter().all(|s| *s > 0.0 && s.is_finite()) && west.is_finite() && north.is_finite()) {
        return Err(malformed(name, "the distance of its samples is not a positive number"));
    }
    // Coordinates of a pixel that is an area are those of its corner; the sample is in its middle.
    let half = if key(RASTER_TYPE) == Some(2) || scale.is_none() && transform.is_none() { 0.0 } else { 0.5 };
    let down = if is_from_south { -half } else { half };
    let (west, north) = (west + half * step[0], north - down * step[1]);
    Ok((RasterPlacement { west, north, step, is_geographic, epsg }, is_from_south))
}

impl Raster for GeoTiff {
    fn name(&self) -> &str {
        &self.name
    }

    fn size(&self) -> [u64; 2] {
        self.size
    }

    fn placement(&self) -> &RasterPlacement {
        &self.placement
    }

    fn is_raw(&self) -> bool {
        false
    }

    fn remarks(&self) -> Vec<String> {
        let Ok(state) = self.state.lock() else { return Vec::new() };
        let mut voids = state.sentinels.clone();
        voids.sort_by(f32::total_cmp);
        let voids = voids.iter().map(|value| {
            format!(
                "samples of {value:e} are taken for none, although the file does not say what stands for that"
            )
        });
        let usual = USUAL_SENTINELS.iter().zip(state.has_usual).filter(|(_, found)| *found).map(|(value, _)| {
            format!("samples of {value} are heights here, but often stand for none: name the value to leave them out")
        });
        voids.chain(usual).collect()
    }

    fn read(&self, at: [u64; 2], [width, height]: [u64; 2]) -> Result<Vec<f32>, ReadError> {
        let mut heights = vec![f32::NAN; (width * height) as usize];
        let (mut sentinels, mut has_usual) = (Vec::new(), [false; USUAL_SENTINELS.len()]);
        let top = at[1];
        let at = if self.is_from_south { [at[0], self.size[1] - at[1] - height] } else { at };
        let row_of = |y: u64| if self.is_from_south { self.size[1] - 1 - y - top } else { y - top };
        let first = [at[0] / self.chunk[0], at[1] / self.chunk[1]];
        let last = [(at[0] + width - 1) / self.chunk[0], (at[1] + height - 1) / self.chunk[1]];
        for cy in first[1]..=last[1] {
            for cx in first[0]..=last[0] {
                let chunk = self.chunk((cy * self.chunks_across + cx) as u32)?;
                let corner = [cx * self.chunk[0], cy * self.chunk[1]];
                let rows = at[1].max(corner[1])..(at[1] + height).min(corner[1] + self.chunk[1]);
                for y in rows {
                    for x in at[0].max(corner[0])..(at[0] + width).min(corner[0] + chunk.width) {
                        let from = (y - corner[1]) * chunk.width + x - corner[0];
                        let Some(&value) = chunk.values.get(from as usize) else { continue };
                        if value.abs() > LARGEST_HEIGHT && value.is_finite() && !sentinels.contains(&value) {
                            sentinels = self.sentinels_with(value, [x, y])?;
                        }
                        // The file may name the sample with more digits than it has.
                        let is_named = || self.nodata.iter().flatten().any(|&named| named as f32 == value);
                        if value.abs() <= LARGEST_HEIGHT && !is_named() {
                            if let Some(at) = USUAL_SENTINELS.iter().position(|&usual| usual == value) {
                                has_usual[at] = true;
                            }
                            let value = f64::from(value) * self.scale[0] + self.scale[1];
                            heights[(row_of(y) * width + x - at[0]) as usize] = value as f32;
                        }
                    }
                }
            }
        }
        if has_usual != [false; 3]
            && let Ok(mut state) = self.state.lock()
        {
            has_usual.iter().zip(&mut state.has_usual).for_each(|(&found, known)| *known |= found);
        }
        Ok(heights)
    }
}
