//! Other ways to hit a parametric patch: as the triangles of a grid on it.

use std::fmt;
use std::str::FromStr;

/// How parametric patches are tested.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PatchMethod {
    /// As they are.
    #[default]
    Exact,
    /// As triangles with the normals of the patch at their corners: each leaf is cut into so many squares along u and v, each
    /// square into two triangles.
    Triangles(u32),
}

impl PatchMethod {
    /// The most squares along u and v.
    pub const MOST: u32 = 64;
}

/// As on the command line: `exact` or `triangles:N`.
impl fmt::Display for PatchMethod {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("exact"),
            Self::Triangles(n) => write!(f, "triangles:{n}"),
        }
    }
}

impl FromStr for PatchMethod {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "exact" {
            return Ok(Self::Exact);
        }
        let count = text.strip_prefix("triangles:").map(str::parse::<u32>);
        match count {
            Some(Ok(n)) if (1..=Self::MOST).contains(&n) => Ok(Self::Triangles(n)),
            Some(_) => Err(format!(
                "the number of squares must be from 1 to {}, such as triangles:8",
                Self::MOST
            )),
            None => Err("write exact or triangles:N (such as triangles:8)".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_method_is_read_as_it_is_written() {
        for method in [PatchMethod::Exact, PatchMethod::Triangles(8)] {
            assert_eq!(method.to_string().parse(), Ok(method));
        }
        for wrong in [
            "",
            "triangles",
            "triangles:0",
            "triangles:65",
            "triangles:-1",
            "8",
        ] {
            assert!(wrong.parse::<PatchMethod>().is_err(), "{wrong}");
        }
    }
}
