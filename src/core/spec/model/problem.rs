//! The pair that every planner takes: a model and the mission in it.

use super::{Mission, Model};

/// A model together with its mission: what is planned.
///
/// To plan with another mission, limit or time, change a copy of the model and take the problem of that: there is no
/// problem whose mission is not its model's.
#[derive(Debug, Clone, Copy)]
pub struct Problem<'a> {
    model: &'a Model,
    mission: &'a Mission,
}

impl<'a> Problem<'a> {
    /// `None` if the model has no mission.
    pub fn of(model: &'a Model) -> Option<Self> {
        model.mission.as_ref().map(|mission| Problem { model, mission })
    }

    pub fn model(self) -> &'a Model {
        self.model
    }

    pub fn mission(self) -> &'a Mission {
        self.mission
    }

    /// A copy of the model with another mission.
    pub fn with_mission(self, mission: Mission) -> Model {
        Model { mission: Some(mission), ..self.model.clone() }
    }
}
