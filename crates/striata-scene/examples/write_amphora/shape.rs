//! Shapes of the scene: surfaces of revolution with a relief, and swept tubes.

use std::f32::consts::TAU;

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

/// Height of the top of the wheel.
pub(crate) const WHEEL_TOP: f32 = 0.5;

/// Height and radius along the wall of the vase, from the foot over the lip to the bottom inside.
const VASE: [[f32; 2]; 24] = [
    [0.0, 0.0],
    [0.0, 0.3],
    [0.03, 0.36],
    [0.09, 0.34],
    [0.13, 0.24],
    [0.2, 0.24],
    [0.4, 0.46],
    [0.7, 0.68],
    [1.0, 0.77],
    [1.25, 0.74],
    [1.48, 0.58],
    [1.62, 0.38],
    [1.72, 0.27],
    [1.95, 0.23],
    [2.15, 0.25],
    [2.22, 0.34],
    [2.28, 0.36],
    [2.29, 0.31],
    [2.2, 0.23],
    [1.95, 0.18],
    [1.7, 0.22],
    [1.4, 0.58],
    [1.0, 0.7],
    [0.3, 0.28],
];

const WHEEL: [[f32; 2]; 8] = [
    [0.32, 0.0],
    [0.32, 0.2],
    [0.36, 0.24],
    [0.38, 1.0],
    [0.42, 1.05],
    [0.48, 1.05],
    [WHEEL_TOP, 1.02],
    [WHEEL_TOP, 0.0],
];

const STAND: [[f32; 2]; 10] = [
    [0.0, 0.0],
    [0.0, 0.75],
    [0.04, 0.8],
    [0.08, 0.78],
    [0.12, 0.5],
    [0.16, 0.22],
    [0.24, 0.16],
    [0.3, 0.18],
    [0.34, 0.24],
    [0.34, 0.0],
];

/// The body of the amphora, with flutes above the foot and a ring of beads on the shoulder.
pub(crate) fn vase() -> IndexedMesh {
    let relief = |[height, _]: [f32; 2], turn: f32| {
        let flutes = bump(height, 0.42, 0.2) * 0.014 * (36.0 * TAU * turn).cos();
        let beads = bump(height, 1.56, 0.035) * 0.016 * (48.0 * TAU * turn).cos();
        flutes + beads
    };
    revolved(&VASE, [192, 140], &relief)
}

/// The turning disc.
pub(crate) fn wheel() -> IndexedMesh {
    revolved(&WHEEL, [96, 40], &|_, _| 0.0)
}

/// The foot below the disc.
pub(crate) fn stand() -> IndexedMesh {
    revolved(&STAND, [96, 40], &|_, _| 0.0)
}

/// A handle from the neck to the shoulder: a tube with three ridges along a curve.
pub(crate) fn handle() -> IndexedMesh {
    const PATH: [[f32; 2]; 6] =
        [[2.08, 0.2], [2.16, 0.4], [2.08, 0.6], [1.86, 0.68], [1.6, 0.62], [1.42, 0.6]];
    let center = |along: f32| spline(&PATH, along, 0.5);
    let point = |[along, around]: [f32; 2]| {
        let [height, out] = center(along);
        let step = 1e-3;
        let (before, after) = (center((along - step).max(0.0)), center((along + step).min(1.0)));
        let [up, outward] = [after[0] - before[0], after[1] - before[1]];
        let length = up.hypot(outward).max(1e-9);
        // The normal of the path in its plane, and the axis across the plane.
        let normal = [-outward / length, up / length];
        let angle = TAU * around;
        let radius = 1.0 + 0.12 * (3.0 * angle).cos();
        let [inside, across] = [0.045 * radius * angle.cos(), 0.085 * radius * angle.sin()];
        [out + inside * normal[1], height + inside * normal[0], across]
    };
    surface([96, 40], &point)
}

