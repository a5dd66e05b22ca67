//! Sources of levels: a mesh alone, a mesh that is simplified for the picture, a file with levels, or a
//! scene.

use striata::file::{DecodeError, StriataFile};
use striata::levels::{PatternLevels, fan_level};
use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh, weld};
use striata::model::{Fans, LodStrips, ModelKind, Mts, Patterns, StoredModel, StripModel};
use striata::simplify::Target;
use striata::strip::{StripSet, stripify};

use super::figure::Figure;
use super::scene_source::SceneSource;
use crate::args::{DrawnModel, RenderArgs};
use crate::commands::levels::camera;
use striata::mesh::Steps;
use striata_command::args::{Coloring, Count, Point};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{CoarseningLimit, FullMesh, ReachedLevel, shortfall};
use striata_command::output::{Bar, Output, format_count};
use striata_command::sequence::SequencePlan;
use striata_render::{SceneLook, with_normals};
use striata_scene::drawn::ImageLimits;

/// The source of the levels in a picture.
pub(super) enum PictureSource<'a> {
    /// A mesh with levels.
    Levels(Box<DrawnLevels<'a>>, Option<Box<SceneLook>>),
    /// A scene in a pose, with or without levels.
    Scene(Box<SceneSource>),
    /// A mesh that is drawn unchanged, or the level for a view, made of pages.
    Fixed(Box<Figure>, Option<Box<SceneLook>>),
}

/// All levels of a mesh, and the model that provides their triangles.
pub(super) struct DrawnLevels<'a> {
    steps: Steps,
    model: Model<'a>,
    error_is_guaranteed: bool,
    file: Option<StriataFile<'a>>,
    /// The limits of a picture of pages, which are read only as far as it needs them.
    pages: Option<PageLimits>,
}

/// How large the mesh of a paged file is, and how much of it a picture shows.
#[derive(Clone, Copy)]
pub(super) struct PageLimits {
    pub full: FullMesh,
    pub triangle_count: usize,
}

