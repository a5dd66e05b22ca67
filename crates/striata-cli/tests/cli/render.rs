//! `render`: the contents of pictures, and errors.

use serde_json::Value;

use crate::png::DecodedPng;
use crate::workbench::{NO_DRIVERS, Workbench, assert_keys, asset};

fn picture(bench: &Workbench, arguments: &str) -> (DecodedPng, Value) {
    let report = bench.json(&format!("render {arguments} -o out.png"));
    (DecodedPng::of(&bench.read("out.png")), report)
}

#[test]
fn a_picture_has_the_requested_size_and_shows_the_mesh() {
    let bench = Workbench::with_ball();
    let (picture, report) = picture(&bench, "sphere.obj --size 200x150");
    assert_eq!((picture.width, picture.height), (200, 150));
    let drawn = picture.drawn(0..200);
    assert!(drawn > 200 * 150 / 3 && drawn < 200 * 150 * 7 / 10, "{drawn} pixels");
    assert_keys(&report, &["adapter", "frame_secs", "path", "secs"]);
    assert_eq!(
        (&report["triangle_count"], &report["levels"][0]["triangle_count"]),
        (&512.into(), &512.into())
    );
    assert!(report["frame_secs"].as_f64().is_some_and(|secs| secs > 0.0), "{report}");
    // No temporary file is left.
    assert_eq!(bench.names(), ["ball.striata", "out.png", "sphere.obj"]);
}

#[test]
fn a_picture_can_be_written_to_stdout_without_json() {
    let bench = Workbench::new();
    let assert = bench.run("render shape:torus -o - --size 90x60").success();
    let picture = DecodedPng::of(&assert.get_output().stdout);
    assert_eq!((picture.width, picture.height), (90, 60));
    assert!(bench.refused("render shape:torus -o - --json").contains("stdout"));
    assert_eq!(bench.names(), Vec::<String>::new());
}

#[test]
fn several_levels_are_drawn_side_by_side() {
    let bench = Workbench::with_ball();
    let (picture, report) =
        picture(&bench, "ball.striata --levels 100%,10%,20 --size 480x220 --flat --wireframe");
    let counts: Vec<u64> =
        (0..3).map(|i| report["levels"][i]["triangle_count"].as_u64().expect("a number")).collect();
    assert!(
        counts[0] == 512 && (45..=51).contains(&counts[1]) && (15..=20).contains(&counts[2]),
        "{counts:?}"
    );
    assert_eq!(report["triangle_count"], counts.iter().sum::<u64>());
    assert!(report["levels"][2]["error"].as_f64() > report["levels"][1]["error"].as_f64(), "{report}");
    let third = |i: usize| 160 * i..160 * (i + 1);
    for i in 0..3 {
        assert!(picture.drawn(third(i)) > 3000, "level {i} is not there");
        let next = (i + 1) % 3;
        let differing = (0..220)
            .flat_map(|y| third(i).map(move |x| (x, y)))
            .filter(|&(x, y)| picture.at(x, y) != picture.at(x % 160 + 160 * next, y));
        assert!(differing.count() > 1500, "levels {i} and {next} look the same");
    }
}

#[test]
fn all_models_show_the_same_level() {
    let bench = Workbench::with_ball();
    let of = |model: &str| {
        picture(&bench, &format!("ball.striata --triangles 100 --size 160x120 --model {model}"))
    };
    let (list, report) = of("list");
    assert_eq!(report["levels"][0]["model"], "list");
    for model in ["lodstrips", "mts", "fans", "patterns"] {
        let (other, report) = of(model);
        assert_eq!(report["levels"][0]["model"], model);
        assert!(list.differing(&other) < 8, "{model}: {} pixels", list.differing(&other));
    }
    let (default, report) = picture(&bench, "ball.striata --triangles 100 --size 160x120");
    assert_eq!(report["levels"][0]["model"], "lodstrips", "the one that the file has");
    assert!(list.differing(&default) < 8);
}

#[test]
fn strips_fans_and_triangles_are_colored_differently() {
    let bench = Workbench::with_ball();
    let hues = |picture: &DecodedPng| {
        let pixels = picture.pixels.iter().filter(|p| p[3] > 250 && p[..3].iter().max() > Some(&60));
        let shares = pixels.map(|p| {
            let most = u32::from(p[..3].iter().copied().max().unwrap_or(1));
            [0, 1, 2].map(|k| u32::from(p[k]) * 6 / most)
        });
        shares.collect::<std::collections::BTreeSet<_>>().len()
    };
    let plain = hues(&picture(&bench, "ball.striata --size 200x150 --background none").0);
    for colors in ["strips", "fans", "triangles", "fragments"] {
        let (colored, _) =
            picture(&bench, &format!("ball.striata --size 200x150 --background none --colors {colors}"));
        assert!(hues(&colored) > plain + 6, "{colors}: {} hues, {plain} of stone", hues(&colored));
    }
    let (rows, report) =
        picture(&bench, "ball.striata --size 300x400 --colors surface,strips --levels 100%,20%");
    assert_eq!(report["triangle_count"].as_u64(), Some(2 * (512 + 102)), "{report}");
    let strip_count = report["levels"][1]["strip_count"].as_u64().expect("a number");
    assert!((1..=10).contains(&strip_count), "the coarse level has strips of its own: {report}");
    assert!(rows.drawn(0..150) > 9000 && rows.drawn(150..300) > 9000);
}

