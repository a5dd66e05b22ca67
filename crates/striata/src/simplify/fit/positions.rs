//! Moves the positions of a level toward its pairs.

use std::collections::HashSet;

use glam::{DMat3, DVec3};

use super::corner_forms::CornerForm;
use super::pairs::{BorderPair, FitPairs, is_boundary};
use super::surface::FitPoint;
use crate::mesh::{Adjacency, IndexedMesh, index_positions};
use crate::simplify::options::{BoundaryRule, SequenceOptions};

/// Sweeps of Gauss-Seidel relaxation; more change results by less than a percent.
const SWEEPS: usize = 6;
/// Resistance to moving, as a share of what the pairs around a position weigh.
const STIFFNESS: f64 = 0.02;
/// Cosine between the normals of a triangle before and after, below which its corners move less.
const LEAST_TURN: f64 = 0.7;
/// Share of its area that a triangle must keep.
const LEAST_AREA: f64 = 0.2;
/// Number of times that a move is halved before it is given up.
const HALVINGS: usize = 5;

/// Constraints on moves: locked positions, rules for boundaries and group borders, and height fields.
pub(super) struct Constraints {
    locked: HashSet<[u32; 3]>,
    boundary: BoundaryRule,
    group_borders: BoundaryRule,
    is_height_field: bool,
}

fn key(position: [f32; 3]) -> [u32; 3] {
    // Adding zero turns -0 into 0.
    position.map(|x| (x + 0.0).to_bits())
}

impl Constraints {
    pub(super) fn new(original: &IndexedMesh, options: &SequenceOptions) -> Self {
        let locked = options.locked_vertices.iter();
        Self {
            locked: locked.map(|&v| key(original.positions[v as usize])).collect(),
            boundary: options.boundary,
            group_borders: options.group_borders,
            is_height_field: options.height_field.unwrap_or(!original.appearance.georeference.is_empty()),
        }
    }
}

/// The distance of the points of a triangle along a direction.
struct Term {
    direction: DVec3,
    form: CornerForm<1>,
    /// How far the corners have moved along the direction.
    moved: [[f64; 1]; 3],
}

impl Term {
    fn new(direction: DVec3) -> Self {
        Self { direction, form: CornerForm::default(), moved: [[0.0]; 3] }
    }
}

/// The terms of a triangle.
struct TriangleTerms {
    along_normal: Term,
    /// Two terms for each border edge.
    across_edges: Vec<Term>,
}

impl TriangleTerms {
    fn terms(&self) -> impl Iterator<Item = &Term> {
        std::iter::once(&self.along_normal).chain(&self.across_edges)
    }

    fn terms_mut(&mut self) -> impl Iterator<Item = &mut Term> {
        std::iter::once(&mut self.along_normal).chain(&mut self.across_edges)
    }
}

/// The positions of a level and the triangles between them.
pub(super) struct LevelPositions {
    position_of: Vec<u32>,
    places: Vec<DVec3>,
    pub adjacency: Adjacency,
}

impl LevelPositions {
    pub(super) fn of(level: &IndexedMesh) -> Self {
        let position_of = index_positions(&level.positions);
        let position_count = position_of.iter().max().map_or(0, |&p| p as usize + 1);
        let corners = level.triangles.iter().map(|t| t.map(|v| position_of[v as usize]));
        let adjacency = Adjacency::of_triangles(corners.collect(), position_count);
        Self { position_of, places: vec![DVec3::ZERO; position_count], adjacency }
    }

    /// Follows vertices that have moved: those at the same position together.
    fn follow(&mut self, positions: &[[f32; 3]]) {
        for (&p, position) in self.position_of.iter().zip(positions) {
            self.places[p as usize] = DVec3::from(position.map(f64::from));
        }
    }

    fn corners_at(&self, p: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.adjacency.corners(p as u32).iter().map(|&at| (at as usize / 3, at as usize % 3))
    }

    /// Whether each position must stay.
    fn fixed(&self, level: &IndexedMesh, constraints: &Constraints) -> Vec<bool> {
        let mut is_fixed = vec![false; self.places.len()];
        for (&p, &position) in self.position_of.iter().zip(&level.positions) {
            is_fixed[p as usize] |= constraints.locked.contains(&key(position));
        }
        if constraints.boundary == BoundaryRule::Locked {
            let edges = self.adjacency.edges().filter(|edge| is_boundary(&self.adjacency, edge));
            edges.flat_map(|edge| edge.ends).for_each(|p| is_fixed[p as usize] = true);
        }
        if constraints.group_borders == BoundaryRule::Locked {
            let mut group_of = vec![None; self.places.len()];
            for (group, run) in level.groups_or_whole().iter().enumerate() {
                for &p in self.adjacency.triangles()[run.range()].as_flattened() {
                    let first = *group_of[p as usize].get_or_insert(group);
                    is_fixed[p as usize] |= first != group;
                }
            }
        }
        is_fixed
    }

    /// Normal of a triangle, as long as twice its area.
    fn normal(&self, t: usize, moves: &[DVec3]) -> DVec3 {
        let [a, b, c] = self.adjacency.triangles()[t].map(|p| self.places[p as usize] + moves[p as usize]);
        (b - a).cross(c - a)
    }

