//! The models that this version has: built by name, as they go into a file.

use striata::file::FileModel;
use striata::model::{FanBounds, Fans, LodModel, LodStrips, Mts, PartBytes, PatternBounds, Patterns};
use striata::strip::StripSet;
use striata_stream::{EncodedStream, file_model};

use striata_command::failure::Failure;
use striata_command::output::Bar;
use striata_command::sequence::{Sequenced, Steps};

/// Models that this version has.
pub(crate) const MODELS: [&str; 5] = ["lodstrips", "mts", FANS, PATTERNS, PROGRESSIVE];

/// The model that follows views by the errors of collapses.
pub(super) const FANS: &str = "fans";

/// The only model that takes any steps.
pub(super) const PATTERNS: &str = "patterns";

/// The stream.
pub(crate) const PROGRESSIVE: &str = "progressive";

/// Whether a model is made of strips.
pub(super) fn takes_strips(model: impl AsRef<str>) -> bool {
    ["lodstrips", "mts"].contains(&model.as_ref())
}

/// The models that were asked for.
#[derive(Debug)]
pub(super) struct Models {
    pub(super) lod_strips: Option<LodStrips<'static>>,
    pub(super) mts: Option<Mts<'static>>,
    pub(super) fans: Option<(Fans, FanBounds)>,
    pub(super) patterns: Option<(Patterns, PatternBounds)>,
    /// The mesh is in its order.
    pub(super) stream: Option<EncodedStream>,
}

impl Models {
    /// Models of strips are built where there are strips.
    ///
    /// # Errors
    /// Where the strips are not those of the mesh, or there are too many fragments.
    pub(super) fn build(
        names: &[String],
        sequenced: &Sequenced,
        (strips, stream): (Option<&StripSet>, Option<EncodedStream>),
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let is_wanted = |name: &str| names.iter().any(|n| n == name);
        let mut models = Self { lod_strips: None, mts: None, fans: None, patterns: None, stream };
        if let Steps::Collapses(refinable) = &sequenced.steps {
            let strips_for = |name: &str| strips.filter(|_| is_wanted(name));
            models.lod_strips =
                strips_for("lodstrips").map(|s| LodStrips::build(refinable, s)).transpose()?;
            models.mts = strips_for("mts").map(|s| Mts::build(refinable, s)).transpose()?;
            models.fans = is_wanted("fans").then(|| {
                let fans = Fans::build(refinable);
                let bounds = FanBounds::build(&fans, refinable);
                (fans, bounds)
            });
        }
        if is_wanted(PATTERNS) {
            let fragmented = sequenced.fragments(&mut |progress| bar.show(progress))?;
            models.patterns = Some((Patterns::build(&fragmented)?, PatternBounds::build(&fragmented)));
        }
        Ok(models)
    }

    pub(super) fn in_file(&self) -> Result<Vec<FileModel<'_>>, Failure> {
        let lod_strips = self.lod_strips.iter().map(FileModel::LodStrips);
        let fans = self.fans.iter().map(|(fans, bounds)| FileModel::Fans(fans, bounds));
        let patterns = self.patterns.iter().map(|(patterns, bounds)| FileModel::Patterns(patterns, bounds));
        let stream = self.stream.as_ref().map(|stream| file_model(&stream.bytes)).transpose()?;
        let of_strips = lod_strips.chain(self.mts.iter().map(FileModel::Mts));
        Ok(of_strips.chain(fans).chain(patterns).chain(stream).collect())
    }

    /// Each model's name and parts.
    pub(super) fn parts(&self) -> Vec<(&'static str, Vec<PartBytes>)> {
        let lod_strips = self.lod_strips.iter().map(|model| ("lodstrips", model.bytes()));
        let mts = self.mts.iter().map(|model| ("mts", model.bytes()));
        let fans = self.fans.iter().map(|(fans, bounds)| ("fans", parts_of_fans(fans, bounds)));
        let patterns =
            self.patterns.iter().map(|(patterns, bounds)| (PATTERNS, parts_of_patterns(patterns, bounds)));
        let parts_of_stream = |s: &EncodedStream| vec![PartBytes { name: "stream", bytes: s.bytes.len() }];
        let streams = self.stream.iter().map(|stream| (PROGRESSIVE, parts_of_stream(stream)));
        lod_strips.chain(mts).chain(fans).chain(patterns).chain(streams).collect()
    }
}

/// The parts of fans, what a view needs of them among these.
pub(crate) fn parts_of_fans(fans: &Fans, bounds: &FanBounds) -> Vec<PartBytes> {
    let mut parts = fans.bytes();
    parts.push(PartBytes { name: "bounds", bytes: bounds.bytes() });
    parts
}

/// The same of patterns.
pub(crate) fn parts_of_patterns(patterns: &Patterns, bounds: &PatternBounds) -> Vec<PartBytes> {
    let mut parts = patterns.bytes();
    parts.push(PartBytes { name: "bounds", bytes: bounds.bytes() });
    parts
}