#[test]
fn the_heat_scale_ends_at_the_largest_distance() {
    let bench = Workbench::with_ball();
    bench.run("extract ball.striata -o level.ply --triangles 60").success();
    let measured = bench.json("distance sphere.obj level.ply")["a_to_b"]["max"].as_f64().expect("a distance");
    let (picture, report) =
        picture(&bench, "ball.striata --heat --triangles 60 --size 400x300 --background light");
    let top = report["heat"]["top"].as_f64().expect("a distance");
    assert!((top - measured).abs() < 0.1 * measured, "{top} against {measured}");
    assert_eq!(report["levels"][0]["distance_max"].as_f64(), Some(top));
    // The color bar: pale below, dark above, of constant width.
    let bar = (0..400).rev().find(|&x| {
        let ([r, _, b, _], [low, ..]) = (picture.at(x, 232), picture.at(x, 67));
        r > 240 && b < 190 && low < 110
    });
    assert!(bar.is_some_and(|x| x > 280), "no bar: {bar:?}");
    let (other, _) =
        crate::render::picture(&bench, "ball.striata --heat --triangles 60 --heat-max 100% --size 400x300");
    let (same, _) = crate::render::picture(&bench, "ball.striata --heat --triangles 60 --size 400x300");
    assert!(same.differing(&other) > 5000, "another end of the bar, other colors");
}

#[test]
fn a_view_seen_from_outside_is_coarse_behind_the_eye() {
    let bench = Workbench::new();
    // The eye is in the middle of a terrain and looks along x; seen from above, its view is to the right.
    let view = "shape:terrain --eye 0,0,0.3 --look-at 5,0,0.1 --up 0,0,1 --pixels 0.5 --size 500x400 \
        --background none \
                --colors triangles --flat --rise 89 --turn 0";
    let bounds = bench.json("info shape:terrain");
    let middle = |k: usize| {
        let side = |name: &str| bounds["bounds"][name][k].as_f64().expect("a number");
        (side("min") + side("max")) / 2.0
    };
    let reach = bounds["bounds"]["max"][0].as_f64().expect("a number") - middle(0);
    let eye = format!("{},{},{}", middle(0), middle(1), middle(2) + 0.2 * reach);
    let look_at = format!("{},{},{}", middle(0) + reach, middle(1), middle(2));
    let view = view.replace("0,0,0.3", &eye).replace("5,0,0.1", &look_at);
    let (picture, report) = picture(&bench, &view);
    let shown = report["triangle_count"].as_u64().expect("a number");
    assert!(shown < bounds["triangle_count"].as_u64().expect("a number"), "{report}");
    assert_eq!(report["levels"][0]["model"], "fans");
    let changes = |columns: std::ops::Range<usize>| {
        let places = (100..300).flat_map(|y| columns.clone().map(move |x| (x, y)));
        places.filter(|&(x, y)| picture.at(x, y) != picture.at(x + 1, y)).count()
    };
    let (behind, ahead) = (changes(80..200), changes(300..420));
    assert!(ahead > 2 * behind && behind > 20, "{behind} changes of color behind, {ahead} ahead");
    // The outline of the frustum.
    let is_line = |p: &&[u8; 4]| p[0] > 220 && (90..170).contains(&p[1]) && p[2] < 90;
    assert!(picture.pixels.iter().filter(is_line).count() > 150, "no frustum");
    let through_it = bench.json(&format!("render {} -o eye.png", view.replace("--rise 89 --turn 0", "")));
    assert_eq!(through_it["triangle_count"], shown);
    assert!(DecodedPng::of(&bench.read("eye.png")).differing(&picture) > 20_000);
}

#[test]
fn camera_and_background_flags_have_an_effect() {
    let bench = Workbench::with_ball();
    let of = |arguments: &str| picture(&bench, &format!("sphere.obj --size 120x120 {arguments}")).0;
    let usual = of("");
    assert!(of("--zoom 0.5").drawn(0..120) * 3 < usual.drawn(0..120));
    assert!(of("--from 0,0,9").drawn(0..120) < usual.drawn(0..120) / 2);
    assert_eq!(of("--background #204060").at(0, 0), [32, 64, 96, 255]);
    assert_eq!(of("--background none").at(0, 0)[3], 0);
    assert!(of("--background light").at(0, 0)[0] > 220);
    let spot = asset("spot.obj.zst");
    let of = |turn: &str| picture(&bench, &format!("{} --size 120x120 --turn {turn}", spot.display())).0;
    assert!(of("0").differing(&of("90")) > 1000);
    assert_eq!(of("30").differing(&of("-330")), 0);
}

