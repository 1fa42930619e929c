//! The mistakes of a built spec.

use std::error::Error;
use std::fmt;

/// Mistakes that the builder finds before the text is compiled.
pub(super) enum BuildCode {
    NotFinite,
    NotAName,
    UnknownField,
    UnknownMode,
    UnknownVolume,
    WrongKind,
}

impl BuildCode {
    pub(super) fn code(self) -> &'static str {
        match self {
            BuildCode::NotFinite => "mavc::unit::not_finite",
            BuildCode::NotAName => "mavc::name::reserved",
            BuildCode::UnknownField => "mavc::name::unknown_field",
            BuildCode::UnknownMode | BuildCode::UnknownVolume => "mavc::name::unknown",
            BuildCode::WrongKind => "mavc::unit::kind",
        }
    }
}

/// One mistake in a built spec, or a warning about it.
#[derive(Debug, Clone, PartialEq)]
pub struct BuildProblem {
    /// The call that made it, such as `plan.samples` or `mission.waypoints[2]`; the block, if something is missing in
    /// it.
    pub field: String,
    /// The code of the mistake, for `mavc explain`.
    pub code: &'static str,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What is wrong with the value that was given, such as `this is 9`.
    pub label: Option<String>,
    /// One action that fixes the problem.
    pub help: Option<String>,
}

#[deprecated = "renamed to `BuildProblem`"]
pub type Problem = BuildProblem;

/// `{field}: {message}: {label}; {help} ({code})`
impl fmt::Display for BuildProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.field, self.message)?;
        if let Some(label) = &self.label {
            write!(f, ": {label}")?;
        }
        if let Some(help) = &self.help {
            write!(f, "; {}", help.lines().map(str::trim).collect::<Vec<_>>().join("; "))?;
        }
        write!(f, " ({})", self.code)
    }
}

/// The mistakes in a built spec.
#[derive(Clone, PartialEq)]
pub struct BuildError {
    pub problems: Vec<BuildProblem>,
    /// The text that was built.
    pub text: String,
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.problems.iter().map(BuildProblem::to_string).collect::<Vec<_>>().join("\n"))
    }
}

/// The text of `Display` on a new line, because a `main` that returns the error prints it so.
impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{self}")
    }
}

impl Error for BuildError {}
