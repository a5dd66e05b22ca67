//! What is shown and how: everything that panel and keys change, apart from where one looks from.

use striata_gpu::{Look, Shading, Viewpoint};

use super::args::ShownModel;
use striata_command::args::Count;

impl ShownModel {
    /// All of them, as the panel lists them.
    pub(super) const ALL: [Self; 6] =
        [Self::LodStrips, Self::Mts, Self::Fans, Self::FansGpu, Self::Patterns, Self::List];

    /// As the panel names it.
    pub(super) const fn title(self) -> &'static str {
        match self {
            Self::List => "List",
            Self::LodStrips => "LodStrips",
            Self::Mts => "MTS",
            Self::Fans => "Fans",
            Self::FansGpu => "GPU fans",
            Self::Patterns => "Patterns",
        }
    }

    /// What one should know of it.
    pub(super) const fn note(self) -> &'static str {
        match self {
            Self::List => "Triangles made anew for each level, and uploaded whole",
            Self::LodStrips => "Strips edited in place; only what changed is uploaded",
            Self::Mts => "Strips walked anew where they change, uploaded whole",
            Self::Fans => "Follows the view: finer where the screen asks for it",
            Self::FansGpu => "Fans made in a compute shader; a bit a step is uploaded",
            Self::Patterns => "Follows the view in fragments of any kind",
        }
    }

    /// Whether the level may differ from place to place.
    pub(super) const fn follows_views(self) -> bool {
        matches!(self, Self::Fans | Self::FansGpu | Self::Patterns)
    }

    /// Whether changes are shown as motion.
    pub(super) const fn can_morph(self) -> bool {
        matches!(self, Self::Fans | Self::FansGpu)
    }

    /// What its triangles are parts of, where they are.
    pub(super) const fn pieces(self) -> Option<&'static str> {
        match self {
            Self::LodStrips | Self::Mts => Some("Strips"),
            Self::Fans | Self::FansGpu => Some("Fans"),
            Self::List | Self::Patterns => None,
        }
    }
}

/// By what a level is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GoalKind {
    /// A share of the way from the base to the full mesh.
    Detail,
    /// A number of triangles, the same detail everywhere.
    Triangles,
    /// Pixels that an error may take.
    Pixels,
    /// The triangles that this view shows best.
    Budget,
}

/// A level that is wanted.
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

/// How triangles are told apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Colors {
    /// Not at all: the surface with its own colors.
    #[default]
    Surface,
    /// Each strip or fan has a color.
    Pieces,
    /// Each triangle has one.
    Triangles,
    /// Each group has one.
    Groups,
}

/// What is behind the model.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Background {
    /// As the panel: dark or light.
    #[default]
    Theme,
    /// A color of the user's, linear light.
    Own([f32; 3]),
}

/// The view that a level was made for and is kept for, while one looks from elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frozen {
    /// Where one looked from.
    pub(super) viewpoint: Viewpoint,
    /// The picture, pixels.
    pub(super) size: [u32; 2],
}

/// Everything that can be chosen.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ViewerState {
    pub(super) model: ShownModel,
    pub(super) goal: GoalKind,
    /// 0 to 1.
    pub(super) detail: f64,
    /// None before there is a model to count them of.
    pub(super) triangles: Option<usize>,
    pub(super) pixels: f32,
    /// As `triangles`.
    pub(super) budget: Option<usize>,
    /// A share of the triangles of the first model.
    pub(super) first_triangles: Option<Count>,
    pub(super) morphs: bool,
    pub(super) frozen: Option<Frozen>,
    pub(super) wireframe: bool,
    pub(super) colors: Colors,
    pub(super) is_flat: bool,
    pub(super) shows_vertex_colors: bool,
    pub(super) hides_back: bool,
    pub(super) background: Background,
    pub(super) turns: bool,
    pub(super) shows_panel: bool,
    pub(super) shows_plots: bool,
    pub(super) shows_help: bool,
}

