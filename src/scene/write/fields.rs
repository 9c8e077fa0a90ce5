//! Fields of a JSON object, in the order and the look of scene files that people write.

use serde_json::Value;

use crate::math::Rgb;
use crate::scene::flat;

/// Fields of an object, one after the other.
#[derive(Clone, Debug, Default)]
pub struct Fields(Vec<String>);

impl Fields {
    /// Adds a field with a value that is JSON already.
    pub fn raw(mut self, key: &str, value: &str) -> Self {
        self.0.push(format!("\"{key}\": {value}"));
        self
    }

    /// Adds a text.
    pub fn text(self, key: &str, value: &str) -> Self {
        self.raw(key, &quoted(value))
    }

    /// Adds a number.
    pub fn number(self, key: &str, value: f64) -> Self {
        self.raw(key, &number(value))
    }

    /// Adds a list of numbers.
    pub fn row(self, key: &str, values: &[f64]) -> Self {
        self.raw(key, &row(values))
    }

    /// Adds a list of lists of numbers.
    pub fn rows<const N: usize>(self, key: &str, values: &[[f64; N]]) -> Self {
        self.raw(key, &rows(values))
    }

    /// Adds a colour that is not black: black is what is left out.
    pub fn color(self, key: &str, value: Rgb) -> Self {
        if value.is_black() {
            return self;
        }
        self.row(key, &value.channels())
    }

    /// The object on one line.
    pub fn line(&self) -> String {
        format!("{{{}}}", self.0.join(", "))
    }

    /// The object with a field a line.
    pub fn lines(&self) -> String {
        format!("{{\n  {}\n}}\n", self.0.join(",\n  "))
    }

    /// The object as a kind: `{"sphere": {...}}`.
    pub fn kind(&self, kind: &str) -> String {
        format!("{{\"{kind}\": {}}}", self.line())
    }
}

/// A text in quotes. (Nothing but memory could be missing for that.)
pub fn quoted(text: &str) -> String {
    flat::line(&text).unwrap_or_default()
}

/// A number that is read with the same bits; whole ones without a point.
fn number(x: f64) -> String {
    if x.fract() == 0.0 && x.abs() < 1e15 {
        format!("{x:.0}")
    } else {
        Value::from(x).to_string()
    }
}

/// A list of numbers.
pub fn row(values: &[f64]) -> String {
    let numbers: Vec<String> = values.iter().map(|x| number(*x)).collect();
    format!("[{}]", numbers.join(", "))
}

/// A list of lists of numbers.
pub fn rows<const N: usize>(values: &[[f64; N]]) -> String {
    let rows: Vec<String> = values.iter().map(|values| row(values)).collect();
    format!("[{}]", rows.join(", "))
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_read_with_the_same_bits() {
        for x in [
            0.0,
            -0.0,
            1.0,
            -3.0,
            0.1,
            1e15,
            1e300,
            5e-324,
            1.0 / 3.0,
            123_456.5,
        ] {
            let read: f64 = serde_json::from_str(&number(x)).expect("a number");
            assert_eq!(read.to_bits(), x.to_bits(), "{}", number(x));
        }
        assert_eq!(number(2.0), "2");
    }
}
