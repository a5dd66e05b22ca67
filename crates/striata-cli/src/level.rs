//! Which level the user means.

use striata::simplify::Target;

use crate::args::LevelArgs;
use crate::failure::Failure;

impl LevelArgs {
    /// The target in mesh units.
    ///
    /// # Errors
    /// Where it is a view; and where none is given, which the argument parser refuses before.
    pub(crate) fn target(&self, diagonal: f64) -> Result<Target, Failure> {
        self.target_if_given(diagonal)?.ok_or_else(|| Failure::internal("no level was given"))
    }

    /// The target in mesh units, where one is given.
    ///
    /// # Errors
    /// Where it is a view.
    pub(crate) fn target_if_given(&self, diagonal: f64) -> Result<Option<Target>, Failure> {
        let targets = [
            self.triangles.map(Target::Triangles),
            self.vertices.map(Target::Vertices),
            self.detail.map(Target::Detail),
            self.error.map(|error| Target::Error(error.in_units(diagonal))),
            self.split_count.map(Target::SplitCount),
        ];
        if self.eye.is_some() {
            return Err(Failure::user("a view is refined from a file that holds all levels")
                .with_hint("`striata build` makes one, `striata extract --eye` takes the view from it"));
        }
        Ok(targets.into_iter().flatten().next())
    }
}
