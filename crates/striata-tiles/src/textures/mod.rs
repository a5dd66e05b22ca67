//! Textures of tiles: images out of memory, and an atlas for each material of a tile.
//!
//! ```text
//!  finest surface ──> texels in use, texel size ─┐
//!  images, one at a time ────────────────────────┴──> pyramids on disk ──> charts of a tile ──> atlas
//! ```
//!
//! The texel size of a level is a sixteenth of its error, or larger if its tiles would have more than a million texels;
//! the geometric error of the level is then sixteen texels. Texels are never smaller than those of the image.
//!
//! | file | what it does |
//! | --- | --- |
//! | `coverage.rs` | the texels that triangles reach |
//! | `regions.rs` | the charts of the whole mesh, and triangles with corners in several of them |
//! | `pyramid.rs` | reduced copies of an image on disk, and how pixels are read from them |
//! | `chart.rs` | the charts of a tile, their sizes and places |
//! | `atlas.rs` | the images of a tile, and its texture coordinates |

mod atlas;
mod chart;
mod coverage;
mod pyramid;
mod regions;

use std::collections::BTreeSet;
use std::io;
use std::path::Path;
use std::sync::Arc;

use serde_json::{Value, json};
use striata::mesh::{AttributeLayer, Image, IndexedMesh, Semantic};
use striata::{Progress, ProgressFn};
use striata_paged::{Metadata, PagedFile, PagedImage, StepTiers};
use striata_scene::drawn::{TextureReader, UvTransform, Wrap};
use striata_scene::textures::{
    AlphaUse, ImageFormat, ImageInfo, MAX_SIDE, RgbaImage, TextureRole, image_info, image_roles,
};

use crate::error::TilesError;
pub(crate) use atlas::DressedTile;
use coverage::Coverage;
use pyramid::{Pyramid, Scratch};
use regions::Regions;

/// Texels of the atlases of a tile, about.
const TILE_TEXELS: f64 = (1 << 20) as f64;
/// A texel is at most this fraction of the error of a tile.
pub(crate) const TEXELS_PER_ERROR: f64 = 16.0;
/// Triangles that are measured together, about.
const MEASURED_TRIANGLES: u64 = 1 << 20;
/// Bytes of an image that say which format it has.
const SIGNATURE_BYTES: usize = 16;

/// The textures of a mesh.
pub(crate) struct TextureSet {
    /// By material.
    materials: Vec<MaterialTextures>,
    /// By image; `None` if no material uses it, or it is missing.
    images: Vec<Option<StoredImage>>,
    scratch: Scratch,
    quality: u8,
}

/// A material and its textures.
struct MaterialTextures {
    /// The material without textures that are missing.
    material: Value,
    textures: Vec<MaterialTexture>,
    /// Set and transform of the texture coordinates; `None` if textures have different ones.
    coordinates: Option<(u8, UvTransform)>,
    /// Size of the largest image, texels, and its charts.
    size: [u32; 2],
    regions: Option<Arc<Regions>>,
    /// Area of the surface, and of its triangles in texels.
    areas: [f64; 2],
}

/// A texture of a material.
#[derive(Clone, Debug)]
struct MaterialTexture {
    /// JSON pointer to the reference.
    pointer: String,
    image: usize,
    wrap: [Wrap; 2],
    sampler: Value,
    set: u8,
    transform: UvTransform,
}

/// An image on disk.
struct StoredImage {
    name: String,
    pyramid: Pyramid,
    format: ImageFormat,
    keeps_alpha: bool,
    /// Place and number of the bytes of the file.
    file: (u64, usize),
}

