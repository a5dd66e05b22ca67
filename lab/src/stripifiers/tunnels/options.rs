//! Options of a search for tunnels, and the interface of both kinds of search.

use striata::mesh::Random;
use striata::strip::StripLinks;

/// How a search knows the strips of triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Identities {
    /// Identities follow every step of the search \[PS03\].
    Dynamic,
    /// Identities are those of the beginning of the search \[Ste01\]; tunnels that close a loop are discarded.
    Static,
}

/// How often a search may visit a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visits {
    /// Once in the whole search.
    OncePerSearch,
    /// Once on each path. After 1,000 moving ends once in the whole search, because the number of paths
    /// doubles with every second link.
    OncePerPath,
}

/// In which order ends are searched from, which \[PS03\] leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndOrder {
    /// Each end once, in random order, and again until none has a tunnel.
    Random,
    /// The same, but longer tunnels are searched only once no end has a shorter one.
    ShortestFirst,
    /// After a tunnel from the ends of the strip that it has made, as long as they have one.
    SameStrip,
}

/// Options of [`join_along_tunnels`](super::join_along_tunnels).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TunnelOptions {
    /// Length of the longest tunnel, in links; an even number acts as the odd one below it.
    pub max_length: u32,
    /// In which order ends are searched from.
    pub order: EndOrder,
    /// How a search knows the strips of triangles.
    pub identities: Identities,
    /// How often a search may visit a triangle.
    pub visits: Visits,
    /// Seed of the order of ends, and of the first link that a search crosses.
    pub seed: u64,
}

/// A search for tunnels that changes links.
pub(super) trait FindTunnels {
    /// Sets the length of the longest tunnel, in links.
    fn set_max_length(&mut self, max_length: u32);

    /// Applies the shortest tunnel from the end of a strip. Returns whether there was one.
    fn apply_shortest(&mut self, start: u32, links: &mut StripLinks<'_>, random: &mut Random) -> bool;

    /// Number of tunnels that were discarded because of a loop.
    fn loop_count(&self) -> usize;
}
