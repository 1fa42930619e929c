//! Tables and numbers as the page prints them.

pub use mavc::number::fixed;

/// A table; every row has as many cells as the header.
pub fn table(header: &[&str], rows: &[Vec<String>]) -> String {
    let line = |cells: Vec<&str>| format!("| {} |\n", cells.join(" | "));
    let body = rows.iter().map(|r| line(r.iter().map(String::as_str).collect()));
    let rule = format!("|{}\n", "---|".repeat(header.len()));
    line(header.to_vec()) + &rule + &body.collect::<String>() + "\n"
}

/// A computed vector: `[0.00 -0.03]`
pub fn vector(values: &[f64], decimals: usize) -> String {
    let cells: Vec<String> = values.iter().map(|&v| fixed(v, decimals)).collect();
    format!("[{}]", cells.join(" "))
}

/// A vector of the paper with its digits: `[0.0 -0.03]`
pub fn as_printed(values: &[f64]) -> String {
    let cells: Vec<String> = values.iter().map(|v| format!("{v:?}")).collect();
    format!("[{}]", cells.join(" "))
}

/// A number of the paper: plain, or with an exponent if it is tiny.
pub fn printed(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-3 { format!("{value:e}") } else { value.to_string() }
}

/// A missing value.
pub fn none() -> String {
    "–".into()
}

/// A paragraph, lines no longer than 120 columns.
pub fn paragraph(text: &str) -> String {
    const WIDTH: usize = 120;
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= WIDTH => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.into()),
        }
    }
    lines.join("\n") + "\n\n"
}
