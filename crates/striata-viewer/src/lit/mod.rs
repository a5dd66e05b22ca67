//! Scenes for the lit renderer of `striata-gpu`: materials, images and lights as it needs them.

mod lights;
mod materials;

pub(crate) use self::lights::lit_lights;
pub(crate) use self::materials::{lit_image, lit_material};
