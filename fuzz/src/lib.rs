//! Builds small meshes and streams from bytes, so that a fuzzer's mutations become mutations of what the
//! bytes stand for; `striata_testing::strange` does so for glTF documents.

mod packets;

pub use packets::{packed, unpacked};

use std::sync::Once;

use striata::mesh::{AttributeLayer, IndexedMesh, Material, Semantic, TriangleGroup};

/// Reads numbers from the front of the fuzzer's bytes; zeros once they are used up.
pub struct Bytes<'a>(pub &'a [u8]);

impl Bytes<'_> {
    pub fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    /// Returns a number of two bytes.
    pub fn short(&mut self) -> usize {
        usize::from(self.byte()) | usize::from(self.byte()) << 8
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns a coordinate: usually a small integer, so that corners coincide and lines are straight,
    /// sometimes a float of arbitrary bits.
    fn coordinate(&mut self) -> f32 {
        match self.byte() {
            255 => f32::from_bits(u32::from_le_bytes([self.byte(), self.byte(), self.byte(), self.byte()])),
            small => f32::from(small % 16) - f32::from(small / 16) / 16.0,
        }
    }

    /// Returns a mesh with up to 48 vertices, whose triangles use up the remaining bytes. It may be invalid.
    pub fn mesh(&mut self) -> IndexedMesh {
        let shape = self.byte();
        let vertex_count = usize::from(self.byte() % 48) + 1;
        let positions: Vec<[f32; 3]> =
            (0..vertex_count).map(|_| [self.coordinate(), self.coordinate(), self.coordinate()]).collect();
        let mut mesh = IndexedMesh::new(positions, Vec::new());
        if shape & 1 != 0 {
            let normals = (0..3 * vertex_count).map(|_| f32::from(self.byte() % 3) - 1.0).collect();
            mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
        }
        if shape & 2 != 0 {
            let texcoords = (0..2 * vertex_count).map(|_| f32::from(self.byte() % 4)).collect();
            mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords));
        }
        let cuts = [self.byte(), self.byte()];
        while !self.is_empty() && mesh.triangles.len() < 400 {
            mesh.triangles.push([(); 3].map(|()| u32::from(self.byte()) % vertex_count as u32));
        }
        if shape & 4 != 0 {
            mesh.groups = groups(cuts, mesh.triangles.len() as u32);
            mesh.appearance.materials = vec![Material::default(); 2];
        }
        mesh
    }
}

/// Three runs of triangles. The first and the last have a material.
fn groups(cuts: [u8; 2], triangle_count: u32) -> Vec<TriangleGroup> {
    let mut cuts = cuts.map(|cut| u32::from(cut).min(triangle_count));
    cuts.sort_unstable();
    let ends = [cuts[0], cuts[1], triangle_count];
    let starts = [0, cuts[0], cuts[1]];
    let materials = [Some(0), None, Some(1)];
    (0..3)
        .map(|g| TriangleGroup {
            name: String::new(),
            material: materials[g],
            first: starts[g],
            count: ends[g] - starts[g],
        })
        .collect()
}

/// Corrects the checksums of a `.striata` file, so that damage reaches the code behind them.
pub fn with_correct_checksums(bytes: &[u8]) -> Vec<u8> {
    const HEADER: usize = 64;
    const ENTRY: usize = 32;
    let mut out = bytes.to_vec();
    if out.len() < HEADER {
        return out;
    }
    let length = out.len() as u64;
    out[16..24].copy_from_slice(&length.to_le_bytes());
    let number = |out: &[u8], at: usize| {
        u64::from_le_bytes(std::array::from_fn(|i| out.get(at + i).copied().unwrap_or(0)))
    };
    let count = (number(&out, 12) as u32 as usize).min((out.len() - HEADER) / ENTRY);
    for entry in (0..count).map(|i| HEADER + ENTRY * i) {
        let first = usize::try_from(number(&out, entry + 8)).unwrap_or(usize::MAX);
        let end = first.saturating_add(usize::try_from(number(&out, entry + 16)).unwrap_or(usize::MAX));
        if let Some(section) = out.get(first..end) {
            let checksum = crc32fast::hash(section);
            out[entry + 24..entry + 28].copy_from_slice(&checksum.to_le_bytes());
        }
    }
    out[24..28].fill(0);
    let checksum = crc32fast::hash(&out[..HEADER + ENTRY * count]);
    out[24..28].copy_from_slice(&checksum.to_le_bytes());
    out
}

/// Lets panics within the decoders of other crates pass, which striata turns into errors; libFuzzer would
/// abort at any panic.
pub fn allow_contained_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let abort = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            let file = info.location().map_or("", |location| location.file());
            if !["draco", "meshoptimizer"].iter().any(|name| file.contains(name)) {
                abort(info);
            }
        }));
    });
}
