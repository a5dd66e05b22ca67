//! Facts of a scene that `info` reports besides its triangles: its parts, extensions and levels.

use serde::Serialize;
use serde_json::Value;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, format_bytes, format_count, format_length, format_noun_count};
use striata_command::scene::SceneKind;
use striata_io::{ExtensionUse, Scene, extension_use};
use striata_scene::LodScene;
use striata_scene::textures::image_info;

/// Number of meshes and images that the text lists; JSON has all of them.
const LISTED: usize = 12;

/// The parts of a scene.
#[derive(Serialize)]
pub(in crate::commands) struct SceneFacts {
    scene_count: usize,
    node_count: usize,
    /// Number of times that the default scene shows a mesh.
    instance_count: usize,
    meshes: Vec<MeshFacts>,
    material_count: usize,
    texture_count: usize,
    images: Vec<ImageFacts>,
    skin_count: usize,
    animation_count: usize,
    camera_count: usize,
    extensions: Vec<String>,
    /// Levels of the whole scene; null if the input has none.
    levels: Option<LevelFacts>,
    /// Whether a stream is complete; null for other inputs.
    is_complete: Option<bool>,
}

#[derive(Serialize)]
struct MeshFacts {
    name: String,
    triangle_count: usize,
    vertex_count: usize,
    primitive_count: usize,
    instance_count: usize,
    /// Number of vertex splits; null without levels.
    step_count: Option<usize>,
}

#[derive(Serialize)]
struct ImageFacts {
    name: String,
    mime_type: String,
    bytes: usize,
    /// Width and height, pixels; null if unknown.
    size: Option<[u32; 2]>,
}

#[derive(Serialize)]
struct LevelFacts {
    step_count: usize,
    base_triangle_count: usize,
    /// Error of the coarsest level, scene units.
    error_max: f64,
    error_is_guaranteed: bool,
}

impl SceneFacts {
    /// Reads an input; also returns its full scene. `None` if it is not a scene.
    ///
    /// # Errors
    /// If the input is damaged.
    pub(in crate::commands) fn read(
        input: &Input,
        output: &Output,
    ) -> Result<Option<(Self, Scene)>, Failure> {
        Ok(match input.scene_kind() {
            None => None,
            Some(SceneKind::Gltf) => {
                let scene = input.scene(output)?;
                Some((Self::new(&scene, None), scene))
            }
            Some(kind) => {
                let received = input.received_scene(output)?;
                let scene = received.lods.full_scene();
                let facts = Self::new(&scene, Some(&received.lods));
                let is_complete = (kind == SceneKind::Stream).then_some(received.is_complete);
                Some((Self { is_complete, ..facts }, scene))
            }
        })
    }

    fn new(scene: &Scene, lods: Option<&LodScene>) -> Self {
        let document = scene.document();
        let count = |key: &str| document.get(key).and_then(Value::as_array).map_or(0, Vec::len);
        let extensions = document.get("extensionsUsed").and_then(Value::as_array).into_iter().flatten();
        let levels = lods.map(|lods| LevelFacts {
            step_count: lods.levels().step_count(),
            base_triangle_count: lods.levels().base_triangle_count(),
            error_max: lods.levels().base_error(),
            error_is_guaranteed: lods.has_guaranteed_errors(),
        });
        Self {
            scene_count: count("scenes"),
            node_count: count("nodes"),
            instance_count: scene.instances().len(),
            meshes: meshes(scene, lods),
            material_count: count("materials"),
            texture_count: count("textures"),
            images: images(scene),
            skin_count: count("skins"),
            animation_count: count("animations"),
            camera_count: count("cameras"),
            extensions: extensions.filter_map(Value::as_str).map(str::to_owned).collect(),
            levels,
            is_complete: None,
        }
    }

