//! Places on the Earth and the local tangent plane: latitude, longitude and height against x east, y north, z up.
//!
//! The ellipsoid is that of WGS 84. Heights above mean sea level are taken as heights above the ellipsoid: the geoid is
//! up to 107 m off it, and 107 m change a distance by 107 m / 6,357 km, 17 mm in a kilometre.

/// Semi-major axis of the ellipsoid, m (NGA.STND.0036, World Geodetic System 1984, table 3.1).
const A: f64 = 6_378_137.0;
/// Flattening of the ellipsoid (the same table).
const F: f64 = 1.0 / 298.257_223_563;
/// Square of the first eccentricity, e^2 = f (2 - f).
const E2: f64 = F * (2.0 - F);

/// A place: latitude and longitude in rad, height in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geodetic {
    pub latitude: f64,
    pub longitude: f64,
    pub height: f64,
}

/// The tangent plane at a place: x east, y north, z up, in m from it.
#[derive(Debug, Clone, Copy)]
pub struct TangentPlane {
    origin: Geodetic,
    /// The origin, Earth-centred and Earth-fixed, m.
    centre: [f64; 3],
    /// Rows: east, north and up in Earth-fixed axes.
    axes: [[f64; 3]; 3],
}

impl Geodetic {
    /// Latitude and longitude in degrees, height in m.
    pub fn degrees(latitude: f64, longitude: f64, height: f64) -> Self {
        Geodetic { latitude: latitude.to_radians(), longitude: longitude.to_radians(), height }
    }

    /// Earth-centred and Earth-fixed, m. With the radius of curvature in the prime vertical N = a / sqrt(1 - e^2 sin^2
    /// phi): `X = (N + h) cos phi cos lambda`, `Y = (N + h) cos phi sin lambda`, `Z = (N (1 - e^2) + h) sin phi` (B.
    /// Hofmann-Wellenhof et al., GNSS, 2008, eq. 8.1 and 8.2).
    fn earth_fixed(&self) -> [f64; 3] {
        let (s, c) = self.latitude.sin_cos();
        let (sl, cl) = self.longitude.sin_cos();
        let n = A / (1.0 - E2 * s * s).sqrt();
        [(n + self.height) * c * cl, (n + self.height) * c * sl, (n * (1.0 - E2) + self.height) * s]
    }

    /// The inverse of [`Self::earth_fixed`]: `tan phi = (Z + e^2 N sin phi) / p` by fixed-point iteration, whose error
    /// falls by e^2, that is to 0.7 %, each time. The height is `p cos phi + Z sin phi - a sqrt(1 - e^2 sin^2 phi)`,
    /// which holds at the poles too.
    fn of_earth_fixed([x, y, z]: [f64; 3]) -> Self {
        /// 0.0067^9 is below the rounding of doubles.
        const STEPS: usize = 9;
        let p = x.hypot(y);
        let mut latitude = z.atan2(p * (1.0 - E2));
        for _ in 0..STEPS {
            let s = latitude.sin();
            latitude = (z + E2 * A / (1.0 - E2 * s * s).sqrt() * s).atan2(p);
        }
        let (s, c) = latitude.sin_cos();
        Geodetic { latitude, longitude: y.atan2(x), height: p * c + z * s - A * (1.0 - E2 * s * s).sqrt() }
    }
}

impl TangentPlane {
    pub fn at(origin: Geodetic) -> Self {
        let (s, c) = origin.latitude.sin_cos();
        let (sl, cl) = origin.longitude.sin_cos();
        let axes = [[-sl, cl, 0.0], [-s * cl, -s * sl, c], [c * cl, c * sl, s]];
        TangentPlane { origin, centre: origin.earth_fixed(), axes }
    }

    /// The place of `[0, 0, 0]`.
    pub fn origin(&self) -> Geodetic {
        self.origin
    }

    /// x east, y north, z up of a place, m.
    pub fn local(&self, place: &Geodetic) -> [f64; 3] {
        let there = place.earth_fixed();
        let from: [f64; 3] = std::array::from_fn(|i| there[i] - self.centre[i]);
        self.axes.map(|axis| (0..3).map(|i| axis[i] * from[i]).sum())
    }

    /// The place of a point, m.
    pub fn place(&self, p: [f64; 3]) -> Geodetic {
        let there =
            std::array::from_fn(|i| self.centre[i] + (0..3).map(|axis| self.axes[axis][i] * p[axis]).sum::<f64>());
        Geodetic::of_earth_fixed(there)
    }
}

/// The direction clockwise from north (deg, 0 up to 360) of a yaw (rad, counter-clockwise from east).
pub fn heading_of_yaw(yaw: f64) -> f64 {
    (90.0 - yaw.to_degrees()).rem_euclid(360.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_come_back_everywhere() {
        for latitude in [-90.0, -89.9999, -45.0, 0.0, 1e-9, 47.397742, 89.0, 90.0] {
            for longitude in [-180.0, -77.0, 0.0, 8.545594, 179.9] {
                for height in [-4000.0, 0.0, 488.0, 9000.0] {
                    let place = Geodetic::degrees(latitude, longitude, height);
                    let back = Geodetic::of_earth_fixed(place.earth_fixed());
                    assert!((back.latitude - place.latitude).abs() < 1e-14, "{place:?} {back:?}");
                    assert!((back.height - height).abs() < 3e-8, "{place:?} {back:?}");
                }
            }
        }
    }
}
