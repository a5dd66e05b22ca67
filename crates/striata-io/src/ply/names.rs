//! Names of vertex properties: the layers common in PLY files, and our own additions.
//!
//! | layer | properties |
//! | --- | --- |
//! | normal, tangent | `nx ny nz`, `tangent_x tangent_y tangent_z tangent_w` |
//! | UV set 0 | `s t` (also read: `u v`, `texture_u texture_v`, `texcoord_u texcoord_v`) |
//! | other UV sets | `texcoord_1_s texcoord_1_t` |
//! | color set 0, others | `red green blue alpha` (also read: `diffuse_red` …), `color_1_red` … |
//! | joints, weights | `joints_0_0` … `joints_0_3`, `weights_0_0` … `weights_0_3` |
//! | morph targets | `morph_0_position_x` …, `morph_0_normal_x` …, `morph_0_tangent_x` … |
//! | anything else | its name; with several components `name.0 name.1` … |
//!
//! A name that would be read as something else gets `generic_` before it: `t` stays as it is unless there is an `s`.

use std::borrow::Borrow;

use striata::mesh::{AttributeLayer, Semantic};

use super::column::Column;
use super::header::Scalar;

const AXES: [&str; 4] = ["x", "y", "z", "w"];
const COLORS: [&str; 4] = ["red", "green", "blue", "alpha"];

/// Columns that form one layer, in the order of its components.
pub(crate) struct ColumnSet<'a> {
    pub semantic: Semantic,
    pub columns: Vec<&'a Column>,
}

/// Returns the layer and component that a property name stands for.
fn semantic_of(name: &str) -> Option<(Semantic, usize)> {
    match name {
        "x" | "y" | "z" => return None,
        "nx" | "ny" | "nz" => return Some((Semantic::Normal, (name.as_bytes()[1] - b'x') as usize)),
        "s" | "u" | "texture_u" | "texcoord_u" => return Some((Semantic::TexCoord(0), 0)),
        "t" | "v" | "texture_v" | "texcoord_v" => return Some((Semantic::TexCoord(0), 1)),
        _ => {}
    }
    let color = name.strip_prefix("diffuse_").unwrap_or(name);
    if let Some(component) = COLORS.iter().position(|&c| c == color) {
        return Some((Semantic::Color(0), component));
    }
    let axis = |word: &str| AXES.iter().position(|&a| a == word);
    let (kind, rest) = name.split_once('_')?;
    if kind == "tangent" {
        return Some((Semantic::Tangent, axis(rest)?));
    }
    let (number, rest) = rest.split_once('_')?;
    match kind {
        "texcoord" => {
            Some((Semantic::TexCoord(number.parse().ok()?), ["s", "t"].iter().position(|&c| c == rest)?))
        }
        "color" => Some((Semantic::Color(number.parse().ok()?), COLORS.iter().position(|&c| c == rest)?)),
        "joints" => Some((Semantic::Joints(number.parse().ok()?), component(rest)?)),
        "weights" => Some((Semantic::Weights(number.parse().ok()?), component(rest)?)),
        "morph" => {
            let target = number.parse().ok()?;
            let (kind, word) = rest.split_once('_')?;
            let semantic = match kind {
                "position" => Semantic::MorphPosition(target),
                "normal" => Semantic::MorphNormal(target),
                "tangent" => Semantic::MorphTangent(target),
                _ => return None,
            };
            Some((semantic, axis(word).filter(|&a| a < 3)?))
        }
        _ => None,
    }
}

fn component(word: &str) -> Option<usize> {
    word.parse().ok().filter(|&c| c < 4)
}

/// Whether a layer with this number of components is complete.
fn is_complete(semantic: &Semantic, component_count: usize) -> bool {
    match semantic {
        Semantic::Normal
        | Semantic::MorphPosition(_)
        | Semantic::MorphNormal(_)
        | Semantic::MorphTangent(_) => component_count == 3,
        Semantic::Tangent => component_count == 4,
        Semantic::TexCoord(_) => component_count == 2,
        Semantic::Color(_) => matches!(component_count, 3 | 4),
        Semantic::Joints(_) | Semantic::Weights(_) | Semantic::Generic(_) => component_count > 0,
    }
}

/// Groups columns into layers, in the order in which the layers begin.
/// Vertices have their positions elsewhere; columns `x`, `y` and `z` of triangles are like any other.
pub(crate) fn column_sets(columns: &[Column], of_triangles: bool) -> Vec<ColumnSet<'_>> {
    let mut sets: Vec<ColumnSet<'_>> = Vec::new();
    let mut is_used = vec![false; columns.len()];
    for (index, column) in columns.iter().enumerate() {
        if is_used[index] || (!of_triangles && matches!(column.name.as_str(), "x" | "y" | "z")) {
            continue;
        }
        let (semantic, members) = members_of(columns, index);
        for &member in &members {
            is_used[member] = true;
        }
        let members = members.into_iter().map(|member| &columns[member]).collect();
        sets.push(ColumnSet { semantic, columns: members });
    }
    sets
}

