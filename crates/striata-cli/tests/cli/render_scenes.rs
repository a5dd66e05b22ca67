//! `render` of scenes: materials, poses, levels and cameras.

use serde_json::{Value, json};
use striata_testing::scenes;

use crate::png::DecodedPng;
use crate::workbench::{Workbench, asset};

/// Copies the animated and textured scene of the repository into a folder.
fn bench() -> Workbench {
    let bench = Workbench::new();
    std::fs::copy(asset("arm.glb"), bench.path("arm.glb")).expect("the folder is ours");
    bench
}

/// Draws without a GPU, which gives the same pixels on every machine.
fn picture(bench: &Workbench, arguments: &str) -> (DecodedPng, Value) {
    let report = bench.json(&format!("render {arguments} --software --size 160x120 -o out.png"));
    (DecodedPng::of(&bench.read("out.png")), report)
}

/// Number of clearly different colors, in steps of an eighth.
fn color_count(picture: &DecodedPng) -> usize {
    let colors = picture.pixels.iter().filter(|p| p[3] > 250);
    colors.map(|p| [0, 1, 2].map(|k| p[k] / 32)).collect::<std::collections::BTreeSet<_>>().len()
}

#[test]
fn an_animation_is_posed_at_a_time() {
    let bench = bench();
    let (rest, report) = picture(&bench, "arm.glb --turn 0 --rise 0");
    assert!(rest.drawn(0..160) > 600, "{report}");
    let at = |time: &str| picture(&bench, &format!("arm.glb --from 0,2,9 --time {time}")).0;
    let (start, later) = (at("0"), at("0.7"));
    assert!(start.differing(&later) > 200, "{} pixels differ", start.differing(&later));
    assert_eq!(start.differing(&at("0 --animation 0")), 0);
    let message = bench.run("render arm.glb -o a.png --software --size 40x30 --time 1000").success();
    let message = String::from_utf8_lossy(&message.get_output().stderr).into_owned();
    assert!(message.contains("ends after"), "{message}");
}

#[test]
fn levels_are_those_of_the_whole_scene() {
    let bench = bench();
    let (_, report) = picture(&bench, "arm.glb --levels 100%,10%,2% --time 0.5");
    let of = |level: usize, key: &str| report["levels"][level][key].as_f64().expect("a number");
    let full = of(0, "triangle_count");
    assert!((0.08..=0.1).contains(&(of(1, "triangle_count") / full)), "{report}");
    assert!(of(2, "triangle_count") <= 0.02 * full && of(2, "error") > of(1, "error"), "{report}");
    let simplified = bench.json("simplify arm.glb -o level.glb --triangles 10% --placement subset");
    assert_eq!(simplified["triangle_count"], report["levels"][1]["triangle_count"]);
    let (level, _) = picture(&bench, "arm.glb --triangles 10% --from 0,2,9 --look-at 0,1,0 --time 0.5");
    let (same, _) = picture(&bench, "level.glb --from 0,2,9 --look-at 0,1,0 --time 0.5");
    assert_eq!(level.differing(&same), 0);
    let (view, report) = picture(&bench, "arm.glb --eye 0,2,12 --pixels 1 --time 0.5");
    assert!(report["triangle_count"].as_f64() < Some(full / 2.0) && view.drawn(0..160) > 40, "{report}");
}

#[test]
fn files_and_streams_look_like_their_scene() {
    let bench = bench();
    bench.json("build arm.glb -o arm.striata");
    bench.json("encode arm.glb -o arm.stri --lossless");
    bench.json("encode arm.glb -o everywhere.glb --lossless");
    let (expected, report) = picture(&bench, "arm.glb --time 0.4");
    for name in ["arm.striata", "arm.stri", "everywhere.glb"] {
        let (found, other) = picture(&bench, &format!("{name} --time 0.4"));
        assert_eq!(other["triangle_count"], report["triangle_count"], "{name}");
        assert!(found.differing(&expected) < 4, "{name}: {} pixels", found.differing(&expected));
    }
}

#[test]
fn other_colorings_show_the_posed_triangles() {
    let bench = bench();
    let (lit, _) = picture(&bench, "arm.glb --time 0.5 --background none");
    for flags in ["--colors triangles", "--colors strips", "--wireframe", "--heat --triangles 2%"] {
        let (other, _) = picture(&bench, &format!("arm.glb --time 0.5 --background none {flags}"));
        // Materials hide the backs of triangles; these pictures show them.
        let pairs = lit.pixels.iter().zip(&other.pixels);
        let missing = pairs.filter(|(a, b)| a[3] > 128 && b[3] < 128).count();
        assert!(flags.contains("heat") || missing < 20, "{flags}: {missing} pixels are missing");
        assert!(lit.differing(&other) > 60, "{flags}: {}", lit.differing(&other));
    }
    let (triangles, _) = picture(&bench, "arm.glb --time 0.5 --background none --colors triangles");
    assert!(color_count(&triangles) > color_count(&lit), "{} colors", color_count(&triangles));
}

