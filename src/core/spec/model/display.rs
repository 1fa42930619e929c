//! The model as text, printed by `mavc emit model`.

mod after_fault;

use std::f64::consts::PI;
use std::fmt;

use super::CaptureHeight;
use super::GiveUpYaw;
use super::Heading;
use super::{
    AfterFault, Air, Attitude, Campaign, Description, Detection, FaultMode, FlownVehicle, Limit, LostYaw, Mission,
    MissionTime, Model, Origin, PlanRotors, PlanSettings, RotorState, STANDARD_DENSITY, Simulation, Spin, Spread,
    Vehicle,
};
use crate::number::{fixed, number};

/// Degrees of an angle in radians.
fn degrees(angle: f64) -> String {
    number(angle * 180.0 / PI)
}

fn list(values: &[f64]) -> String {
    let shown: Vec<String> = values.iter().map(|x| number(*x)).collect();
    format!("[{}]", shown.join(", "))
}

/// A drag: one number if it is the same along all axes of the body, otherwise a list.
fn along_axes(drag: &[f64; 3]) -> String {
    match drag.iter().all(|d| *d == drag[0]) {
        true => number(drag[0]),
        false => list(drag),
    }
}

/// Coordinates, with rounding errors below 1 nm shown as zero.
fn place(position: &[f64; 3]) -> String {
    list(&position.map(|x| if x.abs() < 1e-9 { 0.0 } else { x }))
}

/// Lengths in m, masses in kg, times in s, angles in deg, rotor speeds in rad/s.
impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "gravity {} m/s^2", number(self.gravity))?;
        vehicle(f, &self.vehicle)?;
        if !self.modes.is_empty() {
            writeln!(f, "fault modes")?;
            self.modes.iter().try_for_each(|m| mode(f, m, self))?;
        }
        if let Some(m) = &self.mission {
            mission(f, m)?;
        }
        plan(f, &self.plan, &self.modes)?;
        after_fault::settings(f, self)?;
        if self.simulation.written {
            simulation(f, &self.simulation, &self.modes)?;
        }
        if self.campaign.written {
            campaign(f, &self.campaign)?;
        }
        if !self.defaults.is_empty() {
            writeln!(f, "defaults")?;
        }
        for d in &self.defaults {
            writeln!(f, "  {} = {} ({})", d.field, d.value, d.reason)?;
        }
        Ok(())
    }
}

fn doc(f: &mut fmt::Formatter<'_>, text: &Option<String>) -> fmt::Result {
    text.iter().flat_map(|text| text.lines()).try_for_each(|line| writeln!(f, "  /// {line}"))
}

fn vehicle(f: &mut fmt::Formatter<'_>, v: &Vehicle) -> fmt::Result {
    writeln!(f, "vehicle {}", v.name)?;
    doc(f, &v.doc)?;
    if let Some(layout) = &v.layout {
        writeln!(f, "  layout {layout}")?;
    }
    writeln!(f, "  mass {} kg{}", number(v.mass), interval_of(v.mass_spread))?;
    writeln!(f, "  inertia {} kg*m^2", list(&v.inertia))?;
    for (what, length) in [("propeller_radius", v.propeller_radius), ("size", v.size)] {
        if let Some(length) = length {
            writeln!(f, "  {what} {} m", number(length))?;
        }
    }
    if v.drag != [0.0; 3] {
        writeln!(f, "  drag {} N*s/m{}", along_axes(&v.drag), interval_of(v.drag_spread))?;
    }
    if let Some(centre) = &v.centre_of_gravity {
        writeln!(f, "  centre_of_gravity {} m from the frame's origin; places below are from it", place(centre))?;
    }
    if let Some(drag) = &v.yaw_drag {
        write!(f, "  yaw_drag {} N*m*s/rad{}", number(drag.linear), interval_of(drag.spread))?;
        match drag.quadratic > 0.0 {
            true => writeln!(f, ", yaw_drag_quadratic {} N*m*s^2/rad^2", number(drag.quadratic))?,
            false => writeln!(f)?,
        }
    }
    writeln!(f, "  allocation {}", v.allocation.name())?;
    if let Some(b) = &v.battery {
        write!(
            f,
            "  battery {} A*h, {} V, hover_power {} W",
            number(b.capacity / 3600.0),
            number(b.voltage),
            number(b.hover_power)
        )?;
        write!(f, ", keep {} %", number(b.keep * 100.0))?;
        match b.thrust_at_empty < 1.0 {
            true => writeln!(
                f,
                ", thrust_at_empty {} %; full speeds below are those at `keep`",
                number(b.thrust_at_empty * 100.0)
            )?,
            false => writeln!(f)?,
        }
    }
    for (k, r) in v.rotors.iter().enumerate() {
        let spin = if r.spin == Spin::P { "P" } else { "N" };
        write!(
            f,
            "  rotor {:>2} {spin} at {} m, b {} N*s^2/rad^2, d {} N*m*s^2/rad^2, up to {} rad/s, {} N",
            k + 1,
            place(&r.position),
            number(r.thrust_coefficient),
            number(r.drag_coefficient),
            number(r.max_speed),
            number(r.max_thrust())
        )?;
        if r.min_speed != 0.0 {
            write!(f, ", from {} rad/s", number(r.min_speed))?;
        }
        let s = &r.spread;
        for (what, spread) in [("N", s.full_thrust), ("idle N", s.idle_thrust), ("d/b", s.torque_per_thrust)] {
            if !spread.is_none() && (what != "idle N" || r.min_speed > 0.0) {
                write!(f, ", {what}{}", interval_of(spread))?;
            }
        }
        if let Some(time) = r.time_constant {
            write!(f, ", time constant {} s", number(time))?;
        }
        if let Some(motor) = r.motor {
            write!(f, ", motor {motor}")?;
        }
        match r.inertia > 0.0 {
            true => writeln!(f, ", rotor_inertia {} kg*m^2{}", number(r.inertia), interval_of(r.inertia_spread))?,
            false => writeln!(f)?,
        }
    }
    Ok(())
}

