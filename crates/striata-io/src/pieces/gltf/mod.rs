//! glTF in pieces: the buffers are mapped into memory, and the vertices that a piece mentions are gathered
//! from them.
//!
//! Opening a file parses its JSON and walks through the scene (`outline`). A piece takes a range of the
//! triangles of a large primitive, or several small primitives (`cuts`); reading one needs nothing but its
//! own elements (`assembly`). Three things are read in full, and kept for the pieces that follow: compressed
//! buffer views, compressed meshes, and primitives without normals in a scene that has some.

mod assembly;
mod block_normals;
mod cuts;
mod opened;
mod outline;

use striata::mesh::IndexedMesh;

use self::assembly::Assembly;
use self::block_normals::block_normals;
use self::cuts::{CutPart, Cuts};
use self::opened::OpenedDocument;
use self::outline::SceneOutline;
use super::input::PieceInput;
use super::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::color_space::set_linear;
use crate::error::{Fault, Place};
use crate::gltf::parts::{GltfDocument, SharedCache, appearance, check_triangles, left_out};
use crate::report::Warnings;
use crate::{Format, ReadError};

/// Largest size of a piece: the numbers of its vertices have 32 bits.
const MAX_PIECE_SIZE: usize = 1 << 28;

/// glTF or GLB file.
pub(crate) struct GltfPieces {
    opened: OpenedDocument,
    outline: SceneOutline,
    cuts: Cuts,
    summary: PieceSummary,
    piece_size: usize,
    /// Normals of the blocks that lack them.
    normals: SharedCache<Vec<[f32; 3]>>,
}

impl GltfPieces {
    /// Opens a file and the files of its buffers.
    pub(crate) fn open(input: PieceInput, format: Format, options: &PieceOptions) -> Result<Self, ReadError> {
        let piece_size = options.piece_size().min(MAX_PIECE_SIZE);
        let mut warnings = Warnings::of_file(&input.name);
        let opened = OpenedDocument::open(input, format, &mut warnings)?;
        let outline = SceneOutline::of(&opened, piece_size);
        let read = outline.and_then(|mut outline| {
            let document = opened.document()?;
            check_streams(&document)?;
            let origin = outline.move_to_origin(&document, options.origin)?;
            let appearance = appearance(&document, &mut warnings)?;
            check_triangles(&document, outline.triangle_count == 0)?;
            left_out(&document, &mut warnings)?;
            Ok((outline, appearance, origin))
        });
        let (mut outline, mut appearance, origin) = read.map_err(|fault| fault.in_file(opened.name()))?;
        let mut groups = std::mem::take(&mut outline.groups);
        let counts = outline.shown.iter().map(|shown| outline.triangle_count_of(shown));
        if groups.is_empty() {
            groups.push(PieceGroup::default());
        }
        let layers = outline.formats.iter().map(|(semantic, format)| format.layer(semantic, 0));
        set_linear(&mut appearance, outline.formats.keys().cloned());
        let summary = PieceSummary {
            origin,
            triangle_layers: Vec::new(),
            name: opened.name().to_owned(),
            layers: layers.map(|layer| LayerKind::of(&layer)).collect(),
            groups,
            appearance,
            triangle_count: outline.triangle_count,
            byte_count: opened.byte_count(),
            companions: opened.companions(),
            georeference: None,
            warnings: warnings.into_list(),
        };
        let cuts = Cuts::new(counts, piece_size);
        Ok(Self { opened, outline, cuts, summary, piece_size, normals: SharedCache::default() })
    }

    fn piece(&self, index: u64) -> Result<Piece, Fault> {
        if index >= self.cuts.piece_count() {
            return Err(Fault::Malformed(Place::File, format!("piece {index} does not exist")));
        }
        let document = self.opened.document_of_piece()?;
        self.normals.begin_read();
        let parts =
            self.cuts.parts(index, |shown| self.outline.triangle_count_of(&self.outline.shown[shown]));
        let mut assembly = Assembly::new(&self.outline, &document);
        let shown = |part: &CutPart| self.outline.shown[part.shown];
        for parts in parts.chunk_by(|a, b| self.outline.share_vertices(shown(a), shown(b))) {
            let batch = assembly.add(parts)?;
            if let Some(block) = batch.block() {
                let compute = || block_normals(&self.outline, block, &document, self.piece_size);
                let normals = self.normals.get(block as u64, compute, |normals| 12 * normals.len() as u64)?;
                assembly.set_normals(&batch, &normals);
            }
        }
        let Assembly { mesh: IndexedMesh { positions, layers, triangles, .. }, mut groups, .. } = assembly;
        if self.summary.groups.len() < 2 {
            groups.clear();
        }
        Ok(Piece { positions, layers, triangles, groups, ..Piece::default() })
    }
}

/// Refuses a file whose triangles are only a coarse level.
fn check_streams(document: &GltfDocument<'_>) -> Result<(), Fault> {
    let meshes = document.root.entries("meshes")?;
    if meshes.iter().any(|mesh| mesh.value.pointer("/extensions/STRIATA_lod").is_some()) {
        let what = "in pieces, a file with streams of finer levels (`striata decode` makes one without)";
        return Err(Fault::Unsupported(Place::File, what.to_owned()));
    }
    Ok(())
}

impl PieceSource for GltfPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.cuts.piece_count()
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        self.piece(index).map_err(|fault| fault.in_file(self.opened.name()))
    }
}
