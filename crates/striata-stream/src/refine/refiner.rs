//! The loop that both sides of a stream run: which vertices split, the splits, and what the new vertices are.
//!
//! One generic code over a [`Coder`]: a writer has a [`Source`] that knows what is to come, a reader has none. So the two
//! cannot disagree, as long as models look only at what has been coded.

use crate::base::coder::{BaseLimits, code_base};
use crate::base::hoods::BaseHoods;
use crate::base::mesh::Base;
use crate::connectivity::quick::QuickModel;
use crate::connectivity::{ConnectivityModel, Scene};
use crate::entropy::{Coder, Part};
use crate::format::error::StreamDefect;
use crate::format::form::{Effort, StreamVersion};
use crate::format::grid::{CorrectionModel, PositionGrid};
use crate::general::General;
use crate::layers::attributes::{Actual, Around, Attributes};
use crate::layers::form::LayerForm;
use crate::positions::PositionModel;
use crate::refine::growth::Growth;
use crate::refine::source::Source;
use crate::refine::walk::{Walk, WalkOrder};
use crate::topology::hood::Hood;
use crate::topology::rings::Rings;
use crate::topology::surface::{Cut, NONE, Surface, next, triangle_of};
use crate::wedges::model::{Split, WedgeModel};
use crate::wedges::split::SplitWedges;

/// Splits whose connectivity is coded before their values: what a reader has to wait for.
const STRETCH: usize = 1024;
/// Flags that say yes before the cuts of their vertices are coded.
const GROUP: usize = 24;

/// What both sides agree on before the first bit.
#[derive(Clone, Debug)]
pub(crate) struct Terms {
    /// What the bits mean.
    pub(crate) version: StreamVersion,
    /// Whether there are general batches.
    pub(crate) has_general: bool,
    /// How hard models try.
    pub(crate) effort: Effort,
    /// The grid of positions.
    pub(crate) grid: PositionGrid,
    /// Whether positions are exact beside it.
    pub(crate) is_exact: bool,
    /// Most triangles that a new vertex takes over.
    pub(crate) max_patch: u32,
    /// Positions of the full mesh.
    pub(crate) position_count: u32,
    /// What the base may be at most.
    pub(crate) base: BaseLimits,
    /// Vertices of the full mesh.
    pub(crate) vertex_count: u32,
    /// Groups of the full mesh.
    pub(crate) group_count: u32,
    /// How attribute layers are told.
    pub(crate) layers: Vec<LayerForm>,
}

impl Terms {
    /// Whether what corners show has to be told.
    pub(crate) fn has_wedges(&self) -> bool {
        self.vertex_count != self.position_count || self.group_count > 1
    }

    /// Whether vertices are asked by the quick model.
    fn is_quick(&self) -> bool {
        match self.effort {
            Effort::Fast => true,
            Effort::Default => self.version > StreamVersion::One,
            Effort::Small => false,
        }
    }

    /// Which vertex is asked next.
    fn walk(&self) -> Walk {
        let order = match (self.version, self.effort) {
            (StreamVersion::One, Effort::Small) => WalkOrder::Near,
            (StreamVersion::One, _) => WalkOrder::Numbers,
            _ => WalkOrder::Families,
        };
        if self.is_quick() { Walk::forgetful(order) } else { Walk::new(order) }
    }

    /// How often vertices may be asked in all: what real batches need many times over, and a bound for hostile ones.
    pub(crate) fn most_visits(&self) -> u64 {
        256 * u64::from(self.position_count) + 65_536
    }
}

/// How a stretch of the stream ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ended {
    /// All that was there was coded.
    Whole,
    /// The bytes ended before: what is complete stands.
    Short,
}

/// Who is asked which vertices split.
#[derive(Clone, Debug)]
pub(crate) enum Connectivity {
    /// All that is around a vertex is looked at.
    Thorough(Box<ConnectivityModel>),
    /// Next to nothing is to see whether it splits.
    Quick(Box<QuickModel>),
}

