//! Which level the user means, which files levels go to, and whether they came out as asked.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use striata::mesh::{IndexedMesh, Levels, MeshError, weld};
use striata::simplify::{StopReason, Target};

use crate::args::{Count, Level, LevelArgs, LevelsArgs};
use crate::failure::Failure;
use crate::output::{Table, format_count, format_length, format_noun_count};

/// What stands for a level in the name of an output.
const PLACE: &str = "{}";

/// What targets are shares of: numbers of the full mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FullMesh {
    /// The diagonal of its bounds, mesh units.
    pub diagonal: f64,
    /// Its vertices, equal ones merged.
    pub vertex_count: usize,
    /// Its triangles, without degenerate ones.
    pub triangle_count: usize,
}

impl FullMesh {
    /// Numbers of a mesh as `simplify` and `build` see it.
    ///
    /// # Errors
    /// If the mesh's parts do not fit together.
    pub fn of(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        let welded = weld(mesh)?.mesh;
        let (vertex_count, triangle_count) = (welded.vertex_count(), welded.triangle_count());
        Ok(Self { diagonal: mesh.diagonal(), vertex_count, triangle_count })
    }

    /// Numbers of the finest of some levels; the diagonal is known elsewhere.
    pub fn of_levels(levels: &Levels, diagonal: f64) -> Self {
        let last = levels.step_count();
        let (vertex_count, triangle_count) = (levels.vertex_count_at(last), levels.triangle_count_at(last));
        Self { diagonal, vertex_count, triangle_count }
    }
}

impl LevelArgs {
    /// The target in mesh units, if one is given.
    pub fn target(&self, full: FullMesh) -> Option<Target> {
        let targets = [
            self.triangle_count().map(|count| Target::Triangles(count.of_triangles(full.triangle_count))),
            self.vertices.map(|count| Target::Vertices(count.of_vertices(full.vertex_count))),
            self.detail.map(Target::Detail),
            self.error.map(|error| Target::Error(error.in_units(full.diagonal))),
            self.split_count.map(Target::SplitCount),
        ];
        targets.into_iter().flatten().next()
    }

    /// Whether the target depends on how many vertices or triangles the full mesh has.
    pub fn has_share(&self) -> bool {
        self.triangle_count().or(self.vertices).is_some_and(Count::is_share)
    }
}

impl LevelsArgs {
    /// Whether a level depends on how many triangles the full mesh has.
    pub fn has_share(&self) -> bool {
        self.levels.iter().flatten().any(|level| level.triangles.is_share())
    }
}

/// A level that was asked for, and the file that it goes to.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The level as the user wrote it, if it is one of several.
    pub name: Option<String>,
    /// The level; `None` is the coarsest that there is.
    pub target: Option<Target>,
    /// Where it goes.
    pub path: PathBuf,
}

/// All levels that were asked for, in the user's order, with the files that they go to.
///
/// # Errors
/// If several levels would go to one file, or a name has a place for a level and there is none.
pub fn wanted_levels(
    level: &LevelArgs,
    levels: &LevelsArgs,
    full: FullMesh,
    output: &Path,
) -> Result<Vec<Wanted>, Failure> {
    match &levels.levels {
        Some(levels) => {
            let paths = paths_of_levels(levels, output)?;
            let target = |level: &Level| Target::Triangles(level.triangles.of_triangles(full.triangle_count));
            let wanted = levels.iter().zip(paths).map(|(level, path)| Wanted {
                name: Some(level.text.clone()),
                target: Some(target(level)),
                path,
            });
            Ok(wanted.collect())
        }
        None => {
            let path = path_of_level(level.text().as_deref(), output)?;
            Ok(vec![Wanted { name: None, target: level.target(full), path }])
        }
    }
}

/// Checks the names of all files before the work begins; gives them in the order of the levels.
///
/// # Errors
/// As [`wanted_levels`].
pub fn check_paths(level: &LevelArgs, levels: &LevelsArgs, output: &Path) -> Result<Vec<PathBuf>, Failure> {
    match &levels.levels {
        Some(levels) => paths_of_levels(levels, output),
        None => Ok(vec![path_of_level(level.text().as_deref(), output)?]),
    }
}

