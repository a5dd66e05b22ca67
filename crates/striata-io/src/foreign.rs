//! Files of other programs that are recognized, but not read: the error names a converter.
//!
//! A kind is recognized by its first bytes if it has some, otherwise by the extension.

use crate::ReadError;
use crate::format::EXAMINED_BYTES;

/// Kind of file that another program has to convert.
struct Foreign {
    /// Kind of the file with its article, for the message: `an FBX file`.
    what: &'static str,
    /// First bytes of such files; empty if only the extension identifies them.
    magics: &'static [&'static [u8]],
    extensions: &'static [&'static str],
    hint: &'static str,
}

const TESSELLATE: &str = "it contains curved surfaces: export STL, OBJ or glTF from a CAD program such as FreeCAD, or run \
                          `gmsh FILE -2 -o FILE.stl`";
const NO_TRIANGLES: &str = "a point cloud has no triangles: reconstruct a surface first, for example in MeshLab or CloudCompare, \
                            and save it as PLY";
const ASSIMP: &str = "convert it to glTF, for example with `assimp export FILE FILE.glb`, or in Blender";
const USD: &str = "convert it to glTF: import it in Blender and choose File > Export > glTF 2.0, or run \
                   `usd2gltf -i FILE -o FILE.glb`";
const ITS_PROGRAM: &str = "export glTF, OBJ or STL from the program that wrote it";
const IN_BLENDER: &str = "open or import it in Blender and choose File > Export > glTF 2.0";
/// How to get triangles out of the grids of VTK.
pub(crate) const EXTRACT_SURFACE: &str = "extract the surface, for example in ParaView (Filters > Extract Surface) or with \
                                          PyVista (`mesh.extract_surface()`), and save it as .vtp";

