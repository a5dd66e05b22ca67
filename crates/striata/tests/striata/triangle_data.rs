//! Data of triangles at every level of every model: a triangle of a level has the data of the triangle of the
//! full mesh that it stems from.

use striata::file::{FileModel, StriataFile, WriteOptions, to_striata};
use striata::mesh::{
    AttributeLayer, IndexedMesh, LayerData, RefinableMesh, Semantic, canonical_triangles, replay, shapes,
    weld,
};
use striata::model::{FanInstance, Fans, LodStrips};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::stripify;
use striata_testing::support::{nasty, with_seams_and_groups};

/// Gives every triangle its index, and as a second layer a double that depends on it.
fn numbered(mut mesh: IndexedMesh) -> IndexedMesh {
    let count = mesh.triangle_count() as u32;
    let layer = |name: &str, data| AttributeLayer {
        semantic: Semantic::Generic(name.to_owned()),
        component_count: 1,
        normalized: false,
        data,
    };
    mesh.triangle_layers = vec![
        layer("id", LayerData::U32((0..count).collect())),
        layer("time", LayerData::F64((0..count).map(|i| 1.6e9 + f64::from(i) * 1e-3).collect())),
    ];
    mesh
}

fn ids(mesh: &IndexedMesh) -> &[u32] {
    let LayerData::U32(ids) = &mesh.triangle_layers[0].data else { panic!("{:?}", mesh.triangle_layers[0]) };
    ids
}

/// Checks that each triangle of a level is the one with its id after all collapses. Vertices of the level are a
/// prefix of those of the full mesh.
fn check_level(name: &str, refinable: &RefinableMesh, level: &IndexedMesh, split_count: usize) {
    level.check().unwrap_or_else(|error| panic!("{name}: {error}"));
    let full = &refinable.mesh;
    let triangle_of: std::collections::BTreeMap<u32, usize> = ids(full).iter().copied().zip(0..).collect();
    for (triangle, &id) in level.triangles.iter().zip(ids(level)) {
        let source = full.triangles[triangle_of[&id]].map(|v| refinable.sequence.target_at(v, split_count));
        let (found, expected) = (canonical_triangles(&[*triangle]), canonical_triangles(&[source]));
        assert_eq!(found, expected, "{name}, split count {split_count}, id {id}");
    }
    let LayerData::F64(times) = &level.triangle_layers[1].data else { panic!() };
    for (time, &id) in times.iter().zip(ids(level)) {
        assert_eq!(*time, 1.6e9 + f64::from(id) * 1e-3, "{name}");
    }
}

fn meshes() -> Vec<(&'static str, IndexedMesh)> {
    let mut meshes: Vec<_> = nasty().into_iter().filter(|(_, mesh)| weld(mesh).is_ok()).collect();
    meshes.push(("seams", with_seams_and_groups(shapes::icosphere(2, 1.0))));
    meshes.push(("torus", shapes::torus(12, 8, 1.0, 0.4)));
    meshes
}

#[test]
fn welding_keeps_the_data_of_the_triangles_that_remain() {
    for (name, mesh) in meshes() {
        let mesh = numbered(mesh);
        let welded = weld(&mesh).unwrap().mesh;
        welded.check().unwrap();
        for (triangle, &id) in welded.triangles.iter().zip(ids(&welded)) {
            let before = mesh.triangles[id as usize].map(|v| mesh.positions[v as usize].map(|x| x + 0.0));
            let after = triangle.map(|v| welded.positions[v as usize]);
            assert_eq!(before, after, "{name}");
        }
    }
}

#[test]
fn triangles_of_every_level_have_the_data_of_their_source() {
    for (name, mesh) in meshes() {
        let Ok(built) = build_sequence(&numbered(mesh), &SequenceOptions::default()) else { continue };
        let refinable = &built.refinable;
        let step_count = refinable.sequence.step_count();
        let fans = Fans::build(refinable);
        let strips = stripify(&refinable.mesh).unwrap();
        let lod_strips = LodStrips::build(refinable, &strips);
        for models in
            [vec![FileModel::Fans(&fans)], lod_strips.iter().map(FileModel::LodStrips).collect(), Vec::new()]
        {
            let bytes = to_striata(refinable, &models, &WriteOptions::default()).unwrap();
            let file = StriataFile::parse(&bytes).unwrap();
            let stored = file.refinable_mesh().unwrap();
            check_level(name, refinable, &stored.mesh, step_count);
            for split_count in [0, step_count / 3, step_count] {
                check_level(name, refinable, &replay(refinable, split_count), split_count);
                if !models.is_empty() {
                    check_level(name, refinable, &file.level(split_count).unwrap(), split_count);
                }
            }
        }
        // Without unused vertices, but complete: the numbering is that of the full mesh.
        let full = FanInstance::full(&fans).level(&fans, refinable);
        if full.vertex_count() == refinable.mesh.vertex_count() {
            check_level(name, refinable, &full, step_count);
        }
        let coarse = FanInstance::uniform(&fans, step_count / 2).level(&fans, refinable);
        coarse.check().unwrap();
        let mut found = ids(&coarse).to_vec();
        let mut expected = ids(&replay(refinable, step_count / 2)).to_vec();
        found.sort_unstable();
        expected.sort_unstable();
        if name == "torus" {
            assert_eq!(found, expected, "{name}");
        }
    }
}
