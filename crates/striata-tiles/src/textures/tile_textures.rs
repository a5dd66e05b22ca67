//! The textures of a mesh: measured on its finest surface, and stored out of memory.

use std::collections::BTreeSet;
use std::io;
use std::path::Path;
use std::sync::Arc;

use serde_json::{Value, json};
use striata::mesh::{Image, IndexedMesh, Semantic};
use striata::{Progress, ProgressFn};
use striata_paged::{Metadata, PagedFile, PagedImage, StepTiers};
use striata_scene::drawn::TextureReader;
use striata_scene::textures::{
    AlphaUse, ImageFormat, ImageInfo, MAX_SIDE, RgbaImage, TextureRole, image_info, image_roles,
};

use super::chart;
use super::coverage::Coverage;
use super::material::{MaterialTexture, MaterialTextures};
use super::pyramid::{Pyramid, Scratch};
use super::regions::Regions;
use crate::error::TilesError;

/// Texels of the atlases of a tile, about.
const TILE_TEXELS: f64 = (1 << 20) as f64;
/// A texel is at most this fraction of the error of a tile.
pub(crate) const TEXELS_PER_ERROR: f64 = 16.0;
/// Number of times that a mesh shows an image, beyond which it repeats. Two sides that mirror each other show it twice.
const MOST_COPIES: f64 = 2.0;
/// Triangles that are measured together, about.
const MEASURED_TRIANGLES: u64 = 1 << 20;
/// Texels of all images together of which it is known whether the mesh shows them: memory has a bit for each.
const MAX_COVERED_TEXELS: u64 = 1 << 33;
/// Bytes of an image that say which format it has.
const SIGNATURE_BYTES: usize = 16;

/// The textures of a mesh.
pub(crate) struct TileTextures {
    /// By material.
    pub materials: Vec<MaterialTextures>,
    /// By image; `None` if no material uses it, or it is missing.
    pub images: Vec<Option<StoredImage>>,
    pub scratch: Scratch,
    pub quality: u8,
    /// Remarks on textures that are left out.
    pub warnings: BTreeSet<String>,
}

/// An image on disk.
pub(crate) struct StoredImage {
    pub name: String,
    pub pyramid: Pyramid,
    pub format: ImageFormat,
    pub keeps_alpha: bool,
    /// Place and number of the bytes of the file.
    pub file: (u64, usize),
}

impl TileTextures {
    /// Reads the textures of a mesh.
    pub(crate) fn read(
        file: &mut PagedFile,
        tiers: &StepTiers,
        output: &Path,
        quality: u8,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, TilesError> {
        let mut warnings = BTreeSet::new();
        let metadata = file.metadata().clone();
        let list = |name: &str| metadata.appearance.get(name).cloned().unwrap_or_else(|| json!([]));
        let names: Vec<Value> = metadata.images.iter().map(|_| json!({})).collect();
        let document = json!({
            "materials": list("materials"),
            "textures": list("textures"),
            "samplers": list("samplers"),
            "images": names,
        });
        let (signatures, infos) = signatures(file, &metadata, &mut warnings)?;
        let reader = TextureReader { document: &document, images: &signatures };
        let materials = document["materials"].as_array().into_iter().flatten();
        let mut materials: Vec<MaterialTextures> = materials
            .map(|material| MaterialTextures::read(material, &reader, &infos, &metadata, &mut warnings))
            .collect();
        let mut coverages = coverages(&materials, &infos);
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
        Ok(Self { materials, images, scratch, quality, warnings })
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

    /// Number of texels of all materials that have atlases together, and the length of a texel. Images that repeat do not
    /// count: tiles have them as a whole, however small they are.
    fn texels(&self) -> (f64, f64) {
        let (mut count, mut areas) = (0.0, [0.0; 2]);
        let divided = self.materials.iter().filter(|material| material.regions.is_some());
        for MaterialTextures { size, areas: [surface, texels], .. } in divided {
            let all = f64::from(size[0]) * f64::from(size[1]);
            if *texels > MOST_COPIES * all {
                continue;
            }
            count += texels.min(all);
            areas = [areas[0] + surface, areas[1] + texels];
        }
        (count, if areas[1] > 0.0 { (areas[0] / areas[1]).sqrt() } else { 0.0 })
    }

    /// Number of triangles of the finest tiles, so that each has about a million texels.
    pub(crate) fn tile_triangles(&self, metadata: &Metadata) -> f64 {
        metadata.triangle_count as f64 * TILE_TEXELS / self.texels().0
    }

    /// Length of the texels of a level with a number of tiles.
    pub(crate) fn texel_of(&self, error: f64, tile_count: f64) -> f64 {
        let (count, texel) = self.texels();
        let reduction = count / (tile_count * TILE_TEXELS);
        let fitting = if reduction > 1.0 { texel * reduction.sqrt() } else { 0.0 };
        fitting.max(error / TEXELS_PER_ERROR)
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

/// Coverages of all images, without a texel that counts but for images of which all texels do.
fn coverages(materials: &[MaterialTextures], infos: &[Option<ImageInfo>]) -> Vec<Option<Coverage>> {
    let without_charts = materials.iter().filter(|material| material.coordinates.is_none());
    let whole: BTreeSet<usize> =
        without_charts.flat_map(|material| &material.textures).map(|texture| texture.image).collect();
    let mut total = 0;
    let coverage = |(index, info): (usize, &Option<ImageInfo>)| {
        let size = info.map(|info| [info.width, info.height])?;
        total += u64::from(size[0]) * u64::from(size[1]);
        let is_whole = whole.contains(&index) || total > MAX_COVERED_TEXELS;
        Some(Coverage::new(size, is_whole))
    };
    infos.iter().enumerate().map(coverage).collect()
}

/// Measures the areas of all materials, and marks the texels that they show.
fn measure(
    file: &mut PagedFile,
    tiers: &StepTiers,
    materials: &mut [MaterialTextures],
    coverages: &mut [Option<Coverage>],
    progress: &mut ProgressFn<'_>,
) -> Result<(), TilesError> {
    if materials.iter().all(|material| material.textures.is_empty()) {
        return Ok(());
    }
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
                if !(low <= center && center < high) {
                    continue;
                }
                material.areas[0] += chart::area(at);
                let texel_area = chart::area(texels.map(|[x, y]| [x, y, 0.0]));
                material.areas[1] += if texel_area.is_finite() { texel_area } else { 0.0 };
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
