//! Charts of views: times along the paths, memory, and what the time of a frame depends on.

use super::super::bars;
use super::super::page::{MeshPart, PageBlock, PageSection};
use super::super::plot::{Chart, PlotSeries};
use super::super::scale::Scale;
use super::figures::Figures;
use super::followers::{NAMES, UNIFORM};
use super::report::{PathReport, READING, ViewsReport};
use super::scenario::ScenarioRun;
use super::{costs, memory};
use striata_command::failure::Failure;
use striata_command::output::format_count;

/// Number of points into which many frames are averaged.
const BIN_COUNT: usize = 16;

/// The chart sections of one mesh.
///
/// # Errors
/// If a chart cannot be drawn.
pub(in super::super) fn sections(report: &ViewsReport) -> Result<Vec<PageSection>, Failure> {
    let mut sections = vec![PageSection {
        title: "Views".to_owned(),
        intro: format!(
            "Models that follow a camera along recorded paths, {screen} x {screen} pixels, 60 degrees \
             wide. Fans are evaluated again only if their verdict may have changed; fans-kept also keep \
             their triangles from frame to frame, so that emission writes what changes and copies the \
             rest; fans-stateless begin at the base in every frame and store only one bit per step; VDPM \
             are view-dependent progressive meshes [Hop97]; uniform is one level for the whole mesh, as \
             fine as the nearest visible point requires, which is determined beforehand. {READING} For \
             each frame the fastest of several rounds counts, in which the models take turns.{}",
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
    sections.push(PageSection {
        title: "Memory of views".to_owned(),
        intro: "Bytes per vertex of the full mesh. Static data is shared by all instances; each instance \
                owns the rest, measured at its maximum on the orbit at 1 pixel. A fan instance owns a \
                bit per step; one that follows a view incrementally also owns a front, and fans-kept \
                their triangles. Papers count their structures with 4 bytes per number; 83 bytes per \
                vertex and 112 per active vertex of VDPM are from [Cor01] (figure 5 and section 4.1)."
            .to_owned(),
        blocks: vec![
            PageBlock::bars(bars, "Bytes per vertex of each model")?,
            PageBlock::WideTable(memory::table(&report.memory)),
        ],
    });
    Ok(sections)
}

fn path_section(path: &PathReport) -> Result<PageSection, Failure> {
    let frames = path.frame_count as f64;
    let chart = |y_title: &'static str, values: &dyn Fn(&Figures) -> Vec<f64>| {
        let lines = path.contenders.iter().map(|contender| {
            // A model without points still reserves its color.
            let points = contender.figures.as_ref().map_or_else(Vec::new, |figures| {
                let frames = figures.series.frame.iter().map(|&frame| frame as f64);
                frames.zip(values(figures)).skip(1).collect()
            });
            line(contender.name, points)
        });
        let series: Vec<PlotSeries> = lines.collect();
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
    Ok(PageSection {
        title: format!("View: {}", path.title()),
        intro: format!("{} frames {}; {} rounds.", path.frame_count, path.path.about(), path.rounds),
        blocks: vec![
            PageBlock::chart(&times, "Time of each frame")?,
            PageBlock::chart(&triangles, "Triangles by frame")?,
            PageBlock::WideTable(path.table()),
        ],
    })
}

/// The chart of what the time of a frame depends on.
fn activity_section(report: &ViewsReport) -> Result<PageSection, Failure> {
    let by_changes = report.paths.iter().map(|path| {
        let fans = path.contenders.first().and_then(|contender| contender.run.as_ref());
        let points = fans.map_or_else(Vec::new, |run| {
            points(run, |frame| (run.evaluated[frame] + run.changes[frame], run.follow_secs[frame]))
        });
        line(&path.title(), binned(points))
    });
    let orbits = || report.paths.iter().filter(|path| path.name == "orbit");
    // A uniform level takes no time to be chosen.
    let by_active = NAMES[..UNIFORM].iter().enumerate().map(|(i, name)| {
        let runs = orbits().filter_map(|path| path.contenders.get(i)?.run.as_ref());
        let all = runs.flat_map(|run| points(run, |frame| (run.triangles[frame], run.follow_secs[frame])));
        line(name, binned(all.collect()))
    });
    let by_changes = log_log("steps evaluated and changed", "criterion and update, ms", by_changes.collect());
    let by_active = log_log("triangles shown", "criterion and update, ms", by_active.collect());
    Ok(PageSection {
        title: "Frame time and its causes".to_owned(),
        intro: "Frames grouped by how much work they have, with the mean of each group. On the left, \
                fans on all paths, by the steps that they evaluate and change; on the right, all models \
                on the orbits, by the triangles shown."
            .to_owned(),
        blocks: vec![
            PageBlock::chart(&by_changes, "Time by steps evaluated and changed")?,
            PageBlock::chart(&by_active, "Time by triangles shown")?,
        ],
    })
}

fn refinement_section(report: &ViewsReport) -> Result<PageSection, Failure> {
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
    Ok(PageSection {
        title: "Refinement from the base".to_owned(),
        intro: "One view, with errors from 32 pixels down to a quarter of one: the time to get there \
                from the base mesh, as in figure 6 of [Cor01]. Uniform is one level for the whole mesh, \
                with as many triangles as fans: progressive refinement, which consists of emission \
                only."
            .to_owned(),
        blocks: vec![
            PageBlock::chart(&whole, "Time of refinement and emission by triangles")?,
            PageBlock::chart(&emission, "Time of emission by triangles")?,
            PageBlock::WideTable(costs::table(&report.refinement)),
        ],
    })
}

/// Chart of frame time against mesh size over several meshes, or `None` for fewer than two.
///
/// # Errors
/// If the chart cannot be drawn.
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
    let section = PageSection {
        title: "Views by the size of the mesh".to_owned(),
        intro: format!(
            "Means over the same path around each mesh ({title}). Following a view should cost time in \
             proportion to what is shown and what changes, regardless of the size of the mesh; compare \
             the triangles shown."
        ),
        blocks: vec![
            PageBlock::chart(&times, "Time by the size of the mesh")?,
            PageBlock::chart(&shown, "Triangles shown by the size of the mesh")?,
        ],
    };
    Ok(Some(MeshPart {
        name: "All meshes".to_owned(),
        summary: format!("{} meshes", reports.len()),
        sections: vec![section],
    }))
}

fn line(name: &str, points: Vec<(f64, f64)>) -> PlotSeries {
    PlotSeries { name: name.to_owned(), points, spread: Vec::new() }
}

fn log_log(x_title: &'static str, y_title: &'static str, series: Vec<PlotSeries>) -> Chart {
    let all = || series.iter().flat_map(|series| series.points.iter().copied());
    let (x, y) = (Scale::log(all().map(|point| point.0)), Scale::log(all().map(|point| point.1)));
    Chart { x_title, y_title, x, y, series }
}

/// Points of all frames except the first: a count, and the time in milliseconds.
fn points(run: &ScenarioRun, of: impl Fn(usize) -> (usize, f64)) -> Vec<(f64, f64)> {
    run.later_frames().map(of).map(|(count, secs)| (count as f64, 1e3 * secs)).collect()
}

/// Averages groups of points that are close to each other on a logarithmic axis.
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
    fn binned_points_keep_their_order_and_mean() {
        let points: Vec<(f64, f64)> = (0..1000).map(|i| (f64::from(i), 3.0 * f64::from(i))).collect();
        let few = binned(points);
        assert!(few.len() <= BIN_COUNT && few.len() > BIN_COUNT / 2, "{few:?}");
        assert!(few.is_sorted_by(|a, b| a.0 < b.0));
        assert!(few.iter().all(|&(x, y)| (y - 3.0 * x).abs() < 1e-9 * y), "{few:?}");
        assert_eq!(binned(vec![(5.0, 1.0), (5.0, 3.0), (0.0, 9.0)]), [(5.0, 2.0)]);
        assert!(binned(Vec::new()).is_empty());
    }
}
