//! Text files, which are converted to temporary files.

use std::collections::BTreeMap;

use striata::mesh::shapes;
use striata_io::read;

use super::{Folder, Triangles, of_mesh, of_source};

#[test]
fn solids_of_text_are_groups() {
    let mesh = shapes::torus(15, 10, 2.0, 0.5);
    let mut text = String::new();
    for (solid, triangles) in mesh.triangles.chunks(110).enumerate() {
        text += &format!("solid part {solid}\n");
        for triangle in triangles {
            text += "facet normal 0 0 0\nouter loop\n";
            for &v in triangle {
                let [x, y, z] = mesh.positions[v as usize];
                text += &format!("vertex {x} {y} {z}\n");
            }
            text += "endloop\nendfacet\n";
        }
        text += "endsolid\n";
    }
    let folder = Folder::new();
    folder.check("text.stl", text.as_bytes());
    folder.error("cut.stl", &text.as_bytes()[..text.len() / 2]);
}

#[test]
fn damaged_text_is_refused_with_the_line() {
    let folder = Folder::new();
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
                property double z\n\
                element face 1\nproperty list uchar int vertex_indices\nend_header\n\
                0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let found = folder.open(&folder.file("good.ply", text.as_bytes())).unwrap();
    assert_eq!(of_source(&*found).len(), 1);
    for (from, to, expected) in [
        ("3 0 1 2", "3 0 1 3", "line 13: vertex 3 does not exist"),
        ("3 0 1 2", "3 0 1", "line 14"),
        ("vertex 3", "vertex 3000000", "3000000 rows of `vertex` are declared"),
    ] {
        let message = folder.error("bad.ply", text.replace(from, to).as_bytes());
        assert!(message.contains(expected), "{message}");
    }
    for (text, expected) in [
        ("v 0 0 0\nf 1 1 2\n", "line 2: vertex 2 does not exist"),
        ("v 0 0 0\nf 1 1 -2\n", "line 2: vertex -2 does not exist"),
    ] {
        let message = folder.error("bad.obj", text.as_bytes());
        assert!(message.contains(expected), "{message}");
    }
}

/// More statements than a batch has: quads with colors from the middle on, negative indices and materials.
#[test]
fn large_texts_are_read_in_batches() {
    let (columns, mut text) = (200, String::new());
    for row in 0..200 {
        text += &format!("usemtl stripe {}\n", row % 3);
        for column in 0..columns {
            text += &format!("v {column} {row} 0{}\n", if row > 170 { " 0.5 0.25 1" } else { "" });
            text += &format!("vt {} {}\n", column as f32 / 256.0, row as f32 / 256.0);
            if row > 0 && column > 0 {
                let corner = |back: i32| format!(" -{back}/-{back}");
                let below = columns + 1;
                text += &["f", &corner(below + 1), &corner(below), &corner(1), &corner(2), "\n"].concat();
            }
        }
    }
    let folder = Folder::new();
    let path = folder.file("large.obj", text.as_bytes());
    let (whole, source) = (read(&path).unwrap(), folder.open(&path).unwrap());
    assert_eq!(source.summary().groups.len(), 3);
    let unnamed = |all: Triangles| -> BTreeMap<Vec<Vec<u32>>, usize> {
        all.into_iter().map(|((corners, _), count)| (corners, count)).collect()
    };
    assert!(unnamed(of_source(&*source)) == unnamed(of_mesh(&whole)));
    let counts = |materials: Vec<Option<u32>>| {
        (0..3).map(move |m| materials.iter().filter(|&&x| x == Some(m)).count())
    };
    let mut of_pieces = Vec::new();
    for index in 0..source.piece_count() {
        let piece = source.read_piece(index).unwrap();
        of_pieces.extend(piece.groups.iter().map(|&g| source.summary().groups[g as usize].material));
    }
    let whole = whole.groups.iter().flat_map(|g| g.range().map(|_| g.material)).collect();
    assert!(counts(of_pieces).eq(counts(whole)));
}

/// Colors are bytes, fractions or zeros and ones, which only the last vertex decides.
#[test]
fn off_files_with_all_attributes() {
    let mesh = shapes::torus(15, 10, 2.0, 0.5);
    let folder = Folder::new();
    for (name, last) in
        [("bytes", "255 7 1"), ("fractions", "0.5 1 0"), ("white", "1 1 1"), ("large", "300 1 1")]
    {
        let mut text =
            format!("# made by hand\nSTCNOFF\n{} {} 0\n", mesh.vertex_count(), mesh.triangle_count());
        for (index, [x, y, z]) in mesh.positions.iter().enumerate() {
            let color = if index + 1 == mesh.vertex_count() { last } else { "0 1 1" };
            text += &format!("{x} {y} {z} 0 0 1 {color} 0.25 {index} # vertex {index}\n");
        }
        for [a, b, c] in &mesh.triangles {
            text += &format!("3 {a} {b} {c} 0.5 0.5 0.5\n");
        }
        folder.check(&format!("{name}.off"), text.as_bytes());
        for (from, to, expected) in [
            ("3 1 ", "3 1000000 ", "vertex 1000000 of 150 does not exist"),
            ("150 300 0", "150 3000000 0", "3000000 rows are declared"),
        ] {
            let message = folder.error("bad.off", text.replacen(from, to, 1).as_bytes());
            assert!(message.contains(expected), "{message}");
        }
    }
}
