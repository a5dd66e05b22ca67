//! Where the picture is taken from.

use crate::args::RenderArgs;
use striata_command::args::Point;
use striata_command::failure::Failure;
use striata_viewer::picture::{Angles, Camera, Frustum};

use super::source::Source;

/// Where the picture is taken from.
pub(super) struct Viewpoint {
    placement: CameraPlacement,
    zoom: f32,
    /// What a view sees, where it is looked at from outside.
    pub(super) frustum: Option<Frustum>,
}

enum CameraPlacement {
    /// Here.
    At(Camera),
    /// As near as all of these are still seen.
    Around(Vec<[f32; 3]>, Angles),
}

/// The angle of view from a viewpoint where nothing is said, degrees.
const DEFAULT_FOV: f32 = 45.0;
/// The same of a view, as for `extract`.
const VIEW_FOV: f32 = 60.0;

impl Viewpoint {
    /// # Errors
    /// Where the eye is at the point that it looks at.
    pub(super) fn new(args: &RenderArgs, source: &Source<'_>) -> Result<Self, Failure> {
        let mesh = source.mesh();
        let center = mesh.bounds().map_or([0.0; 3], |b| [0, 1, 2].map(|k| (b.min[k] + b.max[k]) / 2.0));
        let is_outside = args.from.is_some() || args.turn.is_some() || args.rise.is_some();
        let usual = Angles::usual(mesh.bounds().as_ref());
        let up = args.view.up().unwrap_or(usual.up);
        let fov = |usual: f32| args.view.fov().map_or(usual.to_radians(), |angle| angle as f32);
        let look_at = args.view.look_at().unwrap_or(center);
        let points = used_positions(mesh);
        let view = args.level.eye.map(|Point(eye)| {
            // To a criterion y is up wherever nothing is said.
            let up = args.view.up().unwrap_or([0.0, 1.0, 0.0]);
            Camera { eye, look_at, up, fov: fov(VIEW_FOV) }
        });
        if let (Some(view), false) = (view, is_outside) {
            return Ok(Self { placement: CameraPlacement::Fixed(view), zoom: args.zoom, frustum: None });
        }
        let [width, height] = args.view.viewport().unwrap_or(args.size.0).map(|side| side as f32);
        let frustum = view.map(|view| Frustum::new(&view, width / height, &points));
        // What is looked at, and how wide, was said of the view where there is one.
        let is_view = frustum.is_some();
        let placement = match args.from {
            Some(Point(eye)) => {
                let (look_at, fov) =
                    if is_view { (center, DEFAULT_FOV.to_radians()) } else { (look_at, fov(DEFAULT_FOV)) };
                if eye == look_at {
                    return Err(Failure::user("the picture is taken from the very point that it looks at")
                        .with_hint("move --from or --look-at"));
                }
                CameraPlacement::Fixed(Camera { eye, look_at, up, fov })
            }
            None => {
                let fov = if is_view { usual.fov } else { fov(usual.fov.to_degrees()) };
                let turn = args.turn.map_or(usual.turn, f32::to_radians);
                let rise = args.rise.map_or(usual.rise, f32::to_radians);
                let seen = [points, frustum.iter().flat_map(Frustum::points).collect()].concat();
                CameraPlacement::Framing(seen, Angles { turn, rise, up, fov })
            }
        };
        Ok(Self { placement, zoom: args.zoom, frustum })
    }

    /// The camera for pictures of that shape.
    pub(super) fn camera(&self, aspect: f32) -> Camera {
        let camera = match &self.placement {
            CameraPlacement::Fixed(camera) => *camera,
            CameraPlacement::Framing(points, angles) => Camera::around(points, angles, aspect),
        };
        camera.zoomed(self.zoom)
    }

    /// How many times as wide as high everything is, as seen from here; none where the camera stands still
    /// anyway.
    pub(super) fn aspect(&self) -> Option<f32> {
        match &self.placement {
            CameraPlacement::Fixed(_) => None,
            CameraPlacement::Framing(points, angles) => {
                Some(Camera::around(points, angles, 1.0).aspect_of(points))
            }
        }
    }
}

/// Positions that triangles use.
fn used_positions(mesh: &striata::mesh::IndexedMesh) -> Vec<[f32; 3]> {
    let mut is_used = vec![false; mesh.vertex_count()];
    mesh.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
    mesh.positions.iter().zip(is_used).filter(|&(_, is_used)| is_used).map(|(&p, _)| p).collect()
}
