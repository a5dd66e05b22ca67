//! Triangles of flat faces never turn over within their plane: a flat face is neither covered twice nor
//! larger than it was.

use proptest::prelude::*;
use striata::mesh::{IndexedMesh, Random, replay, replay_fragments, shapes};
use striata::simplify::{
    BatchOptions, CostFunction, PlacedOptions, Placement, RemovalOptions, RemovalOrder, Retriangulation,
    SequenceOptions, SimplifyOptions, Target, TopologyRule, build_batches, build_fragments,
    build_placed_fragments, build_sequence, simplify,
};

const SHARES: [f64; 4] = [0.9, 0.7, 0.5, 0.3];
/// Share of the diagonal by which a corner may be off the plane of a face.
const OFF_PLANE: f64 = 1e-5;

/// The plane of a flat face: its unit normal and its distance from the origin.
type Plane = ([f64; 3], f64);

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Sums of the areas in a plane that face its way and the opposite way, and the number of triangles that
/// clearly do the latter.
fn areas_in(mesh: &IndexedMesh, (normal, distance): Plane) -> (f64, f64, usize) {
    let (mut agreeing, mut opposing, mut turned_count) = (0.0, 0.0, 0);
    let diagonal = mesh.diagonal();
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| mesh.positions[v as usize].map(f64::from));
        if [a, b, c].iter().any(|&p| (dot(p, normal) - distance).abs() > OFF_PLANE * diagonal) {
            continue;
        }
        let [ab, ac] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let cross =
            [ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]];
        let area = 0.5 * dot(cross, normal);
        agreeing += area.max(0.0);
        opposing += (-area).max(0.0);
        turned_count += usize::from(area < -1e-9 * diagonal * diagonal);
    }
    (agreeing, opposing, turned_count)
}

fn check_faces(name: &str, level: &IndexedMesh, planes: &[Plane]) {
    for &plane in planes {
        let (agreeing, opposing, turned_count) = areas_in(level, plane);
        let count = level.triangle_count();
        assert_eq!(turned_count, 0, "{name}, {count} triangles: area {opposing} is turned over");
        assert!(opposing <= 1e-6 * agreeing, "{name}, {count} triangles: {opposing} of {agreeing}");
    }
}

/// Checks levels of every kind of simplification.
fn check_everything(name: &str, mesh: &IndexedMesh, planes: &[Plane]) {
    let targets = SHARES.map(|share| Target::Triangles((share * mesh.triangle_count() as f64) as usize));
    check_faces(name, mesh, planes);
    for &cost in CostFunction::ALL {
        check_collapses(name, mesh, &SequenceOptions::default().with_cost(cost), &targets, planes);
    }
    let built = build_batches(mesh, &BatchOptions::default()).expect("valid").built;
    for target in targets {
        let (split_count, _) = target.resolve(&built.refinable.sequence);
        check_faces(&format!("{name}, batches"), &replay(&built.refinable, split_count), planes);
        let options = SimplifyOptions::default().with_placement(Placement::Optimal).with_target(target);
        let level = simplify(mesh, &options).expect("valid").mesh;
        check_faces(&format!("{name}, optimal placement"), &level, planes);
    }
    let placed = build_placed_fragments(mesh, &PlacedOptions::default()).expect("valid").fragmented;
    let mut removed = vec![("placed".to_owned(), placed)];
    for order in [RemovalOrder::Mixed, RemovalOrder::Hausdorff] {
        for filling in [Retriangulation::Free, Retriangulation::Collapse] {
            let options = RemovalOptions::default().with_order(order).with_retriangulation(filling);
            let fragmented = build_fragments(mesh, &options).expect("valid").fragmented;
            removed.push((format!("{order:?} {filling:?}"), fragmented));
        }
    }
    for (kind, fragmented) in removed {
        for target in targets {
            let (split_count, _) = target.resolve_in(fragmented.fragments.levels());
            check_faces(&format!("{name}, {kind}"), &replay_fragments(&fragmented, split_count), planes);
        }
    }
}

fn check_collapses(
    name: &str,
    mesh: &IndexedMesh,
    options: &SequenceOptions,
    targets: &[Target],
    planes: &[Plane],
) {
    let built = build_sequence(mesh, options).expect("valid");
    for target in targets {
        let (split_count, _) = target.resolve(&built.refinable.sequence);
        check_faces(&format!("{name}, {:?}", options.cost), &replay(&built.refinable, split_count), planes);
    }
}

/// A square plate of `tiles` by `tiles` tiles, each with a round hole of `corners` corners. Fans of slivers
/// join the holes with the corners of the tiles, as CAD exporters make them.
struct Plate {
    tiles: u32,
    corners: u32,
}

/// The top face of a plate, and its border edges.
struct FlatPlate {
    points: Vec<[f32; 2]>,
    triangles: Vec<[u32; 3]>,
    walls: Vec<[u32; 2]>,
}

