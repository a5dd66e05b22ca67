//! A z-buffer for triangles: perspective, interpolated normals, a few lights.
//!
//! Triangles are set up in pixels, walked over their bounding rectangle and kept where nearest. Light is a
//! warm key from the upper left, a cool fill from the right and a sky; the camera carries the lights.
//! Time O(pixels covered), memory O(pixels).

use super::{Canvas, Rgb};

type Vec3 = [f32; 3];

/// Where the picture is taken from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Camera {
    /// Eye, mesh units.
    pub(crate) eye: Vec3,
    /// What lies in the middle of the picture.
    pub(crate) look_at: Vec3,
    /// What points up in the picture.
    pub(crate) up: Vec3,
    /// Height of the view, radians.
    pub(crate) fov: f32,
}

/// How triangles are coloured.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Paint<'a> {
    /// One colour, smooth by one normal a vertex.
    Smooth(Rgb, &'a [Vec3]),
    /// A colour for each triangle, flat.
    Flat(&'a [Rgb]),
}

/// What is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    /// One position a vertex.
    pub(crate) positions: &'a [Vec3],
    /// Triangles over them.
    pub(crate) triangles: &'a [[u32; 3]],
    /// Their colours.
    pub(crate) paint: Paint<'a>,
}

/// A vertex on the screen: pixels, and one over the distance.
#[derive(Clone, Copy, Debug)]
struct Projected {
    x: f32,
    y: f32,
    inverse_depth: f32,
}

/// Draws the surface onto the canvas.
pub(crate) fn draw(canvas: &mut Canvas, camera: &Camera, surface: &Surface<'_>) {
    let view = View::new(camera, canvas.width, canvas.height);
    let projected: Vec<Projected> = surface.positions.iter().map(|&p| view.project(p)).collect();
    let mut nearest = vec![0.0f32; canvas.width * canvas.height];
    for (index, corners) in surface.triangles.iter().enumerate() {
        let screen = corners.map(|v| projected[v as usize]);
        if screen.iter().any(|p| p.inverse_depth <= 0.0) {
            continue;
        }
        let shade = Shade::of(surface, index, &view);
        fill(canvas, &mut nearest, &screen, &shade);
    }
}

/// The camera as three axes and a scale.
struct View {
    eye: Vec3,
    right: Vec3,
    up: Vec3,
    forward: Vec3,
    scale: f32,
    centre: [f32; 2],
}

impl View {
    fn new(camera: &Camera, width: usize, height: usize) -> Self {
        let forward = unit(minus(camera.look_at, camera.eye));
        let right = unit(cross(forward, camera.up));
        let up = cross(right, forward);
        let scale = height as f32 / 2.0 / (camera.fov / 2.0).tan();
        Self { eye: camera.eye, right, up, forward, scale, centre: [width as f32 / 2.0, height as f32 / 2.0] }
    }

    fn project(&self, point: Vec3) -> Projected {
        let p = minus(point, self.eye);
        let inverse_depth = 1.0 / dot(p, self.forward);
        Projected {
            x: self.centre[0] + self.scale * dot(p, self.right) * inverse_depth,
            y: self.centre[1] - self.scale * dot(p, self.up) * inverse_depth,
            inverse_depth,
        }
    }

    /// A direction as the camera sees it: right, up, towards the eye.
    fn turned(&self, n: Vec3) -> Vec3 {
        [dot(n, self.right), dot(n, self.up), -dot(n, self.forward)]
    }
}

/// Colour and normals of one triangle.
struct Shade {
    colour: Rgb,
    normals: [Vec3; 3],
}

impl Shade {
    fn of(surface: &Surface<'_>, triangle: usize, view: &View) -> Self {
        let corners = surface.triangles[triangle];
        let [a, b, c] = corners.map(|v| surface.positions[v as usize]);
        let flat = view.turned(unit(cross(minus(b, a), minus(c, a))));
        // A triangle that is seen from behind is lit as if it were two-sided.
        let side = |n: Vec3| if flat[2] < 0.0 { n.map(|x| -x) } else { n };
        match surface.paint {
            Paint::Smooth(colour, normals) => {
                Self { colour, normals: corners.map(|v| side(view.turned(normals[v as usize]))) }
            }
            Paint::Flat(colours) => Self { colour: colours[triangle], normals: [side(flat); 3] },
        }
    }

    fn at(&self, weights: [f32; 3]) -> Rgb {
        let mut normal = [0.0; 3];
        for (axis, sum) in normal.iter_mut().enumerate() {
            *sum = (0..3).map(|corner| weights[corner] * self.normals[corner][axis]).sum();
        }
        lit(self.colour, unit(normal))
    }
}