impl TextureSet {
    /// Reads the textures of a mesh; `None` if no material has any.
    pub(crate) fn read(
        file: &mut PagedFile,
        tiers: &StepTiers,
        output: &Path,
        quality: u8,
        (warnings, progress): (&mut BTreeSet<String>, &mut ProgressFn<'_>),
    ) -> Result<Option<Self>, TilesError> {
        let metadata = file.metadata().clone();
        let list = |name: &str| metadata.appearance.get(name).cloned().unwrap_or_else(|| json!([]));
        let names: Vec<Value> = metadata.images.iter().map(|_| json!({})).collect();
        let document = json!({
            "materials": list("materials"),
            "textures": list("textures"),
            "samplers": list("samplers"),
            "images": names,
        });
        let (signatures, infos) = signatures(file, &metadata, warnings)?;
        let reader = TextureReader { document: &document, images: &signatures };
        let materials = document["materials"].as_array().into_iter().flatten();
        let mut materials: Vec<MaterialTextures> = materials
            .map(|material| MaterialTextures::read(material, &reader, &infos, &metadata, warnings))
            .collect();
        if materials.iter().all(|material| material.textures.is_empty()) {
            return Ok(None);
        }
        let mut coverages: Vec<Option<Coverage>> =
            infos.iter().map(|info| info.map(|info| Coverage::new([info.width, info.height]))).collect();
        for texture in materials.iter().filter(|m| m.coordinates.is_none()).flat_map(|m| &m.textures) {
            if let Some(Some(coverage)) = coverages.get_mut(texture.image) {
                coverage.is_whole = true;
            }
        }
        measure(file, tiers, &mut materials, &mut coverages, progress)?;
        let failed = |source| TilesError::Io { path: output.to_owned(), source };
        let folder =
            output.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut scratch = Scratch::new(folder).map_err(failed)?;
        let roles = image_roles(&document);
        let total = infos.len() as u64;
        let mut images = Vec::with_capacity(infos.len());
        for (index, (coverage, role)) in coverages.iter().zip(roles).enumerate() {
            let stored = match coverage.as_ref().filter(|coverage| !coverage.is_empty()) {
                Some(coverage) => {
                    file.load_image(index as u32)?;
                    let bytes = file.take_image(index as u32);
                    let name = name_of(&metadata.images[index]);
                    stored(&bytes, name, role, coverage, &mut scratch).map_err(failed)?.map_or_else(
                        |reason| {
                            warnings.insert(reason);
                            None
                        },
                        Some,
                    )
                }
                None => None,
            };
            images.push(stored);
            Progress { phase: "texture", done: index as u64 + 1, total }.report(progress)?;
        }
        let regions: Vec<_> =
            coverages.iter().map(|coverage| Some(Arc::new(Regions::new(coverage.as_ref()?)?))).collect();
        for material in &mut materials {
            material.keep(|texture| images[texture.image].is_some());
            let size = material.size;
            let is_largest = |texture: &&MaterialTexture| {
                images[texture.image].as_ref().is_some_and(|i| i.pyramid.size() == size)
            };
            let largest = material.textures.iter().find(is_largest);
            material.regions = largest.and_then(|texture| regions[texture.image].clone());
        }
        Ok(Some(Self { materials, images, scratch, quality }))
    }

    /// Moves all corners of triangles that have them in several charts to one chart, and returns the number of these
    /// triangles.
    pub(crate) fn unmix(&self, mesh: &mut IndexedMesh) -> u64 {
        let mut count = 0;
        for group in mesh.groups.clone() {
            let material = group.material.and_then(|material| self.materials.get(material as usize));
            let Some((regions, set)) = material.and_then(|m| Some((m.regions.as_ref()?, m.coordinates?.0)))
            else {
                continue;
            };
            let Some(place) = material.and_then(|material| material.texel_places(mesh)) else { continue };
            let mut moved = Vec::new();
            for triangle in group.first..group.first + group.count {
                let corners = mesh.triangles[triangle as usize];
                let own = corners.map(|v| regions.at(place(v)));
                let size_of = |i: usize| own.iter().filter(|other| **other == own[i]).count();
                // Most corners are there, or the first.
                let Some(home) = (0..3).rev().filter(|&i| own[i].is_some()).max_by_key(|&i| size_of(i))
                else {
                    continue;
                };
                for i in (0..3).filter(|&i| own[i].is_some() && own[i] != own[home]) {
                    moved.push((triangle, i, corners[home]));
                }
            }
            drop(place);
            count += moved.chunk_by(|a, b| a.0 == b.0).count() as u64;
            move_corners(mesh, set, &moved);
        }
        count
    }

    /// Number of texels of all materials together, and the length of a texel.
    fn texels(&self) -> (f64, f64) {
        let (mut count, mut areas) = (0.0, [0.0; 2]);
        for MaterialTextures { size, areas: [surface, texels], .. } in self.textured() {
            let [width, height] = size.map(f64::from);
            count += texels.min(width * height);
            areas = [areas[0] + surface, areas[1] + texels];
        }
        (count, if areas[1] > 0.0 { (areas[0] / areas[1]).sqrt() } else { 0.0 })
    }

    fn textured(&self) -> impl Iterator<Item = &MaterialTextures> {
        self.materials.iter().filter(|material| !material.textures.is_empty())
    }

    /// Number of tiles of the finest level, so that each has about a million texels.
    pub(crate) fn tile_count(&self) -> f64 {
        self.texels().0 / TILE_TEXELS
    }

    /// Length of the texels of a level with a number of tiles.
    pub(crate) fn texel_of(&self, error: f64, tile_count: f64) -> f64 {
        let (count, texel) = self.texels();
        let reduction = count / (tile_count * TILE_TEXELS);
        let fitting = if reduction > 1.0 { texel * reduction.sqrt() } else { 0.0 };
        fitting.max(error / TEXELS_PER_ERROR)
    }
}

impl MaterialTextures {
    fn read(
        material: &Value,
        reader: &TextureReader<'_>,
        infos: &[Option<ImageInfo>],
        metadata: &Metadata,
        warnings: &mut BTreeSet<String>,
    ) -> Self {
        let mut textures = Vec::new();
        references(material, "", &mut |parent, pointer, name| {
            let Some(found) = reader.read(parent, name) else { return };
            let index = parent[name]["index"].as_u64().unwrap_or(0) as usize;
            let sampler = reader.document["textures"][index]["sampler"].as_u64();
            let sampler = sampler.map_or(Value::Null, |s| reader.document["samplers"][s as usize].clone());
            let name = Semantic::TexCoord(found.uv_set).to_string();
            if !metadata.layers.iter().any(|layer| layer.semantic == name) {
                warnings.insert(format!(
                    "textures of the material {} are left out: the mesh has no {name}",
                    material["name"]
                ));
                return;
            }
            textures.push(MaterialTexture {
                pointer,
                image: found.image,
                wrap: found.sampler.wrap,
                sampler: if sampler.is_object() { sampler } else { json!({}) },
                set: found.uv_set,
                transform: found.transform,
            });
        });
        let mut out = Self {
            material: material.clone(),
            textures,
            coordinates: None,
            size: [1; 2],
            regions: None,
            areas: [0.0; 2],
        };
        out.keep(|texture| infos.get(texture.image).is_some_and(Option::is_some));
        let first = out.textures.first().map(|texture| (texture.set, texture.transform));
        out.coordinates = first.filter(|&(set, transform)| {
            out.textures.iter().all(|t| (t.set, t.transform) == (set, transform))
        });
        let sizes = out.textures.iter().filter_map(|texture| *infos.get(texture.image)?);
        let sizes = sizes.map(|info| [info.width, info.height]);
        out.size = sizes.max_by_key(|&[w, h]| u64::from(w) * u64::from(h)).unwrap_or([1; 2]);
        out
    }