/// ` times 0.97 to 1.03`, or nothing for a value known exactly.
fn interval_of(spread: Spread) -> String {
    match spread.is_none() {
        true => String::new(),
        false => format!(" times {} to {}", number(spread.low), number(spread.high)),
    }
}

fn mode(f: &mut fmt::Formatter<'_>, m: &FaultMode, model: &Model) -> fmt::Result {
    write!(f, "  {}", m.name)?;
    if let Some(title) = &m.title {
        write!(f, " \"{title}\"")?;
    }
    write!(f, ":")?;
    let mut first = true;
    for (k, rotor) in (1..).zip(&m.rotors) {
        let what = match *rotor {
            RotorState::Sound => continue,
            RotorState::Reduced(theta) => format!("at {} %", number(theta * 100.0)),
            RotorState::Stuck(at) => format!("stuck at {} %", number(at * 100.0)),
            RotorState::Lost => "lost".into(),
        };
        write!(f, "{} rotor {k} {what}", if first { "" } else { "," })?;
        first = false;
    }
    let numbers = [("severity", m.severity), ("occurrence", m.occurrence), ("detection", m.detection)];
    for (name, value) in numbers {
        if let Some(value) = value {
            write!(f, ", {name} {value}")?;
        }
    }
    if let Some(rpn) = m.rpn() {
        write!(f, ", rpn {rpn}")?;
    }
    if let Some(rate) = m.rate {
        write!(f, ", rate {} 1/h{}", number(rate * 3600.0), interval_of(m.rate_spread))?;
    }
    if let Some(then) = m.after_fault {
        write!(f, ", after_fault {}", then.name())?;
    }
    if let Some(yaw) = m.without_yaw {
        write!(f, ", without_yaw {}", yaw.name())?;
    }
    if let Some(ways) = &m.recovery {
        write!(f, ", recovery {}", after_fault::order(ways, model))?;
    }
    writeln!(f)?;
    m.doc.iter().flat_map(|text| text.lines()).try_for_each(|line| writeln!(f, "    /// {line}"))
}

