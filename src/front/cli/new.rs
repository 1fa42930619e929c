//! `mavc new`: writes a spec to start from, and never overwrites a file.

use super::files::shown;
use super::target::{Target, write};
use super::{CommandError, FINE, NewVehicleArgs, Options, files};
use crate::admissible::outcome::Outcome;
use crate::import::estimate::{Estimated, Label};
use crate::pipeline::{Sweep, analyze};
use crate::report::headline::{headline, why_undecided};
use crate::spec::Compiler;
use crate::text_table::filled;
use std::path::Path;

/// Writes the template, with a `mission` that of this kind (a name in [`crate::MISSION_TEMPLATES`]), or a `vehicle`.
pub fn run(
    file: &Path,
    mission: Option<&str>,
    vehicle: &NewVehicleArgs,
    options: &Options,
) -> Result<u8, CommandError> {
    let name = shown(file);
    if file.as_os_str() != "-" && file.symlink_metadata().is_ok() {
        return Err(format!("{name} exists already; nothing was written"));
    }
    let target = Target::new(file)?;
    let of_kind = crate::MISSION_TEMPLATES.iter().find(|(kind, _)| Some(*kind) == mission);
    let estimated = label(vehicle).map(|label| label.spec()).transpose()?;
    let text = match &estimated {
        Some(estimated) => &estimated.text,
        None => of_kind.map_or(crate::TEMPLATE, |(_, text)| text),
    };
    write(&[(&target, text.as_bytes())])?;
    if !options.quiet && !target.is_stdout() {
        let next = match &estimated {
            Some(estimated) => depends(estimated, &name),
            None => format!("{name} written. Next: mavc plan {name} -o traj.csv\n"),
        };
        // The file has been written even if this line cannot be printed.
        let _ = files::print(&next);
    }
    Ok(FINE)
}

/// The figures of the command line; `None` without `--vehicle`, which requires them.
fn label(args: &NewVehicleArgs) -> Option<Label> {
    let NewVehicleArgs { vehicle, mass, motors, diagonal, propeller, battery, thrust } = *args;
    let (mass, motors) = mass.zip(motors).filter(|_| vehicle)?;
    let ((diagonal, propeller), motors) = (diagonal.zip(propeller)?, motors as usize);
    Some(Label { mass, motors, diagonal, propeller, battery, thrust })
}

/// What the outcomes of faults do over the range of each estimate.
fn depends(estimated: &Estimated, name: &str) -> String {
    let mut out =
        format!("{name} written. Its estimates are marked. What depends on each, the others in the middle:\n");
    let Some(spec) = Compiler::new().text(name, estimated.middle.as_bytes()).spec else { return out };
    let modes = analyze(&spec);
    for text in &estimated.sweeps {
        match Sweep::run(text, &spec, &modes) {
            Ok(sweep) => out.push_str(&sweep.outcomes()),
            Err(why) => out.push_str(&format!("{why}\n")),
        }
    }
    // Ranges that decide nothing one by one may do so together.
    if let Some(spec) = Compiler::new().text(name, estimated.text.as_bytes()).spec {
        let modes = analyze(&spec);
        let together = headline(spec.model(), &modes);
        let outcomes: Vec<Outcome> = modes.iter().map(|mode| mode.outcome).collect();
        let why = why_undecided(spec.model(), &outcomes).map_or(String::new(), |why| format!(" ({why})"));
        out.push_str(&filled(&format!("All ranges together: {together}{why}")));
    }
    out.push_str(&format!("Next: mavc analyze {name}\n"));
    out
}
