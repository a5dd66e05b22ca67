//! Lights of a document.

use striata_gpu::{LitFrame, LitLight, LitLightKind};
use striata_scene::drawn::{Light, LightKind};

/// Converts lights; those beyond the renderer's limit are left out.
pub(crate) fn lit_lights(lights: &[Light]) -> Vec<LitLight> {
    let lit = lights.iter().take(LitFrame::MAX_LIGHT_COUNT).map(|light| LitLight {
        kind: match light.kind {
            LightKind::Directional => LitLightKind::Directional,
            LightKind::Point => LitLightKind::Point,
            LightKind::Spot { inner_cos, outer_cos } => {
                LitLightKind::Spot { inner_angle: inner_cos.acos(), outer_angle: outer_cos.acos() }
            }
        },
        color: light.color,
        position: light.position.map(f64::from),
        direction: light.direction,
        range: light.range,
    });
    lit.collect()
}
