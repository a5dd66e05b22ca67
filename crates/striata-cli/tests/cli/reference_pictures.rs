//! Pictures of scenes look like those that three.js draws of the same files from the same cameras in the same
//! light. `node tests/reference.mjs` in the folder `web` takes three.js' pictures again.

use std::path::Path;

use serde_json::Value;

use crate::png::DecodedPng;
use crate::workbench::Workbench;

/// Largest mean difference over the pixels that either picture covers, of 255 levels. Edges differ most: each
/// renderer smooths them in its own way.
const TOLERANCE: f64 = 4.0;

#[test]
fn pictures_look_like_those_of_three_js() {
    let shots: Vec<Value> = serde_json::from_str(include_str!("../reference/shots.json")).expect("JSON");
    for shot in &shots {
        let renderers: &[&str] = if cfg!(feature = "gpu") { &["--software", ""] } else { &["--software"] };
        for renderer in renderers {
            let difference = difference(shot, renderer);
            assert!(difference < TOLERANCE, "{shot} {renderer}: differs by {difference}");
        }
    }
}

/// Draws a shot, and returns its mean difference from the reference.
fn difference(shot: &Value, renderer: &str) -> f64 {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = |key: &str| shot[key].as_str().expect("a string").to_owned();
    let point = |key: &str| {
        let numbers: Vec<String> =
            shot[key].as_array().expect("a point").iter().map(Value::to_string).collect();
        numbers.join(",")
    };
    let bench = Workbench::new();
    let model = std::fs::read(root.join(text("model"))).expect("the model is in the repository");
    bench.write("model.glb", model);
    let time = if shot["time"].is_null() { String::new() } else { format!("--time {}", shot["time"]) };
    bench.json(&format!(
        "render model.glb -o out.png --background #000000 --size {}x{} --fov {} --from={} --look-at={} \
         {time} {renderer}",
        shot["width"],
        shot["height"],
        shot["fov"],
        point("eye"),
        point("lookAt"),
    ));
    let reference = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference").join(text("picture"));
    let theirs = DecodedPng::of(&std::fs::read(reference).expect("a reference picture"));
    mean_difference(&DecodedPng::of(&bench.read("out.png")), &theirs)
}

fn mean_difference(ours: &DecodedPng, theirs: &DecodedPng) -> f64 {
    assert_eq!((ours.width, ours.height), (theirs.width, theirs.height));
    let (mut sum, mut covered) = (0.0, 0u32);
    for (a, b) in ours.pixels.iter().zip(&theirs.pixels) {
        let differences = (0..3).map(|k| f64::from(a[k].abs_diff(b[k])));
        sum += differences.sum::<f64>() / 3.0;
        covered += u32::from((0..3).any(|k| a[k].max(b[k]) > 8));
    }
    assert!(covered > 2_000, "both pictures must show something: {covered} pixels");
    sum / f64::from(covered)
}