/// A surface under refinement, with all models.
#[derive(Clone, Debug)]
pub(crate) struct Refiner {
    pub(crate) surface: Surface,
    /// Grid coordinates by vertex of the surface.
    pub(crate) places: Vec<[i32; 3]>,
    pub(crate) walk: Walk,
    pub(crate) is_in_batch: bool,
    splits_in_batch: usize,
    /// Vertices that may still be asked.
    visits_left: u64,
    max_patch: u32,
    pub(crate) grid: PositionGrid,
    pub(crate) connectivity: Connectivity,
    pub(crate) positions: PositionModel,
    /// What grid coordinates lack, where positions are exact.
    pub(crate) corrections: Option<CorrectionModel>,
    /// What corners show, where positions have several vertices or triangles several groups.
    pub(crate) wedges: Option<WedgeModel>,
    told: SplitWedges,
    /// Vertices beyond one a position that there may be; a reader's bytes cannot tell more.
    pub(crate) most_wedges: u64,
    pub(crate) attributes: Option<Attributes>,
    /// Where there are general batches.
    pub(crate) general: Option<General>,
    /// Corners of the patches of splits that are still to be done, and where each one's end.
    patches: Vec<u32>,
    pending: Vec<u32>,
    corners: Vec<u32>,
    /// Vertices that split and whose cuts are next, and the corners around them.
    group: Vec<u32>,
    rings: Rings,
    pub(crate) growth: Growth,
}

impl Refiner {
    /// Codes the base, counts and all, and begins with it.
    ///
    /// # Errors
    /// Where what was read is no base.
    pub(crate) fn begin<C: Coder>(
        coder: &mut C,
        known: &Base,
        terms: &Terms,
        source: &mut impl Source,
    ) -> Result<Self, StreamDefect> {
        let (mut base, order) = code_base(coder, known, terms.base)?;
        source.order_base(&base, &order);
        if coder.overran() {
            return Err(StreamDefect::NoBase);
        }
        if let Some(position) = base.places.iter().position(|&place| !terms.grid.holds(place)) {
            return Err(StreamDefect::Place { position });
        }
        let vertex_of_position = base.vertex_of_position()?;
        let mut surface = base.surface()?;
        let mut wedges = terms.has_wedges().then(|| WedgeModel::new(terms.vertex_count, terms.version));
        match &mut wedges {
            Some(model) => {
                for &vertex in &vertex_of_position {
                    source.name(source.wedges(vertex));
                }
                let most = terms.base.position_count.saturating_add(terms.base.wedges_beyond);
                let counts = (terms.vertex_count.min(most), terms.group_count);
                coder.part(Part::Wedges);
                base.code_wedges(coder, model, source, (counts, &vertex_of_position));
            }
            None => base.show_positions(),
        }
        let mut corrections = terms.is_exact.then(CorrectionModel::new);
        let mut attributes = Attributes::new(&terms.layers, (terms.effort, terms.version));
        let hoods = BaseHoods::new(&base);
        let mut growth = Growth::of_base(&base, &mut surface, terms.group_count);
        for (position, &vertex) in vertex_of_position.iter().enumerate() {
            let place = base.places[position];
            coder.part(Part::Base);
            let exact = match &mut corrections {
                Some(model) => model.code(coder, &terms.grid, place, source.exact(vertex)),
                None => terms.grid.place(place),
            };
            let wedges = base.first_vertex[position]..base.first_vertex[position + 1];
            growth.positions.extend(wedges.clone().map(|_| exact));
            if let Some(attributes) = &mut attributes {
                for (wedge, new) in wedges.enumerate() {
                    let actual = actual_layers::<C>(source, source.wedges(vertex).start + wedge as u32);
                    attributes.base_vertex(coder, (&hoods, place), (new, wedge as u32), actual);
                }
            }
        }
        let Terms { grid, effort, max_patch, .. } = *terms;
        let connectivity = if terms.is_quick() {
            Connectivity::Quick(Box::new(QuickModel::new(&surface, (effort, terms.version))))
        } else {
            Connectivity::Thorough(Box::new(ConnectivityModel::new(effort)))
        };
        Ok(Self {
            surface,
            places: base.surface_places(),
            walk: terms.walk(),
            is_in_batch: false,
            splits_in_batch: 0,
            visits_left: terms.most_visits(),
            max_patch,
            grid,
            connectivity,
            positions: PositionModel::new(effort, terms.version),
            corrections,
            wedges,
            told: SplitWedges::default(),
            most_wedges: terms.base.wedges_beyond.into(),
            attributes,
            general: terms.has_general.then(|| General::new(base.places.clone())),
            patches: Vec::new(),
            pending: Vec::new(),
            corners: Vec::new(),
            group: Vec::new(),
            rings: Rings::default(),
            growth,
        })
    }