    /// Removes textures for which `is_kept` is false, and references that lead nowhere.
    fn keep(&mut self, is_kept: impl Fn(&MaterialTexture) -> bool) {
        self.textures.retain(is_kept);
        let kept: BTreeSet<&str> = self.textures.iter().map(|texture| texture.pointer.as_str()).collect();
        crate::remove_textures(&mut self.material, "", &|pointer| kept.contains(pointer));
    }

    /// Texture coordinates of the charts, in texels of the largest image; `None` if there are none.
    fn texel_places<'m>(&self, mesh: &'m IndexedMesh) -> Option<impl Fn(u32) -> [f64; 2] + use<'m>> {
        let (set, UvTransform(rows)) = self.coordinates?;
        let layer: &AttributeLayer = mesh.layer(&Semantic::TexCoord(set))?;
        let size = self.size.map(f64::from);
        let rows = rows.map(|row| row.map(f64::from));
        Some(move |vertex: u32| {
            let [u, v] = [0, 1].map(|i| f64::from(layer.get(vertex as usize, i)));
            [0, 1].map(|i| (rows[i][0] * u + rows[i][1] * v + rows[i][2]) * size[i])
        })
    }
}

/// Calls `visit` with the parent, the JSON pointer and the name of each reference to a texture.
fn references(value: &Value, path: &str, visit: &mut dyn FnMut(&Value, String, &str)) {
    for (name, member) in value.as_object().into_iter().flatten() {
        let pointer = crate::member_pointer(path, name);
        if name.ends_with("Texture") && member.get("index").is_some() {
            visit(value, pointer, name);
        } else {
            references(member, &pointer, visit);
        }
    }
}

/// Gives corners of triangles the texture coordinates of other vertices.
fn move_corners(mesh: &mut IndexedMesh, set: u8, moved: &[(u32, usize, u32)]) {
    let count = mesh.positions.len() as u32;
    let sources = moved.iter().map(|&(triangle, corner, _)| mesh.triangles[triangle as usize][corner]);
    let order: Vec<u32> = (0..count).chain(sources).collect();
    mesh.positions = order.iter().map(|&v| mesh.positions[v as usize]).collect();
    for layer in &mut mesh.layers {
        let is_moved = layer.semantic == Semantic::TexCoord(set);
        let targets = (0..count).chain(moved.iter().map(|&(.., to)| to));
        *layer = if is_moved { layer.gather(&targets.collect::<Vec<u32>>()) } else { layer.gather(&order) };
    }
    for (number, &(triangle, corner, _)) in (count..).zip(moved) {
        mesh.triangles[triangle as usize][corner] = number;
    }
}

fn name_of(image: &PagedImage) -> String {
    let name = [&image.name, &image.uri].into_iter().find(|name| !name.is_empty());
    name.map_or_else(|| "without a name".to_owned(), Clone::clone)
}

