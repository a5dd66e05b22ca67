//! Sections of the side panel that only scenes have: facts, animation, nodes and materials.

use egui::{Align, Color32, Grid, Layout, RichText, Slider, Ui};
use striata_command::output::{format_bytes, format_count, format_length, format_noun_count};
use striata_gpu::linear_to_srgb;

use super::playback::Playback;
use super::shown::ShownScene;
use super::subject::SceneSubject;
use super::tree::TreeRow;

/// Height of a list before it scrolls, points.
const LIST_HEIGHT: f32 = 180.0;

/// Indent per level of the tree, points, and the deepest level that is indented further.
const INDENT: f32 = 10.0;
const MAX_DEPTH: usize = 12;

/// Shows facts about the file and the scene.
pub(in crate::window) fn facts(subject: &SceneSubject, ui: &mut Ui) {
    let (scene, levels) = (subject.lods.scene(), subject.lods.levels());
    Grid::new("facts").num_columns(2).spacing([16.0, 3.0]).show(ui, |ui| {
        let mut row = |name: &str, value: String| {
            ui.weak(name);
            ui.label(value);
            ui.end_row();
        };
        row(
            "File",
            match subject.origin.file_bytes {
                Some(bytes) => format!("{}, {}", subject.origin.kind, format_bytes(bytes)),
                None => subject.origin.kind.to_owned(),
            },
        );
        let base = levels.base_triangle_count();
        row("Triangles", format!("{}, base {base}", format_count(levels.triangle_count())));
        row("Vertices", format_count(levels.vertex_count()));
        let mesh_count = subject.lods.lods().iter().flatten().count();
        let instances = format_noun_count(scene.instances().len(), "instance", "instances");
        row("Meshes", format!("{}, {instances}", format_count(mesh_count)));
        let texture_bytes: usize = subject.images.iter().map(|image| image.rgba.len()).sum();
        if texture_bytes > 4 * subject.images.len() {
            let count = subject.images.iter().filter(|image| image.rgba.len() > 4).count();
            row("Images", format!("{count}, {} of pixels", format_bytes(texture_bytes)));
        }
        row("Diagonal", format_length(subject.bounds.diagonal()));
        row("Max error", format_length(levels.base_error()));
    });
}

/// Shows the choice of the animation, and its time.
pub(in crate::window) fn animation_section(subject: &SceneSubject, playback: &mut Playback, ui: &mut Ui) {
    let name = |animation: usize| match subject.poser.animation_name(animation) {
        "" => format!("animation {animation}"),
        name => super::tree::printable(name),
    };
    ui.horizontal(|ui| {
        let label = if playback.is_playing { "Pause" } else { "Play" };
        if ui.button(label).on_hover_text("Space").clicked() {
            playback.toggle(&subject.poser);
        }
        let shown = playback.animation.map_or_else(|| "No animation".to_owned(), name);
        let mut chosen = playback.animation;
        egui::ComboBox::from_id_salt("animation").selected_text(shown).show_ui(ui, |ui| {
            ui.selectable_value(&mut chosen, None, "No animation");
            for animation in 0..subject.poser.animation_count() {
                ui.selectable_value(&mut chosen, Some(animation), name(animation));
            }
        });
        if chosen != playback.animation {
            playback.choose(chosen);
        }
    });
    let duration = playback.animation.map_or(0.0, |animation| subject.poser.duration(animation));
    ui.spacing_mut().slider_width = (ui.available_width() - 84.0).max(60.0);
    let slider = Slider::new(&mut playback.time, 0.0..=duration.max(f32::MIN_POSITIVE));
    let response = ui.add_enabled(duration > 0.0, slider.suffix(" s").max_decimals(2));
    if response.dragged() {
        playback.is_playing = false;
    }
    response.on_disabled_hover_text("Choose an animation first");
}

/// Action of the user on a row of the tree.
enum TreeAction {
    Hide(usize, bool),
    Fold(usize),
    Focus(usize),
}

/// Shows the nodes with their triangles; returns the row that the user wants to see.
pub(in crate::window) fn tree_section(
    subject: &SceneSubject,
    shown: &mut ShownScene,
    ui: &mut Ui,
) -> Option<usize> {
    let rows = visible_rows(&subject.rows, &shown.folded_rows);
    let mut action = None;
    let height = ui.text_style_height(&egui::TextStyle::Body).max(ui.spacing().interact_size.y);
    let list =
        egui::ScrollArea::vertical().id_salt("tree").max_height(LIST_HEIGHT).auto_shrink([false, true]);
    list.show_rows(ui, height, rows.len(), |ui, range| {
        for &row in &rows[range] {
            ui.push_id(row, |ui| {
                ui.horizontal(|ui| action = tree_row(subject, shown, row, ui).or(action.take()));
            });
        }
    });
    match action? {
        TreeAction::Hide(row, is_hidden) => shown.set_hidden(subject, row, is_hidden),
        TreeAction::Fold(row) => shown.folded_rows[row] ^= true,
        TreeAction::Focus(row) => return Some(row),
    }
    None
}

