//! Every verb writes valid glTF and keeps the parts of a scene.

use serde_json::Value;
use striata_testing::gltf_check::CheckedGlb;
use striata_testing::scenes;

use crate::workbench::Workbench;

/// Commands that write a GLB of the scene `in.glb`, each with what it prepares before.
const LINES: [&[&str]; 11] = [
    &["convert in.glb out.glb"],
    &["convert in.glb out.glb --meshopt"],
    &["convert in.glb out.glb --quantize --dedup --resample"],
    &["convert in.glb packed.glb --draco", "convert packed.glb out.glb"],
    &["simplify in.glb -o out.glb --ratio .5"],
    &["simplify in.glb -o out.glb --ratio .1 --meshopt"],
    &["simplify in.glb -o out.glb --ratio .5 --texture-format webp"],
    &["build in.glb -o in.striata", "extract in.striata -o out.glb --ratio .5"],
    &["encode in.glb -o in.stri", "decode in.stri -o out.glb"],
    &["encode in.glb -o streams.glb", "convert streams.glb out.glb"],
    &["build in.glb -o out.glb --ranges 3"],
];

/// Counts that may change: the scene, a word of the command, and the name of the count.
const EXCEPTIONS: [(&str, &str, &str); 12] = [
    // Nodes that do more than show a mesh get a child that converts from the grid.
    ("hierarchy", "--meshopt", "nodes"),
    ("hierarchy", "--quantize", "nodes"),
    ("morphed", "--meshopt", "nodes"),
    ("morphed", "--quantize", "nodes"),
    ("unknown references", "--meshopt", "nodes"),
    ("unknown references", "--quantize", "nodes"),
    ("animated properties", "--meshopt", "nodes"),
    ("animated properties", "--quantize", "nodes"),
    ("chains", "--meshopt", "nodes"),
    ("chains", "--quantize", "nodes"),
    // glTF has no primitives without triangles.
    ("vanishing primitive", "", "primitives"),
    ("vanishing primitive", "", "attributes"),
];

/// Decodes a buffer view that meshoptimizer has compressed.
fn decoded(extension: &Value, bytes: &[u8]) -> Vec<u8> {
    use meshoptimizer_rs::codec;

    let number = |key: &str| extension[key].as_u64().expect("a number") as usize;
    let (count, stride) = (number("count"), number("byteStride"));
    let workspace = &mut meshoptimizer_rs::Workspace::default();
    let mut out = match extension["mode"].as_str() {
        Some("TRIANGLES") => codec::decode_index_buffer(count, stride, bytes, workspace),
        Some("INDICES") => codec::decode_index_sequence(count, stride, bytes, workspace),
        _ => codec::decode_vertex_buffer(count, stride, bytes, workspace),
    }
    .expect("the view can be decoded");
    match extension["filter"].as_str() {
        Some("OCTAHEDRAL") => codec::decode_filter_oct(&mut out, count, stride, workspace),
        Some("QUATERNION") => codec::decode_filter_quat(&mut out, count, stride, workspace),
        Some("EXPONENTIAL") => codec::decode_filter_exp(&mut out, count, stride, workspace),
        _ => Ok(()),
    }
    .expect("the filter fits the view");
    out
}

#[test]
fn every_verb_writes_valid_files_that_keep_the_parts_of_a_scene() {
    let mut problems = Vec::new();
    for scene in scenes::all() {
        let bench = Workbench::new();
        bench.write("in.glb", scene.to_glb());
        let before = CheckedGlb::new(&bench.read("in.glb"), decoded);
        for lines in LINES {
            let failed = lines.iter().find_map(|line| {
                let output = bench.command(line).arg("--quiet").output().expect("the command starts");
                (!output.status.success()).then(|| String::from_utf8_lossy(&output.stderr).into_owned())
            });
            if let Some(message) = failed {
                problems.push(format!("{}: {}: {message}", scene.name, lines[0]));
                continue;
            }
            let after = CheckedGlb::new(&bench.read("out.glb"), decoded);
            let mut found = after.faults().to_vec();
            found.retain(|fault| !before.faults().contains(fault));
            let counts = after.counts();
            for (name, count) in before.counts() {
                let is_exception = EXCEPTIONS
                    .iter()
                    .any(|(of, word, what)| *of == scene.name && lines[0].contains(word) && *what == name);
                if counts[name] != count && !is_exception {
                    found.push(format!("{} {name}, not {count}", counts[name]));
                }
            }
            problems.extend(found.iter().map(|problem| format!("{}: {}: {problem}", scene.name, lines[0])));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}
