//! Poses of lit surfaces: nodes, skins and morph targets move vertices exactly as the formulas say.

#[path = "support/lit.rs"]
mod lit;
mod support;

use glam::{DMat4, DVec3};
use lit::{LitTest, SIDE, Shown, chalk, image, quad, sphere, unlit};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata_gpu::{Environment, LitCamera, LitMaterial, Picture, TextureUse};
use support::differing_pixels;

#[test]
fn mirrored_and_flattened_nodes() {
    let mesh = quad();
    let mut test = LitTest::new(LitMaterial {
        base_color_texture: Some(TextureUse::of(0)),
        normal_texture: Some(TextureUse::of(1)),
        base_color: [1.0; 4],
        ..chalk()
    });
    test.environment = Environment::studio();
    test.images = vec![
        image(16, 16, |x, y| [(16 * x) as u8, (16 * y) as u8, 90, 255]),
        image(16, 16, |x, _| if x < 8 { [200, 128, 230, 255] } else { [128, 190, 238, 255] }),
    ];
    test.environment.lobes[0].direction = [0.0, 0.65, 0.75];
    test.environment.lobes[1].direction = [0.0, 0.25, 0.45];
    test.environment.lobes[2].direction = [0.0, 0.5, -0.85];
    let straight = test.draw(&[Shown::new(&mesh)]);
    let mirror = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    let mirrored = test.draw(&[Shown::at(&mesh, mirror)]);
    let rows = mirrored.rgba.chunks(4 * SIDE as usize);
    let turned_back = rows.flat_map(|row| row.chunks(4).rev().flatten().copied()).collect();
    let turned_back = Picture { rgba: turned_back, ..mirrored };
    assert!(differing_pixels(&straight, &turned_back, 3) <= 2 * SIDE as usize);
    // One flat axis keeps the normals; no size at all draws nothing.
    let flat = test.draw(&[Shown::at(&mesh, DMat4::from_scale(DVec3::new(1.0, 1.0, 0.0)))]);
    assert!(differing_pixels(&straight, &flat, 1) == 0);
    let nothing = test.draw(&[Shown::at(&mesh, DMat4::ZERO)]);
    assert!(nothing.rgba.iter().all(|&byte| byte == 0));
    for strange in [f64::NAN, f64::INFINITY, 1e300] {
        test.draw(&[Shown::at(&mesh, DMat4::from_scale(DVec3::splat(strange)))]);
    }
}

fn bending_strip(joint_count: usize) -> (IndexedMesh, Vec<[f32; 8]>) {
    let columns = 16;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    let mut weights = Vec::new();
    for column in 0..=columns {
        let part = column as f32 / columns as f32;
        for y in [-0.2, 0.2] {
            positions.push([2.0 * part - 1.0, y, 0.0]);
            let at = part * (joint_count - 1) as f32;
            weights.push(std::array::from_fn(|joint| {
                if joint < joint_count { (1.0 - (at - joint as f32).abs()).max(0.0) * 0.7 } else { 0.0 }
            }));
        }
        if column < columns {
            let a = 2 * column as u32;
            triangles.extend([[a, a + 2, a + 1], [a + 1, a + 2, a + 3]]);
        }
    }
    let mut mesh = IndexedMesh::new(positions, triangles);
    for set in 0..2u8 {
        let first = 4 * u16::from(set);
        let joints = vec![[first, first + 1, first + 2, first + 3]; mesh.vertex_count()].concat();
        let of_set = weights.iter().flat_map(|w: &[f32; 8]| w[usize::from(first)..][..4].to_vec()).collect();
        mesh.layers.push(AttributeLayer {
            semantic: Semantic::Joints(set),
            component_count: 4,
            normalized: false,
            data: LayerData::U16(joints),
        });
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Weights(set), 4, of_set));
    }
    (mesh, weights)
}

