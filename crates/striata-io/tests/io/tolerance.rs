//! The rule of all readers, as one table: what is kept, what is left out with a warning, what is an error.

use serde_json::{Value, json};
use striata::mesh::IndexedMesh;
use striata_io::{Source, read_bytes_with_report};

/// Expected result of a file: numbers of triangles and vertices, and warnings without its name; or a
/// part of the error.
enum Outcome {
    Read(usize, usize, &'static [&'static str]),
    Refused(&'static str),
}
use Outcome::{Read, Refused};

/// A cube in one of the text formats, with 8 vertices and 12 triangles.
const CORNERS: [[u8; 3]; 8] =
    [[0, 0, 0], [0, 0, 1], [0, 1, 0], [0, 1, 1], [1, 0, 0], [1, 0, 1], [1, 1, 0], [1, 1, 1]];
const TRIANGLES: [[usize; 3]; 12] = [
    [0, 1, 3],
    [0, 3, 2],
    [4, 6, 7],
    [4, 7, 5],
    [0, 4, 5],
    [0, 5, 1],
    [2, 3, 7],
    [2, 7, 6],
    [0, 2, 6],
    [0, 6, 4],
    [1, 5, 7],
    [1, 7, 3],
];

fn rows(prefix: &str) -> String {
    CORNERS.iter().map(|[x, y, z]| format!("{prefix}{x} {y} {z}\n")).collect()
}

/// Faces of an OBJ file; `corner` is what follows the number of a vertex, in which `#` is that number.
fn faces(corner: &str) -> String {
    let corner = |v: usize| format!(" {}{}", v + 1, corner.replace('#', &(v + 1).to_string()));
    TRIANGLES.iter().map(|t| format!("f{}\n", t.map(corner).concat())).collect()
}

fn obj() -> String {
    rows("v ") + &faces("")
}

fn off() -> String {
    let faces: String = TRIANGLES.iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n")).collect();
    format!("OFF\n8 12 0\n{}{faces}", rows(""))
}

fn stl() -> String {
    let facet = |t: &[usize; 3]| {
        let corners = t.map(|v| CORNERS[v]).map(|[x, y, z]| format!("   vertex {x} {y} {z}\n")).concat();
        format!(" facet normal 0 0 1\n  outer loop\n{corners}  endloop\n endfacet\n")
    };
    format!("solid part\n{}endsolid part\n", TRIANGLES.iter().map(facet).collect::<String>())
}

fn binary_stl(head: &[u8], count: u32, tail: &[u8]) -> Vec<u8> {
    let mut bytes = head.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(count.to_le_bytes());
    for triangle in TRIANGLES {
        bytes.extend([0; 12]);
        let corners = triangle.map(|v| CORNERS[v].map(f32::from));
        bytes.extend(corners.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes.extend_from_slice(tail);
    bytes
}

fn ply() -> String {
    let faces: String = TRIANGLES.iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n")).collect();
    let properties = "property float x\nproperty float y\nproperty float z\n";
    format!(
        "ply\nformat ascii 1.0\nelement vertex 8\n{properties}element face 12\n\
         property list uchar int vertex_indices\nend_header\n{}{faces}",
        rows("")
    )
}

fn binary_ply(lost: &[usize], more: usize) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n\
         property float z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n",
        8 + more
    )
    .into_bytes();
    for (vertex, corner) in CORNERS.iter().enumerate() {
        let corner = if lost.contains(&vertex) { [f32::NAN; 3] } else { corner.map(f32::from) };
        bytes.extend(corner.iter().flat_map(|x| x.to_le_bytes()));
    }
    (0..3 * more).for_each(|_| bytes.extend(f32::INFINITY.to_le_bytes()));
    for triangle in TRIANGLES {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|&v| (v as u32).to_le_bytes()));
    }
    bytes
}

