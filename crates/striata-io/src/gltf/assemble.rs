//! Assembles one mesh from everything that the scene shows.
//!
//! Vertices come in **blocks**: the vertices of one set of accessors under one transform. Primitives that
//! share their accessors, such as those of our own writer, share the block, so that a file does not grow
//! when it is read and written again. A block whose triangles use few of many vertices, as if all parts of a
//! building share one buffer, only has those. Everything is counted before anything is decoded.

use std::collections::BTreeMap;

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, TriangleGroup};

use super::accessor::Accessor;
use super::appearance;
use super::document::GltfDocument;
use super::draco::{DracoKey, DracoLink};
use super::far_origin::{origin_of_corners, placed_corners};
use super::gpu_instancing::BYTES_PER_INSTANCE;
use super::layers::{LayerFormats, add_vertices, append, fill};
use super::node_tree::visit_instances;
use super::primitive::{Primitive, document_fault};
use super::rest_pose::{PoseKey, RestPose};
use super::transform::Transform;
use crate::color_space::set_linear;
use crate::error::Fault;
use crate::normals;
use crate::report::Warnings;

/// Memory that a mesh may take regardless of the file size, in bytes: small files with many instances are
/// legal.
const ALWAYS_ALLOWED_BYTES: u64 = 1 << 30;

/// Additional memory allowed per byte of the file.
const BYTES_PER_INPUT_BYTE: u64 = 64;

/// Largest number of primitives that the nodes may show, counting repetitions.
const MAX_PRIMITIVES: usize = 1 << 20;

/// Vertices of one set of accessors under one transform.
struct VertexBlock<'a> {
    /// Primitive that names the accessors.
    primitive: Primitive<'a>,
    transform: Option<Transform>,
    pose: RestPose,
    first_vertex: usize,
    vertex_count: usize,
    /// Number of elements of the accessors.
    element_count: usize,
    /// Number of corners that the triangles of all primitives have at most.
    corner_count: u64,
    /// Increasing numbers of the elements that are vertices; [`None`] if all are.
    elements: Option<Vec<u32>>,
}

/// One primitive as shown by one node.
struct PlacedPrimitive<'a> {
    /// [`None`] for the block's own primitive.
    primitive: Option<Primitive<'a>>,
    block: usize,
    name: &'a str,
}

/// Everything the scene shows, before it is decoded.
#[derive(Default)]
struct AssemblyPlan<'a> {
    blocks: Vec<VertexBlock<'a>>,
    pieces: Vec<PlacedPrimitive<'a>>,
    formats: LayerFormats,
    /// Number of vertices, at most.
    vertex_count: usize,
    triangle_limit: u64,
    block_of: BTreeMap<BlockKey, usize>,
    /// Memory that other meshes of the document and the names of groups take, in bytes.
    other_bytes: u64,
}

/// Identity of a block: the accessor of the positions, the other accessors, the compressed mesh with the
/// identifiers of its attributes, the transform and the pose.
type BlockKey = (u64, Vec<(Semantic, u64)>, Option<DracoKey>, Option<[u64; 16]>, PoseKey);

/// Builds the mesh of a document's scene.
pub(super) fn mesh_of(document: &GltfDocument<'_>, warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let mut plan = AssemblyPlan::default();
    visit_instances(document, BYTES_PER_INSTANCE, &mut |instance| {
        let transform = Transform::new(instance.matrix);
        for at in document.item("meshes", instance.mesh, &document.root)?.entries("primitives")? {
            if plan.pieces.len() == MAX_PRIMITIVES {
                return Err(document_fault(format!("the scene shows more than {MAX_PRIMITIVES} primitives")));
            }
            if let Some(primitive) = Primitive::parse(document, at)? {
                plan.add(
                    document,
                    primitive,
                    NodePlace { transform, pose: instance.pose.clone() },
                    instance.name,
                )?;
            }
        }
        Ok(())
    })?;
    let mut mesh =
        IndexedMesh { appearance: appearance::appearance(document, warnings)?, ..IndexedMesh::default() };
    plan.choose_vertices(document, Unused::Kept)?;
    mesh.origin = plan.move_to_origin(document);
    mesh.positions = plan.positions(document)?;
    mesh.layers = plan.layers(document)?;
    set_linear(&mut mesh.appearance, mesh.layers.iter().map(|layer| layer.semantic.clone()));
    for block in &plan.blocks {
        block.pose.apply(&mut mesh, block.first_vertex..block.first_vertex + block.vertex_count);
    }
    let block_of_group = plan.triangles_into(document, Grouping::FansJoined, &mut mesh)?;
    plan.compute_normals(&block_of_group, &mut mesh);
    Ok(mesh)
}