impl Plate {
    /// Builds the solid; `place(point, is_top)` returns where a point of the top or bottom face lies.
    fn solid(&self, place: impl Fn([f32; 2], bool) -> [f32; 3]) -> IndexedMesh {
        let FlatPlate { points, triangles: flat, walls } = self.flat();
        let count = points.len() as u32;
        let positions = [true, false].map(|is_top| points.iter().map(move |&p| (p, is_top)));
        let mut mesh = IndexedMesh {
            positions: positions.into_iter().flatten().map(|(p, is_top)| place(p, is_top)).collect(),
            triangles: flat.clone(),
            ..IndexedMesh::default()
        };
        mesh.triangles.extend(flat.iter().map(|&[a, b, c]| [c + count, b + count, a + count]));
        for [a, b] in walls {
            mesh.triangles.extend([[b, a, a + count], [b, a + count, b + count]]);
        }
        mesh
    }

    /// Builds the top face.
    fn flat(&self) -> FlatPlate {
        let n = self.tiles;
        let mut points: Vec<[f32; 2]> =
            (0..(n + 1) * (n + 1)).map(|i| [(i % (n + 1)) as f32, (i / (n + 1)) as f32]).collect();
        let (mut triangles, mut walls) = (Vec::new(), Vec::new());
        for tile in 0..n * n {
            let (x, y) = (tile % n, tile / n);
            let corner =
                |i: u32| (y + [0, 0, 1, 1][i as usize % 4]) * (n + 1) + x + [0, 1, 1, 0][i as usize % 4];
            let first = points.len() as u32;
            for i in 0..self.corners {
                let [sin, cos] = unit(i, self.corners);
                points.push([x as f32 + 0.5 + 0.3 * cos, y as f32 + 0.5 + 0.3 * sin]);
            }
            let ring = |i: u32| first + i % self.corners;
            for i in 0..self.corners {
                let quarter = 4 * i / self.corners;
                triangles.push([ring(i), corner(quarter + 2), ring(i + 1)]);
                walls.push([ring(i + 1), ring(i)]);
                if 4 * (i + 1) / self.corners > quarter {
                    triangles.push([ring(i + 1), corner(quarter + 2), corner(quarter + 3)]);
                }
            }
        }
        for i in 0..n {
            let side = |j: u32, k: u32| j * (n + 1) + k;
            walls.extend([[side(0, i), side(0, i + 1)], [side(n, i + 1), side(n, i)]]);
            walls.extend([[side(i + 1, 0), side(i, 0)], [side(i, n), side(i + 1, n)]]);
        }
        FlatPlate { points, triangles, walls }
    }
}

/// Sine and cosine of a share of a turn.
fn unit(i: u32, count: u32) -> [f32; 2] {
    let angle = f64::from(i) / f64::from(count) * std::f64::consts::TAU;
    [angle.sin() as f32, angle.cos() as f32]
}

const TOP: Plane = ([0.0, 0.0, 1.0], 0.125);
const BOTTOM: Plane = ([0.0, 0.0, -1.0], 0.0);

#[test]
fn plates_with_holes_stay_flat() {
    for (tiles, corners) in [(1, 64), (2, 32), (3, 48)] {
        let solid = Plate { tiles, corners }.solid(|[x, y], is_top| [x, y, if is_top { 0.125 } else { 0.0 }]);
        check_everything(&format!("plate of {tiles}, holes of {corners}"), &solid, &[TOP, BOTTOM]);
    }
}

#[test]
fn wedges_with_holes_stay_flat() {
    // Along its edge, the two faces of the wedge are nearly opposite.
    let solid = Plate { tiles: 3, corners: 32 }
        .solid(|[x, y], is_top| [x, y, if is_top { 0.015625 + 0.125 * x } else { 0.0 }]);
    let length = (1.0f64 + 0.125 * 0.125).sqrt();
    let top = ([-0.125 / length, 0.0, 1.0 / length], 0.015625 / length);
    check_everything("wedge", &solid, &[top, BOTTOM]);
}

#[test]
fn rotated_plates_stay_flat() {
    // An exact rotation by fractions, so that only the rounding to single precision is off the plane.
    let rows = [
        [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0],
        [2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0],
        [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0],
    ];
    let normal = [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];
    for corners in [32, 48] {
        let solid = Plate { tiles: 2, corners }.solid(|[x, y], is_top| {
            let p = [x, y, if is_top { 0.125 } else { 0.0 }].map(f64::from);
            rows.map(|row| dot(row, p) as f32)
        });
        let normal = [normal[0], rows[1][2], rows[2][2]];
        let planes = [(normal, 0.125), (normal.map(|x| -x), 0.0)];
        check_everything("rotated plate", &solid, &planes);
    }
}