fn mission(f: &mut fmt::Formatter<'_>, m: &Mission) -> fmt::Result {
    writeln!(f, "mission {}", m.name)?;
    doc(f, &m.doc)?;
    let state = |rest: bool| if rest { "at rest" } else { "moving" };
    writeln!(f, "  starts {}, ends {}", state(m.start_at_rest), state(m.end_at_rest))?;
    for (i, w) in m.waypoints.iter().enumerate() {
        write!(f, "  waypoint {}", i + 1)?;
        if let Some(name) = &w.name {
            write!(f, " {name}")?;
        }
        write!(
            f,
            " at {} m, yaw {} deg, within {} m and {} deg, weight {}",
            place(&w.position),
            degrees(w.yaw),
            number(w.within),
            degrees(w.yaw_within),
            number(w.weight)
        )?;
        if let Some(time) = w.time {
            write!(f, ", time {} s", number(time))?;
        }
        if w.hold > 0.0 {
            write!(f, ", hold {} s", number(w.hold))?;
        }
        if w.stop {
            write!(f, ", stop")?;
        }
        match w.heading {
            Heading::Given => {}
            Heading::Towards([x, y]) => write!(f, ", yaw towards [{}, {}] m", number(x), number(y))?,
            Heading::AlongPath => write!(f, ", yaw along path")?,
            Heading::Free => write!(f, ", yaw free")?,
        }
        writeln!(f)?;
        if let Some(leg) = m.legs.get(i) {
            writeln!(f, "  leg {} has a share of {}", i + 1, number(leg.share))?;
        }
    }
    m.limits.iter().try_for_each(|l| match &l.leg {
        Some(on) => writeln!(f, "  limit on leg {}: {l}", on.leg + 1),
        None => writeln!(f, "  limit {l}"),
    })?;
    let Air { wind, wind_spread, gusts, density_ratio, .. } = &m.air;
    if wind.iter().chain(wind_spread).any(|v| *v != 0.0) {
        writeln!(f, "  wind {} +- {} m/s", list(wind), list(wind_spread))?;
    }
    if *gusts > 0.0 {
        writeln!(f, "  gusts {} m/s", number(*gusts))?;
    }
    if let Some(ground) = m.ground {
        writeln!(f, "  ground {} m", number(ground))?;
    }
    if let Some(Origin { latitude, longitude, altitude }) = m.origin {
        let [north, east] = [latitude, longitude].map(|angle| fixed(angle.to_degrees(), 7));
        writeln!(f, "  origin at latitude {north} deg, longitude {east} deg, altitude {} m", number(altitude))?;
    }
    if *density_ratio != 1.0 {
        writeln!(f, "  density {} kg/m^3", number(density_ratio * STANDARD_DENSITY))?;
    }
    after_fault::rules(f, &m.after_fault)
}

/// The limit in the words of a spec: `speed <= 8 m/s`.
impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Description { word: name, unit, unit_in_si, .. } = self.kind.describe();
        let shown = |x: f64| if unit_in_si == 1.0 { number(x) } else { degrees(x) };
        if let Some(volume) = &self.volume {
            write!(f, "{}: ", volume.name)?;
        }
        match (self.lower, self.upper) {
            (Some(low), Some(high)) => write!(f, "{name} in {} .. {} {unit}", shown(low), shown(high)),
            (Some(low), None) => write!(f, "{name} >= {} {unit}", shown(low)),
            (None, Some(high)) => write!(f, "{name} <= {} {unit}", shown(high)),
            (None, None) => write!(f, "{name} without bounds"),
        }
    }
}

fn plan(f: &mut fmt::Formatter<'_>, p: &PlanSettings, modes: &[FaultMode]) -> fmt::Result {
    writeln!(f, "plan")?;
    writeln!(f, "  planner {}, model {}", p.planner.name(), p.model.name())?;
    if p.rotors != PlanRotors::Instant {
        writeln!(f, "  rotors {}", p.rotors.name())?;
    }
    if p.chooses_times {
        writeln!(f, "  timing optimal")?;
    }
    let names: Vec<&str> = p.against.iter().map(|&k| modes[k].name.as_str()).collect();
    writeln!(f, "  against [{}]", names.join(", "))?;
    match p.time {
        MissionTime::Minimum => writeln!(f, "  time minimum")?,
        MissionTime::Fixed(time) => writeln!(f, "  time {} s", number(time))?,
    }
    writeln!(f, "  samples {}", p.samples)?;
    if p.rounds != 1 {
        writeln!(f, "  rounds {}", p.rounds)?;
    }
    if let Some(bound) = p.require_risk {
        writeln!(f, "  risk at most {}", number(bound))?;
    }
    if let Some(CaptureHeight { radius, delay, .. }) = p.require_capture {
        writeln!(f, "  capture height beyond {} m, {} s after a fault", number(radius), number(delay))?;
    }
    if p.after_fault != AfterFault::Continue {
        writeln!(f, "  after_fault {}", p.after_fault.name())?;
    }
    if p.without_yaw != GiveUpYaw::default() {
        writeln!(f, "  without_yaw {}", p.without_yaw.name())?;
    }
    writeln!(f, "  reserve {} %", number(p.reserve * 100.0))?;
    writeln!(f, "  snap {}, acceleration {}", number(p.snap_weight), number(p.acceleration_weight))
}