/// Rows that are not inside a folded one.
fn visible_rows(rows: &[TreeRow], folded: &[bool]) -> Vec<usize> {
    let mut visible = Vec::with_capacity(rows.len());
    let mut row = 0;
    while row < rows.len() {
        visible.push(row);
        row = if folded[row] { rows[row].end } else { row + 1 };
    }
    visible
}

fn tree_row(subject: &SceneSubject, shown: &ShownScene, row: usize, ui: &mut Ui) -> Option<TreeAction> {
    let mut action = None;
    let TreeRow { name, depth, end, instances } = &subject.rows[row];
    ui.add_space(INDENT * (*depth).min(MAX_DEPTH) as f32);
    if *end > row + 1 {
        let symbol = if shown.folded_rows[row] { "+" } else { "–" };
        if ui.add(egui::Button::new(symbol).frame(false)).clicked() {
            action = Some(TreeAction::Fold(row));
        }
    }
    let mut is_shown = !shown.is_hidden(row);
    let hover = "Show this node and everything below it";
    if ui.checkbox(&mut is_shown, "").on_hover_text(hover).clicked() {
        action = Some(TreeAction::Hide(row, !is_shown));
    }
    for material in materials_of(subject, instances) {
        let (name, color) = &subject.swatches[material];
        draw_swatch(ui, *color).on_hover_text(name);
    }
    // From the right, so that a long name does not push the numbers out.
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        if !instances.is_empty() {
            let of_all =
                |count: &dyn Fn(usize) -> usize| instances.iter().map(|&at| count(at)).sum::<usize>();
            let triangle_count = format_count(of_all(&|at| shown.triangles_of(at)));
            let full = format_count(of_all(&|at| subject.full_triangles_of(at)));
            ui.label(RichText::new(format!("{triangle_count} / {full}")).small().weak());
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let label = egui::Label::new(name).truncate().sense(egui::Sense::click());
            if ui.add(label).on_hover_text("Click to frame it").clicked() {
                action = Some(TreeAction::Focus(row));
            }
        });
    });
    action
}

/// Materials of some instances, each once, and not more than fit.
fn materials_of(subject: &SceneSubject, instances: &[usize]) -> Vec<usize> {
    const MOST: usize = 6;
    let mut materials = Vec::new();
    for &instance in instances.iter().take(1) {
        let mesh = subject.lods.scene().instances()[instance].mesh;
        for material in subject.primitive_materials[mesh].iter().flatten() {
            if *material < subject.swatches.len() && !materials.contains(material) && materials.len() < MOST {
                materials.push(*material);
            }
        }
    }
    materials
}

/// Shows the materials with their average colors.
pub(in crate::window) fn materials_section(subject: &SceneSubject, ui: &mut Ui) {
    let height = ui.text_style_height(&egui::TextStyle::Body).max(ui.spacing().interact_size.y);
    let list = egui::ScrollArea::vertical().id_salt("materials").max_height(LIST_HEIGHT / 2.0);
    let count = subject.swatches.len();
    list.auto_shrink([false, true]).show_rows(ui, height, count, |ui, range| {
        for ((name, color), material) in subject.swatches[range.clone()].iter().zip(&subject.materials[range])
        {
            ui.horizontal(|ui| {
                draw_swatch(ui, *color);
                ui.add(egui::Label::new(name).truncate());
                let count = [
                    &material.base_color_texture,
                    &material.metallic_roughness_texture,
                    &material.normal_texture,
                    &material.occlusion_texture,
                    &material.emissive_texture,
                ];
                let count = count.into_iter().flatten().count();
                if count > 0 {
                    let plural = if count == 1 { "" } else { "s" };
                    ui.label(RichText::new(format!("{count} texture{plural}")).small().weak());
                }
            });
        }
    });
}

/// Shows a color, linear light.
fn draw_swatch(ui: &mut Ui, color: [f32; 3]) -> egui::Response {
    const SIDE: f32 = 10.0;
    let [red, green, blue] = color.map(|x| (255.0 * linear_to_srgb(x)).round() as u8);
    let (rect, response) = ui.allocate_exact_size(egui::Vec2::splat(SIDE), egui::Sense::hover());
    ui.painter().rect_filled(rect, 2.0, Color32::from_rgb(red, green, blue));
    response
}
