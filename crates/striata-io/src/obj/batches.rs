//! Statements of an OBJ file in batches, for files whose tables do not fit into memory.

use striata::mesh::{Appearance, AttributeLayer, IndexedMesh, Semantic, TriangleGroup};

use super::corners::{Corner, CornerTables, NONE};
use super::{ObjReader, libraries};
use crate::Source;
use crate::error::Fault;
use crate::report::Warnings;
use crate::text::{Cursor, trimmed};

/// Number of statements after which the tables are handed on.
const STATEMENTS: usize = 1 << 16;

/// Values and triangles of some statements.
pub(crate) struct StatementBatch {
    pub positions: Vec<[f32; 3]>,
    /// Three values for each position, if there have been colors so far.
    pub colors: Option<Vec<f32>>,
    pub texcoords: Vec<[f32; 2]>,
    pub normals: Vec<[f32; 3]>,
    /// Indices of position, texture coordinate and normal; the last two may be `u32::MAX`. Three per
    /// triangle.
    pub corners: Vec<Corner>,
}

/// Kinds of values in the batches so far.
#[derive(Default)]
struct Seen {
    colors: bool,
    texcoords: bool,
}

/// Counts, groups and appearance of a file, which are known at its end.
pub(crate) struct ObjOutline {
    /// Numbers of positions, texture coordinates and normals.
    pub counts: [usize; 3],
    /// First line with a texture coordinate or normal that does not exist, and a description; corners may
    /// mention those.
    pub missing: [Option<(u64, String)>; 3],
    /// Runs of triangles; none if nothing distinguishes them.
    pub groups: Vec<TriangleGroup>,
    pub appearance: Appearance,
    /// Whether single precision does not keep all digits of the positions.
    pub has_long_coordinates: bool,
}

/// Passes the content of a file to `visit`, batch by batch.
pub(crate) fn read_batches(
    bytes: &[u8],
    source: &Source<'_>,
    warnings: &mut Warnings,
    mut visit: impl FnMut(StatementBatch),
) -> Result<ObjOutline, Fault> {
    let mut cursor = Cursor::new(trimmed(bytes)).with_continuation();
    let (mut reader, mut seen, mut count) = (ObjReader::of_file(source.name), Seen::default(), 0);
    while !cursor.at_end() {
        reader.statement(&mut cursor)?;
        count += 1;
        if count % STATEMENTS == 0 {
            visit(reader.take(&mut seen));
            if u32::try_from(reader.taken_triangles).is_err() {
                return Err(cursor.fault("the file has more triangles than can be counted"));
            }
        }
        cursor.next_line();
    }
    reader.check_end()?;
    visit(reader.take(&mut seen));
    warnings.append(std::mem::take(&mut reader.warnings));
    let outline = reader.outline(bytes.len() as u64, seen.texcoords, source, warnings);
    Ok(ObjOutline { has_long_coordinates: cursor.has_long_coordinates(), ..outline })
}

impl ObjReader {
    /// Takes the content of the tables.
    fn take(&mut self, seen: &mut Seen) -> StatementBatch {
        self.taken = self.counts();
        let CornerTables { positions, mut colors, texcoords, normals, .. } = std::mem::take(&mut self.tables);
        let corners = std::mem::take(&mut self.corners);
        self.taken_triangles += corners.len() / 3;
        seen.texcoords |= corners.iter().any(|corner| corner[1] != NONE);
        seen.colors |= !colors.is_empty();
        colors.resize(if seen.colors { positions.len() * 3 } else { 0 }, 1.0);
        StatementBatch { positions, colors: seen.colors.then_some(colors), texcoords, normals, corners }
    }

    fn outline(
        self,
        input_bytes: u64,
        has_texcoords: bool,
        source: &Source<'_>,
        warnings: &mut Warnings,
    ) -> ObjOutline {
        let (counts, missing) = (self.counts(), [0, 1, 2].map(|kind| self.missing(kind)));
        let Self { taken_triangles, libraries, mut groups, materials, georeference, .. } = self;
        let mut end = taken_triangles as u32;
        for group in groups.iter_mut().rev() {
            group.count = end - group.first;
            end = group.first;
        }
        if matches!(&groups[..], [only] if only.name.is_empty() && only.material.is_none()) {
            groups.clear();
        }
        // A stand-in for the mesh: materials have textures only if it has coordinates.
        let mut mesh = IndexedMesh::default();
        if has_texcoords {
            mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, Vec::new()));
        }
        mesh.appearance.materials = materials;
        mesh.appearance.georeference = georeference;
        mesh.appearance.material_libraries = libraries.iter().map(|library| library.names.clone()).collect();
        libraries::attach(&mut mesh, &libraries, input_bytes, source, warnings);
        ObjOutline { groups, appearance: mesh.appearance, counts, missing, has_long_coordinates: false }
    }
}
