//! The place of a tileset on the Earth: from coordinates of a map to earth-centered ones.
//!
//! Tiles are drawn with one linear transform, which is that of the map at the center of the mesh. It contains the
//! scale of the map and its convergence, but not the curvature of the Earth.

use proj4rs::Proj;
use proj4rs::transform::transform;
use serde_json::Value;

use crate::error::TilesError;

/// Semi-major axis of WGS 84, in meters.
const EQUATOR: f64 = 6_378_137.0;
/// Flattening of WGS 84.
const FLATTENING: f64 = 1.0 / 298.257_223_563;

/// Columns of a transform.
pub(crate) type Matrix = [f64; 16];

/// The place of a mesh, and the error of its linear transform.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EarthPlace {
    /// From coordinates of the mesh, minus an offset, to earth-centered ones in meters.
    pub matrix: Matrix,
    /// Code of the coordinate system.
    pub epsg: u32,
    /// Largest distance of a corner of the mesh from its true place, in meters.
    pub error: f64,
}

/// A map whose coordinates follow from those of the mesh.
struct Map {
    system: Proj,
    wgs84: Proj,
    /// Coordinates of the origin of the mesh.
    origin: [f64; 2],
    /// Coordinates per mesh unit.
    scale: [f64; 2],
}

/// A point on the surface of the Earth, by longitude and latitude in radians and the height above the ellipsoid.
fn earth_centered([longitude, latitude, height]: [f64; 3]) -> [f64; 3] {
    let eccentricity = FLATTENING * (2.0 - FLATTENING);
    let radius = EQUATOR / (1.0 - eccentricity * latitude.sin().powi(2)).sqrt();
    let across = (radius + height) * latitude.cos();
    let up = (radius * (1.0 - eccentricity) + height) * latitude.sin();
    [across * longitude.cos(), across * longitude.sin(), up]
}

impl Map {
    fn place(&self, point: [f64; 3]) -> Option<[f64; 3]> {
        let map = [0, 1].map(|a| self.origin[a] + point[a] * self.scale[a]);
        let map = if self.system.is_latlong() { map.map(f64::to_radians) } else { map };
        let mut point = (map[0], map[1], point[2]);
        transform(&self.system, &self.wgs84, &mut point).ok()?;
        Some(earth_centered([point.0, point.1, point.2])).filter(|place| place.iter().all(|x| x.is_finite()))
    }
}

/// The place of a mesh with a georeference, given its bounds and the offset of the tileset, all in coordinates of the
/// mesh; `None` if the georeference names no coordinate system.
pub(crate) fn place(
    georeference: &Value,
    [min, max]: [[f64; 3]; 2],
    offset: [f64; 3],
) -> Result<Option<EarthPlace>, TilesError> {
    let Some(epsg) = georeference.get("epsg").and_then(Value::as_u64) else { return Ok(None) };
    let unknown = || TilesError::CoordinateSystem { epsg };
    let pair = |name: &str| {
        let list = georeference.get(name)?.as_array()?;
        Some([list.first()?.as_f64()?, list.get(1)?.as_f64()?])
    };
    let origin = pair("origin").ok_or_else(unknown)?;
    let ratio = pair("sample_step").zip(pair("mesh_step"));
    let scale = ratio.map_or([1.0; 2], |(sample, mesh)| [0, 1].map(|a| sample[a] / mesh[a]));
    let code = u16::try_from(epsg).map_err(|_| unknown())?;
    let system = Proj::from_epsg_code(code).map_err(|_| unknown())?;
    let wgs84 = Proj::from_epsg_code(4326).map_err(|_| unknown())?;
    let map = Map { system, wgs84, origin, scale };
    let at = |point: [f64; 3]| map.place(point).ok_or(TilesError::OffTheMap { epsg });
    let center = [0, 1, 2].map(|a| 0.5 * (min[a] + max[a]));
    let middle = at(center)?;
    // A thousandth of the mesh is short enough for its map to be linear, and long enough for doubles.
    let width = (max[0] - min[0]).max(max[1] - min[1]);
    let length = if width > 0.0 { 1e-3 * width } else { 1.0 };
    let mut matrix = [0.0; 16];
    for axis in 0..3 {
        let moved = |by: f64| {
            let mut point = center;
            point[axis] += by;
            at(point)
        };
        let (before, after) = (moved(-length)?, moved(length)?);
        (0..3).for_each(|i| matrix[4 * axis + i] = (after[i] - before[i]) / (2.0 * length));
    }
    (0..3).for_each(|i| {
        let moved: f64 = (0..3).map(|axis| matrix[4 * axis + i] * (offset[axis] - center[axis])).sum();
        matrix[12 + i] = middle[i] + moved;
    });
    matrix[15] = 1.0;
    let mut error = 0.0f64;
    for [x, y] in [[min[0], min[1]], [min[0], max[1]], [max[0], min[1]], [max[0], max[1]]] {
        let corner = [x, y, center[2]];
        let (truth, drawn) = (at(corner)?, applied(&matrix, [0, 1, 2].map(|a| corner[a] - offset[a])));
        error = error.max((0..3).map(|i| (truth[i] - drawn[i]).powi(2)).sum::<f64>().sqrt());
    }
    Ok(Some(EarthPlace { matrix, epsg: epsg as u32, error }))
}

