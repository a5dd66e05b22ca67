//! Distribution of everything over packets, in the order of the stream.

use striata_io::Scene;

use super::head::PART_COUNT;
use super::images::PreparedImage;
use super::mesh_stream::MeshStream;
use super::packet::{PacketKind, put_packet};
use super::schedule::{ANIMATION_ERROR, Item, MeshCosts, WholeCosts, schedule};

/// Largest packet of refinement that is made of several chunks, bytes: small packets can be used sooner,
/// large ones have less overhead.
const JOINED_BYTES: usize = 8192;

/// Largest piece of an image, bytes.
const IMAGE_PIECE_BYTES: usize = 1 << 16;

/// Bytes of each part of a stream; together they are the whole stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SceneStreamSizes {
    /// Document and table.
    pub document_bytes: usize,
    /// Base meshes, with the headers of their streams.
    pub base_bytes: usize,
    /// Refinement of the meshes.
    pub refinement_bytes: usize,
    /// Animations, skins, points and lines.
    pub buffer_bytes: usize,
    /// Previews of images.
    pub preview_bytes: usize,
    /// Images.
    pub image_bytes: usize,
    /// Header of the stream, and headers of the packets.
    pub packet_bytes: usize,
    /// Length of the prefix that shows every mesh.
    pub drawable_at: usize,
    /// Length of the prefix that shows every mesh, with previews of all images.
    pub textured_at: usize,
}

/// Packets in the order of the stream, with a count of what they contain.
#[derive(Default)]
pub(super) struct Packets {
    pub bytes: Vec<u8>,
    /// Length of everything but payloads.
    pub head_bytes: usize,
    pub sizes: SceneStreamSizes,
}

impl Packets {
    fn put(&mut self, kind: PacketKind, index: usize, payload: &[u8]) {
        let start = self.bytes.len();
        put_packet(kind, index, payload, &mut self.bytes);
        self.head_bytes += self.bytes.len() - start - payload.len();
        let sum = match kind {
            PacketKind::Document => &mut self.sizes.document_bytes,
            PacketKind::Mesh => &mut self.sizes.refinement_bytes,
            PacketKind::Buffer => &mut self.sizes.buffer_bytes,
            PacketKind::Preview => &mut self.sizes.preview_bytes,
            PacketKind::Image => &mut self.sizes.image_bytes,
        };
        *sum += payload.len();
    }

    fn put_image(&mut self, image: usize, bytes: &[u8]) {
        bytes.chunks(IMAGE_PIECE_BYTES).for_each(|piece| self.put(PacketKind::Image, image, piece));
    }
}

/// All packets after the document.
pub(super) struct Body {
    pub packets: Packets,
    /// Length of the packets until every mesh can be drawn.
    pub base_end: usize,
    /// Length of the packets until all previews are there.
    pub preview_end: usize,
}

impl Body {
    /// Distributes everything over packets.
    pub(super) fn new(
        scene: &Scene,
        meshes: &[Option<MeshStream>],
        images: &[PreparedImage],
        parts: &[Vec<u8>; PART_COUNT],
    ) -> Self {
        let mut packets = Packets::default();
        let put_part =
            |packets: &mut Packets, part: usize| packets.put(PacketKind::Buffer, part, &parts[part]);
        put_part(&mut packets, 0);
        for (index, mesh) in meshes.iter().enumerate() {
            let Some(mesh) = mesh else { continue };
            packets.put(PacketKind::Mesh, index, &mesh.bytes[..mesh.info.base_bytes as usize]);
        }
        packets.sizes.base_bytes = std::mem::take(&mut packets.sizes.refinement_bytes);
        let base_end = packets.bytes.len();
        let preview_end = put_refinement(&mut packets, scene, meshes, images, &parts[1]);
        Self { packets, base_end, preview_end }
    }
}