impl Default for ViewerState {
    fn default() -> Self {
        Self {
            model: ShownModel::LodStrips,
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
            turns: false,
            shows_panel: true,
            shows_plots: true,
            shows_help: false,
        }
    }
}

/// What a key or a button asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Action {
    /// A finer level.
    Finer,
    /// A coarser level.
    Coarser,
    /// The next model.
    NextModel,
    /// Edges or none.
    Wireframe,
    /// Colors of strips or fans, or none.
    Pieces,
    /// Flat or smooth.
    Flat,
    /// Motion instead of jumps, or not.
    Morphs,
    /// Turning by itself, or not.
    Turn,
    /// The side panel.
    Panel,
    /// The list of keys.
    Help,
}

/// How much finer a step is: the number of triangles it takes.
const STEP: f64 = 1.25;

impl ViewerState {
    /// The level that is wanted.
    pub(super) fn wanted(&self) -> Goal {
        match self.goal {
            GoalKind::Detail => Goal::Detail(self.detail),
            GoalKind::Triangles => Goal::Triangles(self.triangles.unwrap_or(usize::MAX)),
            GoalKind::Pixels => Goal::Pixels(self.pixels),
            GoalKind::Budget => Goal::Budget(self.budget.unwrap_or(usize::MAX)),
        }
    }

    /// Does what a key asks for. `triangle_count` is the full mesh's.
    pub(super) fn apply(&mut self, action: Action, triangle_count: usize, has_collapses: bool) {
        match action {
            Action::Finer => self.refine(true, triangle_count),
            Action::Coarser => self.refine(false, triangle_count),
            Action::NextModel => self.model = self.model_after(has_collapses),
            Action::Wireframe => self.wireframe ^= true,
            Action::Pieces if self.colors == Colors::Pieces => self.colors = Colors::Surface,
            Action::Pieces => self.colors = Colors::Pieces,
            Action::Flat => self.is_flat ^= true,
            Action::Morphs => self.morphs ^= true,
            Action::Turn => self.turns ^= true,
            Action::Panel => self.shows_panel ^= true,
            Action::Help => self.shows_help ^= true,
        }
    }

    /// Chooses by what a level is told; what only a view tells takes a model that follows it.
    pub(super) fn set_goal(&mut self, goal: GoalKind, has_collapses: bool) {
        self.goal = goal;
        let is_of_view = matches!(goal, GoalKind::Pixels | GoalKind::Budget);
        if is_of_view && !self.model.follows_views() {
            self.model = if has_collapses { ShownModel::Fans } else { ShownModel::Patterns };
        }
    }

    /// Keeps the level of this view while one looks from elsewhere; or lets it follow again.
    pub(super) fn freeze(&mut self, viewpoint: Viewpoint, size: [u32; 2]) {
        self.frozen = match self.frozen {
            None => Some(Frozen { viewpoint, size }),
            Some(_) => None,
        };
    }

    /// Takes a number of triangles, or a share that becomes one once there is a model.
    pub(super) fn ask_for(&mut self, triangles: Count) {
        match triangles {
            Count::Number(count) => (self.triangles, self.budget) = (Some(count), Some(count)),
            Count::Share(_) => self.first_triangles = Some(triangles),
        }
    }

    /// A new model has come: numbers of triangles are no more than it has, and no view is kept.
    pub(super) fn meet(&mut self, triangle_count: usize, has_collapses: bool) {
        let first = self.first_triangles.take().map(|share| share.of_triangles(triangle_count));
        for count in [&mut self.triangles, &mut self.budget] {
            *count = first.or(*count);
            *count = Some(count.unwrap_or(triangle_count / 10).clamp(1, triangle_count.max(1)));
        }
        self.frozen = None;
        if !has_collapses && !matches!(self.model, ShownModel::List | ShownModel::Patterns) {
            self.model = ShownModel::Patterns;
        }
    }

    /// The colors that this model can show.
    pub(super) fn colors_shown(&self) -> Colors {
        match self.colors {
            Colors::Pieces if self.model.pieces().is_none() => Colors::Surface,
            colors => colors,
        }
    }