#[test]
fn skinned_vertices_are_where_the_processor_puts_them() {
    for joint_count in [2, 4, 7, 8] {
        let (mesh, weights) = bending_strip(joint_count);
        let joints: Vec<DMat4> = (0..joint_count)
            .map(|joint| {
                let turn = DMat4::from_rotation_z(0.35 * joint as f64 / joint_count as f64);
                DMat4::from_translation(DVec3::new(0.02 * joint as f64, -0.1, 0.0)) * turn
            })
            .collect();
        let mut posed = mesh.clone();
        for (position, weights) in posed.positions.iter_mut().zip(&weights) {
            let total: f32 = weights.iter().sum();
            let point = DVec3::from(position.map(f64::from));
            let moved: DVec3 = joints
                .iter()
                .zip(weights)
                .map(|(j, &w)| j.transform_point3(point) * f64::from(w / total))
                .sum();
            *position = moved.as_vec3().into();
        }
        posed.layers.clear();
        let mut test = LitTest::new(unlit([1.0; 4]));
        test.materials[0].is_double_sided = true;
        let elsewhere = DMat4::from_translation(DVec3::splat(100.0));
        let by_gpu = test.draw(&[Shown { joints: &joints, ..Shown::at(&mesh, elsewhere) }]);
        let by_processor = test.draw(&[Shown::new(&posed)]);
        assert!(differing_pixels(&by_gpu, &by_processor, 1) <= 2, "{joint_count} joints");
        assert!(support::drawn_pixels(&by_gpu) > 300);
        // Joints that the skin does not have move nothing; without any, the vertices stay.
        let still = test.draw(&[Shown::new(&mesh)]);
        assert!(differing_pixels(&by_gpu, &still, 1) > 100);
        test.draw(&[Shown { joints: &joints[..1], ..Shown::new(&mesh) }]);
    }
}

#[test]
fn morphed_vertices_are_where_the_processor_puts_them() {
    let mut mesh = sphere();
    let count = mesh.vertex_count();
    let displacements = [0usize, 2].map(|target| -> Vec<f32> {
        (0..3 * count).map(|at| 0.3 * ((at * (target + 3)) as f32).sin()).collect()
    });
    for (target, data) in [0u16, 2].into_iter().zip(&displacements) {
        mesh.layers.push(AttributeLayer::from_f32(Semantic::MorphPosition(target), 3, data.clone()));
    }
    // Normals follow only the second target.
    let normals: Vec<f32> = vec![[0.3, 0.0, 0.2]; count].concat();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::MorphNormal(2), 3, normals));
    let weights = [0.4, 9.0, -0.25];
    let mut posed = mesh.clone();
    posed.layers.retain(|layer| layer.semantic == Semantic::Normal);
    for (at, position) in posed.positions.as_flattened_mut().iter_mut().enumerate() {
        *position += weights[0] * displacements[0][at] + weights[2] * displacements[1][at];
    }
    let LayerData::F32(posed_normals) = &mut posed.layers[0].data else { unreachable!() };
    for (normal, [x, y, z]) in
        posed_normals.as_chunks_mut::<3>().0.iter_mut().zip(&vec![[0.3, 0.0, 0.2]; count])
    {
        for (value, by) in normal.iter_mut().zip([x, y, z]) {
            *value += weights[2] * by;
        }
    }
    let mut test = LitTest::new(chalk());
    test.environment = Environment::studio();
    let by_gpu = test.draw(&[Shown { morph_weights: &weights, ..Shown::new(&mesh) }]);
    let by_processor = test.draw(&[Shown::new(&posed)]);
    assert!(differing_pixels(&by_gpu, &by_processor, 3) <= 8);
    assert!(differing_pixels(&by_gpu, &test.draw(&[Shown::new(&mesh)]), 3) > 500);
}

#[test]
fn scenes_far_from_the_origin_look_the_same() {
    let mut test = LitTest::new(LitMaterial { roughness: 0.3, ..Default::default() });
    test.environment = Environment::studio();
    let mesh = sphere();
    let near = test.draw(&[Shown::new(&mesh)]);
    let far_away = DVec3::new(6.4e6, -2.0e6, 1.0e7);
    let moved = |point: [f64; 3]| (DVec3::from(point) + far_away).into();
    test.camera =
        LitCamera { eye: moved(test.camera.eye), look_at: moved(test.camera.look_at), ..test.camera };
    let far = test.draw(&[Shown::at(&mesh, DMat4::from_translation(far_away))]);
    assert!(differing_pixels(&near, &far, 1) <= 4);
}
