//! The user interface around the picture: the side panel, progress, and errors.

use std::ops::RangeInclusive;

use egui::{Align, Color32, Grid, Layout, RichText, Slider, TextureId, ThemePreference, Ui};

use super::args::ShownModel;
use super::loader::Task;
use super::mesh_subject::MeshSubject;
use super::orbit::Up;
use super::scene;
use super::state::{Background, Colors, GoalKind};
use super::subject::Subject;
use super::viewer::{PictureArea, Viewer};
use super::{frustum, help, plots};
use striata_command::output::{format_bytes, format_count, format_length};

/// Description of scenes among the models.
const SCENE_NOTE: &str = "The scene as it is, with materials, lights and animations";

/// Why a setting is disabled for scenes.
const ONLY_MESHES: &str = "Only for one mesh: choose a model above to show the scene as one mesh";

/// Default width of the panel, points.
const WIDTH: f32 = 300.0;

/// Shows the whole user interface, and records in [`PictureArea`] where `picture` goes.
pub(super) fn show(viewer: &mut Viewer, ui: &mut Ui, picture: Option<TextureId>) {
    viewer.handle_input(ui.ctx());
    if viewer.state.shows_panel {
        egui::Panel::right("panel").default_size(WIDTH).size_range(220.0..=480.0).show(ui, |ui| {
            egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| sections(viewer, ui));
        });
    }
    egui::CentralPanel::no_frame().show(ui, |ui| middle(viewer, ui, picture));
    if viewer.state.shows_help {
        viewer.state.shows_help = help::show(ui.ctx());
    }
}

/// The picture and the overlays on it.
fn middle(viewer: &mut Viewer, ui: &mut Ui, picture: Option<TextureId>) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, egui::Sense::click_and_drag());
    viewer.handle_pointer(ui, &response);
    let pixels_per_point = ui.ctx().pixels_per_point();
    let pixels = |points: f32| (points * pixels_per_point).round().clamp(0.0, 16_384.0) as u32;
    viewer.area = PictureArea {
        rect,
        size: [pixels(rect.width()), pixels(rect.height())],
        pixels_per_point,
        is_dark: ui.visuals().dark_mode,
    };
    if let Some(picture) = picture {
        let whole = egui::Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
        ui.painter().image(picture, rect, whole, Color32::WHITE);
    }
    if let Some(frozen) = &viewer.state.frozen {
        frustum::draw(&ui.painter_at(rect), rect, &viewer.orbit.viewpoint(), frozen);
    }
    let is_dragged_over = ui.input(|input| !input.raw.hovered_files.is_empty());
    if is_dragged_over || (viewer.subject().is_none() && viewer.work().is_none()) {
        let text = "Drop a scene, a mesh or a .striata file here";
        let (center, font) = (rect.center(), egui::FontId::proportional(20.0));
        ui.painter().text(center, egui::Align2::CENTER_CENTER, text, font, ui.visuals().weak_text_color());
    }
    overlays(viewer, ui);
}

/// Progress and errors at the top of the picture.
fn overlays(viewer: &mut Viewer, ui: &Ui) {
    let overlay = |name: &str, from_top: f32| {
        egui::Area::new(egui::Id::unique(name)).constrain_to(viewer.area.rect).anchor(
            egui::Align2::LEFT_TOP,
            [viewer.area.rect.left() + 12.0, viewer.area.rect.top() + from_top],
        )
    };
    let mut from_top = 12.0;
    if let Some((task, progress)) = viewer.work() {
        let what = match task {
            Task::Open(path, _) => {
                path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
            }
            Task::Build(_, kind) => kind.title().to_owned(),
        };
        overlay("progress", from_top).show(ui.ctx(), |ui| {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_width(260.0);
                ui.label(format!("{what}: {}", progress.phase));
                match progress.share {
                    Some(share) => ui.add(egui::ProgressBar::new(share).show_percentage()),
                    None => ui.add(egui::ProgressBar::new(0.0).animate(true)),
                };
            });
        });
        from_top += 70.0;
    }
    let mut is_dismissed = false;
    if let Some(failure) = &viewer.failure {
        overlay("failure", from_top).show(ui.ctx(), |ui| {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_max_width(420.0);
                ui.colored_label(ui.visuals().error_fg_color, failure.message());
                if let Some(hint) = failure.hint() {
                    ui.label(RichText::new(format!("Hint: {hint}")));
                }
                is_dismissed = ui.button("Dismiss").clicked();
            });
        });
    }
    if is_dismissed {
        viewer.failure = None;
    }
}

