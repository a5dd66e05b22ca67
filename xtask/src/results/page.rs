//! Tables of a Markdown page that are preceded by a marker.
//!
//! ```text
//! <!-- table: strip-blocks
//! keys: mesh; stripifier; blocks of
//! json: strips = strip_count
//! -->
//!
//! striata strip $MESHES/{mesh}.* --strips {stripifier} [--block-triangles {blocks of}]     (in a code block)
//!
//! | mesh | stripifier | blocks of | strips |
//! ```
//!
//! The entries of a marker may also be in `docs/results/tables.txt`, after a line `table: NAME` and up to an
//! empty line, which keeps addresses out of what people read.
//!
//! * The command is in the code block between marker and table, or in an entry: `command: striata ...`, or
//!   `command of: NAME` if another table has it; `names` are then shared too.
//! * `keys:` are the columns that identify a row (by default the first one); an empty cell repeats the one
//!   above.
//! * `rows:` are prefixes of key cells, if only some rows can be checked.
//! * `check:` are columns that the commands print in a Markdown table with the same titles and keys.
//! * `json:` is for commands with `--json`: a column and the address of its value (`address.rs`), one column
//!   per line. Of several commands, the last one prints the JSON; those before it prepare temporary files.
//!   `at:` is the base of addresses that begin with a dot.
//! * `{column}` in a command or an address is replaced by the cell of the row. A part of a command in square
//!   brackets is omitted if its cell contains no number.
//! * `names: dragon = dragon.ply; cow = cow.obj` maps cells to the names that the command uses.

use anyhow::{Context, Result, bail, ensure};

use super::cells::{argument, label};

/// A table of a page with its marker.
#[derive(Debug, Default)]
pub(super) struct DocTable {
    pub name: String,
    pub page: String,
    /// Line of the marker, counted from 1.
    pub line: usize,
    pub commands: Vec<String>,
    /// Name of the table whose commands this one shares.
    command_of: Option<String>,
    pub keys: Vec<String>,
    pub checked: Vec<String>,
    pub beginnings: Vec<String>,
    pub addresses: Vec<(String, String)>,
    pub base: String,
    names: Vec<(String, String)>,
    pub head: Vec<String>,
    pub rows: Vec<Row>,
}

/// A row of a table.
#[derive(Debug)]
pub(super) struct Row {
    /// Line of the row, counted from 1.
    pub line: usize,
    cells: Vec<String>,
}

/// Returns the marked tables of a page; `entries` is the text of `tables.txt`.
///
/// # Errors
/// If a marker cannot be parsed, or is not followed by a table with its columns.
pub(super) fn tables_of(page: &str, text: &str, entries: &str) -> Result<Vec<DocTable>> {
    let lines: Vec<&str> = text.lines().collect();
    let starts = (0..lines.len()).filter(|&at| lines[at].starts_with("<!-- table:"));
    let table =
        |at: usize| DocTable::read(page, &lines, at, entries).with_context(|| format!("{page}:{}", at + 1));
    starts.map(table).collect()
}

/// Copies commands and names to the tables that share those of another table.
///
/// # Errors
/// If there is no such table.
pub(super) fn share_commands(tables: &mut [DocTable]) -> Result<()> {
    for at in 0..tables.len() {
        let Some(name) = tables[at].command_of.clone() else { continue };
        let other = tables.iter().find(|table| table.name == name && table.command_of.is_none());
        let other = other.with_context(|| format!("no table `{name}`"))?;
        let (commands, names) = (other.commands.clone(), other.names.clone());
        tables[at].commands = commands;
        tables[at].names.extend(names);
    }
    Ok(())
}

impl DocTable {
    fn read(page: &str, lines: &[&str], start: usize, entries: &str) -> Result<Self> {
        let mut table = Self { page: page.to_owned(), line: start + 1, ..Self::default() };
        let length =
            lines[start..].iter().position(|line| line.contains("-->")).context("the marker has no end")?;
        for line in &lines[start..=start + length] {
            let line = line.trim_start_matches("<!--").trim().trim_end_matches("-->").trim();
            if !line.is_empty() {
                table.parse_line(line)?;
            }
        }
        for line in entries_of(entries, &table.name) {
            table.parse_line(line)?;
        }
        let mut at = start + length + 1;
        while !lines.get(at).context("no table follows the marker")?.starts_with('|') {
            if lines[at].starts_with("```") && table.commands.is_empty() {
                let end = lines[at + 1..]
                    .iter()
                    .position(|line| line.starts_with("```"))
                    .context("open code block")?;
                table.commands = commands_of(&lines[at + 1..at + 1 + end]);
                at += end + 1;
            }
            ensure!(!lines[at].starts_with("<!-- table:"), "there is another marker before the table");
            at += 1;
        }
        table.head = cells_of(lines[at]);
        let body = lines.iter().enumerate().skip(at + 2).take_while(|(_, line)| line.starts_with('|'));
        table.rows = body.map(|(at, line)| Row { line: at + 1, cells: cells_of(line) }).collect();
        if table.keys.is_empty() {
            table.keys.extend(table.head.first().cloned());
        }
        table.repeat_keys()?;
        for column in table.checked.iter().chain(table.addresses.iter().map(|(column, _)| column)) {
            column_of(&table.head, column)?;
        }
        Ok(table)
    }

