//! Choices of arithmetic: how shapes are tested, and how a ray leaves a surface.
//!
//! The default is what raytree is built on. The other choices are those of many tracers; they are there for comparison,
//! and never without a note that says so.

pub mod flat;
pub mod patch;
pub mod quartic;
pub mod real;
pub mod sphere;
pub mod triangle;

pub use patch::PatchMethod;
pub use quartic::QuarticMethod;

use std::fmt;
use std::str::FromStr;

/// How a triangle is tested.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum TriangleTest {
    /// The crossing with its plane, then the sides of its three edges, as in the lectures.
    PlaneEdges,
    /// Cramer's rule for t and the weights. Source: Moeller and Trumbore 1997.
    MollerTrumbore,
    /// Signs of edge functions that neighbours share. Source: Woop, Benthin and Wald 2013.
    #[default]
    Watertight,
}

/// Where a ray starts that leaves a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Offset {
    /// At o + t d.
    None,
    /// At o + t d, moved along the normal by so many metres.
    Fixed(f64),
    /// As far off the surface as its error bound says.
    #[default]
    Bounded,
}

/// How the two crossings of a sphere are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Quadratic {
    /// The school formula.
    Naive,
    /// The one without cancellation. Source: Haines, Guenther and Akenine-Moeller 2019.
    #[default]
    Stable,
}

/// The numbers that tests and hit points are computed with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Precision {
    /// 24 bits, about 7 digits.
    Single,
    /// 53 bits, about 16 digits.
    #[default]
    Double,
}

/// All of these choices.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arithmetic {
    /// How triangles are tested.
    pub triangle: TriangleTest,
    /// Where rays start that leave a surface.
    pub offset: Offset,
    /// How spheres, cylinders and other surfaces of the second degree are tested.
    pub quadratic: Quadratic,
    /// How tori and other surfaces of the fourth degree are tested.
    pub quartic: QuarticMethod,
    /// How parametric patches are tested.
    pub patch: PatchMethod,
    /// In which precision.
    pub precision: Precision,
}

impl Arithmetic {
    /// That of this tracer, which is the default.
    pub const OURS: Self = Self {
        triangle: TriangleTest::Watertight,
        offset: Offset::Bounded,
        quadratic: Quadratic::Stable,
        quartic: QuarticMethod::Polished,
        patch: PatchMethod::Exact,
        precision: Precision::Double,
    };
}

/// A choice that is not the default.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Deviation {
    /// Which choice: the name of its flag.
    pub choice: &'static str,
    /// What was chosen.
    pub value: String,
    /// What comes of it.
    pub note: &'static str,
}

impl TriangleTest {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::PlaneEdges, Self::MollerTrumbore, Self::Watertight];

    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

impl Quadratic {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Naive, Self::Stable];

    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

impl Precision {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Single, Self::Double];

    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// As on the command line: `none`, `fixed:EPS` or `bounded`.
impl fmt::Display for Offset {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Fixed(epsilon) => write!(f, "fixed:{epsilon:e}"),
            Self::Bounded => f.write_str("bounded"),
        }
    }
}

impl FromStr for Offset {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let epsilon = match text {
            "none" => return Ok(Self::None),
            "bounded" => return Ok(Self::Bounded),
            _ => text.strip_prefix("fixed:").map(str::parse::<f64>),
        };
        match epsilon {
            Some(Ok(epsilon)) if epsilon.is_finite() && epsilon > 0.0 => Ok(Self::Fixed(epsilon)),
            Some(_) => {
                Err("the offset must be a number of metres above 0, such as fixed:1e-4".to_owned())
            }
            None => Err("write none, fixed:EPS (such as fixed:1e-4) or bounded".to_owned()),
        }
    }
}

impl Arithmetic {
    /// The choices that are not the default, in the order of the fields.
    pub fn deviations(&self) -> Vec<Deviation> {
        let ours = Self::default();
        let mut list = Vec::new();
        let mut add = |choice, value: String, note| {
            list.push(Deviation {
                choice,
                value,
                note,
            });
        };
        if self.triangle != ours.triangle {
            let note = "rays at an edge may slip through or hit both neighbours";
            add("triangle", self.triangle.name().to_owned(), note);
        }
        if self.offset != ours.offset {
            let note = match self.offset {
                Offset::Fixed(_) => {
                    "rays may hit the surface that they leave, or start behind the next one"
                }
                _ => "rays may hit the surface that they leave",
            };
            add("offset", self.offset.to_string(), note);
        }
        if self.quadratic != ours.quadratic {
            let note = "small spheres and the like far away, and large ones nearby, are hit in the wrong places";
            add("quadratic", self.quadratic.name().to_owned(), note);
        }
        if self.quartic != ours.quartic {
            let note = "a torus far away, or seen at its edge, is hit in the wrong places";
            add("quartic", self.quartic.name().to_owned(), note);
        }
        if self.patch != ours.patch {
            let note = "patches are flat between the corners of a grid: outlines have corners, and rays slip through where leaves meet";
            add("patch-test", self.patch.to_string(), note);
        }
        if self.precision != ours.precision {
            let note = "shapes are tested with 7 digits instead of 16";
            add("precision", self.precision.name().to_owned(), note);
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_offset_is_read_as_it_is_written() {
        for offset in [Offset::None, Offset::Fixed(1e-4), Offset::Bounded] {
            assert_eq!(offset.to_string().parse(), Ok(offset));
        }
        for wrong in [
            "",
            "fixed",
            "fixed:",
            "fixed:0",
            "fixed:-1",
            "fixed:nan",
            "fixed:1e999",
            "1e-4",
        ] {
            assert!(wrong.parse::<Offset>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn only_what_deviates_is_told() {
        assert!(Arithmetic::default().deviations().is_empty());
        let naive = Arithmetic {
            triangle: TriangleTest::PlaneEdges,
            offset: Offset::None,
            quadratic: Quadratic::Naive,
            quartic: QuarticMethod::Plain,
            patch: PatchMethod::Triangles(4),
            precision: Precision::Single,
        };
        let told = naive.deviations();
        let choices: Vec<_> = told.iter().map(|d| d.choice).collect();
        let all = [
            "triangle",
            "offset",
            "quadratic",
            "quartic",
            "patch-test",
            "precision",
        ];
        assert_eq!(choices, all);
    }
}
