//! Rust source as tokens: names, `::` and single signs; comments, texts and numbers are left out.

/// The tokens of a source.
///
/// ```
/// let found = cla_tests::tokens::tokens("use a::b; // c\nlet d = \"e\";");
/// assert_eq!(found, ["use", "a", "::", "b", ";", "let", "d", "=", ";"]);
/// ```
#[must_use]
pub fn tokens(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if let Some(length) = silent(rest) {
            length
        } else if first.is_alphabetic() || first == '_' {
            let end = rest.find(|it: char| !(it.is_alphanumeric() || it == '_'));
            let length = end.unwrap_or(rest.len());
            found.push(rest[..length].to_owned());
            length
        } else if rest.starts_with("::") {
            found.push("::".to_owned());
            2
        } else {
            if !first.is_whitespace() {
                found.push(first.to_string());
            }
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    found
}

/// The length of a comment, a text, a sign in quotes, a lifetime or a number that begins here.
fn silent(rest: &str) -> Option<usize> {
    let until = |end: &str, from: usize| {
        let found = rest[from..].find(end);
        found.map_or(rest.len(), |at| from + at + end.len())
    };
    if rest.starts_with("//") {
        return Some(until("\n", 2));
    }
    if rest.starts_with("/*") {
        return Some(until("*/", 2));
    }
    let raw = rest.trim_start_matches(['b', 'c']);
    if let Some(hashes) = raw.strip_prefix('r')
        && rest.len() - raw.len() <= 1
    {
        let marks = hashes.len() - hashes.trim_start_matches('#').len();
        if hashes[marks..].starts_with('"') {
            let end = format!("\"{}", "#".repeat(marks));
            return Some(until(&end, rest.len() - hashes.len() + marks + 1));
        }
    }
    if let Some(text) = rest.strip_prefix('"') {
        return Some(1 + quoted(text, '"'));
    }
    if let Some(inside) = rest.strip_prefix('\'') {
        let mut signs = inside.chars();
        let (first, second) = (signs.next(), signs.next());
        // `'a'` and `'\n'` are signs, `'a` is a lifetime.
        if first == Some('\\') || second == Some('\'') {
            return Some(1 + quoted(inside, '\''));
        }
        let end = inside.find(|it: char| !(it.is_alphanumeric() || it == '_'));
        return Some(1 + end.unwrap_or(inside.len()));
    }
    if rest.starts_with(|first: char| first.is_ascii_digit()) {
        let end = rest.find(|it: char| !(it.is_alphanumeric() || it == '_'));
        return Some(end.unwrap_or(rest.len()));
    }
    None
}

/// The length of what follows an opening quote, up to and with the closing one.
fn quoted(text: &str, end: char) -> usize {
    let mut escaped = false;
    for (at, sign) in text.char_indices() {
        if sign == end && !escaped {
            return at + 1;
        }
        escaped = sign == '\\' && !escaped;
    }
    text.len()
}
