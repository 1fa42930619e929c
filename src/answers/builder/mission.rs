//! The mission of a built spec: waypoints, holds, limits and volumes.

use super::{BuildCode, Builder, Line, Named, Value, digits, unit, word};
use crate::language::Group;
use crate::model::VolumeSide;

impl Builder {
    /// Adds a waypoint (m; x east, y north, z up). The first is the start.
    pub fn waypoint(self, position: [f64; 3]) -> Self {
        self.waypoint_with(position, &[])
    }

    /// Adds a waypoint with clauses such as `yaw` (rad), `within` (m) and `time` (s).
    pub fn waypoint_with(mut self, position: [f64; 3], clauses: &[(&str, f64)]) -> Self {
        self.waypoints += 1;
        let path = format!("mission.waypoints[{}].", self.waypoints);
        let head = if self.waypoints == 1 { "start" } else { "waypoint" };
        let given = [("at", Value::from(position))].into_iter();
        let given = given.chain(clauses.iter().map(|(name, value)| (*name, Value::from(*value))));
        let line = self.clauses(Group::Waypoint, &path, head, given);
        self.mission.push(line);
        self
    }

    /// Holds at rest at the last waypoint, for a time in s.
    pub fn hold(mut self, seconds: f64) -> Self {
        let path = format!("mission.hold[{}]", self.waypoints);
        let before = self.problems.len();
        self.finite(&path, &[seconds]);
        let line = self.line(before, path, format!("hold {} s", digits(seconds)));
        self.mission.push(line);
        self
    }

    /// The mission does not start at rest.
    pub fn start_moving(mut self) -> Self {
        self.mission.push(Line::new("mission.start_moving", "start moving"));
        self
    }

    /// The mission does not end at rest.
    pub fn end_moving(mut self) -> Self {
        self.mission.push(Line::new("mission.end_moving", "end moving"));
        self
    }

    /// Bounds a limit from above, such as `speed` (m/s).
    pub fn at_most(self, limit: &str, bound: f64) -> Self {
        self.limit(limit, "<=", &[bound])
    }

    /// Bounds a limit from below, such as `altitude` (m).
    pub fn at_least(self, limit: &str, bound: f64) -> Self {
        self.limit(limit, ">=", &[bound])
    }

    /// Bounds a limit from both sides.
    pub fn between(self, limit: &str, low: f64, high: f64) -> Self {
        self.limit(limit, "in", &[low, high])
    }

    fn limit(mut self, limit: &str, form: &str, bounds: &[f64]) -> Self {
        let line = self.limit_line(Group::Limits, limit, form, bounds);
        self.limits.push(line);
        self
    }

    /// A limit of `group`, whose bounds are in SI units.
    pub(super) fn limit_line(&mut self, group: Group, limit: &str, form: &str, bounds: &[f64]) -> Line {
        let path = format!("{}{limit}", group.path().unwrap_or_default());
        let before = self.problems.len();
        let unit = self.entry(group, &path, limit).map_or(String::new(), unit);
        self.finite(&path, bounds);
        let bounds: Vec<String> = bounds.iter().map(|bound| format!("{}{unit}", digits(*bound))).collect();
        self.line(before, path, format!("{} {form} {}", word(limit), bounds.join(" .. ")))
    }

    /// Sets a field of the mission, such as `ground` or `buffer` (m).
    pub fn mission(mut self, field: &str, value: impl Into<Value>) -> Self {
        let line = self.field(Group::Mission, "mission.", field, value.into(), " = ");
        self.mission.push(line);
        self
    }

    /// Adds a volume in which the whole vehicle stays, of a shape of the language (docs/language.md, *Volumes*); its
    /// fields are set by [`Builder::volume`].
    pub fn keep_in(self, name: &str, shape: &str) -> Self {
        self.new_volume(VolumeSide::KeepIn, name, shape)
    }

    /// Adds a volume that no part of the vehicle enters.
    ///
    /// ```
    /// use mavc::builder::Builder;
    ///
    /// let spec = Builder::new()
    ///     .vehicle("layout", "PNPN")
    ///     .vehicle("arm", 0.2)
    ///     .vehicle("mass", 1.0)
    ///     .vehicle("inertia", [0.01, 0.01, 0.02])
    ///     .vehicle("size", 0.35)
    ///     .rotor("max_thrust", 5.0)
    ///     .rotor("torque_per_thrust", 0.016)
    ///     .rotor("max_speed", 900.0)
    ///     .waypoint([0.0, 0.0, 2.0])
    ///     .waypoint([10.0, 0.0, 5.0])
    ///     .keep_out("mast", "cylinder")
    ///     .volume("mast", "centre", [5.0, 0.5, 0.0])
    ///     .volume("mast", "radius", 0.4)
    ///     .volume("mast", "height", 30.0)
    ///     .volume("mast", "clearance", 1.0)
    ///     .keep_in("field", "polygon")
    ///     .volume("field", "corners", [[-5.0, -10.0], [20.0, -10.0], [20.0, 10.0], [-5.0, 10.0]])
    ///     .volume("field", "bottom", 0.0)
    ///     .volume("field", "top", 20.0)
    ///     .build()?;
    /// assert_eq!(spec.model().mission.as_ref().unwrap().volumes.len(), 2);
    /// # Ok::<(), mavc::builder::BuildError>(())
    /// ```
    pub fn keep_out(self, name: &str, shape: &str) -> Self {
        self.new_volume(VolumeSide::KeepOut, name, shape)
    }

    fn new_volume(mut self, side: VolumeSide, name: &str, shape: &str) -> Self {
        let path = format!("mission.volumes.{name}");
        self.name(&path, name);
        let shape = self.field(Group::Volume, &format!("{path}."), "shape", shape.into(), " = ");
        self.volumes.push(Named { path, keyword: side.keyword(), name: name.into(), fields: vec![shape] });
        self
    }

    /// Sets a field of a volume that was added before, such as `radius` (m), or `corners`, a list of points `[x, y]`
    /// (m).
    pub fn volume(mut self, volume: &str, field: &str, value: impl Into<Value>) -> Self {
        let path = format!("mission.volumes.{volume}.");
        let line = self.field(Group::Volume, &path, field, value.into(), " = ");
        match self.volumes.iter_mut().rfind(|known| known.name == volume) {
            Some(known) => known.fields.push(line),
            None => {
                let message = format!("unknown volume `{volume}`");
                let help = "add it before its fields, by `keep_in` or `keep_out`";
                self.problem(path.trim_end_matches('.'), BuildCode::UnknownVolume, message, Some(help.into()));
            }
        }
        self
    }
}
