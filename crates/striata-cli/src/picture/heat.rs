//! Distances as colours: how far each vertex of the original is from a level.

use striata::mesh::{IndexedMesh, MeshError, TriangleTree};

use super::paint::{Colour, linear};

/// How far the vertices of a mesh are from another surface.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Heat {
    /// One distance a vertex, mesh units; 0 for those that no triangle uses.
    pub(crate) distances: Vec<f64>,
    /// The largest.
    pub(crate) max: f64,
}

impl Heat {
    /// Measures all vertices of a mesh that its triangles use.
    ///
    /// # Errors
    /// Where the other surface is no sound mesh.
    pub(crate) fn of(original: &IndexedMesh, level: &IndexedMesh) -> Result<Self, MeshError> {
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

    /// The colours of the vertices, where `top` has the last one.
    pub(crate) fn colours(&self, top: f64) -> Vec<Colour> {
        let share = |distance: f64| if top > 0.0 { (distance / top).min(1.0) } else { 0.0 };
        self.distances.iter().map(|&distance| colour_at(share(distance))).collect()
    }
}

/// The colour of a share of the largest distance; it looks as much brighter as the distance is larger.
pub(super) fn colour_at(share: f64) -> Colour {
    linear(colorous::VIRIDIS.eval_continuous(share.clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    #[test]
    fn distances_are_those_from_the_surface() {
        let level = shapes::grid(1, 1);
        let mut original = level.clone();
        original.positions.push([0.5, 0.5, 0.25]);
        original.positions.push([0.0, 0.0, 9.0]);
        original.triangles.push([0, 1, 4]);
        let plane = level.positions[0];
        original.positions[4] = [plane[0], plane[1], plane[2]];
        original.positions[4] =
            std::array::from_fn(|k| (level.positions[1][k] + level.positions[2][k]) / 2.0);
        let flat = (0..3).find(|&k| level.positions.iter().all(|p| p[k] == plane[k])).expect("it is flat");
        original.positions[4][flat] += 0.25;
        let heat = Heat::of(&original, &level).expect("sound meshes");
        assert!((heat.max - 0.25).abs() < 1e-6 && heat.distances[..4] == [0.0; 4], "{heat:?}");
        assert_eq!(heat.distances[5], 0.0, "no triangle uses it");
        let colours = heat.colours(heat.max);
        assert_eq!((colours[0], colours[4]), (colour_at(0.0), colour_at(1.0)));
        assert_eq!(heat.colours(0.0)[4], colour_at(0.0));
    }

    #[test]
    fn larger_distances_are_brighter() {
        let light = |share: f64| {
            let [r, g, b, _] = colour_at(share).map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        for step in 1..=16 {
            let (below, above) = (light(f64::from(step - 1) / 16.0), light(f64::from(step) / 16.0));
            assert!(above > below, "{step}: {below} {above}");
        }
    }
}