fn paths_of_levels(levels: &[Level], output: &Path) -> Result<Vec<PathBuf>, Failure> {
    let Some(pattern) = output.to_str().filter(|pattern| pattern.contains(PLACE)) else {
        let hint = match (output.file_stem(), output.extension()) {
            (Some(stem), Some(extension)) if output != Path::new("-") => {
                let name = format!("{}-{PLACE}.{}", stem.to_string_lossy(), extension.to_string_lossy());
                output.with_file_name(name).display().to_string()
            }
            _ => format!("level-{PLACE}.glb"),
        };
        return Err(Failure::user(format!(
            "{}: --levels needs {PLACE} in the name of the output",
            output.display()
        ))
        .with_hint(format!("{PLACE} stands for the level: -o '{hint}'")));
    };
    let mut seen = BTreeSet::new();
    let mut paths = Vec::new();
    for level in levels {
        let path = PathBuf::from(pattern.replace(PLACE, &file_part(&level.text)));
        if !seen.insert(path.clone()) {
            return Err(Failure::user(format!("{}: more than one level goes to this file", path.display()))
                .with_hint(format!("leave {} out, or write it by a command of its own", level.text)));
        }
        paths.push(path);
    }
    Ok(paths)
}

/// The name of the output with a level's text in its place.
///
/// # Errors
/// If it has such a place and the level has no text.
fn path_of_level(text: Option<&str>, output: &Path) -> Result<PathBuf, Failure> {
    match (output.to_str().filter(|pattern| pattern.contains(PLACE)), text) {
        (None, _) => Ok(output.to_owned()),
        (Some(pattern), Some(text)) => Ok(PathBuf::from(pattern.replace(PLACE, &file_part(text)))),
        (Some(pattern), None) => {
            Err(Failure::user(format!("{pattern}: {PLACE} stands for a level, and this one has no number"))
                .with_hint(format!("leave {PLACE} out of the name")))
        }
    }
}

/// A level's text as a part of a file name: `50%` is `50`.
fn file_part(text: &str) -> String {
    let is_fit = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '_');
    let number = text.trim_end_matches('%').trim();
    number.chars().map(|c| if is_fit(c) { c } else { '-' }).collect()
}

/// Why no coarser level than the last one can be made.
#[derive(Clone, Debug)]
pub enum Floor {
    /// The mesh was simplified as far as it goes; the text says what forbids more.
    Simplified(String),
    /// The file holds nothing coarser.
    File,
}

/// A level as it came out.
#[derive(Clone, Copy, Debug)]
pub struct Reached {
    /// Its vertices.
    pub vertex_count: usize,
    /// Its triangles.
    pub triangle_count: usize,
    /// Why it is this one.
    pub stop_reason: StopReason,
}

/// Why a level is not what was asked for; `None` if it is.
pub fn shortfall(target: Target, reached: Reached, floor: &Floor) -> Option<String> {
    let Reached { vertex_count, triangle_count, stop_reason } = reached;
    let (wanted, found) = match target {
        Target::Triangles(n) if triangle_count > n => (
            format!("at most {}", format_noun_count(n, "triangle", "triangles")),
            format!("{} are left", format_count(triangle_count)),
        ),
        Target::Vertices(n) if vertex_count > n => (
            format!("at most {}", format_noun_count(n, "vertex", "vertices")),
            format!("{} are left", format_count(vertex_count)),
        ),
        Target::SplitCount(n) if stop_reason == StopReason::FullMesh => {
            return Some(format!(
                "there are fewer than {} vertex splits: this is the full mesh",
                format_count(n)
            ));
        }
        Target::SplitCount(_) | Target::Detail(_)
            if matches!(stop_reason, StopReason::BaseReached | StopReason::ErrorLimit) =>
        {
            ("a coarser level".to_owned(), format!("{} triangles are left", format_count(triangle_count)))
        }
        _ => return None,
    };
    let why = match (floor, stop_reason) {
        (Floor::Simplified(_), StopReason::ErrorLimit) => "the next step would exceed the error limit",
        (Floor::Simplified(why), _) => why,
        (Floor::File, _) => "the file holds no coarser level",
    };
    Some(format!("asked for {wanted}, but {found}: {why}"))
}