/// Builds the mesh of some primitives, each of which becomes a group, without transforms and appearance.
///
/// `used_bytes` is the memory that the meshes of the document take; that of this mesh is added. `numbers` is
/// the name of a layer with the numbers of the vertices in their accessors.
pub(super) fn mesh_of_primitives<'a>(
    document: &GltfDocument<'_>,
    primitives: impl IntoIterator<Item = Primitive<'a>>,
    used_bytes: &mut u64,
    numbers: Option<&str>,
) -> Result<IndexedMesh, Fault> {
    let mut plan = AssemblyPlan { other_bytes: *used_bytes, ..AssemblyPlan::default() };
    for primitive in primitives {
        plan.add(document, primitive, NodePlace { transform: None, pose: RestPose::default() }, "")?;
    }
    *used_bytes = plan.total_bytes();
    plan.choose_vertices(document, Unused::LeftOut)?;
    let mut mesh = IndexedMesh { positions: plan.positions(document)?, ..IndexedMesh::default() };
    mesh.layers = plan.layers(document)?;
    mesh.layers.extend(numbers.map(|name| plan.numbers(name)));
    plan.triangles_into(document, Grouping::Primitives, &mut mesh)?;
    Ok(mesh)
}

/// Treatment of vertices that no triangle has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unused {
    /// They are kept, unless several blocks have the same accessors.
    Kept,
    /// They are left out if they are many.
    LeftOut,
}

/// How primitives become groups.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Grouping {
    /// Each becomes a group.
    Primitives,
    /// All fans of one mesh and material become one group, and each other primitive becomes a group.
    FansJoined,
}

impl VertexBlock<'_> {
    /// Number of vertices that the block has if it has no unused ones, at most. Those of few triangles are
    /// looked up one by one; where most are used, all are kept.
    fn least_vertices(&self) -> usize {
        let corners = usize::try_from(self.corner_count).unwrap_or(usize::MAX);
        if corners < self.element_count / 2 { corners } else { self.element_count }
    }

    /// Reads those elements of an accessor that are vertices.
    fn read<T>(&self, accessor: &Accessor<'_>, read: impl FnOnce(&Accessor<'_>) -> T) -> T {
        match &self.elements {
            None => read(accessor),
            Some(elements) => read(&accessor.with_elements(&accessor.gather(elements))),
        }
    }
}

/// Transform and pose in which a node shows a primitive.
struct NodePlace {
    /// Transform to the scene, unless it is the identity.
    pub transform: Option<Transform>,
    /// Skin and morph targets in the rest pose.
    pub pose: RestPose,
}

impl<'a> AssemblyPlan<'a> {
    fn add(
        &mut self,
        document: &GltfDocument<'_>,
        primitive: Primitive<'a>,
        NodePlace { transform, pose }: NodePlace,
        name: &'a str,
    ) -> Result<(), Fault> {
        // Each group has a copy.
        self.other_bytes = self.other_bytes.saturating_add(name.len() as u64);
        let key: BlockKey = (
            primitive.position,
            primitive.attributes.clone(),
            primitive.draco.as_ref().map(DracoLink::key),
            transform.as_ref().map(Transform::key),
            pose.key(),
        );
        let (block, primitive) = match self.block_of.get(&key) {
            Some(&block) => (block, Some(primitive)),
            None => {
                self.add_block(document, primitive, transform, pose)?;
                self.block_of.insert(key, self.blocks.len() - 1);
                (self.blocks.len() - 1, None)
            }
        };
        let own = &mut self.blocks[block];
        let shown = primitive.as_ref().unwrap_or(&own.primitive);
        let triangle_limit = shown.triangle_limit(document, own.element_count)?;
        self.triangle_limit += triangle_limit;
        own.corner_count = own.corner_count.saturating_add(3 * triangle_limit);
        self.vertex_count -= own.vertex_count;
        own.vertex_count = own.least_vertices();
        self.vertex_count += own.vertex_count;
        self.check_size(document)?;
        self.pieces.push(PlacedPrimitive { primitive, block, name });
        Ok(())
    }

    /// Checks the accessors of a new block, and widens the formats of the layers for them.
    fn add_block(
        &mut self,
        document: &GltfDocument<'_>,
        primitive: Primitive<'a>,
        transform: Option<Transform>,
        pose: RestPose,
    ) -> Result<(), Fault> {
        let shape_of =
            |semantic: Option<&Semantic>, index| Ok(primitive.data(document, semantic, index)?.shape);
        let element_count = add_vertices(&primitive, &mut self.formats, shape_of)?;
        // All replacements of sparse accessors would be looked at for each block.
        let mut corner_count = if primitive.positions(document)?.sparse.is_some() { u64::MAX } else { 0 };
        for &(ref semantic, index) in &primitive.attributes {
            if primitive.attribute(document, semantic, index)?.sparse.is_some() {
                corner_count = u64::MAX;
            }
        }
        let (first_vertex, vertex_count, elements) = (0, 0, None);
        self.blocks.push(VertexBlock {
            primitive,
            transform,
            pose,
            first_vertex,
            vertex_count,
            element_count,
            corner_count,
            elements,
        });
        Ok(())
    }

