//! Kinds of tunneling that are compared: the published ones, and ours.

use clap::ValueEnum;
use striata::mesh::{DualGraph, IndexedMesh, MeshError};
use striata::strip::StripLinks;
use striata_strip::{StripOptions, Stripifier, stripify};

use super::{EndOrder, Identities, TunnelOptions, Visits, join_along_tunnels, strips_of};

/// A kind of tunneling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Tunneling {
    /// To the letter of \[PS03\]: from single triangles, each visited once per search.
    Published,
    /// To the letter of \[PS03\], with each triangle visited once per path.
    PerPath,
    /// As `PerPath`, but longer tunnels are searched once no end has a shorter one.
    ShortestFirst,
    /// As `PerPath`, but after a tunnel the search goes on from the same strip.
    SameStrip,
    /// The predecessor \[Ste01\] with static identities.
    Static,
    /// Our growth of strips, then the search of \[PS03\], once per path.
    Grown,
    /// Our stripifier: growth, and moves of ends that have no tunnel.
    Tunnel,
}

impl Tunneling {
    /// All kinds, from the published ones to ours.
    pub const ALL: [Self; 7] = [
        Self::Published,
        Self::PerPath,
        Self::ShortestFirst,
        Self::SameStrip,
        Self::Static,
        Self::Grown,
        Self::Tunnel,
    ];

    /// Explanation of the names.
    pub const LEGEND: &str = "published: from single triangles, each visited once per search; per-path: once per \
        path; shortest-first: once per path, and longer tunnels only where no end has a shorter one; same-strip: once per path, and on from the same strip; static: with the identities from before each search; grown: strips are grown first; tunnel: ours, \
        which also moves ends.";

    /// Returns the name in reports.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Published => "published",
            Self::PerPath => "per-path",
            Self::ShortestFirst => "shortest-first",
            Self::SameStrip => "same-strip",
            Self::Static => "static",
            Self::Grown => "grown",
            Self::Tunnel => "tunnel",
        }
    }

    /// Makes strips from none; returns their number.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub fn strip_count(self, mesh: &IndexedMesh, max_length: u32, seed: u64) -> Result<usize, MeshError> {
        let ours = |max_length| {
            let options = StripOptions::default().with_stripifier(Stripifier::Tunnel { max_length });
            stripify(mesh, &options.with_seed(seed))
        };
        let published = |identities, visits| {
            let order = match self {
                Self::ShortestFirst => EndOrder::ShortestFirst,
                Self::SameStrip => EndOrder::SameStrip,
                _ => EndOrder::Random,
            };
            TunnelOptions { max_length, order, identities, visits, seed }
        };
        let from_none = |options: TunnelOptions| {
            strips_of(mesh, |triangles, links| {
                join_along_tunnels(triangles, links, &options);
            })
        };
        let strips = match self {
            Self::Published => from_none(published(Identities::Dynamic, Visits::OncePerSearch))?,
            Self::PerPath | Self::ShortestFirst | Self::SameStrip => {
                from_none(published(Identities::Dynamic, Visits::OncePerPath))?
            }
            Self::Static => from_none(published(Identities::Static, Visits::OncePerSearch))?,
            Self::Grown => {
                // Tunnels of one link are our growth.
                let grown = ours(1)?;
                let graph = DualGraph::of_vertices(mesh);
                let mut links = StripLinks::from_strips(&graph, &mesh.triangles, &grown);
                let options = published(Identities::Dynamic, Visits::OncePerPath);
                let tunnel_count = join_along_tunnels(&mesh.triangles, &mut links, &options).tunnel_count;
                return Ok(grown.strip_count() - tunnel_count);
            }
            Self::Tunnel => ours(max_length)?,
        };
        Ok(strips.strip_count())
    }
}
