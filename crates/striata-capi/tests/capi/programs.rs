//! Programs in C and C++, compiled with the compiler of the system, see what Rust sees.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use striata::file::{StriataFile, WriteOptions};
use striata::mesh::{IndexedMesh, canonical_triangles, replay, shapes};
use striata::simplify::{BatchOptions, build_batches};
use striata::view::Camera;
use striata::{Lod, LodOptions, Target};
use striata_stream::{StreamDecoder, StreamOptions, encode_stream};

fn checksum(numbers: impl IntoIterator<Item = u32>) -> u32 {
    numbers.into_iter().fold(2_166_136_261, |sum, number| (sum ^ number).wrapping_mul(16_777_619))
}

/// Compiles a program in C or C++ with the library, in the folder of this test; [`None`] without a compiler.
fn compiled(source: &str, name: &str, arguments: &[&str]) -> Option<PathBuf> {
    if cfg!(not(unix)) {
        return None;
    }
    let crate_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let test = std::env::current_exe().expect("the path of this test");
    let libraries = test.parent().expect("a folder").to_owned();
    let (compiler, standard) =
        if source.ends_with(".cpp") { ("c++", "-std=c++17") } else { ("cc", "-std=c11") };
    if Command::new(compiler).arg("--version").output().is_err() {
        return None;
    }
    let program = libraries.join(name);
    let mut command = Command::new(compiler);
    command.args([standard, "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1", "-o"]).arg(&program);
    command.arg(crate_folder.join(source)).arg("-I").arg(crate_folder.join("include"));
    command
        .args(arguments.iter().map(|argument| argument.replace("LIBRARIES", &libraries.to_string_lossy())));
    let output = command.output().expect("the compiler runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(program)
}

const STATIC: [&str; 4] = ["LIBRARIES/libstriata_capi.a", "-lpthread", "-ldl", "-lm"];
const SHARED: [&str; 3] = ["-LLIBRARIES", "-lstriata_capi", "-Wl,-rpath,LIBRARIES"];

/// Runs a program, under a tool such as `STRIATA_RUNNER="valgrind -q --error-exitcode=9"` if that is set.
fn output_of(program: &Path, arguments: &[&Path]) -> String {
    let runner = std::env::var("STRIATA_RUNNER").unwrap_or_default();
    let mut words =
        runner.split_whitespace().map(Path::new).chain([program]).chain(arguments.iter().copied());
    let mut command = Command::new(words.next().expect("a program"));
    let output = command.args(words).output().expect("the program runs");
    assert!(output.status.success(), "{:?}: {}", output.status, String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// The number as `%.6g` of C prints it, for numbers between 0.0001 and 1, and 0.
fn short(number: f32) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    let digits = (5 - number.log10().floor() as i32) as usize;
    let text = format!("{number:.digits$}");
    text.trim_end_matches('0').to_owned()
}

fn level_line(lod: &Lod, target: Target) -> String {
    let level = lod.level(target);
    let refinable =
        striata::mesh::RefinableMesh { mesh: lod.mesh().clone(), sequence: lod.sequence().clone() };
    let expected = canonical_triangles(&replay(&refinable, level.split_count()).triangles);
    assert_eq!(canonical_triangles(level.triangles()), expected);
    let (error, sum) = (short(level.error()), checksum(level.indices().iter().copied()));
    let (vertices, triangles) = (level.vertex_count(), level.triangle_count());
    format!("level {} {vertices} {triangles} {error} {sum:08x}\n", level.split_count())
}

fn targets(lod: &Lod) -> String {
    let quarter = lod.mesh().triangle_count() / 4;
    [
        Target::Triangles(100),
        Target::Vertices(100),
        Target::Triangles(quarter),
        Target::Error(0.01),
        Target::Detail(0.5),
        Target::SplitCount(7),
    ]
    .map(|target| level_line(lod, target))
    .concat()
}

fn facts_line(lod: &Lod) -> String {
    let base = lod.level(Target::SplitCount(0)).triangle_count();
    format!("facts {} {} {base}\n", lod.mesh().vertex_count(), lod.mesh().triangle_count())
}

fn range_lines(lod: &Lod) -> String {
    let splits = lod.sequence().halving_split_counts();
    let made = lod.ranges(&splits[..4], None);
    let mut lines = String::new();
    for range in &made.ranges {
        let (first, count) = (range.first_index, range.index_count);
        writeln!(lines, "range {first} {count} {}", range.vertex_count).expect("text");
    }
    lines + &format!("ranges {:08x}\n", checksum(made.indices))
}

fn view_lines(lod: &Lod) -> String {
    let camera = Camera::new([0.0, 0.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0], 0.5, [800, 800]).expect("a camera");
    let mut view = lod.view();
    view.update(&camera, 2.0);
    let sum = checksum(view.indices().iter().copied());
    let uniform = level_line(lod, lod.target_for_view(&camera, 2.0));
    format!("view {} {sum:08x}\nchanges 1 {sum:08x} 0\n{uniform}", view.triangle_count())
}

fn bumpy() -> IndexedMesh {
    let mut mesh = shapes::torus(64, 32, 1.0, 0.4);
    for [x, y, z] in &mut mesh.positions {
        *z += 0.05 * (*x * 7.0 + *y * 5.0).sin();
    }
    mesh
}

#[test]
fn a_program_in_c_sees_the_same_levels() {
    let Some(program) = compiled("tests/c/levels.c", "levels_c", &STATIC) else {
        eprintln!("skipped: there is no C compiler");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let mesh = bumpy();
    let lod = Lod::build(&mesh, &LodOptions::default()).expect("levels");
    let counts = [mesh.vertex_count() as u32, 3 * mesh.triangle_count() as u32];
    let positions = mesh.positions.as_flattened().iter().map(|x| x.to_bits());
    let words = counts.into_iter().chain(positions).chain(mesh.triangles.as_flattened().iter().copied());
    fs::write(path("arrays"), words.flat_map(u32::to_ne_bytes).collect::<Vec<_>>()).expect("a file");
    fs::write(path("file"), lod.to_striata(&WriteOptions::default()).expect("a file")).expect("a file");
    let batches = build_batches(&mesh, &BatchOptions::default()).expect("batches");
    let stream = encode_stream(&batches.built.refinable, &batches.batches, &StreamOptions::default());
    let stream = stream.expect("a stream").bytes;
    fs::write(path("stream"), &stream).expect("a file");

    let sources = checksum(lod.source_vertices().iter().copied());
    let collapses = checksum((0..lod.mesh().vertex_count() as u32).map(|v| lod.sequence().target(v)));
    let mut expected = facts_line(&lod);
    writeln!(expected, "sources {sources:08x} {collapses:08x}").expect("text");
    expected += &[targets(&lod), range_lines(&lod), view_lines(&lod)].concat();
    let index_count = 3 * mesh.triangle_count();
    writeln!(expected, "failure too small: to has room for 2 elements, but {index_count} are needed")
        .expect("text");
    expected += &targets(&lod);
    let mut decoder = StreamDecoder::new();
    decoder.push(&stream).expect("a stream");
    let indices = checksum(decoder.triangles().as_flattened().iter().copied());
    let positions = checksum(decoder.positions().as_flattened().iter().map(|x| x.to_bits()));
    let (vertices, triangles) = (decoder.positions().len(), decoder.triangle_count());
    writeln!(expected, "stream 1 {vertices} {triangles} {indices:08x} {positions:08x}").expect("text");
    expected += &targets(&Lod::from_refinable(decoder.refinable_mesh().expect("a mesh")));

    let found = output_of(&program, &[&path("arrays"), &path("file"), &path("stream")]);
    assert_eq!(found, expected);
}

#[test]
fn a_program_in_cpp_sees_the_same_levels() {
    let Some(program) = compiled("tests/c/levels.cpp", "levels_cpp", &SHARED) else {
        eprintln!("skipped: there is no C++ compiler");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    let lod = Lod::build(&bumpy(), &LodOptions::default()).expect("levels");
    let bytes = lod.to_striata(&WriteOptions::default()).expect("a file");
    fs::write(&file, &bytes).expect("a file");
    // Files have their own order of triangles, which ranges begin with.
    let lod = Lod::from_file(&StriataFile::parse(&bytes).expect("a file")).expect("levels");
    let triangle_count = lod.mesh().triangle_count();
    let levels = [triangle_count, triangle_count / 4, triangle_count / 100];
    let levels = levels.map(|count| level_line(&lod, Target::Triangles(count))).concat();
    let view = format!("view {}\n", lod.view().triangle_count());
    let failure =
        "failure -8: lod was read from a file or a stream, which do not know the vertices of the input\n";
    let expected = [facts_line(&lod), levels, range_lines(&lod), view, failure.to_owned()].concat();
    assert_eq!(output_of(&program, &[&file]), expected);
}

#[test]
fn the_example_prints_levels() {
    let Some(program) = compiled("../../examples/c/level.c", "level_example", &STATIC) else {
        eprintln!("skipped: there is no C compiler");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    let lod = Lod::build(&shapes::icosphere(3, 1.0), &LodOptions::default()).expect("levels");
    fs::write(&file, lod.to_striata(&WriteOptions::default()).expect("a file")).expect("a file");
    let text = output_of(&program, &[&file]);
    assert_eq!(text.lines().count(), lod.sequence().halving_split_counts().len() + 1, "{text}");
    assert!(text.starts_with("     1280 triangles over the first       642 vertices, error 0\n"), "{text}");
}

#[test]
fn the_program_of_the_guide_runs() {
    let folder = tempfile::tempdir().expect("a folder");
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/guide/c.md");
    let guide = fs::read_to_string(guide).expect("the guide is in the repository");
    let blocks = guide.split("```").skip(1).step_by(2).filter_map(|block| block.strip_prefix("c\n"));
    let source = folder.path().join("guide.c");
    fs::write(&source, blocks.collect::<Vec<_>>().concat()).expect("a file");
    let Some(program) = compiled(&source.to_string_lossy(), "guide_c", &STATIC) else {
        eprintln!("skipped: there is no C compiler");
        return;
    };
    let text = output_of(&program, &[]);
    assert!(text.starts_with("draw 63 triangles over the first "), "{text}");
}