    /// Returns the rows of the table.
    pub(in crate::commands) fn rows(&self) -> Vec<(&'static str, String)> {
        let mut rows = Vec::new();
        let nodes = format_noun_count(self.node_count, "node", "nodes");
        let instances = format_noun_count(self.instance_count, "instance of a mesh", "instances of meshes");
        rows.push(("scene", format!("{nodes}, {instances}")));
        for mesh in self.meshes.iter().take(LISTED) {
            rows.push(("  mesh", mesh.to_text()));
        }
        if self.meshes.len() > LISTED {
            rows.push(("  mesh", format!("{} more", format_count(self.meshes.len() - LISTED))));
        }
        let bytes: usize = self.images.iter().map(|image| image.bytes).sum();
        let textures = format_noun_count(self.texture_count, "texture", "textures");
        let images = format_noun_count(self.images.len(), "image", "images");
        rows.push(("textures", format!("{textures}, {images} ({})", format_bytes(bytes))));
        for image in self.images.iter().take(LISTED) {
            rows.push(("  image", image.to_text()));
        }
        if self.images.len() > LISTED {
            rows.push(("  image", format!("{} more", format_count(self.images.len() - LISTED))));
        }
        for (name, count) in
            [("skins", self.skin_count), ("animations", self.animation_count), ("cameras", self.camera_count)]
        {
            if count > 0 {
                rows.push((name, format_count(count)));
            }
        }
        if !self.extensions.is_empty() {
            let described = self.extensions.iter().map(|name| {
                let usage = extension_use(name).map_or("unknown", ExtensionUse::as_str);
                format!("{name} ({usage})")
            });
            rows.push(("extensions", described.collect::<Vec<_>>().join(", ")));
        }
        if let Some(levels) = &self.levels {
            rows.push(("levels", format_count(levels.step_count + 1)));
            let kind = if levels.error_is_guaranteed { "guaranteed error" } else { "error" };
            let triangles = format_noun_count(levels.base_triangle_count, "triangle", "triangles");
            rows.push(("coarsest level", format!("{triangles}, {kind} {}", format_length(levels.error_max))));
        }
        rows
    }
}

fn meshes(scene: &Scene, lods: Option<&LodScene>) -> Vec<MeshFacts> {
    let mut instance_counts = vec![0; scene.meshes().len()];
    for instance in scene.instances() {
        instance_counts[instance.mesh] += 1;
    }
    let facts = scene.meshes().iter().enumerate().filter_map(|(index, mesh)| {
        let mesh = mesh.as_ref()?;
        Some(MeshFacts {
            name: scene.mesh_name(index).to_owned(),
            triangle_count: mesh.triangle_count(),
            vertex_count: mesh.vertex_count(),
            primitive_count: mesh.groups_or_whole().len(),
            instance_count: instance_counts[index],
            step_count: lods.and_then(|lods| Some(lods.lods()[index].as_ref()?.step_count())),
        })
    });
    facts.collect()
}

fn images(scene: &Scene) -> Vec<ImageFacts> {
    let facts = scene.images().iter().map(|image| ImageFacts {
        name: if image.name.is_empty() { image.uri.clone() } else { image.name.clone() },
        mime_type: image.mime_type.clone(),
        bytes: image.bytes.len(),
        size: image_info(&image.bytes).ok().map(|info| [info.width, info.height]),
    });
    facts.collect()
}

impl MeshFacts {
    fn to_text(&self) -> String {
        let name = if self.name.is_empty() { "unnamed" } else { &self.name };
        let triangles = format_noun_count(self.triangle_count, "triangle", "triangles");
        let mut text = format!("{name}: {triangles}");
        for (count, what) in [(self.primitive_count, "primitives"), (self.instance_count, "instances")] {
            if count != 1 {
                text.push_str(&format!(", {} {what}", format_count(count)));
            }
        }
        text
    }
}

impl ImageFacts {
    fn to_text(&self) -> String {
        let name = if self.name.is_empty() { "unnamed" } else { &self.name };
        let size = self.size.map_or_else(|| "unknown size".to_owned(), |[w, h]| format!("{w} x {h}"));
        if self.bytes == 0 {
            return format!("{name}: missing");
        }
        format!("{name}: {size}, {}, {}", self.mime_type, format_bytes(self.bytes))
    }
}
