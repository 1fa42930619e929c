//! The first line that `mavc fmt --check` would change, for people.

const BYTE_ORDER_MARK: char = '\u{feff}';

/// The name of a file that would change, with its first line that would, before and after; the name alone if `brief`.
pub fn first_difference(name: &str, before: &str, after: &str, brief: bool) -> String {
    if brief {
        return format!("{name}\n");
    }
    let (mut old, mut new) = (before.split_inclusive('\n'), after.split_inclusive('\n'));
    let mut line = 1;
    let (old, new) = loop {
        match (old.next(), new.next()) {
            (old, new) if old == new && old.is_some() => line += 1,
            pair => break pair,
        }
    };
    let head = format!("{name}:{line}: would be reformatted\n");
    let shown = |sign: char, text: &str| format!("  {sign} {text}\n");
    let (was, is) = (old.unwrap_or("").trim_end(), new.unwrap_or("").trim_end());
    // A difference behind the last visible character has to be described.
    if was == is && old.is_some() && new.is_some() || was == format!("{BYTE_ORDER_MARK}{is}") {
        return head + &shown('~', unseen(old.unwrap_or(""), new.unwrap_or("")));
    }
    match (old, new) {
        (Some(_), _) if was.is_empty() => head + &shown('-', "an empty line"),
        (_, Some(_)) if is.is_empty() => head + &shown('+', "an empty line"),
        (Some(_), Some(_)) => head + &shown('-', was) + &shown('+', is),
        (Some(_), None) => head + &shown('-', was),
        (None, _) => head + &shown('+', is),
    }
}

/// The difference between two lines that look the same.
fn unseen(old: &str, new: &str) -> &'static str {
    if old.starts_with(BYTE_ORDER_MARK) {
        return "a byte order mark at the beginning";
    }
    match (old.ends_with('\n'), new.ends_with('\n'), old.ends_with("\r\n"), new.ends_with("\r\n")) {
        (false, true, ..) => "no line end at the end of the file",
        (.., true, false) => "a carriage return at the line's end, where the first line has none",
        (.., false, true) => "no carriage return at the line's end, where the first line has one",
        _ => "blanks at the line's end",
    }
}
