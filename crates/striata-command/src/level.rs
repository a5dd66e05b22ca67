//! Requested levels: their targets, the files that they are written to, and whether they were reached.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde::Serialize;
use striata::mesh::{IndexedMesh, LevelTable, MeshError, weld};
use striata::simplify::{StopReason, Target};

use crate::args::{Count, Level, LevelArgs, LevelsArgs};
use crate::failure::Failure;
use crate::output::{Table, format_count, format_length, format_noun_count};
use crate::save::display_name;

/// Placeholder for the level in the name of an output file.
const PLACEHOLDER: &str = "{}";
/// Placeholder for the number of the level, from 0, as engines count: `LOD0`.
const NUMBER: &str = "{i}";

/// Sizes of the full mesh, which percentages of targets refer to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FullMesh {
    /// Diagonal of the bounding box, mesh units.
    pub diagonal: f64,
    /// Number of vertices after equal ones were merged.
    pub vertex_count: usize,
    /// Number of triangles, without degenerate ones.
    pub triangle_count: usize,
}

impl FullMesh {
    /// Returns the sizes of a mesh after welding, as `simplify` and `build` use it.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub fn of(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        let welded = weld(mesh)?.mesh;
        let (vertex_count, triangle_count) = (welded.vertex_count(), welded.triangle_count());
        Ok(Self { diagonal: mesh.diagonal(), vertex_count, triangle_count })
    }

    /// Returns the sizes of the finest level, with a diagonal that the caller knows.
    pub fn of_levels(levels: &LevelTable, diagonal: f64) -> Self {
        let last = levels.step_count();
        let (vertex_count, triangle_count) = (levels.vertex_count_at(last), levels.triangle_count_at(last));
        Self { diagonal, vertex_count, triangle_count }
    }
}

impl LevelArgs {
    /// Returns the target if one was given, with lengths in mesh units.
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

    /// Whether the target is a percentage, which depends on the size of the full mesh.
    pub fn has_share(&self) -> bool {
        self.triangle_count().or(self.vertices).is_some_and(Count::is_share)
    }
}

impl LevelsArgs {
    /// Whether any level is a percentage, which depends on the size of the full mesh.
    pub fn has_share(&self) -> bool {
        self.levels.iter().flatten().any(|level| level.triangles.is_share())
    }
}

/// A requested level and the file that it is written to.
#[derive(Clone, Debug)]
pub struct LevelRequest {
    /// The text that the user wrote for this level, if there are several.
    pub name: Option<String>,
    /// The target of the level; `None` requests the coarsest level.
    pub target: Option<Target>,
    /// The output file.
    pub path: PathBuf,
}

/// Returns all requested levels in the order of the user, with their output files.
///
/// # Errors
/// If several levels would be written to the same file, or a file name has a placeholder and there is no
/// level for it.
pub fn level_requests(
    level: &LevelArgs,
    levels: &LevelsArgs,
    full: FullMesh,
    output: &Path,
) -> Result<Vec<LevelRequest>, Failure> {
    match &levels.levels {
        Some(names) => {
            let paths = paths_of(names, levels.lod_chain, output)?;
            let target = |level: &Level| Target::Triangles(level.triangles.of_triangles(full.triangle_count));
            let requests = names.iter().zip(paths).map(|(level, path)| LevelRequest {
                name: Some(level.text.clone()),
                target: Some(target(level)),
                path,
            });
            Ok(requests.collect())
        }
        None => {
            let path = path_of_level(level.text().as_deref(), output)?;
            Ok(vec![LevelRequest { name: None, target: level.target(full), path }])
        }
    }
}

/// Returns the output files in the order of the levels, so that their names can be checked before the work
/// begins.
///
/// # Errors
/// Under the same conditions as [`level_requests`].
pub fn check_paths(level: &LevelArgs, levels: &LevelsArgs, output: &Path) -> Result<Vec<PathBuf>, Failure> {
    match &levels.levels {
        Some(names) => paths_of(names, levels.lod_chain, output),
        None => Ok(vec![path_of_level(level.text().as_deref(), output)?]),
    }
}