/// First bytes and headers of all images; those that are missing have none.
fn signatures(
    file: &mut PagedFile,
    metadata: &Metadata,
    warnings: &mut BTreeSet<String>,
) -> Result<(Vec<Image>, Vec<Option<ImageInfo>>), TilesError> {
    let (mut images, mut infos) = (Vec::new(), Vec::new());
    for (index, image) in (0..).zip(&metadata.images) {
        file.load_image(index)?;
        let mut bytes = file.take_image(index);
        let info = match image_info(&bytes) {
            _ if bytes.is_empty() => Err("it is missing".to_owned()),
            Ok(info) if !info.format.is_decoded() => Err(format!("{} cannot be decoded", info.format)),
            Ok(info) if info.width.max(info.height) > MAX_SIDE => {
                Err(format!("it has more than {MAX_SIDE} pixels per side"))
            }
            Ok(info) => Ok(info),
            Err(error) => Err(error.to_string()),
        };
        if let Err(reason) = &info {
            warnings.insert(format!("the image {} is left out: {reason}", name_of(image)));
        }
        bytes.truncate(SIGNATURE_BYTES);
        images.push(Image { bytes, ..Image::default() });
        infos.push(info.ok());
    }
    Ok((images, infos))
}

/// Measures the areas of all materials, and marks the texels that they show.
fn measure(
    file: &mut PagedFile,
    tiers: &StepTiers,
    materials: &mut [MaterialTextures],
    coverages: &mut [Option<Coverage>],
    progress: &mut ProgressFn<'_>,
) -> Result<(), TilesError> {
    let metadata = file.metadata().clone();
    let extent = |a: usize| f64::from(metadata.max[a]) - f64::from(metadata.min[a]);
    let axis = (0..3).fold(0, |best, a| if extent(a) > extent(best) { a } else { best });
    let total = metadata.triangle_count.div_ceil(MEASURED_TRIANGLES).max(1);
    let plane = |i: u64| match i {
        0 => f64::NEG_INFINITY,
        _ if i == total => f64::INFINITY,
        _ => f64::from(metadata.min[axis]) + extent(axis) * i as f64 / total as f64,
    };
    for part in 0..total {
        let [low, high] = [plane(part), plane(part + 1)];
        let cut = file.cut_tiers(tiers, |_, bounds| {
            f64::from(bounds.max[axis]) >= low && f64::from(bounds.min[axis]) <= high
        })?;
        let mesh = cut.mesh;
        for group in &mesh.groups {
            let Some(material) = group.material.and_then(|m| materials.get_mut(m as usize)) else { continue };
            let Some(place) = material.texel_places(&mesh) else { continue };
            for corners in &mesh.triangles[group.first as usize..(group.first + group.count) as usize] {
                let at = corners.map(|v| mesh.positions[v as usize].map(f64::from));
                let center = at.iter().map(|p| p[axis]).sum::<f64>() / 3.0;
                let texels = corners.map(&place);
                if !(low <= center && center < high) || texels.iter().flatten().any(|x| !x.is_finite()) {
                    continue;
                }
                material.areas[0] += chart::area(at);
                material.areas[1] += chart::area(texels.map(|[x, y]| [x, y, 0.0]));
                for texture in &material.textures {
                    let Some(Some(coverage)) = coverages.get_mut(texture.image) else { continue };
                    let scale = [
                        f64::from(coverage.width) / f64::from(material.size[0]),
                        f64::from(coverage.height) / f64::from(material.size[1]),
                    ];
                    coverage.add(texels.map(|at| [0, 1].map(|a| at[a] * scale[a])));
                }
            }
        }
        Progress { phase: "measure", done: part + 1, total }.report(progress)?;
    }
    Ok(())
}

/// Decodes an image and stores it, or says why that is not possible.
fn stored(
    bytes: &[u8],
    name: String,
    role: TextureRole,
    coverage: &Coverage,
    scratch: &mut Scratch,
) -> io::Result<Result<StoredImage, String>> {
    let decoded =
        image_info(bytes).and_then(|info| Ok((info.format, RgbaImage::decode(bytes, role, MAX_SIDE)?)));
    let (format, mut image) = match decoded {
        Ok(decoded) => decoded,
        Err(error) => return Ok(Err(format!("the image {name} is left out: {error}"))),
    };
    if [image.width, image.height] != [coverage.width, coverage.height] {
        return Ok(Err(format!("the image {name} is left out: its header has another size")));
    }
    let keeps_alpha =
        role.alpha != AlphaUse::Unused && image.rgba.iter().skip(3).step_by(4).any(|&a| a < 255);
    let file = (scratch.push(bytes)?, bytes.len());
    let pyramid = Pyramid::new(&mut image, role, coverage, scratch)?;
    Ok(Ok(StoredImage { name, pyramid, format, keeps_alpha, file }))
}