/// A line for people about a level that is not what was asked for.
pub fn remark(name: Option<&str>, shortfall: &str) -> String {
    let level = name.map_or_else(|| "the level".to_owned(), |name| format!("level {name}"));
    format!("{level} was not reached: {shortfall}")
}

/// With `--strict`, a level that was not reached is a failure.
///
/// # Errors
/// If it was not and that is forbidden.
pub fn check_strict(is_strict: bool, name: Option<&str>, shortfall: Option<&str>) -> Result<(), Failure> {
    match shortfall.filter(|_| is_strict) {
        None => Ok(()),
        Some(shortfall) => Err(Failure::user(format!("--strict: {}", remark(name, shortfall)))
            .with_hint("leave --strict out to get the nearest level")),
    }
}

/// One of several levels, for people.
#[derive(Clone, Debug)]
pub struct LevelRow<'a> {
    /// As the user wrote it.
    pub name: &'a str,
    /// Its triangles.
    pub triangle_count: usize,
    /// Its vertices.
    pub vertex_count: usize,
    /// Its error, mesh units.
    pub error: f64,
    /// Where it went.
    pub path: &'a str,
    /// Why it is not what was asked for.
    pub shortfall: Option<&'a str>,
}

/// Several levels as a table, and below it those that were not reached.
pub fn table_of_levels(rows: &[LevelRow<'_>]) -> String {
    let mut table = Table::with_head(&["level", "triangles", "vertices", "error", "file"]);
    for row in rows {
        table.row(vec![
            row.name.to_owned(),
            format_count(row.triangle_count),
            format_count(row.vertex_count),
            format_length(row.error),
            row.path.to_owned(),
        ]);
    }
    let mut text = table.to_text();
    for row in rows {
        if let Some(shortfall) = row.shortfall {
            text.push_str(&remark(Some(row.name), shortfall));
            text.push('\n');
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(texts: &[&str]) -> Vec<Level> {
        texts.iter().map(|text| text.parse().expect("a level")).collect()
    }

    #[test]
    fn levels_name_their_files() {
        let paths = paths_of_levels(&levels(&["50%", "12.5 %", "500"]), Path::new("out/a-{}.glb"));
        let expected = ["out/a-50.glb", "out/a-12.5.glb", "out/a-500.glb"].map(PathBuf::from);
        assert_eq!(paths.expect("names"), expected);
        for (texts, output) in [
            (&["50%", "25%"][..], "a.glb"),
            (&["50%"], "-"),
            (&["50%", "50"], "a-{}.glb"),
            (&["50%", "50%"], "a-{}.glb"),
        ] {
            assert!(paths_of_levels(&levels(texts), Path::new(output)).is_err(), "{texts:?} to {output}");
        }
    }

    #[test]
    fn one_level_may_name_its_file() {
        let path = |text, output: &str| path_of_level(text, Path::new(output)).ok();
        assert_eq!(path(Some("0.1%"), "a-{}.ply"), Some("a-0.1.ply".into()));
        assert_eq!(path(Some("0.1%"), "a.ply"), Some("a.ply".into()));
        assert_eq!(path(None, "a.ply"), Some("a.ply".into()));
        assert_eq!(path(None, "a-{}.ply"), None);
    }

    #[test]
    fn what_is_not_reached_says_why() {
        let reached = |triangle_count, stop_reason| Reached { vertex_count: 60, triangle_count, stop_reason };
        let floor = Floor::Simplified("no edge can go".to_owned());
        let said = |target, reached| shortfall(target, reached, &floor);
        assert_eq!(said(Target::Triangles(100), reached(99, StopReason::TargetReached)), None);
        assert_eq!(said(Target::Triangles(1000), reached(99, StopReason::FullMesh)), None);
        let base = said(Target::Triangles(50), reached(99, StopReason::BaseReached)).expect("a shortfall");
        assert!(base.contains("99 are left") && base.ends_with("no edge can go"), "{base}");
        let limit = said(Target::Vertices(50), reached(99, StopReason::ErrorLimit)).expect("a shortfall");
        assert!(limit.contains("60 are left") && limit.ends_with("error limit"), "{limit}");
        assert!(said(Target::SplitCount(9), reached(99, StopReason::FullMesh)).is_some());
        assert_eq!(said(Target::Error(0.1), reached(99, StopReason::BaseReached)), None);
    }
}