    /// Reduces moves that would turn a triangle over or flatten it.
    fn keep_triangles(&self, moves: &mut [DVec3]) {
        let still = vec![DVec3::ZERO; moves.len()];
        let normals: Vec<DVec3> =
            (0..self.adjacency.triangles().len()).map(|t| self.normal(t, &still)).collect();
        for round in 0..=HALVINGS {
            let mut is_bad = vec![false; moves.len()];
            for (t, &before) in normals.iter().enumerate() {
                let after = self.normal(t, moves);
                let (squared, squared_before) = (after.length_squared(), before.length_squared());
                let turned = before.dot(after) < LEAST_TURN * (squared * squared_before).sqrt();
                if turned || squared < LEAST_AREA * LEAST_AREA * squared_before {
                    self.adjacency.triangles()[t].iter().for_each(|&p| is_bad[p as usize] = true);
                }
            }
            let factor = if round < HALVINGS { 0.5 } else { 0.0 };
            moves.iter_mut().zip(&is_bad).filter(|(_, is_bad)| **is_bad).for_each(|(m, _)| *m *= factor);
            if !is_bad.contains(&true) {
                return;
            }
        }
    }
}

/// Moves the vertices so that the summed squared distance of all pairs along normals is least.
pub(super) fn move_vertices(
    level: &mut IndexedMesh,
    places: &mut LevelPositions,
    pairs: &FitPairs,
    constraints: &Constraints,
) {
    places.follow(&level.positions);
    let terms = terms_of(places, pairs);
    let is_fixed = places.fixed(level, constraints);
    let mut moves = solve(places, terms, &is_fixed, constraints.is_height_field);
    places.keep_triangles(&mut moves);
    for (position, &p) in level.positions.iter_mut().zip(&places.position_of) {
        if moves[p as usize] != DVec3::ZERO {
            let limit = f64::from(f32::MAX);
            let moved = places.places[p as usize] + moves[p as usize];
            *position = moved.to_array().map(|x| x.clamp(-limit, limit) as f32);
        }
    }
}

/// Collects the terms of each triangle.
fn terms_of(places: &LevelPositions, pairs: &FitPairs) -> Vec<TriangleTerms> {
    let still = vec![DVec3::ZERO; places.places.len()];
    let triangles = places.adjacency.triangles();
    let along_normal = |t| Term::new(places.normal(t, &still).normalize_or_zero());
    let mut terms: Vec<TriangleTerms> = (0..triangles.len())
        .map(|t| TriangleTerms { along_normal: along_normal(t), across_edges: Vec::new() })
        .collect();
    let away = |point: FitPoint, target: DVec3| {
        let [a, b, c] = triangles[point.triangle as usize].map(|p| places.places[p as usize]);
        let [u, v, w] = point.shares;
        target - (u * a + v * b + w * c)
    };
    for pair in &pairs.of_surfaces {
        let term = &mut terms[pair.level.triangle as usize].along_normal;
        let wish = term.direction.dot(away(pair.level, pair.target));
        term.form.add(pair.area, pair.level.shares, [wish]);
    }
    for BorderPair { pair, along } in &pairs.of_borders {
        let away = away(pair.level, pair.target);
        let TriangleTerms { along_normal, across_edges } = &mut terms[pair.level.triangle as usize];
        let normal = along_normal.direction;
        for direction in [normal, along.cross(normal)] {
            let known = across_edges.iter().position(|term| term.direction == direction);
            let index = known.unwrap_or(across_edges.len());
            if known.is_none() {
                across_edges.push(Term::new(direction));
            }
            across_edges[index].form.add(pair.area, pair.level.shares, [direction.dot(away)]);
        }
    }
    terms
}

/// Returns how far each position moves.
fn solve(
    places: &LevelPositions,
    mut terms: Vec<TriangleTerms>,
    is_fixed: &[bool],
    is_height_field: bool,
) -> Vec<DVec3> {
    let mut moves = vec![DVec3::ZERO; places.places.len()];
    let inverse_at = |p: usize| {
        let (mut matrix, mut weight) = (DMat3::ZERO, 0.0);
        for (t, corner) in places.corners_at(p) {
            for term in terms[t].terms() {
                let (d, own) = (term.direction, term.form.weight(corner));
                matrix += own * DMat3::from_cols(d * d.x, d * d.y, d * d.z);
                weight += own;
            }
        }
        if is_fixed[p] || !(weight > 0.0 && weight.is_finite()) {
            return DMat3::ZERO;
        }
        if is_height_field {
            let stiff = matrix.z_axis.z + STIFFNESS * weight;
            return DMat3::from_diagonal(DVec3::new(0.0, 0.0, stiff.recip()));
        }
        // Scaled, since the determinant of tiny areas underflows.
        let scaled = matrix * weight.recip() + DMat3::from_diagonal(DVec3::splat(STIFFNESS));
        scaled.inverse() * weight.recip()
    };
    let mut inverses: Vec<(usize, DMat3)> = (0..moves.len()).map(|p| (p, inverse_at(p))).collect();
    inverses.retain(|(_, inverse)| *inverse != DMat3::ZERO);
    // So that the result does not depend on the order of the vertices.
    let key = |p: usize| places.places[p].to_array().map(f64::to_bits);
    inverses.sort_unstable_by_key(|&(p, _)| key(p));
    for _ in 0..SWEEPS {
        for &(p, inverse) in &inverses {
            let mut rest = DVec3::ZERO;
            for (t, corner) in places.corners_at(p) {
                for term in terms[t].terms() {
                    rest += term.direction * term.form.rest(corner, term.moved)[0];
                }
            }
            moves[p] = inverse * rest;
            for (t, corner) in places.corners_at(p) {
                for term in terms[t].terms_mut() {
                    term.moved[corner] = [term.direction.dot(moves[p])];
                }
            }
        }
    }
    moves
}
