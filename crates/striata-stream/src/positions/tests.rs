//! Round trips of positions on synthetic surfaces.

use striata::mesh::{IndexedMesh, Random, shapes};

use super::{MixedModel, PositionModel, Surroundings};
use crate::entropy::{Coder, RangeReader, RangeWriter};
use crate::format::effort::Effort;
use crate::topology::cutting::close;
use crate::topology::neighborhood::Neighborhood;
use crate::topology::surface::{NONE, Surface, next};

const EFFORTS: [Effort; 2] = [Effort::Fast, Effort::Compact];

/// A closed surface and the grid coordinates of its vertices.
struct TestSample {
    surface: Surface,
    coords: Vec<[i32; 3]>,
}

fn sample(mesh: &IndexedMesh, coords_of: impl Fn(usize) -> [i32; 3]) -> TestSample {
    let surface = close(&mesh.triangles, mesh.positions.len()).surface;
    let first = surface.virtual_count() as usize;
    let coords =
        (0..surface.vertex_count()).map(|v| v.checked_sub(first).map_or([0; 3], &coords_of)).collect();
    TestSample { surface, coords }
}

/// Quantizes a mesh to a grid with a number of steps per unit.
fn on_grid(mesh: &IndexedMesh, steps: f32) -> TestSample {
    sample(mesh, |v| mesh.positions[v].map(|x| (x * steps).round() as i32))
}

fn samples() -> Vec<TestSample> {
    let torus = shapes::torus(40, 16, 1.0, 0.4);
    let grid = shapes::grid(20, 15);
    let mut random = Random::new(2);
    let wild: Vec<[i32; 3]> =
        torus.positions.iter().map(|_| [(); 3].map(|()| random.next_u64() as i32)).collect();
    vec![
        on_grid(&torus, 1000.0),
        on_grid(&torus, 3.0),
        on_grid(&grid, 50.0),
        on_grid(&shapes::icosphere(3, 1.0), 4_000_000.0),
        sample(&torus, |v| wild[v]),
        sample(&torus, |v| if v % 2 == 0 { [i32::MIN; 3] } else { [i32::MAX; 3] }),
        sample(&grid, |_| [7; 3]),
    ]
}

/// Samples that a model can code: the one that predicts ahead requires grid coordinates of at most 24 bits.
fn samples_for(effort: Effort) -> Vec<TestSample> {
    let is_on_grid =
        |sample: &TestSample| sample.coords.iter().flatten().all(|x| (-1 << 23..1 << 23).contains(x));
    samples().into_iter().filter(|sample| effort != Effort::Fast || is_on_grid(sample)).collect()
}

/// Returns the known surroundings of a vertex.
fn around(neighborhood: &Neighborhood<'_>) -> Surroundings {
    let mut around = Surroundings { count: neighborhood.corners.len().min(8), ..Surroundings::default() };
    let spot = |vertex: u32| neighborhood.coords_of(vertex).map_or([0; 4], |[x, y, z]| [x, y, z, 1]);
    for (i, &corner) in neighborhood.corners.iter().enumerate().take(8) {
        around.ring[i] = spot(neighborhood.surface.vertex(next(corner)));
        around.across[i] = spot(neighborhood.surface.vertex(neighborhood.surface.opposite(corner)));
    }
    around
}

/// Codes all positions but the first few in order. `unknown` fills the positions that are not known yet.
fn code<C: Coder>(coder: &mut C, sample: &TestSample, effort: Effort, unknown: [i32; 3]) -> Vec<[i32; 3]> {
    let first = sample.surface.virtual_count() as usize + 4;
    let mut coords = sample.coords[..first].to_vec();
    coords.resize(sample.coords.len(), unknown);
    let mut model = PositionModel::new(effort);
    for vertex in first..coords.len() {
        let corners: Vec<u32> = sample.surface.ring(vertex as u32).collect();
        let neighborhood = Neighborhood {
            surface: &sample.surface,
            coords: &coords,
            vertex: vertex as u32,
            corners: &corners,
        };
        if let Some(ahead) = model.ahead(vertex as u32) {
            ahead.look_ahead(&around(&neighborhood));
        }
        let actual = if C::READS { [0; 3] } else { sample.coords[vertex] };
        coords[vertex] = model.code(coder, &neighborhood, actual);
    }
    coords
}

fn write(sample: &TestSample, effort: Effort, unknown: [i32; 3]) -> Vec<u8> {
    let mut writer = RangeWriter::new();
    assert_eq!(code(&mut writer, sample, effort, unknown), sample.coords);
    writer.finish().0
}

#[test]
fn decodes_coordinates_of_all_magnitudes() {
    for effort in EFFORTS {
        for (at, sample) in samples_for(effort).iter().enumerate() {
            let bytes = write(sample, effort, [0; 3]);
            let coords = code(&mut RangeReader::new(&bytes, true), sample, effort, [1; 3]);
            assert_eq!(coords, sample.coords, "sample {at}, {effort:?}");
        }
    }
}

#[test]
fn later_coordinates_have_no_influence() {
    for effort in EFFORTS {
        for (at, sample) in samples_for(effort).iter().enumerate() {
            let expected = write(sample, effort, [0; 3]);
            for rubbish in [[i32::MAX; 3], [-5, 4000, 77]] {
                assert_eq!(write(sample, effort, rubbish), expected, "sample {at}, {effort:?}");
            }
        }
    }
}

#[test]
fn random_bytes_give_coordinates() {
    let mut random = Random::new(6);
    // The caller of the model that predicts ahead stops at positions outside the grid, so it is never
    // called after them.
    for sample in &samples() {
        let bytes: Vec<u8> = (0..400).map(|_| random.next_u64() as u8).collect();
        code(&mut RangeReader::new(&bytes, true), sample, Effort::Compact, [0; 3]);
        let mut cut = RangeReader::new(&bytes[..40], false);
        code(&mut cut, sample, Effort::Compact, [0; 3]);
        assert!(cut.overran());
    }
}

#[test]
fn more_effort_takes_fewer_bytes() {
    let mesh = shapes::torus(120, 50, 1.0, 0.4);
    let mut random = Random::new(3);
    // Noise makes exact prediction impossible.
    let noise: Vec<[f32; 3]> =
        mesh.positions.iter().map(|_| [(); 3].map(|()| random.between(-4.0, 4.0))).collect();
    let sample =
        sample(&mesh, |v| [0, 1, 2].map(|a| (mesh.positions[v][a] * 1000.0 + noise[v][a]).round() as i32));
    let bits =
        EFFORTS.map(|effort| write(&sample, effort, [0; 3]).len() as f64 * 8.0 / mesh.positions.len() as f64);
    // The noise alone takes 9.5 bits.
    assert!(bits[0] < 20.0 && bits[1] < 15.5, "{bits:?}");
}

#[test]
fn bytes_are_the_same_on_every_machine() {
    let samples = samples();
    let found = EFFORTS.map(|effort| crc32fast::hash(&write(&samples[0], effort, [0; 3])));
    assert_eq!(found, [1_581_675_626, 1_206_542_486]);
}

#[test]
fn renumbering_keeps_the_errors_of_vertices() {
    let mut model = MixedModel::new();
    model.errors = vec![[1, 2], [3, 4], [5, 6]];
    model.renumber(&[2, NONE, 0]);
    assert_eq!(model.errors, [[5, 6], [7, 7], [1, 2]]);
}