/// A point after a transform.
fn applied(matrix: &Matrix, point: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| matrix[12 + i] + (0..3).map(|axis| matrix[4 * axis + i] * point[axis]).sum::<f64>())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// Distance of a transformed point from longitude, latitude (degrees) and height.
    fn distance(place: &EarthPlace, point: [f64; 3], [longitude, latitude, height]: [f64; 3]) -> f64 {
        let truth = earth_centered([longitude.to_radians(), latitude.to_radians(), height]);
        let found = applied(&place.matrix, point);
        (0..3).map(|i| (truth[i] - found[i]).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn ellipsoid() {
        let near = |a: [f64; 3], b: [f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-6);
        assert!(near(earth_centered([0.0, 0.0, 10.0]), [EQUATOR + 10.0, 0.0, 0.0]));
        let pole = earth_centered([0.0, std::f64::consts::FRAC_PI_2, 0.0]);
        assert!(near(pole, [0.0, 0.0, 6_356_752.314_245]), "{pole:?}");
    }

    #[test]
    fn degrees() {
        let georeference = json!({
            "origin": [-118.0, 34.0], "sample_step": [0.001, 0.001], "mesh_step": [92.0, 111.0], "epsg": 4326,
        });
        let place =
            place(&georeference, [[0.0; 3], [920.0, 1110.0, 50.0]], [92.0, 0.0, 7.0]).unwrap().unwrap();
        assert!(distance(&place, [368.0, 555.0, 93.0], [-117.995, 34.005, 100.0]) < 0.2);
        assert!(place.error < 0.2, "{}", place.error);
        assert_eq!(place.epsg, 4326);
    }

    #[test]
    fn universal_transverse_mercator() {
        // On its central meridian, the zone has the scale .9996 and its northing is the length of the meridian.
        let georeference = json!({ "origin": [500_000.0, 0.0], "epsg": 32633 });
        let place =
            place(&georeference, [[-50.0, -50.0, 0.0], [50.0, 50.0, 0.0]], [0.0; 3]).unwrap().unwrap();
        assert!(distance(&place, [0.0, 0.0, 100.0], [15.0, 0.0, 100.0]) < 1e-3);
        let east = [0, 1, 2].map(|i| place.matrix[i]);
        let length = east.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((length - 1.0 / 0.9996).abs() < 1e-6, "{length}");
        let up = [8, 9, 10].map(|i| place.matrix[i]);
        assert!((up.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-6);
    }

    #[test]
    fn unknown_systems_are_refused() {
        let at = |epsg: Value| place(&json!({ "origin": [0.0, 0.0], "epsg": epsg }), [[0.0; 3]; 2], [0.0; 3]);
        assert!(matches!(at(json!(70_000)), Err(TilesError::CoordinateSystem { epsg: 70_000 })));
        assert!(matches!(at(json!(1)), Err(TilesError::CoordinateSystem { epsg: 1 })));
        assert!(at(Value::Null).unwrap().is_none());
    }
}
