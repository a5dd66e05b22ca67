//! Coding of a general batch, as part of the loop that writer and reader share.

use super::General;
use super::complex::Complex;
use super::step::{CodedStep, KnownStep};
use super::wedges::LevelBefore;
use crate::entropy::{Coder, Part};
use crate::format::error::StreamDefect;
use crate::layers::attributes::{GeneralVertex, RingVertex, actual_layers};
use crate::refine::refiner::{Ended, Refiner};
use crate::refine::source::{Plan, Source};
use crate::topology::cutting::{Closed, close_used};
use crate::topology::surface::NONE;

impl Refiner {
    /// Codes whether the next batch is a general one, and prepares for it if so.
    pub(crate) fn begin_general<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &impl Source,
    ) -> Result<bool, StreamDefect> {
        let Some(general) = &mut self.models.general else { return Ok(false) };
        coder.part(Part::Connectivity);
        let count = general.begin(coder, source.plan().map_or(0, |plan| plan.general_count()));
        if count == 0 || coder.overran() {
            return Ok(false);
        }
        general.steps_left = count;
        let triangle_count = self.level.growth.triangle_count();
        self.spend_visits(triangle_count as u64)?;
        self.level.growth.catch_up(&mut self.level.surface);
        let Some(general) = &mut self.models.general else { return Ok(false) };
        let growth = &self.level.growth;
        let position_of = growth.positions_of_vertices();
        let triangles: Vec<[u32; 3]> =
            growth.triangles.iter().map(|t| t.map(|v| position_of[v as usize])).collect();
        general.complex = Complex::new(&triangles, growth.first_vertex.len() - 1);
        Ok(true)
    }

    /// Codes up to `max_steps` steps of the current general batch.
    pub(crate) fn general_stretch<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl Source,
        max_steps: usize,
    ) -> Result<Ended, StreamDefect> {
        for _ in 0..max_steps {
            let Some(mut general) = self.models.general.take() else { break };
            let actual = source.follower().map(|follower| follower.general_step());
            let mut step = std::mem::take(&mut general.step);
            let ended = self.general_step(coder, (source, actual.as_ref()), (&mut general, &mut step));
            general.step = step;
            general.steps_left -= 1;
            let is_last = general.steps_left == 0;
            self.models.general = Some(general);
            if ended? == Ended::Short {
                return Ok(Ended::Short);
            }
            if is_last {
                self.rebuild(source);
                self.batch.is_under_way = false;
                break;
            }
        }
        Ok(Ended::Whole)
    }

    /// Codes a step and applies it.
    fn general_step<C: Coder>(
        &mut self,
        coder: &mut C,
        (source, actual): (&mut impl Source, Option<&KnownStep>),
        (general, step): (&mut General, &mut CodedStep),
    ) -> Result<Ended, StreamDefect> {
        let General { model, wedges: wedge_model, complex, places, .. } = general;
        coder.part(Part::Connectivity);
        step.split = model.code_split(coder, complex.position_count() as u32, actual);
        model.moved(coder, complex, (actual, &mut *step));
        model.born(coder, complex, (actual, &mut *step));
        let ring = complex.corners(step.split).count() as u64;
        self.spend_visits((1 + ring) * (1 + step.born.len() as u64))?;
        coder.part(Part::Positions);
        model.place(coder, (complex, places), (actual, &mut *step));
        if !self.level.grid.holds(step.place) {
            let position = self.level.growth.first_vertex.len() - 1;
            return if coder.overran() { Ok(Ended::Short) } else { Err(StreamDefect::Place { position }) };
        }
        let exact = actual.map_or([0.0; 3], |step| step.exact);
        let position = match &mut self.models.corrections {
            Some(model) => model.code(coder, &self.level.grid, step.place, exact),
            None => self.level.grid.place(step.place),
        };
        coder.part(Part::Wedges);
        let extra_wedges = (self.level.growth.beyond() + step.born.len().saturating_sub(2)) as u64;
        if let Some(wedges) = &mut self.models.wedges {
            let max_extra_wedges = self.limits.most_wedges.saturating_sub(extra_wedges);
            let level_before = LevelBefore { complex, growth: &self.level.growth, max_extra_wedges };
            wedge_model.code(coder, level_before, (actual, &mut *step), wedges);
            if let Some(follower) = source.follower() {
                follower.name(&step.named);
            }
        } else {
            step.show_positions();
        }
        places.push(step.place);
        self.general_layers(coder, source.plan(), (actual, &*step), (complex, places));
        let is_full = extra_wedges + step.targets.len() as u64 > self.limits.most_wedges + 1;
        let is_degenerate = step.born.iter().any(|born| born.third == step.split);
        if coder.overran() || is_full || is_degenerate {
            if let Some(attributes) = &mut self.models.attributes {
                attributes.truncate(self.level.growth.positions.len());
            }
            return if is_degenerate && !coder.overran() {
                Err(StreamDefect::Step { step: self.level.growth.added.len() })
            } else {
                Ok(Ended::Short)
            };
        }
        if let Some(wedges) = &mut self.models.wedges {
            wedges.follow_general(&self.level.growth, step);
        }
        let new = complex.position_count() as u32;
        complex.push_position();
        complex.move_to_last(step.split, &step.moved);
        step.born.iter().for_each(|born| complex.push_triangle(born.ordered([new, step.split, born.third])));
        self.level.growth.add_general(position, step);
        if let Some(follower) = source.follower() {
            follower.born_general(step);
        }
        Ok(Ended::Whole)
    }

    /// Codes the attributes of the new position's vertices, predicted from the vertices with which they
    /// share triangles.
    fn general_layers<C: Coder>(
        &mut self,
        coder: &mut C,
        plan: Option<&dyn Plan>,
        (actual, step): (Option<&KnownStep>, &CodedStep),
        (complex, places): (&Complex, &[[i32; 3]]),
    ) {
        let Some(attributes) = &mut self.models.attributes else { return };
        let mut vertices: Vec<GeneralVertex> =
            step.targets.iter().map(|&target| GeneralVertex { target, ..GeneralVertex::default() }).collect();
        let mut add = |wedge: u32, vertex: u32, position: u32| {
            let ring = &mut vertices[wedge as usize].ring;
            ring.push(RingVertex { vertex, place: places[position as usize] });
        };
        let (fan, born) = step.wedges.split_at(step.fan.len());
        for (&corner, &wedge) in step.fan.iter().zip(fan) {
            let (t, i) = (corner / 3, corner as usize % 3);
            let (vertices_of_triangle, positions) =
                (self.level.growth.triangles[t as usize], complex.triangle(t));
            [(i + 1) % 3, (i + 2) % 3]
                .iter()
                .for_each(|&j| add(wedge, vertices_of_triangle[j], positions[j]));
        }
        for (at, &wedge) in born.iter().enumerate() {
            add(wedge, step.others[at][0], step.split);
            add(wedge, step.others[at][1], step.born[at].third);
        }
        let has_wedges = self.models.wedges.is_some();
        let first = actual.map_or(NONE, |step| step.wedges.start);
        attributes.general_position(coder, step.place, &vertices, |wedge| {
            actual_layers(plan, |_| if has_wedges { step.named[wedge] } else { first })
        });
    }

    /// Rebuilds the surface from the current triangles, and renumbers what models store per vertex.
    fn rebuild(&mut self, source: &mut impl Source) {
        let Some(general) = &mut self.models.general else { return };
        let complex = std::mem::take(&mut general.complex);
        let Closed { mut surface, vertex_of_copy: positions, .. } =
            close_used(&complex.triangles(), complex.position_count());
        let mut old_of_position = vec![NONE; complex.position_count()];
        for old in (self.level.surface.virtual_count()..self.level.surface.vertex_count() as u32).rev() {
            old_of_position[self.level.growth.position_of(old) as usize] = old;
        }
        let virtual_count = surface.virtual_count() as usize;
        let old_of_new: Vec<u32> = std::iter::repeat_n(NONE, virtual_count)
            .chain(positions.iter().map(|&p| old_of_position[p as usize]))
            .collect();
        let triangle_count = self.level.growth.triangles.len() as u32;
        (0..surface.triangle_count() as u32)
            .for_each(|t| surface.set_label(t, if t < triangle_count { t } else { NONE }));
        let virtual_places = std::iter::repeat_n([0; 3], virtual_count);
        self.level.places =
            virtual_places.chain(positions.iter().map(|&p| general.places[p as usize])).collect();
        self.level.growth.renumber(virtual_count, &positions, surface.triangle_count());
        self.batch.walk.renumber(&old_of_new);
        self.models.renumber(&old_of_new);
        if let Some(follower) = source.follower() {
            follower.rebuilt(&surface);
        }
        self.level.surface = surface;
    }
}
