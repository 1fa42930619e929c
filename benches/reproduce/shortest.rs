//! The shortest times found in the exact model. Their searches take minutes, so the tests skip them.

use crate::document::case_plans::seconds;
use crate::document::exact::{PLANNERS, degrees, exact_case, exactly, plan};
use crate::document::markdown::{fixed, none, paragraph, table};
use crate::document::plans;
use mavc::Planning;
use mavc::planner::studies::{MissionPlan, Run};

/// The part under `exact::SHORTEST`.
pub fn section() -> String {
    let mut rows = Vec::new();
    for (number, planner, kind) in PLANNERS {
        let hover = plans::of_case(number);
        let before = hover.plan(planner, Run::Own);
        let spec = exact_case(number, kind, None);
        let found = plan(&spec);
        let or_none =
            |of: &dyn Fn(&MissionPlan) -> String| found.as_ref().and_then(Planning::plan).map_or_else(none, of);
        rows.push(vec![
            number.to_string(),
            planner.into(),
            seconds(before.time),
            or_none(&|s| seconds(s.time)),
            or_none(&|s| fixed(s.time / before.time, 2)),
            degrees(before, &hover.model),
            or_none(&|s| degrees(s, spec.model())),
            or_none(&|s| {
                let rows = found.as_ref().map_or(&[][..], |planning| &planning.set().rows);
                let found = exactly(s, spec.model(), rows);
                if found.outside > 0.0 { seconds(found.outside) } else { "never".into() }
            }),
        ]);
    }
    let header = [
        "case",
        "planner",
        "T, hover",
        "T, exact",
        "ratio",
        "tilt, hover, degrees",
        "tilt, exact, degrees",
        "exact plan outside",
    ];
    [
        paragraph(
            "With `--set plan.model=exact` shortest times are the shortest *found*: the steps are local, and a plan \
             may exist for a shorter time. Every such plan stays upright, and is evaluated like the hover plans.",
        ),
        table(&header, &rows),
    ]
    .concat()
}
