//! Tables of a Markdown page that a marker stands in front of.
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
//! * The command stands in the code block between marker and table, or in the marker: `command: striata ...`, or
//!   `command of: NAME` if another table has it.
//! * `keys:` are the columns that tell rows apart (the first one if nothing is said); an empty cell there repeats the one above.
//! * `rows:` are the beginnings of key cells if only some rows can be checked.
//! * `check:` names columns that the commands print in a Markdown table with the same titles and keys.
//! * `json:` is for commands that take `--json`: a column and the address of its value (`address.rs`), one column a line. Of
//!   several commands the last one is asked; those before it prepare files in a scratch folder.
//!   `at:` is an address that those beginning with a dot go on from.
//! * `{column}` in a command or an address is the row's cell. A part of a command in square brackets is left out if the
//!   cell in it holds no number. `names: dragon = dragon.ply; cow = cow.obj` replaces what a cell says by what the command calls it.

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use super::address::values;
use super::cells::{argument, label, numbers, shows, shows_printed};

/// A table of a page with its marker.
#[derive(Debug, Default)]
pub(super) struct DocTable {
    pub(super) name: String,
    pub(super) page: String,
    /// Line of the marker, from 1.
    pub(super) line: usize,
    pub(super) commands: Vec<String>,
    /// The table that has the command, if this one has not.
    command_of: Option<String>,
    keys: Vec<String>,
    checked: Vec<String>,
    beginnings: Vec<String>,
    addresses: Vec<(String, String)>,
    base: String,
    names: Vec<(String, String)>,
    head: Vec<String>,
    rows: Vec<Row>,
}

#[derive(Debug)]
struct Row {
    line: usize,
    cells: Vec<String>,
}

/// What a check found.
#[derive(Debug, Default)]
pub(super) struct Checked {
    pub(super) cell_count: usize,
    /// A line for each cell that differs.
    pub(super) differences: Vec<String>,
}

/// The marked tables of a page.
///
/// # Errors
/// If a marker cannot be read, or no table with its columns follows.
pub(super) fn tables_of(page: &str, text: &str) -> Result<Vec<DocTable>> {
    let lines: Vec<&str> = text.lines().collect();
    let starts = (0..lines.len()).filter(|&at| lines[at].starts_with("<!-- table:"));
    let table = |at: usize| DocTable::read(page, &lines, at).with_context(|| format!("{page}:{}", at + 1));
    starts.map(table).collect()
}

/// Gives tables the commands of those that they name.
///
/// # Errors
/// If there is no such table.
pub(super) fn share_commands(tables: &mut [DocTable]) -> Result<()> {
    for at in 0..tables.len() {
        let Some(name) = tables[at].command_of.clone() else { continue };
        let other = tables.iter().find(|table| table.name == name && table.command_of.is_none());
        tables[at].commands = other.with_context(|| format!("no table `{name}`"))?.commands.clone();
    }
    Ok(())
}