/// All kinds; those with the more specific first bytes come first.
const KINDS: &[Foreign] = &[
    Foreign {
        what: "an FBX file",
        magics: &[b"Kaydara FBX Binary", b"; FBX "],
        extensions: &["fbx"],
        hint: "convert it to glTF: import it in Blender and choose File > Export > glTF 2.0, or run \
               `FBX2glTF --binary --input FILE`",
    },
    Foreign { what: "a Blender file", magics: &[b"BLENDER"], extensions: &["blend"], hint: IN_BLENDER },
    Foreign {
        what: "an IFC building model",
        magics: &[],
        extensions: &["ifc", "ifczip", "ifcxml"],
        hint: "convert it to glTF with IfcOpenShell: `IfcConvert FILE.ifc FILE.glb`",
    },
    Foreign {
        what: "a STEP file",
        magics: &[b"ISO-10303-21;"],
        extensions: &["step", "stp", "stpz", "p21"],
        hint: TESSELLATE,
    },
    Foreign { what: "an IGES file", magics: &[], extensions: &["iges", "igs"], hint: TESSELLATE },
    Foreign {
        what: "an OpenCASCADE file",
        magics: &[b"DBRep_DrawableShape", b"CASCADE Topology"],
        extensions: &["brep"],
        hint: TESSELLATE,
    },
    Foreign {
        what: "a Parasolid or ACIS file",
        magics: &[],
        extensions: &["x_t", "x_b", "xmt_txt", "sat", "sab"],
        hint: TESSELLATE,
    },
    Foreign {
        what: "a file of a CAD program",
        magics: &[],
        extensions: &[
            "sldprt",
            "sldasm",
            "catpart",
            "catproduct",
            "prt",
            "ipt",
            "iam",
            "f3d",
            "3dm",
            "dwg",
            "dxf",
            "fcstd",
            "jt",
        ],
        hint: "it contains curved surfaces or drawings: export STL, OBJ or glTF from the program that wrote it, or from FreeCAD",
    },
    Foreign {
        what: "a USD scene",
        magics: &[b"#usda ", b"PXR-USDC"],
        extensions: &["usd", "usda", "usdc", "usdz"],
        hint: USD,
    },
    Foreign { what: "an Alembic file", magics: &[b"Ogawa"], extensions: &["abc"], hint: IN_BLENDER },
    Foreign { what: "a COLLADA file", magics: &[], extensions: &["dae"], hint: ASSIMP },
    Foreign { what: "a 3D Studio file", magics: &[], extensions: &["3ds"], hint: ASSIMP },
    Foreign {
        what: "a VRML or X3D file",
        magics: &[b"#VRML", b"#X3D"],
        extensions: &["wrl", "vrml", "x3d", "x3dv"],
        hint: ASSIMP,
    },
    Foreign { what: "a LightWave file", magics: &[], extensions: &["lwo", "lws"], hint: ASSIMP },
    Foreign { what: "a DirectX file", magics: &[b"xof 0"], extensions: &["x"], hint: ASSIMP },
    Foreign {
        what: "an AMF file",
        magics: &[],
        extensions: &["amf"],
        hint: "save it as 3MF or STL in a slicer such as PrusaSlicer",
    },
    Foreign {
        what: "an OpenCTM file",
        magics: &[b"OCTM"],
        extensions: &["ctm"],
        hint: "save it as PLY in MeshLab",
    },
    Foreign {
        what: "a SketchUp file",
        magics: &[b"\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h\0U\0p\0"],
        extensions: &["skp"],
        hint: ITS_PROGRAM,
    },
    Foreign { what: "a 3ds Max file", magics: &[], extensions: &["max"], hint: ITS_PROGRAM },
    Foreign { what: "a Cinema 4D file", magics: &[b"QC4DC4D6"], extensions: &["c4d"], hint: ITS_PROGRAM },
    Foreign { what: "a Maya file", magics: &[b"//Maya ASCII"], extensions: &["ma", "mb"], hint: ITS_PROGRAM },
    Foreign { what: "a Houdini file", magics: &[], extensions: &["hip", "bgeo"], hint: ITS_PROGRAM },
    Foreign { what: "a ZBrush file", magics: &[], extensions: &["ztl", "zpr"], hint: ITS_PROGRAM },
    Foreign {
        what: "a raster or an image",
        magics: &[b"II*\0", b"MM\0*", b"II+\0", b"MM\0+", b"\x89PNG\r\n\x1a\n"],
        extensions: &["tif", "tiff", "hgt", "png"],
        hint: "the command reads heights from files named .tif, .tiff, .hgt or .png that are not packed",
    },
    Foreign {
        what: "a tile of 3D Tiles",
        magics: &[b"b3dm", b"i3dm", b"cmpt"],
        extensions: &["b3dm", "i3dm", "cmpt"],
        hint: "take the glTF out of it: `npx 3d-tiles-tools b3dmToGlb -i FILE -o FILE.glb`",
    },
    Foreign {
        what: "a point cloud (LAS or LAZ)",
        magics: &[b"LASF"],
        extensions: &["las", "laz"],
        hint: NO_TRIANGLES,
    },
    Foreign { what: "a point cloud (E57)", magics: &[b"ASTM-E57"], extensions: &["e57"], hint: NO_TRIANGLES },
    Foreign { what: "a point cloud (PCD)", magics: &[b"# .PCD "], extensions: &["pcd"], hint: NO_TRIANGLES },
    Foreign {
        what: "a point cloud (3D Tiles)",
        magics: &[b"pnts"],
        extensions: &["pnts"],
        hint: NO_TRIANGLES,
    },
    Foreign {
        what: "a point cloud (text)",
        magics: &[],
        extensions: &["xyz", "pts", "asc"],
        hint: NO_TRIANGLES,
    },
    Foreign {
        what: "a Gmsh mesh",
        magics: &[b"$MeshFormat"],
        extensions: &["msh"],
        hint: "convert it with meshio: `meshio convert FILE.msh FILE.vtu`",
    },
    Foreign {
        what: "a mesh of a finite element program",
        magics: &[],
        extensions: &["inp", "nas", "bdf", "med", "unv", "cgns", "exo", "e", "xdmf", "mesh"],
        hint: "convert it with meshio: `meshio convert FILE FILE.vtu`",
    },
    Foreign {
        what: "a VTK file of an image, a grid or several files",
        magics: &[],
        extensions: &["vti", "vts", "vtr", "vtm", "vthb", "pvd", "pvtp", "pvtu", "pvti", "vtkhdf"],
        hint: EXTRACT_SURFACE,
    },
    Foreign {
        what: "an HDF5 file",
        magics: &[b"\x89HDF\r\n\x1a\n"],
        extensions: &["h5", "hdf5"],
        hint: EXTRACT_SURFACE,
    },
    Foreign {
        what: "an archive",
        magics: &[b"PK\x03\x04", b"7z\xbc\xaf\x27\x1c", b"Rar!"],
        extensions: &["zip", "7z", "rar", "tar"],
        hint: "unpack it, and name the mesh file in it",
    },
];

