//! Verifies the tables in the docs: runs their commands and compares counts and sizes with the page.
//!
//! A marker before a table states what can be compared; `page.rs` documents and parses it, `check.rs`
//! compares. No code here depends on a particular table.

mod address;
mod cells;
mod check;
mod page;
mod source;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use clap::Args;

use self::check::Correction;
use self::page::{DocTable, tables_of};
use self::source::Commands;
use crate::steps::say;
use crate::workspace;

/// Pages with tables, relative to the workspace, in addition to all pages in `docs`.
const PAGES: [&str; 2] = ["README.md", "web/README.md"];

/// Entries about tables that their markers leave out, relative to the workspace.
const ENTRIES: &str = "docs/results/tables.txt";

/// Arguments of `cargo xtask results`.
#[derive(Debug, Args)]
#[command(group = clap::ArgGroup::new("what").required(true))]
pub(crate) struct ResultsArgs {
    /// List all marked tables with their commands
    #[arg(long, group = "what")]
    list: bool,
    /// Run the commands of these tables and compare counts and sizes with the docs [default: all tables]
    #[arg(long, group = "what", value_name = "TABLE", num_args = 0..)]
    check: Option<Vec<String>>,
    /// Write the measured values into the pages instead of reporting differences
    #[arg(long, requires = "check")]
    write: bool,
    /// Folder that `$MESHES` stands for in commands
    #[arg(long, value_name = "DIR")]
    meshes: Option<PathBuf>,
    /// Use this `striata` instead of a release build of this workspace
    #[arg(long, value_name = "PATH")]
    striata: Option<PathBuf>,
}

/// Lists or checks tables.
///
/// # Errors
/// If a page or marker cannot be read, a command fails, or a cell differs and is not to be written.
pub(crate) fn run(args: &ResultsArgs) -> Result<()> {
    let tables = all_tables()?;
    if args.list {
        tables.iter().for_each(|table| say(&list_entry(table)));
        return Ok(());
    }
    let mut chosen: Vec<&DocTable> = Vec::new();
    for name in args.check.iter().flatten() {
        let table = tables.iter().find(|table| table.name == *name);
        chosen.push(table.with_context(|| format!("no table `{name}`; see `cargo xtask results --list`"))?);
    }
    if chosen.is_empty() {
        chosen.extend(tables.iter().filter(|table| table.is_checkable()));
    }
    let mut commands = Commands::new(args.meshes.as_deref(), args.striata.as_deref())?;
    let (mut cell_count, mut differences, mut corrections) = (0, Vec::new(), Vec::new());
    for table in chosen {
        ensure!(
            table.is_checkable(),
            "table `{}` has no `check` or `json` columns, because it only contains times",
            table.name
        );
        let checked = table.check(&mut |words| commands.output(words));
        let checked = checked.with_context(|| format!("table `{}`", table.name))?;
        let count = checked.differences.len();
        say(&format!("{}: {} cells compared, {count} differ", table.name, checked.cell_count));
        checked.differences.iter().for_each(|line| say(line));
        cell_count += checked.cell_count;
        differences.extend(checked.differences);
        corrections.extend(checked.corrections);
    }
    if args.write {
        write(&corrections)?;
        say(&format!("{} of {} cells that differed were written", corrections.len(), differences.len()));
        return Ok(());
    }
    ensure!(differences.is_empty(), "{} of {cell_count} cells differ from the docs", differences.len());
    say(&format!("all {cell_count} cells match the docs"));
    Ok(())
}

/// Replaces cells in the pages.
fn write(corrections: &[Correction]) -> Result<()> {
    let mut pages: BTreeMap<&str, Vec<&Correction>> = BTreeMap::new();
    for correction in corrections {
        pages.entry(&correction.page).or_default().push(correction);
    }
    for (page, corrections) in pages {
        let path = workspace().join(page);
        let mut lines: Vec<String> = std::fs::read_to_string(&path)?.lines().map(str::to_owned).collect();
        for correction in corrections {
            let line = lines.get_mut(correction.line - 1).context("the page has changed")?;
            *line = with_cell(line, correction);
        }
        std::fs::write(&path, lines.join("\n") + "\n")?;
    }
    Ok(())
}

/// Returns the row of a Markdown table with one cell replaced.
fn with_cell(line: &str, correction: &Correction) -> String {
    let mut cells: Vec<String> = line.split('|').map(str::to_owned).collect();
    // The first part is empty: a row begins with a bar.
    if let Some(cell) = cells.get_mut(correction.column_index + 1) {
        *cell = format!(" {} ", correction.cell);
    }
    cells.join("|")
}

fn list_entry(table: &DocTable) -> String {
    let what = if table.is_checkable() { "checked" } else { "times only" };
    format!("{} ({what}), {}:{}\n    {}", table.name, table.page, table.line, table.commands.join("\n    "))
}

fn all_tables() -> Result<Vec<DocTable>> {
    let mut pages: Vec<PathBuf> = PAGES.iter().map(PathBuf::from).collect();
    add_pages(Path::new("docs"), &mut pages)?;
    let mut tables: Vec<DocTable> = Vec::new();
    let entries = std::fs::read_to_string(workspace().join(ENTRIES))?;
    for page in pages {
        let text = std::fs::read_to_string(workspace().join(&page))?;
        tables.extend(tables_of(&page.to_string_lossy(), &text, &entries)?);
    }
    page::share_commands(&mut tables)?;
    Ok(tables)
}

/// Adds the Markdown files of a folder and its subfolders, sorted.
fn add_pages(folder: &Path, pages: &mut Vec<PathBuf>) -> Result<()> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(workspace().join(folder))? {
        names.push(entry?.file_name());
    }
    names.sort();
    for name in names {
        let path = folder.join(name);
        if workspace().join(&path).is_dir() {
            add_pages(&path, pages)?;
        } else if path.extension().is_some_and(|extension| extension == "md") {
            pages.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_markers_of_the_docs_are_valid() {
        let tables = all_tables().unwrap();
        assert!(tables.iter().any(DocTable::is_checkable));
        for table in &tables {
            assert!(!table.commands.is_empty(), "{} has no command", table.name);
            let same_name = tables.iter().filter(|other| other.name == table.name);
            assert_eq!(same_name.count(), 1, "{} occurs twice", table.name);
        }
        let entries = std::fs::read_to_string(workspace().join(ENTRIES)).unwrap();
        for name in entries.lines().filter_map(|line| line.strip_prefix("table: ")) {
            assert!(tables.iter().any(|table| table.name == name), "no page has the table {name}");
        }
    }
}
