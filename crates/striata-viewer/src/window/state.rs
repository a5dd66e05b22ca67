//! Settings of the viewer: everything that the panel and keys can change, except the camera.

use striata_gpu::{Look, Shading, Viewpoint};

use super::args::ShownModel;
use striata_command::args::Count;

impl ShownModel {
    /// All models, in the order of the panel.
    pub(super) const ALL: [Self; 7] =
        [Self::LodStrips, Self::LiveStrips, Self::Mts, Self::Fans, Self::FansGpu, Self::Patterns, Self::List];

    /// Name in the panel.
    pub(super) const fn title(self) -> &'static str {
        match self {
            Self::List => "List",
            Self::LodStrips => "LodStrips",
            Self::LiveStrips => "Live strips",
            Self::Mts => "MTS",
            Self::Fans => "Fans",
            Self::FansGpu => "GPU fans",
            Self::Patterns => "Patterns",
        }
    }

    /// Description for the panel.
    pub(super) const fn note(self) -> &'static str {
        match self {
            Self::List => "Triangle list, rebuilt and uploaded completely for each level",
            Self::LodStrips => "Strips edited in place; only changes are uploaded",
            Self::LiveStrips => "Strips repaired after every step; only changes are uploaded",
            Self::Mts => "Strips traversed again where they change, uploaded completely",
            Self::Fans => "Fans with view-dependent detail",
            Self::FansGpu => "Fans extracted in a compute shader; uploads one bit per step",
            Self::Patterns => "Fragment patterns with view-dependent detail",
        }
    }

    /// Whether the model supports view-dependent detail.
    const fn follows_views(self) -> bool {
        matches!(self, Self::Fans | Self::FansGpu | Self::Patterns)
    }

    /// Whether the model supports geomorphs.
    pub(super) const fn can_morph(self) -> bool {
        matches!(self, Self::Fans | Self::FansGpu)
    }

    /// Name of the model's primitives, if it has strips or fans.
    pub(super) const fn primitive_name(self) -> Option<&'static str> {
        match self {
            Self::LodStrips | Self::LiveStrips | Self::Mts => Some("Strips"),
            Self::Fans | Self::FansGpu => Some("Fans"),
            Self::List | Self::Patterns => None,
        }
    }
}

/// How the level is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GoalKind {
    /// By detail, from the base mesh to the full mesh.
    Detail,
    /// By triangle count, with uniform detail.
    Triangles,
    /// By screen error, pixels.
    Pixels,
    /// By triangle count, with detail optimized for the view.
    Budget,
}

/// The level to show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Goal {
    /// See [`GoalKind::Detail`].
    Detail(f64),
    /// See [`GoalKind::Triangles`].
    Triangles(usize),
    /// See [`GoalKind::Pixels`].
    Pixels(f32),
    /// See [`GoalKind::Budget`].
    Budget(usize),
}

/// How triangles are colored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Colors {
    /// The surface with its own colors.
    #[default]
    Surface,
    /// One color per strip or fan.
    StripsOrFans,
    /// One color per triangle.
    Triangles,
    /// One color per group.
    Groups,
}

/// Background of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Background {
    /// Dark or light, like the panel.
    #[default]
    Theme,
    /// A color chosen by the user, linear light.
    Custom([f32; 3]),
}

/// A frozen view: its level is kept while the camera moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frozen {
    /// Viewpoint when it was frozen.
    pub viewpoint: Viewpoint,
    /// Size of the picture, pixels.
    pub size: [u32; 2],
}

/// All settings.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ViewerState {
    pub model: ShownModel,
    /// Whether scenes are opened as they are, rather than as one mesh in a model.
    pub as_scene: bool,
    pub goal: GoalKind,
    /// Detail from 0 to 1.
    pub detail: f64,
    /// Maximum triangle count; none until a model is loaded.
    pub triangles: Option<usize>,
    pub pixels: f32,
    /// Like `triangles`, for view-dependent detail.
    pub budget: Option<usize>,
    /// Fraction of the first model's triangles, until it is loaded.
    pub first_triangles: Option<Count>,
    pub morphs: bool,
    pub frozen: Option<Frozen>,
    pub wireframe: bool,
    pub colors: Colors,
    pub is_flat: bool,
    pub shows_vertex_colors: bool,
    pub hides_back: bool,
    pub background: Background,
    pub auto_rotates: bool,
    pub shows_panel: bool,
    pub shows_plots: bool,
    pub shows_help: bool,
}

