//! Every source of levels shows what the plain replay of its steps shows.

use striata::file::{FileModel, StriataFile, WriteOptions, to_striata};
use striata::levels::{FileLevels, Levels as _};
use striata::mesh::{IndexedMesh, replay, shapes};
use striata::model::{Fans, LodStrips, ModelKind, Mts, Patterns};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::stripify;
use striata::view::DetailBox;
use striata::{Lod, LodOptions, Target};
use striata_testing::levels::{check_levels, check_views, placed_triangles};

fn meshes() -> [IndexedMesh; 3] {
    [shapes::torus(24, 12, 1.0, 0.4), shapes::terrain(16, 3), shapes::two_material_sphere(12, 16)]
}

#[test]
fn a_built_lod_is_a_source() {
    for mesh in meshes() {
        let mut lod = Lod::build(&mesh, &LodOptions::default()).expect("a sound mesh");
        let refinable = build_sequence(&mesh, &SequenceOptions::default()).expect("a sound mesh").refinable;
        check_levels(&mut lod, &|split_count| replay(&refinable, split_count));
        check_views(&mut lod);
    }
}

#[test]
fn every_model_of_a_file_is_a_source() {
    for mesh in meshes() {
        let refinable = build_sequence(&mesh, &SequenceOptions::default()).expect("a sound mesh").refinable;
        let strips = stripify(&refinable.mesh).expect("a sound mesh");
        let lod_strips = LodStrips::build(&refinable, &strips).expect("small");
        let mts = Mts::build(&refinable, &strips).expect("small");
        let fans = Fans::build(&refinable);
        let fragments = striata::mesh::FragmentedMesh::from_collapses(&refinable);
        let patterns = Patterns::build(&fragments).expect("small");
        let models = [
            FileModel::LodStrips(&lod_strips),
            FileModel::Mts(&mts),
            FileModel::Fans(&fans),
            FileModel::Patterns(&patterns),
        ];
        let bytes = to_striata(&refinable, &models, &WriteOptions::default()).expect("small");
        let stripless = to_striata(&refinable, &models[2..], &WriteOptions::default()).expect("small");
        let open = |bytes, kind| FileLevels::new(StriataFile::parse(bytes).expect("just written"), kind);
        let oracle = |split_count| replay(&refinable, split_count);
        for kind in [ModelKind::LodStrips, ModelKind::Mts, ModelKind::Fans, ModelKind::Patterns] {
            let mut levels = open(&bytes[..], Some(kind)).expect("a sound file").keeping_strips();
            assert_eq!(levels.kind(), Some(kind));
            check_levels(&mut levels, &oracle);
            let level = levels.find(Target::Detail(0.4)).expect("a level");
            if let Some(strips) = levels.strips() {
                let mut shown = IndexedMesh { triangles: Vec::new(), ..level.shape.clone() };
                strips.triangles_into(&mut shown.triangles);
                assert_eq!(placed_triangles(&shown), placed_triangles(&level.shape));
            }
            assert_eq!(levels.strips().is_some(), matches!(kind, ModelKind::LodStrips | ModelKind::Mts));
        }
        for kind in [ModelKind::Fans, ModelKind::Patterns] {
            check_views(&mut open(&stripless[..], Some(kind)).expect("a sound file"));
        }
        assert_eq!(open(&stripless[..], Some(ModelKind::Mts)).expect("a sound file").kind(), None);
        assert_eq!(open(&stripless[..], None).expect("a sound file").kind(), Some(ModelKind::Fans));
    }
}

#[test]
fn a_box_has_full_detail_inside_and_a_limit_outside() {
    let mesh = shapes::terrain(24, 5);
    let lod = Lod::build(&mesh, &LodOptions::default()).expect("a sound mesh");
    let bytes = lod.to_striata(&WriteOptions::default()).expect("small");
    let mut levels = FileLevels::new(StriataFile::parse(&bytes).expect("just written"), None).expect("sound");
    let bounds = mesh.bounds().expect("vertices");
    let middle = [0, 1, 2].map(|axis| f32::midpoint(bounds.min[axis], bounds.max[axis]));
    let corner = DetailBox { min: bounds.min, max: middle, error_outside: f32::INFINITY };
    let coarse = levels.find_for_box(&corner, None).expect("sound").expect("patterns can be built");
    let limit = usize::midpoint(coarse.triangle_count, mesh.triangle_count());
    let within = levels.find_for_box(&corner, Some(limit)).expect("sound").expect("patterns can be built");
    assert!(coarse.triangle_count < within.triangle_count && within.triangle_count <= limit);
    let exact = DetailBox { error_outside: 0.0, ..corner };
    let full = levels.find_for_box(&exact, None).expect("sound").expect("patterns can be built");
    assert!(full.triangle_count >= within.triangle_count && full.error <= within.error);
}
