//! Names of rays: the steps from the eye, as in `/T/R/L:lamp`.

use std::fmt;
use std::str::FromStr;

use crate::probe::RayKind;

/// A ray of a pixel, by the steps that lead to it from the eye.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TreePath {
    /// The number of the pixel's sample.
    pub sample: u32,
    /// The steps; none for the eye ray.
    pub steps: Vec<Step>,
}

/// A step from a hit along one of its rays.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Step {
    /// `L:lamp`, or `L:lamp~3` for a further sample of an area light.
    Light(String, u32),
    /// `R`.
    Reflected,
    /// `T`.
    Transmitted,
}

impl TreePath {
    /// The path of the eye ray of a sample.
    pub fn eye(sample: u32) -> Self {
        Self {
            sample,
            steps: Vec::new(),
        }
    }

    /// The path with one more step.
    pub fn then(&self, step: Step) -> Self {
        let mut path = self.clone();
        path.steps.push(step);
        path
    }

    /// Bounces since the eye.
    pub fn depth(&self) -> usize {
        self.steps.len()
    }
}

impl Step {
    /// The step of a ray of this kind, to a light if it is an L ray; `None` for eye rays.
    pub fn new(kind: RayKind, light: Option<&str>, sample: u32) -> Option<Self> {
        match kind {
            RayKind::Incident => None,
            RayKind::Light => Some(Self::Light(light.unwrap_or_default().to_owned(), sample)),
            RayKind::Reflected => Some(Self::Reflected),
            RayKind::Transmitted => Some(Self::Transmitted),
        }
    }
}

/// Letters that mean something in an address, and how they are written in a name.
const ESCAPED: [(char, &str); 6] = [
    ('%', "%25"),
    ('/', "%2F"),
    ('#', "%23"),
    ('@', "%40"),
    ('~', "%7E"),
    ('.', "%2E"),
];

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reflected => write!(f, "R"),
            Self::Transmitted => write!(f, "T"),
            Self::Light(name, sample) => {
                write!(f, "L:")?;
                for c in name.chars() {
                    match ESCAPED.iter().find(|(letter, _)| *letter == c) {
                        Some((_, code)) => write!(f, "{code}")?,
                        None => write!(f, "{c}")?,
                    }
                }
                if *sample > 0 {
                    write!(f, "~{sample}")?;
                }
                Ok(())
            }
        }
    }
}

impl FromStr for Step {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "R" => Ok(Self::Reflected),
            "T" => Ok(Self::Transmitted),
            _ => {
                let light = text.strip_prefix("L:").filter(|name| !name.is_empty());
                let light = light.ok_or_else(|| {
                    format!("`{text}` is no step; write R, T or L: and the name of a light")
                })?;
                let (name, sample) = light.split_once('~').unwrap_or((light, "0"));
                let sample = sample.parse().map_err(|_| {
                    format!(
                        "`{sample}` in `{text}` is no number of a sample; write one, such as ~2"
                    )
                })?;
                // The sign of escapes comes last, so that nothing is unescaped twice.
                let plain = ESCAPED
                    .iter()
                    .rev()
                    .fold(name.to_owned(), |name, (c, code)| {
                        name.replace(code, &c.to_string())
                    });
                Ok(Self::Light(plain, sample))
            }
        }
    }
}

impl fmt::Display for TreePath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.sample > 0 {
            write!(f, ":{}", self.sample)?;
        }
        self.steps.iter().try_for_each(|step| write!(f, "/{step}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_read_as_they_are_written() {
        for name in ["lamp", "50% /#@~.", "%2F", "a%252Eb", "L"] {
            for sample in [0, 3] {
                let step = Step::Light(name.to_owned(), sample);
                assert_eq!(step.to_string().parse(), Ok(step), "{name}");
            }
        }
        assert!("L:".parse::<Step>().is_err());
        assert!("X".parse::<Step>().is_err());
        assert!("L:lamp~x".parse::<Step>().is_err());
    }
}