    /// Parses a line of the marker.
    fn parse_line(&mut self, line: &str) -> Result<()> {
        let (word, rest) = line.split_once(':').context("a line of the marker has no colon")?;
        let rest = rest.trim();
        let list = || rest.split("; ").map(|name| name.trim().to_owned());
        let pair = |text: &str| {
            let pair = text.split_once(" =").map(|(a, b)| (a.trim().to_owned(), b.trim().to_owned()));
            pair.with_context(|| format!("`{text}` is not of the form A = B"))
        };
        match word.trim() {
            "table" => self.name = rest.to_owned(),
            "command" => self.commands.push(rest.to_owned()),
            "command of" => self.command_of = Some(rest.to_owned()),
            "keys" => self.keys = list().collect(),
            "rows" => self.beginnings = list().collect(),
            "at" => self.base = rest.to_owned(),
            "check" => self.checked = list().collect(),
            "json" => self.addresses.push(pair(rest)?),
            "names" => self.names = rest.split("; ").map(pair).collect::<Result<_>>()?,
            other => bail!("unknown entry `{other}` in the marker"),
        }
        Ok(())
    }

    fn repeat_keys(&mut self) -> Result<()> {
        for key in &self.keys {
            let column = column_of(&self.head, key)?;
            let mut above = String::new();
            for row in &mut self.rows {
                let cell = row.cells.get_mut(column).context("a row is too short")?;
                if cell.is_empty() { cell.clone_from(&above) } else { above.clone_from(cell) }
            }
        }
        Ok(())
    }

    /// Whether the table can be compared with the output of its commands.
    pub(super) fn is_checkable(&self) -> bool {
        !self.checked.is_empty() || !self.addresses.is_empty()
    }

    pub(super) fn cell(&self, row: &Row, column: &str) -> String {
        let at = self.head.iter().position(|title| title == column);
        at.and_then(|at| row.cells.get(at)).cloned().unwrap_or_default()
    }

    pub(super) fn renamed(&self, name: String) -> String {
        self.names.iter().find(|(from, _)| *from == name).map_or(name, |(_, to)| to.clone())
    }

    /// Replaces the placeholders of a template by the cells of a row.
    pub(super) fn filled(&self, template: &str, row: &Row) -> Result<String> {
        let mut text = String::new();
        let mut rest = template;
        while let Some((before, after)) = rest.split_once('{') {
            let (column, after) = after.split_once('}').context("a brace is not closed")?;
            column_of(&self.head, column)?;
            text.push_str(before);
            text.push_str(&self.renamed(argument(&self.cell(row, column))));
            rest = after;
        }
        text.push_str(rest);
        Ok(text)
    }
}

/// Returns the lines about a table: those from `table: NAME` to the next empty line.
fn entries_of<'t>(entries: &'t str, name: &str) -> impl Iterator<Item = &'t str> + use<'t> {
    let is_start = move |line: &&str| line.strip_prefix("table: ") == Some(name);
    let from = entries.lines().position(|line| is_start(&line)).map_or(usize::MAX, |at| at + 1);
    entries.lines().skip(from).take_while(|line| !line.is_empty())
}

/// Returns the commands of a code block, with continued lines joined and comments removed.
fn commands_of(lines: &[&str]) -> Vec<String> {
    let mut commands: Vec<String> = Vec::new();
    let mut is_continued = false;
    for line in lines {
        let line = line.split(" #").next().unwrap_or_default().trim();
        let (line, continues) = line.strip_suffix('\\').map_or((line, false), |line| (line.trim(), true));
        match commands.last_mut() {
            Some(last) if is_continued => {
                last.push(' ');
                last.push_str(line);
            }
            _ if !line.is_empty() && !line.starts_with('#') => commands.push(line.to_owned()),
            _ => (),
        }
        is_continued = continues;
    }
    commands
}

/// Returns the cells of a line.
pub(super) fn cells_of(line: &str) -> Vec<String> {
    let line = line.trim();
    let inner = line.strip_prefix('|').unwrap_or(line);
    let inner = inner.strip_suffix('|').unwrap_or(inner);
    inner.split('|').map(label).collect()
}

/// Returns the index of the column with a title.
///
/// # Errors
/// If there is no such column, or more than one.
pub(super) fn column_of(head: &[String], title: &str) -> Result<usize> {
    let mut indices = (0..head.len()).filter(|&at| head[at] == title);
    let index = indices.next().with_context(|| format!("there is no column `{title}`"))?;
    ensure!(indices.next().is_none(), "there are two columns `{title}`");
    Ok(index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn malformed_markers_are_refused() {
        let table = "| a |\n| - |\n| 1 |\n";
        let read = |marker: &str| tables_of("a.md", &format!("<!-- table: t\n{marker}\n-->\n{table}"), "");
        assert!(read("check: a").is_ok());
        for wrong in ["check: b", "keys: b", "json: a", "color: red", "nothing"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn commands_can_be_shared_and_continued() {
        let page = "<!-- table: a\n-->\n```sh\n# first\nstriata a \\\n    b\nstriata c # d\n```\n| x |\n| \
            - |\n\
            <!-- table: b\ncommand of: a\n-->\n| x |\n| - |\n";
        let mut tables = tables_of("a.md", page, "table: a\nnames: p = q\n\ntable: b\nkeys: x\n").unwrap();
        share_commands(&mut tables).unwrap();
        assert_eq!(tables[1].commands, ["striata a b", "striata c"]);
        assert_eq!(tables[1].renamed("p".to_owned()), "q");
        assert_eq!(tables[1].keys, ["x"]);
        assert!(!tables[1].is_checkable());
    }
}