fn simulation(f: &mut fmt::Formatter<'_>, s: &Simulation, modes: &[FaultMode]) -> fmt::Result {
    writeln!(f, "simulate")?;
    match s.duration {
        Some(duration) => writeln!(f, "  duration {} s", number(duration))?,
        None => writeln!(f, "  duration that of the plan")?,
    }
    let [rate, control, estimator] = [s.rate, s.control_rate, s.estimator_rate].map(number);
    writeln!(f, "  rate {rate} Hz, control_rate {control} Hz, estimator_rate {estimator} Hz")?;
    writeln!(f, "  controller {}", s.controller.name())?;
    match s.detection {
        Detection::Never => write!(f, "  detection never")?,
        Detection::Estimator => write!(f, "  detection estimator")?,
        Detection::After(delay) => write!(f, "  detection {} s", number(delay))?,
    }
    writeln!(f, ", after_fault {}", s.after_fault.name())?;
    let g = &s.gains;
    for (name, gain, rate_name, rate_gain) in [
        ("position", g.position, "velocity", g.velocity),
        ("altitude", g.altitude, "climb", g.climb),
        ("attitude", g.attitude, "attitude_rate", g.attitude_rate),
        ("yaw", g.yaw, "yaw_rate", g.yaw_rate),
    ] {
        let (gain, rate_gain) = (number(gain), number(rate_gain));
        writeln!(f, "  {name}_gain {gain} 1/s^2, {rate_name}_gain {rate_gain} 1/s")?;
    }
    writeln!(f, "  forgetting {}, seed {}", number(s.forgetting), s.seed)?;
    let (gyroscope, position) = (number(s.gyroscope_noise), number(s.position_noise));
    writeln!(f, "  gyroscope_noise {gyroscope} rad/s, position_noise {position} m")?;
    if s.threshold != Simulation::default().threshold {
        writeln!(f, "  threshold {}", number(s.threshold))?;
    }
    if let Some(assumed) = s.assumed_gyroscope_noise {
        writeln!(f, "  assumed_gyroscope_noise {} rad/s", number(assumed))?;
    }
    if s.attitude != Attitude::Exact {
        writeln!(f, "  attitude {}", s.attitude.name())?;
    }
    if s.gyroscope_range != Simulation::default().gyroscope_range {
        writeln!(f, "  gyroscope_range {} deg/s", degrees(s.gyroscope_range))?;
    }
    writeln!(f, "  drag {} N*s/m, wind {} m/s", along_axes(&s.drag), list(&s.wind))?;
    writeln!(f, "  gusts {} m/s, gust_length {} m", number(s.gusts), number(s.gust_length))?;
    if s.torque_gusts > 0.0 {
        writeln!(f, "  torque_gusts {} N*m", number(s.torque_gusts))?;
    }
    if s.spread != FlownVehicle::Middle || s.centre_offset > 0.0 {
        writeln!(f, "  spread {}, centre_offset {} m", s.spread.name(), number(s.centre_offset))?;
    }
    writeln!(f, "  lost_beyond {} m, upside_down {} s", number(s.lost_beyond), number(s.upside_down))?;
    match s.lost_yaw {
        LostYaw::Beyond(angle) => write!(f, "  lost_yaw {} deg", degrees(angle))?,
        LostYaw::Off => write!(f, "  lost_yaw off")?,
    }
    writeln!(f, ", lost_yaw_after {} s", number(s.lost_yaw_after))?;
    writeln!(f, "  ground {} m", number(s.ground))?;
    for fault in &s.faults {
        write!(f, "  fault {} at {} s", modes[fault.mode].name, number(fault.at))?;
        match fault.until {
            Some(until) => writeln!(f, " until {} s", number(until))?,
            None => writeln!(f)?,
        }
    }
    Ok(())
}

fn campaign(f: &mut fmt::Formatter<'_>, c: &Campaign) -> fmt::Result {
    writeln!(f, "campaign")?;
    writeln!(f, "  times {}, seeds {}, seed {}", c.times, c.seeds, c.seed)?;
    let names: Vec<&str> = c.planners.iter().map(|p| p.name()).collect();
    writeln!(f, "  planners [{}]", names.join(", "))
}
