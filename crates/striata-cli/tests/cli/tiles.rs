//! 3D Tiles from paged files and from meshes.

use std::fs;

use serde_json::Value;
use striata::mesh::shapes;

use crate::workbench::Workbench;

/// A terrain at the equator, on the central meridian of a zone of UTM.
fn write_terrain(bench: &Workbench, name: &str, epsg: u32) {
    let mut mesh = shapes::terrain(40, 1);
    mesh.appearance.georeference = format!(r#"{{"origin":[500000.0,0.0],"epsg":{epsg}}}"#);
    striata_io::write(bench.path(name), &mesh, &striata_io::WriteOptions::default()).unwrap();
}

fn tileset(bench: &Workbench, folder: &str) -> Value {
    serde_json::from_slice(&fs::read(bench.path(&format!("{folder}/tileset.json"))).unwrap()).unwrap()
}

#[test]
fn a_paged_file_and_its_input_have_the_same_tiles() {
    let bench = Workbench::new();
    bench.run("build shape:terrain:130 -o t.striata --cell 4000").success();
    let paged = bench.json("tiles t.striata -o a --tile-triangles 2000 --meshopt");
    let direct =
        bench.json("tiles shape:terrain:130 -o b --cell 4000 --tile-triangles 2000 --meshopt --memory 500MB");
    assert_eq!(paged["levels"], direct["levels"]);
    assert!(paged["tiles"].as_u64().unwrap() >= 21 && paged["up"] == "z", "{paged}");
    assert_eq!(tileset(&bench, "a"), tileset(&bench, "b"));
    let errors: Vec<f64> =
        paged["levels"].as_array().unwrap().iter().map(|level| level["error"].as_f64().unwrap()).collect();
    assert!(errors[0] == 0.0 && errors.is_sorted(), "{errors:?}");
    let files: Vec<_> =
        fs::read_dir(bench.path(".")).unwrap().map(|file| file.unwrap().file_name()).collect();
    assert_eq!(files.len(), 3, "nothing temporary is left: {files:?}");
    // Built-in shapes, files with levels, and archives.
    bench.json("tiles shape:torus -o torus.3tz --tile-triangles 5000 --draco");
    assert!(fs::read(bench.path("torus.3tz")).unwrap().starts_with(b"PK"));
    bench.run("build shape:torus -o torus.striata").success();
    bench.json("tiles torus.striata -o torus --tile-triangles 5000 --quantize --raw");
}

#[test]
fn a_georeference_becomes_a_place_on_the_earth() {
    let bench = Workbench::new();
    write_terrain(&bench, "t.glb", 32633);
    let report = bench.json("tiles t.glb -o t");
    assert_eq!((&report["epsg"], report["tiles"].as_u64()), (&32633.into(), Some(1)));
    let transform = tileset(&bench, "t")["root"]["transform"].clone();
    let number = |i: usize| transform[i].as_f64().unwrap();
    // The mesh begins 15 degrees east of Greenwich.
    let place = [12, 13, 14].map(number);
    let (sin, cos) = 15f64.to_radians().sin_cos();
    let distance = [6_378_137.0 * cos, 6_378_137.0 * sin, 0.0];
    let distance = (0..3).map(|i| (place[i] - distance[i]).powi(2)).sum::<f64>().sqrt();
    assert!(distance < 100.0, "{transform}");
    // Up leads away from the center of the Earth.
    let up = (0..3).map(|i| number(8 + i) * place[i]).sum::<f64>();
    assert!(up > 6_300_000.0, "{transform}");
    let local = bench.json("tiles t.glb -o local --local");
    assert_eq!((&local["epsg"], &local["left_out"]), (&Value::Null, &serde_json::json!([])));
    let turned = bench.json("tiles t.glb -o turned --up y");
    assert_eq!(turned["left_out"][0], "the georeference is left out: the z axis is not up");
    write_terrain(&bench, "odd.glb", 99);
    let refused = bench.refused("tiles odd.glb -o odd");
    assert!(refused.contains("EPSG:99") && refused.contains("--local"), "{refused}");
    assert!(!bench.path("odd").exists());
}

/// A surface of `count` squares along each side, with a material whose image may be missing.
fn write_textured(bench: &Workbench, count: usize, has_image: bool) {
    let mut obj = String::from("mtllib t.mtl\nusemtl paint\n");
    for (i, j) in (0..=count).flat_map(|j| (0..=count).map(move |i| (i, j))) {
        let [x, y] = [i, j].map(|k| k as f64 / count as f64);
        obj += &format!("v {x} {y} {}\nvt {x} {y}\n", 0.1 * (9.0 * x).sin() * (7.0 * y).cos());
    }
    for (i, j) in (0..count).flat_map(|j| (0..count).map(move |i| (i, j))) {
        let [a, b] = [1 + j * (count + 1) + i, 1 + (j + 1) * (count + 1) + i];
        obj += &format!("f {a}/{a} {0}/{0} {1}/{1} {b}/{b}\n", a + 1, b + 1);
    }
    bench.write("t.obj", obj);
    bench.write("t.mtl", "newmtl paint\nmap_Kd paint.png\n");
    if has_image {
        let mut png = Vec::new();
        let mut encoder = png::Encoder::new(&mut png, 256, 256);
        encoder.set_color(png::ColorType::Rgb);
        let pixels: Vec<u8> = (0..256u32 * 256).flat_map(|i| [i, i >> 8, i >> 3].map(|x| x as u8)).collect();
        encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
        bench.write("paint.png", png);
    }
}

#[test]
fn textures_become_atlases() {
    let bench = Workbench::new();
    write_textured(&bench, 80, false);
    let missing = bench.json("tiles t.obj -o missing --tile-triangles 1000");
    assert!(missing["left_out"][0].as_str().unwrap().contains("paint.png"), "{missing}");
    assert_eq!(missing["image_bytes"], 0);
    write_textured(&bench, 80, true);
    let report = bench.json("tiles t.obj -o t --tile-triangles 1000 --draco");
    assert_eq!(report["left_out"], serde_json::json!([]));
    assert!(report["atlases"].as_u64().unwrap() >= 4, "{report}");
    let coarse = bench.json("tiles t.obj -o coarse --tile-triangles 1000 --draco --texture-quality 20");
    assert!(coarse["image_bytes"].as_u64() < report["image_bytes"].as_u64(), "{coarse}");
    let plain = bench.json("tiles t.obj -o plain --tile-triangles 1000 --no-textures");
    assert_eq!((&plain["image_bytes"], &plain["left_out"]), (&0.into(), &serde_json::json!([])));
    // Tiles do not move.
    std::fs::copy(crate::workbench::asset("arm.glb"), bench.path("arm.glb")).unwrap();
    let arm = bench.json("tiles arm.glb -o arm");
    assert!(arm["left_out"].to_string().contains("joints and morph targets"), "{arm}");
    // Nothing temporary is left.
    let folders = ["arm", "arm.glb", "coarse", "missing", "paint.png", "plain", "t", "t.mtl", "t.obj"];
    assert_eq!(bench.names(), folders);
}

#[test]
fn what_cannot_be_done_is_refused_by_name() {
    let bench = Workbench::new();
    bench.run("build shape:terrain:60 -o t.striata --paged").success();
    fs::create_dir(bench.path("mine")).unwrap();
    fs::write(bench.path("mine/file"), "").unwrap();
    for (arguments, expected) in [
        ("tiles t.striata -o mine", "no tileset of striata"),
        ("tiles t.striata -o mine/file", "tiles need a folder"),
        ("tiles t.striata -o out --cell 4000", "--cell has no effect on a paged file"),
        ("tiles t.striata -o out --threads 0", "1..=1024"),
        ("tiles t.striata -o out --meshopt --draco", "cannot be used with"),
        ("tiles shape:torus -o out --up y --skirts", "skirts are for terrains"),
        ("tiles none.ply -o out", "none.ply"),
        ("tiles t.striata -o out --no-textures --texture-quality 3", "cannot be used with"),
        ("tiles t.striata -o out --texture-quality 0", "texture-quality"),
        ("tiles t.striata -o no/out", "no/out"),
    ] {
        let text = bench.refused(arguments);
        assert!(text.contains(expected), "{arguments}: {text}");
        assert!(!bench.path("out").exists());
    }
    assert!(bench.path("mine/file").exists());
    // A paged file is not built, but its tiles are.
    bench.run("tiles t.striata -o out --threads 2").success();
}

fn info(bench: &Workbench, folder: &str) -> Value {
    serde_json::from_slice(&fs::read(bench.path(&format!("{folder}/info"))).unwrap()).unwrap()
}

#[test]
fn an_input_becomes_a_segment_of_neuroglancer() {
    let bench = Workbench::new();
    bench.run("build shape:terrain:60 -o t.striata --paged").success();
    let report =
        bench.json("tiles t.striata -o meshes --format neuroglancer --tile-triangles 1000 --segment-id 42");
    assert_eq!((&report["segments"], report["levels"].as_array().unwrap().len() > 1), (&1.into(), true));
    assert_eq!(bench.names(), ["meshes", "t.striata"]);
    let written = info(&bench, "meshes");
    assert_eq!(written["@type"], "neuroglancer_multilod_draco");
    assert_eq!((&written["vertex_quantization_bits"], written.get("sharding")), (&16.into(), None));
    let bytes = |name: &str| fs::read(bench.path(&format!("meshes/{name}"))).unwrap().len() as u64;
    assert_eq!(report["bytes"], bytes("42") + bytes("42.index"));
    let small = bench.json("tiles t.striata -o meshes --format neuroglancer --bits 10 --sharded");
    assert!(small["bytes"].as_u64() < report["bytes"].as_u64());
    let written = info(&bench, "meshes");
    assert_eq!(written["vertex_quantization_bits"], 10);
    assert_eq!(written["sharding"]["@type"], "neuroglancer_uint64_sharded_v1");
    assert!(bench.path("meshes/0.shard").exists() && !bench.path("meshes/42").exists());
    // Tiles of another format may be replaced.
    bench.json("tiles t.striata -o meshes");
    assert!(!bench.path("meshes/info").exists());
}

#[test]
fn meshes_of_a_folder_become_segments() {
    let bench = Workbench::new();
    fs::create_dir(bench.path("cells")).unwrap();
    for (name, shape) in [("7.ply", "cube"), ("18446744073709551615.obj", "torus"), ("12.stl", "tetrahedron")]
    {
        bench.run(&format!("convert shape:{shape} cells/{name}")).success();
    }
    fs::write(bench.path("cells/notes.txt"), "mine").unwrap();
    let run = bench.run("tiles cells -o meshes --format neuroglancer").success();
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(said.contains("left out: cells/notes.txt"), "{said}");
    for name in ["7", "12.index", "18446744073709551615"] {
        assert!(bench.path(&format!("meshes/{name}")).exists(), "{name}");
    }
    let properties: Value =
        serde_json::from_slice(&fs::read(bench.path("meshes/segment_properties/info")).unwrap()).unwrap();
    assert_eq!(properties["inline"]["ids"], serde_json::json!(["7", "12", "18446744073709551615"]));
    let refused = bench.refused("tiles cells -o meshes --format neuroglancer --segment-id 3");
    assert!(refused.contains("--segment-id has no effect on a folder"), "{refused}");
    bench.run("convert shape:cube cells/007.glb").success();
    let refused = bench.refused("tiles cells -o other --format neuroglancer");
    assert!(refused.contains("cells/007.glb and cells/7.ply are both segment 7"), "{refused}");
    fs::rename(bench.path("cells/007.glb"), bench.path("cells/seven.glb")).unwrap();
    let refused = bench.refused("tiles cells -o other --format neuroglancer");
    assert!(refused.contains("seven.glb: the name is not the number of a segment"), "{refused}");
    assert_eq!(bench.names(), ["cells", "meshes"]);
}

#[test]
fn flags_of_another_format_are_refused() {
    let bench = Workbench::new();
    fs::create_dir(bench.path("empty")).unwrap();
    for (arguments, expected) in [
        ("--format neuroglancer --meshopt", "--meshopt has no effect on meshes of Neuroglancer"),
        ("--format neuroglancer --texture-quality 90", "--texture-quality has no effect"),
        ("--format neuroglancer --up z", "--up has no effect"),
        ("--format neuroglancer --bits 12", "invalid value '12'"),
        ("--format stars", "invalid value 'stars'"),
        ("--bits 10", "--bits has no effect on 3D Tiles"),
        ("--sharded", "--sharded has no effect on 3D Tiles"),
        ("--format zarr --bits 10", "--bits has no effect on Zarr stores"),
        ("--format zarr --draco", "--draco has no effect on Zarr stores"),
        ("--format zarr --tile-triangles 1000", "--tile-triangles has no effect"),
        ("--format zarr --exact", "--exact has no effect"),
        ("--format zarr shape:cube", "a Zarr store has one input"),
    ] {
        let text = bench.refused(&format!("tiles shape:torus -o out {arguments}"));
        assert!(text.contains(expected), "{arguments}: {text}");
    }
    let text = bench.refused("tiles empty -o out --format neuroglancer");
    assert!(text.contains("there are no meshes in this folder"), "{text}");
    assert_eq!(bench.names(), ["empty"]);
}

#[test]
fn an_input_becomes_a_zarr_store() {
    let bench = Workbench::new();
    let report = bench.json("tiles shape:torus -o direct.zarr --format zarr");
    let levels = report["levels"].as_array().unwrap();
    assert!(levels.len() > 3 && levels[0]["error"] == 0.0, "{report}");
    assert_eq!(levels[0]["vertices"], report["vertices"]);
    bench.run("build shape:torus -o t.striata --certify").success();
    let certified = bench.json("tiles t.striata -o t.zarr --format zarr");
    assert_eq!(certified["level_count"], report["level_count"]);
    let root: Value = serde_json::from_slice(&fs::read(bench.path("t.zarr/zarr.json")).unwrap()).unwrap();
    let described = &root["attributes"]["striata"];
    assert_eq!((&described["guaranteed_errors"], &described["version"]), (&true.into(), &1.into()));
    assert_eq!((&root["node_type"], &root["zarr_format"]), (&"group".into(), &3.into()));
    for path in certified["arrays"].as_array().unwrap() {
        let node = format!("t.zarr/{}/zarr.json", path.as_str().unwrap());
        assert!(bench.path(&node).exists(), "{node}");
    }
    // All levels of a paged file.
    bench.run("build shape:terrain:60 -o p.striata --paged").success();
    let paged = bench.json("tiles p.striata -o direct.zarr --format zarr");
    assert_eq!(paged["vertices"], 3600);
    std::fs::copy(crate::workbench::asset("arm.glb"), bench.path("arm.glb")).unwrap();
    let arm = bench.json("tiles arm.glb -o arm.zarr --format zarr");
    assert!(arm["left_out"].to_string().contains("left out: the materials"), "{arm}");
    assert_eq!(bench.names(), ["arm.glb", "arm.zarr", "direct.zarr", "p.striata", "t.striata", "t.zarr"]);
}
