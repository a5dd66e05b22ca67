//! All ways to get a level onto the screen that are timed.

mod fans;
mod resident;
mod strips;
mod way;

use striata::model::FanForm;

use self::fans::{ComputedFans, SentFans};
use self::resident::Resident;
use self::strips::{ChangedStrips, SentList, SentStrips};
pub(super) use self::way::Way;
use super::stage::Stage;
use striata_command::failure::Failure;

/// Builds a way for the levels of a walk.
type Build = for<'s> fn(&'s Stage<'_>, &[usize]) -> Result<Box<dyn Way + 's>, Failure>;

/// A way by its name.
pub(super) struct Entry {
    pub(super) name: &'static str,
    /// What it does, for people.
    pub(super) about: &'static str,
    /// Whether levels stay on the GPU.
    pub(super) is_resident: bool,
    build: Build,
}

impl Entry {
    /// Builds it.
    ///
    /// # Errors
    /// Where it does not fit onto the GPU.
    pub(super) fn build<'s>(
        &self,
        stage: &'s Stage<'_>,
        levels: &[usize],
    ) -> Result<Box<dyn Way + 's>, Failure> {
        (self.build)(stage, levels)
    }
}

const fn sent(name: &'static str, about: &'static str, build: Build) -> Entry {
    Entry { name, about, is_resident: false, build }
}

const fn resident(name: &'static str, about: &'static str, build: Build) -> Entry {
    Entry { name, about, is_resident: true, build }
}

const ENTRIES: [Entry; 10] = [
    sent("list", "a progressive mesh's list of triangles, sent whole", |stage, _| {
        Ok(Box::new(SentList::new(stage)?))
    }),
    sent("strips", "the strips of LodStrips, sent whole", |stage, _| Ok(Box::new(SentStrips::new(stage)?))),
    sent("strips-ranges", "the same, of which only what changes is sent", |stage, _| {
        Ok(Box::new(ChangedStrips::new(stage, false)?))
    }),
    sent("strips-draws", "the same, and a draw for each strip instead of restarts", |stage, _| {
        Ok(Box::new(ChangedStrips::new(stage, true)?))
    }),
    sent("fans", "fans made a list by the processor, sent whole", |stage, _| {
        Ok(Box::new(SentFans::new(stage, FanForm::Triangles)?))
    }),
    sent("fans-strips", "fans made strips by the processor, sent whole", |stage, _| {
        Ok(Box::new(SentFans::new(stage, FanForm::Strips)?))
    }),
    sent("fans-compute", "fans made a list by compute shaders; a bit a step is sent", |stage, _| {
        Ok(Box::new(ComputedFans::new(stage)?))
    }),
    resident("resident-list", "the levels of the walk as lists, all on the GPU before", |stage, levels| {
        Ok(Box::new(Resident::lists(stage, levels)?))
    }),
    resident("resident-strips", "the same as strips", |stage, levels| {
        Ok(Box::new(Resident::strips(stage, levels)?))
    }),
    resident("discrete", "five discrete levels down to a sixteenth, the next coarser one", |stage, _| {
        Ok(Box::new(Resident::discrete(stage)?))
    }),
];

/// The names of all ways.
pub(crate) fn way_names() -> impl Iterator<Item = &'static str> {
    ENTRIES.iter().map(|entry| entry.name)
}

/// All ways, for those who explain them.
pub(super) fn all() -> &'static [Entry] {
    &ENTRIES
}

/// The ways of these names.
///
/// # Errors
/// Where a name is none.
pub(super) fn entries(names: &[&str]) -> Result<Vec<&'static Entry>, Failure> {
    let find = |name: &&str| {
        ENTRIES.iter().find(|entry| entry.name == *name).ok_or_else(|| {
            let known: Vec<&str> = way_names().collect();
            Failure::user(format!("no way to draw is called {name:?}"))
                .with_hint(format!("--ways takes {}", known.join(", ")))
        })
    };
    names.iter().map(find).collect()
}
