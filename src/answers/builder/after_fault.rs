//! What a built spec says of the time after a fault.

use super::{BuildCode, Builder, Named, Value};
use crate::language::Group;

impl Builder {
    /// Adds a landing site, where a damaged vehicle may touch down within `radius` (m) of `at` (m); its height is that
    /// of the ground there. The mission needs a `ground` ([`Builder::mission`]).
    ///
    /// ```
    /// use mavc::builder::Builder;
    ///
    /// let spec = Builder::new()
    ///     .vehicle("layout", "PPNNPN")
    ///     .vehicle("arm", 0.3)
    ///     .vehicle("mass", 2.0)
    ///     .vehicle("inertia", [0.03, 0.03, 0.05])
    ///     .vehicle("size", 0.5)
    ///     .rotor("max_thrust", 9.0)
    ///     .rotor("torque_per_thrust", 0.016)
    ///     .rotor("max_speed", 900.0)
    ///     .lost("M1", &[1])
    ///     .mode("M1", "recovery", ["continue", "pad"])
    ///     .mission("ground", 0.0)
    ///     .mission("buffer", 5.0)
    ///     .waypoint([0.0, 0.0, 2.0])
    ///     .waypoint([20.0, 0.0, 10.0])
    ///     .landing_site("pad", [12.0, -8.0, 0.0], 2.0)
    ///     .keep_off("street", "box")
    ///     .area("street", "from", [0.0, 5.0, 0.0])
    ///     .area("street", "to", [40.0, 11.0, 0.0])
    ///     .after_fault_at_most("descent", 2.0)
    ///     .recovery("within", 20.0)
    ///     .build()?;
    /// assert_eq!(spec.model().mission.as_ref().unwrap().after_fault.sites.len(), 1);
    /// # Ok::<(), mavc::builder::BuildError>(())
    /// ```
    pub fn landing_site(mut self, name: &str, at: [f64; 3], radius: f64) -> Self {
        let path = format!("mission.landing_sites.{name}");
        self.name(&path, name);
        let fields = [("at", Value::from(at)), ("radius", Value::from(radius))];
        let fields =
            fields.map(|(field, value)| self.field(Group::LandingSite, &format!("{path}."), field, value, " = "));
        self.places.push(Named { path, keyword: "landing_site", name: name.into(), fields: fields.into() });
        self
    }

    /// Adds an area where no damaged vehicle lands, of the shape `box`, `cylinder` or `polygon`; its fields are set by
    /// [`Builder::area`].
    pub fn keep_off(mut self, name: &str, shape: &str) -> Self {
        let path = format!("mission.keep_off.{name}");
        self.name(&path, name);
        let shape = self.field(Group::KeepOff, &format!("{path}."), "shape", shape.into(), " = ");
        self.places.push(Named { path, keyword: "keep_off", name: name.into(), fields: vec![shape] });
        self
    }

    /// Sets a field of an area that was added before, such as `radius` (m); of three coordinates the height does not
    /// matter.
    pub fn area(mut self, area: &str, field: &str, value: impl Into<Value>) -> Self {
        let path = format!("mission.keep_off.{area}.");
        let line = self.field(Group::KeepOff, &path, field, value.into(), " = ");
        match self.places.iter_mut().rfind(|known| known.keyword == "keep_off" && known.name == area) {
            Some(known) => known.fields.push(line),
            None => {
                let message = format!("unknown area `{area}`");
                let help = "add it before its fields, by `keep_off`";
                self.problem(path.trim_end_matches('.'), BuildCode::UnknownVolume, message, Some(help.into()));
            }
        }
        self
    }

    /// Bounds a limit from above after a fault, such as `tilt` (rad), in place of the mission's.
    pub fn after_fault_at_most(mut self, limit: &str, bound: f64) -> Self {
        let line = self.limit_line(Group::AfterFaultLimits, limit, "<=", &[bound]);
        self.after_fault_limits.push(line);
        self
    }

    /// Sets a field of `recovery` in the plan, such as `order` (a list of words and names) or `within` (s).
    pub fn recovery(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Recovery, "plan.recovery.", field, value.into(), " = ");
        self.recovery.push(line);
        self
    }
}
