//! What it costs to refine a mesh from its base, everywhere or for one view, by how fine: figure 6 of \[Cor01\].

use std::hint::black_box;
use std::time::Instant;

use serde::Serialize;
use striata::view::ScreenError;

use super::followers::{FANS, KEPT, Models, NAMES, RIVAL, STATELESS, View};
use super::paths::Path;
use striata_command::failure::Failure;
use striata_command::output::format_count;

/// Pixels allowed, coarse ones last.
const PIXELS: [f32; 8] = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0];

/// The frame of the orbit that is looked at: half a turn on, between near and far.
const FRAME: usize = 180;

/// Repetitions of which the quickest counts.
const REPETITIONS: usize = 7;

/// Refinements of all followers to one number of pixels.
#[derive(Clone, Debug, Serialize)]
pub(super) struct CostRow {
    /// Allowed on the screen.
    pixels: f32,
    /// Those that can be built.
    pub(super) contenders: Vec<Cost>,
}

/// A refinement from the base.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Cost {
    /// Who refines.
    pub(super) name: &'static str,
    /// Shown then.
    pub(super) triangles: usize,
    /// Questions and changes.
    pub(super) follow_ms: f64,
    /// Making the indices.
    pub(super) emission_ms: f64,
}

/// Refines from the base for one view; the level that is the same everywhere has as many triangles as fans.
///
/// # Errors
/// Where the camera makes no picture, which is our fault.
pub(super) fn measure(models: &Models<'_>) -> Result<Vec<CostRow>, Failure> {
    let frames = Path::Orbit.frames(&models.refinable.mesh);
    let camera = frames[FRAME].camera().map_err(|error| Failure::internal(error.to_string()))?;
    let screens =
        PIXELS.map(|pixels| ScreenError::new(camera, pixels).with_model_bounds(models.scene().sphere()));
    let mut buffer = Vec::new();
    let mut rows = Vec::new();
    for (pixels, screen) in PIXELS.into_iter().zip(&screens) {
        let mut contenders: Vec<Cost> = Vec::new();
        for (name, follower) in NAMES.into_iter().zip(models.followers()) {
            let Ok(mut follower) = follower else { continue };
            let as_many = contenders.first().map_or(0, |fans| fans.triangles);
            let split_count = models.refinable.sequence.split_count_for_triangles(as_many);
            let (mut follow_secs, mut emission_secs) = (f64::INFINITY, f64::INFINITY);
            for _ in 0..REPETITIONS {
                follower.restart();
                let started = Instant::now();
                follower.follow(View { screen, split_count }, None);
                let followed = started.elapsed().as_secs_f64();
                buffer.clear();
                follower.emit_into(&mut buffer);
                black_box(&*buffer);
                emission_secs = emission_secs.min(started.elapsed().as_secs_f64() - followed);
                follow_secs = follow_secs.min(followed);
            }
            let triangles = buffer.len() / 3;
            contenders.push(Cost {
                name,
                triangles,
                follow_ms: 1e3 * follow_secs,
                emission_ms: 1e3 * emission_secs,
            });
        }
        rows.push(CostRow { pixels, contenders });
    }
    Ok(rows)
}

/// Head and rows.
pub(super) fn table(rows: &[CostRow]) -> Vec<Vec<String>> {
    const SHOWN: [usize; 2] = [FANS, RIVAL];
    const REFINED: [usize; 3] = [FANS, STATELESS, RIVAL];
    const EMITTED: [usize; 3] = [FANS, KEPT, RIVAL];
    let mut head = vec!["pixels".to_owned()];
    head.extend(SHOWN.map(|i| format!("triangles, {}", NAMES[i])));
    head.extend(REFINED.map(|i| format!("{}, ms", NAMES[i])));
    head.extend(EMITTED.map(|i| format!("emission, {}", NAMES[i])));
    let mut table = vec![head];
    for row in rows {
        let cell = |i: usize, text: fn(&Cost) -> String| {
            let found = row.contenders.iter().find(|cost| cost.name == NAMES[i]);
            found.map_or_else(|| "-".to_owned(), text)
        };
        let mut cells = vec![row.pixels.to_string()];
        cells.extend(SHOWN.map(|i| cell(i, |cost| format_count(cost.triangles))));
        cells.extend(REFINED.map(|i| cell(i, |cost| format!("{:.3}", cost.follow_ms))));
        cells.extend(EMITTED.map(|i| cell(i, |cost| format!("{:.3}", cost.emission_ms))));
        table.push(cells);
    }
    table
}
