//! Warnings: what of a scene was left out, guessed or clamped, and what cannot be meant.
//!
//! A warning has a code that stays the same in all versions; the book lists the codes with their cures.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::{SceneError, first_line, shown};
use super::limits::MAX_WARNINGS;

/// A warning about a scene. Its text has two lines: where and what, then what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Its kind.
    pub code: WarningCode,
    /// Where it was found first, what it is about, and what to do.
    pub problem: SceneError,
    /// How often it was found.
    pub count: u64,
}

/// The kind of a warning, by a name that stays the same in all versions.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    Hash,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    JsonSchema,
    strum::IntoStaticStr,
    strum::VariantArray,
)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum WarningCode {
    /// The scene has no objects.
    NoObjects,
    /// Faces of a model with fewer than three corners, which are left out.
    FewCorners,
    /// Triangles without area, which are left out.
    NoArea,
    /// A polygon whose corners do not lie in one plane, which is cut into triangles.
    NotFlat,
    /// A polygon that crosses itself.
    CrossesItself,
    /// A csg of which nothing is left.
    EmptyCsg,
    /// A part that nothing uses.
    UnusedPart,
    /// A file of materials that is not there.
    MissingLibrary,
    /// A material that no file describes.
    MissingMaterial,
    /// Corner normals on the other side than the order of the corners says, which are not used.
    NormalsAgainstWinding,
    /// A coefficient of a material above 1.
    ShareAboveOne,
    /// A material whose coefficients add up to more than 1.
    SumAboveOne,
    /// A colour of light from 0 to 255.
    #[serde(rename = "color-to-255")]
    #[strum(serialize = "color-to-255")]
    ColorTo255,
    /// An angle in radians where degrees are asked.
    AngleInRadians,
    /// No light on what shows nothing but light.
    NoLight,
    /// A light that cannot be seen on anything.
    LightOfNoUse,
    /// A closed transparent body with its faces turned inwards.
    InsideOut,
    /// A transparent body some of whose faces are turned over.
    MixedWinding,
    /// A transparent body that is open.
    OpenBody,
    /// Transparent objects of equal priority that overlap in part.
    EqualPriority,
    /// An eye inside of something opaque, with all light outside.
    EyeInside,
    /// A lamp inside of something opaque.
    LampInside,
    /// A camera that sees no object.
    NothingInView,
    /// Bytes of a file that are no UTF-8 text.
    NotUtf8,
    /// A face that crosses itself, or has too many corners, so that its triangles are a guess.
    GuessedFace,
    /// A corner of a face that names texture coordinates or a normal that are not there.
    DanglingIndex,
    /// Texture coordinates, a normal or a weight that are no usable numbers.
    BadVertexData,
    /// Colours of points, which are not drawn.
    VertexColors,
    /// Faces in a smoothing group that have no normals.
    SmoothingGroup,
    /// Statements of a model or of its materials that are not read.
    LeftOut,
    /// `usemtl` without a name.
    NoMaterialName,
    /// The path of a file of materials that leads elsewhere, where one of that name lies beside the model.
    LibraryPath,
    /// A line about a material that cannot be read.
    UnreadLine,
    /// A number of a material beyond its range.
    Clamped,
    /// A picture on a surface, which is not drawn.
    Texture,
    /// A material whose `d` and `Tr` contradict each other.
    OpacityConflict,
    /// A material that is wholly transparent.
    Invisible,
    /// A colour of transmission in a material that is opaque.
    OpaqueFilter,
    /// More numbers than are read, or an option beside them.
    ExtraNumbers,
    /// A name in a model that is too long to be shown, or has control characters.
    ChangedName,
    /// Rays that a limit left out, with much of the picture's light.
    RaysCut,
    /// More kinds of warnings than are kept.
    MoreWarnings,
}

impl WarningCode {
    /// Its name, as in `no-area`.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = match self.count {
            1 => String::new(),
            n => format!(" ({n} times, this is the first)"),
        };
        let (what, cure) = (first_line(&self.problem), shown(&self.problem.problem.cure));
        write!(f, "{what}{count} [{}]\n  {cure}", self.code.name())
    }
}

/// Warnings as they are found. Those of one code, file and text are one, with a count.
#[derive(Clone, Debug, Default)]
pub struct Warnings {
    kept: Vec<Warning>,
    more: u64,
}

impl Warnings {
    /// Adds a warning.
    pub fn add(&mut self, code: WarningCode, problem: SceneError) {
        self.add_many(code, problem, 1);
    }

    /// Adds a warning that was found `count` times, the first time where it says.
    pub fn add_many(&mut self, code: WarningCode, problem: SceneError, count: u64) {
        let same = |kept: &&mut Warning| {
            let (a, b) = (&kept.problem, &problem);
            kept.code == code && a.problem.what == b.problem.what && a.file == b.file
        };
        if let Some(kept) = self.kept.iter_mut().find(same) {
            kept.count += count;
        } else if self.kept.len() < MAX_WARNINGS {
            let warning = Warning {
                code,
                problem,
                count,
            };
            self.kept.push(warning);
        } else {
            self.more += count;
        }
    }

    /// The warnings, with a last one for those that were not kept.
    pub fn into_list(mut self, scene: &str) -> Vec<Warning> {
        if self.more > 0 {
            let problem = super::error::Problem::new(
                format!("and {} more warnings", self.more),
                "mend those above first",
            );
            self.kept.push(Warning {
                code: WarningCode::MoreWarnings,
                problem: problem.in_file(scene),
                count: 1,
            });
        }
        self.kept
    }
}

#[cfg(test)]
mod tests {
    use super::super::error::Problem;
    use super::*;

    fn warnings(count: usize) -> Vec<Warning> {
        let mut warnings = Warnings::default();
        for i in 0..count {
            let problem = Problem::new(format!("{i}\n"), "mend it").in_line("a.obj", i + 1);
            warnings.add(WarningCode::NoArea, problem);
        }
        warnings.into_list("a.json")
    }

    #[test]
    fn the_first_are_kept_and_the_others_counted() {
        assert_eq!(warnings(MAX_WARNINGS).len(), MAX_WARNINGS);
        let more = warnings(MAX_WARNINGS + 3);
        assert_eq!(more.len(), MAX_WARNINGS + 1);
        let text = more[MAX_WARNINGS].to_string();
        assert!(text.starts_with("a.json: and 3 more warnings [more-warnings]"));
    }

    #[test]
    fn a_warning_says_where_what_how_often_and_the_cure() {
        let text = warnings(2)[1].to_string();
        assert_eq!(text, "a.obj:2: 1\\n [no-area]\n  mend it");
        let mut twice = Warnings::default();
        for line in [3, 9] {
            twice.add(
                WarningCode::NoArea,
                Problem::new("odd", "mend it").in_line("a.obj", line),
            );
        }
        let text = twice.into_list("a.json")[0].to_string();
        assert_eq!(
            text,
            "a.obj:3: odd (2 times, this is the first) [no-area]\n  mend it"
        );
    }
}
