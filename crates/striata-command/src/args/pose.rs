//! Flags for the pose of an animated scene.

use clap::Args;
use striata_scene::Poser;

use crate::failure::Failure;

/// Flags for the pose of an animated scene.
#[derive(Clone, Debug, Default, Args)]
pub struct PoseArgs {
    /// Pose of the scene at this time of its animation, in seconds [default: the pose without animation]
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true, value_parser = parse_seconds)]
    pub time: Option<f32>,
    /// Animation to take the pose from: its number, beginning with 0, or its name [default: 0]
    #[arg(long, value_name = "N|NAME")]
    pub animation: Option<String>,
}

impl PoseArgs {
    /// Returns the first of these flags that was given.
    pub fn given(&self) -> Option<&'static str> {
        let of_animation = self.animation.as_ref().map(|_| "--animation");
        self.time.map(|_| "--time").or(of_animation)
    }

    /// Returns the animation and the time in seconds that the flags ask for; [`None`] if no flag was given.
    ///
    /// # Errors
    /// If a flag was given and there is no such animation.
    pub fn choose(&self, poser: &Poser, name: &str) -> Result<Option<(usize, f32)>, Failure> {
        let Some(flag) = self.given() else { return Ok(None) };
        if poser.animation_count() == 0 {
            return Err(Failure::user(format!("{name}: the scene has no animation"))
                .with_hint(format!("remove {flag}")));
        }
        let names: Vec<&str> = (0..poser.animation_count()).map(|at| poser.animation_name(at)).collect();
        let animation = self.animation.as_deref();
        let animation = animation.map_or(Ok(0), |wanted| find_entry(wanted, &names, "animation"))?;
        Ok(Some((animation, self.time.unwrap_or(0.0))))
    }
}

/// Finds an entry of a scene by its number or name; `what` says what it is, for messages.
///
/// # Errors
/// If there is none.
pub fn find_entry(wanted: &str, names: &[&str], what: &str) -> Result<usize, Failure> {
    /// Names in the hint.
    const SHOWN: usize = 12;
    let by_number = wanted.parse().ok().filter(|&index: &usize| index < names.len());
    let found = by_number.or_else(|| names.iter().position(|&name| name == wanted));
    found.ok_or_else(|| {
        let failure = Failure::user(format!("the scene has no {what} {wanted:?}"));
        let listed: Vec<String> =
            names.iter().take(SHOWN).enumerate().map(|(index, name)| format!("{index} {name:?}")).collect();
        let rest = if names.len() > SHOWN { ", ..." } else { "" };
        match names.len() {
            0 => failure.with_hint(format!("it has no {what}s")),
            _ => failure.with_hint(format!("it has these: {}{rest}", listed.join(", "))),
        }
    })
}

fn parse_seconds(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(time) if time >= 0.0 && time.is_finite() => Ok(time),
        _ => Err("must be a time of at least 0 seconds".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_found_by_number_or_name() {
        let names = ["walk", "1", "walk"];
        let of = |wanted| find_entry(wanted, &names, "animation").ok();
        assert_eq!(["walk", "0", "1", "2"].map(of), [Some(0), Some(0), Some(1), Some(2)]);
        let missing = find_entry("run", &names, "animation").expect_err("there is no such animation");
        assert!(missing.hint().is_some_and(|hint| hint.contains("0 \"walk\"")), "{missing:?}");
        assert!(find_entry("0", &[], "camera").is_err());
    }

    #[test]
    fn times_are_not_negative() {
        assert_eq!(parse_seconds("0.5"), Ok(0.5));
        assert!(["-1", "nan", "inf", "x"].iter().all(|text| parse_seconds(text).is_err()));
    }
}
