//! Attributes by the names that glTF gives them.

use striata::mesh::{AttributeLayer, LayerData, Semantic};

use crate::Failure;

/// Makes a layer of an attribute; morph targets have a number in front of the name: `0/POSITION`.
///
/// # Errors
/// If the number of values does not fit the number of vertices.
pub(crate) fn layer_of(
    name: &str,
    component_count: u8,
    data: LayerData,
    vertex_count: usize,
) -> Result<AttributeLayer, Failure> {
    if component_count == 0 || data.len() != usize::from(component_count) * vertex_count {
        return Err(Failure::unsupported(
            [name, " does not have as many values as there are vertices"].concat(),
        ));
    }
    Ok(AttributeLayer { semantic: semantic_of(name), component_count, normalized: false, data })
}

/// The meaning of an attribute of glTF.
fn semantic_of(name: &str) -> Semantic {
    let generic = || Semantic::Generic(name.to_owned());
    if let Some((target, morphed)) = name.split_once('/') {
        let Ok(target) = target.parse() else { return generic() };
        return match morphed {
            "POSITION" => Semantic::MorphPosition(target),
            "NORMAL" => Semantic::MorphNormal(target),
            "TANGENT" => Semantic::MorphTangent(target),
            _ => generic(),
        };
    }
    let numbered = |prefix: &str| name.strip_prefix(prefix).and_then(|set| set.parse().ok());
    match name {
        "NORMAL" => Semantic::Normal,
        "TANGENT" => Semantic::Tangent,
        _ => None
            .or_else(|| numbered("TEXCOORD_").map(Semantic::TexCoord))
            .or_else(|| numbered("COLOR_").map(Semantic::Color))
            .or_else(|| numbered("JOINTS_").map(Semantic::Joints))
            .or_else(|| numbered("WEIGHTS_").map(Semantic::Weights))
            .unwrap_or_else(generic),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_attributes_have_their_meanings() {
        let expected = [
            ("NORMAL", Semantic::Normal),
            ("TEXCOORD_1", Semantic::TexCoord(1)),
            ("WEIGHTS_0", Semantic::Weights(0)),
            ("12/POSITION", Semantic::MorphPosition(12)),
            ("_FEATURE", Semantic::Generic("_FEATURE".to_owned())),
            ("TEXCOORD_x", Semantic::Generic("TEXCOORD_x".to_owned())),
        ];
        for (name, semantic) in expected {
            assert_eq!(semantic_of(name), semantic);
        }
    }
}
