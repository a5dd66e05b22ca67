//! The HTML page of a comparison: sections for each mesh, each with charts and tables.

use super::bars::BarChart;
use super::plot::{self, Chart};
use striata_command::failure::Failure;
use striata_command::page::{STYLE, escaped, fill, table};

/// The page, with placeholders such as `{{MESHES}}`.
const TEMPLATE: &str = include_str!("page.html");

/// A section of the page: a topic with charts and tables.
#[derive(Clone, Debug)]
pub(super) struct PageSection {
    /// Heading of the section.
    pub title: String,
    /// Introduction that explains the section.
    pub intro: String,
    /// Charts and tables; two fit next to each other on wide screens.
    pub blocks: Vec<PageBlock>,
}

/// A chart or a table.
#[derive(Clone, Debug)]
pub(super) enum PageBlock {
    /// A chart and its text alternative.
    Chart { svg: String, alt: String },
    /// Header and rows, as plain text.
    Table(Vec<Vec<String>>),
    /// A table that takes the whole width.
    WideTable(Vec<Vec<String>>),
}

impl PageBlock {
    /// Draws a chart.
    ///
    /// # Errors
    /// If drawing fails.
    pub(super) fn chart(chart: &Chart, alt: &str) -> Result<Self, Failure> {
        Ok(Self::Chart { svg: chart.to_svg()?, alt: alt.to_owned() })
    }

    /// Draws a bar chart.
    ///
    /// # Errors
    /// If drawing fails.
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

impl PageSection {
    fn to_html(&self) -> String {
        let blocks: String = self.blocks.iter().map(PageBlock::to_html).collect();
        format!(
            "<h3>{}</h3>\n<p>{}</p>\n<div class=\"blocks\">\n{blocks}</div>\n",
            escaped(&self.title),
            escaped(&self.intro)
        )
    }
}

/// The part of the page about one mesh.
#[derive(Clone, Debug)]
pub(super) struct MeshPart {
    /// Name of the mesh.
    pub name: String,
    /// One-line summary of the mesh.
    pub summary: String,
    /// The sections of its measurements.
    pub sections: Vec<PageSection>,
}

/// Renders the page, which is self-contained: it needs neither a network nor other files.
pub(super) fn render(command: &str, machine: &str, meshes: &[MeshPart]) -> String {
    fill(TEMPLATE, |name| match name {
        "STYLE" => STYLE.to_owned(),
        "CHARTS" => plot::style(),
        "COMMAND" => escaped(command),
        "MACHINE" => escaped(machine),
        "MESHES" => meshes.iter().map(mesh_to_html).collect(),
        unknown => unreachable!("the template contains an unknown placeholder {unknown}"),
    })
}

fn mesh_to_html(mesh: &MeshPart) -> String {
    let sections: String = mesh.sections.iter().map(PageSection::to_html).collect();
    format!("<h2>{}</h2>\n<p>{}</p>\n{sections}", escaped(&mesh.name), escaped(&mesh.summary))
}
