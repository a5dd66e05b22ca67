//! Views on the page: charts of paths, of memory, and of what time depends on.

use super::super::bars;
use super::super::page::{Block, MeshPart, Section};
use super::super::plot::{Chart, Series};
use super::super::scale::Scale;
use super::course::Run;
use super::figures::Figures;
use super::followers::{NAMES, UNIFORM};
use super::report::{PathReport, READING, ViewsReport};
use super::{costs, memory};
use striata_command::failure::Failure;
use striata_command::output::format_count;

/// Points that many frames are put together to.
const BIN_COUNT: usize = 16;

/// All that is shown of a mesh.
///
/// # Errors
/// Where a chart cannot be drawn.
pub(in super::super) fn sections(report: &ViewsReport) -> Result<Vec<Section>, Failure> {
    let mut sections = vec![Section {
        title: "Views".to_owned(),
        intro: format!(
            "What follows an eye along recorded paths, on a screen of {screen} x {screen} pixels, 60 degrees wide. Fans are \
             asked again only where the view may have changed its mind; kept fans keep their triangles from frame to frame \
             besides, so that emission writes what changes and copies the rest; stateless fans begin at the base in every frame and \
             own nothing but their bits; VDPM are view-dependent progressive meshes [Hop97]; uniform is a level that is the \
             same everywhere, as fine as the nearest point in the picture asks for, which is found beforehand. {READING} Of \
             each frame the quickest of several rounds counts, in which models take turns.{}",
            report.missing(),
            screen = format_count(report.screen_px as usize),
        ),
        blocks: Vec::new(),
    }];
    for path in &report.paths {
        sections.push(path_section(path)?);
    }
    sections.push(activity_section(report)?);
    sections.push(refinement_section(report)?);
    let bars: &bars::BarChart = &memory::chart(&report.memory);
    sections.push(Section {
        title: "Memory of views".to_owned(),
        intro: "Bytes a vertex of the full mesh. What is built once is shared by all instances; each instance owns the rest, \
                here the most on the orbit at 1 pixel. Fans own a bit a step; one that follows a view at the cost of what \
                changes owns a front besides, and its triangles where it keeps them. What papers count: their structures, 4 bytes a number; 83 bytes a vertex and \
                112 an active vertex of VDPM are what [Cor01] says (figure 5 and section 4.1)."
            .to_owned(),
        blocks: vec![
            Block::bars(bars, "Bytes a vertex of each model")?,
            Block::WideTable(memory::table(&report.memory)),
        ],
    });
    Ok(sections)
}

fn path_section(path: &PathReport) -> Result<Section, Failure> {
    let frames = path.frame_count as f64;
    let chart = |y_title: &'static str, values: &dyn Fn(&Figures) -> Vec<f64>| {
        let lines = path.contenders.iter().map(|contender| {
            // Without points a model still has its color.
            let points = contender.figures.as_ref().map_or_else(Vec::new, |figures| {
                let frames = figures.series.frame.iter().map(|&frame| frame as f64);
                frames.zip(values(figures)).skip(1).collect()
            });
            line(contender.name, points)
        });
        let series: Vec<Series> = lines.collect();
        let y = Scale::log(series.iter().flat_map(|series| series.points.iter().map(|&(_, y)| y)));
        let x = Scale::at(&[0.0, 0.25, 0.5, 0.75, 1.0].map(|share| (share * frames).round()));
        Chart { x_title: "frame", y_title, x, y, series }
    };
    let times = chart("criterion, update and emission, ms", &|figures| {
        let series = &figures.series;
        series.follow_ms.iter().zip(&series.emission_ms).map(|(follow, emission)| follow + emission).collect()
    });
    let triangles =
        chart("triangles", &|figures| figures.series.triangles.iter().map(|&count| count as f64).collect());
    Ok(Section {
        title: format!("View: {}", path.title()),
        intro: format!("{} frames {}; {} rounds.", path.frame_count, path.path.about(), path.rounds),
        blocks: vec![
            Block::chart(&times, "Time of each frame")?,
            Block::chart(&triangles, "Triangles by frame")?,
            Block::WideTable(path.table()),
        ],
    })
}

/// What the time of a frame depends on.
fn activity_section(report: &ViewsReport) -> Result<Section, Failure> {
    let by_changes = report.paths.iter().map(|path| {
        let fans = path.contenders.first().and_then(|contender| contender.run.as_ref());
        let points = fans.map_or_else(Vec::new, |run| {
            points(run, |frame| (run.asked[frame] + run.changes[frame], run.follow_secs[frame]))
        });
        line(&path.title(), binned(points))
    });
    let orbits = || report.paths.iter().filter(|path| path.name == "orbit");
    // A level that is the same everywhere takes no time to be chosen.
    let by_active = NAMES[..UNIFORM].iter().enumerate().map(|(i, name)| {
        let runs = orbits().filter_map(|path| path.contenders.get(i)?.run.as_ref());
        let all = runs.flat_map(|run| points(run, |frame| (run.triangles[frame], run.follow_secs[frame])));
        line(name, binned(all.collect()))
    });
    let by_changes = log_log("steps asked for and changed", "criterion and update, ms", by_changes.collect());
    let by_active = log_log("triangles shown", "criterion and update, ms", by_active.collect());
    Ok(Section {
        title: "What a frame depends on".to_owned(),
        intro: "Frames put together by how much they have to do, means of each group. On the left fans on all paths, by the \
                steps that they ask for and change; on the right all models on the orbits, by what they show."
            .to_owned(),
        blocks: vec![
            Block::chart(&by_changes, "Time by steps asked for and changed")?,
            Block::chart(&by_active, "Time by triangles shown")?,
        ],
    })
}

