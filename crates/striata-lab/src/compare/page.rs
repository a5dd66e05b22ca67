//! The page of a comparison: for each mesh its sections, each with charts and tables.

use super::bars::BarChart;
use super::plot::{self, Chart};
use striata_command::failure::Failure;
use striata_command::page::{STYLE, escaped, fill, table};

/// The page with `{{NAMES}}` where content goes.
const TEMPLATE: &str = include_str!("page.html");

/// One question and its answers.
#[derive(Clone, Debug)]
pub(super) struct Section {
    /// The heading.
    pub(super) title: String,
    /// How to read it.
    pub(super) intro: String,
    /// What is shown; two stand side by side where there is room.
    pub(super) blocks: Vec<Block>,
}

/// A chart or a table.
#[derive(Clone, Debug)]
pub(super) enum Block {
    /// A chart, and what it shows in words.
    Chart { svg: String, alt: String },
    /// Head and rows, of plain text.
    Table(Vec<Vec<String>>),
    /// A table that takes the whole width.
    WideTable(Vec<Vec<String>>),
}

impl Block {
    /// Draws the chart.
    ///
    /// # Errors
    /// Where it cannot be drawn.
    pub(super) fn chart(chart: &Chart, alt: &str) -> Result<Self, Failure> {
        Ok(Self::Chart { svg: chart.to_svg()?, alt: alt.to_owned() })
    }

    /// Draws the bars.
    ///
    /// # Errors
    /// Where they cannot be drawn.
    pub(super) fn bars(chart: &BarChart, alt: &str) -> Result<Self, Failure> {
        Ok(Self::Chart { svg: chart.to_svg()?, alt: alt.to_owned() })
    }

    fn to_html(&self) -> String {
        let plain = |rows: &[Vec<String>]| -> Vec<Vec<String>> {
            rows.iter().map(|row| row.iter().map(|cell| escaped(cell)).collect()).collect()
        };
        match self {
            Self::Chart { svg, alt } => {
                format!(
                    "<div class=\"card chart\" role=\"img\" aria-label=\"{}\">{svg}</div>\n",
                    escaped(alt)
                )
            }
            Self::Table(rows) => format!("<div class=\"card scroll\">{}</div>\n", table(&plain(rows), true)),
            Self::WideTable(rows) => {
                format!("<div class=\"card scroll wide\">{}</div>\n", table(&plain(rows), true))
            }
        }
    }
}

impl Section {
    fn to_html(&self) -> String {
        let blocks: String = self.blocks.iter().map(Block::to_html).collect();
        format!(
            "<h3>{}</h3>\n<p>{}</p>\n<div class=\"blocks\">\n{blocks}</div>\n",
            escaped(&self.title),
            escaped(&self.intro)
        )
    }
}

/// A mesh on the page.
#[derive(Clone, Debug)]
pub(super) struct MeshPart {
    /// Its name.
    pub(super) name: String,
    /// What it is like, in a line.
    pub(super) summary: String,
    /// What was measured on it.
    pub(super) sections: Vec<Section>,
}

/// The page, complete in itself: it needs neither a network nor another file.
pub(super) fn render(command: &str, machine: &str, meshes: &[MeshPart]) -> String {
    fill(TEMPLATE, |name| match name {
        "STYLE" => STYLE.to_owned(),
        "CHARTS" => plot::style(),
        "COMMAND" => escaped(command),
        "MACHINE" => escaped(machine),
        "MESHES" => meshes.iter().map(mesh_to_html).collect(),
        unknown => unreachable!("the template asks for {unknown}"),
    })
}

fn mesh_to_html(mesh: &MeshPart) -> String {
    let sections: String = mesh.sections.iter().map(Section::to_html).collect();
    format!("<h2>{}</h2>\n<p>{}</p>\n{sections}", escaped(&mesh.name), escaped(&mesh.summary))
}
