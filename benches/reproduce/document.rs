//! The document's parts, each under one heading of the second level.

pub mod alternatives;
pub mod case_orders;
pub mod case_plans;
pub mod claims;
pub mod exact;
pub mod faults;
pub mod flights;
pub mod judgement;
pub mod markdown;
pub mod paper_faults;
pub mod paper_plans;
pub mod plans;
pub mod setting;
pub mod specs;

const INTRODUCTION: &str = "\
# The paper's tables compared with mavc

The paper is N. Osmic, A. Tahirovic and I. Petrovic, *Risk-sensitive motion planning for MAVs based on mission-related
fault-tolerant analysis*, Automatika 61:2 (2020), doi 10.1080/00051144.2020.1733324. The command
`cargo bench --bench reproduce -- --write` writes this page from the specs in `specs/`. The tests recompute its
numbers (the last table takes minutes, so they check it in cheaper ways).

Each row has a judgement: **agrees**, **differs** (and why), or **not comparable** (and what the paper does not give).
Rows in which only an order can be compared say so. Numbers of the paper are as printed.

";

/// The whole page; `shortest` writes the part under [`exact::SHORTEST`].
pub fn whole(shortest: impl FnOnce() -> String) -> String {
    let parts = [
        INTRODUCTION.to_string(),
        "## Fault sets and verdicts: Tables 1 to 7\n\n".into(),
        faults::sections(),
        "## Statements about sets and layouts\n\n".into(),
        claims::section(),
        "## Flights: Figures 3 to 5 and 10 to 12\n\n".into(),
        flights::section(),
        "## How the plans are set up\n\n".into(),
        setting::section(),
        case(1),
        case(2),
        case(3),
        "## What changes in the exact model\n\n".into(),
        exact::section(shortest),
    ];
    parts.concat().trim_end().to_string() + "\n"
}

/// Tables 8 and 9, 10 and 11, or 12 and 13, with the paper's statements about them.
fn case(number: usize) -> String {
    let heading = format!("## Case {number}: Tables {} and {}\n\n", 6 + 2 * number, 7 + 2 * number);
    heading + &case_plans::section(number) + &case_orders::section(number)
}
