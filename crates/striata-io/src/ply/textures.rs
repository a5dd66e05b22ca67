//! Materials of a PLY file: one for each `comment TextureFile`.

use serde_json::{Value, json};
use striata::mesh::{IndexedMesh, Material, Semantic, TriangleGroup};

use super::header::TextureComment;
use crate::error::Place;
use crate::report::Warnings;
use crate::texture_set::{TextureName, TextureSet, shortened};

/// Gives a mesh the materials of its textures, and sorts its triangles by texture. `numbers` has the texture
/// of each triangle; if it is empty, all triangles have the first one.
pub(crate) fn attach(
    mesh: &mut IndexedMesh,
    comments: &[TextureComment],
    numbers: &[i64],
    mut textures: TextureSet<'_>,
    warnings: &mut Warnings,
) {
    if comments.is_empty() {
        return;
    }
    if mesh.layer(&Semantic::TexCoord(0)).is_none() {
        for TextureComment { name, line } in comments {
            let name = shortened(name);
            let reason = format!("texture `{name}`: the mesh has no texture coordinates; it is left out");
            warnings.push(Place::Line(*line), reason);
        }
        return;
    }
    let (mut materials, mut values) = (Vec::new(), Vec::new());
    for comment in comments {
        let (material, value) = material(comment, &mut textures, warnings);
        materials.push(material);
        values.push(value);
    }
    group_by_texture(mesh, comments, numbers, warnings);
    mesh.appearance = textures.into_appearance(materials, &values);
}

/// Returns a matte material with the texture, which is named after the image.
fn material(
    TextureComment { name, line }: &TextureComment,
    textures: &mut TextureSet<'_>,
    warnings: &mut Warnings,
) -> (Material, Value) {
    let file = warnings.file().to_owned();
    let texture = TextureName { name, folder: "", file: &file, place: Place::Line(*line) };
    let mut pbr = json!({ "metallicFactor": 0.0 });
    if let Some(file) = textures.file(&texture, warnings) {
        pbr["baseColorTexture"] = json!({ "index": textures.texture(file, false) });
    }
    let file_name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let name = file_name.rsplit_once('.').map_or(file_name, |(stem, _)| stem).to_owned();
    let value = json!({ "name": name, "pbrMetallicRoughness": pbr });
    (Material { name, gltf_json: value.to_string() }, value)
}

/// Sorts triangles by texture, those without one last, and makes a group for each texture in use.
fn group_by_texture(
    mesh: &mut IndexedMesh,
    comments: &[TextureComment],
    numbers: &[i64],
    warnings: &mut Warnings,
) {
    let count = comments.len();
    if numbers.is_empty() && count > 1 {
        let reason = format!("{count} textures, but no `texnumber`: all faces get the first one");
        warnings.push(Place::Line(comments[1].line), reason);
    }
    let texture_of = |triangle: usize| match numbers.get(triangle) {
        None => 0,
        Some(&number) => usize::try_from(number).unwrap_or(count).min(count),
    };
    if let Some(unknown) = numbers.iter().find(|&&number| number < -1 || number >= count as i64) {
        let reason = format!("texture number {unknown} does not exist: there are {count} textures");
        warnings.push(Place::File, reason);
    }
    let mut counts = vec![0u32; count + 1];
    (0..mesh.triangles.len()).for_each(|triangle| counts[texture_of(triangle)] += 1);
    if !(0..mesh.triangles.len()).is_sorted_by_key(texture_of) {
        let mut order: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
        order.sort_by_key(|&triangle| texture_of(triangle as usize));
        mesh.triangles = order.iter().map(|&triangle| mesh.triangles[triangle as usize]).collect();
        mesh.triangle_layers = mesh.triangle_layers.iter().map(|layer| layer.gather(&order)).collect();
    }
    let mut first = 0;
    for (texture, &count_of_texture) in counts.iter().enumerate() {
        if count_of_texture > 0 {
            let material = (texture < count).then_some(texture as u32);
            mesh.groups.push(TriangleGroup { name: String::new(), material, first, count: count_of_texture });
        }
        first += count_of_texture;
    }
}
