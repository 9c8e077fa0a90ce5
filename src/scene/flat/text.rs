//! A flat scene as lines of words and numbers, for languages without a reader of JSON.
//!
//! A line is a kind, a name, numbers, then for a shape the name of its material, then what only some shapes have, each behind its
//! own word (`normals`, `uvs`, `axes`), or the word alone (`gouraud`). A program passes over lines, and words at the end of lines, that it does not know.

use std::fmt::Write as _;
use std::io::{self, Write};

use super::{FlatLight, FlatMaterial, FlatObject, FlatScene, head, objects};
use crate::geometry::Shape;
use crate::math::Rgb;
use crate::scene::Scene;
use crate::scene::error::{Problem, SceneError};
use crate::scene::file::Triple;
use crate::scene::printable::is_printable;
use crate::shading::ShadingModel;

/// An error if the text form cannot say the scene. A shape that was stretched or turned takes a way to the world, and a program
/// that passes over it would draw something else. Solids of more than a few numbers are said in JSON only.
pub fn check_text(scene: &Scene) -> Result<(), SceneError> {
    let problem = |shape: &Shape| match shape.plain() {
        Shape::Body(_) | Shape::Patch(_) => Some(format!("is a {}", shape.kind())),
        Shape::Transformed(moved) => Some(match &moved.shape {
            Shape::Body(body) => format!("is a {}", body.kind()),
            // It stands there as triangles.
            Shape::Mesh(_) => return None,
            _ => "was stretched or turned".to_owned(),
        }),
        _ => None,
    };
    let mut all = scene.shapes.iter().map(problem).zip(0..);
    let Some((problem, primitive)) = all.find_map(|(p, i)| Some((p?, i))) else {
        return Ok(());
    };
    let name = &scene.object_of(primitive).name;
    let problem = Problem::new(
        format!("`{name}` {problem}, which the text form cannot say"),
        "take the JSON form (`--flat`), or leave out the object or its transform",
    );
    Err(problem.in_file(&scene.name))
}

/// Writes a scene as text; [`check_text`] tells whether all of it can be said.
pub fn write_text(out: &mut dyn Write, scene: &Scene) -> io::Result<()> {
    let head = head(scene);
    for line in general(&head) {
        writeln!(out, "{line}")?;
    }
    for material in &head.materials {
        for line in of_material(material) {
            writeln!(out, "{line}")?;
        }
    }
    for light in &head.lights {
        writeln!(out, "{}", of_light(light))?;
    }
    for object in objects(scene) {
        writeln!(out, "{}", of_object(&object))?;
    }
    Ok(())
}

/// A line that grows at its end.
struct Line(String);

impl Line {
    fn new(kind: &str) -> Self {
        Self(kind.to_owned())
    }

    fn named(kind: &str, name: &str) -> Self {
        Self::new(kind).word(name)
    }

    /// A name: spaces and what cannot be seen as %20 and the like, byte by byte, so that it is one word.
    fn word(mut self, name: &str) -> Self {
        self.0.push(' ');
        for c in name.chars() {
            if is_printable(c) && !" %".contains(c) {
                self.0.push(c);
                continue;
            }
            for byte in c.encode_utf8(&mut [0; 4]).bytes() {
                // Writing to a string cannot fail.
                let _ = write!(self.0, "%{byte:02X}");
            }
        }
        self
    }

    fn numbers(mut self, numbers: impl IntoIterator<Item = f64>) -> Self {
        for x in numbers {
            // No minus before a zero.
            let _ = write!(self.0, " {}", x + 0.0);
        }
        self
    }

    /// A word, if there is one.
    fn flagged(self, word: Option<&str>) -> Self {
        match word {
            Some(word) => self.word(word),
            None => self,
        }
    }

    /// A word and its numbers, if there are any.
    fn tagged<const N: usize, const M: usize>(
        self,
        tag: &str,
        rows: Option<[[f64; N]; M]>,
    ) -> Self {
        match rows {
            Some(rows) => self.word(tag).numbers(rows.into_iter().flatten()),
            None => self,
        }
    }
}

