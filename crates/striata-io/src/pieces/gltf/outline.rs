//! Outline of a scene: every shown primitive with its place, its group and its number of triangles. Data are
//! only read to count the triangles of strips, fans and compressed meshes.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use glam::{DMat4, DVec3};
use striata::mesh::Semantic;

use super::opened::OpenedDocument;
use crate::error::Fault;
use crate::gltf::parts::{
    DracoKey, DracoLink, GltfDocument, Instance, LayerFormats, Primitive, RestPose, Transform, TriangleCount,
    add_vertices, document_fault, origin_of_corners, placed_corners, visit_instances,
};
use crate::pieces::PieceGroup;

/// Number of primitives that a scene may show regardless of its size, counting repetitions.
const ALWAYS_ALLOWED: u64 = 1 << 20;

/// Bytes of the document and its buffers for each primitive more: about what one takes in memory.
const BYTES_PER_PRIMITIVE: u64 = 64;

/// Memory that the names of groups may take regardless of the size of the scene, in bytes.
const ALWAYS_ALLOWED_NAME_BYTES: u64 = 1 << 28;

/// Number of triangles that a scene may show regardless of its size, counting repetitions.
const ALWAYS_ALLOWED_TRIANGLES: u64 = 1 << 36;

/// Size of decompressed data after which a document is replaced by a fresh one, in bytes.
const MAX_UNPACKED_BYTES: u64 = 1 << 26;

/// Marks primitives that have normals, or need none.
const NO_BLOCK: u32 = u32::MAX;

/// Everything that a scene shows.
#[derive(Default)]
pub(super) struct SceneOutline {
    pub primitives: Vec<PrimitiveOutline>,
    pub placements: Vec<NodePlacement>,
    /// In tree order.
    pub shown: Vec<OutlinePrimitive>,
    pub formats: LayerFormats,
    pub groups: Vec<PieceGroup>,
    pub triangle_count: u64,
    /// Blocks whose normals are computed: all primitives that show the same vertices at the same place, as
    /// indices into `shown`.
    pub blocks: Vec<Vec<u32>>,
}

/// Primitive of a mesh that is shown at least once.
pub(super) struct PrimitiveOutline {
    pub mesh: u64,
    /// Index of the primitive in its mesh.
    pub index: usize,
    /// Number of the set of accessors that its vertices have.
    vertex_set: u32,
    pub vertex_count: usize,
    pub triangles: TriangleCount,
    material: Option<u32>,
    is_fan: bool,
    has_normals: bool,
}

/// Transform and pose in which a node shows a mesh.
pub(super) struct NodePlacement {
    matrix: DMat4,
    pub pose: RestPose,
}

/// One primitive as shown by one node.
#[derive(Clone, Copy)]
pub(super) struct OutlinePrimitive {
    pub primitive: u32,
    pub placement: u32,
    pub group: u32,
    block: u32,
}

impl NodePlacement {
    /// Transform from the mesh to the scene; [`None`] for the identity.
    pub(super) fn transform(&self) -> Option<Transform> {
        Transform::new(self.matrix)
    }

    fn is_at(&self, instance: &Instance<'_>) -> bool {
        bits(&self.matrix) == bits(&instance.matrix) && self.pose.key() == instance.pose.key()
    }
}

/// Returns the bits of a transform, to compare it with others; [`None`] for the identity.
fn bits(matrix: &DMat4) -> Option<[u64; 16]> {
    // Negative zeros make no identity different from another.
    (*matrix != DMat4::IDENTITY).then(|| matrix.to_cols_array().map(f64::to_bits))
}

impl OutlinePrimitive {
    /// Number of the block whose normals are computed, if it is one.
    pub(super) fn block(&self) -> Option<usize> {
        (self.block != NO_BLOCK).then_some(self.block as usize)
    }
}

impl SceneOutline {
    /// Makes all placements relative to an origin: the given one, or one near the scene if it is far from zero.
    /// Skins have transforms of their own, and keep an origin of zero.
    pub(super) fn move_to_origin(
        &mut self,
        document: &GltfDocument<'_>,
        given: Option<[f64; 3]>,
    ) -> Result<[f64; 3], Fault> {
        if self.placements.iter().any(|placement| placement.pose.has_skin()) {
            return Ok([0.0; 3]);
        }
        let origin = match given {
            Some(origin) => origin,
            None if self.placements.iter().all(|placement| placement.transform().is_none()) => [0.0; 3],
            None => origin_of_corners(self.corners(document)?),
        };
        if origin != [0.0; 3] {
            for placement in &mut self.placements {
                placement.matrix = DMat4::from_translation(-DVec3::from_array(origin)) * placement.matrix;
            }
        }
        Ok(origin)
    }

