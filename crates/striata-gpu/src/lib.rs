//! Draws striata's levels of detail with wgpu.