/// The model that provides the triangles of a level.
enum Model<'a> {
    LodStrips(LodStrips<'a>),
    Mts(Mts<'a>),
    Fans(Fans),
    Patterns(Patterns),
    List,
}

impl<'a> PictureSource<'a> {
    /// Reads the input; simplifies a mesh only if the picture needs levels.
    ///
    /// # Errors
    /// If the input is malformed, or does not have the requested model.
    pub(super) fn read(
        args: &RenderArgs,
        input: &'a Input,
        output: &Output,
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let in_file = |error: Failure| error.in_file(&input.name);
        if let Some(scene) = SceneSource::read(args, input, output, bar)? {
            return Ok(Self::Scene(Box::new(scene)));
        }
        if input.has_levels() {
            let file = input.striata()?;
            input.remark_on(&file, output)?;
            let levels = DrawnLevels::of_file(args, file, input)?;
            let look = look_of(args, levels.steps.mesh());
            return Ok(Self::Levels(Box::new(levels), look));
        }
        let mesh = input.mesh(output)?;
        mesh.check().map_err(|error| in_file(error.into()))?;
        let look = look_of(args, &mesh);
        if !args.needs_levels() {
            return Ok(Self::Fixed(Box::new(Figure::of_mesh(with_normals(mesh))), look));
        }
        let welded = weld(&mesh).map_err(|error| in_file(error.into()))?;
        let sequenced = SequencePlan::default().run(welded, &mut |progress| bar.show(progress));
        let steps = with_level_normals(sequenced.map_err(|error| in_file(error.into()))?.steps);
        let model = Model::built(args.model.unwrap_or(default_model(args)), &steps)?;
        let levels = DrawnLevels { steps, model, error_is_guaranteed: false, file: None, pages: None };
        Ok(Self::Levels(Box::new(levels), look))
    }

    /// Keeps pictures of a paged file within its limits.
    pub(super) fn of_pages(mut self, pages: PageLimits) -> Self {
        if let Self::Levels(levels, _) = &mut self {
            levels.pages = Some(pages);
        }
        self
    }

    /// Wraps the level for a view, made of pages.
    pub(super) fn of_view(args: &RenderArgs, figure: Figure) -> Self {
        let look = look_of(args, &figure.mesh);
        Self::Fixed(Box::new(figure), look)
    }

    /// Returns the materials, if the picture shows them.
    pub(super) fn look(&self) -> Option<&SceneLook> {
        match self {
            Self::Levels(_, look) | Self::Fixed(_, look) => look.as_deref(),
            Self::Scene(scene) => scene.look(),
        }
    }

    /// Returns the scene, if the source is one.
    pub(super) fn scene(&self) -> Option<&SceneSource> {
        match self {
            Self::Scene(scene) => Some(scene),
            _ => None,
        }
    }

    /// Returns the full mesh, with normals.
    pub(super) fn mesh(&self) -> &IndexedMesh {
        match self {
            Self::Levels(levels, _) => levels.steps.mesh(),
            Self::Scene(scene) => scene.mesh(),
            Self::Fixed(figure, _) => &figure.mesh,
        }
    }

    /// Returns the diagonal of the bounding box of the full mesh.
    pub(super) fn diagonal(&self) -> f64 {
        self.mesh().diagonal()
    }

    /// Returns the sizes that percentages of targets refer to.
    pub(super) fn full(&self) -> FullMesh {
        let diagonal = self.diagonal();
        match self {
            Self::Levels(levels, _) => match levels.pages {
                Some(pages) => FullMesh { diagonal, ..pages.full },
                None => FullMesh::of_levels(levels.steps.levels(), diagonal),
            },
            Self::Scene(scene) => scene.full(),
            Self::Fixed(figure, _) => FullMesh {
                diagonal,
                vertex_count: figure.mesh.vertex_count(),
                triangle_count: figure.mesh.triangle_count(),
            },
        }
    }

    /// Returns the level for a target, or the full mesh if there is none.
    ///
    /// # Errors
    /// If its strips cannot be made.
    pub(super) fn target(&self, target: Option<Target>) -> Result<Figure, Failure> {
        let levels = match self {
            Self::Scene(scene) => return scene.target(target),
            Self::Fixed(figure, _) => return Ok(Figure::clone(figure)),
            Self::Levels(levels, _) => levels,
        };
        let known = levels.steps.levels();
        let finest = levels.finest();
        let Some(target) = target else { return levels.figure(finest) };
        let target = levels.of_file_read(target);
        let (split_count, stop_reason) = target.resolve_in(known);
        let split_count = split_count.min(finest);
        let figure = levels.figure(split_count)?;
        let (vertex_count, triangle_count) = (figure.vertex_count, figure.mesh.triangle_count());
        let reached = ReachedLevel { vertex_count, triangle_count, stop_reason };
        Ok(Figure { shortfall: shortfall(target, reached, &levels.coarsening_limit()), ..figure })
    }

    /// Returns the level with at most this number or percentage of triangles.
    ///
    /// # Errors
    /// If its strips cannot be made.
    pub(super) fn triangles(&self, count: Count) -> Result<Figure, Failure> {
        let title = match count {
            Count::Number(count) => format_count(count),
            Count::Share(share) => format!("{} %", (100_000.0 * share).round() / 1000.0),
        };
        let target = Target::Triangles(count.of_triangles(self.full().triangle_count));
        Ok(Figure { title, ..self.target(Some(target))? })
    }

    /// Returns the level for a view.
    ///
    /// # Errors
    /// If the camera is degenerate, or the file is damaged.
    pub(super) fn view(&self, args: &RenderArgs, eye: Point, input: &Input) -> Result<Figure, Failure> {
        let levels = match self {
            Self::Levels(levels, _) => levels,
            Self::Scene(scene) => return scene.view(args, eye),
            Self::Fixed(figure, _) => return Ok(Figure::clone(figure)),
        };
        let origin = self.mesh().origin;
        let view = args.view.on_screen(args.size.0);
        let camera = camera(&view, eye, origin, self.mesh().bounds())?;
        let criterion = view.relative_to(origin).criterion(camera);
        let limit =
            args.level.level.triangle_count().map(|count| count.of_triangles(self.full().triangle_count));
        let stored_patterns = levels.file.as_ref().filter(|_| levels.has_patterns_only());
        let patterns = match (&levels.model, stored_patterns.and_then(StriataFile::patterns)) {
            (Model::Patterns(model), _) => Some(Patterns::clone(model)),
            (_, Some(patterns)) => Some(patterns.map_err(|error| input.damaged(&error))?),
            _ => None,
        };
        if let Some(patterns) = patterns {
            let patterns = PatternLevels::new(patterns, levels.steps.mesh().clone());
            let level = patterns.view(&criterion, limit);
            return Ok(Figure::of_view(ModelKind::Patterns, level, &view, limit));
        }
        let stored = levels.file.as_ref().and_then(StriataFile::fans).transpose();
        let stored = stored.map_err(|error| input.damaged(&error))?;
        let fans = stored.unwrap_or_else(|| Fans::build(&levels.steps));
        let level = fan_level(&fans, &levels.steps, &criterion, limit);
        Ok(Figure::of_view(ModelKind::Fans, level, &view, limit))
    }
}

impl<'a> DrawnLevels<'a> {
    /// Number of splits of the finest level that a picture shows.
    fn finest(&self) -> usize {
        let known = self.steps.levels();
        self.pages.map_or(known.step_count(), |pages| known.split_count_for_triangles(pages.triangle_count))
    }

    /// Expresses a share of the splits of a paged file by vertices, since only some of the splits were read.
    fn of_file_read(&self, target: Target) -> Target {
        match (self.pages, target) {
            (Some(pages), Target::Detail(share)) => {
                let base = self.steps.levels().base_vertex_count();
                let splits = pages.full.vertex_count.saturating_sub(base);
                Target::Vertices(base + (share * splits as f64).round() as usize)
            }
            _ => target,
        }
    }

    /// Returns why no coarser level exists.
    fn coarsening_limit(&self) -> CoarseningLimit {
        match self.file {
            Some(_) => CoarseningLimit::File,
            None => CoarseningLimit::Simplification(
                "no more edges can be collapsed without removing the last triangles".to_owned(),
            ),
        }
    }

    /// Reads the levels of a file.
    ///
    /// # Errors
    /// If the file is damaged, or the requested model is neither in the file nor can be built.
    fn of_file(args: &RenderArgs, file: StriataFile<'a>, input: &Input) -> Result<Self, Failure> {
        let damaged = |error| input.damaged(&error);
        let error_is_guaranteed = file.has_guaranteed_errors().map_err(damaged)?;
        let steps = with_level_normals(file.steps().map_err(damaged)?);
        let stored = match args.model {
            _ if args.heat => None,
            Some(DrawnModel::List) => None,
            Some(DrawnModel::Model(kind)) => Model::stored(&file, kind),
            None => ModelKind::ALL.into_iter().find_map(|kind| Model::stored(&file, kind)),
        };
        let model = match stored {
            Some(model) => model.map_err(damaged)?,
            None if args.heat => Model::List,
            None => Model::built(args.model.unwrap_or(default_model(args)), &steps)?,
        };
        Ok(Self { steps, model, error_is_guaranteed, file: Some(file), pages: None })
    }

    /// Whether patterns are the only model that views can use.
    fn has_patterns_only(&self) -> bool {
        let has =
            |file: &StriataFile<'_>| file.has_model(ModelKind::Patterns) && !file.has_model(ModelKind::Fans);
        self.file.as_ref().is_some_and(has)
    }

    /// Returns the figure of a level.
    ///
    /// # Errors
    /// Never, since strips are those of the model.
    fn figure(&self, split_count: usize) -> Result<Figure, Failure> {
        let known = self.steps.levels();
        let (mesh, strips) = match &self.model {
            Model::LodStrips(model) => (self.steps.level(split_count), Some(strips_at(model, split_count))),
            Model::Mts(model) => (self.steps.level(split_count), Some(strips_at(model, split_count))),
            Model::Fans(model) => (self.level_of(model, split_count), None),
            Model::Patterns(model) => (self.level_of(model, split_count), None),
            Model::List => (self.steps.level(split_count), None),
        };
        let step_of = |&[a, b, c]: &[u32; 3]| known.step_of(a.max(b).max(c));
        let steps = self.pages.is_none().then(|| mesh.triangles.iter().map(step_of).collect());
        Ok(Figure {
            title: String::new(),
            shortfall: None,
            model: self.model.name(),
            split_count: Some(split_count),
            vertex_count: known.vertex_count_at(split_count),
            error: known.error_at(split_count),
            error_is_guaranteed: self.error_is_guaranteed,
            pixels: None,
            mesh,
            strips,
            steps,
        })
    }

    /// Returns a level with the triangles of a model without strips.
    fn level_of<M: StoredModel>(&self, model: &M, split_count: usize) -> IndexedMesh {
        let mut state = model.new_state();
        model.move_to(&mut state, split_count);
        let mut level = self.steps.level(split_count);
        level.triangles.clear();
        for group in 0..level.groups.len().max(1) {
            let first = level.triangles.len() as u32;
            model.group_triangles_into(&state, group, &mut level.triangles);
            if let Some(group) = level.groups.get_mut(group) {
                (group.first, group.count) = (first, level.triangles.len() as u32 - first);
            }
        }
        level
    }
}

impl<'a> Model<'a> {
    /// Reads a model, if the file has it.
    fn stored(file: &StriataFile<'a>, kind: ModelKind) -> Option<Result<Self, DecodeError>> {
        Some(match kind {
            ModelKind::LodStrips => file.lod_strips()?.map(Self::LodStrips),
            ModelKind::Mts => file.mts()?.map(Self::Mts),
            ModelKind::Fans => file.fans()?.map(Self::Fans),
            ModelKind::Patterns => file.patterns()?.map(Self::Patterns),
            _ => return None,
        })
    }

    /// Builds a model for the picture.
    ///
    /// # Errors
    /// If the steps are not collapses, which models of strips require.
    fn built(model: DrawnModel, steps: &Steps) -> Result<Self, Failure> {
        let refinable = match (steps, model) {
            (_, DrawnModel::List) => return Ok(Self::List),
            (_, DrawnModel::Model(ModelKind::Fans)) => {
                return Ok(Self::Fans(Fans::build_without_bounds(steps)));
            }
            (steps, DrawnModel::Model(ModelKind::Patterns)) => {
                return Ok(Self::Patterns(Patterns::build(&steps.fragments())?));
            }
            (Steps::Collapses(refinable), _) => refinable,
            (Steps::Fragments(_), model) => {
                return Err(Failure::user(format!(
                    "model {} requires collapses, but this file has none",
                    model.as_str()
                ))
                .with_hint("remove --model, or use --model fans, patterns or list"));
            }
        };
        Ok(match model {
            DrawnModel::Model(ModelKind::LodStrips) => {
                Self::LodStrips(LodStrips::build(refinable, &strips_of(refinable)?)?)
            }
            DrawnModel::Model(ModelKind::Mts) => Self::Mts(Mts::build(refinable, &strips_of(refinable)?)?),
            DrawnModel::Model(kind) => {
                return Err(Failure::internal(format!("model {kind} cannot be drawn")));
            }
            DrawnModel::List => Self::List,
        })
    }

    fn name(&self) -> &'static str {
        let model = match self {
            Self::LodStrips(_) => DrawnModel::Model(ModelKind::LodStrips),
            Self::Mts(_) => DrawnModel::Model(ModelKind::Mts),
            Self::Fans(_) => DrawnModel::Model(ModelKind::Fans),
            Self::Patterns(_) => DrawnModel::Model(ModelKind::Patterns),
            Self::List => DrawnModel::List,
        };
        model.as_str()
    }
}

