//! Tables 8 to 13 of the paper as printed.

/// A row of Tables 8, 10 and 12: shortest time and waypoint errors.
pub struct Own {
    pub planner: &'static str,
    /// s
    pub time: f64,
    /// e_R of (49), m, and e_R/N.
    pub position: [f64; 2],
    /// e_psi of (50), rad, and e_psi/N.
    pub yaw: [f64; 2],
}

const fn own(planner: &'static str, time: f64, position: [f64; 2], yaw: [f64; 2]) -> Own {
    Own { planner, time, position, yaw }
}

pub const TABLE_8: [Own; 2] =
    [own("RIP", 16.0, [0.0412, 0.0019], [4e-12, 4e-13]), own("RCP M1", 20.0, [0.0566, 0.0027], [1e-18, 5e-21])];

pub const TABLE_10: [Own; 3] = [
    own("RIP", 16.0, [0.0412, 0.0019], [4e-12, 2e-13]),
    own("RCP M1_6", 26.0, [0.286, 0.014], [2e-17, 1e-19]),
    own("RSP", 18.0, [0.234, 0.011], [1.2e-9, 6e-11]),
];

pub const TABLE_12: [Own; 10] = [
    own("RIP", 16.0, [0.0412, 0.0019], [4e-12, 4e-13]),
    own("RCP M1", 20.0, [0.057, 0.0027], [1e-18, 5e-21]),
    own("RCP M2", 20.0, [0.038, 0.018], [4e-18, 2e-19]),
    own("RCP M3", 20.0, [0.038, 0.018], [7e-12, 3.4e-13]),
    own("RCP M4", 28.0, [0.5, 0.0238], [1.4e-8, 6.9e-10]),
    own("RCP M5", 24.0, [0.26, 0.012], [0.0012, 5.9e-4]),
    own("RCP M6", 24.0, [0.43, 0.021], [9e-12, 4.4e-13]),
    own("RCP M7", 20.0, [0.073, 0.0035], [1.5e-10, 7.4e-12]),
    own("RCP M8", 20.0, [0.038, 0.018], [7e-12, 3.4e-13]),
    own("RSP", 28.0, [0.54, 0.025], [7e-6, 3.5e-7]),
];

/// A row of Tables 9 and 11: all planners at one time. Errors are printed in Table 9 alone.
pub struct Common {
    pub planner: &'static str,
    /// s
    pub time: f64,
    /// e_R, m, and e_psi, rad.
    pub errors: Option<[f64; 2]>,
    /// "Violated constraints".
    pub violated: usize,
}

const fn common(planner: &'static str, time: f64, errors: Option<[f64; 2]>, violated: usize) -> Common {
    Common { planner, time, errors, violated }
}

pub const TABLE_9: [Common; 3] = [
    common("RIP", 20.0, Some([0.038, 5e-19]), 51),
    common("RCP M1", 20.0, Some([0.057, 1e-18]), 0),
    common("RSP", 20.0, Some([0.038, 1.25e-18]), 1),
];

pub const TABLE_11: [Common; 3] =
    [common("RIP", 26.0, None, 80), common("RCP M1_6", 26.0, None, 0), common("RSP", 26.0, None, 21)];

/// Violated constraints of the sets M1 to M8, planner by planner, at 28 s.
pub const TABLE_13: [(&str, [usize; 8]); 10] = [
    ("RIP", [52, 0, 108, 206, 0, 108, 24, 136]),
    ("RCP M1", [0, 0, 107, 179, 0, 89, 20, 116]),
    ("RCP M2", [52, 0, 110, 205, 0, 108, 24, 136]),
    ("RCP M3", [53, 0, 0, 185, 0, 87, 23, 137]),
    ("RCP M4", [52, 0, 99, 0, 0, 99, 24, 136]),
    ("RCP M5", [52, 0, 101, 197, 0, 99, 24, 136]),
    ("RCP M6", [52, 0, 101, 197, 0, 0, 24, 136]),
    ("RCP M7", [52, 0, 101, 191, 0, 95, 0, 134]),
    ("RCP M8", [52, 0, 108, 197, 0, 108, 24, 0]),
    ("RSP", [0, 0, 118, 15, 0, 5, 0, 0]),
];

/// Waypoints along the curve (section 5.4).
pub const WAYPOINTS: usize = 21;

/// All times of Tables 8, 10 and 12, s.
pub fn own_times() -> impl Iterator<Item = f64> {
    TABLE_8.iter().chain(&TABLE_10).chain(&TABLE_12).map(|row| row.time)
}

/// Violations as section 5.4 puts them in words.
pub struct Told {
    pub times: usize,
    pub positions: usize,
}

/// Case 1, the RIP plan at 20 s: two of 440 inequalities, at positions "out of possible 210".
pub const CASE_1_RIP: Told = Told { times: 111, positions: 99 };
/// Case 2 at 26 s.
pub const CASE_2_RIP: Told = Told { times: 80, positions: 73 };
pub const CASE_2_RSP: Told = Told { times: 21, positions: 21 };
