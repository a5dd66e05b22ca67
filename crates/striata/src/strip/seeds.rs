//! Which triangles are still free, and which of them is to start the next strip.
//!
//! A triangle with few free neighbors is in danger of being left alone, so strips that are grown one after
//! another start there: a stack for each number of free neighbors, the last added first, so that the next strip
//! lies beside the last one. Entries are not moved when a count falls but pushed again; those left behind are
//! skipped. Linear in time; a byte and, over a whole run, some eight bytes a triangle.

use std::ops::Range;

use super::StripLinks;
use crate::mesh::{NO_TWIN, is_proper};

/// Triangles that no strip holds yet, for stripifiers that grow one strip after another.
///
/// Sides are those of [`StripLinks`]: side `3 * triangle + k` runs from corner `k` to the next.
#[derive(Clone, Debug)]
pub struct FreeTriangles<'a> {
    twins: &'a [u32],
    is_free: Vec<bool>,
}

impl<'a> FreeTriangles<'a> {
    /// Triangles that stand alone, degenerate ones left out.
    ///
    /// # Panics
    /// If `triangles` are more than the links know.
    pub fn new(triangles: &[[u32; 3]], links: &StripLinks<'a>) -> Self {
        let is_free = |(t, corners): (u32, _)| is_proper(corners) && links.solid_bits(t) == 0;
        Self { twins: links.twins(), is_free: (0..).zip(triangles).map(is_free).collect() }
    }

    /// Whether no strip holds this triangle.
    #[inline]
    pub fn is_free(&self, triangle: u32) -> bool {
        self.is_free[triangle as usize]
    }

    /// Notes that a strip holds this triangle now.
    #[inline]
    pub fn take(&mut self, triangle: u32) {
        self.is_free[triangle as usize] = false;
    }

    /// The free triangle that is entered by leaving another through this side: the side entered by.
    #[inline]
    pub fn beyond(&self, exit: u32) -> Option<u32> {
        let enter = self.twins[exit as usize];
        (enter != NO_TWIN && self.is_free(enter / 3)).then_some(enter)
    }

    /// Free neighbors of a triangle, each link counted.
    #[inline]
    pub fn neighbor_count(&self, triangle: u32) -> usize {
        (3 * triangle..3 * triangle + 3).filter(|&side| self.beyond(side).is_some()).count()
    }
}

/// Triangles that wait to start a strip, those with the fewest free neighbors first, the last added first.
#[derive(Clone, Debug)]
pub struct Seeds {
    by_count: [Vec<u32>; 4],
}

impl Seeds {
    /// The free triangles of a group, which is a range of triangles.
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

    /// Adds the neighbors of a triangle that has just been covered.
    pub fn push_around(&mut self, triangle: u32, free: &FreeTriangles<'_>) {
        for enter in (3 * triangle..3 * triangle + 3).filter_map(|side| free.beyond(side)) {
            self.push(enter / 3, free);
        }
    }

    /// Takes the next free triangle out.
    pub fn pop(&mut self, free: &FreeTriangles<'_>) -> Option<u32> {
        for stack in &mut self.by_count {
            while let Some(triangle) = stack.pop() {
                // Entries that have moved to a lower stack or are covered stay behind: skipped here.
                if free.is_free(triangle) {
                    return Some(triangle);
                }
            }
        }
        None
    }
}
