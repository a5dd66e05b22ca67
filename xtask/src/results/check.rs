//! Compares a table of the docs with the output of its commands.

use anyhow::{Context, Result};
use serde_json::Value;

use super::address::values;
use super::cells::{argument, numbers, printed_values, shows, shows_printed, with_values};
use super::page::{DocTable, Row, cells_of, column_of};

/// Result of a check.
#[derive(Debug, Default)]
pub(super) struct CheckResult {
    pub cell_count: usize,
    /// One line for each cell that differs.
    pub differences: Vec<String>,
    /// Cells that differ, with their measured values.
    pub corrections: Vec<Correction>,
}

/// A cell of a page with the text that it should have.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Correction {
    pub page: String,
    /// Line of the row, from 1.
    pub line: usize,
    /// Index of the cell in its row.
    pub column_index: usize,
    pub cell: String,
}

impl DocTable {
    /// Compares the table with the output of its commands.
    ///
    /// # Errors
    /// If a command fails, or its output is neither a table nor JSON with the values of the row.
    pub(super) fn check(&self, output: &mut dyn FnMut(&str) -> Result<String>) -> Result<CheckResult> {
        let mut found = CheckResult::default();
        for row in self.rows.iter().filter(|row| self.is_wanted(row)) {
            let lines = self
                .commands
                .iter()
                .map(|command| self.filled(command, row).map(|line| without_options(&line)));
            let lines = lines.collect::<Result<Vec<_>>>()?;
            let mut differs = |column: &str, cell: &str, measured: &str, values: &[f64]| {
                let column_index = column_of(&self.head, column).ok();
                if let (Some(column_index), Some(cell)) = (column_index, with_values(cell, values)) {
                    let correction =
                        Correction { page: self.page.clone(), line: row.line, column_index, cell };
                    found.corrections.push(correction);
                }
                let keys: Vec<String> = self.keys.iter().map(|key| self.cell(row, key)).collect();
                found.differences.push(format!(
                    "{}:{}: {}: {}: {column}: the page has `{cell}`, the command printed `{measured}`",
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
                    Ok(measured) => differs(column, &cell, &format!("{measured:?}"), &measured),
                    Err(error) => differs(column, &cell, &format!("nothing: {error:#}"), &[]),
                }
                found.cell_count += 1;
            }
            for column in &self.checked {
                let cell = self.cell(row, column);
                // Not every row of a page that joins two printed tables is in both.
                if cell == "–" {
                    continue;
                }
                let printed = self.printed_cell(&lines, row, column, output)?;
                found.cell_count += 1;
                match printed {
                    Some(printed) if shows_printed(&cell, &printed) => (),
                    Some(printed) => differs(column, &cell, &printed, &printed_values(&printed)),
                    None => differs(column, &cell, "nothing: no such row", &[]),
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

    /// Returns the cell of a column in the printed row with the same keys.
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
        // The most similar table comes first: a command may print two tables that share some titles.
        tables.sort_by_key(|(head, _)| head.iter().filter(|title| !self.head.contains(title)).count());
        // A table with all checked columns goes before those with some, since titles repeat from table to table.
        let has_all = |head: &[String]| self.checked.iter().all(|column| column_of(head, column).is_ok());
        let one_has_all = tables.iter().any(|(head, _)| has_all(head));
        for (head, rows) in tables {
            let Ok(at) = column_of(&head, column) else { continue };
            if one_has_all && !has_all(&head) {
                continue;
            }
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
}

/// Resolves the optional parts of a command, ` [--flag VALUE]`: those that contain a number are kept.
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

/// Returns the header and the rows of each Markdown table in the output of a command.
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
    use super::super::page::tables_of;
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

    fn check(page: &str, output: &str) -> (Vec<String>, Result<CheckResult>) {
        let mut lines = Vec::new();
        let tables = tables_of("a.md", page, "").unwrap();
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
        let line =
            "a.md:18: blocks: cow, 10,000: strips: the page has `1,300`, the command printed `[1234.0]`";
        let checked = checked.unwrap();
        assert_eq!(checked.differences, [line]);
        let correction = Correction { page: "a.md".into(), line: 18, column_index: 2, cell: "1,234".into() };
        assert_eq!(checked.corrections, [correction]);
        let missing = check(PAGE, "{}").1.unwrap();
        assert_eq!(missing.differences.len(), 3);
        assert!(check(PAGE, "no JSON").1.is_err());
    }

    #[test]
    fn a_table_may_join_two_printed_ones() {
        let page = "<!-- table: t\ncommand: cargo bench\ncheck: strips; bytes\n-->\n| mesh | strips | bytes |\n\
            |---|---|---|\n| cow | 3 | 70 |\n| bunny | 4 | – |\n";
        let printed = "| mesh | strips |\n|---|---|\n| cow | 3 |\n| bunny | 5 |\n\n\
            | mesh | bytes |\n|---|---|\n| cow | 70 |\n";
        let checked = check(page, printed).1.unwrap();
        assert_eq!(checked.cell_count, 3);
        assert_eq!(
            checked.differences,
            ["a.md:8: t: bunny: strips: the page has `4`, the command printed `5`"]
        );
    }

    #[test]
    fn printed_tables_are_matched_by_keys_and_titles() {
        let page = "<!-- table: t; -->\n";
        assert!(tables_of("a.md", page, "").is_err());
        let page = "<!-- table: t\ncommand: cargo bench\nkeys: mesh; tool\ncheck: strips\n-->\n\
            | mesh | tool | strips | ms |\n| --- | --- | --- | --- |\n| cow | a | 3 | 9 |\n| cow | b | 4 | \
            9 |\n";
        let printed = "Title\n\n| x |\n| - |\n| 1 |\n\n| mesh | tool | ms | strips |\n|---|---|---|---|\n\
            | cow | a | 1.0 | 3 |\n| cow | c | 1.0 | 4 |\n";
        let differences = check(page, printed).1.unwrap().differences;
        assert_eq!(
            differences,
            ["a.md:9: t: cow, b: strips: the page has `4`, the command printed `nothing: no such row`"]
        );
    }
}