fn sections(viewer: &mut Viewer, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.y = 2.0;
    ui.spacing_mut().button_padding.x = 6.0;
    ui.spacing_mut().interact_size.y = 17.0;
    ui.add_space(4.0);
    facts(viewer, ui);
    if viewer.files.len() > 1 {
        section(ui, "Files");
        let mut chosen = None;
        for (index, path) in viewer.files.iter().enumerate() {
            let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
            if ui.selectable_label(viewer.file == Some(index), name).clicked() {
                chosen = Some(index);
            }
        }
        chosen.into_iter().for_each(|index| viewer.choose(index));
    }
    scene_sections(viewer, ui);
    section(ui, "Level");
    level(viewer, ui);
    section(ui, "Model");
    model(viewer, ui);
    section(ui, "Appearance");
    look(viewer, ui);
    ui.add_space(4.0);
    ui.separator();
    ui.checkbox(&mut viewer.state.shows_plots, RichText::new("Frame statistics").strong());
    if viewer.state.shows_plots {
        plots::show(ui, &viewer.history);
    }
    ui.add_space(8.0);
    ui.horizontal(|ui| {
        let mut theme = ui.options(|options| options.theme_preference);
        ui.selectable_value(&mut theme, ThemePreference::System, "System");
        ui.selectable_value(&mut theme, ThemePreference::Light, "Light");
        ui.selectable_value(&mut theme, ThemePreference::Dark, "Dark");
        ui.ctx().set_theme(theme);
        if ui.button("Help").clicked() {
            viewer.state.shows_help ^= true;
        }
    });
    ui.label(RichText::new(&viewer.adapter).small().weak());
}

/// Sections of a scene.
fn scene_sections(viewer: &mut Viewer, ui: &mut Ui) {
    let Some((subject, shown, playback)) = viewer.scene_mut() else { return };
    if subject.poser.animation_count() > 0 {
        section(ui, "Animation");
        scene::animation_section(&subject, playback, ui);
    }
    section(ui, "Nodes");
    let focused = scene::tree_section(&subject, shown, ui);
    let bounds = focused.and_then(|row| shown.bounds_of(&subject, row));
    if subject.has_materials() {
        section(ui, "Materials");
        scene::materials_section(&subject, ui);
    }
    if let Some(bounds) = bounds {
        viewer.orbit.frame(&bounds);
    }
}

fn section(ui: &mut Ui, title: &str) {
    ui.add_space(4.0);
    ui.separator();
    ui.label(RichText::new(title).strong());
}

/// Facts about the file and the mesh.
fn facts(viewer: &Viewer, ui: &mut Ui) {
    let Some(subject) = viewer.subject() else {
        ui.heading("striata");
        ui.weak("No model loaded");
        return;
    };
    ui.heading(&subject.origin().name);
    match subject {
        Subject::Mesh(mesh) => mesh_facts(mesh, ui),
        Subject::Scene(subject) => scene::facts(subject, ui),
    }
}

fn mesh_facts(subject: &MeshSubject, ui: &mut Ui) {
    let (mesh, levels) = (subject.steps.mesh(), subject.steps.levels());
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
        row(
            "Triangles",
            format!("{}, base {}", format_count(mesh.triangle_count()), levels.triangle_count_at(0)),
        );
        row("Vertices", format_count(mesh.vertex_count()));
        if mesh.groups.len() > 1 {
            row("Groups", format_count(mesh.groups.len()));
        }
        row("Diagonal", format_length(subject.bounds.diagonal()));
        row("Max error", format_length(levels.error_at(0).into()));
    });
}

