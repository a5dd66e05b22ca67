//! Lit surfaces: textures, blending and light give the pictures that formulas predict; mistakes are errors.

use std::f32::consts::PI;

use crate::support::lit::{
    LitTest, SIDE, Shown, assert_near, camera, chalk, image, lit_by, pixel, quad, sphere, srgb, sunlight,
    unlit, used,
};
use glam::{Mat4, Vec3};
use striata::mesh::{AttributeLayer, ColorSpace, IndexedMesh, LayerData, Semantic};
use striata_render::gpu::{GpuIndices, GpuVertices, LitFrame, LitMaterials, LitObject, LitPart, LitScene};
use striata_render::{AlphaMode, Light, LightKind, Material, RgbaImage, Sampler, TextureUse, UvTransform};

#[test]
fn an_unlit_textured_quad_shows_its_pixels() {
    let mut test = LitTest::new(Material {
        base_color_texture: Some(TextureUse {
            sampler: Sampler { is_smooth: false, ..Sampler::default() },
            ..used(0)
        }),
        ..unlit([1.0; 4])
    });
    let colors = |x: u32, y: u32| [(x * 60) as u8, (y * 60) as u8, 200 - (x * y) as u8, 255];
    test.images = vec![image(4, 4, colors)];
    let picture = test.draw(&[Shown::new(&quad())]);
    for y in 0..4 {
        for x in 0..4 {
            assert_near(pixel(&picture, 16 * x + 8, 16 * y + 8), colors(x, y), 1);
        }
    }
}

#[test]
fn a_white_furnace_returns_the_light_that_arrives() {
    let sphere = sphere();
    for metallic in [0.0, 1.0] {
        for roughness in [0.0, 0.2, 0.5, 0.8, 1.0] {
            let test = LitTest::new(Material { metallic, roughness, ..Default::default() });
            let picture = test.draw(&[Shown::new(&sphere)]);
            // Middle, halfway and near the edge.
            for x in [32, 46, 58] {
                let found = pixel(&picture, x, 32);
                let name = format!("metallic {metallic}, roughness {roughness}, at {x}: {found:?}");
                assert!(found[..3].iter().all(|&byte| byte >= 248), "{name}");
            }
        }
    }
}

#[test]
fn masked_pixels_are_there_or_not() {
    let mut test = LitTest::new(Material {
        base_color_texture: Some(used(0)),
        alpha_mode: AlphaMode::Mask(0.5),
        ..unlit([1.0; 4])
    });
    test.images = vec![image(64, 64, |x, _| [255, 0, 0, if x < 32 { 120 } else { 135 }])];
    let picture = test.draw(&[Shown::new(&quad())]);
    assert_eq!(pixel(&picture, 16, 32), [0; 4]);
    assert_near(pixel(&picture, 48, 32), [255, 0, 0, 255], 1);
    // Opaque materials ignore the opacity.
    test.materials[0].alpha_mode = AlphaMode::Opaque;
    assert_near(pixel(&test.draw(&[Shown::new(&quad())]), 16, 32), [255, 0, 0, 255], 1);
}

#[test]
fn blended_quads_show_what_is_behind_them_in_any_order() {
    let blend = |color| Material { alpha_mode: AlphaMode::Blend, ..unlit(color) };
    let mut test = LitTest::new(unlit([1.0, 0.0, 0.0, 1.0]));
    test.materials.extend([blend([0.0, 1.0, 0.0, 0.5]), blend([0.0, 0.0, 1.0, 0.5])]);
    let mesh = quad();
    let layer = |material: usize, z| Shown {
        material: Some(material),
        ..Shown::at(&mesh, Mat4::from_translation(Vec3::new(0.0, 0.0, z)))
    };
    // Half of blue over half of green over red.
    let expected = [srgb(0.25), srgb(0.25), srgb(0.5), 255];
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let layers = order.map(|material| layer(material, material as f32));
        assert_near(pixel(&test.draw(&layers), 32, 32), expected, 2);
    }
    // What is behind an opaque quad stays hidden.
    let hidden = test.draw(&[layer(1, -1.0), layer(0, 0.0)]);
    assert_near(pixel(&hidden, 32, 32), [255, 0, 0, 255], 1);
}