impl Foreign {
    /// Detects the kind by the first bytes of a file.
    fn from_content(bytes: &[u8]) -> Option<&'static Self> {
        let kind_of = |extension: &str| KINDS.iter().find(|kind| kind.extensions.contains(&extension));
        let head = &bytes[..bytes.len().min(EXAMINED_BYTES)];
        let contains = |word: &[u8]| head.windows(word.len()).any(|window| window == word);
        if head.starts_with(b"PK\x03\x04") && [&b".usdc"[..], b".usda", b".usd"].into_iter().any(contains) {
            return kind_of("usdz");
        }
        // STEP is the syntax of IFC, and COLLADA and X3D are XML.
        if head.starts_with(b"ISO-10303-21;") && contains(b"'IFC") {
            return kind_of("ifc");
        }
        let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
        if text.starts_with(b"<") {
            let roots = [(&b"<VTKFile"[..], "vti"), (b"<COLLADA", "dae"), (b"<X3D", "x3d"), (b"<amf", "amf")];
            return roots.into_iter().find(|(root, _)| contains(root)).and_then(|(_, name)| kind_of(name));
        }
        // The main chunk of a 3D Studio file is the whole file.
        if let Some(&[b'M', b'M', a, b, c, d]) = head.first_chunk()
            && u64::from(u32::from_le_bytes([a, b, c, d])) == bytes.len() as u64
        {
            return kind_of("3ds");
        }
        KINDS.iter().find(|kind| kind.magics.iter().any(|magic| text.starts_with(magic)))
    }

    fn from_extension(name: &str) -> Option<&'static Self> {
        let extension = std::path::Path::new(name).extension()?.to_str()?.to_ascii_lowercase();
        KINDS.iter().find(|kind| kind.extensions.contains(&extension.as_str()))
    }
}

/// Whether the first bytes are those of a file that another program has to convert.
pub(crate) fn is_foreign(bytes: &[u8]) -> bool {
    Foreign::from_content(bytes).is_some()
}

/// Returns the error for a file whose format is not read.
pub(crate) fn error_of(file: &str, bytes: &[u8], inner_name: &str) -> Option<ReadError> {
    let Foreign { what, hint, .. } =
        Foreign::from_content(bytes).or_else(|| Foreign::from_extension(inner_name))?;
    let found = format!("this is {what}, which striata does not read");
    Some(ReadError::NeedsConversion { file: file.to_owned(), found, hint: (*hint).to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_content_wins_over_the_name() {
        let cases: [(&[u8], &str, &str); 18] = [
            (b"Kaydara FBX Binary  \0\x1a\0", "x", "an FBX file"),
            (b"; FBX 7.3.0 project file\n", "x.obj", "an FBX file"),
            (b"BLENDER-v300", "x.stl", "a Blender file"),
            (b"ISO-10303-21;\nHEADER;FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));", "x", "a STEP file"),
            (b"ISO-10303-21;\nHEADER;FILE_SCHEMA(('IFC4'));", "x.stp", "an IFC building model"),
            (b"hello", "x.IGS", "an IGES file"),
            (b"#usda 1.0\n(\n)", "x", "a USD scene"),
            (b"PXR-USDC\0\0", "x", "a USD scene"),
            (
                b"PK\x03\x04\x14\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x09\0\0\0scene.usdc",
                "x.zip",
                "a USD scene",
            ),
            (b"PK\x03\x04\x14\0", "x", "an archive"),
            (b"<?xml version=\"1.0\"?>\n<COLLADA xmlns=", "x.xml", "a COLLADA file"),
            (b"MM\x0a\0\0\0abcd", "x", "a 3D Studio file"),
            (b"LASF\0\0", "x.ply", "a point cloud (LAS or LAZ)"),
            (b"# .PCD v0.7\nVERSION 0.7", "x", "a point cloud (PCD)"),
            (b"1 2 3\n", "scan.xyz", "a point cloud (text)"),
            (b"", "part.SLDPRT", "a file of a CAD program"),
            (b"MM\0*\0\0\0\x08", "x.txt", "a raster or an image"),
            (b"\0\0\0\0", "n47e008.hgt", "a raster or an image"),
        ];
        for (bytes, name, expected) in cases {
            match error_of(name, bytes, name) {
                Some(ReadError::NeedsConversion { found, .. }) => {
                    assert_eq!(found, format!("this is {expected}, which striata does not read"), "{name}");
                }
                other => panic!("{name}: {other:?}"),
            }
        }
        assert!(
            error_of("x.txt", b"MM\0+\0\0\0\x08", "x.txt")
                .is_some_and(|error| !error.to_string().contains("3D"))
        );
        for kind in KINDS {
            assert!(
                !kind
                    .extensions
                    .iter()
                    .any(|name| crate::Format::from_extension(format!("x.{name}")).is_some())
            );
        }
    }
}