#[test]
fn borders_of_grids_stay_flat() {
    let mut random = Random::new(1);
    for (columns, rows, uneven) in [(40, 3, 0.1), (16, 16, 0.0), (16, 16, 0.3)] {
        let mut grid = shapes::height_field(columns, rows, |_, _| 0.0);
        for position in grid.positions.iter_mut().take(columns as usize + 1) {
            position[1] += uneven * random.between(-1.0, 1.0);
        }
        check_everything(&format!("grid of {columns} by {rows}"), &grid, &[([0.0, 0.0, 1.0], 0.0)]);
    }
}

#[test]
fn cut_through_a_bumpy_solid_stays_flat() {
    // A bumpy terrain over a flat cut; fans of slivers join its walls with a row of points on the cut.
    let n = 16;
    let mut random = Random::new(7);
    let mut solid = shapes::height_field(n, n, |_, _| 2.0 + random.between(0.0, 0.5));
    let border: Vec<u32> = (0..n)
        .chain((0..n).map(|i| (n + 1) * i + n))
        .chain((0..n).map(|i| (n + 1) * (n + 1) - 1 - i))
        .chain((0..n).map(|i| (n + 1) * (n - i)))
        .collect();
    let first = solid.positions.len() as u32;
    let cut: Vec<[f32; 3]> =
        border.iter().map(|&v| solid.positions[v as usize]).map(|[x, y, _]| [x, y, 0.0]).collect();
    solid.positions.extend(&cut);
    let count = border.len() as u32;
    for i in 0..count {
        let j = (i + 1) % count;
        let [a, b] = [i, j].map(|i| border[i as usize]);
        solid.triangles.extend([[b, a, first + i], [b, first + i, first + j]]);
        if i > 0 && j > 0 {
            // The first side is collinear with the corner of the fan: triangles without area.
            solid.triangles.push([first, first + j, first + i]);
        }
    }
    check_everything("cut", &solid, &[BOTTOM]);
}

/// Twice the signed area of integer points: exact.
fn doubled_area([a, b, c]: [[i32; 2]; 3]) -> i32 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// A random triangulation of a square: a jittered grid in which random edges are flipped as long as no
/// triangle turns over; some lose their area.
fn random_triangulation(n: i32, flip_count: usize, seed: u64) -> (Vec<[i32; 2]>, Vec<[u32; 3]>) {
    let mut random = Random::new(seed);
    let mut jitter = |is_free: bool| if is_free { random.between(-2.9, 2.9) as i32 } else { 0 };
    let mut points = Vec::new();
    for i in 0..(n + 1) * (n + 1) {
        let (x, y) = (i % (n + 1), i / (n + 1));
        let is_inner = |x: i32| x > 0 && x < n;
        points.push([10 * x + jitter(is_inner(x)), 10 * y + jitter(is_inner(y))]);
    }
    let mut triangles = shapes::grid(n as u32, n as u32).triangles;
    for _ in 0..flip_count {
        let t = random.between(0.0, triangles.len() as f32) as usize % triangles.len();
        let [a, b, c] = triangles[t];
        let other = triangles.iter().position(|o| (0..3).any(|k| o[k] == b && o[(k + 1) % 3] == a));
        let Some(other) = other else { continue };
        let Some(&d) = triangles[other].iter().find(|&&v| v != a && v != b) else { continue };
        let at = |t: [u32; 3]| t.map(|v| points[v as usize]);
        let exists = triangles.iter().any(|o| o.contains(&c) && o.contains(&d));
        let flipped = [[c, a, d], [d, b, c]];
        if !exists && flipped.iter().all(|&t| doubled_area(at(t)) >= 0) {
            (triangles[t], triangles[other]) = (flipped[0], flipped[1]);
        }
    }
    (points, triangles)
}

proptest! {
    #![proptest_config(striata_testing::cases(12))]

    #[test]
    fn random_triangulations_of_a_square_stay_flat(seed in any::<u64>(), flip_count in 0usize..300) {
        let (points, triangles) = random_triangulation(7, flip_count, seed);
        let tilted = [1.0 / 3f64.sqrt(); 3];
        for (name, tilt, normal) in [("level", 0, [0.0, 0.0, 1.0]), ("tilted", -1, tilted)] {
            let plane = (normal, 0.0);
            let place = |&[x, y]: &[i32; 2]| [x, y, tilt * (x + y)].map(|coordinate| coordinate as f32);
            let mesh = IndexedMesh {
                positions: points.iter().map(place).collect(),
                triangles: triangles.clone(),
                ..IndexedMesh::default()
            };
            check_everything(name, &mesh, &[plane]);
            // Collapses that preserve the topology never fold, however far they go.
            let shares = [0.2, 0.1, 0.05, 0.0].map(|share| Target::Triangles((share * 98.0) as usize));
            for &cost in CostFunction::ALL {
                let options = SequenceOptions::default().with_cost(cost).with_topology(TopologyRule::Keep);
                check_collapses(name, &mesh, &options, &shares, &[plane]);
            }
        }
    }
}
