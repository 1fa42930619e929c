//! Figures of a vehicle that PX4's parameters hold beside its geometry. A parameter that has PX4's default was never
//! measured, and gives none.
//!
//! Sources: `src/lib/parameters` of PX4 1.15 and the modules that define them; of the vehicle model,
//! `vehicle_model_params.c`, of which airframes of Hardware-in-the-Loop have values.

use crate::import::vehicle::draft::{Field, Figure, battery};
use crate::import::vehicle::parameters::Parameters;

/// Parameters of moments of inertia about x, y and z.
const INERTIA: [&str; 3] = ["VM_INERTIA_XX", "VM_INERTIA_YY", "VM_INERTIA_ZZ"];
/// PX4's defaults: kg, kg m^2, share of full thrust.
const DEFAULT_MASS: f64 = 1.0;
const DEFAULT_INERTIA: f64 = 0.01;
const DEFAULT_HOVER: f64 = 0.5;
/// The simulated vehicle of PX4's simulator in hardware (`sih_params.c`): mass (kg), moments (kg m^2), full thrust (N)
/// and torque (N m) of a rotor, each with its default.
const SIMULATED: [(&str, f64); 6] = [
    ("SIH_MASS", 1.0),
    ("SIH_IXX", 0.025),
    ("SIH_IYY", 0.025),
    ("SIH_IZZ", 0.03),
    ("SIH_T_MAX", 5.0),
    ("SIH_Q_MAX", 0.1),
];
/// The nominal voltage of a cell of a lithium polymer battery, V.
const CELL: f64 = 3.7;

/// The figures, and the parameters that they are from.
#[derive(Default)]
pub struct Figures {
    /// kg
    pub mass: Option<f64>,
    /// kg m^2
    pub inertia: Option<[f64; 3]>,
    /// The share of full thrust with which the vehicle hovers.
    pub hover: Option<f64>,
    /// Full thrust of a rotor of a simulated vehicle, N, and its torque per thrust, m.
    pub thrust: Option<f64>,
    pub ratio: Option<f64>,
    /// Where mass and inertia are from.
    pub model: &'static str,
    /// The fields of `battery`.
    pub battery: Vec<Field>,
    pub used: Vec<&'static str>,
}

pub fn read(parameters: &Parameters) -> Figures {
    let value = |name: &str| parameters.get(name).map(|parameter| f64::from(parameter.value as f32));
    let unlike = |name: &str, default: f64| value(name).filter(|x| *x > 0.0 && (*x as f32) != default as f32);
    let mut found = Figures { model: "VM", ..Figures::default() };
    let inertia = INERTIA.map(|name| value(name).filter(|x| *x > 0.0));
    // All three are the default, or none was left at it by oversight.
    if let [Some(x), Some(y), Some(z)] = inertia
        && [x, y, z].iter().any(|moment| *moment as f32 != DEFAULT_INERTIA as f32)
    {
        found.inertia = Some([x, y, z]);
        found.used.extend(INERTIA);
    }
    found.mass = match value("VM_MASS") {
        // A kilogram beside measured inertias is a mass.
        Some(mass) if mass > 0.0 && found.inertia.is_some() => Some(mass),
        _ => unlike("VM_MASS", DEFAULT_MASS),
    };
    if found.mass.is_none() && found.inertia.is_none() {
        simulated(parameters, &mut found);
    }
    found.hover = unlike("MPC_THR_HOVER", DEFAULT_HOVER).filter(|share| *share < 1.0);
    found.used.extend(found.mass.filter(|_| found.model == "VM").map(|_| "VM_MASS"));
    found.used.extend(found.hover.map(|_| "MPC_THR_HOVER"));
    // -1 mAh and 0 cells are PX4's defaults for what nobody set.
    let capacity = value("BAT1_CAPACITY").filter(|x| *x > 0.0);
    let cells = value("BAT1_N_CELLS").filter(|x| *x >= 1.0);
    if let Some(capacity) = capacity {
        let voltage = cells.map(|cells| (CELL * cells, format!("{cells} cells of {CELL} V, BAT1_N_CELLS")));
        found.battery = battery(capacity, "BAT1_CAPACITY", voltage);
        found.used.push("BAT1_CAPACITY");
        found.used.extend(cells.map(|_| "BAT1_N_CELLS"));
    }
    found
}

/// The figures of the simulator's vehicle, if one of them is not the default: who sets one means them all.
fn simulated(parameters: &Parameters, found: &mut Figures) {
    let value =
        |name: &str| parameters.get(name).map(|parameter| f64::from(parameter.value as f32)).filter(|x| *x > 0.0);
    if SIMULATED.iter().all(|(name, default)| value(name).is_none_or(|x| x as f32 == *default as f32)) {
        return;
    }
    let [mass, x, y, z, thrust, torque] = SIMULATED.map(|(name, _)| value(name));
    found.model = "SIH";
    found.mass = mass;
    found.inertia = x.zip(y).zip(z).map(|((x, y), z)| [x, y, z]);
    found.thrust = thrust;
    found.ratio = torque.zip(thrust).map(|(torque, thrust)| torque / thrust);
    found.used.extend(SIMULATED.map(|(name, _)| name));
}

impl Figures {
    /// The field `mass`, by a `let` if full thrust follows from it, and that `let`.
    pub fn mass(&self) -> (Field, Option<Field>) {
        let figure = self.mass.map_or(Figure::Unknown, |mass| Figure::single(mass as f32, "kg"));
        let remark =
            |field: Field| if self.mass.is_some() { field.remark(format!("{}_MASS", self.model)) } else { field };
        match self.hover {
            Some(_) => (Field::new("mass", Figure::Known("mass".into())), Some(remark(Field::new("mass", figure)))),
            None => (remark(Field::new("mass", figure)), None),
        }
    }

    pub fn inertia(&self) -> Field {
        let Some([x, y, z]) = self.inertia.map(|moments| moments.map(|moment| moment as f32)) else {
            return Field::new("inertia", Figure::Unknown).remark("[Ixx, Iyy, Izz]");
        };
        Field::new("inertia", Figure::Known(format!("[{x}, {y}, {z}] kg*m^2"))).remark(if self.model == "VM" {
            "VM_INERTIA"
        } else {
            "SIH_IXX and so on"
        })
    }
}