type Case = (&'static str, Vec<u8>, Outcome);

fn case(name: &'static str, bytes: impl Into<Vec<u8>>, outcome: Outcome) -> Case {
    (name, bytes.into(), outcome)
}

const LOST_4: &[&str] =
    &["4 triangles left out, the first is triangle 0: its vertex 1 has the coordinate NaN"];

fn obj_cases() -> Vec<Case> {
    let strange = |word: &str| obj().replacen("v 0 0 1", &format!("v {word} 0 {word}"), 1);
    vec![
        case(
            "dollar.obj",
            "$ by an old exporter\n".to_owned() + &obj(),
            Read(12, 8, &["1 line skipped, line 1: unknown statement \"$\""]),
        ),
        case(
            "slashes.obj",
            "// by a script\n".to_owned() + &obj(),
            Read(12, 8, &["1 line skipped, line 1: unknown statement \"//\""]),
        ),
        case(
            "tags.obj",
            obj() + "t crease 2/1/0 1 5 4.7\nvw 0 0 1.0\nvw\n",
            Read(12, 8, &["3 lines skipped, the first is line 21: unknown statement \"t\""]),
        ),
        case("control.obj", obj() + "\x1a", Read(12, 8, &[])),
        case("capitals.obj", obj().to_uppercase(), Read(12, 8, &[])),
        case("zeros.obj", obj() + "\0\0\0", Read(12, 8, &[])),
        case("mark.obj", "\u{feff}".to_owned() + &obj(), Read(12, 8, &[])),
        case("returns.obj", obj().replace('\n', "\r"), Read(12, 8, &[])),
        case("both.obj", obj().replace('\n', "\r\n"), Read(12, 8, &[])),
        case("double.obj", obj().replace('\n', "\r\r\n"), Read(12, 8, &[])),
        case("mixed.obj", rows("v ").replace('\n', "\r") + &faces(""), Read(12, 8, &[])),
        case(
            "no-normals.obj",
            rows("v ") + &faces("//#"),
            Read(
                12,
                8,
                &[
                    "36 normals of corners left out, the first is line 9: normal 1 does not exist: there are 0",
                ],
            ),
        ),
        case(
            "no-texcoords.obj",
            rows("v ") + &faces("/#"),
            Read(
                12,
                8,
                &[
                    "36 texture coordinates of corners left out, the first is line 9: texture coordinate 1 does not \
             exist: there are 0",
                ],
            ),
        ),
        case(
            "zero-normals.obj",
            rows("v ") + &faces("//0"),
            Read(
                12,
                8,
                &[
                    "36 normals of corners left out, the first is line 9: normal 0 does not exist: there are 0 so far",
                ],
            ),
        ),
        case("nan.obj", strange("nan"), Read(8, 7, LOST_4)),
        case("ind.obj", strange("-nan(ind)"), Read(8, 7, LOST_4)),
        case("qnan.obj", strange("1.#QNAN"), Read(8, 7, LOST_4)),
        case("fortran.obj", strange("0.0D+00"), Read(12, 8, &[])),
        case("unused.obj", obj() + "v nan nan nan\nv inf 0 0\n", Read(12, 8, &[])),
    ]
}

fn many_faults_in_obj() -> Vec<Case> {
    vec![
        case(
            "few-normals.obj",
            rows("v ") + "vn 0 0 1\n" + &faces("//1").replacen("//1", "//7", 2),
            Read(
                12,
                10,
                &[
                    "2 normals of corners left out, the first is line 10: normal 7 does not exist: there are 1",
                ],
            ),
        ),
        case(
            "strange-normals.obj",
            rows("v ") + &rows("vn ").replacen("0 0 1", "1.#INF 0 1", 1) + &faces("//#"),
            Read(
                12,
                8,
                &["1 normal computed anew, vertex 1: the layer normal has a value that is not finite"],
            ),
        ),
        case(
            "words.obj",
            obj().replacen("v 0 0 1", "v 0 here 1", 1) + "f 1 x 3\n",
            Read(
                8,
                7,
                &[
                    "1 value that is no number, line 2: expected a number, found `here`",
                    "1 polygon left out, line 21: expected a whole number, found `x`",
                    "4 triangles left out, the first is triangle 0: its vertex 1 has the coordinate NaN",
                ],
            ),
        ),
        case(
            "short-rows.obj",
            rows("v ")
                + &rows("vn ").replacen("vn 0 0 1", "vn 0 0", 1).replacen("vn 1 1 1", "vn a b c", 1)
                + &rows("vt ").replacen("vt 0 1 0", "vt", 1).replacen("vt 0 0 1", "vt x y", 1)
                + &faces("/#/#").replacen("f 1/1/1", "f 1/x/1", 1),
            Read(
                12,
                9,
                &[
                    "4 values that are no numbers, the first is line 10: expected a number, found the end of the line",
                    "1 texture coordinate of a corner left out, line 25: expected a whole number, found `x`",
                    "2 normals computed anew, the first is vertex 1: the layer normal has a value that is not finite",
                    "2 texture coordinates set to 0, the first is vertex 1: the layer texcoord_0 has a value that is not finite",
                ],
            ),
        ),
        case(
            "everything.obj",
            "\u{feff}$\r".to_owned()
                + &(rows("v ").replace("0 0 1", "0 -1.#IND 1")
                    + &rows("vt ")
                    + &faces("/#").replace("/8\n", "/99\n")
                    + "v 1 2 3 4 5 6 7 8 9\nf 1 2\n")
                    .replace('\n', "\r")
                + "\x1a",
            Read(
                8,
                8,
                &[
                    "1 line skipped, line 1: unknown statement \"$\"",
                    "1 vertex with surplus numbers, line 30: a vertex has at most 8",
                    "1 polygon left out, line 31: a face with 2 corners",
                    "3 texture coordinates of corners left out, the first is line 20: texture coordinate 99 does not exist: there are 8",
                    "4 triangles left out, the first is triangle 0: its vertex 1 has the coordinate NaN",
                ],
            ),
        ),
    ]
}

fn refused_obj_cases() -> Vec<Case> {
    vec![
        case("no-position.obj", obj().replace("f 1", "f 9"), Refused("line 9: vertex 9 does not exist")),
        case("points.obj", rows("v "), Refused("the file has 8 points and no triangles")),
        case(
            "edges.obj",
            rows("v ") + "l 1 2\nf 3 4\n",
            Refused(
                "8 points, 1 line or curve (1 polygon left out, line 10: a face with 2 corners) and no triangles",
            ),
        ),
        case("other.obj", "%PDF-1.4\nhello\n", Refused("line 1: no line of the file is an OBJ statement")),
        case("nothing.obj", "", Refused("the file is empty")),
        case("remarks.obj", "# nothing\n", Read(0, 0, &[])),
    ]
}

fn stl_cases() -> Vec<Case> {
    let half = stl().len() / 2;
    let ended = &["line 86: the file ends before `endsolid`"];
    vec![
        case("capitals.stl", stl().to_uppercase(), Read(12, 8, &[])),
        case("later.stl", stl()[..half].to_owned() + &stl()[half..].to_uppercase(), Read(12, 8, &[])),
        case("title.stl", stl().replace("facet", "Facet").replace("solid", "Solid"), Read(12, 8, &[])),
        case("end-loop.stl", stl().replace("endloop", "end loop"), Read(12, 8, &[])),
        case("end-facet.stl", stl().replace("endfacet", "End Facet"), Read(12, 8, &[])),
        case("end-solid.stl", stl().replace("endsolid", "end solid"), Read(12, 8, &[])),
        case(
            "hash.stl",
            "# by a tool\n".to_owned() + &stl().replace(" facet", "# next\n facet"),
            Read(12, 8, &[]),
        ),
        case("mark.stl", "\u{feff}".to_owned() + &stl(), Read(12, 8, &[])),
        case("returns.stl", stl().replace('\n', "\r"), Read(12, 8, &[])),
        case("control.stl", stl() + "\x1a", Read(12, 8, &[])),
        case(
            "words.stl",
            "by a tool\n".to_owned() + &stl().replace(" facet", " color 1 0 0\n facet"),
            Read(12, 8, &["13 lines skipped, the first is line 1: unknown statement `by`"]),
        ),
        case("no-solid.stl", stl().replacen("solid part\n", "", 1), Read(12, 8, &[])),
        case("no-end.stl", stl().replace("endsolid part\n", ""), Read(12, 8, ended)),
        case(
            "no-edge.stl",
            stl().replacen("   vertex 0 0 1\n", "", 1),
            Read(11, 8, &["1 polygon left out, line 2: a facet with 2 vertices"]),
        ),
        case(
            "nan.stl",
            stl().replace("vertex 0 0 1", "vertex nan 0 -1.#IND"),
            Read(
                8,
                7,
                &["4 triangles left out, the first is triangle 0: its vertex 1 has the coordinate NaN"],
            ),
        ),
        case("one-line.stl", stl().replace('\n', " "), Read(12, 8, &[])),
        case(
            "word.stl",
            stl().replacen("vertex 0 0 1", "vertex 0 here 1", 1).replacen("vertex 1 1 1", "vertex 1 1", 1),
            Read(
                10,
                8,
                &[
                    "2 values that are no numbers, the first is line 5: expected a number, found `here`",
                    "2 triangles left out, the first is triangle 0: its vertex 1 has the coordinate NaN",
                ],
            ),
        ),
        case("cut.stl", stl()[..half + 10].to_owned(), Refused("the file ends within a facet")),
        case("solid.stl", binary_stl(b"solid box", 12, b""), Read(12, 8, &[])),
        case(
            "solid-more.stl",
            binary_stl(b"solid facet", 12, b"more"),
            Read(12, 8, &["byte 684: 4 bytes follow the last triangle; they are left out"]),
        ),
        case(
            "hash-more.stl",
            binary_stl(b"# v 0 0 0", 12, b"\0"),
            Read(12, 8, &["byte 684: 1 bytes follow the last triangle; they are left out"]),
        ),
        case(
            "zero.stl",
            binary_stl(b"x", 0, b""),
            Read(12, 8, &["byte 80: the header declares no triangles, but 12 follow, which are read"]),
        ),
        case("many.stl", binary_stl(b"solid", 13, b""), Refused("byte 80: the header declares 13 triangles")),
        case("nothing.stl", "", Refused("the file is empty")),
        case("empty.stl", "solid\nendsolid\n", Read(0, 0, &[])),
    ]
}

fn off_cases() -> Vec<Case> {
    let with = |head: &str| off().replacen("OFF\n8 12 0\n", head, 1);
    let colors = off().replace("OFF\n", "COFF\n").replacen("1 1 1\n", "1 1 1 255 0 0 255\n", 1);
    let colored = |keyword: &str, more: &str| {
        let rows: String = CORNERS.iter().map(|[x, y, z]| format!("{x} {y} {z} {more} # remark\n")).collect();
        off().replace(&rows_of(), &rows).replace("OFF", keyword)
    };
    fn rows_of() -> String {
        rows("")
    }
    vec![
        case("attached.off", with("OFF8 12 0\n"), Read(12, 8, &[])),
        case("lower.off", with("off\n8 12 0\n"), Read(12, 8, &[])),
        case("lower-attached.off", with("off8 12 0\n"), Read(12, 8, &[])),
        case("one-line.off", with("OFF 8 12 0\n"), Read(12, 8, &[])),
        case("no-edges.off", with("OFF\n8 12\n"), Read(12, 8, &[])),
        case("lines.off", with("OFF\n8\n12\n18\n"), Read(12, 8, &[])),
        case("no-word.off", with("8 12 0\n"), Read(12, 8, &[])),
        case("mark.off", "\u{feff}".to_owned() + &off(), Read(12, 8, &[])),
        case("returns.off", off().replace('\n', "\r"), Read(12, 8, &[])),
        case("control.off", off() + "\x1a", Read(12, 8, &[])),
        case("remarks.off", off().replace('\n', " # remark\n\n# another\n"), Read(12, 8, &[])),
        case("colors.off", colored("COFF", "255 0 7 255"), Read(12, 8, &[])),
        case("normals.off", colored("NOFF", "0 0 1"), Read(12, 8, &[])),
        case("texcoords.off", colored("stoff", "0.5 1"), Read(12, 8, &[])),
        case("all.off", colored("STCNOFF", "0 0 1 0.5 0.5 0.5 1 0.25 0.75"), Read(12, 8, &[])),
        case("order.off", colored("CNSTOFF", "0 0 1 0.5 0.5 0.5 0.25 0.75"), Read(12, 8, &[])),
        case(
            "surplus.off",
            colored("OFF", "255 0 0"),
            Read(12, 8, &["8 vertices with surplus numbers, the first is line 3: `255` follows a vertex"]),
        ),
        case(
            "few.off",
            colors.replacen("0 0 0\n", "0 0 0 0 0 0 255\n", 1),
            Read(12, 8, &["6 vertices without some attributes, the first is line 4: 3 numbers instead of 7"]),
        ),
        case(
            "edge.off",
            off().replacen("3 0 1 3", "2 0 1", 1),
            Read(11, 8, &["1 polygon left out, line 11: a polygon with 2 corners"]),
        ),
        case("nan.off", off().replacen("0 0 1\n", "0 nan 1\n", 1), Read(8, 7, LOST_4)),
        case(
            "word.off",
            off().replacen("0 0 1\n", "0 here 1\n", 1),
            Read(
                8,
                7,
                &[
                    "1 value that is no number, line 4: expected a number, found `here`",
                    "4 triangles left out, the first is triangle 0: its vertex 1 has the coordinate NaN",
                ],
            ),
        ),
        case(
            "index.off",
            off().replacen("3 0 1 3", "3 0 1 8", 1),
            Refused("line 11: polygon 0: vertex 8 of 8"),
        ),
        case("four.off", with("4OFF\n8 12 0\n"), Refused("cannot be read")),
        case(
            "points.off",
            format!("OFF\n8 0 0\n{}", rows("")),
            Refused("the file has 8 points and no triangles"),
        ),
        case("nothing.off", "", Refused("the file is empty")),
        case("empty.off", "OFF\n0 0 0\n", Read(0, 0, &[])),
    ]
}

fn ply_cases() -> Vec<Case> {
    vec![
        case("plain.ply", ply(), Read(12, 8, &[])),
        case("nan.ply", ply().replacen("0 0 1\n", "0 -nan(ind) 1\n", 1), Read(8, 7, LOST_4)),
        case("unused.ply", binary_ply(&[], 1), Read(12, 8, &[])),
        case("used.ply", binary_ply(&[1], 3), Read(8, 7, LOST_4)),
        case(
            "lost.ply",
            binary_ply(&[0, 1, 2, 3, 4, 5, 6, 7], 0),
            Refused("none of the triangles can be used"),
        ),
        case(
            "points.ply",
            ply().split("3 0 1").next().unwrap().replace("face 12", "face 0"),
            Refused("the file has 8 points and no triangles; striata simplifies triangle meshes"),
        ),
        case("nothing.ply", "", Refused("the file is empty")),
        case(
            "empty.ply",
            "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n\
            property float z\nend_header\n",
            Read(0, 0, &[]),
        ),
    ]
}

/// An ASCII PLY file with a color of bytes, whose first values are replaced.
fn colored_ply(first: &str) -> String {
    let text = ply().replacen("property float z\n", "property float z\nproperty uchar red\n", 1);
    let (head, body) = text.split_once("end_header\n").unwrap();
    let rows: String = body.lines().take(8).map(|row| format!("{row} 7\n")).collect();
    let faces: String = body.lines().skip(8).map(|row| format!("{row}\n")).collect();
    format!("{head}end_header\n{}{faces}", rows.replacen(" 7\n", &format!(" {first}\n"), 1))
}

fn strange_ply_cases() -> Vec<Case> {
    let in_capitals = |text: &str| {
        let (head, body) = text.split_once("end_header\n").unwrap();
        let names = ["x", "y", "z"].map(|name| (format!(" {}\n", name.to_uppercase()), format!(" {name}\n")));
        let head = names.iter().fold(head.to_uppercase(), |head, (from, to)| head.replace(from, to));
        format!("{}END_HEADER\n{body}", head.replace("VERTEX_INDICES", "vertex_indices"))
    };
    let mut with_tail = binary_ply(&[], 0);
    with_tail.extend(b"abc");
    vec![
        case("mark.ply", "\u{feff}".to_owned() + &ply(), Read(12, 8, &[])),
        case("returns.ply", ply().replace('\n', "\r"), Read(12, 8, &[])),
        case("both.ply", ply().replace('\n', "\r\n"), Read(12, 8, &[])),
        case("capitals.ply", in_capitals(&ply()), Read(12, 8, &[])),
        case("control.ply", ply() + "\n\x1a", Read(12, 8, &[])),
        case("fortran.ply", ply().replacen("0 0 1\n", "0.0D+00 0 1.0d0\n", 1), Read(12, 8, &[])),
        case(
            "word.ply",
            ply().replacen("0 0 1\n", "0 abc 1\n", 1),
            Read(
                8,
                7,
                &[
                    "1 value that is no number, line 11: expected a number, found `abc`",
                    "4 triangles left out, the first is triangle 0: its vertex 1 has the coordinate NaN",
                ],
            ),
        ),
        case(
            "fraction.ply",
            colored_ply("0.75"),
            Read(12, 8, &["1 value that is no whole number, line 11: expected a whole number, found `0.75`"]),
        ),
        case(
            "large.ply",
            colored_ply("300"),
            Read(12, 8, &["1 value out of range, line 11: 300 does not fit into a uchar; it becomes 255"]),
        ),
        case(
            "tail.ply",
            ply() + "3 0 1 2\n",
            Read(
                12,
                8,
                &["byte 298: 7 bytes follow the last element that the header declares; they are left out"],
            ),
        ),
        case(
            "binary-tail.ply",
            with_tail,
            Read(
                12,
                8,
                &["byte 422: 3 bytes follow the last element that the header declares; they are left out"],
            ),
        ),
        case("cut.ply", ply().trim_end_matches("1 7 3\n"), Refused("line 29")),
    ]
}

/// A cube as glTF, with normals; `change` may change the document, and the floats of the buffer.
fn gltf(change: impl Fn(&mut Value, &mut [f32])) -> (Value, Vec<u8>) {
    let mut floats: Vec<f32> = CORNERS.as_flattened().iter().map(|&x| f32::from(x)).collect();
    floats.extend([0.6, 0.0, 0.8].repeat(8));
    let view =
        |offset: usize, length: usize| json!({ "buffer": 0, "byteOffset": offset, "byteLength": length });
    let mut document = json!({
        "asset": { "version": "2.0" },
        "buffers": [{ "byteLength": 264 }],
        "bufferViews": [view(0, 96), view(96, 96), view(192, 72)],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3" },
            { "bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC3" },
            { "bufferView": 2, "componentType": 5123, "count": 36, "type": "SCALAR" },
        ],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "NORMAL": 1 }, "indices": 2 }] }],
        "nodes": [{ "mesh": 0 }],
        "scenes": [{ "nodes": [0] }],
    });
    change(&mut document, &mut floats);
    let mut buffer: Vec<u8> = floats.iter().flat_map(|x| x.to_le_bytes()).collect();
    buffer.extend(TRIANGLES.as_flattened().iter().flat_map(|&v| (v as u16).to_le_bytes()));
    (document, buffer)
}

