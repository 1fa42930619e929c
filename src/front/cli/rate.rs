//! The option `--rate 100Hz`.

use super::CommandError;
use crate::report::trajectory_csv::RATES;

/// Reads `100Hz`, `100 Hz` or `0.5kHz`; the rate in Hz.
pub fn parse(text: &str) -> Result<f64, CommandError> {
    let trimmed = text.trim();
    let (digits, factor) = match (trimmed.strip_suffix("kHz"), trimmed.strip_suffix("Hz")) {
        (Some(d), _) => (d, 1e3),
        (None, Some(d)) => (d, 1.0),
        _ => return Err(format!("--rate {text}: write a frequency such as 100Hz")),
    };
    let rate = digits.trim().parse::<f64>().ok().map(|r| r * factor).filter(|r| r.is_finite());
    match rate {
        Some(r) if RATES.contains(&r) => Ok(r),
        Some(_) => Err(format!("--rate {text}: the rate must lie between 0.001 Hz and 100 kHz")),
        None => Err(format!("--rate {text}: {:?} is not a number", digits.trim())),
    }
}