impl Default for ViewerState {
    fn default() -> Self {
        Self {
            model: ShownModel::LodStrips,
            as_scene: true,
            goal: GoalKind::Detail,
            detail: 1.0,
            triangles: None,
            pixels: 1.0,
            budget: None,
            first_triangles: None,
            morphs: false,
            frozen: None,
            wireframe: false,
            colors: Colors::Surface,
            is_flat: false,
            shows_vertex_colors: true,
            hides_back: false,
            background: Background::Theme,
            auto_rotates: false,
            shows_panel: true,
            shows_plots: true,
            shows_help: false,
        }
    }
}

/// Change of a setting by a key or button.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Action {
    /// Select a finer level.
    Finer,
    /// Select a coarser level.
    Coarser,
    /// Select the next model.
    NextModel,
    /// Toggle edges.
    Wireframe,
    /// Toggle colors by strip or fan.
    StripsOrFans,
    /// Toggle flat shading.
    Flat,
    /// Toggle geomorphs.
    Morphs,
    /// Toggle auto-rotation.
    Rotate,
    /// Toggle the side panel.
    Panel,
    /// Toggle the help.
    Help,
}

/// Factor on the triangle count or screen error per key press.
const STEP_FACTOR: f64 = 1.25;

impl ViewerState {
    /// The requested level.
    pub(super) fn requested_level(&self) -> Goal {
        match self.goal {
            GoalKind::Detail => Goal::Detail(self.detail),
            GoalKind::Triangles => Goal::Triangles(self.triangles.unwrap_or(usize::MAX)),
            GoalKind::Pixels => Goal::Pixels(self.pixels),
            GoalKind::Budget => Goal::Budget(self.budget.unwrap_or(usize::MAX)),
        }
    }

    /// Applies an action. `triangle_count` is that of the full mesh.
    pub(super) fn apply(&mut self, action: Action, triangle_count: usize, has_collapses: bool) {
        match action {
            Action::Finer => self.refine(true, triangle_count),
            Action::Coarser => self.refine(false, triangle_count),
            Action::NextModel => self.model = self.model_after(has_collapses),
            Action::Wireframe => self.wireframe ^= true,
            Action::StripsOrFans if self.colors == Colors::StripsOrFans => self.colors = Colors::Surface,
            Action::StripsOrFans => self.colors = Colors::StripsOrFans,
            Action::Flat => self.is_flat ^= true,
            Action::Morphs => self.morphs ^= true,
            Action::Rotate => self.auto_rotates ^= true,
            Action::Panel => self.shows_panel ^= true,
            Action::Help => self.shows_help ^= true,
        }
    }

    /// Chooses how the level is selected; view-dependent selection switches to a model that supports it.
    pub(super) fn set_goal(&mut self, goal: GoalKind) {
        self.goal = goal;
        let is_of_view = matches!(goal, GoalKind::Pixels | GoalKind::Budget);
        if is_of_view && !self.model.follows_views() {
            self.model = ShownModel::Fans;
        }
    }

    /// Freezes the level of this view, or unfreezes it.
    pub(super) fn freeze(&mut self, viewpoint: Viewpoint, size: [u32; 2]) {
        self.frozen = match self.frozen {
            None => Some(Frozen { viewpoint, size }),
            Some(_) => None,
        };
    }

    /// Sets the triangle limits, or remembers a fraction until a model is loaded.
    pub(super) fn set_triangle_count(&mut self, triangles: Count) {
        match triangles {
            Count::Number(count) => (self.triangles, self.budget) = (Some(count), Some(count)),
            Count::Share(_) => self.first_triangles = Some(triangles),
        }
    }

