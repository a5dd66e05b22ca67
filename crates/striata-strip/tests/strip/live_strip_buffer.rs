//! Index buffers of live strips: they draw the level, and their changed ranges are complete.

use std::ops::Range;

use proptest::prelude::*;
use striata::mesh::{RefinableMesh, canonical_triangles, replay, shapes};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::{RESTART, restart_triangles_into};
use striata_strip::{LiveStripBuffer, LiveStrips, RepairGoal, RepairOptions, StripOptions, stripify};
use striata_testing::support::{
    Random, RandomSequenceOptions, grid, nasty, random_refinable, soup, with_seams_and_groups,
};

/// Live strips, their buffer, and a copy that only gets the changed ranges, as a GPU would.
struct Followed<'a> {
    refinable: &'a RefinableMesh,
    live: LiveStrips<'a>,
    buffer: LiveStripBuffer,
    copy: Vec<u32>,
    uploaded_count: usize,
}

impl<'a> Followed<'a> {
    fn new(refinable: &'a RefinableMesh, split_count: usize, options: &RepairOptions) -> Self {
        let strips = stripify(&replay(refinable, split_count), &StripOptions::default()).unwrap();
        let mut live = LiveStrips::new(refinable, split_count, &strips, options).unwrap();
        let buffer = LiveStripBuffer::new(&mut live);
        let mut followed = Self { refinable, live, buffer, copy: Vec::new(), uploaded_count: 0 };
        followed.upload();
        followed.check();
        followed
    }

    fn move_to(&mut self, split_count: usize) {
        self.live.move_to(split_count);
        self.buffer.sync(&mut self.live);
        self.uploaded_count = self.upload();
        self.check();
    }

    /// Copies the changed ranges; returns the number of indices in them.
    fn upload(&mut self) -> usize {
        let indices = self.buffer.indices().to_vec();
        self.copy.resize(indices.len(), 7);
        let ranges = self.buffer.take_changed_ranges();
        assert!(ranges.is_sorted_by(|a, b| a.end < b.start), "{ranges:?}");
        for range in &ranges {
            let range = range.start as usize..range.end as usize;
            self.copy[range.clone()].copy_from_slice(&indices[range]);
        }
        ranges.iter().map(ExactSizeIterator::len).sum()
    }

    fn check(&self) {
        assert!(self.copy == self.buffer.indices(), "the changed ranges are not complete");
        let level = replay(self.refinable, self.live.split_count());
        let ranges: Vec<Range<u32>> = self.buffer.group_ranges().collect();
        assert_eq!(ranges.len(), level.groups_or_whole().len());
        let mut drawn_strips = 0;
        for (group, range) in level.groups_or_whole().into_iter().zip(ranges) {
            let indices = &self.copy[range.start as usize..range.end as usize];
            let mut found = Vec::new();
            restart_triangles_into(indices, &mut found);
            let expected = canonical_triangles(&level.triangles[group.range()]);
            assert_eq!(canonical_triangles(&found), expected, "at {}", self.live.split_count());
            drawn_strips += indices.split(|&i| i == RESTART).filter(|strip| !strip.is_empty()).count();
        }
        assert_eq!(drawn_strips, self.live.strip_count());
        self.check_strip_ranges();
        let drawn: u32 = self.buffer.group_ranges().map(|range| range.end - range.start).sum();
        let live = self.buffer.live_index_count();
        let needed: usize = self.live.to_strip_set().strips().map(|strip| strip.len() + 1).sum();
        assert_eq!(live, needed, "each strip is written in its cheaper direction");
        assert!(drawn as usize <= live + live / 4 + 64 * self.buffer.group_ranges().count());
    }

    fn check_strip_ranges(&self) {
        let mut ranges: Vec<Range<u32>> = self.buffer.strip_ranges().collect();
        ranges.sort_unstable_by_key(|range| range.start);
        assert_eq!(ranges.len(), self.live.strip_count());
        assert!(ranges.is_sorted_by(|a, b| a.end < b.start), "strips overlap or lack a restart");
        let all = ranges.iter().flat_map(|range| &self.copy[range.start as usize..range.end as usize]);
        assert!(all.clone().all(|&index| index != RESTART));
        assert_eq!(all.count(), self.copy.iter().filter(|&&index| index != RESTART).count());
    }
}