/// Returns the layer that a column begins, and its columns.
///
/// The names decide if the layer is complete and of one type; otherwise the column becomes a layer of its
/// own.
fn members_of(columns: &[Column], index: usize) -> (Semantic, Vec<usize>) {
    let own = &columns[index];
    // Components are usually consecutive; searching a few columns around is enough.
    let near = index.saturating_sub(8)..columns.len().min(index + 8);
    if let Some((semantic, _)) = semantic_of(&own.name) {
        let find = |component: usize| {
            let wanted = Some((semantic.clone(), component));
            near.clone().find(|&i| semantic_of(&columns[i].name) == wanted)
        };
        let members: Vec<usize> = (0..4).map_while(find).collect();
        let one_type = members.iter().all(|&m| columns[m].scalar == own.scalar);
        if one_type && members.contains(&index) && is_complete(&semantic, members.len()) {
            return (semantic, members);
        }
    }
    if let Some(stem) = own.name.strip_suffix(".0") {
        let is_next = |&i: &usize| {
            columns[i].scalar == own.scalar && columns[i].name == format!("{stem}.{}", i - index)
        };
        let members: Vec<usize> = (index..columns.len().min(index + 255)).take_while(is_next).collect();
        if members.len() > 1 {
            return (Semantic::Generic(plain_name(stem)), members);
        }
    }
    (Semantic::Generic(plain_name(&own.name)), vec![index])
}

/// The name of a generic layer: without the prefix of our writer, which is there only if it is needed.
pub(crate) fn plain_name(name: &str) -> String {
    let plain = name.strip_prefix("generic_").filter(|plain| plain.is_empty() || has_meaning(plain));
    plain.unwrap_or(name).to_owned()
}

/// Whether a name may be read as something else than a generic layer of one component.
fn has_meaning(word: &str) -> bool {
    matches!(word, "x" | "y" | "z")
        || semantic_of(word).is_some()
        || word.strip_prefix("generic_").is_some_and(|rest| rest.is_empty() || has_meaning(rest))
        || word.rsplit_once('.').is_some_and(|(_, end)| end.parse::<u32>().is_ok())
}

/// Returns the property names of some layers, for the writer. A name that could have another meaning keeps it only
/// if the reader finds the same layers.
pub(crate) fn names_of_layers(
    layers: &[impl Borrow<AttributeLayer>],
    scalar_of: impl Fn(&AttributeLayer) -> Scalar,
    of_triangles: bool,
) -> Vec<Vec<String>> {
    let layers: Vec<&AttributeLayer> = layers.iter().map(Borrow::borrow).collect();
    let plain: Vec<Vec<String>> = layers.iter().map(|layer| property_names(layer, word_of)).collect();
    let columns: Vec<Column> = layers
        .iter()
        .zip(&plain)
        .flat_map(|(layer, names)| names.iter().map(|name| (name.clone(), scalar_of(layer))))
        .map(|(name, scalar)| Column { name, scalar, offset: 0, is_flipped: false })
        .collect();
    let found = column_sets(&columns, of_triangles);
    let is_found = |(layer, set): (&&AttributeLayer, &ColumnSet<'_>)| {
        let is_same = match (&layer.semantic, &set.semantic) {
            (Semantic::Generic(own), Semantic::Generic(read)) => word_of(own) == *read,
            (own, read) => own == read,
        };
        is_same && set.columns.len() == usize::from(layer.component_count)
    };
    if found.len() == layers.len() && layers.iter().zip(&found).all(is_found) {
        return plain;
    }
    layers.iter().map(|layer| property_names(layer, generic_stem)).collect()
}

/// A name as one word.
fn word_of(name: &str) -> String {
    name.chars().map(|c| if c.is_whitespace() { '_' } else { c }).collect()
}

/// Returns the property names of a layer; `stem` makes one of the name of a generic layer.
fn property_names(layer: &AttributeLayer, stem: fn(&str) -> String) -> Vec<String> {
    let count = layer.component_count as usize;
    let numbered = |stem: String| (0..count).map(move |c| format!("{stem}{c}")).collect();
    let named = |stem: String, words: &[&str]| words.iter().map(|w| format!("{stem}{w}")).collect();
    let own: Vec<String> = match &layer.semantic {
        Semantic::Normal => named("n".to_owned(), &AXES[..3]),
        Semantic::Tangent => named("tangent_".to_owned(), &AXES),
        Semantic::TexCoord(0) => named(String::new(), &["s", "t"]),
        Semantic::TexCoord(set) => named(format!("texcoord_{set}_"), &["s", "t"]),
        Semantic::Color(0) => named(String::new(), &COLORS[..count.clamp(3, 4)]),
        Semantic::Color(set) => named(format!("color_{set}_"), &COLORS[..count.clamp(3, 4)]),
        Semantic::Joints(set) => numbered(format!("joints_{set}_")),
        Semantic::Weights(set) => numbered(format!("weights_{set}_")),
        Semantic::MorphPosition(target) => named(format!("morph_{target}_position_"), &AXES[..3]),
        Semantic::MorphNormal(target) => named(format!("morph_{target}_normal_"), &AXES[..3]),
        Semantic::MorphTangent(target) => named(format!("morph_{target}_tangent_"), &AXES[..3]),
        Semantic::Generic(name) => return generic_names(&stem(name), count),
    };
    // A layer with an unusual number of components is kept as a generic one.
    if own.len() == count { own } else { generic_names(&generic_stem(&layer.semantic.to_string()), count) }
}

/// Returns a generic layer's name as one word that has no other meaning.
fn generic_stem(name: &str) -> String {
    let word = word_of(name);
    if word.is_empty() || has_meaning(&word) { format!("generic_{word}") } else { word }
}

fn generic_names(stem: &str, count: usize) -> Vec<String> {
    match count {
        1 => vec![stem.to_owned()],
        _ => (0..count).map(|c| format!("{stem}.{c}")).collect(),
    }
}
