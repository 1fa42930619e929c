//! The place of a mission's origin on the Earth.

/// A point on the Earth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Origin {
    /// rad, north positive; on the ellipsoid WGS 84.
    pub latitude: f64,
    /// rad, east positive.
    pub longitude: f64,
    /// Height above mean sea level, m.
    pub altitude: f64,
}
