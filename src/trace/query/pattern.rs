//! Patterns of names, in which `*` stands for any letters.

/// A pattern of names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern(pub String);

impl Pattern {
    /// True if the whole name fits: the parts between the stars stand in it one after the other, the first at its start and the
    /// last at its end.
    pub fn matches(&self, name: &str) -> bool {
        let Some((first, rest)) = self.0.split_once('*') else {
            return self.0 == name;
        };
        let Some(mut left) = name.strip_prefix(first) else {
            return false;
        };
        let mut parts = rest.split('*').peekable();
        while let Some(part) = parts.next() {
            if parts.peek().is_none() {
                return left.ends_with(part);
            }
            // The first place is as good as any: it leaves most of the name to the parts behind it.
            let Some(at) = left.find(part) else {
                return false;
            };
            left = &left[at + part.len()..];
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stars_stand_for_any_letters() {
        let matches = |pattern: &str, name: &str| Pattern(pattern.to_string()).matches(name);
        for (pattern, name) in [
            ("ball", "ball"),
            ("*", ""),
            ("*", "ball"),
            ("b*l", "ball"),
            ("*a*l*", "ball"),
            ("a*b*b", "abbb"),
            ("é*", "été"),
        ] {
            assert!(matches(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in [
            ("ball", "balls"),
            ("b*", "a ball"),
            ("ab*ba", "aba"),
            ("*x*", "ball"),
            ("", "ball"),
        ] {
            assert!(!matches(pattern, name), "{pattern} {name}");
        }
    }
}