#[test]
fn lights_follow_the_formulas() {
    // Light and eye along the normal: every angle is 0, and the distribution of a roughness of 1 is 1 / pi.
    let f0 = 0.04;
    let diffuse = 0.8 / PI * (1.0 - f0);
    let specular = f0 / (4.0 * PI);
    let expected = 2.0 * (diffuse + specular);
    let front = lit_by(chalk(), sunlight([0.0, 0.0, -1.0]));
    let found = pixel(&front.draw(&[Shown::new(&quad())]), 32, 32);
    assert_near(found, [srgb(expected), srgb(expected), srgb(expected), 255], 2);

    // A point at twice the distance, and a spot that is off its axis.
    let place = |kind, position: [f32; 3]| Light { kind, position, ..sunlight([0.0, 0.0, -1.0]) };
    let brightness = |light| pixel(&lit_by(chalk(), light).draw(&[Shown::new(&quad())]), 32, 32)[0];
    let point = brightness(place(LightKind::Point, [0.0, 0.0, 2.0]));
    assert!(point.abs_diff(srgb(expected / 4.0)) <= 2, "{point}");
    let spot = LightKind::Spot { inner_cos: 0.1f32.cos(), outer_cos: 0.3f32.cos() };
    assert_eq!(brightness(place(spot, [1.0, 0.0, 2.0])), 0);
    assert!(brightness(place(spot, [0.0, 0.0, 2.0])).abs_diff(point) <= 1);
    let near = Light { range: Some(1.9), ..place(LightKind::Point, [0.0, 0.0, 2.0]) };
    assert_eq!(brightness(near), 0);
}

#[test]
fn normal_maps_turn_the_shading_with_and_without_tangents() {
    // Tilted by 45 degrees toward the right of the image, or toward its top.
    let tilted = [[218, 128, 218, 255], [128, 218, 218, 255]];
    for (pixel_of_map, from) in tilted.into_iter().zip([[1.0, 0.0], [0.0, 1.0]]) {
        let material = Material { normal_texture: Some(used(0)), ..chalk() };
        let [x, y] = from;
        let mut test = lit_by(material, sunlight([-x, -y, -1.0]));
        test.images = vec![image(2, 2, |_, _| pixel_of_map)];
        let mut with_tangents = quad();
        let tangents = [[1.0, 0.0, 0.0, 1.0]; 4].concat();
        with_tangents.layers.push(AttributeLayer::from_f32(Semantic::Tangent, 4, tangents));
        for mesh in [quad(), with_tangents] {
            let towards = pixel(&test.draw(&[Shown::new(&mesh)]), 32, 32)[0];
            // The light is on the normal now: as bright as a quad that faces its light.
            let facing = lit_by(chalk(), sunlight([0.0, 0.0, -1.0]));
            let expected = pixel(&facing.draw(&[Shown::new(&mesh)]), 32, 32)[0];
            assert!(towards.abs_diff(expected) <= 4, "{from:?}: {towards}, not {expected}");
            test.lights = vec![sunlight([x, y, -1.0])];
            let away = pixel(&test.draw(&[Shown::new(&mesh)]), 32, 32)[0];
            assert!(away < 20, "{from:?}: {away}");
            test.lights = vec![sunlight([-x, -y, -1.0])];
        }
    }
}

#[test]
fn single_sided_surfaces_have_no_back_and_double_sided_ones_are_lit_on_both() {
    let mesh = quad();
    let turned = Mat4::from_rotation_y(PI);
    let mut test = lit_by(chalk(), sunlight([0.0, 0.0, -1.0]));
    let front = pixel(&test.draw(&[Shown::new(&mesh)]), 32, 32);
    assert_eq!(pixel(&test.draw(&[Shown::at(&mesh, turned)]), 32, 32), [0; 4]);
    test.materials[0].is_double_sided = true;
    assert_near(pixel(&test.draw(&[Shown::at(&mesh, turned)]), 32, 32), front, 1);
    // Without normals, surfaces are flat and face the viewer.
    let mut without = mesh.clone();
    without.layers.retain(|layer| layer.semantic != Semantic::Normal);
    assert_near(pixel(&test.draw(&[Shown::at(&without, turned)]), 32, 32), front, 1);
}

#[test]
fn fine_checkers_fade_to_their_mean_light() {
    let mut test = LitTest::new(Material { base_color_texture: Some(used(0)), ..unlit([1.0; 4]) });
    test.images = vec![image(512, 512, |x, y| if (x + y) % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] })];
    let mean = pixel(&test.draw(&[Shown::new(&quad())]), 31, 31);
    assert_near(mean, [188, 188, 188, 255], 2);
    // Without mip levels, only the pixels next to the sample count.
    test.images =
        vec![image(512, 512, |x, _| if matches!(x % 8, 3 | 4) { [255; 4] } else { [0, 0, 0, 255] })];
    test.materials[0].base_color_texture =
        Some(TextureUse { sampler: Sampler { has_mip_maps: false, ..Sampler::default() }, ..used(0) });
    assert_near(pixel(&test.draw(&[Shown::new(&quad())]), 31, 31), [255; 4], 1);
}