    /// Codes up to so many splits: the rest of a batch, or a part of it.
    pub(crate) fn stretch<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl Source,
        most: usize,
    ) -> Result<Ended, StreamDefect> {
        if !self.is_in_batch {
            self.spend_visits(self.surface.vertex_count() as u64)?;
            source.begin_batch();
            self.is_in_batch = true;
            if self.begin_general(coder, source)? {
                return self.general_stretch(coder, source, most);
            }
            self.walk.begin(&self.surface);
            match &mut self.connectivity {
                Connectivity::Thorough(model) => model.begin_batch(&self.surface, self.walk.end()),
                Connectivity::Quick(model) => model.begin_batch(&self.surface),
            }
            self.splits_in_batch = 0;
        } else if self.general.as_ref().is_some_and(General::is_under_way) {
            return self.general_stretch(coder, source, most);
        }
        coder.part(Part::Connectivity);
        self.connectivity(coder, source, most.min(STRETCH));
        if coder.overran() {
            return Ok(Ended::Short);
        }
        self.splits_in_batch += self.pending.len();
        if !self.is_in_batch && self.splits_in_batch == 0 {
            return Err(StreamDefect::EmptyBatch { batch: self.walk.batch() });
        }
        let (first, mut start) = (self.surface.vertex_count() as u32, 0);
        let is_ahead = self.look_ahead(first);
        self.split_pending(source);
        if !is_ahead {
            self.fetch(first);
        }
        for split in 0..self.pending.len() {
            let vertex = first + split as u32;
            let end = self.pending[split] as usize;
            // The ring of the new vertex: A, its patch, B.
            let a = self.surface.corner_of(vertex);
            self.corners.clear();
            self.corners.push(a);
            self.corners.extend_from_slice(&self.patches[start..end]);
            self.corners.push(a + 4);
            start = end;
            if self.values(coder, source, vertex)? == Ended::Short {
                return Ok(Ended::Short);
            }
        }
        Ok(Ended::Whole)
    }

    /// Notes that so many vertices or triangles are looked at.
    ///
    /// # Errors
    /// Where they are too many for so few splits.
    pub(crate) fn spend_visits(&mut self, visits: u64) -> Result<(), StreamDefect> {
        let batch_count = self.walk.batch();
        self.visits_left =
            self.visits_left.checked_sub(visits).ok_or(StreamDefect::Batches { batch_count })?;
        Ok(())
    }

    /// Which vertices split and how, until there are `most` or the batch is done.
    fn connectivity<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        self.pending.clear();
        self.patches.clear();
        match &self.connectivity {
            Connectivity::Quick(_) => self.ask_quickly(coder, source, most),
            Connectivity::Thorough(model) if model.is_thorough() => self.ask_thoroughly(coder, source, most),
            Connectivity::Thorough(_) => self.ask_in_groups(coder, source, most),
        }
    }

    /// Vertex by vertex.
    fn ask_thoroughly<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        let Connectivity::Thorough(model) = &mut self.connectivity else { return };
        while self.pending.len() < most {
            let Some(vertex) = self.walk.next_vertex() else {
                self.is_in_batch = false;
                return;
            };
            self.corners.clear();
            self.corners.extend(self.surface.ring(vertex));
            let scene = Scene {
                surface: &self.surface,
                places: &self.places,
                walk: &self.walk,
                max_patch: self.max_patch,
            };
            let actual = if C::READS { None } else { source.cut(vertex) };
            let cut = model.code(coder, &scene, (vertex, &self.corners), actual);
            self.walk.settle(&self.surface, vertex, &self.corners, cut.is_some());
            if let Some(cut) = cut {
                take(&mut self.surface, (&mut self.patches, &mut self.pending), cut, self.walk.batch());
            }
        }
    }

    /// Flags until some vertices split, then the cuts of these, so that rings can be found side by side.
    fn ask_in_groups<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        let Connectivity::Thorough(model) = &mut self.connectivity else { return };
        while self.is_in_batch && self.pending.len() < most {
            let room = GROUP.min(most - self.pending.len());
            self.group.clear();
            while self.group.len() < room {
                let Some(vertex) = self.walk.next_vertex() else {
                    self.is_in_batch = false;
                    break;
                };
                let splits = model.flag(coder, vertex, !C::READS && source.cut(vertex).is_some());
                self.walk.settle(&self.surface, vertex, &[], splits);
                if splits {
                    self.group.push(vertex);
                }
            }
            self.rings.find(&self.surface, &self.group);
            for (at, &vertex) in self.group.iter().enumerate() {
                let scene = Scene {
                    surface: &self.surface,
                    places: &self.places,
                    walk: &self.walk,
                    max_patch: self.max_patch,
                };
                let actual = if C::READS { None } else { source.cut(vertex) };
                let Some(cut) = model.cut(coder, &scene, (vertex, self.rings.of(at)), actual) else {
                    continue;
                };
                take(&mut self.surface, (&mut self.patches, &mut self.pending), cut, self.walk.batch());
            }
        }
    }

    /// All flags by the quick model, then all cuts.
    fn ask_quickly<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        let Connectivity::Quick(model) = &mut self.connectivity else { return };
        self.is_in_batch = !model.flags(coder, &mut self.walk, most, |vertex| source.cut(vertex).is_some());
        model.find_rings(&self.surface, &self.places);
        for split in 0..model.splits().len() {
            let scene = Scene {
                surface: &self.surface,
                places: &self.places,
                walk: &self.walk,
                max_patch: self.max_patch,
            };
            let actual = if C::READS { None } else { source.cut(model.splits()[split]) };
            if !model.cut(coder, &scene, (split, actual), &mut self.patches) {
                continue;
            }
            let start = self.pending.last().map_or(0, |&end| end as usize);
            for &corner in &self.patches[start..] {
                self.surface.set_mark(triangle_of(corner), self.walk.batch());
            }
            self.pending.push(self.patches.len() as u32);
        }
    }

    /// Looks at what is around the vertices that come next; false where that is done one by one.
    fn look_ahead(&mut self, first: u32) -> bool {
        let Connectivity::Quick(model) = &self.connectivity else { return false };
        let Some(positions) = self.positions.ahead(first) else { return false };
        let patches = (self.patches.as_slice(), self.pending.as_slice());
        model.look_around(&self.surface, &self.places, patches, |around| positions.look_ahead(around));
        true
    }

    fn split_pending(&mut self, source: &mut impl Source) {
        let mut start = 0;
        for &end in &self.pending {
            let patch = &self.patches[start..end as usize];
            start = end as usize;
            let kept = self.surface.vertex(patch[0]);
            let vertex = self.surface.split(patch);
            let made = self.surface.triangle_count() as u32;
            for triangle in [made - 2, made - 1] {
                self.surface.set_mark(triangle, self.walk.batch());
                // No part of the mesh before the vertex's values are known.
                self.surface.set_label(triangle, NONE);
            }
            if let Connectivity::Quick(model) = &mut self.connectivity {
                model.split(&self.surface, patch.len(), kept);
            }
            self.walk.born(kept);
            source.born(vertex, kept);
        }
    }

    /// Touches what the values of new vertices are foretold from, so that waiting for memory overlaps between vertices.
    fn fetch(&self, first: u32) {
        let surface = &self.surface;
        let place = |vertex: u32| self.places.get(vertex as usize).map_or(0, |place| place[0]);
        let (mut sum, mut start) = (0, 0);
        for (vertex, &end) in (first..).zip(&self.pending) {
            let a = surface.corner_of(vertex);
            let patch = &self.patches[start..end as usize];
            start = end as usize;
            for &corner in patch {
                sum ^= place(surface.vertex(next(corner)));
                sum ^= place(surface.vertex(surface.opposite(corner)));
            }
            for corner in [a, a + 4] {
                sum ^= place(surface.vertex(next(corner)));
                sum ^= place(surface.vertex(surface.opposite(corner)));
            }
        }
        std::hint::black_box(sum);
    }

    /// What the new vertex is; then it is part of the mesh.
    fn values<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl Source,
        vertex: u32,
    ) -> Result<Ended, StreamDefect> {
        let hood = Hood { surface: &self.surface, places: &self.places, vertex, corners: &self.corners };
        coder.part(Part::Positions);
        let actual = if C::READS { [0; 3] } else { source.place(vertex) };
        let place = self.positions.code(coder, &hood, actual);
        if !self.grid.holds(place) {
            let position = self.growth.first_vertex.len() - 1;
            return if coder.overran() { Ok(Ended::Short) } else { Err(StreamDefect::Place { position }) };
        }
        let position = match &mut self.corrections {
            Some(model) => model.code(coder, &self.grid, place, source.exact(vertex)),
            None => self.grid.place(place),
        };
        self.places.push(place);
        if let Some(general) = &mut self.general {
            general.push_place(place);
        }
        coder.part(Part::Wedges);
        self.shown(coder, source, vertex);
        let is_full = self.growth.beyond() as u64 + self.told.targets.len() as u64 > self.most_wedges + 1;
        if coder.overran() || is_full {
            if let Some(attributes) = &mut self.attributes {
                attributes.truncate(self.growth.positions.len());
            }
            return Ok(Ended::Short);
        }
        match &self.wedges {
            Some(_) => self.growth.add_wedges(&mut self.surface, &self.corners, position, &self.told),
            None => self.growth.add(&self.surface, &self.corners, position),
        }
        Ok(Ended::Whole)
    }

    /// What corners around a new vertex show, and the attributes of that.
    fn shown<C: Coder>(&mut self, coder: &mut C, source: &mut impl Source, vertex: u32) {
        if let Some(model) = &mut self.wedges {
            source.refine(vertex, &self.corners);
            let split = Split {
                surface: &self.surface,
                growth: &self.growth,
                corners: &self.corners,
                source: &*source,
                most_beyond: self.most_wedges.saturating_sub(self.growth.beyond() as u64),
            };
            model.code(coder, &split, &mut self.told);
            source.name(self.told.named.iter().copied());
        }
        let Some(attributes) = &mut self.attributes else { return };
        let around = Around {
            surface: &self.surface,
            growth: &self.growth,
            places: &self.places,
            corners: &self.corners,
            told: self.wedges.as_ref().map(|_| &self.told),
        };
        let place = self.places[vertex as usize];
        if self.wedges.is_none() {
            let kept = self.surface.vertex(next(self.corners[0]));
            let actual = actual_layers::<C>(source, source.wedges(vertex).start);
            attributes.vertex(coder, around, (place, 0, self.growth.wedges(kept).start), actual);
            return;
        }
        attributes.begin_position(around, place);
        for (wedge, &target) in self.told.targets.iter().enumerate() {
            let actual = actual_layers::<C>(source, self.told.named[wedge]);
            attributes.vertex(coder, around, (place, wedge as u32, target), actual);
        }
    }

    /// The attribute layers, if there are any.
    pub(crate) fn attributes(&self) -> Option<&Attributes> {
        self.attributes.as_ref()
    }

    /// A reader has bytes for so many vertices beyond one a position.
    pub(crate) fn limit_wedges(&mut self, most: u64) {
        self.most_wedges = most;
    }

    /// Makes room for what is to come.
    pub(crate) fn reserve(&mut self, steps: usize) {
        self.surface.reserve(steps);
        self.places.reserve(steps);
        self.growth.reserve(steps);
        // These know nothing yet of the vertices that are there.
        let all = self.surface.vertex_count() + steps;
        self.walk.reserve(all);
        self.positions.reserve(all);
        match &mut self.connectivity {
            Connectivity::Thorough(model) => model.reserve(all),
            Connectivity::Quick(model) => model.reserve(steps),
        }
    }

    /// All models follow a surface that was built anew between two batches: here is the old number of each of its vertices, or
    /// [`NONE`] for those that are new. Only in streams of the second version; the surface, its places and what has grown
    /// are up to the caller.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        self.walk.renumber(old_of_new);
        match &mut self.connectivity {
            Connectivity::Thorough(model) => model.renumber(old_of_new),
            Connectivity::Quick(model) => model.renumber(old_of_new),
        }
        self.positions.renumber(old_of_new);
    }

    /// Brings the list of triangles up to date.
    pub(crate) fn catch_up(&mut self) {
        self.growth.catch_up(&mut self.surface);
    }

    /// Splits done and told in full.
    pub(crate) fn split_count(&self) -> usize {
        self.growth.added.len()
    }

    /// Batches begun so far.
    pub(crate) fn batch(&self) -> u32 {
        self.walk.batch()
    }

    /// True where the last batch has not been asked to its end.
    pub(crate) fn is_in_batch(&self) -> bool {
        self.is_in_batch
    }
}

/// Notes a split and marks the triangles of its patch: no other split of the batch may have them.
fn take(surface: &mut Surface, (patches, ends): (&mut Vec<u32>, &mut Vec<u32>), cut: Cut, batch: u32) {
    let mut corner = cut.first;
    for at in 0..cut.length {
        if at > 0 {
            corner = surface.swing(corner);
        }
        surface.set_mark(triangle_of(corner), batch);
        patches.push(corner);
    }
    ends.push(patches.len() as u32);
}

/// A writer's layers and the vertex there.
pub(crate) fn actual_layers<C: Coder>(source: &impl Source, vertex: u32) -> Actual<'_> {
    (!C::READS).then(|| (source.layers(), vertex))
}
