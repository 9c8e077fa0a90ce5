//! How large a scene file would be if each use of a part were written out as a group.

use serde_json::Value;

/// What costs memory in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Weight {
    /// Bytes.
    pub bytes: usize,
    /// Times that a model is named.
    pub models: usize,
    /// Bezier surfaces.
    pub patches: usize,
}

/// Uses that are followed: the reader refuses more.
const MOST: usize = 300_000;

impl Weight {
    fn of(text: &[u8]) -> Self {
        let count = |word: &[u8]| text.windows(word.len()).filter(|w| *w == word).count();
        Self {
            bytes: text.len(),
            models: count(b"\"file\""),
            patches: count(b"\"bezier\""),
        }
    }

    fn add(&mut self, other: Self) {
        self.bytes += other.bytes;
        self.models += other.models;
        self.patches += other.patches;
    }
}

/// The weight of a file with its uses written out.
pub fn written_out(text: &[u8]) -> Weight {
    let mut whole = Weight::of(text);
    if let Ok(scene) = serde_json::from_slice::<Value>(text) {
        let mut left = MOST;
        add_uses(&scene["objects"], &scene["parts"], 0, &mut left, &mut whole);
    }
    whole
}

/// Adds the parts that are used in a value, and those that these use.
fn add_uses(value: &Value, parts: &Value, depth: usize, left: &mut usize, sum: &mut Weight) {
    match value {
        Value::Array(items) => {
            for item in items {
                add_uses(item, parts, depth, left, sum);
            }
        }
        Value::Object(fields) => {
            let part = fields.get("use").and_then(|used| used["part"].as_str());
            if let Some(part) = part.filter(|_| depth < 33 && *left > 0) {
                *left -= 1;
                sum.add(Weight::of(parts[part].to_string().as_bytes()));
                add_uses(&parts[part], parts, depth + 1, left, sum);
            }
            for inner in fields.values() {
                add_uses(inner, parts, depth, left, sum);
            }
        }
        _ => {}
    }
}

#[test]
fn a_use_counts_as_its_part() {
    let file = |objects: &str| {
        let parts = r#""a": [{"obj": {"file": "m.obj"}}], "b": [{"use": {"part": "a"}}, {"use": {"part": "a"}}]"#;
        written_out(format!(r#"{{"parts": {{{parts}}}, "objects": [{objects}]}}"#).as_bytes())
    };
    assert_eq!(file("").models, 1);
    assert_eq!(file(r#"{"use": {"part": "a"}}"#).models, 2);
    assert_eq!(
        file(r#"{"use": {"part": "b"}}, {"use": {"part": "b"}}"#).models,
        5
    );
    let [none, one] = [file(""), file(r#"{"use": {"part": "b"}}"#)];
    assert!(one.bytes > none.bytes + 60, "{one:?}");
}