#[test]
fn texture_coordinates_are_chosen_and_transformed() {
    let mut mesh = quad();
    let second = vec![0.75; 8];
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(1), 2, second));
    let nearest = Sampler { is_smooth: false, ..Sampler::default() };
    let used = |uv_set, rows| TextureUse { uv_set, transform: UvTransform(rows), sampler: nearest, image: 0 };
    let shown = |used, at: [u32; 2]| {
        let mut test = LitTest::new(Material { base_color_texture: Some(used), ..unlit([1.0; 4]) });
        test.images = vec![image(2, 2, |x, y| [(255 * x) as u8, (255 * y) as u8, 0, 255])];
        pixel(&test.draw(&[Shown::new(&mesh)]), at[0], at[1])
    };
    let same = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_near(shown(used(1, same), [5, 5]), [255, 255, 0, 255], 1);
    // Shifted by half the image, which repeats.
    assert_near(shown(used(0, [[1.0, 0.0, 0.5], [0.0, 1.0, 0.0]]), [10, 10]), [255, 0, 0, 255], 1);
    // Turned: v becomes u.
    assert_near(shown(used(0, [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]), [10, 50]), [255, 0, 0, 255], 1);
}

#[test]
fn vertex_colors_become_light_and_multiply_the_base_color() {
    let mut mesh = quad();
    let data = LayerData::U8([128u8, 64, 255, 255].repeat(4));
    mesh.layers.push(AttributeLayer {
        semantic: Semantic::Color(0),
        component_count: 4,
        normalized: true,
        data,
    });
    let mut drawn = |color_space, base_color| {
        mesh.appearance.color_space = color_space;
        pixel(&LitTest::new(unlit(base_color)).draw(&[Shown::new(&mesh)]), 32, 32)
    };
    let expected = [srgb(0.5 * 128.0 / 255.0), srgb(64.0 / 255.0), srgb(0.25), 255];
    assert_near(drawn(ColorSpace::Linear, [0.5, 1.0, 0.25, 1.0]), expected, 1);
    // Colors as they are shown come out as they went in.
    assert_near(drawn(ColorSpace::Srgb, [1.0; 4]), [128, 64, 255, 255], 1);
}

#[test]
fn mistakes_are_errors_that_name_their_place() {
    let textured = Material { name: "wood".into(), base_color_texture: Some(used(1)), ..unlit([1.0; 4]) };
    let mut test = LitTest::new(textured);
    let mesh = quad();
    let error = |test: &LitTest, shown: Shown| test.try_draw(&[shown]).unwrap_err().to_string();
    test.images = vec![image(2, 2, |_, _| [255; 4])];
    assert_eq!(error(&test, Shown::new(&mesh)), "material \"wood\" uses image 1, but there are 1 images");
    for (width, height) in [(0, 0), (3, 2), (u32::MAX, u32::MAX)] {
        test.images.truncate(1);
        test.images.push(RgbaImage { width, height, rgba: [0; 16].into() });
        assert!(error(&test, Shown::new(&mesh)).contains("image 1"), "{width} x {height}");
    }
    test.materials[0].base_color_texture = None;
    let shown = Shown { material: Some(7), ..Shown::new(&mesh) };
    assert_eq!(error(&test, shown), "a part uses material 7, but there are 1 materials");
    test.draw(&[Shown { material: None, ..Shown::new(&mesh) }]);
    let mut broken = mesh.clone();
    broken.triangles[1][2] = 4;
    assert!(error(&test, Shown::new(&broken)).contains("triangle 1 uses vertex 4"));
    let mut short = mesh.clone();
    short.layers[1].data = LayerData::F32(vec![0.0; 7]);
    assert!(error(&test, Shown::new(&short)).contains("texcoord_0"));
    test.lights = vec![sunlight([0.0, 0.0, -1.0]); LitFrame::MAX_LIGHT_COUNT + 1];
    assert!(error(&test, Shown::new(&mesh)).contains("33 lights"));
    test.lights.clear();

    let vertices = GpuVertices::upload(&test.gpu, &mesh).unwrap();
    let indices = GpuIndices::upload(&test.gpu, &[0, 1, 2]).unwrap();
    let materials = LitMaterials::upload(&test.gpu, &test.painter, &[], &[]).unwrap();
    let parts = [LitPart { range: 0..6, material: None }];
    let objects = [LitObject { vertices: &vertices, indices: &indices, parts: &parts }];
    let scene = LitScene {
        camera: &camera(),
        size: [SIDE; 2],
        lights: &[],
        materials: &materials,
        objects: &objects,
    };
    let beyond = LitFrame::new(&test.gpu, &test.painter, &test.environment, &scene).unwrap_err();
    assert_eq!(beyond.to_string(), "a part uses the indices 0..6, but the buffer has 3");
    // Empty scenes and meshes are no mistake.
    let empty = IndexedMesh::new(Vec::new(), Vec::new());
    let nothing = test.draw(&[Shown::new(&empty)]);
    assert!(nothing.rgba.iter().all(|&byte| byte == 0) && test.draw(&[]) == nothing);
}
