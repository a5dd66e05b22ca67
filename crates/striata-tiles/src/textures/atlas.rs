//! The images of a tile, and its texture coordinates.
//!
//! Each material of a tile has an atlas of the charts that it uses, for all of its textures alike. If that would be as
//! large as the reduced images, as for images that repeat, the material has these, and its texture coordinates stay.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, HashMap};
use std::io;

use serde_json::{Value, json};
use striata::mesh::{Appearance, AttributeLayer, Image, IndexedMesh, Material, Semantic};
use striata_scene::drawn::Wrap;
use striata_scene::textures::{ImageFormat, RgbaImage, TextureTransfer};

use super::chart::{AtlasChart, MAX_ATLAS_SIDE, charts, packed, step_for};
use super::material::{MaterialTexture, MaterialTextures};
use super::pyramid::SampledRect;
use super::tile_textures::{StoredImage, TileTextures};

/// Largest difference of the resolutions of the images of a material that its atlases keep, as a power of two.
const MAX_COARSER: u32 = 3;
/// `CLAMP_TO_EDGE`.
const CLAMP: u32 = 33_071;
const NONE: u32 = u32::MAX;

/// A tile with its textures.
pub(crate) struct DressedTile {
    pub mesh: IndexedMesh,
    pub atlas_count: u64,
    pub image_bytes: u64,
    /// Name of a material whose images are reduced because they would be too large for an atlas.
    pub reduced: Option<String>,
}

/// Set and texture coordinates.
type NewTexCoord = (u8, [f32; 2]);

/// The vertices and images of a tile while they are made.
struct TileDresser<'a> {
    set: &'a TileTextures,
    mesh: &'a IndexedMesh,
    appearance: Appearance,
    /// Vertex of each new vertex, and its new texture coordinates.
    vertices: Vec<(u32, Option<NewTexCoord>)>,
    atlas_count: u64,
    reduced: Option<String>,
}

impl TileTextures {
    /// Gives a tile its textures, with texels of this length, or that of the images if it is 0.
    pub(crate) fn dress(&self, mesh: &IndexedMesh, texel: f64) -> io::Result<DressedTile> {
        let mut of_material: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        let mut chart_of = vec![NONE; mesh.triangles.len()];
        for group in &mesh.groups {
            let triangles = of_material.entry(group.material.unwrap_or(NONE)).or_default();
            triangles.extend(group.first..group.first + group.count);
        }
        let mut dresser = TileDresser {
            set: self,
            mesh,
            appearance: Appearance {
                materials: Vec::new(),
                images: Vec::new(),
                textures_json: Vec::new(),
                samplers_json: Vec::new(),
                georeference: String::new(),
                ..mesh.appearance.clone()
            },
            vertices: Vec::new(),
            atlas_count: 0,
            reduced: None,
        };
        let mut number_of = BTreeMap::new();
        let mut all: Vec<(AtlasChart, [u32; 2], &MaterialTextures)> = Vec::new();
        for (&index, triangles) in of_material.iter().filter(|(index, _)| **index != NONE) {
            number_of.insert(index, dresser.appearance.materials.len() as u32);
            let Some(material) = self.materials.get(index as usize) else { continue };
            let (json, charts, size) = dresser.material(material, triangles, texel)?;
            let name = mesh.appearance.materials.get(index as usize).map(|m| m.name.clone());
            let name = name.unwrap_or_default();
            dresser.appearance.materials.push(Material { name, gltf_json: json.to_string() });
            for chart in charts {
                chart.triangles.iter().for_each(|&t| chart_of[t as usize] = all.len() as u32);
                all.push((chart, size, material));
            }
        }
        let mut groups = mesh.groups.clone();
        for group in &mut groups {
            group.material = group.material.and_then(|m| number_of.get(&m).copied());
        }
        let triangles = dresser.new_triangles(&chart_of, &all);
        Ok(dresser.finish(triangles, groups))
    }
}