fn paths_of(levels: &[Level], is_chain: bool, output: &Path) -> Result<Vec<PathBuf>, Failure> {
    if is_chain {
        Ok(vec![path_of_level(None, output)?; levels.len()])
    } else {
        paths_of_levels(levels, output)
    }
}

/// Returns the output file of each level: `{}` in the name becomes the level.
///
/// # Errors
/// If the name has no `{}`, or several levels would be written to the same file.
pub fn paths_of_levels(levels: &[Level], output: &Path) -> Result<Vec<PathBuf>, Failure> {
    let is_pattern = |pattern: &&str| pattern.contains(PLACEHOLDER) || pattern.contains(NUMBER);
    let Some(pattern) = output.to_str().filter(is_pattern) else {
        let hint = match (output.file_stem(), output.extension()) {
            (Some(stem), Some(extension)) if output != Path::new("-") => {
                let name =
                    format!("{}-{PLACEHOLDER}.{}", stem.to_string_lossy(), extension.to_string_lossy());
                output.with_file_name(name).display().to_string()
            }
            _ => format!("level-{PLACEHOLDER}.glb"),
        };
        return Err(Failure::usage(format!(
            "{}: --levels needs {PLACEHOLDER} in the output name",
            output.display()
        ))
        .with_hint(format!(
            "{PLACEHOLDER} is replaced by the level, and {NUMBER} by its number from 0: -o '{hint}'"
        )));
    };
    let mut seen = BTreeSet::new();
    let mut paths = Vec::new();
    for (number, level) in levels.iter().enumerate() {
        let name = pattern.replace(NUMBER, &number.to_string()).replace(PLACEHOLDER, &file_part(&level.text));
        let path = PathBuf::from(name);
        if !seen.insert(path.clone()) {
            return Err(Failure::usage(format!(
                "{}: several levels would be written to this file",
                path.display()
            ))
            .with_hint(format!("remove {}, or write it with a separate command", level.text)));
        }
        paths.push(path);
    }
    Ok(paths)
}

/// Returns the output path with the placeholder replaced by the text of the level.
///
/// # Errors
/// If the path has a placeholder and the level has no text.
fn path_of_level(text: Option<&str>, output: &Path) -> Result<PathBuf, Failure> {
    match (output.to_str().filter(|pattern| pattern.contains(PLACEHOLDER)), text) {
        (None, _) => Ok(output.to_owned()),
        (Some(pattern), Some(text)) => Ok(PathBuf::from(pattern.replace(PLACEHOLDER, &file_part(text)))),
        (Some(pattern), None) => Err(Failure::usage(format!(
            "{pattern}: {PLACEHOLDER} stands for a level, but none of \
                --triangles, --ratio and the like was given"
        ))
        .with_hint(format!("remove {PLACEHOLDER} from the name"))),
    }
}

/// Converts the text of a level to a part of a file name: `50%` becomes `50`.
fn file_part(text: &str) -> String {
    let is_allowed = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '_');
    let number = text.trim_end_matches('%').trim();
    number.chars().map(|c| if is_allowed(c) { c } else { '-' }).collect()
}

/// Why no coarser level exists than the coarsest one.
#[derive(Clone, Debug)]
pub enum CoarseningLimit {
    /// The mesh was simplified as far as possible; the text says what prevents more.
    Simplification(String),
    /// The file contains no coarser level.
    File,
}

/// The level that was reached for a target.
#[derive(Clone, Copy, Debug)]
pub struct ReachedLevel {
    /// Number of vertices.
    pub vertex_count: usize,
    /// Number of triangles.
    pub triangle_count: usize,
    /// Why the level is neither finer nor coarser.
    pub stop_reason: StopReason,
}