fn strips_of(refinable: &RefinableMesh) -> Result<StripSet, Failure> {
    Ok(stripify(&refinable.mesh)?)
}

fn strips_at<M: StripModel>(model: &M, split_count: usize) -> StripSet {
    let mut state = model.new_state();
    model.move_to(&mut state, split_count);
    model.strips_at(&state)
}

/// Returns the materials of a mesh, if the picture shows them.
fn look_of(args: &RenderArgs, mesh: &IndexedMesh) -> Option<Box<SceneLook>> {
    let look = || SceneLook::of_mesh(mesh, &ImageLimits::default());
    args.shows_surface().then(look).flatten().map(Box::new)
}

/// Returns the model that is used by default: LodStrips if strips are shown, so that they follow the levels.
fn default_model(args: &RenderArgs) -> DrawnModel {
    let shows_strips = args.colors.contains(&Coloring::Strips) && args.level.eye.is_none();
    if shows_strips { DrawnModel::Model(ModelKind::LodStrips) } else { DrawnModel::List }
}

/// Adds normals to the full mesh, so that every level has them.
fn with_level_normals(steps: Steps) -> Steps {
    match steps {
        Steps::Collapses(RefinableMesh { mesh, sequence }) => {
            Steps::Collapses(RefinableMesh { mesh: with_normals(mesh), sequence })
        }
        Steps::Fragments(FragmentedMesh { mesh, fragments }) => {
            Steps::Fragments(FragmentedMesh { mesh: with_normals(mesh), fragments })
        }
    }
}
