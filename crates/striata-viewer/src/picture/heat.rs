//! Distances as colors: how far each vertex of the original is from a level.

use striata::mesh::{IndexedMesh, MeshError, TriangleTree};

use super::canvas::from_srgb;
use super::paint::Color;

/// How far the vertices of a mesh are from another surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Heat {
    /// One distance a vertex, mesh units; 0 for those that no triangle uses.
    pub distances: Vec<f64>,
    /// The largest.
    pub max: f64,
}

impl Heat {
    /// Measures all vertices of a mesh that its triangles use.
    ///
    /// # Errors
    /// Where the other surface is no sound mesh.
    pub fn of(original: &IndexedMesh, level: &IndexedMesh) -> Result<Self, MeshError> {
        let tree = TriangleTree::new(level)?;
        let mut is_used = vec![false; original.vertex_count()];
        original.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
        let distance = |(position, is_used): (&[f32; 3], bool)| {
            if is_used { tree.distance_to(position.map(f64::from)) } else { 0.0 }
        };
        let distances: Vec<f64> = original.positions.iter().zip(is_used).map(distance).collect();
        let max = distances.iter().copied().fold(0.0, f64::max);
        Ok(Self { distances, max })
    }

    /// The colors of the vertices, where `top` has the last one.
    pub fn colors(&self, top: f64) -> Vec<Color> {
        let share = |distance: f64| if top > 0.0 { (distance / top).min(1.0) } else { 0.0 };
        self.distances.iter().map(|&distance| bytes(color_at(share(distance)))).collect()
    }
}

/// The color of a share of the largest distance, linear light: inferno backwards, so that what is near is pale and looks
/// as much darker as the distance is larger; its darkest part would be lost among shadows.
pub(super) fn color_at(share: f64) -> [f32; 3] {
    const DARKEST: f64 = 0.22;
    // Between neighbors of the map, since its own bytes make steps in the dark.
    let place = 255.0 * (1.0 - (1.0 - DARKEST) * share.clamp(0.0, 1.0));
    let (below, above) = (place.floor(), place.ceil());
    let [a, b] = [below, above].map(|at| {
        let color = colorous::INFERNO.eval_continuous(at / 255.0);
        [color.r, color.g, color.b].map(from_srgb)
    });
    let weight = (place - below) as f32;
    [0, 1, 2].map(|k| a[k] + weight * (b[k] - a[k]))
}

fn bytes([r, g, b]: [f32; 3]) -> Color {
    let [r, g, b] = [r, g, b].map(|light| (255.0 * light + 0.5) as u8);
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    #[test]
    fn distances_are_those_from_the_surface() {
        let level = shapes::grid(1, 1);
        let flat = level.positions[0];
        let axis = (0..3).find(|&k| level.positions.iter().all(|p| p[k] == flat[k])).expect("it is flat");
        let mut above: [f32; 3] = [0, 1, 2].map(|k| (level.positions[1][k] + level.positions[2][k]) / 2.0);
        above[axis] += 0.25;
        let mut original = level.clone();
        original.positions.extend([above, [0.0, 0.0, 9.0]]);
        original.triangles.push([0, 1, 4]);
        let heat = Heat::of(&original, &level).expect("sound meshes");
        assert!((heat.max - 0.25).abs() < 1e-6 && heat.distances[..4] == [0.0; 4], "{heat:?}");
        assert_eq!(heat.distances[5], 0.0, "no triangle uses it");
        let colors = heat.colors(heat.max);
        assert_eq!((colors[0], colors[4]), (bytes(color_at(0.0)), bytes(color_at(1.0))));
        assert_eq!(heat.colors(0.0)[4], bytes(color_at(0.0)));
    }

    #[test]
    fn larger_distances_are_darker_step_by_step() {
        let light = |step: u32| {
            let [r, g, b] = color_at(f64::from(step) / 64.0);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!(light(0) > 0.9 && light(64) < 0.04, "{} {}", light(0), light(64));
        for step in 0..64 {
            assert!(light(step + 1) < light(step), "step {step}");
        }
    }
}
