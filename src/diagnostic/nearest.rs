//! "Did you mean": the known word nearest to one that is unknown.

/// The candidate with the fewest single-letter changes from `word` (a swap of neighbours counts one), where that is
/// at most a third of the letters (one in short words, three in long ones); ties go to the first by name. Letter case counts for nothing.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.len() > 64 {
        return None;
    }
    let word_letters: Vec<char> = word.to_lowercase().chars().collect();
    let most = |letters: usize| (word_letters.len().max(letters) / 3).clamp(1, 3).min(word_letters.len().max(1) - 1);
    let near = |candidate: &'a str| {
        let letters = candidate.chars().count();
        // So many letters more or less are so many changes at least.
        if candidate == word || letters.abs_diff(word_letters.len()) > most(letters) {
            return None;
        }
        let changes = distance(&word_letters, &candidate.to_lowercase().chars().collect::<Vec<_>>());
        (changes <= most(letters)).then_some((changes, candidate))
    };
    candidates.into_iter().filter_map(near).min().map(|(_, c)| c)
}

/// Edits, where a swap of two neighbours counts one (optimal string alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    rows[0] = (0..=b.len()).collect();
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let change = usize::from(a[i - 1] != b[j - 1]);
            let mut best = (rows[i - 1][j] + 1).min(rows[i][j - 1] + 1).min(rows[i - 1][j - 1] + change);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn finds_the_nearest_by_edits_then_by_name() {
        let words = ["mission", "vehicle", "plan", "faults"];
        assert_eq!(nearest("mision", words), Some("mission"));
        assert_eq!(nearest("fualts", words), Some("faults"));
        assert_eq!(nearest("Plan", words), Some("plan"));
        assert_eq!(nearest("banana", words), None);
        assert_eq!(nearest("M3", ["M2", "M1"]), Some("M1"));
    }

    #[test]
    fn never_offers_the_word_itself_or_a_wholly_different_one() {
        assert_eq!(nearest("mass", ["mass"]), None);
        assert_eq!(nearest("x", ["y"]), None);
    }
}