    /// Chooses the vertices of each block, and numbers them.
    fn choose_vertices(&mut self, document: &GltfDocument<'_>, unused: Unused) -> Result<(), Fault> {
        let mut uses: BTreeMap<u64, u32> = BTreeMap::new();
        for block in &self.blocks {
            *uses.entry(block.primitive.position).or_default() += 1;
        }
        let may_choose = |block: &VertexBlock<'_>| {
            let is_shared = unused == Unused::LeftOut || uses[&block.primitive.position] > 1;
            is_shared && block.least_vertices() < block.element_count
        };
        let chosen: Vec<bool> = self.blocks.iter().map(may_choose).collect();
        let mut elements = vec![Vec::new(); self.blocks.len()];
        for piece in self.pieces.iter().filter(|piece| chosen[piece.block]) {
            let block = &self.blocks[piece.block];
            let primitive = piece.primitive.as_ref().unwrap_or(&block.primitive);
            elements[piece.block].extend(primitive.indices(document, block.element_count)?);
        }
        let mut first_vertex = 0;
        for ((block, mut elements), is_chosen) in self.blocks.iter_mut().zip(elements).zip(chosen) {
            block.vertex_count = block.element_count;
            if is_chosen {
                elements.sort_unstable();
                elements.dedup();
                block.vertex_count = elements.len();
                block.elements = Some(elements);
            }
            block.first_vertex = first_vertex;
            first_vertex += block.vertex_count;
        }
        self.vertex_count = first_vertex;
        Ok(())
    }

    /// Refuses a scene whose mesh is far too large for the file.
    fn check_size(&self, document: &GltfDocument<'_>) -> Result<(), Fault> {
        let limit = ALWAYS_ALLOWED_BYTES.max(document.input_bytes * BYTES_PER_INPUT_BYTE);
        let bytes = self.total_bytes();
        let is_countable = self.vertex_count < u32::MAX as usize / 4 && self.triangle_limit < 1 << 30;
        if bytes > limit || !is_countable {
            let reason = format!(
                "the scene expands to {} vertices and up to {} triangles, {bytes} bytes with all names, too \
                 many for a file of {} bytes",
                self.vertex_count, self.triangle_limit, document.input_bytes
            );
            return Err(document_fault(reason));
        }
        Ok(())
    }

    /// Returns the memory that this mesh and the others of the document take, in bytes.
    fn total_bytes(&self) -> u64 {
        let vertex_bytes: u64 = 12 + self.formats.values().map(|f| f.vertex_bytes()).sum::<u64>();
        (self.vertex_count as u64)
            .saturating_mul(vertex_bytes)
            .saturating_add(self.triangle_limit.saturating_mul(12))
            .saturating_add(self.other_bytes)
    }

    /// Chooses the origin of a scene whose nodes place meshes far from zero, and makes all transforms relative
    /// to it. Skins have transforms of their own, and keep an origin of zero.
    fn move_to_origin(&mut self, document: &GltfDocument<'_>) -> [f64; 3] {
        let has_skins = self.blocks.iter().any(|block| block.pose.has_skin());
        if has_skins || self.blocks.iter().all(|block| block.transform.is_none()) {
            return [0.0; 3];
        }
        let corners =
            |block: &VertexBlock<'_>| placed_corners(document, &block.primitive, block.transform.as_ref());
        let origin = origin_of_corners(self.blocks.iter().flat_map(corners).collect());
        if origin != [0.0; 3] {
            for block in &mut self.blocks {
                block.transform = block.transform.unwrap_or_default().relative_to(origin);
            }
        }
        origin
    }

    fn positions(&self, document: &GltfDocument<'_>) -> Result<Vec<[f32; 3]>, Fault> {
        let mut positions: Vec<[f32; 3]> = Vec::with_capacity(self.vertex_count);
        for block in &self.blocks {
            let accessor = block.primitive.positions(document)?;
            let numbers = block.read(&accessor, |own| own.floats());
            let (points, _) = numbers.as_chunks::<3>();
            match &block.transform {
                None => positions.extend_from_slice(points),
                Some(transform) => positions.extend(points.iter().map(|&p| transform.point(p))),
            }
        }
        Ok(positions)
    }

    fn layers(&self, document: &GltfDocument<'_>) -> Result<Vec<AttributeLayer>, Fault> {
        let mut layers = Vec::with_capacity(self.formats.len());
        for (semantic, format) in &self.formats {
            let mut layer = format.layer(semantic, self.vertex_count);
            for block in &self.blocks {
                let own = block.primitive.attributes.iter().find(|(s, _)| s == semantic);
                match own {
                    Some(&(_, index)) => {
                        let accessor = block.primitive.attribute(document, semantic, index)?;
                        block.read(&accessor, |own| append(&mut layer, own, block.transform.as_ref()));
                    }
                    None => fill(&mut layer, block.vertex_count),
                }
            }
            layers.push(layer);
        }
        Ok(layers)
    }

    /// Returns a layer with the number of each vertex in its accessor.
    fn numbers(&self, name: &str) -> AttributeLayer {
        let mut numbers = Vec::with_capacity(self.vertex_count);
        for block in &self.blocks {
            match &block.elements {
                None => numbers.extend((0..block.element_count).map(|number| number as f32)),
                Some(elements) => numbers.extend(elements.iter().map(|&number| number as f32)),
            }
        }
        AttributeLayer::from_f32(Semantic::Generic(name.to_owned()), 1, numbers)
    }

    /// Appends triangles and their groups; returns the block of each group.
    fn triangles_into(
        &self,
        document: &GltfDocument<'_>,
        grouping: Grouping,
        mesh: &mut IndexedMesh,
    ) -> Result<Vec<usize>, Fault> {
        mesh.triangles.reserve(self.triangle_limit as usize);
        let mut block_of_group = Vec::with_capacity(self.pieces.len());
        let mut fans_before = None;
        for piece in &self.pieces {
            let block = &self.blocks[piece.block];
            let primitive = piece.primitive.as_ref().unwrap_or(&block.primitive);
            let first = mesh.triangles.len();
            let first_vertex = block.first_vertex as u32;
            match &block.elements {
                None => {
                    let count = block.element_count;
                    primitive.triangles_into(document, first_vertex, count, &mut mesh.triangles)?;
                }
                Some(elements) => {
                    primitive.triangles_into(document, 0, block.element_count, &mut mesh.triangles)?;
                    let number = |v: u32| elements.binary_search(&v).map_or(0, |found| found as u32);
                    let own = &mut mesh.triangles[first..];
                    own.iter_mut().for_each(|t| *t = t.map(|v| first_vertex + number(v)));
                }
            }
            if block.transform.as_ref().is_some_and(|t| t.is_mirrored) {
                mesh.triangles[first..].iter_mut().for_each(|t| t.swap(1, 2));
            }
            let count = (mesh.triangles.len() - first) as u32;
            // Fans of one object are separate primitives, but form one group.
            let joins = grouping == Grouping::FansJoined && primitive.is_fan();
            let fans = joins.then_some((piece.block, piece.name, primitive.material));
            match mesh.groups.last_mut() {
                Some(group) if fans.is_some() && fans == fans_before => group.count += count,
                _ => {
                    block_of_group.push(piece.block);
                    let (name, material, first) = (piece.name.to_owned(), primitive.material, first as u32);
                    mesh.groups.push(TriangleGroup { name, material, first, count });
                }
            }
            fans_before = fans;
        }
        Ok(block_of_group)
    }

    /// Computes normals for the blocks that have none, if others have.
    fn compute_normals(&self, block_of_group: &[usize], mesh: &mut IndexedMesh) {
        let Some(layer) = mesh.layers.iter_mut().find(|layer| layer.semantic == Semantic::Normal) else {
            return;
        };
        let LayerData::F32(data) = &mut layer.data else { return };
        let lacks = |b: &VertexBlock<'_>| b.primitive.attributes.iter().all(|(s, _)| *s != Semantic::Normal);
        let mut triangles_of: BTreeMap<usize, Vec<[u32; 3]>> = BTreeMap::new();
        for (&block, group) in block_of_group.iter().zip(&mesh.groups) {
            if lacks(&self.blocks[block]) {
                let own = triangles_of.entry(block).or_default();
                own.extend_from_slice(&mesh.triangles[group.range()]);
            }
        }
        for (block, triangles) in triangles_of {
            let VertexBlock { first_vertex, vertex_count, .. } = self.blocks[block];
            let range = first_vertex..first_vertex + vertex_count;
            let normals = normals::of_vertices(&mesh.positions, &triangles, range.clone());
            data[range.start * 3..range.end * 3].copy_from_slice(normals.as_flattened());
        }
    }
}