/// Explains how a level misses its target; `None` if it meets it.
pub fn shortfall(target: Target, reached: ReachedLevel, limit: &CoarseningLimit) -> Option<String> {
    let ReachedLevel { vertex_count, triangle_count, stop_reason } = reached;
    if stop_reason == StopReason::InputEnded {
        return Some("the input ends before this level".to_owned());
    }
    let (requested, found) = match target {
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
                "there are fewer than {} vertex splits; this is the full mesh",
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
    let why = match (limit, stop_reason) {
        (CoarseningLimit::Simplification(_), StopReason::ErrorLimit) => {
            "the next step would exceed the error limit"
        }
        (CoarseningLimit::Simplification(why), _) => why,
        (CoarseningLimit::File, _) => "the file has no coarser level",
    };
    Some(format!("requested {requested}, but {found}: {why}"))
}

/// Error limits beyond this share of the diagonal are likely meant in another unit.
const LARGE_ERROR: f64 = 0.05;

/// Warns of an error limit, as a share of the diagonal, that leaves less than a hundredth of the triangles because it is
/// large. Smaller ones leave as little only of surfaces that are simple, such as boxes.
pub fn large_error_warning(share: f64, triangle_count: usize, full_count: usize) -> Option<String> {
    let is_large = share > LARGE_ERROR && triangle_count.saturating_mul(100) < full_count;
    is_large.then(|| {
        format!(
            "the error limit is {:.0}% of the diagonal, and {} of {} triangles are left; limits of 0.1% to 2% are usual",
            share * 100.0,
            format_count(triangle_count),
            format_count(full_count)
        )
    })
}

/// Formats a message about a level that misses its target.
pub fn shortfall_note(name: Option<&str>, shortfall: &str) -> String {
    let level = name.map_or_else(|| "the level".to_owned(), |name| format!("level {name}"));
    format!("{level} was not reached: {shortfall}")
}

/// Turns a level that misses its target into a failure if `--strict` was given.
///
/// # Errors
/// If `is_strict` is set and there is a shortfall.
pub fn check_strict(is_strict: bool, name: Option<&str>, shortfall: Option<&str>) -> Result<(), Failure> {
    match shortfall.filter(|_| is_strict) {
        None => Ok(()),
        Some(shortfall) => Err(Failure::user(format!("--strict: {}", shortfall_note(name, shortfall)))
            .with_hint("remove --strict to get the closest level")),
    }
}

/// A level that a verb has written, as far as all verbs report it.
#[derive(Clone, Debug, Serialize)]
pub struct WrittenLevel {
    /// The text that the user wrote for the level, if there are several.
    #[serde(rename = "level", skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The output file.
    pub path: String,
    /// Number of vertices; those of a mesh of a scene count once.
    pub vertex_count: usize,
    /// Number of triangles; those of a mesh of a scene count once for each instance.
    pub triangle_count: usize,
    /// Largest error, mesh units; null for a view of a scene.
    pub error: Option<f64>,
    /// Why the level is neither finer nor coarser.
    pub stop_reason: &'static str,
    /// How the level misses its target; null if it does not.
    pub shortfall: Option<String>,
    /// Why the target may not be what the user meant.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub warning: Option<String>,
}

impl WrittenLevel {
    /// Creates the report on a level for a request, without its error.
    pub fn new(request: &LevelRequest, reached: ReachedLevel, limit: &CoarseningLimit) -> Self {
        Self {
            name: request.name.clone(),
            path: display_name(&request.path),
            vertex_count: reached.vertex_count,
            triangle_count: reached.triangle_count,
            error: None,
            stop_reason: reached.stop_reason.as_str(),
            shortfall: request.target.and_then(|target| shortfall(target, reached, limit)),
            warning: None,
        }
    }

    /// Gives an error that is a number in single precision the digits that it needs there.
    #[must_use]
    pub fn with_short_error(self) -> Self {
        let shortened = |error: f64| {
            let single = error as f32;
            if f64::from(single) == error { single.to_string().parse().unwrap_or(error) } else { error }
        };
        Self { error: self.error.map(shortened), ..self }
    }

    /// Turns a missed target into a failure if `--strict` was given.
    ///
    /// # Errors
    /// If `is_strict` is set and there is a shortfall.
    pub fn check_strict(&self, is_strict: bool) -> Result<(), Failure> {
        check_strict(is_strict, self.name.as_deref(), self.shortfall.as_deref())
    }

    /// Why the level is neither finer nor coarser, in words.
    pub fn stop_text(&self) -> String {
        self.stop_reason.replace('_', " ")
    }

    /// A line about a missed target, after the line break that ends what is before it; empty if it is met.
    pub fn note(&self) -> String {
        self.shortfall.as_deref().map_or_else(String::new, |text| format!("\n{}", shortfall_note(None, text)))
    }
}

/// Formats several levels as a table, followed by messages about those that miss their target.
pub fn table_of_levels<'l>(levels: impl Iterator<Item = &'l WrittenLevel> + Clone) -> String {
    let mut table = Table::with_head(&["level", "triangles", "vertices", "error", "file"]);
    for level in levels.clone() {
        table.row(vec![
            level.name.clone().unwrap_or_default(),
            format_count(level.triangle_count),
            format_count(level.vertex_count),
            format_length(level.error.unwrap_or_default()),
            level.path.clone(),
        ]);
    }
    let mut text = table.to_text();
    for level in levels {
        if let Some(shortfall) = &level.shortfall {
            text.push_str(&shortfall_note(level.name.as_deref(), shortfall));
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
    fn each_level_has_its_own_file() {
        let numbered = paths_of_levels(&levels(&["50%", "20%"]), Path::new("tree_LOD{i}.glb"));
        assert_eq!(numbered.expect("names"), ["tree_LOD0.glb", "tree_LOD1.glb"].map(PathBuf::from));
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
    fn a_single_level_may_fill_the_placeholder() {
        let path = |text, output: &str| path_of_level(text, Path::new(output)).ok();
        assert_eq!(path(Some("0.1%"), "a-{}.ply"), Some("a-0.1.ply".into()));
        assert_eq!(path(Some("0.1%"), "a.ply"), Some("a.ply".into()));
        assert_eq!(path(None, "a.ply"), Some("a.ply".into()));
        assert_eq!(path(None, "a-{}.ply"), None);
    }

    #[test]
    fn a_shortfall_gives_the_reason() {
        let reached =
            |triangle_count, stop_reason| ReachedLevel { vertex_count: 60, triangle_count, stop_reason };
        let limit = CoarseningLimit::Simplification("no edge can be collapsed".to_owned());
        let message = |target, reached| shortfall(target, reached, &limit);
        assert_eq!(message(Target::Triangles(100), reached(99, StopReason::TargetReached)), None);
        assert_eq!(message(Target::Triangles(1000), reached(99, StopReason::FullMesh)), None);
        let base = message(Target::Triangles(50), reached(99, StopReason::BaseReached)).expect("a shortfall");
        assert!(base.contains("99 are left") && base.ends_with("no edge can be collapsed"), "{base}");
        let error_limit =
            message(Target::Vertices(50), reached(99, StopReason::ErrorLimit)).expect("a shortfall");
        assert!(error_limit.contains("60 are left") && error_limit.ends_with("error limit"), "{error_limit}");
        assert!(message(Target::SplitCount(9), reached(99, StopReason::FullMesh)).is_some());
        assert_eq!(message(Target::Error(0.1), reached(99, StopReason::BaseReached)), None);
    }

    #[test]
    fn a_large_error_limit_is_questioned_only_if_little_is_left() {
        let warning = large_error_warning(0.4, 2, 5856).expect("a warning");
        assert!(warning.contains("40% of the diagonal") && warning.contains("2 of 5,856"), "{warning}");
        assert_eq!(large_error_warning(0.4, 59, 5856), None);
        assert_eq!(large_error_warning(0.01, 2, 5856), None);
        assert_eq!(large_error_warning(f64::NAN, 0, 0), None);
    }
}