/// How the level is chosen, and the level that results.
fn level(viewer: &mut Viewer, ui: &mut Ui) {
    let Some(subject) = viewer.subject().cloned() else { return };
    let kinds = [
        (GoalKind::Detail, "Detail", "Uniform detail, from 0 (base mesh) to 1 (full mesh)"),
        (GoalKind::Triangles, "Triangles", "Maximum triangle count, with uniform detail"),
        (GoalKind::Pixels, "Pixels", "Maximum screen error; fans and patterns adapt to the view"),
        (GoalKind::Budget, "Budget", "Maximum triangle count, with detail optimized for the view"),
    ];
    ui.horizontal(|ui| {
        for (kind, name, note) in kinds {
            if ui.selectable_label(viewer.state.goal == kind, name).on_hover_text(note).clicked() {
                viewer.state.set_goal(kind);
            }
        }
    });
    let triangles = subject.base_triangle_count().max(1)..=subject.triangle_count().max(2);
    ui.spacing_mut().slider_width = (ui.available_width() - 84.0).max(60.0);
    let state = &mut viewer.state;
    match state.goal {
        GoalKind::Detail => {
            let slider = Slider::new(&mut state.detail, 0.0..=1.0).logarithmic(true).smallest_positive(1e-3);
            ui.add(slider.max_decimals(4))
        }
        GoalKind::Triangles => count_slider(ui, &mut state.triangles, triangles),
        GoalKind::Budget => count_slider(ui, &mut state.budget, triangles),
        GoalKind::Pixels => ui
            .add(Slider::new(&mut state.pixels, 0.1..=100.0).logarithmic(true).suffix(" px").max_decimals(2)),
    };
    let Some(achieved) = viewer.achieved().copied() else { return };
    let error_px = viewer.error_px();
    Grid::new("achieved").num_columns(2).spacing([16.0, 3.0]).show(ui, |ui| {
        let mut row = |name: &str, value: String| {
            ui.weak(name);
            ui.label(RichText::new(value).monospace());
            ui.end_row();
        };
        let share = 100.0 * achieved.triangle_count as f64 / subject.triangle_count().max(1) as f64;
        row("Triangles", format!("{} ({share:.1}%)", format_count(achieved.triangle_count)));
        if let Some(mesh) = subject.mesh() {
            let step_count = mesh.steps.levels().step_count();
            let splits = format_count(achieved.split_count);
            row("Splits", format!("{splits} of {}", format_count(step_count)));
        }
        // Instances of a scene have errors of their own, so a view has a screen error only.
        if subject.mesh().is_some() || achieved.error_px.is_none() {
            row("Error", format_length(achieved.error.into()));
        }
        row(
            "Screen error",
            match error_px {
                Some(pixels) => format!("{pixels:.2} px"),
                None => "–".to_owned(),
            },
        );
    });
}

fn count_slider(ui: &mut Ui, count: &mut Option<usize>, range: RangeInclusive<usize>) -> egui::Response {
    let mut value = count.unwrap_or(*range.end());
    let response = ui.add(Slider::new(&mut value, range).logarithmic(true));
    *count = Some(value);
    response
}

/// Choice between the scene as it is, and the models of one mesh.
fn model(viewer: &mut Viewer, ui: &mut Ui) {
    let Some(subject) = viewer.subject().cloned() else { return };
    let is_scene = subject.scene().is_some();
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        if subject.origin().has_scene {
            let response = ui.selectable_label(is_scene, "Scene");
            if response.on_hover_text(SCENE_NOTE).clicked() && !is_scene {
                viewer.show_as_scene();
            }
        }
        for kind in ShownModel::ALL {
            let is_usable = subject.has_collapses() || !kind.needs_collapses();
            let is_stored = subject.mesh().is_some_and(|mesh| mesh.stored.contains(&kind));
            let origin = if is_stored { " (stored in the file)" } else { "" };
            let origin = if is_scene { "; shows the scene as one mesh without materials" } else { origin };
            let label = egui::Button::selectable(!is_scene && viewer.state.model == kind, kind.title());
            let response = ui.add_enabled(is_usable, label);
            if response.on_hover_text(format!("{}{origin}", kind.note())).clicked() {
                chosen = Some(kind);
            }
        }
    });
    match chosen {
        Some(kind) if is_scene => viewer.show_as_mesh(kind),
        Some(kind) => viewer.state.model = kind,
        None => {}
    }
    let note = if is_scene { SCENE_NOTE } else { viewer.state.model.note() };
    ui.label(RichText::new(note).small().weak());
    if !is_scene {
        morphs(viewer, ui);
    }
    let mut is_frozen = viewer.state.frozen.is_some();
    let hover = "Keep the level of this view while the camera moves";
    if ui.checkbox(&mut is_frozen, "Freeze level").on_hover_text(hover).clicked() {
        viewer.state.freeze(viewer.orbit.viewpoint(), viewer.area.size);
    }
}