/// A binary file whose JSON has `more` blanks at its end.
fn glb((document, buffer): (Value, Vec<u8>), more: usize) -> Vec<u8> {
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4) + more, b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((28 + json.len() as u32 + buffer.len() as u32).to_le_bytes());
    for (kind, data) in [(b"JSON", json), (b"BIN\0", buffer)] {
        bytes.extend((data.len() as u32).to_le_bytes());
        bytes.extend_from_slice(kind);
        bytes.extend(data);
    }
    bytes
}

/// A text file whose buffer is base64, broken into lines.
fn embedded((mut document, buffer): (Value, Vec<u8>), line_end: &str) -> Vec<u8> {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let bits = |index: usize| buffer[index / 8] >> (7 - index % 8) & 1;
    let digit = |at: usize| (0..6).fold(0, |all, bit| all << 1 | bits(6 * at + bit));
    let digits: Vec<u8> = (0..buffer.len() * 8 / 6).map(|at| DIGITS[digit(at) as usize]).collect();
    let lines: Vec<&str> = digits.chunks(76).map(|line| std::str::from_utf8(line).unwrap()).collect();
    document["buffers"][0]["uri"] =
        json!("data:application/octet-stream;base64,".to_owned() + &lines.join(line_end));
    document.to_string().into_bytes()
}