fn refinement_section(report: &ViewsReport) -> Result<Section, Failure> {
    let of = |name: &'static str, secs: fn(&costs::Cost) -> f64| {
        let all = report.refinement.iter().flat_map(|row| &row.contenders).filter(|cost| cost.name == name);
        let mut points: Vec<(f64, f64)> = all.map(|cost| (cost.triangles as f64, secs(cost))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points
    };
    let series = NAMES.iter().map(|&name| line(name, of(name, |cost| cost.follow_ms + cost.emission_ms)));
    let emission = NAMES.iter().map(|&name| line(name, of(name, |cost| cost.emission_ms)));
    let whole = log_log("triangles shown", "refinement and emission, ms", series.collect());
    let emission = log_log("triangles shown", "emission, ms", emission.collect());
    Ok(Section {
        title: "Refinement from the base".to_owned(),
        intro: "One view, errors of 32 pixels down to a quarter of one: what it takes to come there from the base mesh, as \
                figure 6 of [Cor01] has it. Uniform is a level that is the same everywhere, with as many triangles as fans: \
                progressive refinement, which is nothing but emission."
            .to_owned(),
        blocks: vec![
            Block::chart(&whole, "Time of refinement and emission by triangles")?,
            Block::chart(&emission, "Time of emission by triangles")?,
            Block::WideTable(costs::table(&report.refinement)),
        ],
    })
}

/// Time of a frame against the size of the mesh, over several meshes; `None` where there are fewer than two.
///
/// # Errors
/// Where the chart cannot be drawn.
pub(in super::super) fn by_size(reports: &[&ViewsReport]) -> Result<Option<MeshPart>, Failure> {
    if reports.len() < 2 {
        return Ok(None);
    }
    let of = |i: usize, value: fn(&Figures) -> f64| {
        let at = |report: &&ViewsReport| {
            let figures = report.paths.first()?.contenders.get(i)?.figures.as_ref()?;
            Some((report.triangle_count as f64, value(figures)))
        };
        let mut points: Vec<(f64, f64)> = reports.iter().filter_map(at).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points
    };
    let chart = |y_title, value: fn(&Figures) -> f64| {
        let series = NAMES.iter().enumerate().map(|(i, name)| line(name, of(i, value)));
        log_log("triangles of the mesh", y_title, series.collect())
    };
    let times = chart("criterion and update, ms", |figures| figures.criterion_ms + figures.update_ms);
    let shown = chart("triangles shown", |figures| figures.triangles);
    let title = reports[0].paths.first().map_or_else(String::new, PathReport::title);
    let section = Section {
        title: "Views by the size of the mesh".to_owned(),
        intro: format!(
            "Means over the same path around each mesh ({title}). What follows a view should cost what the picture shows \
             and what changes in it, and not grow with the mesh; compare the triangles that are shown."
        ),
        blocks: vec![
            Block::chart(&times, "Time by the size of the mesh")?,
            Block::chart(&shown, "Triangles shown by the size of the mesh")?,
        ],
    };
    Ok(Some(MeshPart {
        name: "All meshes".to_owned(),
        summary: format!("{} meshes", reports.len()),
        sections: vec![section],
    }))
}

fn line(name: &str, points: Vec<(f64, f64)>) -> Series {
    Series { name: name.to_owned(), points, spread: Vec::new() }
}

fn log_log(x_title: &'static str, y_title: &'static str, series: Vec<Series>) -> Chart {
    let all = || series.iter().flat_map(|series| series.points.iter().copied());
    let (x, y) = (Scale::log(all().map(|point| point.0)), Scale::log(all().map(|point| point.1)));
    Chart { x_title, y_title, x, y, series }
}

/// Frames of a run after the first, with milliseconds.
fn points(run: &Run, of: impl Fn(usize) -> (usize, f64)) -> Vec<(f64, f64)> {
    run.later_frames().map(of).map(|(count, secs)| (count as f64, 1e3 * secs)).collect()
}

/// Means of groups of points that are neighbors on a logarithmic axis.
fn binned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = points.into_iter().filter(|&(x, _)| x > 0.0).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (Some(&(first, _)), Some(&(last, _))) = (points.first(), points.last()) else { return points };
    let width = ((last / first).ln() / BIN_COUNT as f64).max(f64::MIN_POSITIVE);
    let bin = |x: f64| ((x / first).ln() / width).min(BIN_COUNT as f64 - 1.0) as usize;
    let groups = points.chunk_by(|a, b| bin(a.0) == bin(b.0));
    let mean = |group: &[(f64, f64)]| {
        let (x, y) = group.iter().fold((0.0, 0.0), |(x, y), point| (x + point.0, y + point.1));
        (x / group.len() as f64, y / group.len() as f64)
    };
    groups.map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_of_points_keep_their_order_and_their_mean() {
        let points: Vec<(f64, f64)> = (0..1000).map(|i| (f64::from(i), 3.0 * f64::from(i))).collect();
        let few = binned(points);
        assert!(few.len() <= BIN_COUNT && few.len() > BIN_COUNT / 2, "{few:?}");
        assert!(few.is_sorted_by(|a, b| a.0 < b.0));
        assert!(few.iter().all(|&(x, y)| (y - 3.0 * x).abs() < 1e-9 * y), "{few:?}");
        assert_eq!(binned(vec![(5.0, 1.0), (5.0, 3.0), (0.0, 9.0)]), [(5.0, 2.0)]);
        assert!(binned(Vec::new()).is_empty());
    }
}
