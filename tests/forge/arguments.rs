//! The command line, which is also that of a test program without its harness.

/// What is asked for.
#[derive(Debug, Clone)]
pub struct Arguments {
    pub count: usize,
    pub seed: u64,
    /// Words that a kind's name contains.
    pub kind: String,
    /// A filter was given that means other tests.
    pub filtered_out: bool,
}

/// The name that filters of `cargo test` are held against.
const NAME: &str = "forge";

/// Forgeries of a plain `cargo test`.
const FEW: usize = 400;

impl Arguments {
    /// # Errors
    /// A number that is none.
    pub fn read(mut given: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut found = Arguments { count: FEW, seed: 1, kind: String::new(), filtered_out: false };
        let mut filters: Vec<String> = Vec::new();
        while let Some(argument) = given.next() {
            let mut value = || given.next().ok_or(format!("`{argument}` takes a value"));
            match argument.as_str() {
                "--count" => found.count = number(&value()?)?,
                "--seed" => found.seed = number(&value()?)?,
                "--kind" => found.kind = value()?,
                // Those of a test harness that take a value.
                "--skip" | "--format" | "--test-threads" | "--color" | "--logfile" => drop(value()?),
                "--list" => found.filtered_out = true,
                other if other.starts_with('-') => {}
                filter => filters.push(filter.into()),
            }
        }
        found.filtered_out |= !filters.is_empty() && !filters.iter().any(|filter| NAME.contains(filter.as_str()));
        Ok(found)
    }
}

fn number<T: std::str::FromStr>(text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("`{text}` is not a whole number"))
}
