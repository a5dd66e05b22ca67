//! Conversion of floats to small integers.

use super::changes::Texcoords;
use super::grid::MeshGrid;
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::passes::elements::Elements;

/// Rounds positions to a grid.
pub(super) fn positions(numbers: &[f32], grid: &MeshGrid) -> Elements {
    let points = numbers.as_chunks::<3>().0.iter();
    let rounded = points.flat_map(|&point| grid.rounded(point)).map(i64::from);
    let component = if grid.last <= 0xff { GltfComponentType::U8 } else { GltfComponentType::U16 };
    Elements::integers(rounded, 3, component)
}

/// Expresses displacements of positions in grid steps: as integers, or as floats if they are too long.
pub(super) fn displacements(numbers: &[f32], grid: &MeshGrid) -> Option<Elements> {
    let steps = || numbers.iter().map(|&x| f64::from(x) / f64::from(grid.step));
    if numbers.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let most = steps().fold(0.0, |most: f64, x| most.max(x.abs()));
    Some(if most < 32767.5 {
        let component = if most < 127.5 { GltfComponentType::I8 } else { GltfComponentType::I16 };
        Elements::integers(steps().map(|x| x.round() as i64), 3, component)
    } else {
        let floats: Vec<f32> = steps().map(|x| x as f32).collect();
        if floats.iter().any(|x| !x.is_finite()) {
            return None;
        }
        Elements::floats(&floats, 3)
    })
}

/// Converts numbers from -1 to 1 to normalized integers; [`None`] if there are others.
pub(super) fn signed_fractions(numbers: &[f32], width: usize, bits: u32) -> Option<Elements> {
    // Lengths that differ from 1 by a rounding error are corrected.
    if !numbers.iter().all(|x| x.abs() <= 1.001) {
        return None;
    }
    let bits = bits.clamp(2, 16);
    let (component, most) =
        if bits <= 8 { (GltfComponentType::I8, 127.0) } else { (GltfComponentType::I16, 32767.0) };
    let last = f64::from((1u32 << (bits - 1)) - 1);
    let fraction = |&x: &f32| {
        let level = (f64::from(x).clamp(-1.0, 1.0) * last).round();
        (level * most / last).round() as i64
    };
    Some(Elements::integers(numbers.iter().map(fraction), width, component).into_normalized())
}

/// Converts numbers from 0 to 1 to normalized integers; [`None`] if there are others.
pub(super) fn fractions(numbers: &[f32], width: usize, bits: u32) -> Option<Elements> {
    if !numbers.iter().all(|x| (0.0..=1.0).contains(x)) {
        return None;
    }
    let bits = bits.clamp(1, 16);
    let (component, most) =
        if bits <= 8 { (GltfComponentType::U8, 255.0) } else { (GltfComponentType::U16, 65535.0) };
    let last = f64::from((1u32 << bits) - 1);
    let fraction = |&x: &f32| ((f64::from(x) * last).round() * most / last).round() as i64;
    Some(Elements::integers(numbers.iter().map(fraction), width, component).into_normalized())
}

/// Converts texture coordinates from 0 to 1 to 16-bit fractions, unless floats are wanted, and rounds others
/// to multiples of 2^-bits; [`None`] if some are not finite.
pub(super) fn texture_coordinates(numbers: &[f32], bits: u32, texcoords: Texcoords) -> Option<Elements> {
    let bits = bits.clamp(1, 16);
    if texcoords == Texcoords::Integers && numbers.iter().all(|x| (0.0..=1.0).contains(x)) {
        let last = f64::from((1u32 << bits) - 1);
        let fraction = |&x: &f32| ((f64::from(x) * last).round() * 65535.0 / last).round() as i64;
        let integers = numbers.iter().map(fraction);
        return Some(Elements::integers(integers, 2, GltfComponentType::U16).into_normalized());
    }
    if numbers.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let cells = f64::from(1u32 << bits);
    let rounded = |&x: &f32| ((f64::from(x) * cells).round() / cells) as f32;
    Some(Elements::floats(&numbers.iter().map(rounded).collect::<Vec<f32>>(), 2))
}

/// Converts the weights of each vertex, in one or several sets of 4, to bytes whose sum is 255.
pub(super) fn weights(sets: &[Vec<f32>]) -> Option<Vec<Elements>> {
    let length = sets.first()?.len();
    if sets.iter().any(|set| set.len() != length || set.iter().any(|x| !x.is_finite() || *x < 0.0)) {
        return None;
    }
    let mut bytes = vec![Vec::with_capacity(length); sets.len()];
    for vertex in 0..length / 4 {
        let own: Vec<f64> =
            sets.iter().flat_map(|set| &set[4 * vertex..4 * vertex + 4]).map(|&x| f64::from(x)).collect();
        let shares = shares(&own);
        for (set, four) in bytes.iter_mut().zip(shares.chunks(4)) {
            set.extend_from_slice(four);
        }
    }
    let elements = |set: Vec<i64>| Elements::integers(set, 4, GltfComponentType::U8).into_normalized();
    Some(bytes.into_iter().map(elements).collect())
}

/// Divides 255 in proportion to weights; weights that are all zero stay so.
fn shares(weights: &[f64]) -> Vec<i64> {
    let sum: f64 = weights.iter().sum();
    if sum <= 0.0 {
        return vec![0; weights.len()];
    }
    let exact: Vec<f64> = weights.iter().map(|x| x / sum * 255.0).collect();
    let mut shares: Vec<i64> = exact.iter().map(|x| *x as i64).collect();
    let missing = 255 - shares.iter().sum::<i64>();
    let mut order: Vec<usize> = (0..weights.len()).collect();
    order.sort_by(|&a, &b| exact[b].fract().total_cmp(&exact[a].fract()).then(a.cmp(&b)));
    for &place in order.iter().cycle().take(missing.max(0) as usize) {
        shares[place] += 1;
    }
    shares
}
