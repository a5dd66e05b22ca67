//! Report of `poses`: tables for people, and JSON.

use serde::Serialize;
use striata_command::output::{Table, format_count, format_duration, format_length};

use super::measure::PoseDistances;

/// Results of all scenes.
#[derive(Serialize)]
pub(super) struct PosesReport {
    /// Times of each animation.
    pub times: u32,
    pub scenes: Vec<SceneReport>,
}

/// The deformed meshes of a scene.
#[derive(Serialize)]
pub(super) struct SceneReport {
    pub name: String,
    pub meshes: Vec<PosedMeshReport>,
}

/// Levels of a mesh that was simplified for its poses, and of the same mesh simplified in its bind pose.
#[derive(Serialize)]
pub(super) struct PosedMeshReport {
    pub index: usize,
    pub name: String,
    pub triangle_count: usize,
    pub vertex_count: usize,
    /// Poses that were measured.
    pub pose_count: usize,
    /// Time of simplification in the bind pose.
    pub bind_secs: f64,
    /// Time of simplification for poses: their choice, simplification, and measuring them.
    pub secs: f64,
    pub choice_secs: f64,
    pub finish_secs: f64,
    pub levels: Vec<PosedLevelReport>,
}

/// Levels of one share; lengths in mesh units.
#[derive(Serialize)]
pub(super) struct PosedLevelReport {
    pub percent: f64,
    pub triangle_count: usize,
    /// Distances of the level that was simplified in the bind pose, and the error that it reports.
    pub bind: PoseDistances,
    pub bind_error: f64,
    /// Distances of the level that was simplified for poses.
    pub distances: PoseDistances,
    /// Its error before poses were measured, and after.
    pub estimated_error: f64,
    pub error: f64,
    /// Whether no distance exceeds the error.
    pub is_held: bool,
}

impl PosesReport {
    /// Tables with an explanation of their columns.
    pub(super) fn to_text(&self) -> String {
        let mut text = format!(
            "Distances of the posed full mesh from posed levels, {} times per animation, mesh units.\n\
             bind: simplified in the bind pose only; estimated and error: before and after measuring poses\n",
            self.times
        );
        for scene in &self.scenes {
            if scene.meshes.is_empty() {
                text.push_str(&format!("\n{}: nothing is deformed\n", scene.name));
            }
            for mesh in &scene.meshes {
                mesh.add_text(&scene.name, &mut text);
            }
        }
        text
    }
}

impl PosedMeshReport {
    fn add_text(&self, scene: &str, text: &mut String) {
        text.push_str(&format!(
            "\n{scene}, mesh {} {:?}: {} triangles, {} vertices, {} poses; {} for poses ({} to choose, {} to \
             measure), {} in the bind pose\n",
            self.index,
            self.name,
            format_count(self.triangle_count),
            format_count(self.vertex_count),
            self.pose_count,
            format_duration(self.secs),
            format_duration(self.choice_secs),
            format_duration(self.finish_secs),
            format_duration(self.bind_secs),
        ));
        let head = [
            "%",
            "triangles",
            "bind RMS",
            "bind max",
            "bind error",
            "RMS",
            "max",
            "estimated",
            "error",
            "held",
        ];
        let mut table = Table::with_head(&head);
        for level in &self.levels {
            let mut row = vec![format!("{}", level.percent), format_count(level.triangle_count)];
            let lengths = [
                level.bind.rms,
                level.bind.max,
                level.bind_error,
                level.distances.rms,
                level.distances.max,
                level.estimated_error,
                level.error,
            ];
            row.extend(lengths.map(format_length));
            row.push(if level.is_held { "yes" } else { "no" }.to_owned());
            table.row(row);
        }
        text.push_str(&table.to_text());
    }
}
