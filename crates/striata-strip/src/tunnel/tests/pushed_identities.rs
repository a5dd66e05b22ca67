//! Identities as \[PS03, 4\] describes them: each node has a stack, and a step pushes along a whole strip.

use striata::mesh::NO_TWIN;
use striata::strip::StripLinks;

use super::super::trace::TunnelStep;

/// Links that change with each step of a tunnel, and the identities of their strips.
pub(super) struct PushedIdentities<'a> {
    links: StripLinks<'a>,
    /// Stack of identities of each triangle; the last one is valid.
    stacks: Vec<Vec<u32>>,
    /// Steps, each with the triangles whose stack it pushed to.
    steps: Vec<(TunnelStep, Vec<u32>)>,
}

impl<'a> PushedIdentities<'a> {
    pub(super) fn new(links: StripLinks<'a>) -> Self {
        let count = links.triangle_count() as u32;
        let stacks = (0..count).map(|t| vec![*strip_of(&links, t).iter().min().unwrap()]).collect();
        Self { links, stacks, steps: Vec::new() }
    }

    pub(super) fn are_in_one_strip(&self, a: u32, b: u32) -> bool {
        self.stacks[a as usize].last() == self.stacks[b as usize].last()
    }

    /// Whether a walk through this side comes to a triangle.
    pub(super) fn leads_to(&self, side: u32, triangle: u32) -> bool {
        beyond(&self.links, side).contains(&triangle)
    }

    /// Returns the steps from a moving end that obey the second rule.
    pub(super) fn valid_steps(&self, end: u32, is_visited: impl Fn(u32) -> bool) -> Vec<TunnelStep> {
        let mut steps = Vec::new();
        for crossed in 3 * end..3 * end + 3 {
            let entered = self.links.twins()[crossed as usize];
            if entered == NO_TWIN || self.links.is_solid(crossed) || is_visited(entered / 3) {
                continue;
            }
            let taken = entered / 3;
            for cut in (3 * taken..3 * taken + 3).filter(|&side| self.links.is_solid(side)) {
                let next = self.links.twins()[cut as usize] / 3;
                let is_right = !self.are_in_one_strip(end, taken) || self.leads_to(cut, end);
                if is_right && !is_visited(next) {
                    steps.push(TunnelStep { crossed, taken, cut, end: next });
                }
            }
        }
        steps
    }

    /// Takes a step: the triangles that join the moving end's strip get its identity.
    pub(super) fn push(&mut self, step: TunnelStep) {
        let identity = *self.stacks[step.crossed as usize / 3].last().unwrap();
        self.links.cut(step.cut);
        let is_same = self.are_in_one_strip(step.crossed / 3, step.taken);
        let pushed = if is_same { Vec::new() } else { strip_of(&self.links, step.taken) };
        pushed.iter().for_each(|&t| self.stacks[t as usize].push(identity));
        self.links.join(step.crossed);
        self.steps.push((step, pushed));
    }

    /// Takes back the last step.
    pub(super) fn pop(&mut self) {
        let (step, pushed) = self.steps.pop().unwrap();
        self.links.cut(step.crossed);
        self.links.join(step.cut);
        for &triangle in &pushed {
            self.stacks[triangle as usize].pop();
        }
        assert!(self.stacks.iter().all(|stack| !stack.is_empty()));
    }

    pub(super) fn into_links(self) -> StripLinks<'a> {
        self.links
    }
}

/// Returns the triangles of a strip.
fn strip_of(links: &StripLinks<'_>, triangle: u32) -> Vec<u32> {
    let sides = (3 * triangle..3 * triangle + 3).filter(|&side| links.is_solid(side));
    std::iter::once(triangle).chain(sides.flat_map(|side| beyond(links, side))).collect()
}

/// Returns the triangles of a strip beyond a solid side.
fn beyond(links: &StripLinks<'_>, side: u32) -> Vec<u32> {
    let (mut triangles, mut exit) = (Vec::new(), Some(side));
    while let Some(side) = exit {
        let entered = links.twins()[side as usize];
        triangles.push(entered / 3);
        exit = (entered / 3 * 3..entered / 3 * 3 + 3).find(|&s| s != entered && links.is_solid(s));
    }
    triangles
}
