//! Distances of levels from the original.

use std::io::Write;

use striata::mesh::{
    DistanceOptions, IndexedMesh, SurfaceDistance, replay, replay_fragments, surface_distance,
};
use striata::simplify::{Placement, SimplifyOptions, Target, simplify};

use crate::table::Table;
use crate::{BuiltSequence, Fallible, Request, SHARES, Subject};

/// The source of our levels.
enum Tool {
    Sequence(BuiltSequence),
    Optimal,
}

impl Tool {
    /// A level with at most `triangle_count` triangles, and the error that it reports.
    fn level(&self, subject: &Subject, triangle_count: usize) -> Fallible<(IndexedMesh, f64)> {
        match self {
            Self::Sequence(BuiltSequence::Fragments(fragmented)) => {
                let levels = fragmented.fragments.levels();
                let split_count = levels.split_count_for_triangles(triangle_count);
                let error = f64::from(levels.error_at(split_count));
                Ok((replay_fragments(fragmented, split_count), error))
            }
            Self::Sequence(BuiltSequence::Collapses(refinable)) => {
                let split_count = refinable.sequence.split_count_for_triangles(triangle_count);
                let error = f64::from(refinable.sequence.error_at(split_count));
                Ok((replay(refinable, split_count), error))
            }
            Self::Optimal => {
                let options = SimplifyOptions::default()
                    .with_target(Target::Triangles(triangle_count))
                    .with_placement(Placement::Optimal);
                let out = simplify(subject.mesh(), &options)?;
                Ok((out.mesh, out.error))
            }
        }
    }
}

fn tools(request: &Request, subject: &Subject) -> Fallible<Vec<Tool>> {
    let mut tools = Vec::new();
    for simplifier in &request.simplifiers {
        tools.push(Tool::Sequence(simplifier.build(subject.welded.clone())?));
    }
    if request.has_optimal {
        tools.push(Tool::Optimal);
    }
    Ok(tools)
}

/// Geometric mean of ratios, so that 2 and 1/2 average to 1.
#[derive(Clone, Copy, Default)]
struct GeometricMean {
    log_sum: f64,
    count: usize,
}

impl GeometricMean {
    /// Adds a ratio; ratios with a zero distance are meaningless and skipped.
    fn add(&mut self, ratio: f64) {
        if ratio.is_finite() && ratio > 0.0 {
            self.log_sum += ratio.ln();
            self.count += 1;
        }
    }

    fn value(self) -> f64 {
        (self.log_sum / self.count as f64).exp()
    }
}

/// Ratios of one tool to meshoptimizer at each share: RMS and maximum.
#[derive(Clone, Copy, Default)]
struct Means([[GeometricMean; 2]; SHARES.len()]);

pub(crate) fn report(request: &Request, subjects: &[Subject], out: &mut dyn Write) -> Fallible<()> {
    let mut names: Vec<String> = request.simplifiers.iter().map(|simplifier| simplifier.name()).collect();
    names.extend(request.has_optimal.then(|| "optimal placement".to_owned()));
    let head =
        |first: &[&str]| Table::new(first.iter().map(|s| (*s).to_owned()).chain(names.iter().cloned()));
    let mut distances = head(&["mesh", "share", "triangles", "meshoptimizer"]);
    let mut ratios = head(&["mesh", "share"]);
    let mut means = vec![Means::default(); names.len()];
    for subject in subjects {
        let tools = tools(request, subject)?;
        for (s, share) in SHARES.into_iter().enumerate() {
            let peer = subject.peer_level(share)?;
            let reference = measured(request, subject, &peer)?;
            let mut row = vec![subject.name.clone(), percent(share), peer.triangle_count().to_string()];
            row.push(cell(&reference));
            let mut ratio_row = row[..2].to_vec();
            for (tool, mean) in tools.iter().zip(&mut means) {
                let (level, error) = tool.level(subject, peer.triangle_count())?;
                let found = measured(request, subject, &level)?;
                row.push(cell(&found));
                let [rms, max] = [found.rms / reference.rms, found.max / reference.max];
                mean.0[s][0].add(rms);
                mean.0[s][1].add(max);
                ratio_row.push(format!("{rms:.3} / {max:.3}, {}", unit(error, &found)));
            }
            distances.push(row);
            ratios.push(ratio_row);
        }
    }
    writeln!(out, "RMS (maximum) in 1e-5 of the diagonal.\n")?;
    distances.print(out)?;
    writeln!(
        out,
        "RMS / maximum as ratios to meshoptimizer's, and the error that the level reports in 1e-5.\n"
    )?;
    ratios.print(out)?;
    print_means(&names, &means, subjects.len(), out)
}

fn print_means(names: &[String], means: &[Means], mesh_count: usize, out: &mut dyn Write) -> Fallible<()> {
    writeln!(out, "Geometric means of the ratios (RMS / maximum) over {mesh_count} meshes.\n")?;
    let head = ["tool".to_owned()].into_iter().chain(SHARES.map(percent));
    let mut table = Table::new(head);
    for (name, means) in names.iter().zip(means) {
        let cell = |[rms, max]: [GeometricMean; 2]| format!("{:.3} / {:.3}", rms.value(), max.value());
        table.push([name.clone()].into_iter().chain(means.0.map(cell)).collect());
    }
    table.print(out)?;
    Ok(())
}

fn measured(request: &Request, subject: &Subject, level: &IndexedMesh) -> Fallible<SurfaceDistance> {
    let options = DistanceOptions::default().with_sample_count(request.sample_count);
    Ok(surface_distance(subject.mesh(), level, &options)?)
}

fn cell(distance: &SurfaceDistance) -> String {
    format!("{} ({})", unit(distance.rms, distance), unit(distance.max, distance))
}

/// A distance in 1e-5 of the diagonal.
fn unit(distance: f64, of: &SurfaceDistance) -> String {
    let value = distance / of.diagonal * 1e5;
    if value < 10.0 { format!("{value:.2}") } else { format!("{value:.1}") }
}

fn percent(share: f64) -> String {
    format!("{} %", share * 100.0)
}
