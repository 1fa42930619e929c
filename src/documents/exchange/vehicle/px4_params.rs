//! A vehicle as parameters of PX4's control allocation, in the form that QGroundControl loads: vehicle, component,
//! name, value and type (6: 32-bit integer, 9: 32-bit float), separated by tabs. PX4's frame is forward, right, down;
//! see `crate::import::vehicle`.

use crate::model::{Spin, Vehicle};

/// The parameters of a vehicle. Motors follow each other by their numbers of the spec, or else as the rotors do. Values
/// are the nearest 32-bit floats in their shortest form.
pub fn text(vehicle: &Vehicle) -> String {
    let mut out = format!(
        "# Vehicle {}, for PX4's control allocation\n#\n# Vehicle-Id Component-Id Name Value Type\n",
        vehicle.name
    );
    let count = vehicle.rotors.len();
    out.push_str(&format!("1\t1\tCA_AIRFRAME\t0\t6\n1\t1\tCA_ROTOR_COUNT\t{count}\t6\n"));
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|k| vehicle.rotors[*k].motor);
    let mut reversible: u32 = 0;
    for (index, rotor) in order.into_iter().map(|k| &vehicle.rotors[k]).enumerate() {
        let [x, y, z] = rotor.position;
        let ratio = rotor.drag_coefficient / rotor.thrust_coefficient;
        let torque = if rotor.spin == Spin::P { ratio } else { -ratio };
        reversible |= u32::from(rotor.is_reversible()) << index;
        let values = [
            ("AX", 0.0),
            ("AY", 0.0),
            ("AZ", -1.0),
            ("CT", rotor.max_thrust()),
            ("KM", torque),
            ("PX", x),
            ("PY", -y),
            ("PZ", -z),
        ];
        for (key, value) in values {
            out.push_str(&format!("1\t1\tCA_ROTOR{index}_{key}\t{}\t9\n", single(value)));
        }
    }
    if reversible > 0 {
        out.push_str(&format!("1\t1\tCA_R_REV\t{reversible}\t6\n"));
    }
    out
}

/// The nearest 32-bit float, without the sign of a zero.
fn single(value: f64) -> f32 {
    if value == 0.0 { 0.0 } else { value as f32 }
}
