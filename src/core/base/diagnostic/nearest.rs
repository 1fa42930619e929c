//! "Did you mean": the known word most similar to an unknown one.

/// The candidate with the fewest single-letter edits from `word` (a swap of neighbours counts as one), if these are at
/// most a third of the letters, at least one and at most three. Ties go to the first in alphabetical order. Case is
/// ignored.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.len() > 64 {
        return None;
    }
    let word_letters: Vec<char> = word.to_lowercase().chars().collect();
    let most = |letters: usize| (word_letters.len().max(letters) / 3).clamp(1, 3).min(word_letters.len().max(1) - 1);
    let near = |candidate: &'a str| {
        let letters = candidate.chars().count();
        // The difference of lengths is a lower bound of the edits.
        if candidate == word || letters.abs_diff(word_letters.len()) > most(letters) {
            return None;
        }
        let changes = distance(&word_letters, &candidate.to_lowercase().chars().collect::<Vec<_>>());
        (changes <= most(letters)).then_some((changes, candidate))
    };
    candidates.into_iter().filter_map(near).min().map(|(_, c)| c)
}

/// Synonyms of words in names.
const SAME: [(&str, &str); 2] = [("rpm", "speed"), ("velocity", "speed")];

/// The candidate whose words all occur in `word`, in any order: `arm` for `arm_length`, `max_speed` for `rpm_max`. A
/// word of `word` may be an abbreviation of at least four letters: `acceleration` for `accel`. Returns the candidate
/// with the most words; `None` if two have equally many, or if `word` has `min` and the candidate does not begin with
/// it.
pub fn nearest_by_words<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let parts: Vec<&str> =
        lower.split('_').map(|part| SAME.iter().find(|s| s.0 == part).map_or(part, |s| s.1)).collect();
    let is_named =
        |wanted: &str| parts.iter().any(|part| *part == wanted || part.len() >= 4 && wanted.starts_with(part));
    let covered = |candidate: &&str| {
        candidate.split('_').all(is_named) && (candidate.starts_with("min_") || !parts.contains(&"min"))
    };
    let fits: Vec<&'a str> = candidates.into_iter().filter(|c| *c != word).filter(covered).collect();
    let count = |candidate: &str| candidate.split('_').count();
    let most = fits.iter().map(|c| count(c)).max()?;
    let mut best = fits.into_iter().filter(|c| count(c) == most);
    best.next().filter(|_| best.next().is_none())
}

/// The number of edits, where a swap of two neighbours counts as one (optimal string alignment distance).
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
    use super::{nearest, nearest_by_words};

    #[test]
    fn a_name_made_of_more_words_is_found_by_its_words() {
        let limits = ["speed", "acceleration", "acceleration_horizontal", "tilt", "yaw", "yaw_rate", "altitude"];
        assert_eq!(nearest_by_words("max_tilt", limits), Some("tilt"));
        assert_eq!(nearest_by_words("accel", limits), Some("acceleration"));
        assert_eq!(nearest_by_words("max_yaw_rate", limits), Some("yaw_rate"));
        assert_eq!(nearest_by_words("max_velocity", limits), Some("speed"));
        assert_eq!(nearest_by_words("min_altitude", limits), None);
        assert_eq!(nearest_by_words("speed_tilt", limits), None);
        let rotor = ["max_thrust", "min_speed", "max_speed", "thrust_coefficient"];
        assert_eq!(nearest_by_words("rpm_max", rotor), Some("max_speed"));
        assert_eq!(nearest_by_words("thrust", rotor), None);
    }

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
