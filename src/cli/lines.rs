//! Lines of fields in RON text, for errors that are found when the text has become values and the places are forgotten.

/// The line, from 1, of the first field of this name, whatever comments and strings say; 1 if there is none.
/// The text has been read without a syntax error before.
pub fn of_field(text: &str, name: &str) -> usize {
    let code = code(text);
    let is_field = |at: &usize| {
        let before = code[..*at].chars().next_back();
        let whole = !before.is_some_and(|c| c.is_alphanumeric() || c == '_');
        whole && code[at + name.len()..].trim_start().starts_with(':')
    };
    let found = code.match_indices(name).map(|(at, _)| at).find(is_field);
    found.map_or(1, |at| 1 + code[..at].matches('\n').count())
}

/// The text without comments and strings, on the lines where it was.
fn code(text: &str) -> String {
    let (mut out, mut rest) = (String::with_capacity(text.len()), text);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '"' => string(rest),
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => block(rest),
            _ => 0,
        };
        if length == 0 {
            out.push(first);
            rest = &rest[first.len_utf8()..];
        } else {
            let (hidden, after) = rest.split_at(length);
            out.push(' ');
            out.extend(hidden.chars().filter(|&c| c == '\n'));
            rest = after;
        }
    }
    out
}

/// Bytes of the string that the text begins with.
fn string(text: &str) -> usize {
    let mut escaped = false;
    let ends = |&(at, c): &(usize, char)| {
        let end = at > 0 && c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        end
    };
    text.char_indices()
        .find(ends)
        .map_or(text.len(), |(at, _)| at + 1)
}

/// Bytes of the block comment that the text begins with; such comments nest.
fn block(text: &str) -> usize {
    let (mut depth, mut at) = (0, 0);
    while at < text.len() {
        match &text.as_bytes()[at..] {
            [b'/', b'*', ..] => (depth, at) = (depth + 1, at + 2),
            [b'*', b'/', ..] => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_is_found_by_its_whole_name_outside_of_comments_and_strings() {
        let text = "( // seed: 1\n level: \"\\\" seed: 2\",\n /* seed: /* 3\n */ seed: 4 */ my_seed: 5,\n \
                    seeds: 6, b: seed,\n seed : 7)";
        assert_eq!(of_field(text, "seed"), 6);
        assert_eq!(of_field(text, "level"), 2);
        assert_eq!(of_field(text, "my_seed"), 4);
        assert_eq!(of_field("(\"é\", é: 1, // ü\n seed: 2)", "seed"), 2);
        assert_eq!(of_field("", "seed"), 1);
        assert_eq!(of_field("(\" /* // ", "seed"), 1);
    }
}