/// Rotates a profile of heights and radii around the y axis; `relief` is added to the radius.
fn revolved(profile: &[[f32; 2]], size: [usize; 2], relief: &dyn Fn([f32; 2], f32) -> f32) -> IndexedMesh {
    let point = |[turn, along]: [f32; 2]| {
        let [height, radius] = spline(profile, along, 0.25);
        let radius = (radius + if radius > 0.01 { relief([height, radius], turn) } else { 0.0 }).max(0.0);
        let angle = TAU * turn;
        [radius * angle.cos(), height, -radius * angle.sin()]
    };
    surface(size, &point)
}

/// Samples a surface over the unit square, with normals and texture coordinates. Texture coordinates have
/// v = 0 at the top.
fn surface([columns, rows]: [usize; 2], point: &dyn Fn([f32; 2]) -> [f32; 3]) -> IndexedMesh {
    let (mut positions, mut normals, mut uvs) = (Vec::new(), Vec::new(), Vec::new());
    for row in 0..=rows {
        for column in 0..=columns {
            let at = [column as f32 / columns as f32, row as f32 / rows as f32];
            positions.push(point(at));
            normals.extend(normal(at, point));
            uvs.extend([at[0], 1.0 - at[1]]);
        }
    }
    let corner = |row: usize, column: usize| (row * (columns + 1) + column) as u32;
    let mut triangles = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let [a, b] = [corner(row, column), corner(row, column + 1)];
            let [c, d] = [corner(row + 1, column), corner(row + 1, column + 1)];
            triangles.extend([[a, b, d], [a, d, c]]);
        }
    }
    triangles.retain(|t| {
        let [a, b, c] = t.map(|v| positions[v as usize]);
        a != b && b != c && a != c
    });
    IndexedMesh {
        positions,
        triangles,
        layers: vec![
            AttributeLayer::from_f32(Semantic::Normal, 3, normals),
            AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs),
        ],
        ..IndexedMesh::default()
    }
}

/// Unit normal by differences; at a pole, that of a place next to it.
fn normal([u, v]: [f32; 2], point: &dyn Fn([f32; 2]) -> [f32; 3]) -> [f32; 3] {
    const STEP: f32 = 2e-3;
    let v = v.clamp(STEP, 1.0 - STEP);
    let minus = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|k| a[k] - b[k]);
    let across = minus(point([u + STEP, v]), point([u - STEP, v]));
    let along = minus(point([u, v + STEP]), point([u, v - STEP]));
    let cross = [0, 1, 2].map(|k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        across[i] * along[j] - across[j] * along[i]
    });
    let length = cross.iter().map(|x| x * x).sum::<f32>().sqrt();
    if length > 0.0 { cross.map(|x| x / length) } else { [0.0, 1.0, 0.0] }
}

/// Point of a curve through all points, at 0 to 1 along it. With `tension` 0.5 it is a Catmull-Rom curve;
/// with less, edges of the profile do not swing over.
fn spline(points: &[[f32; 2]], along: f32, tension: f32) -> [f32; 2] {
    let last = points.len() - 1;
    let at = along.clamp(0.0, 1.0) * last as f32;
    let segment = (at as usize).min(last - 1);
    let t = at - segment as f32;
    let point = |offset: isize| points[segment.saturating_add_signed(offset).min(last)];
    let (p, q, r, s) = (point(-1), point(0), point(1), point(2));
    [0, 1].map(|k| {
        let (p, q, r, s) = (p[k], q[k], r[k], s[k]);
        let (from, to) = (tension * (r - p), tension * (s - q));
        let (t2, t3) = (t * t, t * t * t);
        (2.0 * t3 - 3.0 * t2 + 1.0) * q
            + (t3 - 2.0 * t2 + t) * from
            + (3.0 * t2 - 2.0 * t3) * r
            + (t3 - t2) * to
    })
}

/// 1 in the middle, falling smoothly to 0 at `width`.
fn bump(x: f32, middle: f32, width: f32) -> f32 {
    let t = ((x - middle) / width).abs().min(1.0);
    (1.0 - t * t).powi(2)
}