    fn corners(&self, document: &GltfDocument<'_>) -> Result<Vec<[f64; 3]>, Fault> {
        let mut corners = Vec::new();
        let mut known = BTreeSet::new();
        for shown in self.shown.iter().filter(|shown| known.insert((shown.primitive, shown.placement))) {
            let outline = &self.primitives[shown.primitive as usize];
            let mesh = document.item("meshes", outline.mesh, &document.root)?;
            if let Some(primitive) = Primitive::parse(document, mesh.entry("primitives", outline.index)?)? {
                let transform = self.placements[shown.placement as usize].transform();
                corners.extend(placed_corners(document, &primitive, transform.as_ref()));
            }
        }
        Ok(corners)
    }

    /// Walks through the default scene. Runs are what pieces of large primitives will be.
    pub(super) fn of(opened: &OpenedDocument, run_size: usize) -> Result<Self, Fault> {
        let mut walk = OutlineWalk {
            opened,
            document: opened.document()?,
            run_size,
            outline: Self::default(),
            primitives_of: BTreeMap::new(),
            vertex_sets: BTreeMap::new(),
            name_bytes: 0,
            unpacked_before: 0,
            counted: 0,
            fans_before: None,
        };
        let document = opened.document()?;
        visit_instances(&document, BYTES_PER_PRIMITIVE, &mut |instance| walk.add_instance(&instance))?;
        let mut outline = walk.outline;
        let counts = outline.shown.iter().map(|shown| outline.triangle_count_of(shown));
        outline.triangle_count = counts.fold(0, u64::saturating_add);
        if outline.triangle_count > ALWAYS_ALLOWED_TRIANGLES.max(document.input_bytes) {
            let (count, bytes) = (outline.triangle_count, document.input_bytes);
            return Err(document_fault(format!(
                "the scene shows {count} triangles, too many for {bytes} bytes"
            )));
        }
        if outline.formats.contains_key(&Semantic::Normal) {
            outline.find_blocks();
        }
        Ok(outline)
    }

    /// Returns the number of triangles of a shown primitive.
    pub(super) fn triangle_count_of(&self, shown: &OutlinePrimitive) -> u64 {
        self.primitives[shown.primitive as usize].triangles.triangle_count
    }

    /// Whether two shown primitives have the same vertices at the same place.
    pub(super) fn share_vertices(&self, a: OutlinePrimitive, b: OutlinePrimitive) -> bool {
        let vertex_set = |shown: OutlinePrimitive| self.primitives[shown.primitive as usize].vertex_set;
        a.placement == b.placement && vertex_set(a) == vertex_set(b)
    }

    /// Finds the blocks of primitives that lack normals, which others have.
    fn find_blocks(&mut self) {
        let mut known = BTreeMap::new();
        for (index, shown) in self.shown.iter_mut().enumerate() {
            let primitive = &self.primitives[shown.primitive as usize];
            if primitive.has_normals {
                continue;
            }
            let placement = &self.placements[shown.placement as usize];
            let key = (primitive.vertex_set, bits(&placement.matrix), placement.pose.key());
            shown.block = *known.entry(key).or_insert_with(|| {
                self.blocks.push(Vec::new());
                self.blocks.len() as u32 - 1
            });
            self.blocks[shown.block as usize].push(index as u32);
        }
    }
}

/// Accessors of the positions and of the other attributes, and the compressed mesh with the identifiers of
/// its attributes.
type VertexKey = (u64, Vec<(Semantic, u64)>, Option<DracoKey>);

struct OutlineWalk<'a> {
    opened: &'a OpenedDocument,
    document: GltfDocument<'a>,
    run_size: usize,
    outline: SceneOutline,
    /// Primitives of each mesh.
    primitives_of: BTreeMap<u64, Range<u32>>,
    vertex_sets: BTreeMap<VertexKey, u32>,
    name_bytes: u64,
    /// Size of what earlier documents have decompressed, in bytes.
    unpacked_before: u64,
    /// Number of indices of strips and fans that have been read.
    counted: u64,
    /// Primitive before the current one, if it is a fan.
    fans_before: Option<OutlinePrimitive>,
}

