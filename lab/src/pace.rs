//! How the level falls on a walk away from an object: the linear test of \[RCRG06\] and \[BRR02\], section 4.3,
//! and the exponential test of the latter.

use clap::ValueEnum;
use serde::Serialize;

/// In each frame, an exponential walk covers this share of the remaining detail, divided by the number of
/// frames.
const EXPONENTIAL_RATE: f64 = 5.0;

/// How the level falls as the object moves away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Pace {
    /// Equally many steps in each frame.
    #[default]
    Linear,
    /// A fixed share of the remaining steps in each frame: large changes near, small ones far away.
    Exponential,
}

impl Pace {
    /// All paces.
    pub(crate) const ALL: [Self; 2] = [Self::Linear, Self::Exponential];

    /// Name of the pace.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Exponential => "exponential",
        }
    }

    /// Capitalized name of the pace.
    pub(crate) const fn title(self) -> &'static str {
        match self {
            Self::Linear => "Linear",
            Self::Exponential => "Exponential",
        }
    }

    /// Split counts from the full mesh (near) to the base mesh (far): one more than there are frames.
    pub(crate) fn split_counts(self, step_count: usize, frames: usize) -> Vec<usize> {
        let frames = frames.max(1);
        // Repeated multiplication gives the same result on every machine.
        let remaining_per_frame = 1.0 - (EXPONENTIAL_RATE / frames as f64).min(0.5);
        let remainders: Vec<f64> =
            std::iter::successors(Some(1.0), |remaining| Some(remaining * remaining_per_frame))
                .take(frames + 1)
                .collect();
        let last = remainders[frames];
        let detail = |frame: usize| match self {
            Self::Linear => 1.0 - frame as f64 / frames as f64,
            Self::Exponential => (remainders[frame] - last) / (1.0 - last),
        };
        (0..=frames).map(|frame| (detail(frame) * step_count as f64).round() as usize).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walks_lead_from_the_full_mesh_to_the_base() {
        for pace in Pace::ALL {
            for (step_count, frames) in [(0, 1), (1, 1), (7, 200), (1000, 1), (1000, 3), (34_000, 200)] {
                let levels = pace.split_counts(step_count, frames);
                assert_eq!((levels.len(), levels[0], levels[frames]), (frames + 1, step_count, 0));
                assert!(levels.is_sorted_by(|a, b| a >= b), "{pace:?}: {levels:?}");
            }
        }
    }

    #[test]
    fn exponential_walk_changes_much_near_and_little_far_away() {
        let changes = |pace: Pace| -> Vec<usize> {
            pace.split_counts(10_000, 100).windows(2).map(|pair| pair[0] - pair[1]).collect()
        };
        assert!(changes(Pace::Linear).iter().all(|&change| change == 100));
        let falling = changes(Pace::Exponential);
        assert!(falling.is_sorted_by(|a, b| a + 1 >= *b), "{falling:?}");
        assert!(falling[0] > 450 && falling[99] < 10, "{falling:?}");
    }
}