    /// Adapts to a new model: limits triangle counts to its size, and unfreezes the view.
    pub(super) fn on_new_model(&mut self, triangle_count: usize, has_collapses: bool) {
        let first = self.first_triangles.take().map(|share| share.of_triangles(triangle_count));
        for count in [&mut self.triangles, &mut self.budget] {
            *count = first.or(*count);
            *count = Some(count.unwrap_or(triangle_count / 10).clamp(1, triangle_count.max(1)));
        }
        self.frozen = None;
        if !has_collapses && self.model.needs_collapses() {
            self.model = ShownModel::Fans;
        }
    }

    /// The chosen colors, if the model supports them.
    pub(super) fn effective_colors(&self) -> Colors {
        match self.colors {
            Colors::StripsOrFans if self.model.primitive_name().is_none() => Colors::Surface,
            colors => colors,
        }
    }

    /// Whether individual triangles are drawn, with colors and edges.
    pub(super) fn needs_inspection(&self) -> bool {
        self.wireframe || matches!(self.effective_colors(), Colors::StripsOrFans | Colors::Triangles)
    }

    /// Whether individual triangles of a scene are drawn, instead of its materials.
    pub(super) fn scene_needs_inspection(&self) -> bool {
        self.wireframe || matches!(self.colors, Colors::Triangles | Colors::Groups)
    }

    /// Appearance of the surface on a dark or light background.
    pub(super) fn look(&self, is_dark: bool, pixels_per_point: f32) -> Look {
        let background = match self.background {
            Background::Custom([r, g, b]) => [r, g, b, 1.0],
            Background::Theme if is_dark => [0.012, 0.013, 0.017, 1.0],
            Background::Theme => [0.80, 0.82, 0.85, 1.0],
        };
        let edges = if self.wireframe { [0.02, 0.02, 0.03, 0.85] } else { [0.0; 4] };
        let shading = if self.is_flat { Shading::Flat } else { Shading::Smooth };
        Look::default()
            .with_background(background)
            .with_shading(shading)
            .with_edges(edges)
            .with_edge_width_px(pixels_per_point)
            .with_vertex_colors(self.shows_vertex_colors)
            .with_groups(self.effective_colors() == Colors::Groups)
            .with_back_hidden(self.hides_back)
    }

    fn refine(&mut self, is_finer: bool, triangle_count: usize) {
        let more = |n: Option<usize>, factor: f64| {
            let count = n.unwrap_or(triangle_count) as f64 * factor;
            Some((count.round() as usize).clamp(4, triangle_count.max(4)))
        };
        let factor = if is_finer { STEP_FACTOR } else { 1.0 / STEP_FACTOR };
        match self.goal {
            // Near the base, levels differ more per step, so detail changes by a factor.
            GoalKind::Detail => {
                let detail = if is_finer { (self.detail * factor).max(0.001) } else { self.detail * factor };
                self.detail = if detail < 0.001 { 0.0 } else { detail.min(1.0) };
            }
            GoalKind::Triangles => self.triangles = more(self.triangles, factor),
            GoalKind::Budget => self.budget = more(self.budget, factor),
            GoalKind::Pixels => self.pixels = (f64::from(self.pixels) / factor).clamp(0.05, 500.0) as f32,
        }
    }