fn gltf_cases() -> Vec<Case> {
    let plain = || gltf(|_, _| {});
    let mode =
        |mode: u64| glb(gltf(|document, _| document["meshes"][0]["primitives"][0]["mode"] = json!(mode)), 0);
    let primitive = "/meshes/0/primitives/0";
    let nulls = gltf(move |document, _| {
        let primitive = document.pointer_mut(primitive).unwrap();
        (primitive["material"], primitive["extensions"], primitive["targets"]) = Default::default();
        (document["nodes"][0]["matrix"], document["nodes"][0]["skin"]) = Default::default();
        (document["materials"], document["scene"], document["bufferViews"][0]["byteStride"]) =
            Default::default();
    });
    let strange = |at: usize| glb(gltf(|_, floats| floats[at] = f32::NAN), 0);
    vec![
        case("plain.glb", glb(plain(), 0), Read(12, 8, &[])),
        case(
            "unaligned.glb",
            glb(plain(), 1),
            Read(12, 8, &["byte 12: chunks are not aligned: one has 541 bytes, which is no multiple of 4"]),
        ),
        case("nulls.glb", glb(nulls.clone(), 0), Read(12, 8, &[])),
        case("nulls.gltf", embedded(nulls, ""), Read(12, 8, &[])),
        case("lines.gltf", embedded(plain(), "\r\n"), Read(12, 8, &[])),
        case("escaped.gltf", embedded(plain(), "%0A"), Read(12, 8, &[])),
        case("nan.glb", strange(3), Read(8, 7, LOST_4)),
        case(
            "normal.glb",
            strange(24 + 5),
            Read(
                12,
                8,
                &["1 normal computed anew, vertex 1: the layer normal has a value that is not finite"],
            ),
        ),
        case("points.glb", mode(0), Refused("the file has 8 points and no triangles")),
        case("edges.glb", mode(1), Refused("the file has 1 set of lines and no triangles")),
        case(
            "more.glb",
            glb(
                gltf(|document, _| {
                    let more = json!({ "attributes": { "POSITION": 0 }, "mode": 0 });
                    document["meshes"][0]["primitives"].as_array_mut().unwrap().push(more);
                }),
                0,
            ),
            Read(
                12,
                8,
                &[
                    "1 primitive left out, meshes[0].primitives[1]: it draws points; a mesh has only triangles",
                ],
            ),
        ),
        case("nothing.glb", "", Refused("the file is empty")),
        case("empty.gltf", r#"{ "asset": { "version": "2.0" } }"#, Read(0, 0, &[])),
    ]
}

fn cases() -> Vec<Case> {
    [
        obj_cases(),
        many_faults_in_obj(),
        refused_obj_cases(),
        stl_cases(),
        off_cases(),
        ply_cases(),
        strange_ply_cases(),
        gltf_cases(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Warnings without the name of the file.
fn texts<'a>(warnings: impl IntoIterator<Item = &'a striata_io::Warning>, file: &str) -> Vec<String> {
    let prefix = format!("{file}: ");
    warnings.into_iter().map(|warning| warning.to_string().replace(&prefix, "")).collect()
}

fn check_numbers(name: &str, mesh: &IndexedMesh, expected: [usize; 2]) {
    assert_eq!([mesh.triangle_count(), mesh.vertex_count()], expected, "{name}");
    mesh.check().unwrap_or_else(|error| panic!("{name}: {error}"));
}

#[test]
fn files_in_memory_follow_the_rule() {
    for (name, bytes, outcome) in cases() {
        let found = read_bytes_with_report(&bytes, &Source::new(name));
        match (found, outcome) {
            (Ok(report), Read(triangles, vertices, warnings)) => {
                assert_eq!(texts(&report.warnings, name), warnings, "{name}");
                check_numbers(name, &report.mesh, [triangles, vertices]);
            }
            (Err(error), Refused(part)) => {
                let message = error.to_string();
                assert!(message.starts_with(name) && message.contains(part), "{message}");
            }
            (Ok(report), Refused(_)) => panic!("{name} was read with {:?}", report.warnings),
            (Err(error), Read(..)) => panic!("{error}"),
        }
    }
}

#[cfg(feature = "pieces")]
#[test]
fn files_in_pieces_follow_the_rule() {
    use striata_io::pieces::{PieceOptions, open_pieces};
    let folder = tempfile::tempdir().unwrap();
    // Pieces cannot compute normals that some faces lack: they leave out all of them.
    for (name, bytes, outcome) in cases().into_iter().filter(|case| case.0 != "few-normals.obj") {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        let file = path.display().to_string();
        let found = open_pieces(&path, &PieceOptions::default()).and_then(|source| {
            let mut counts = (0, 0);
            for index in 0..source.piece_count() {
                let piece = source.read_piece(index)?;
                assert_eq!(source.read_piece(index)?, piece, "{name}");
                assert!(piece.positions.iter().flatten().all(|x| x.is_finite()), "{name}");
                counts = (counts.0 + piece.triangles.len(), counts.1 + piece.positions.len());
            }
            Ok((counts, texts(&source.warnings(), &file)))
        });
        match (found, outcome) {
            (Ok((counts, found)), Read(triangles, vertices, warnings)) => {
                assert_eq!(counts, (triangles, vertices), "{name}");
                assert_eq!(found.len(), warnings.len(), "{name}: {found:?}");
                for (found, expected) in found.iter().zip(warnings) {
                    // Pieces know the piece instead of the triangle.
                    let head = expected.split(':').next().unwrap();
                    let head = head
                        .split(", vertex")
                        .next()
                        .unwrap()
                        .split(", the first is triangle")
                        .next()
                        .unwrap()
                        .split(", the first is vertex")
                        .next()
                        .unwrap();
                    assert!(found.starts_with(head), "{name}: {found}");
                }
            }
            (Err(error), Refused(part)) => {
                let message = error.to_string();
                assert!(message.contains(name) && message.contains(part), "{message}");
            }
            (Ok(found), Refused(_)) => panic!("{name} was read: {found:?}"),
            (Err(error), Read(..)) => panic!("{error}"),
        }
    }
}

/// Scenes read the same files: they carry points and lines, and repair the triangles of each mesh.
#[test]
fn scenes_follow_the_rule() {
    for (name, bytes, outcome) in cases() {
        let found = striata_io::read_scene_bytes(&bytes, &Source::new(name));
        match (found, outcome) {
            (Ok(scene), Read(triangles, _, warnings)) => {
                assert_eq!(scene.triangle_count(), triangles, "{name}");
                let carried = usize::from(name == "more.glb");
                assert_eq!(scene.warnings().len() + carried, warnings.len(), "{name}");
            }
            (Err(error), Refused(part)) => {
                let message = error.to_string();
                assert!(message.starts_with(name) && message.contains(part), "{message}");
            }
            (Ok(scene), Refused(_)) => panic!("{name} was read with {:?}", scene.warnings()),
            (Err(error), Read(..)) => panic!("{error}"),
        }
    }
}

#[test]
fn the_first_fault_is_named_if_nothing_is_left() {
    let text = obj().replace("v 0", "v 0,5").replace("v 1", "v 1,5");
    let error = read_bytes_with_report(text.as_bytes(), &Source::new("comma.obj")).expect_err("no positions");
    let message = error.to_string();
    assert!(message.contains("(line 1: expected a number, found `0,5`)"), "{message}");
}
