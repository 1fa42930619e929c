//! Lists of mode names that fit into a cell or a line.

/// Modes by name, given by their places among `all`; three or more consecutive modes of one `every` statement as a
/// range: `M1 .. M6`. Each with the number of modes that it names.
pub fn ranges(all: &[String], places: &[usize]) -> Vec<(String, usize)> {
    let name = |place: usize| all[place].clone();
    let family = |place: usize| all[place].trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
    let runs = places.chunk_by(|a, b| a + 1 == *b && family(*a) == family(*b));
    runs.flat_map(|run| match run {
        [first, _, .., last] => vec![(format!("{} .. {}", name(*first), name(*last)), run.len())],
        few => few.iter().map(|place| (name(*place), 1)).collect(),
    })
    .collect()
}

/// The modes by name in at most `width` columns: `M1, M4`, `M1 .. M6`, `D1_2, D1_3 and 12 more`. A name that does not
/// fit is cut.
pub fn within(all: &[String], places: &[usize], width: usize) -> String {
    let named = ranges(all, places);
    let whole: Vec<&str> = named.iter().map(|(name, _)| name.as_str()).collect();
    let whole = whole.join(", ");
    if whole.chars().count() <= width {
        return whole;
    }
    let total: usize = places.len();
    let (mut text, mut modes) = (String::new(), 0);
    for (name, count) in &named {
        let separator = if text.is_empty() { "" } else { ", " };
        let longer = format!("{text}{separator}{name}");
        let left = total - modes - count;
        let tail = if left > 0 { format!(" and {left} more").len() } else { 0 };
        if longer.chars().count() + tail > width && !text.is_empty() {
            return format!("{text} and {} more", total - modes);
        }
        if longer.chars().count() + tail > width {
            let cut: String = name.chars().take(width.saturating_sub(tail + 1)).collect();
            text = format!("{cut}…");
        } else {
            text = longer;
        }
        modes += count;
        if text.ends_with('…') && left > 0 {
            return format!("{text} and {left} more");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_fit() {
        let all: Vec<String> = ["M1", "M2", "M3", "M4", "rail", "worn"].map(String::from).to_vec();
        assert_eq!(within(&all, &[0, 1, 2, 3], 20), "M1 .. M4");
        assert_eq!(within(&all, &[0, 3], 20), "M1, M4");
        assert_eq!(within(&all, &[0, 1, 3, 4, 5], 20), "M1, M2 and 3 more");
        assert_eq!(within(&all, &[0, 1, 3, 4, 5], 22), "M1, M2, M4, rail, worn");
        assert_eq!(within(&all, &[], 10), "");
        let long = vec!["a".repeat(60), "b".into()];
        for width in 12..70 {
            let text = within(&long, &[0, 1], width);
            assert!(text.chars().count() <= width, "{width}: {text}");
        }
        assert_eq!(within(&long, &[0, 1], 20), "aaaaaaaa… and 1 more");
    }
}
