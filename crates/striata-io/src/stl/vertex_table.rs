//! Vertices of facets: equal positions are one.

/// Hash table that finds the vertex of a position, by open addressing over the vertices themselves.
pub(crate) struct VertexTable {
    pub positions: Vec<[f32; 3]>,
    /// Vertex index plus one, or 0 for a free slot; the length is a power of two.
    table: Vec<u32>,
}

impl VertexTable {
    pub(crate) fn with_capacity(vertex_count: usize) -> Self {
        let places = (vertex_count * 2).next_power_of_two().max(16);
        Self { positions: Vec::with_capacity(vertex_count), table: vec![0; places] }
    }

    /// Returns the vertex of a position, after adding it if it is new.
    #[inline]
    pub(crate) fn vertex(&mut self, position: [f32; 3]) -> u32 {
        let mask = self.table.len() - 1;
        let key = key_of(position);
        let mut place = hash(key) as usize & mask;
        loop {
            match self.table[place] {
                0 => break,
                vertex if key_of(self.positions[vertex as usize - 1]) == key => return vertex - 1,
                _ => place = (place + 1) & mask,
            }
        }
        self.positions.push(position);
        let vertex = self.positions.len() as u32;
        self.table[place] = vertex;
        if self.positions.len() * 3 > self.table.len() * 2 {
            self.grow();
        }
        vertex - 1
    }

    fn grow(&mut self) {
        let mut table = vec![0u32; self.table.len() * 2];
        let mask = table.len() - 1;
        for (vertex, &position) in self.positions.iter().enumerate() {
            let mut place = hash(key_of(position)) as usize & mask;
            while table[place] != 0 {
                place = (place + 1) & mask;
            }
            table[place] = vertex as u32 + 1;
        }
        self.table = table;
    }
}

/// Returns bits that are equal if positions are: adding zero makes -0 and 0 the same.
#[inline]
fn key_of(position: [f32; 3]) -> [u32; 3] {
    position.map(|x| (x + 0.0).to_bits())
}

#[inline]
fn hash([x, y, z]: [u32; 3]) -> u64 {
    let mixed = (u64::from(x) | u64::from(y) << 32).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ (mixed >> 32) ^ u64::from(z)).wrapping_mul(0xD6E8_FEB8_6659_FD93);
    mixed ^ (mixed >> 32)
}
