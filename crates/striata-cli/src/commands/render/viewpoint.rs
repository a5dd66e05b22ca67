//! The camera of a picture.

use crate::args::RenderArgs;
use striata_command::args::Point;
use striata_command::failure::Failure;
use striata_render::{Camera, Frustum, ViewAngles};

use super::source::PictureSource;

/// The camera of a picture, for any aspect ratio.
pub(super) struct Viewpoint {
    placement: CameraPlacement,
    zoom: f32,
    /// The frustum of the view, if the picture shows a view from outside.
    pub frustum: Option<Frustum>,
}

enum CameraPlacement {
    /// A fixed camera.
    Fixed(Camera),
    /// A camera at these angles, as close as possible with all of these points visible.
    Framing(Vec<[f32; 3]>, ViewAngles),
}

/// Default field of view of a camera given by `--from`, degrees.
const DEFAULT_FOV: f32 = 45.0;
/// Default field of view of a view, the same as for `extract`, degrees.
const VIEW_FOV: f32 = 60.0;

impl Viewpoint {
    /// Chooses the camera from the flags.
    ///
    /// # Errors
    /// If the camera looks at its own position.
    pub(super) fn new(args: &RenderArgs, source: &PictureSource<'_>) -> Result<Self, Failure> {
        let mesh = source.mesh();
        let center = mesh.bounds().map_or([0.0; 3], |b| [0, 1, 2].map(|k| (b.min[k] + b.max[k]) / 2.0));
        let is_outside = args.from.is_some() || args.turn.is_some() || args.rise.is_some();
        if let (Some(name), Some(scene)) = (&args.camera, source.scene()) {
            let placement = CameraPlacement::Fixed(scene.camera(name, center)?);
            return Ok(Self { placement, zoom: args.zoom, frustum: None });
        }
        // In scenes, y is up, whatever their shape.
        let is_terrain = !mesh.appearance.georeference.is_empty();
        let bounds = mesh.bounds().filter(|_| source.scene().is_none());
        let usual = ViewAngles::usual(bounds.as_ref(), is_terrain);
        let up = args.view.up().unwrap_or(usual.up);
        let fov = |usual: f32| args.view.fov().map_or(usual.to_radians(), |angle| angle as f32);
        let look_at = args.view.relative_to(mesh.origin).look_at().unwrap_or(center);
        let place = |point: Point| point.relative_to(mesh.origin).in_f32();
        let points = used_positions(mesh);
        let view = args.level.eye.map(|eye| {
            // The refinement criterion takes y as up by default, whatever the mesh looks like.
            let up = args.view.up().unwrap_or([0.0, 1.0, 0.0]);
            Camera { eye: place(eye), look_at, up, fov: fov(VIEW_FOV) }
        });
        if let (Some(view), false) = (view, is_outside) {
            return Ok(Self { placement: CameraPlacement::Fixed(view), zoom: args.zoom, frustum: None });
        }
        let [width, height] = args.view.viewport().unwrap_or(args.size.0).map(|side| side as f32);
        let frustum = view.map(|view| Frustum::new(&view, width / height, &points));
        // If there is a view, `--look-at` and `--fov` describe the view, not this camera.
        let is_view = frustum.is_some();
        let placement = match args.from {
            Some(eye) => {
                let eye = place(eye);
                let (look_at, fov) =
                    if is_view { (center, DEFAULT_FOV.to_radians()) } else { (look_at, fov(DEFAULT_FOV)) };
                if eye == look_at {
                    return Err(Failure::usage("the camera looks at its own position")
                        .with_hint("move --from or --look-at"));
                }
                CameraPlacement::Fixed(Camera { eye, look_at, up, fov })
            }
            None => {
                let fov = if is_view { usual.fov } else { fov(usual.fov.to_degrees()) };
                let turn = args.turn.map_or(usual.turn, f32::to_radians);
                let rise = args.rise.map_or(usual.rise, f32::to_radians);
                let seen = [points, frustum.iter().flat_map(Frustum::points).collect()].concat();
                CameraPlacement::Framing(seen, ViewAngles { turn, rise, up, fov })
            }
        };
        Ok(Self { placement, zoom: args.zoom, frustum })
    }

    /// Returns the camera for a picture of this aspect ratio.
    pub(super) fn camera(&self, aspect: f32) -> Camera {
        let camera = match &self.placement {
            CameraPlacement::Fixed(camera) => *camera,
            CameraPlacement::Framing(points, angles) => Camera::around(points, angles, aspect),
        };
        camera.zoomed(self.zoom)
    }

    /// Returns the aspect ratio of everything that the camera shows; `None` if the camera is fixed.
    pub(super) fn aspect(&self) -> Option<f32> {
        match &self.placement {
            CameraPlacement::Fixed(_) => None,
            CameraPlacement::Framing(points, angles) => {
                Some(Camera::around(points, angles, 1.0).aspect_of(points))
            }
        }
    }
}

/// Returns the positions that triangles use.
fn used_positions(mesh: &striata::mesh::IndexedMesh) -> Vec<[f32; 3]> {
    let mut is_used = vec![false; mesh.vertex_count()];
    mesh.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
    mesh.positions.iter().zip(is_used).filter(|&(_, is_used)| is_used).map(|(&p, _)| p).collect()
}
