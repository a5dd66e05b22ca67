//! The ways of drawing a level that are timed.

mod fans;
mod resident;
mod sent;
mod strips;
mod way;

use striata::model::{FanForm, Mts};
use striata_lab::MtsGraph;
use striata_lab::baseline::{EfficientLodStrips, ProgressiveMeshes, Winding};

use self::fans::{ComputedFans, SentFans};
use self::resident::Resident;
use self::sent::Sent;
use self::strips::ChangedStrips;
pub(super) use self::way::Way;
use super::bench_scene::BenchScene;
use striata_command::failure::Failure;

/// Builds a way for the levels of a walk.
type Build = for<'s> fn(&'s BenchScene<'_>, &[usize]) -> Result<Box<dyn Way + 's>, Failure>;

/// A way, its name, and how to build it.
pub(super) struct WayEntry {
    pub name: &'static str,
    /// Description printed in the report.
    pub about: &'static str,
    /// Whether all levels stay on the GPU.
    pub is_resident: bool,
    build: Build,
}

impl WayEntry {
    /// Builds the way.
    ///
    /// # Errors
    /// If it does not fit onto the GPU.
    pub(super) fn build<'s>(
        &self,
        bench: &'s BenchScene<'_>,
        levels: &[usize],
    ) -> Result<Box<dyn Way + 's>, Failure> {
        (self.build)(bench, levels)
    }
}

const fn sent(name: &'static str, about: &'static str, build: Build) -> WayEntry {
    WayEntry { name, about, is_resident: false, build }
}

const fn resident(name: &'static str, about: &'static str, build: Build) -> WayEntry {
    WayEntry { name, about, is_resident: true, build }
}

const ENTRIES: [WayEntry; 14] = [
    sent("list", "triangle list of a progressive mesh, uploaded whole", |bench, _| {
        Ok(Box::new(Sent::new(bench, ProgressiveMeshes::build(&bench.refinable))?))
    }),
    sent("strips", "strips of LodStrips, uploaded whole", |bench, _| {
        Ok(Box::new(Sent::new(bench, bench.lod_strips()?)?))
    }),
    sent("strips-ranges", "strips of LodStrips, uploading only the changed ranges", |bench, _| {
        Ok(Box::new(ChangedStrips::new(bench, bench.lod_strips()?, false)?))
    }),
    sent("strips-draws", "as strips-ranges, with a draw per strip instead of restarts", |bench, _| {
        Ok(Box::new(ChangedStrips::new(bench, bench.lod_strips()?, true)?))
    }),
    sent("strips-staged", "strips of LodStrips in stages, uploaded whole", |bench, _| {
        Ok(Box::new(Sent::new(bench, bench.staged_lod_strips()?)?))
    }),
    sent("strips-published", "strips of LodStrips as published, uploaded whole", |bench, _| {
        let model = EfficientLodStrips::build(&bench.refinable, &bench.strips, Winding::Kept)?;
        Ok(Box::new(Sent::new(bench, model)?))
    }),
    sent("mts", "strips of MTS, uploaded whole", |bench, _| {
        Ok(Box::new(Sent::new(bench, Mts::build(&bench.refinable, &bench.strips)?)?))
    }),
    sent("mts-published", "strips of MTS as published, uploaded whole", |bench, _| {
        Ok(Box::new(Sent::new(bench, MtsGraph::build(&bench.refinable, &bench.strips)?)?))
    }),
    sent("fans", "fans expanded to a list by the CPU, uploaded whole", |bench, _| {
        Ok(Box::new(SentFans::new(bench, FanForm::Triangles)?))
    }),
    sent("fans-strips", "fans expanded to strips by the CPU, uploaded whole", |bench, _| {
        Ok(Box::new(SentFans::new(bench, FanForm::Strips)?))
    }),
    sent(
        "fans-compute",
        "fans expanded to a list by compute shaders, uploading a bit per step",
        |bench, _| Ok(Box::new(ComputedFans::new(bench)?)),
    ),
    resident("resident-list", "all levels of the walk as lists, uploaded in advance", |bench, levels| {
        Ok(Box::new(Resident::lists(bench, levels)?))
    }),
    resident("resident-strips", "all levels of the walk as strips, uploaded in advance", |bench, levels| {
        Ok(Box::new(Resident::strips(bench, levels)?))
    }),
    resident(
        "discrete",
        "five discrete levels down to a sixteenth, drawing the next coarser one",
        |bench, _| Ok(Box::new(Resident::discrete(bench)?)),
    ),
];

/// Names of all ways.
pub(crate) fn way_names() -> impl Iterator<Item = &'static str> {
    ENTRIES.iter().map(|entry| entry.name)
}

/// All ways, in the order of the report.
pub(super) fn all() -> &'static [WayEntry] {
    &ENTRIES
}

/// Finds the ways with these names.
///
/// # Errors
/// If a name is unknown.
pub(super) fn entries(names: &[&str]) -> Result<Vec<&'static WayEntry>, Failure> {
    let find = |name: &&str| {
        ENTRIES.iter().find(|entry| entry.name == *name).ok_or_else(|| {
            let known: Vec<&str> = way_names().collect();
            Failure::user(format!("no way to draw is called {name:?}"))
                .with_hint(format!("--ways takes {}", known.join(", ")))
        })
    };
    names.iter().map(find).collect()
}