fn simplified(mesh: &striata::mesh::IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &SequenceOptions::default()).unwrap().refinable
}

#[test]
fn every_level_of_difficult_meshes_is_drawn() {
    for (name, mesh) in nasty() {
        eprintln!("{name}");
        let options = RandomSequenceOptions { far_percent: 20, base_position_count: 1 };
        let refinable = random_refinable(&mesh, options, &mut Random::new(3));
        let step_count = refinable.sequence.step_count();
        let mut followed = Followed::new(&refinable, step_count, &RepairOptions::default());
        (0..step_count).rev().chain(0..=step_count).for_each(|split_count| followed.move_to(split_count));
    }
}

#[test]
fn a_buffer_that_starts_at_the_base_grows() {
    let refinable = simplified(&with_seams_and_groups(grid(20, true)));
    let step_count = refinable.sequence.step_count();
    let mut followed = Followed::new(&refinable, 0, &RepairOptions::default());
    let before = followed.copy.len();
    (0..=step_count).step_by(5).chain([step_count]).for_each(|split_count| followed.move_to(split_count));
    assert!(followed.copy.len() > 4 * before);
    followed.move_to(0);
    followed.move_to(step_count);
}

#[test]
fn a_small_step_uploads_little() {
    let refinable = simplified(&shapes::terrain(120, 4));
    let step_count = refinable.sequence.step_count();
    for goal in [RepairGoal::FewestIndices, RepairGoal::FewestStrips] {
        let options = RepairOptions::default().with_goal(goal);
        let mut followed = Followed::new(&refinable, step_count / 2, &options);
        let whole = followed.copy.len();
        let mut uploaded_count = 0;
        for step in 1..=50 {
            followed.move_to(step_count / 2 - step);
            uploaded_count += followed.uploaded_count;
        }
        assert!(uploaded_count < 50 * whole / 20, "{uploaded_count} of {} indices", 50 * whole);
        followed.move_to(step_count / 2 - 50);
        assert_eq!(followed.uploaded_count, 0, "nothing has changed");
    }
}

#[test]
fn owned_strips_go_on_where_borrowed_ones_were() {
    let refinable = simplified(&shapes::torus(20, 12, 2.0, 1.0));
    let step_count = refinable.sequence.step_count();
    let strips = stripify(&refinable.mesh, &StripOptions::default()).unwrap();
    let mut borrowed = LiveStrips::new(&refinable, step_count, &strips, &RepairOptions::default()).unwrap();
    borrowed.move_to(step_count / 3);
    let mut owned: LiveStrips<'static> = borrowed.clone().into_owned();
    assert_eq!(owned.move_to(step_count / 2), borrowed.move_to(step_count / 2));
    assert_eq!(owned.to_strip_set(), borrowed.to_strip_set());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(64) })]

    /// Whatever the jumps: a copy that only gets the changed ranges equals the buffer and draws the level.
    #[test]
    fn changed_ranges_keep_a_copy_up_to_date(
        seed in any::<u64>(),
        vertex_count in 3usize..60,
        triangle_count in 0usize..120,
        kind in 0usize..3,
        jumps in prop::collection::vec(0.0f64..=1.0, 1..25),
        goal in 0usize..2,
    ) {
        let mut random = Random::new(seed);
        let mesh = match kind {
            0 => soup(vertex_count, triangle_count, &mut random),
            1 => with_seams_and_groups(soup(vertex_count, triangle_count, &mut random)),
            _ => grid(12, true),
        };
        let sequence = RandomSequenceOptions { far_percent: 5, base_position_count: 1 };
        let refinable = random_refinable(&mesh, sequence, &mut random);
        let goal = [RepairGoal::FewestIndices, RepairGoal::FewestStrips][goal];
        let step_count = refinable.sequence.step_count();
        let start = (jumps[0] * step_count as f64) as usize;
        let mut followed = Followed::new(&refinable, start, &RepairOptions::default().with_goal(goal));
        for jump in jumps {
            followed.move_to((jump * step_count as f64) as usize);
        }
    }
}