/// Directions towards the lights as the camera sees them, with their colours.
const LIGHTS: [(Vec3, Rgb); 2] =
    [([-0.52, 0.58, 0.63], [1.05, 0.98, 0.88]), ([0.86, -0.10, 0.50], [0.16, 0.20, 0.27])];

fn lit(colour: Rgb, normal: Vec3) -> Rgb {
    let sky = 0.5 + 0.5 * normal[1];
    let mut light = [0.05 + 0.10 * sky, 0.05 + 0.11 * sky, 0.05 + 0.14 * sky];
    for (towards, shine) in LIGHTS {
        let amount = dot(normal, towards).max(0.0);
        light = [light[0] + shine[0] * amount, light[1] + shine[1] * amount, light[2] + shine[2] * amount];
    }
    let half = unit([LIGHTS[0].0[0], LIGHTS[0].0[1], LIGHTS[0].0[2] + 1.0]);
    let gloss = 0.10 * dot(normal, half).max(0.0).powi(24);
    [colour[0] * light[0] + gloss, colour[1] * light[1] + gloss, colour[2] * light[2] + gloss]
}

/// Colours the pixels whose centres lie in the triangle and that nothing nearer covers.
fn fill(canvas: &mut Canvas, nearest: &mut [f32], screen: &[Projected; 3], shade: &Shade) {
    let [a, b, c] = *screen;
    let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if area == 0.0 || !area.is_finite() {
        return;
    }
    let width = canvas.width;
    let columns = covered(a.x, b.x, c.x, width);
    for y in covered(a.y, b.y, c.y, canvas.height) {
        let row = canvas.row_mut(y);
        let py = y as f32 + 0.5;
        for x in columns.clone() {
            let px = x as f32 + 0.5;
            let wa = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
            let wb = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
            let wc = 1.0 - wa - wb;
            if wa < 0.0 || wb < 0.0 || wc < 0.0 {
                continue;
            }
            let depth = wa * a.inverse_depth + wb * b.inverse_depth + wc * c.inverse_depth;
            let kept = &mut nearest[y * width + x];
            if depth > *kept {
                *kept = depth;
                let weights = [wa * a.inverse_depth, wb * b.inverse_depth, wc * c.inverse_depth];
                row[x] = shade.at(weights.map(|w| w / depth));
            }
        }
    }
}

/// The pixels of a row or column whose centres may lie between three coordinates.
fn covered(a: f32, b: f32, c: f32, size: usize) -> std::ops::Range<usize> {
    let low = a.min(b).min(c).floor().clamp(0.0, size as f32);
    let high = a.max(b).max(c).ceil().clamp(0.0, size as f32);
    low as usize..high as usize
}

fn minus(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vec3, b: Vec3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vec3) -> Vec3 {
    let length = dot(a, a).sqrt();
    if length > 0.0 { a.map(|x| x / length) } else { [0.0, 0.0, 1.0] }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Camera = Camera { eye: [0.0, 0.0, 5.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };

    fn middle(triangles: &[[u32; 3]], colours: &[Rgb]) -> Rgb {
        let positions = [
            [-1.0, -1.0, 0.0],
            [1.0, -1.0, 0.0],
            [0.0, 1.0, 0.0],
            [-1.0, -1.0, 1.0],
            [1.0, -1.0, 1.0],
            [0.0, 1.0, 1.0],
        ];
        let mut canvas = Canvas::filled(21, 21, [0.5; 3]);
        draw(
            &mut canvas,
            &CAMERA,
            &Surface { positions: &positions, triangles, paint: Paint::Flat(colours) },
        );
        assert_eq!(canvas.row_mut(0)[0], [0.5; 3], "the corner is background");
        canvas.row_mut(10)[10]
    }

    #[test]
    fn the_nearer_triangle_hides_the_other_in_any_order() {
        let (far, near) = ([0, 1, 2], [3, 4, 5]);
        let (red, blue) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
        let one = middle(&[far, near], &[red, blue]);
        let other = middle(&[near, far], &[blue, red]);
        assert_eq!(one, other);
        assert!(one[2] > 2.0 * one[0], "blue is in front: {one:?}");
    }

    #[test]
    fn what_lies_behind_the_eye_is_not_drawn() {
        let positions = [[-1.0, -1.0, 9.0], [1.0, -1.0, 9.0], [0.0, 1.0, 9.0]];
        let mut canvas = Canvas::filled(5, 5, [0.5; 3]);
        let paint = Paint::Flat(&[[1.0; 3]]);
        draw(&mut canvas, &CAMERA, &Surface { positions: &positions, triangles: &[[0, 1, 2]], paint });
        assert_eq!(canvas.row_mut(2)[2], [0.5; 3]);
    }
}