impl<'a> OutlineWalk<'a> {
    fn add_instance(&mut self, instance: &Instance<'a>) -> Result<(), Fault> {
        let primitives = self.primitives_of_mesh(instance.mesh)?;
        if primitives.is_empty() {
            return Ok(());
        }
        self.check_size(primitives.len() as u64, instance.name)?;
        let placements = &mut self.outline.placements;
        if placements.last().is_none_or(|last| !last.is_at(instance)) {
            placements.push(NodePlacement { matrix: instance.matrix, pose: instance.pose.clone() });
        }
        let placement = placements.len() as u32 - 1;
        for primitive in primitives {
            let shown = OutlinePrimitive { primitive, placement, group: 0, block: NO_BLOCK };
            self.add_shown(shown, instance.name);
        }
        Ok(())
    }

    /// Adds a primitive to the last group if both are fans of one object, and otherwise to a new group.
    fn add_shown(&mut self, mut shown: OutlinePrimitive, name: &str) {
        let outline = &mut self.outline;
        let PrimitiveOutline { material, is_fan, .. } = outline.primitives[shown.primitive as usize];
        let continues =
            self.fans_before.is_some_and(|before| is_fan && outline.share_vertices(before, shown));
        let is_group = |last: &PieceGroup| continues && last.name == name && last.material == material;
        if !outline.groups.last().is_some_and(is_group) {
            outline.groups.push(PieceGroup { name: name.to_owned(), material });
        }
        shown.group = outline.groups.len() as u32 - 1;
        self.fans_before = is_fan.then_some(shown);
        outline.shown.push(shown);
    }

    /// Refuses scenes that show far too much for their size.
    fn check_size(&mut self, added: u64, name: &str) -> Result<(), Fault> {
        let (count, input_bytes) = (self.outline.shown.len() as u64 + added, self.document.input_bytes);
        self.name_bytes = self.name_bytes.saturating_add(added.saturating_mul(name.len() as u64));
        if count > ALWAYS_ALLOWED.max(input_bytes / BYTES_PER_PRIMITIVE).min(u64::from(NO_BLOCK)) {
            let reason = format!("the scene shows {count} primitives, too many for {input_bytes} bytes");
            return Err(document_fault(reason));
        }
        if self.name_bytes > ALWAYS_ALLOWED_NAME_BYTES.max(input_bytes) {
            let reason = format!(
                "the names of all groups take {} bytes, too many for a scene of {input_bytes} bytes",
                self.name_bytes
            );
            return Err(document_fault(reason));
        }
        Ok(())
    }

    /// Returns the triangle primitives of a mesh, which are examined when it is shown for the first time.
    fn primitives_of_mesh(&mut self, mesh: u64) -> Result<Range<u32>, Fault> {
        if let Some(known) = self.primitives_of.get(&mesh) {
            return Ok(known.clone());
        }
        let first = self.outline.primitives.len() as u32;
        let at = self.document.item("meshes", mesh, &self.document.root)?;
        for (index, at) in at.entries("primitives")?.into_iter().enumerate() {
            if let Some(primitive) = Primitive::parse(&self.document, at)? {
                self.add_primitive(mesh, index, &primitive)?;
            }
        }
        let range = first..self.outline.primitives.len() as u32;
        self.primitives_of.insert(mesh, range.clone());
        Ok(range)
    }

    fn add_primitive(&mut self, mesh: u64, index: usize, primitive: &Primitive<'a>) -> Result<(), Fault> {
        if self.document.unpacked.bytes() - self.unpacked_before > MAX_UNPACKED_BYTES {
            self.document = self.opened.document_after(&self.document)?;
            self.unpacked_before = self.document.unpacked.bytes();
        }
        let document = &self.document;
        let shape_of = |semantic: Option<&Semantic>, index| primitive.shape(document, semantic, index);
        let vertex_count = add_vertices(primitive, &mut self.outline.formats, shape_of)?;
        if u32::try_from(vertex_count).is_err() {
            return Err(primitive.at.fault(format!("{vertex_count} vertices are more than can be handled")));
        }
        let triangles =
            TriangleCount::of(document, primitive, vertex_count, self.run_size, &mut self.counted)?;
        let draco = primitive.draco.as_ref().map(DracoLink::key);
        let key: VertexKey = (primitive.position, primitive.attributes.clone(), draco);
        let next = self.vertex_sets.len() as u32;
        let outline = PrimitiveOutline {
            mesh,
            index,
            vertex_set: *self.vertex_sets.entry(key).or_insert(next),
            vertex_count,
            triangles,
            material: primitive.material,
            is_fan: primitive.is_fan(),
            has_normals: primitive.attributes.iter().any(|(semantic, _)| *semantic == Semantic::Normal),
        };
        self.outline.primitives.push(outline);
        Ok(())
    }
}
