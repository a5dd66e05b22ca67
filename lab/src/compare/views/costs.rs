//! Cost of refining a mesh from its base, uniformly or for one view, by the allowed error: figure 6 of
//! \[Cor01\].

use std::hint::black_box;
use std::time::Instant;

use serde::Serialize;
use striata::model::{FanForm, FanIndices, FanInstance};
use striata::view::ScreenError;

use super::followers::{FANS, KEPT, Models, NAMES, PUBLISHED, STATELESS, VDPM, VDPM_KEPT, View};
use super::paths::Path;
use striata_command::failure::Failure;
use striata_command::output::format_count;

/// Allowed screen errors in pixels, finest first.
const PIXELS: [f32; 8] = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0];

/// The frame of the orbit that is rendered: half a turn on, between near and far.
const FRAME: usize = 180;

/// Number of repetitions; the fastest one counts.
const REPETITIONS: usize = 7;

/// Refinements of all followers to one screen error.
#[derive(Clone, Debug, Serialize)]
pub(super) struct CostRow {
    /// Allowed error on the screen, in pixels.
    pixels: f32,
    /// The followers that can be built.
    pub contenders: Vec<Cost>,
    /// Indices and time that it takes to draw the fans of this view, by form.
    drawn: Vec<ViewIndices>,
}

/// Indices of one form of the fans that a view shows.
#[derive(Clone, Debug, Serialize)]
struct ViewIndices {
    form: &'static str,
    /// Number of indices, including the restarts between fans or strips.
    index_count: usize,
    /// Number of fans or strips.
    piece_count: usize,
    /// Time to write them.
    emission_ms: f64,
}

/// A refinement from the base.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Cost {
    /// Name of the follower.
    pub name: &'static str,
    /// Number of triangles shown afterward.
    pub triangles: usize,
    /// Time to evaluate the criterion and apply changes.
    pub follow_ms: f64,
    /// Time to write the indices.
    pub emission_ms: f64,
}

/// Refines from the base for one view; the uniform level gets as many triangles as fans.
///
/// # Errors
/// If the camera is invalid, which would be a bug.
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
        rows.push(CostRow { pixels, contenders, drawn: drawn(models, screen) });
    }
    Ok(rows)
}

/// Writes what a view shows as a list, as fans, and as a strip for each fan.
fn drawn(models: &Models<'_>, screen: &ScreenError) -> Vec<ViewIndices> {
    let mut instance = FanInstance::uniform(&models.fans, 0);
    instance.refine(&models.scene(), screen);
    let forms = [("list", FanForm::Triangles), ("fans", FanForm::Fans), ("strips", FanForm::Strips)];
    let mut indices = FanIndices::default();
    let of_form = forms.map(|(name, form)| {
        let mut secs = f64::INFINITY;
        for _ in 0..REPETITIONS {
            let started = Instant::now();
            instance.emit_into(&models.fans, form, &mut indices);
            black_box(&indices);
            secs = secs.min(started.elapsed().as_secs_f64());
        }
        let counts = instance.draw_counts(&models.fans, form);
        let (index_count, piece_count) = (counts.index_count, counts.strip_count);
        ViewIndices { form: name, index_count, piece_count, emission_ms: 1e3 * secs }
    });
    of_form.into()
}

/// Header and rows of the table.
pub(super) fn table(rows: &[CostRow]) -> Vec<Vec<String>> {
    const SHOWN: [usize; 3] = [FANS, PUBLISHED, VDPM];
    const REFINED: [usize; 5] = [FANS, STATELESS, PUBLISHED, VDPM, VDPM_KEPT];
    const EMITTED: [usize; 4] = [FANS, KEPT, PUBLISHED, VDPM];
    let mut head = vec!["pixels".to_owned()];
    head.extend(SHOWN.map(|i| format!("triangles, {}", NAMES[i])));
    head.extend(REFINED.map(|i| format!("{}, ms", NAMES[i])));
    head.extend(EMITTED.map(|i| format!("emission, {}", NAMES[i])));
    head.extend(["list", "fans", "strips"].map(|form| format!("indices, {form}")));
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
        cells.extend(row.drawn.iter().map(|drawn| format_count(drawn.index_count)));
        table.push(cells);
    }
    table
}
