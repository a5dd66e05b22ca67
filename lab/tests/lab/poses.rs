//! `poses`: levels of a tube that bends are measured in its animation.

use striata_testing::scenes;

use crate::workbench::Workbench;

#[test]
fn levels_of_a_bending_tube_hold() {
    let bench = Workbench::new();
    bench.write("tube.glb", scenes::bending_tube().to_glb());
    let report = bench.json("poses tube.glb --shares 25,10 --times 5 --quiet");
    let mesh = &report["scenes"][0]["meshes"][0];
    assert_eq!(mesh["pose_count"], 5);
    let levels = mesh["levels"].as_array().unwrap();
    assert_eq!(levels.len(), 2);
    for level in levels {
        let number = |pointer: &str| level.pointer(pointer).unwrap().as_f64().unwrap();
        assert_eq!(level["is_held"], true, "{level}");
        assert!(number("/distances/max") <= number("/error"), "{level}");
        assert!(number("/distances/max") < 0.5 * number("/bind/max"), "{level}");
        assert!(number("/bind/rms") <= number("/bind/max"), "{level}");
    }
}

#[test]
fn a_share_above_the_whole_is_refused() {
    let bench = Workbench::new();
    bench.write("tube.glb", scenes::bending_tube().to_glb());
    bench.command("poses tube.glb --shares 110").assert().failure().code(1);
}
