//! Free triangles, and the choice of the free triangle that starts the next strip.
//!
//! A triangle with few free neighbors is likely to be left isolated, so strips that are grown one after
//! another start there. There is one stack for each number of free neighbors; the triangle added last is
//! used first, so that each strip is adjacent to the previous one. When a count falls, the triangle is
//! pushed again instead of being moved; stale entries are skipped. Linear time; one byte per triangle, plus
//! about eight bytes per triangle over a whole run.

use std::ops::Range;

use super::StripLinks;
use crate::mesh::{NO_TWIN, is_proper};

/// Triangles that do not belong to a strip yet, for stripifiers that grow one strip after another.
///
/// Sides are numbered as in [`StripLinks`]: side `3 * triangle + k` runs from corner `k` to the next corner.
#[derive(Clone, Debug)]
pub struct FreeTriangles<'a> {
    twins: &'a [u32],
    is_free: Vec<bool>,
}

impl<'a> FreeTriangles<'a> {
    /// Marks all triangles as free that have no solid link and are not degenerate.
    ///
    /// # Panics
    /// If there are more triangles than in the graph of the links.
    pub fn new(triangles: &[[u32; 3]], links: &StripLinks<'a>) -> Self {
        let is_free = |(t, corners): (u32, _)| is_proper(corners) && links.solid_bits(t) == 0;
        Self { twins: links.twins(), is_free: (0..).zip(triangles).map(is_free).collect() }
    }

    /// Whether a triangle does not belong to a strip yet.
    #[inline]
    pub fn is_free(&self, triangle: u32) -> bool {
        self.is_free[triangle as usize]
    }

    /// Marks a triangle as part of a strip.
    #[inline]
    pub fn mark_used(&mut self, triangle: u32) {
        self.is_free[triangle as usize] = false;
    }

    /// If the triangle across side `exit` is free, the side by which it is entered.
    #[inline]
    pub fn free_entry_across(&self, exit: u32) -> Option<u32> {
        let enter = self.twins[exit as usize];
        (enter != NO_TWIN && self.is_free(enter / 3)).then_some(enter)
    }

    /// Number of links from a triangle to free triangles; a triangle linked twice counts twice.
    #[inline]
    pub fn neighbor_count(&self, triangle: u32) -> usize {
        (3 * triangle..3 * triangle + 3).filter(|&side| self.free_entry_across(side).is_some()).count()
    }
}

/// Candidates for the start of a strip: those with the fewest free neighbors first, then those added last.
#[derive(Clone, Debug)]
pub struct Seeds {
    by_count: [Vec<u32>; 4],
}

impl Seeds {
    /// Collects the free triangles of a group, given as a range of triangles.
    pub fn new(free: &FreeTriangles<'_>, group: Range<usize>) -> Self {
        let mut seeds = Self { by_count: Default::default() };
        for triangle in (group.start as u32..group.end as u32).rev().filter(|&t| free.is_free(t)) {
            seeds.push(triangle, free);
        }
        seeds
    }

    fn push(&mut self, triangle: u32, free: &FreeTriangles<'_>) {
        self.by_count[free.neighbor_count(triangle)].push(triangle);
    }

    /// Adds the free neighbors of a triangle that has just become part of a strip.
    pub fn push_around(&mut self, triangle: u32, free: &FreeTriangles<'_>) {
        for enter in (3 * triangle..3 * triangle + 3).filter_map(|side| free.free_entry_across(side)) {
            self.push(enter / 3, free);
        }
    }

    /// Removes and returns the next free triangle.
    pub fn pop(&mut self, free: &FreeTriangles<'_>) -> Option<u32> {
        for stack in &mut self.by_count {
            while let Some(triangle) = stack.pop() {
                // Skip stale entries: triangles that are now in a lower stack or in a strip.
                if free.is_free(triangle) {
                    return Some(triangle);
                }
            }
        }
        None
    }
}