    /// Whether single triangles are drawn, each with colors and edges of its own.
    pub(super) fn inspects(&self) -> bool {
        self.wireframe || matches!(self.colors_shown(), Colors::Pieces | Colors::Triangles)
    }

    /// How the surface looks on a dark or a light background.
    pub(super) fn look(&self, is_dark: bool, pixels_per_point: f32) -> Look {
        let background = match self.background {
            Background::Own([r, g, b]) => [r, g, b, 1.0],
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
            .with_groups(self.colors_shown() == Colors::Groups)
            .with_back_hidden(self.hides_back)
    }

    fn refine(&mut self, is_finer: bool, triangle_count: usize) {
        let more = |n: Option<usize>, factor: f64| {
            let count = n.unwrap_or(triangle_count) as f64 * factor;
            Some((count.round() as usize).clamp(4, triangle_count.max(4)))
        };
        let factor = if is_finer { STEP } else { 1.0 / STEP };
        match self.goal {
            // Half of the way is half of the steps, far more than a person sees: near the base they count more.
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
        let usable =
            |&kind: &ShownModel| has_collapses || matches!(kind, ShownModel::List | ShownModel::Patterns);
        let after = ShownModel::ALL.iter().skip_while(|&&kind| kind != self.model).skip(1);
        after.chain(&ShownModel::ALL).copied().find(usable).unwrap_or(self.model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_one_of_the_first_model() {
        let mut state = ViewerState { goal: GoalKind::Budget, ..Default::default() };
        state.ask_for(Count::Share(0.25));
        state.meet(1000, true);
        assert_eq!(state.wanted(), Goal::Budget(250));
        state.meet(100, true);
        assert_eq!(state.wanted(), Goal::Budget(100), "a later model has what there was, as far as it goes");
        state.ask_for(Count::Number(50));
        assert_eq!(state.wanted(), Goal::Budget(50));
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
    fn the_base_can_be_left_again() {
        let mut state = ViewerState { detail: 0.0, ..Default::default() };
        state.apply(Action::Finer, 1000, true);
        assert!(state.detail > 0.0);
    }

    #[test]
    fn what_a_view_tells_takes_a_model_that_follows_it() {
        let mut state = ViewerState::default();
        state.set_goal(GoalKind::Triangles, true);
        assert_eq!(state.model, ShownModel::LodStrips);
        state.set_goal(GoalKind::Pixels, true);
        assert_eq!((state.model, state.wanted()), (ShownModel::Fans, Goal::Pixels(1.0)));
        let mut state = ViewerState::default();
        state.set_goal(GoalKind::Budget, false);
        assert_eq!(state.model, ShownModel::Patterns);
    }

    #[test]
    fn models_come_in_turn_and_only_those_that_can() {
        for (has_collapses, count) in [(true, ShownModel::ALL.len()), (false, 2)] {
            let mut state = ViewerState::default();
            state.meet(1000, has_collapses);
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
    fn a_view_is_frozen_and_let_go() {
        let viewpoint = Viewpoint { eye: [1.0; 3], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.7 };
        let mut state = ViewerState::default();
        state.freeze(viewpoint, [8, 6]);
        assert_eq!(state.frozen, Some(Frozen { viewpoint, size: [8, 6] }));
        state.freeze(viewpoint, [8, 6]);
        assert_eq!(state.frozen, None);
        state.freeze(viewpoint, [8, 6]);
        state.meet(10, true);
        assert_eq!(state.frozen, None, "a new model has not been seen from there");
    }

    #[test]
    fn colors_of_pieces_need_pieces() {
        let mut state = ViewerState::default();
        state.apply(Action::Pieces, 10, true);
        assert!(state.inspects() && state.colors_shown() == Colors::Pieces);
        state.model = ShownModel::List;
        assert!(!state.inspects() && state.colors_shown() == Colors::Surface);
        state.apply(Action::Wireframe, 10, true);
        assert!(state.inspects());
        assert!(state.look(true, 1.0).edges[3] > 0.0);
        assert_ne!(state.look(true, 1.0).background, state.look(false, 1.0).background);
    }
}
