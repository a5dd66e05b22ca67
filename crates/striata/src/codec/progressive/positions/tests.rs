//! Positions of made-up surfaces, there and back.

use super::super::super::entropy::{Coder, RangeReader, RangeWriter};
use super::super::Effort;
use super::super::cutting::close;
use super::super::hood::Hood;
use super::super::surface::Surface;
use super::PositionModel;
use crate::mesh::{IndexedMesh, Random, shapes};

const EFFORTS: [Effort; 3] = [Effort::Fast, Effort::Default, Effort::Small];

/// A closed surface, and a place for each of its vertices.
struct Sample {
    surface: Surface,
    places: Vec<[i32; 3]>,
}

fn sample(mesh: &IndexedMesh, place: impl Fn(usize) -> [i32; 3]) -> Sample {
    let surface = close(&mesh.triangles, mesh.positions.len()).surface;
    let first = surface.virtual_count() as usize;
    let places = (0..surface.vertex_count()).map(|v| v.checked_sub(first).map_or([0; 3], &place)).collect();
    Sample { surface, places }
}

/// The mesh on a grid of so many steps to a unit.
fn on_grid(mesh: &IndexedMesh, steps: f32) -> Sample {
    sample(mesh, |v| mesh.positions[v].map(|x| (x * steps).round() as i32))
}

fn samples() -> Vec<Sample> {
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

/// Codes all places but the first few in order; `unseen` stands where places are not known yet.
fn code<C: Coder>(coder: &mut C, sample: &Sample, effort: Effort, unseen: [i32; 3]) -> Vec<[i32; 3]> {
    let first = sample.surface.virtual_count() as usize + 4;
    let mut places = sample.places[..first].to_vec();
    places.resize(sample.places.len(), unseen);
    let mut model = PositionModel::new(effort);
    for vertex in first..places.len() {
        let corners: Vec<u32> = sample.surface.ring(vertex as u32).collect();
        let hood =
            Hood { surface: &sample.surface, places: &places, vertex: vertex as u32, corners: &corners };
        let actual = if C::READS { [0; 3] } else { sample.places[vertex] };
        places[vertex] = model.code(coder, &hood, actual);
    }
    places
}

fn write(sample: &Sample, effort: Effort, unseen: [i32; 3]) -> Vec<u8> {
    let mut writer = RangeWriter::new();
    assert_eq!(code(&mut writer, sample, effort, unseen), sample.places);
    writer.finish().0
}

#[test]
fn places_of_all_sizes_come_back() {
    for (at, sample) in samples().iter().enumerate() {
        for effort in EFFORTS {
            let bytes = write(sample, effort, [0; 3]);
            let places = code(&mut RangeReader::new(&bytes, true), sample, effort, [1; 3]);
            assert_eq!(places, sample.places, "sample {at}, {effort:?}");
        }
    }
}

#[test]
fn nothing_is_seen_before_its_time() {
    for (at, sample) in samples().iter().enumerate() {
        for effort in EFFORTS {
            let expected = write(sample, effort, [0; 3]);
            for rubbish in [[i32::MAX; 3], [-5, 4000, 77]] {
                assert_eq!(write(sample, effort, rubbish), expected, "sample {at}, {effort:?}");
            }
        }
    }
}

#[test]
fn any_bytes_give_places() {
    let mut random = Random::new(6);
    for sample in &samples() {
        for effort in EFFORTS {
            let bytes: Vec<u8> = (0..400).map(|_| random.next_u64() as u8).collect();
            code(&mut RangeReader::new(&bytes, true), sample, effort, [0; 3]);
            let mut cut = RangeReader::new(&bytes[..40], false);
            code(&mut cut, sample, effort, [0; 3]);
            assert!(cut.overran());
        }
    }
}

#[test]
fn more_effort_takes_fewer_bytes() {
    let mesh = shapes::torus(120, 50, 1.0, 0.4);
    let mut random = Random::new(3);
    // Sampled with some noise, so that nothing is foretold for sure.
    let noise: Vec<[f32; 3]> =
        mesh.positions.iter().map(|_| [(); 3].map(|()| random.between(-4.0, 4.0))).collect();
    let sample =
        sample(&mesh, |v| [0, 1, 2].map(|a| (mesh.positions[v][a] * 1000.0 + noise[v][a]).round() as i32));
    let bits =
        EFFORTS.map(|effort| write(&sample, effort, [0; 3]).len() as f64 * 8.0 / mesh.positions.len() as f64);
    // The noise alone is 9.5 bits.
    assert!(bits[0] < 20.0 && bits[1] < 15.5 && bits[2] < 15.0, "{bits:?}");
    assert!(bits[2] < bits[1] && bits[1] < bits[0], "{bits:?}");
}

#[test]
fn bytes_are_the_same_everywhere() {
    let samples = samples();
    let found = EFFORTS.map(|effort| crc32fast::hash(&write(&samples[0], effort, [0; 3])));
    assert_eq!(found, [541_360_663, 4_176_046_866, 815_267_749]);
}