/// Puts the rest of all meshes, the previews, the images and the animations, in the order of the schedule. Returns the
/// length of the packets until all previews are there, and the images that are sent instead of one.
fn put_refinement(
    packets: &mut Packets,
    scene: &Scene,
    meshes: &[Option<MeshStream>],
    images: &[PreparedImage],
    animations: &[u8],
) -> usize {
    let costs: Vec<MeshCosts> =
        meshes.iter().map(|mesh| mesh.as_ref().map(MeshStream::costs).unwrap_or_default()).collect();
    let diagonal = scene.diagonal();
    let is_early = |item: &Item| match item {
        Item::Preview(_) => true,
        Item::Image(image) => images[*image].is_early,
        Item::Animations | Item::Chunks { .. } => false,
    };
    let mut others: Vec<_> =
        images.iter().enumerate().flat_map(|(index, image)| image.costs(index, diagonal)).collect();
    put_before_images(&mut others, &is_early);
    others.push(WholeCosts {
        item: Item::Animations,
        bytes: animations.len() as u64,
        error: ANIMATION_ERROR * diagonal,
    });
    let mut sent: Vec<usize> =
        meshes.iter().map(|mesh| mesh.as_ref().map_or(0, |mesh| mesh.info.base_bytes as usize)).collect();
    let mut preview_end = packets.bytes.len();
    for item in schedule(&costs, &others, diagonal) {
        let ends_previews = is_early(&item);
        match item {
            Item::Animations => packets.put(PacketKind::Buffer, 1, animations),
            Item::Preview(image) => packets.put(PacketKind::Preview, image, &images[image].preview),
            Item::Image(image) => packets.put_image(image, &scene.images()[image].bytes),
            Item::Chunks { mesh, chunks } => {
                let Some(stream) = &meshes[mesh] else { continue };
                let lengths = stream.refinement()[chunks].iter().map(|chunk| chunk.bytes as usize);
                for length in joined(lengths) {
                    let end = sent[mesh] + length;
                    packets.put(PacketKind::Mesh, mesh, &stream.bytes[sent[mesh]..end]);
                    sent[mesh] = end;
                }
            }
        }
        if ends_previews {
            preview_end = packets.bytes.len();
        }
    }
    preview_end
}

/// Raises what early items gain, so that no whole image precedes one of them: the previews of all flat maps together are
/// smaller than an image.
fn put_before_images(items: &mut [WholeCosts], is_early: &impl Fn(&Item) -> bool) {
    let is_late_image = |costs: &&WholeCosts| matches!(costs.item, Item::Image(_)) && !is_early(&costs.item);
    let best = items.iter().filter(is_late_image).map(WholeCosts::rate).fold(0.0, f64::max);
    for costs in items.iter_mut().filter(|costs| is_early(&costs.item)) {
        // A little more, since the quotient is rounded.
        costs.error = costs.error.max(best * costs.bytes.max(1) as f64 * (1.0 + 1e-9));
    }
}

/// Joins neighboring lengths as long as their sum stays small.
fn joined(lengths: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut joined: Vec<usize> = Vec::new();
    for length in lengths {
        match joined.last_mut() {
            Some(last) if *last + length <= JOINED_BYTES => *last += length,
            _ => joined.push(length),
        }
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::super::schedule::MeshCosts;
    use super::*;

    /// A preview of one color, and an image that gains much per byte, come in this order, whatever is between them.
    #[test]
    fn previews_precede_whole_images() {
        let costs = |item, bytes, error| WholeCosts { item, bytes, error };
        for bytes in [1, 3, 700, 12_345] {
            let mut items = vec![
                costs(Item::Image(0), 999, 7.0),
                costs(Item::Image(1), 90, 0.0),
                costs(Item::Preview(2), bytes, 0.0),
            ];
            put_before_images(&mut items, &|item| matches!(item, Item::Image(1) | Item::Preview(_)));
            let mesh = MeshCosts { bytes: vec![100], gains: vec![1.0] };
            let order = schedule(&[mesh], &items, 1.0);
            let at = |item| order.iter().position(|other| *other == item);
            assert!(at(Item::Preview(2)) < at(Item::Image(0)) && at(Item::Image(1)) < at(Item::Image(0)));
            assert_eq!(order.len(), 4);
        }
    }
}
