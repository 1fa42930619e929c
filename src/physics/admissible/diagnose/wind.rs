//! Modes that cannot hover because of the mission's wind.

use crate::admissible::verdict::{ModeAnalysis, analyze};
use crate::admissible::without_yaw::YawFree;
use crate::admissible::{AdmissibleSet, HEALTHY};
use crate::model::Model;
use crate::number::significant;

/// What lets a vehicle hover that the wind alone prevents from it.
pub(super) const HELP: &str = "check the units of `drag`, or lower it or the `wind` of the mission";

/// The label of a mode that would keep control in still air, or hover with yaw given up if it does not even do that in
/// the wind; `None` if the air is not the cause.
pub(super) fn is_the_cause(model: &Model, mode: &ModeAnalysis) -> Option<String> {
    let environment = model.environment();
    let speed = environment.wind.iter().map(|w| w * w).sum::<f64>().sqrt();
    if !environment.has_drag() || speed == 0.0 {
        return None;
    }
    let mut still = model.clone();
    still.vehicle.drag = [0.0; 3];
    let set = match still.modes.iter().position(|fault| fault.name == mode.name && mode.name != HEALTHY) {
        Some(index) => AdmissibleSet::of_mode(&still, index),
        None => AdmissibleSet::healthy(&still),
    };
    let found = analyze(&still, &set);
    let hovers_again = mode.yaw_free == YawFree::None && found.yaw_free != YawFree::None;
    (found.keeps_full_control() || hovers_again).then(|| {
        let most = model.vehicle.drag.into_iter().fold(0.0, f64::max);
        let up_to = if environment.is_isotropic() { "" } else { "up to " };
        format!(
            "in still air it can: a `drag` of {} N*s/m turns the mission's wind of {} m/s into {up_to}{} N",
            significant(most, 3),
            significant(speed, 3),
            significant(most * speed, 3)
        )
    })
}