#[test]
fn coarse_levels_show_their_facets_if_they_are_flat() {
    let bench = Workbench::new();
    bench.write("amphora.glb", include_bytes!("../../assets/amphora.glb"));
    let drawn = |flag: &str| picture(&bench, &format!("amphora.glb --triangles 3% {flag}")).0;
    let [smooth, flat] = ["", "--flat"].map(drawn);
    assert!(smooth.differing(&flat) > 60, "{} pixels differ", smooth.differing(&flat));
}

#[test]
fn cameras_of_the_scene_are_used() {
    let bench = bench();
    let (through, _) = picture(&bench, "arm.glb --camera 0");
    assert!(through.drawn(0..160) > 200);
    for (arguments, message) in [
        ("arm.glb --camera 7", "no camera"),
        ("arm.glb --camera 0 --turn 3", "--turn"),
        ("arm.glb --animation jump", "no animation"),
        ("arm.glb --time -1", "--time"),
        ("shape:torus --time 1", "--time is for scenes"),
        ("shape:torus --camera 0", "--camera is for scenes"),
        ("arm.glb --model fans --time 1", "--model"),
    ] {
        let text = bench.refused(&format!("render {arguments} -o out2.png"));
        assert!(text.contains(message), "{arguments}: {text}");
    }
    bench.write("still.glb", scenes::hierarchy().to_glb());
    let text = bench.refused("render still.glb --time 0.5 -o out2.png");
    assert!(text.contains("the scene has no animation"), "{text}");
}

#[test]
fn plain_meshes_are_stone_in_every_format() {
    let bench = Workbench::with_ball();
    bench.json("convert sphere.obj sphere.glb --raw");
    let (expected, _) = picture(&bench, "sphere.obj");
    for flags in ["", "--triangles 100", "--colors fans"] {
        let (a, _) = picture(&bench, &format!("sphere.obj {flags}"));
        let (b, _) = picture(&bench, &format!("sphere.glb {flags}"));
        assert!(a.differing(&b) < 4, "{flags}: {} pixels", a.differing(&b));
    }
    let warm = expected.pixels.iter().filter(|p| p[0] > 100).all(|p| p[0] > p[2]);
    assert!(warm, "stone is reddish");
}

#[test]
fn textures_of_obj_files_are_drawn() {
    let bench = Workbench::new();
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, 2, 1);
    encoder.set_color(::png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("memory");
    writer.write_image_data(&[250, 10, 10, 10, 250, 10]).expect("memory");
    drop(writer);
    bench.write("two.png", bytes);
    bench.write("m.mtl", "newmtl m\nmap_Kd two.png\n");
    let square = "mtllib m.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n\
                  vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    bench.write("square.obj", square);
    let (picture, _) = picture(&bench, "square.obj --turn 0 --rise 0 --up 0,1,0");
    let [left, right] = [50, 110].map(|x| picture.at(x, 60));
    assert!(left[0] > 2 * left[1] && right[1] > 2 * right[0], "{left:?} {right:?}");
    // Without its material library, the same file is stone.
    bench.write("bare.obj", square.replace("mtllib m.mtl\n", ""));
    let (bare, _) = crate::render_scenes::picture(&bench, "bare.obj --turn 0 --rise 0 --up 0,1,0");
    let [left, right] = [50, 110].map(|x| bare.at(x, 60));
    assert!(
        left[0] > left[2] && left.iter().zip(right).all(|(a, b)| a.abs_diff(b) < 12),
        "{left:?} {right:?}"
    );
}

#[test]
fn images_that_cannot_be_decoded_are_reported_and_left_out() {
    let bench = Workbench::new();
    let mut scene = scenes::hierarchy();
    scene.document["materials"][0] = scene.document["materials"][1].clone();
    // The image of the emission becomes something else: the scene must not glow.
    scene.document["images"] = json!([{ "uri": "data:image/png;base64,AAAA", "name": "noise" }]);
    bench.write("a.glb", scene.to_glb());
    let assert = bench.run("render a.glb --software --size 80x60 -o out.png").success();
    let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(stderr.contains("warning: ") && stderr.contains("noise"), "{stderr}");
    assert!(DecodedPng::of(&bench.read("out.png")).drawn(0..80) > 500);
}