    fn model_after(&self, has_collapses: bool) -> ShownModel {
        let usable = |&kind: &ShownModel| has_collapses || !kind.needs_collapses();
        let after = ShownModel::ALL.iter().skip_while(|&&kind| kind != self.model).skip(1);
        after.chain(&ShownModel::ALL).copied().find(usable).unwrap_or(self.model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fraction_refers_to_the_first_model() {
        let mut state = ViewerState { goal: GoalKind::Budget, ..Default::default() };
        state.set_triangle_count(Count::Share(0.25));
        state.on_new_model(1000, true);
        assert_eq!(state.requested_level(), Goal::Budget(250));
        state.on_new_model(100, true);
        assert_eq!(
            state.requested_level(),
            Goal::Budget(100),
            "a later model keeps the count, up to its size"
        );
        state.set_triangle_count(Count::Number(50));
        assert_eq!(state.requested_level(), Goal::Budget(50));
    }

    #[test]
    fn finer_and_coarser_undo_each_other_and_stay_in_range() {
        for goal in [GoalKind::Detail, GoalKind::Triangles, GoalKind::Pixels, GoalKind::Budget] {
            let mut state = ViewerState { detail: 0.5, goal, ..Default::default() };
            (state.triangles, state.budget) = (Some(1000), Some(1000));
            let before = state.clone();
            state.apply(Action::Coarser, 100_000, true);
            assert_ne!(state, before, "{goal:?}");
            state.apply(Action::Finer, 100_000, true);
            assert!((state.detail - 0.5).abs() < 1e-9 && (state.pixels - 1.0).abs() < 1e-5);
            assert_eq!([state.triangles, state.budget], [Some(1000); 2]);
            for action in [Action::Coarser, Action::Finer] {
                (0..500).for_each(|_| state.apply(action, 100_000, true));
                assert!((0.0..=1.0).contains(&state.detail) && state.pixels > 0.0, "{state:?}");
                let counts = [state.triangles, state.budget].map(|count| count.expect("a number"));
                assert!(counts.iter().all(|count| (4..=100_000).contains(count)), "{counts:?}");
            }
            let most = Some(100_000);
            let ends = [state.detail == 1.0, state.triangles == most, state.budget == most];
            assert_eq!(ends.iter().filter(|&&end| end).count(), usize::from(goal != GoalKind::Pixels));
        }
    }

    #[test]
    fn the_base_mesh_can_be_refined_again() {
        let mut state = ViewerState { detail: 0.0, ..Default::default() };
        state.apply(Action::Finer, 1000, true);
        assert!(state.detail > 0.0);
    }

    #[test]
    fn view_dependent_goals_select_a_model_that_supports_them() {
        let mut state = ViewerState::default();
        state.set_goal(GoalKind::Triangles);
        assert_eq!(state.model, ShownModel::LodStrips);
        state.set_goal(GoalKind::Pixels);
        assert_eq!((state.model, state.requested_level()), (ShownModel::Fans, Goal::Pixels(1.0)));
        let mut state = ViewerState { model: ShownModel::Patterns, ..Default::default() };
        state.set_goal(GoalKind::Budget);
        assert_eq!(state.model, ShownModel::Patterns, "patterns follow views too");
    }

    #[test]
    fn next_model_cycles_through_the_usable_models() {
        for (has_collapses, count) in [(true, ShownModel::ALL.len()), (false, ShownModel::ALL.len() - 2)] {
            let mut state = ViewerState::default();
            state.on_new_model(1000, has_collapses);
            let first = state.model;
            let mut seen = vec![first];
            loop {
                state.apply(Action::NextModel, 1000, has_collapses);
                if state.model == first {
                    break;
                }
                seen.push(state.model);
            }
            assert_eq!(seen.len(), count, "{seen:?}");
        }
    }

    #[test]
    fn a_view_can_be_frozen_and_unfrozen() {
        let viewpoint = Viewpoint { eye: [1.0; 3], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.7 };
        let mut state = ViewerState::default();
        state.freeze(viewpoint, [8, 6]);
        assert_eq!(state.frozen, Some(Frozen { viewpoint, size: [8, 6] }));
        state.freeze(viewpoint, [8, 6]);
        assert_eq!(state.frozen, None);
        state.freeze(viewpoint, [8, 6]);
        state.on_new_model(10, true);
        assert_eq!(state.frozen, None, "a new model unfreezes the view");
    }

    #[test]
    fn colors_by_strip_or_fan_need_strips_or_fans() {
        let mut state = ViewerState::default();
        state.apply(Action::StripsOrFans, 10, true);
        assert!(state.needs_inspection() && state.effective_colors() == Colors::StripsOrFans);
        state.model = ShownModel::List;
        assert!(!state.needs_inspection() && state.effective_colors() == Colors::Surface);
        state.apply(Action::Wireframe, 10, true);
        assert!(state.needs_inspection());
        assert!(state.look(true, 1.0).edges[3] > 0.0);
        assert_ne!(state.look(true, 1.0).background, state.look(false, 1.0).background);
    }
}