fn morphs(viewer: &mut Viewer, ui: &mut Ui) {
    let can_morph = viewer.state.model.can_morph();
    ui.add_enabled(can_morph, egui::Checkbox::new(&mut viewer.state.morphs, "Geomorphs"))
        .on_disabled_hover_text("Only available for fans")
        .on_hover_text("Vertices move smoothly instead of jumping; not with wireframe or triangle colors");
}

/// Appearance of the surface.
fn look(viewer: &mut Viewer, ui: &mut Ui) {
    let is_mesh = viewer.scene().is_none();
    let state = &mut viewer.state;
    let primitive_name = state.model.primitive_name();
    ui.horizontal_wrapped(|ui| {
        let shown = match state.colors {
            Colors::StripsOrFans if !is_mesh => Colors::Surface,
            colors if !is_mesh => colors,
            _ => state.effective_colors(),
        };
        let mut choice = |ui: &mut Ui, colors, name: &str, is_enabled| {
            let button = egui::Button::selectable(shown == colors, name);
            let is_enabled = is_enabled && (is_mesh || colors != Colors::StripsOrFans);
            let response = ui.add_enabled(is_enabled, button);
            let reason = if is_mesh { "The model has no such parts" } else { ONLY_MESHES };
            if response.on_disabled_hover_text(reason).clicked() {
                state.colors = colors;
            }
        };
        choice(ui, Colors::Surface, "Surface", true);
        choice(ui, Colors::StripsOrFans, primitive_name.unwrap_or("Strips"), primitive_name.is_some());
        choice(ui, Colors::Triangles, "Triangles", true);
        choice(ui, Colors::Groups, "Groups", true);
    });
    Grid::new("look").num_columns(2).spacing([16.0, 4.0]).show(ui, |ui| {
        let mesh_only = |ui: &mut Ui, value: &mut bool, name: &str| {
            let response = ui.add_enabled(is_mesh, egui::Checkbox::new(value, name));
            response.on_disabled_hover_text(ONLY_MESHES);
        };
        let wireframe = ui.checkbox(&mut state.wireframe, "Wireframe");
        if !is_mesh {
            wireframe.on_hover_text("Edges, over the average color of each material");
        }
        mesh_only(ui, &mut state.is_flat, "Flat shading");
        ui.end_row();
        mesh_only(ui, &mut state.hides_back, "Cull back faces");
        mesh_only(ui, &mut state.shows_vertex_colors, "Vertex colors");
        ui.end_row();
        ui.checkbox(&mut state.auto_rotates, "Auto-rotate");
        let mut is_z_up = viewer.orbit.up() == Up::Z;
        if ui.checkbox(&mut is_z_up, "Z up").clicked() {
            viewer.orbit.set_up(if is_z_up { Up::Z } else { Up::Y });
        }
        ui.end_row();
    });
    ui.horizontal(|ui| {
        ui.label("Background");
        let is_custom = matches!(state.background, Background::Custom(_));
        if ui.selectable_label(!is_custom, "Theme").clicked() {
            state.background = Background::Theme;
        }
        let mut color = match state.background {
            Background::Custom(color) => color,
            Background::Theme => [0.2, 0.25, 0.3],
        };
        if ui.color_edit_button_rgb(&mut color).changed() {
            state.background = Background::Custom(color);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button("Reset view").clicked() {
                viewer.orbit.reset();
            }
        });
    });
}
