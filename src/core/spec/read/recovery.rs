//! What a spec says of the time after a fault: the mission's landing sites, areas to keep off and limits, and the ways
//! out that the plan and its fault modes prefer.

mod order;
mod places;
mod rules;
mod settings;
mod sites;

pub(super) use order::{Order, of_modes, read as order};
pub(super) use places::check as check_places;
pub(super) use rules::Blocks;
pub(super) use settings::Draft;

const ORDER: &str = "mavc::recovery::order";
const GROUND: &str = "mavc::recovery::ground";
const SITE: &str = "mavc::recovery::site";
const VALUE: &str = "mavc::recovery::value";
const BATTERY: &str = "mavc::recovery::battery";
const TOO_MANY: &str = "mavc::recovery::too_many";
/// A limit that `after_fault_limits` does not take.
pub(super) const LIMIT: &str = "mavc::recovery::limit";
