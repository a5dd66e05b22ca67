//! Any input that can be streamed, as a binary PLY file: the file itself, or a temporary one.

use std::fs::File;
use std::path::Path;

use striata::mesh::AttributeLayer;

use super::obj_triangles::ObjTriangles;
use super::piece_triangles::PieceTriangles;
use super::ply_writer::PlyWriter;
use super::scratch::ScratchFolder;
use super::shared_vertices::write_shared;
use crate::pieces::gltf::GltfPieces;
use crate::pieces::input::PieceInput;
use crate::pieces::obj::ObjPieces;
use crate::pieces::off::OffPieces;
use crate::pieces::ply::must_be_read_at_once;
use crate::pieces::repaired::Repaired;
use crate::pieces::stl::StlPieces;
use crate::pieces::{PieceOptions, PieceSource, PieceSummary, ply_text};
use crate::ply::face_data::{FaceData, left_out};
use crate::ply::header::{Encoding, Header};
use crate::ply::{PlyStream, push_row};
use crate::report::Warnings;
use crate::{Format, Place, ReadError, Warning};

/// Binary PLY file, and remarks on what it lacks of the input.
pub(super) struct BinaryPly {
    pub stream: PlyStream,
    pub warnings: Vec<Warning>,
    /// Layers of the triangles, without values.
    pub triangle_layers: Vec<AttributeLayer>,
}

impl BinaryPly {
    /// Opens a binary PLY file, or converts a text file, a compressed file, an STL, an OBJ, an OFF, a glTF or a
    /// terrain.
    pub(super) fn open(path: &Path, scratch: &ScratchFolder) -> Result<Self, ReadError> {
        let options = PieceOptions::default().with_scratch(scratch.folder.clone());
        #[cfg(feature = "terrain")]
        if crate::pieces::is_raster(path) {
            return Self::of_pieces(&*crate::pieces::open_pieces(path, &options)?, scratch);
        }
        let refused = |found: &str| ReadError::NotInBlocks {
            file: path.display().to_string(),
            found: found.to_owned(),
        };
        if path.metadata().is_ok_and(|metadata| !metadata.is_file()) {
            return Err(refused("what is not a regular file"));
        }
        let input = PieceInput::open(path, &options)?;
        match Format::detect(&input.bytes, &input.inner_name) {
            Some(Format::Ply) => Self::of_ply(input, &options),
            Some(Format::Stl) => Self::of_pieces(&Repaired::new(StlPieces::open(input, &options)?), scratch),
            Some(Format::Obj) => Self::of_obj(&ObjPieces::open(input, &options)?, scratch),
            Some(Format::Off) => Self::of_off(&OffPieces::open(input, &options)?, scratch),
            Some(format @ (Format::Gltf | Format::Glb)) => {
                Self::of_pieces(&Repaired::new(GltfPieces::open(input, format, &options)?), scratch)
            }
            Some(format) => Err(refused(&format!("the format {format}"))),
            None => Err(ReadError::unrecognized(&input.name, &input.bytes, &input.inner_name)),
        }
    }

    /// Reads a file piece by piece, without vertices that are no points.
    pub(super) fn repaired(path: &Path, scratch: &ScratchFolder) -> Result<Self, ReadError> {
        let options = PieceOptions::default().with_scratch(scratch.folder.clone());
        Self::of_pieces(&*crate::pieces::open_pieces(path, &options)?, scratch)
    }

    fn of_ply(input: PieceInput, options: &PieceOptions) -> Result<Self, ReadError> {
        let header = Header::read(&input.bytes).map_err(|fault| fault.in_file(&input.name))?;
        let mut warnings = Warnings::of_file(&input.name);
        let file = match header.encoding {
            Encoding::Ascii => {
                if let Some(element) = header.elements.iter().find(|element| must_be_read_at_once(element)) {
                    let found = format!("text with this kind of the element `{}`", element.name);
                    return Err(ReadError::NotInBlocks { file: input.name, found });
                }
                ply_text::converted(&input, &header, options, &mut warnings)?.finish_file(options)?
            }
            _ => input.file,
        };
        let mut stream = PlyStream::open(file, input.name)?;
        stream.header.has_top_origin = header.encoding == Encoding::Ascii;
        stream.choose_origin()?;
        left_out(&header).into_iter().for_each(|remark| warnings.push(Place::File, remark));
        let mut data = FaceData::new(&header, 0);
        if let Some(faces) = header.elements.iter().find(|element| element.name == "face") {
            data.begin(faces, 0);
        }
        let triangle_layers = data.into_layers(&header, 0).0;
        Ok(Self { stream, warnings: warnings.into_list(), triangle_layers })
    }

    fn of_obj(pieces: &ObjPieces, scratch: &ScratchFolder) -> Result<Self, ReadError> {
        if !pieces.has_positions_only() {
            return Self::converted(write_shared(&ObjTriangles(pieces), scratch)?, pieces.summary());
        }
        let mut ply = PlyWriter::new(pieces.summary(), scratch)?;
        for vertex in 0..pieces.position_count() as u32 {
            ply.vertex(|row| pieces.push_row([vertex, u32::MAX, u32::MAX], row))?;
        }
        pieces.for_each_triangle(|corners| ply.face(corners.map(|corner| corner[0])))?;
        Self::converted(ply.finish()?, pieces.summary())
    }

    fn of_off(pieces: &OffPieces, scratch: &ScratchFolder) -> Result<Self, ReadError> {
        let mut ply = PlyWriter::new(pieces.summary(), scratch)?;
        for vertex in 0..pieces.vertex_count() {
            let (positions, layers) = pieces.vertices([vertex]);
            ply.vertex(|row| push_row(&positions, &layers, 0, row))?;
        }
        pieces.triangles().try_for_each(|corners| ply.face(corners))?;
        Self::converted(ply.finish()?, pieces.summary())
    }

    /// Converts pieces; vertices with equal positions and attributes become one.
    pub(super) fn of_pieces(pieces: &dyn PieceSource, scratch: &ScratchFolder) -> Result<Self, ReadError> {
        let file = write_shared(&PieceTriangles(pieces), scratch)?;
        let mut ply = Self::converted(file, pieces.summary())?;
        let known = &pieces.summary().warnings;
        ply.warnings.extend(pieces.warnings().into_iter().filter(|warning| !known.contains(warning)));
        Ok(ply)
    }

    fn converted(file: File, summary: &PieceSummary) -> Result<Self, ReadError> {
        let mut warnings = Warnings::of_list(&summary.name, summary.warnings.clone());
        if summary.groups.len() > 1 || summary.groups.iter().any(|group| group.material.is_some()) {
            warnings.push(Place::File, "groups and materials are left out");
        }
        let mut stream = PlyStream::open(file, summary.name.clone())?;
        stream.header.has_top_origin = true;
        stream.header.georeference = match &summary.georeference {
            Some(georeference) => georeference.to_string(),
            None => summary.appearance.georeference.clone(),
        };
        (stream.origin, stream.is_relative) = (summary.origin, true);
        let triangle_layers = summary.triangle_layers.iter().map(|kind| kind.empty_layer()).collect();
        Ok(Self { stream, warnings: warnings.into_list(), triangle_layers })
    }
}
