//! Tables 1 to 7 of the paper: residuals e_p of (31) as printed, N and N m.

/// One column group of one table: a vehicle and its faults.
pub struct Table {
    pub number: usize,
    pub title: &'static str,
    /// Under specs/vehicles.
    pub vehicle: &'static str,
    pub rows: &'static [Row],
}

/// A row as printed: the fault's rotors, e_p with all four components, and e_p without tau_z where it is printed.
pub struct Row {
    pub rotors: &'static [usize],
    pub full: [f64; 4],
    pub yaw_free: Option<[f64; 3]>,
}

const fn single(rotors: &'static [usize], full: [f64; 4]) -> Row {
    Row { rotors, full, yaw_free: None }
}

const fn double(rotors: &'static [usize], full: [f64; 4], yaw_free: [f64; 3]) -> Row {
    Row { rotors, full, yaw_free: Some(yaw_free) }
}

/// The zeros that most rows hold.
const NONE: [f64; 4] = [0.0; 4];
const NONE_3: [f64; 3] = [0.0; 3];

pub const TABLES: [Table; 9] = [
    Table {
        number: 1,
        title: "quadcopter, one rotor lost",
        vehicle: "quad_pnpn",
        rows: &[
            single(&[1], [0.0, -0.03, 0.0, 0.21]),
            single(&[2], [0.0, 0.0, 0.03, -0.21]),
            single(&[3], [0.0, 0.03, 0.0, 0.21]),
            single(&[4], [0.0, 0.0, -0.03, -0.21]),
        ],
    },
    Table {
        number: 2,
        title: "hexacopters, one rotor lost",
        vehicle: "hexa_pnpnpn",
        rows: &[
            single(&[1], NONE),
            single(&[2], NONE),
            single(&[3], NONE),
            single(&[4], NONE),
            single(&[5], NONE),
            single(&[6], NONE),
        ],
    },
    Table {
        number: 2,
        title: "hexacopters, one rotor lost",
        vehicle: "hexa_ppnnpn",
        rows: &[
            single(&[1], NONE),
            single(&[2], NONE),
            single(&[3], NONE),
            single(&[4], NONE),
            single(&[5], NONE),
            single(&[6], NONE),
        ],
    },
    Table {
        number: 3,
        title: "hexacopter, two rotors lost",
        vehicle: "hexa_pnpnpn",
        rows: &[
            double(&[1, 2], [0.0, -0.44, 0.25, 0.0], [0.0, -0.44, 0.25]),
            double(&[1, 3], [0.0, 0.0, 0.03, 0.13], NONE_3),
            double(&[1, 4], NONE, NONE_3),
            double(&[1, 5], [0.0, -0.2, 0.0, 0.12], NONE_3),
            double(&[1, 6], [0.0, -0.6, -0.3, 0.0], [0.0, -0.44, -0.25]),
            double(&[2, 3], [0.0, 0.0, 0.51, 0.0], [0.0, 0.5, 0.0]),
            double(&[2, 4], [0.0, 0.24, 0.42, -0.13], NONE_3),
            double(&[2, 5], NONE, NONE_3),
            double(&[2, 6], [0.0, -0.04, 0.0, -0.12], NONE_3),
            double(&[3, 4], [0.0, 0.64, 0.36, 0.0], [0.0, 0.44, 0.25]),
            double(&[3, 5], [0.0, 0.04, 0.0, 0.12], NONE_3),
            double(&[3, 6], NONE, NONE_3),
            double(&[4, 5], [0.0, 0.04, -0.25, 0.12], [0.0, 0.61, -0.35]),
            double(&[4, 6], [0.0, 0.02, -0.03, -0.12], NONE_3),
            double(&[5, 6], [0.0, 0.0, -0.5, 0.0], [0.0, 0.0, -0.51]),
        ],
    },
    Table {
        number: 4,
        title: "hexacopter, two rotors lost",
        vehicle: "hexa_ppnnpn",
        rows: &[
            double(&[1, 2], [0.0, -0.43, 0.27, 0.18], [0.0, -0.44, 0.25]),
            double(&[1, 3], NONE, NONE_3),
            double(&[1, 4], NONE, NONE_3),
            double(&[1, 5], [0.0, 0.0, -0.01, 0.07], NONE_3),
            double(&[1, 6], [0.0, -0.44, -0.25, -0.15], [0.0, -0.44, -0.25]),
            double(&[2, 3], [0.0, 0.0, 0.51, 0.0], [0.0, 0.0, 0.5]),
            double(&[2, 4], NONE, NONE_3),
            double(&[2, 5], [0.0, 0.0, 0.0, 0.04], NONE_3),
            double(&[2, 6], [0.0, 0.0, 0.0, -0.05], NONE_3),
            double(&[3, 4], [0.0, 0.43, 0.27, -0.02], [0.0, 0.44, 0.25]),
            double(&[3, 5], [0.0, 0.0, 0.0, 0.05], NONE_3),
            double(&[3, 6], [0.0, 0.0, 0.0, -0.05], NONE_3),
            double(&[4, 5], [0.0, 0.44, -0.25, 0.14], [0.0, 0.44, -0.25]),
            double(&[4, 6], [0.0, 0.0, 0.0, -0.08], NONE_3),
            double(&[5, 6], [0.0, -0.51, 0.0, 0.0], [0.0, 0.0, -0.51]),
        ],
    },
    Table {
        number: 5,
        title: "octocopters, one rotor lost",
        vehicle: "octo_pnpnpnpn",
        rows: &[
            single(&[1], NONE),
            single(&[2], NONE),
            single(&[3], NONE),
            single(&[4], NONE),
            single(&[5], NONE),
            single(&[6], NONE),
            single(&[7], NONE),
            single(&[8], NONE),
        ],
    },
    Table {
        number: 5,
        title: "octocopters, one rotor lost",
        vehicle: "octo_ppnnppnn",
        rows: &[
            single(&[1], NONE),
            single(&[2], NONE),
            single(&[3], NONE),
            single(&[4], NONE),
            single(&[5], NONE),
            single(&[6], NONE),
            single(&[7], NONE),
            single(&[8], NONE),
        ],
    },
    Table {
        number: 6,
        title: "octocopter, two rotors lost",
        vehicle: "octo_pnpnpnpn",
        rows: &[
            double(&[1, 2], NONE, NONE_3),
            double(&[1, 3], [0.0, 0.0, 0.0, 0.01], NONE_3),
            double(&[1, 4], NONE, NONE_3),
            double(&[1, 5], NONE, NONE_3),
            double(&[1, 6], NONE, NONE_3),
            double(&[1, 7], [0.0, 0.0, 0.0, 0.01], NONE_3),
            double(&[1, 8], NONE, NONE_3),
            double(&[2, 3], NONE, NONE_3),
            double(&[2, 4], [0.0, 0.0, 0.0, -0.01], NONE_3),
            double(&[2, 5], NONE, NONE_3),
            double(&[2, 6], NONE, NONE_3),
            double(&[2, 7], NONE, NONE_3),
            double(&[2, 8], [0.0, 0.0, 0.0, 0.01], NONE_3),
            double(&[3, 4], NONE, NONE_3),
            double(&[3, 5], [0.0, 0.0, 0.0, 0.01], NONE_3),
            double(&[3, 6], NONE, NONE_3),
            double(&[3, 7], NONE, NONE_3),
            double(&[3, 8], NONE, NONE_3),
            double(&[4, 5], NONE, NONE_3),
            double(&[4, 6], [0.0, 0.0, 0.0, -0.01], NONE_3),
            double(&[4, 7], NONE, NONE_3),
            double(&[4, 8], NONE, NONE_3),
            double(&[5, 6], NONE, NONE_3),
            double(&[5, 7], [0.0, 0.0, 0.0, 0.01], NONE_3),
            double(&[5, 8], NONE, NONE_3),
            double(&[6, 7], NONE, NONE_3),
            double(&[6, 8], [0.0, 0.0, 0.0, -0.01], NONE_3),
            double(&[7, 8], NONE, NONE_3),
        ],
    },
    Table {
        number: 7,
        title: "octocopter, two rotors lost",
        vehicle: "octo_ppnnppnn",
        rows: &[
            double(&[1, 2], [0.0, 0.0, 0.0, 0.13], NONE_3),
            double(&[1, 3], NONE, NONE_3),
            double(&[1, 4], NONE, NONE_3),
            double(&[1, 5], NONE, NONE_3),
            double(&[1, 6], NONE, NONE_3),
            double(&[1, 7], NONE, NONE_3),
            double(&[1, 8], NONE, NONE_3),
            double(&[2, 3], NONE, NONE_3),
            double(&[2, 4], NONE, NONE_3),
            double(&[2, 5], NONE, NONE_3),
            double(&[2, 6], NONE, NONE_3),
            double(&[2, 7], NONE, NONE_3),
            double(&[2, 8], NONE, NONE_3),
            double(&[3, 4], [0.0, 0.01, 0.02, -0.13], NONE_3),
            double(&[3, 5], NONE, NONE_3),
            double(&[3, 6], NONE, NONE_3),
            double(&[3, 7], NONE, NONE_3),
            double(&[3, 8], NONE, NONE_3),
            double(&[4, 5], NONE, NONE_3),
            double(&[4, 6], NONE, NONE_3),
            double(&[4, 7], NONE, NONE_3),
            double(&[4, 8], NONE, NONE_3),
            double(&[5, 6], [0.0, 0.02, -0.01, 0.13], NONE_3),
            double(&[5, 7], NONE, NONE_3),
            double(&[5, 8], NONE, NONE_3),
            double(&[6, 7], NONE, NONE_3),
            double(&[6, 8], NONE, NONE_3),
            double(&[7, 8], [0.0, -0.01, -0.03, -0.13], NONE_3),
        ],
    },
];
