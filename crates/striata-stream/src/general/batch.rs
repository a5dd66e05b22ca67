//! Coding of a general batch, as part of the loop that writer and reader share.

use super::GeneralBatches;
use super::complex::Complex;
use super::step::{CodedStep, ReferenceStep};
use super::wedges::LevelBefore;
use crate::entropy::{Coder, Part};
use crate::format::error::StreamDefect;
use crate::layers::attributes::{GeneralVertex, RingVertex, actual_layers};
use crate::refine::refiner::{CodingResult, MeshRefiner};
use crate::refine::source::{EncoderInput, StreamSide};
use crate::topology::cutting::{Closed, close_used};
use crate::topology::surface::NONE;

impl MeshRefiner {
    /// Codes whether the next batch is a general one, and prepares for it if so.
    pub(crate) fn begin_general<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &impl StreamSide,
    ) -> Result<bool, StreamDefect> {
        let Some(general) = &mut self.models.general else { return Ok(false) };
        coder.part(Part::Connectivity);
        let count = general.begin(coder, source.input().map_or(0, |input| input.general_count()));
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
    pub(crate) fn continue_general<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl StreamSide,
        max_steps: usize,
    ) -> Result<CodingResult, StreamDefect> {
        for _ in 0..max_steps {
            let Some(mut general) = self.models.general.take() else { break };
            let actual = source.observer().map(|observer| observer.general_step());
            let mut step = std::mem::take(&mut general.step);
            let ended = self.general_step(coder, (source, actual.as_ref()), (&mut general, &mut step));
            general.step = step;
            general.steps_left -= 1;
            let is_last = general.steps_left == 0;
            self.models.general = Some(general);
            if ended? == CodingResult::OutOfData {
                return Ok(CodingResult::OutOfData);
            }
            if is_last {
                self.rebuild(source);
                self.batch.is_under_way = false;
                break;
            }
        }
        Ok(CodingResult::Complete)
    }

    /// Codes a step and applies it.
    fn general_step<C: Coder>(
        &mut self,
        coder: &mut C,
        (source, actual): (&mut impl StreamSide, Option<&ReferenceStep>),
        (general, step): (&mut GeneralBatches, &mut CodedStep),
    ) -> Result<CodingResult, StreamDefect> {
        let GeneralBatches { model, wedges: wedge_model, complex, grid_points, .. } = general;
        coder.part(Part::Connectivity);
        step.split = model.code_split(coder, complex.position_count() as u32, actual);
        model.moved(coder, complex, actual, &mut *step);
        model.new_triangles(coder, complex, actual, &mut *step);
        let ring = complex.corners(step.split).count() as u64;
        self.spend_visits((1 + ring) * (1 + step.new_triangles.len() as u64))?;
        coder.part(Part::Positions);
        model.grid_point(coder, (complex, grid_points), (actual, &mut *step));
        if !self.level.grid.contains(step.grid_point) {
            let position = self.level.growth.first_vertex.len() - 1;
            return if coder.overran() {
                Ok(CodingResult::OutOfData)
            } else {
                Err(StreamDefect::OffGrid { position })
            };
        }
        let exact = actual.map_or([0.0; 3], |step| step.exact);
        let position = match &mut self.models.corrections {
            Some(model) => model.code(coder, &self.level.grid, step.grid_point, exact),
            None => self.level.grid.position(step.grid_point),
        };
        coder.part(Part::Wedges);
        let extra_wedges =
            (self.level.growth.excess_count() + step.new_triangles.len().saturating_sub(2)) as u64;
        if let Some(wedges) = &mut self.models.wedges {
            let max_extra_wedges = self.limits.most_wedges.saturating_sub(extra_wedges);
            let level_before = LevelBefore { complex, growth: &self.level.growth, max_extra_wedges };
            wedge_model.code(coder, level_before, (actual, &mut *step), wedges);
            if let Some(observer) = source.observer() {
                observer.name(&step.reference_wedges);
            }
        } else {
            step.use_one_vertex_per_position();
        }
        grid_points.push(step.grid_point);
        self.general_layers(coder, source.input(), (actual, &*step), (complex, grid_points));
        let is_full = extra_wedges + step.targets.len() as u64 > self.limits.most_wedges + 1;
        let is_degenerate = step.new_triangles.iter().any(|triangle| triangle.third == step.split);
        if coder.overran() || is_full || is_degenerate {
            if let Some(attributes) = &mut self.models.attributes {
                attributes.truncate(self.level.growth.positions.len());
            }
            return if is_degenerate && !coder.overran() {
                Err(StreamDefect::DegenerateTriangle { step: self.level.growth.added.len() })
            } else {
                Ok(CodingResult::OutOfData)
            };
        }
        if let Some(wedges) = &mut self.models.wedges {
            wedges.follow_general(&self.level.growth, step);
        }
        let new = complex.position_count() as u32;
        complex.push_position();
        complex.move_to_last(step.split, &step.moved);
        step.new_triangles
            .iter()
            .for_each(|triangle| complex.push_triangle(triangle.ordered([new, step.split, triangle.third])));
        self.level.growth.add_general(position, step);
        if let Some(observer) = source.observer() {
            observer.general_step_applied(step);
        }
        Ok(CodingResult::Complete)
    }

    /// Codes the attributes of the new position's vertices, predicted from the vertices with which they
    /// share triangles.
    fn general_layers<C: Coder>(
        &mut self,
        coder: &mut C,
        input: Option<&dyn EncoderInput>,
        (actual, step): (Option<&ReferenceStep>, &CodedStep),
        (complex, grid_points): (&Complex, &[[i32; 3]]),
    ) {
        let Some(attributes) = &mut self.models.attributes else { return };
        let mut vertices: Vec<GeneralVertex> =
            step.targets.iter().map(|&target| GeneralVertex { target, ..GeneralVertex::default() }).collect();
        let mut add = |wedge: u32, vertex: u32, position: u32| {
            let ring = &mut vertices[wedge as usize].ring;
            ring.push(RingVertex { vertex, grid_point: grid_points[position as usize] });
        };
        let (fan, new_wedges) = step.wedges.split_at(step.fan.len());
        for (&corner, &wedge) in step.fan.iter().zip(fan) {
            let (t, i) = (corner / 3, corner as usize % 3);
            let (vertices_of_triangle, positions) =
                (self.level.growth.triangles[t as usize], complex.triangle(t));
            [(i + 1) % 3, (i + 2) % 3]
                .iter()
                .for_each(|&j| add(wedge, vertices_of_triangle[j], positions[j]));
        }
        for (at, &wedge) in new_wedges.iter().enumerate() {
            add(wedge, step.others[at][0], step.split);
            add(wedge, step.others[at][1], step.new_triangles[at].third);
        }
        let has_wedges = self.models.wedges.is_some();
        let first = actual.map_or(NONE, |step| step.wedges.start);
        attributes.general_position(coder, step.grid_point, &vertices, |wedge| {
            actual_layers(input, |_| if has_wedges { step.reference_wedges[wedge] } else { first })
        });
    }

    /// Rebuilds the surface from the current triangles, and renumbers what models store per vertex.
    fn rebuild(&mut self, source: &mut impl StreamSide) {
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
        let virtual_points = std::iter::repeat_n([0; 3], virtual_count);
        self.level.grid_points =
            virtual_points.chain(positions.iter().map(|&p| general.grid_points[p as usize])).collect();
        self.level.growth.renumber(virtual_count, &positions, surface.triangle_count());
        self.batch.walk.renumber(&old_of_new);
        self.models.renumber(&old_of_new);
        if let Some(observer) = source.observer() {
            observer.surface_rebuilt(&surface);
        }
        self.level.surface = surface;
    }
}