/// What is there once.
fn general(head: &FlatScene) -> [String; 9] {
    let (settings, camera) = (&head.settings, &head.camera);
    let fresnel = format!("{:?}", settings.fresnel).to_lowercase();
    [
        Line::new("format raytree-flat/1"),
        Line::named("name", &head.name),
        Line::new("depth").numbers([f64::from(settings.depth)]),
        Line::new("min_weight").numbers([settings.min_weight]),
        Line::named("fresnel", &fresnel),
        Line::new("exposure").numbers([settings.exposure]),
        Line::new("background").numbers(head.background.channels()),
        Line::new("ambient").numbers(head.ambient.channels()),
        Line::new("camera")
            .numbers(
                [camera.eye, camera.u, camera.v, camera.w]
                    .into_iter()
                    .flatten(),
            )
            .numbers([camera.half_height]),
    ]
    .map(|line| line.0)
}

/// `material NAME ka kd ks shininess kr kt ior priority le`, and `checker MATERIAL kd ka size`.
fn of_material(m: &FlatMaterial) -> impl Iterator<Item = String> {
    let reflected = [m.ambient, m.diffuse, m.specular];
    let sent = [m.mirror, m.transmission];
    let line = Line::named("material", &m.name)
        .numbers(reflected.into_iter().flat_map(Rgb::channels))
        .numbers([m.shininess])
        .numbers(sent.into_iter().flat_map(Rgb::channels))
        .numbers([m.ior, f64::from(m.priority)])
        .numbers(m.emission.channels());
    let checker = m.checker.as_ref().map(|checker| {
        Line::named("checker", &m.name)
            .numbers(checker.diffuse.channels())
            .numbers(checker.ambient.channels())
            .numbers([checker.size])
    });
    [Some(line), checker]
        .into_iter()
        .flatten()
        .map(|line| line.0)
}

fn of_light(light: &FlatLight) -> String {
    let line = match light {
        FlatLight::Point {
            name,
            position,
            intensity,
            attenuation,
        } => Line::named("point", name)
            .numbers(*position)
            .numbers(intensity.channels())
            .numbers(*attenuation),
        FlatLight::Directional {
            name,
            direction,
            intensity,
        } => Line::named("directional", name)
            .numbers(*direction)
            .numbers(intensity.channels()),
        FlatLight::Spot {
            name,
            position,
            direction,
            intensity,
            attenuation,
            cos_cutoff,
            exponent,
        } => Line::named("spot", name)
            .numbers(*position)
            .numbers(*direction)
            .numbers(intensity.channels())
            .numbers(*attenuation)
            .numbers([*cos_cutoff, *exponent]),
        FlatLight::Area { name, object } => Line::named("area", name).word(object),
    };
    line.0
}

fn of_object(object: &FlatObject) -> String {
    let line = match object {
        FlatObject::Triangle {
            name,
            corners,
            normals,
            shading,
            uvs,
            material,
            ..
        } => of_corners(name, corners)
            .word(material)
            .tagged("normals", *normals)
            .tagged("uvs", *uvs)
            .flagged(shading.map(ShadingModel::word)),
        FlatObject::Sphere {
            name,
            center,
            radius,
            material,
            ..
        } => Line::named("sphere", name)
            .numbers(*center)
            .numbers([*radius])
            .word(material),
        FlatObject::Plane {
            name,
            point,
            normal,
            axes,
            material,
        } => Line::named("plane", name)
            .numbers(*point)
            .numbers(*normal)
            .word(material)
            .tagged("axes", *axes),
        FlatObject::Box {
            name,
            min,
            max,
            material,
            ..
        } => Line::named("box", name)
            .numbers(*min)
            .numbers(*max)
            .word(material),
        FlatObject::Polygon {
            name,
            loops,
            axes,
            material,
            ..
        } => of_loops(name, loops).word(material).tagged("axes", *axes),
        FlatObject::Disc {
            name,
            center,
            normal,
            radius,
            axes,
            material,
            ..
        } => Line::named("disc", name)
            .numbers(center.iter().chain(normal).chain([radius]).copied())
            .word(material)
            .tagged("axes", *axes),
        // `check_text` refuses all others.
        other => Line::named("solid", other.name()),
    };
    line.0
}

/// `triangle NAME` and its corners.
fn of_corners(name: &str, corners: &[Triple; 3]) -> Line {
    Line::named("triangle", name).numbers(corners.iter().copied().flatten())
}

/// `polygon NAME loops`, then for each loop the number of its corners and these.
fn of_loops(name: &str, loops: &[Vec<Triple>]) -> Line {
    let line = Line::named("polygon", name).numbers([loops.len() as f64]);
    loops.iter().fold(line, |line, corners| {
        line.numbers([corners.len() as f64])
            .numbers(corners.iter().copied().flatten())
    })
}