#[test]
fn meshes_without_visible_triangles_are_drawn() {
    let bench = Workbench::new();
    bench.write("point.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
    bench.write("none.off", "OFF\n0 0 0\n");
    for name in ["point.obj", "none.off"] {
        for flags in ["", "--heat", "--wireframe --levels 100%,1", "--colors strips,fans,groups"] {
            let (picture, _) = picture(&bench, &format!("{name} --size 64x64 {flags} --background none"));
            assert_eq!((picture.width, picture.height), (64, 64), "{name} {flags}");
        }
    }
    let assert = bench.run("render point.obj -o one.png --size 8x8").success();
    let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(stderr.contains("1 triangle;"), "{stderr}");
}

#[test]
fn wrong_flags_and_files_are_refused() {
    let bench = Workbench::new();
    bench.write("nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 nan 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    for (arguments, message) in [
        ("shape:torus -o out.jpg", "PNG"),
        ("shape:torus -o out.png --size 0x10", "0x10"),
        ("shape:torus -o out.png --size 9000x10", "8192"),
        ("shape:torus -o out.png --levels 110%", "110%"),
        ("shape:torus -o out.png --levels 10% --triangles 5", "--triangles"),
        ("shape:torus -o out.png --colors plaid", "plaid"),
        ("shape:torus -o out.png --colors strips,fans --rows 2", "--rows"),
        ("shape:torus -o out.png --heat --colors strips", "--heat"),
        ("shape:torus -o out.png --heat-max 1", "--heat"),
        ("shape:torus -o out.png --background mauve", "mauve"),
        ("shape:torus -o out.png --zoom 0", "--zoom"),
        ("shape:torus -o out.png --pixels 2", "--eye"),
        ("shape:torus -o out.png --eye 0,0,0 --look-at 0,0,0", "--look-at"),
        ("shape:torus -o out.png --eye 9,0,0 --colors fragments", "uniform levels"),
        ("shape:torus -o out.png --from 0,0,0 --look-at 0,0,0", "--from"),
        ("shape:torus -o out.png --from 1,0,0 --turn 5", "--turn"),
        ("shape:ball -o out.png", "torus"),
        ("nowhere.ply -o out.png", "nowhere.ply"),
        ("nan.off -o out.png", "NaN"),
    ] {
        let text = bench.refused(&format!("render {arguments}"));
        assert!(text.contains(message), "{arguments}: {text}");
    }
    assert_eq!(bench.names(), ["nan.off"]);
}

#[test]
fn without_a_driver_the_software_rasterizer_draws_the_same_with_a_note() {
    let bench = Workbench::with_ball();
    let arguments = "render ball.striata --levels 100%,10% --size 300x160 --json";
    let (expected, _) = picture(&bench, &arguments.replace("render ", "").replace(" --json", " --software"));
    let assert = bench.command(&format!("{arguments} -o bare.png")).envs(NO_DRIVERS).assert().success();
    let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(
        message.starts_with("note: ") && message.contains("using the software rasterizer instead"),
        "{message}"
    );
    assert_eq!(message.lines().count(), 1, "{message}");
    let report: Value = serde_json::from_slice(&assert.get_output().stdout).expect("JSON");
    assert_eq!(report["adapter"], "the software rasterizer");
    assert_eq!(DecodedPng::of(&bench.read("bare.png")).differing(&expected), 0);
    let assert =
        bench.command(&format!("{arguments} --quiet -o bare.png")).envs(NO_DRIVERS).assert().success();
    assert!(assert.get_output().stderr.is_empty());
}

#[test]
fn driver_messages_are_only_shown_with_verbose() {
    let bench = Workbench::with_ball();
    let of = |flags: &str| {
        let mut command = bench.command(&format!("render ball.striata -o a.png --size 60x60{flags}"));
        let assert = command.env_remove("XDG_RUNTIME_DIR").env("EGL_LOG_LEVEL", "debug").assert().success();
        String::from_utf8_lossy(&assert.get_output().stderr).into_owned()
    };
    let usual = of("");
    assert!(usual.lines().count() <= 2, "{usual}");
    assert!(usual.lines().all(|line| line.starts_with("note: ") || line.contains("a.png")), "{usual}");
    let verbose = of(" --verbose");
    assert!(verbose.lines().count() > usual.lines().count(), "{verbose}");
}

#[test]
fn an_unknown_adapter_is_refused() {
    let bench = Workbench::new();
    let message = bench.refused("render shape:torus -o out.png --adapter none-such");
    assert!(message.contains("none-such") && message.contains("hint: name another"), "{message}");
    assert_eq!(bench.names(), Vec::<String>::new());
}
