//! The sets of a decision, each computed at most once: several conditions are about the same set.

use super::{Generators, HEALTHY, Plane};
use crate::model::{FaultMode, Model};
use crate::verify::Rejection;
use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

/// The sets of a spec's modes.
pub struct Sets<'m> {
    model: &'m Model,
    /// The place of a mode in the spec, by its name: specs may have thousands.
    places: HashMap<&'m str, usize>,
    healthy: OfMode,
    modes: Vec<OfMode>,
}

#[derive(Default)]
struct OfMode {
    planes: OnceLock<Result<Arc<[Plane]>, String>>,
    has_hover: OnceLock<bool>,
}

impl<'m> Sets<'m> {
    pub fn new(model: &'m Model) -> Self {
        // The first of equal names counts, as everywhere.
        let places = model.modes.iter().enumerate().rev().map(|(place, mode)| (mode.name.as_str(), place)).collect();
        let modes = model.modes.iter().map(|_| OfMode::default()).collect();
        Sets { model, places, healthy: OfMode::default(), modes }
    }

    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// A mode by its name.
    pub fn mode(&self, name: &str) -> Option<&'m FaultMode> {
        self.places.get(name).map(|&place| &self.model.modes[place])
    }

    fn of(&self, name: &str) -> Result<(&OfMode, Option<&'m FaultMode>), Rejection> {
        match (name, self.places.get(name)) {
            (HEALTHY, _) => Ok((&self.healthy, None)),
            (_, Some(&place)) => Ok((&self.modes[place], Some(&self.model.modes[place]))),
            _ => Err(Rejection::new(format!("the set of {name}"), "the spec has no such mode")),
        }
    }

    /// The generators of `healthy` or of a mode.
    ///
    /// # Errors
    /// The spec has no such mode.
    pub fn generators(&self, name: &str) -> Result<Generators, Rejection> {
        let (_, mode) = self.of(name)?;
        Ok(Generators::new(&self.model.vehicle, &self.model.environment(), mode, self.model.plan.reserve))
    }

    /// The planes of `healthy` or of a mode, or why they cannot be computed ([`Generators::planes`]).
    ///
    /// # Errors
    /// The spec has no such mode.
    pub fn planes(&self, name: &str) -> Result<Result<Arc<[Plane]>, String>, Rejection> {
        let (set, _) = self.of(name)?;
        if let Some(known) = set.planes.get() {
            return Ok(known.clone());
        }
        let planes = self.generators(name)?.planes().map(Arc::from);
        Ok(set.planes.get_or_init(|| planes).clone())
    }

    /// What `decide` finds about hover in a mode's set, decided once.
    pub fn has_hover(&self, name: &str, decide: impl FnOnce() -> bool) -> bool {
        self.of(name).is_ok_and(|(set, _)| *set.has_hover.get_or_init(decide))
    }
}
