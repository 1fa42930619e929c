use super::spec;
use super::{CheckArgs, CheckFormat, Deny, FINE, NO_PLAN, Options, Problem, SPEC_ERRORS, files};
use crate::admissible::diagnose::diagnose;
use crate::diagnostic::{Severity, sort};
use crate::flight::twins;
use crate::report::table::Table;

/// `mavc check`
pub fn run(args: &CheckArgs, options: &Options) -> Result<u8, Problem> {
    if args.explain_defaults && args.format != CheckFormat::Human {
        return Err("--explain-defaults prints a table for people: leave --format out".into());
    }
    let mut loaded = spec::read(&args.spec, options)?;
    let mut code = if loaded.has_errors() { SPEC_ERRORS } else { FINE };
    if let Some(model) = &loaded.model {
        let answers = diagnose(model);
        if answers.iter().any(|d| d.severity == Severity::Error) {
            code = NO_PLAN;
        }
        loaded.diagnostics.extend(answers);
        loaded.diagnostics.extend(twins::diagnose(model));
        sort(&mut loaded.diagnostics);
    }
    let count = |s: Severity| loaded.diagnostics.iter().filter(|d| d.severity == s).count();
    let (errors, warnings) = (count(Severity::Error), count(Severity::Warning));
    if args.deny == Some(Deny::Warnings) && warnings > 0 && code == FINE {
        code = SPEC_ERRORS;
    }
    match args.format {
        CheckFormat::Json => files::print(&loaded.json())?,
        CheckFormat::Short => files::print(&loaded.short())?,
        CheckFormat::Human => {
            files::print(&loaded.human(&std::io::stdout()))?;
            if !options.quiet {
                let name = spec::name(&args.spec.spec);
                files::print(&format!("{name}: {}\n", verdict(errors, warnings)))?;
            }
        }
    }
    if let Some(model) = loaded.model.as_ref().filter(|_| args.explain_defaults) {
        let mut table = Table::new(&["field", "default", "why"]);
        for d in &model.defaults {
            table.row(vec![d.field.clone(), d.value.clone(), d.reason.clone()]);
        }
        files::print(&table.render_left(0))?;
    }
    Ok(code)
}

fn verdict(errors: usize, warnings: usize) -> String {
    let plural = |n: usize, word: &str| format!("{n} {word}{}", if n == 1 { "" } else { "s" });
    match (errors, warnings) {
        (0, 0) => "no problems".into(),
        (0, w) => plural(w, "warning"),
        (e, 0) => plural(e, "error"),
        (e, w) => format!("{}, {}", plural(e, "error"), plural(w, "warning")),
    }
}