impl TileDresser<'_> {
    /// The material with its new images; the charts and the size of its atlas if it has one.
    fn material(
        &mut self,
        material: &MaterialTextures,
        triangles: &[u32],
        texel: f64,
    ) -> io::Result<(Value, Vec<AtlasChart>, [u32; 2])> {
        let mut json = material.material.clone();
        if material.textures.is_empty() {
            return Ok((json, Vec::new(), [0; 2]));
        }
        let place = material.texel_places(self.mesh);
        let found = place.and_then(|place| charts(self.mesh, triangles, &place));
        let areas =
            found.iter().flatten().fold([0.0; 2], |sum, chart| [0, 1].map(|i| sum[i] + chart.areas[i]));
        let step = if found.is_some() { step_for(areas, texel) } else { 1.0 };
        let whole = material.size.map(|side| reduced(side, step));
        if let Some(mut charts) = found {
            let coarser = self.fit(material, &mut charts, texel);
            let most = u64::from(whole[0]) * u64::from(whole[1]);
            if charts.iter().map(AtlasChart::pixel_count).sum::<u64>() < most
                && let Some(size) = packed(&mut charts)
                && u64::from(size[0]) * u64::from(size[1]) < most
            {
                let size = size.map(|side| side.next_multiple_of(1 << coarser));
                let mut made = BTreeMap::new();
                for texture in &material.textures {
                    let image = match made.entry(texture.image) {
                        Entry::Occupied(image) => *image.get(),
                        Entry::Vacant(place) => *place.insert(self.atlas(material, texture, &charts, size)?),
                    };
                    self.refer(&mut json, texture, image, true);
                }
                self.atlas_count += 1;
                return Ok((json, charts, size));
            }
        }
        let limit = f64::from(whole[0].max(whole[1])) / f64::from(MAX_ATLAS_SIDE);
        if limit > 1.0 {
            self.reduced = Some(json["name"].as_str().unwrap_or_default().to_owned());
        }
        let mut made = BTreeMap::new();
        for texture in &material.textures {
            let image = match made.entry(texture.image) {
                Entry::Occupied(image) => *image.get(),
                Entry::Vacant(place) => {
                    *place.insert(self.whole(material, texture, step * limit.max(1.0))?)
                }
            };
            self.refer(&mut json, texture, image, false);
        }
        Ok((json, Vec::new(), [0; 2]))
    }

    /// Chooses the sizes of charts; returns by how much the coarsest atlas is coarser, as a power of two.
    fn fit(&mut self, material: &MaterialTextures, charts: &mut [AtlasChart], texel: f64) -> u32 {
        let steps: Vec<f64> = charts.iter().map(|chart| step_for(chart.areas, texel)).collect();
        let least = steps.iter().copied().fold(f64::INFINITY, f64::min);
        let coarser = |texture: &MaterialTexture| self.coarser(material, texture, least);
        let coarser = material.textures.iter().map(coarser).max().unwrap_or(0);
        for (chart, step) in charts.iter_mut().zip(steps) {
            chart.set_size(step, 1 << coarser);
        }
        coarser
    }

    /// By how much the atlas of an image may be coarser than that of the largest image, as a power of two.
    fn coarser(&self, material: &MaterialTextures, texture: &MaterialTexture, step: f64) -> u32 {
        let Some(image) = self.image(texture) else { return 0 };
        let size = image.pyramid.size();
        let ratio = |a: usize| f64::from(material.size[a]) / f64::from(size[a]);
        let ratio = ratio(0).min(ratio(1)) / step;
        (0..MAX_COARSER).take_while(|&n| f64::from(2u32 << n) <= ratio).count() as u32
    }

    fn image(&self, texture: &MaterialTexture) -> Option<&StoredImage> {
        self.set.images[texture.image].as_ref()
    }

    /// Makes the atlas of an image and returns its index.
    fn atlas(
        &mut self,
        material: &MaterialTextures,
        texture: &MaterialTexture,
        charts: &[AtlasChart],
        size: [u32; 2],
    ) -> io::Result<usize> {
        let least = charts.iter().map(|chart| chart.step).fold(f64::INFINITY, f64::min);
        let shift = self.coarser(material, texture, least);
        let Some(image) = self.image(texture) else { return Ok(0) };
        let full = image.pyramid.size().map(f64::from);
        let scale = [0, 1].map(|a| full[a] / f64::from(material.size[a]));
        let size = size.map(|side| side >> shift);
        let mut pixels = vec![[0u8; 4]; size[0] as usize * size[1] as usize];
        let average = SampledRect { start: [0.0; 2], step: full, size: [1, 1], wrap: [Wrap::ClampToEdge; 2] };
        image.pyramid.read(&self.set.scratch, &average, |_, row| pixels.fill(row[0]))?;
        for chart in charts {
            let step = scale.map(|scale| scale * chart.step * f64::from(1u32 << shift));
            let gutter = f64::from(chart.gutter) * chart.step;
            let sampled = SampledRect {
                start: [0, 1].map(|a| (chart.start[a] - gutter) * scale[a]),
                step,
                size: chart.size.map(|side| side >> shift),
                wrap: texture.wrap,
            };
            let [left, top] = chart.place.map(|x| (x >> shift) as usize);
            image.pyramid.read(&self.set.scratch, &sampled, |y, row| {
                let first = (top + y as usize) * size[0] as usize + left;
                pixels[first..first + row.len()].copy_from_slice(row);
            })?;
        }
        self.encoded(texture, size, &pixels)
    }

    /// Adds a whole image, reduced by `step` texels of the largest one, and returns its index.
    fn whole(
        &mut self,
        material: &MaterialTextures,
        texture: &MaterialTexture,
        step: f64,
    ) -> io::Result<usize> {
        let Some(image) = self.image(texture) else { return Ok(0) };
        let full = image.pyramid.size();
        let scale = |a: usize| f64::from(full[a]) / f64::from(material.size[a]);
        let step = (step * scale(0).min(scale(1))).max(1.0);
        let size = full.map(|side| reduced(side, step));
        if size == full && matches!(image.format, ImageFormat::Png | ImageFormat::Jpeg) {
            let bytes = self.set.scratch.read(image.file.0, image.file.1)?;
            let (name, format) = (image.name.clone(), image.format);
            return Ok(self.push_image(name, format, bytes));
        }
        let sampled = SampledRect {
            start: [0.0; 2],
            step: [0, 1].map(|a| f64::from(full[a]) / f64::from(size[a])),
            size,
            wrap: texture.wrap,
        };
        let mut pixels = Vec::with_capacity(size[0] as usize * size[1] as usize);
        image.pyramid.read(&self.set.scratch, &sampled, |_, row| pixels.extend_from_slice(row))?;
        self.encoded(texture, size, &pixels)
    }

    fn encoded(
        &mut self,
        texture: &MaterialTexture,
        size: [u32; 2],
        pixels: &[[u8; 4]],
    ) -> io::Result<usize> {
        let Some(image) = self.image(texture) else { return Ok(0) };
        // Noise in directions and roughness is seen more than in colors.
        let is_color = image.pyramid.role.transfer == TextureTransfer::Srgb;
        let format = match image.format {
            _ if image.keeps_alpha => ImageFormat::Png,
            ImageFormat::Jpeg => ImageFormat::Jpeg,
            _ if is_color => ImageFormat::Jpeg,
            _ => ImageFormat::Png,
        };
        let [width, height] = size;
        let rgba = RgbaImage { width, height, rgba: pixels.as_flattened().into() };
        let encoded = rgba.encode(format, image.keeps_alpha, self.set.quality).map_err(io::Error::other)?;
        let name = image.name.clone();
        Ok(self.push_image(name, format, encoded.bytes))
    }

    fn push_image(&mut self, name: String, format: ImageFormat, bytes: Vec<u8>) -> usize {
        let mime_type = format.mime_type().to_owned();
        self.appearance.images.push(Image { name, uri: String::new(), mime_type, bytes });
        self.appearance.images.len() - 1
    }

    /// Makes a material refer to an image.
    fn refer(&mut self, material: &mut Value, texture: &MaterialTexture, image: usize, is_packed: bool) {
        let mut sampler = texture.sampler.clone();
        if is_packed {
            (sampler["wrapS"], sampler["wrapT"]) = (json!(CLAMP), json!(CLAMP));
        }
        let sampler = index_of(&mut self.appearance.samplers_json, sampler.to_string());
        let found = json!({ "source": image, "sampler": sampler }).to_string();
        let index = index_of(&mut self.appearance.textures_json, found);
        let Some(Value::Object(reference)) = material.pointer_mut(&texture.pointer) else { return };
        reference.insert("index".to_owned(), json!(index));
        if !is_packed {
            return;
        }
        reference.insert("texCoord".to_owned(), json!(texture.set));
        if let Some(Value::Object(extensions)) = reference.get_mut("extensions") {
            extensions.remove("KHR_texture_transform");
            if extensions.is_empty() {
                reference.remove("extensions");
            }
        }
    }

    /// Triangles with a vertex for each chart that a vertex is in.
    fn new_triangles(
        &mut self,
        chart_of: &[u32],
        charts: &[(AtlasChart, [u32; 2], &MaterialTextures)],
    ) -> Vec<[u32; 3]> {
        let mut number_of: HashMap<(u32, u32), u32> = HashMap::new();
        let mut triangles = Vec::with_capacity(self.mesh.triangles.len());
        let places: Vec<_> = charts.iter().map(|(.., material)| material.texel_places(self.mesh)).collect();
        for (corners, &chart) in self.mesh.triangles.iter().zip(chart_of) {
            triangles.push(corners.map(|v| {
                *number_of.entry((v, chart)).or_insert_with(|| {
                    let own = charts.get(chart as usize).zip(places.get(chart as usize));
                    let coordinates = own.and_then(|((chart, size, material), place)| {
                        let at = chart.pixel_of(place.as_ref()?(v));
                        let (set, _) = material.coordinates?;
                        Some((set, [0, 1].map(|a| (at[a] / f64::from(size[a])) as f32)))
                    });
                    self.vertices.push((v, coordinates));
                    self.vertices.len() as u32 - 1
                })
            }));
        }
        triangles
    }

    fn finish(self, triangles: Vec<[u32; 3]>, groups: Vec<striata::mesh::TriangleGroup>) -> DressedTile {
        let order: Vec<u32> = self.vertices.iter().map(|&(v, _)| v).collect();
        let mut layers: Vec<AttributeLayer> =
            self.mesh.layers.iter().map(|layer| layer.gather(&order)).collect();
        for layer in &mut layers {
            let Semantic::TexCoord(set) = layer.semantic else { continue };
            let new = |own: &Option<NewTexCoord>| own.filter(|(own, _)| *own == set).map(|(_, at)| at);
            if self.vertices.iter().any(|(_, own)| new(own).is_some()) {
                let values =
                    self.vertices.iter().enumerate().flat_map(|(v, (_, own))| {
                        new(own).unwrap_or_else(|| [0, 1].map(|i| layer.get(v, i)))
                    });
                *layer = AttributeLayer::from_f32(layer.semantic.clone(), 2, values.collect());
            }
        }
        let image_bytes = self.appearance.images.iter().map(|image| image.bytes.len() as u64).sum();
        let mesh = IndexedMesh {
            positions: order.iter().map(|&v| self.mesh.positions[v as usize]).collect(),
            layers,
            triangles,
            groups,
            appearance: self.appearance,
            origin: self.mesh.origin,
            ..IndexedMesh::default()
        };
        DressedTile { mesh, atlas_count: self.atlas_count, image_bytes, reduced: self.reduced }
    }
}

/// Number of pixels of a side with `step` texels each.
fn reduced(side: u32, step: f64) -> u32 {
    ((f64::from(side) / step).ceil() as u32).clamp(1, side)
}

/// Index of an entry, which is added if it is new.
fn index_of(entries: &mut Vec<String>, entry: String) -> usize {
    entries.iter().position(|own| *own == entry).unwrap_or_else(|| {
        entries.push(entry);
        entries.len() - 1
    })
}
