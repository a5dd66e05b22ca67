//! Kinds of sections.

use std::fmt;

/// Kind of a section, a four-character code.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SectionKind(pub [u8; 4]);

impl SectionKind {
    /// Counts and bounds; see [`Summary`](super::Summary).
    pub const SUMMARY: Self = Self(*b"SUMM");
    /// Key-value texts about the file.
    pub const METADATA: Self = Self(*b"META");
    /// Positions of all vertices.
    pub const POSITIONS: Self = Self(*b"POSN");
    /// Origin of the positions; only if it is not zero.
    pub const ORIGIN: Self = Self(*b"ORGN");
    /// One attribute layer; a file can have several.
    pub const LAYER: Self = Self(*b"LAYR");
    /// An attribute layer of triangles, in the order of
    /// [`sorted_triangle_order`](crate::mesh::sorted_triangle_order).
    pub const TRIANGLE_LAYER: Self = Self(*b"TLYR");
    /// Groups of triangles.
    pub const GROUPS: Self = Self(*b"GRUP");
    /// Materials, images and textures.
    pub const APPEARANCE: Self = Self(*b"APPR");
    /// Triangles of the full mesh; only in files from whose models they cannot be derived.
    pub const TRIANGLES: Self = Self(*b"TRIS");
    /// First vertex of each position; only if some position has several vertices.
    pub const FIRST_VERTICES: Self = Self(*b"SQFV");
    /// Collapse target of each vertex.
    pub const TARGETS: Self = Self(*b"SQTG");
    /// Error of each level.
    pub const ERRORS: Self = Self(*b"SQER");
    /// Number of triangles that each collapse removes.
    pub const REMOVED: Self = Self(*b"SQRM");
    /// Indices of the strips of the full mesh, shared by all models that use strips.
    pub const STRIP_INDICES: Self = Self(*b"LSIX");
    /// Number of indices of each strip.
    pub const STRIP_LENGTHS: Self = Self(*b"LSLN");
    /// First strip of each group.
    pub const STRIP_GROUPS: Self = Self(*b"LSGR");
    /// LodStrips: head of each record, which gives its length.
    pub const RECORD_HEADS: Self = Self(*b"LSRH");
    /// LodStrips: records of all vertices above the base.
    pub const RECORDS: Self = Self(*b"LSAR");
    /// LodStrips: the levels at which later stages begin, and their strips in each group.
    pub const STAGES: Self = Self(*b"LSST");
    /// LodStrips: strips of later stages as walks over the triangles of their levels.
    pub const STAGE_WALKS: Self = Self(*b"LSSW");
    /// MTS: for each strip, how long its slots survive and where it breaks.
    pub const LIFETIMES: Self = Self(*b"MTLT");
    /// MTS: head of each record, which gives its length.
    pub const CHANGE_HEADS: Self = Self(*b"MTRH");
    /// MTS: records of all steps, which list the strips that each step changes.
    pub const CHANGES: Self = Self(*b"MTCH");
    /// Fans: entries of all vertices.
    pub const FAN_ENTRIES: Self = Self(*b"FNEN");
    /// Fans: start of each block of vertices, or of each vertex.
    pub const FAN_BLOCKS: Self = Self(*b"FNBL");
    /// Fans: start of each vertex's entry within its block.
    pub const FAN_STARTS: Self = Self(*b"FNST");
    /// Fans: dependencies between steps that do not follow from the entries.
    pub const FAN_WAITS: Self = Self(*b"FNWT");
    /// Fans: steps whose target is not in a triangle around them.
    pub const FAN_FAR_TARGETS: Self = Self(*b"FNFT");
    /// Fans: steps that no entry lists as a child.
    pub const FAN_ORPHANS: Self = Self(*b"FNOR");
    /// Fans: bounds of each step, for view-dependent refinement.
    pub const FAN_BOUNDS: Self = Self(*b"FNBD");
    /// Patterns: counts, scales, and how records are packed.
    pub const PATTERN_HEADER: Self = Self(*b"PAHD");
    /// Patterns: rules.
    pub const PATTERN_RULES: Self = Self(*b"PARU");
    /// Patterns: ways in which ceilings are divided among later fragments.
    pub const PATTERN_SHARINGS: Self = Self(*b"PASH");
    /// Patterns: the pairs of a rule and a sharing that occur.
    pub const PATTERN_KINDS: Self = Self(*b"PAKD");
    /// Patterns: start and counts of each block of records.
    pub const PATTERN_BLOCKS: Self = Self(*b"PABL");
    /// Patterns: records of all steps.
    pub const PATTERN_RECORDS: Self = Self(*b"PARC");
    /// Patterns: triangles of the base mesh and the fragments that replace them.
    pub const PATTERN_BASE: Self = Self(*b"PABS");
    /// Patterns: bounds of each step, for view-dependent refinement.
    pub const PATTERN_BOUNDS: Self = Self(*b"PABD");
    /// Progressive stream.
    pub const STREAM: Self = Self(*b"STRM");
    /// Scene: the JSON of a glTF document.
    pub const SCENE: Self = Self(*b"SCND");
    /// Scene: data of animations, skins, points and lines.
    pub const SCENE_BUFFER: Self = Self(*b"SCBF");
    /// Scene: an image; one section for each image of the document.
    pub const SCENE_IMAGE: Self = Self(*b"SCIM");
    /// Scene: a complete file with the levels of a mesh; one section for each mesh of the document.
    pub const SCENE_MESH: Self = Self(*b"SCMS");
    /// Scene: for each mesh of the document, the mesh whose levels it has; only if meshes have equal levels.
    pub const SCENE_SHARING: Self = Self(*b"SCSH");

    /// Whether this version knows the kind.
    pub(super) fn is_known(self) -> bool {
        [
            Self::SUMMARY,
            Self::METADATA,
            Self::POSITIONS,
            Self::ORIGIN,
            Self::LAYER,
            Self::TRIANGLE_LAYER,
            Self::GROUPS,
            Self::APPEARANCE,
            Self::TRIANGLES,
            Self::FIRST_VERTICES,
            Self::TARGETS,
            Self::ERRORS,
            Self::REMOVED,
            Self::STRIP_INDICES,
            Self::STRIP_LENGTHS,
            Self::STRIP_GROUPS,
            Self::RECORD_HEADS,
            Self::RECORDS,
            Self::STAGES,
            Self::STAGE_WALKS,
            Self::LIFETIMES,
            Self::CHANGE_HEADS,
            Self::CHANGES,
            Self::FAN_ENTRIES,
            Self::FAN_BLOCKS,
            Self::FAN_STARTS,
            Self::FAN_WAITS,
            Self::FAN_FAR_TARGETS,
            Self::FAN_ORPHANS,
            Self::FAN_BOUNDS,
            Self::PATTERN_HEADER,
            Self::PATTERN_RULES,
            Self::PATTERN_SHARINGS,
            Self::PATTERN_KINDS,
            Self::PATTERN_BLOCKS,
            Self::PATTERN_RECORDS,
            Self::PATTERN_BASE,
            Self::PATTERN_BOUNDS,
            Self::STREAM,
            Self::SCENE,
            Self::SCENE_BUFFER,
            Self::SCENE_IMAGE,
            Self::SCENE_MESH,
            Self::SCENE_SHARING,
        ]
        .contains(&self)
    }
}

impl fmt::Display for SectionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.escape_ascii())
    }
}

impl fmt::Debug for SectionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}