impl DocTable {
    fn read(page: &str, lines: &[&str], start: usize) -> Result<Self> {
        let mut table = Self { page: page.to_owned(), line: start + 1, ..Self::default() };
        let length =
            lines[start..].iter().position(|line| line.contains("-->")).context("the marker has no end")?;
        for line in &lines[start..=start + length] {
            let line = line.trim_start_matches("<!--").trim().trim_end_matches("-->").trim();
            if !line.is_empty() {
                table.take(line)?;
            }
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
            ensure!(!lines[at].starts_with("<!-- table:"), "another marker stands in front of the table");
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

    /// Takes a line of the marker.
    fn take(&mut self, line: &str) -> Result<()> {
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
            other => bail!("the marker says `{other}`, which means nothing"),
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

    /// Whether a command can tell if it is right.
    pub(super) fn is_checkable(&self) -> bool {
        !self.checked.is_empty() || !self.addresses.is_empty()
    }

    /// Compares the table with what its commands print.
    ///
    /// # Errors
    /// If a command fails or prints something else than a table or JSON with the row's values.
    pub(super) fn check(&self, output: &mut dyn FnMut(&str) -> Result<String>) -> Result<Checked> {
        let mut found = Checked::default();
        for row in self.rows.iter().filter(|row| self.is_wanted(row)) {
            let lines = self
                .commands
                .iter()
                .map(|command| self.filled(command, row).map(|line| without_options(&line)));
            let lines = lines.collect::<Result<Vec<_>>>()?;
            let mut differs = |column: &str, cell: &str, measured: &str| {
                let keys: Vec<String> = self.keys.iter().map(|key| self.cell(row, key)).collect();
                found.differences.push(format!(
                    "{}:{}: {}: {}: {column}: the page says `{cell}`, the command `{measured}`",
                    self.page,
                    row.line,
                    self.name,
                    keys.join(", ")
                ));
            };
            for (column, address) in &self.addresses {
                let cell = self.cell(row, column);
                if numbers(&cell).is_empty() {
                    continue;
                }
                let (line, first) = lines.split_last().context("there is no command")?;
                first.iter().try_for_each(|line| output(line).map(drop))?;
                let json: Value = serde_json::from_str(&output(&format!("{line} --json"))?)?;
                let address = self.filled(address, row)?;
                match values(&json, &self.filled(&self.base, row)?, &address) {
                    Ok(measured) if shows(&cell, &measured) => (),
                    Ok(measured) => differs(column, &cell, &format!("{measured:?}")),
                    Err(error) => differs(column, &cell, &format!("nothing: {error:#}")),
                }
                found.cell_count += 1;
            }
            for column in &self.checked {
                let cell = self.cell(row, column);
                let printed = self.printed_cell(&lines, row, column, output)?;
                found.cell_count += 1;
                match printed {
                    Some(printed) if shows_printed(&cell, &printed) => (),
                    Some(printed) => differs(column, &cell, &printed),
                    None => differs(column, &cell, "nothing: no such row"),
                }
            }
        }
        Ok(found)
    }

    fn is_wanted(&self, row: &Row) -> bool {
        let begins =
            |key: &String| self.beginnings.iter().any(|b| self.cell(row, key).starts_with(b.as_str()));
        self.beginnings.is_empty() || self.keys.iter().any(begins)
    }

    /// The cell of a column in the printed row that has the same keys.
    fn printed_cell(
        &self,
        lines: &[String],
        row: &Row,
        column: &str,
        output: &mut dyn FnMut(&str) -> Result<String>,
    ) -> Result<Option<String>> {
        let mut tables = Vec::new();
        for line in lines {
            tables.extend(printed_tables(&output(line)?));
        }
        // The most alike first: a command may print two tables with some of the same titles.
        tables.sort_by_key(|(head, _)| head.iter().filter(|title| !self.head.contains(title)).count());
        for (head, rows) in tables {
            let Ok(at) = column_of(&head, column) else { continue };
            let keys = self.keys.iter().map(|key| column_of(&head, key)).collect::<Result<Vec<_>>>();
            let Ok(keys) = keys else { continue };
            let is_same = |cells: &&Vec<String>| {
                let printed = |&at: &usize| cells.get(at).map(|cell| argument(cell));
                let wanted = self.keys.iter().map(|key| Some(self.renamed(argument(&self.cell(row, key)))));
                keys.iter().map(printed).eq(wanted)
            };
            if let Some(cells) = rows.iter().find(is_same) {
                return Ok(cells.get(at).cloned());
            }
        }
        Ok(None)
    }

    fn cell(&self, row: &Row, column: &str) -> String {
        let at = self.head.iter().position(|title| title == column);
        at.and_then(|at| row.cells.get(at)).cloned().unwrap_or_default()
    }

    fn renamed(&self, name: String) -> String {
        self.names.iter().find(|(from, _)| *from == name).map_or(name, |(_, to)| to.clone())
    }

    /// A template with the cells of a row.
    fn filled(&self, template: &str, row: &Row) -> Result<String> {
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

/// A command whose optional parts, ` [--flag VALUE]`, are there if they hold a number.
fn without_options(line: &str) -> String {
    let mut text = String::new();
    let mut rest = line;
    while let Some((before, after)) = rest.split_once(" [") {
        text.push_str(before);
        let (part, after) = after.split_once(']').unwrap_or((after, ""));
        if part.chars().any(|c| c.is_ascii_digit()) {
            text.push(' ');
            text.push_str(part);
        }
        rest = after;
    }
    text.push_str(rest);
    text
}

/// Commands of a code block: continued lines joined, comments left out.
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

fn cells_of(line: &str) -> Vec<String> {
    let line = line.trim();
    let inner = line.strip_prefix('|').unwrap_or(line);
    let inner = inner.strip_suffix('|').unwrap_or(inner);
    inner.split('|').map(label).collect()
}

fn column_of(head: &[String], title: &str) -> Result<usize> {
    let mut places = (0..head.len()).filter(|&at| head[at] == title);
    let place = places.next().with_context(|| format!("there is no column `{title}`"))?;
    ensure!(places.next().is_none(), "there are two columns `{title}`");
    Ok(place)
}

/// Head and rows of the Markdown tables in what a command printed.
fn printed_tables(text: &str) -> Vec<(Vec<String>, Vec<Vec<String>>)> {
    let mut tables: Vec<(Vec<String>, Vec<Vec<String>>)> = Vec::new();
    let mut is_inside = false;
    for line in text.lines() {
        let is_row = line.starts_with('|');
        match tables.last_mut() {
            Some((_, rows)) if is_row && is_inside => rows.push(cells_of(line)),
            _ if is_row => tables.push((cells_of(line), Vec::new())),
            _ => (),
        }
        is_inside = is_row;
    }
    tables
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "\
# Page

<!-- table: blocks
keys: mesh; blocks of
json: strips = strip_count
json: per triangle = index_count / triangle_count
names: cow = kine
-->
```sh
striata strip $MESHES/{mesh}.* [--block {blocks of}]   # a comment
```

Text.

| mesh | blocks of | strips | per triangle |
| --- | --- | --- | --- |
| **cow** | whole | 1,234 | 1.35 |
| | 10,000 | 1,300 | |
";

    fn check(page: &str, output: &str) -> (Vec<String>, Result<Checked>) {
        let mut lines = Vec::new();
        let tables = tables_of("a.md", page).unwrap();
        let checked = tables[0].check(&mut |line| {
            lines.push(line.to_owned());
            Ok(output.to_owned())
        });
        lines.dedup();
        (lines, checked)
    }

    #[test]
    fn a_table_that_is_right_passes_row_by_row() {
        let json = r#"{ "strip_count": 1234, "index_count": 1346, "triangle_count": 1000 }"#;
        let (lines, checked) = check(&PAGE.replace("1,300", ""), json);
        assert_eq!(lines, ["striata strip $MESHES/kine.* --json"]);
        let checked = checked.unwrap();
        assert_eq!((checked.cell_count, checked.differences), (2, Vec::new()));
    }

    #[test]
    fn a_cell_that_differs_is_reported_with_its_place() {
        let json = r#"{ "strip_count": 1234, "index_count": 1346, "triangle_count": 1000 }"#;
        let (lines, checked) = check(PAGE, json);
        assert_eq!(lines[1], "striata strip $MESHES/kine.* --block 10000 --json");
        let line = "a.md:18: blocks: cow, 10,000: strips: the page says `1,300`, the command `[1234.0]`";
        assert_eq!(checked.unwrap().differences, [line]);
        let missing = check(PAGE, "{}").1.unwrap();
        assert_eq!(missing.differences.len(), 3);
        assert!(check(PAGE, "no JSON").1.is_err());
    }

    #[test]
    fn printed_tables_are_matched_by_keys_and_titles() {
        let page = "<!-- table: t; -->\n";
        assert!(tables_of("a.md", page).is_err());
        let page = "<!-- table: t\ncommand: cargo bench\nkeys: mesh; tool\ncheck: strips\n-->\n\
            | mesh | tool | strips | ms |\n| --- | --- | --- | --- |\n| cow | a | 3 | 9 |\n| cow | b | 4 | 9 |\n";
        let printed = "Title\n\n| x |\n| - |\n| 1 |\n\n| mesh | tool | ms | strips |\n|---|---|---|---|\n\
            | cow | a | 1.0 | 3 |\n| cow | c | 1.0 | 4 |\n";
        let differences = check(page, printed).1.unwrap().differences;
        assert_eq!(
            differences,
            ["a.md:9: t: cow, b: strips: the page says `4`, the command `nothing: no such row`"]
        );
    }

    #[test]
    fn markers_that_mean_nothing_are_refused() {
        let table = "| a |\n| - |\n| 1 |\n";
        let read = |marker: &str| tables_of("a.md", &format!("<!-- table: t\n{marker}\n-->\n{table}"));
        assert!(read("check: a").is_ok());
        for wrong in ["check: b", "keys: b", "json: a", "colour: red", "nothing"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn commands_may_be_shared_and_continued() {
        let page = "<!-- table: a\n-->\n```sh\n# first\nstriata a \\\n    b\nstriata c # d\n```\n| x |\n| - |\n\
            <!-- table: b\ncommand of: a\n-->\n| x |\n| - |\n";
        let mut tables = tables_of("a.md", page).unwrap();
        share_commands(&mut tables).unwrap();
        assert_eq!(tables[1].commands, ["striata a b", "striata c"]);
        assert!(!tables[1].is_checkable());
    }
}
