//! Lights that reach nothing that is seen.

use super::Checked;
use crate::geometry::{Plane, Shape};
use crate::math::DVec3;
use crate::scene::warning::{WarningCode, Warnings};
use crate::shading::{LightKind, Material};

/// Warns about lights on the other side of an endless opaque plane than the eye: it is in their way, whatever is seen.
pub fn behind_planes(checked: &Checked, warnings: &mut Warnings) {
    let scene = &checked.world.scene;
    let planes = scene
        .shapes
        .iter()
        .zip(&scene.owners)
        .filter_map(|(shape, owner)| {
            let object = &scene.objects[*owner as usize];
            let opaque = !scene.materials[object.material as usize].is_transmissive();
            match shape.plain() {
                Shape::Plane(plane) if opaque => Some((&**plane, &object.name)),
                _ => None,
            }
        });
    let planes: Vec<(&Plane, &String)> = planes.collect();
    for (i, light) in scene.lights.iter().enumerate() {
        let hides =
            |(plane, _): &&(&Plane, &String)| is_behind(&light.kind, plane, scene.camera.eye);
        if let Some((_, plane)) = planes.iter().find(hides) {
            let what = format!(
                "light `{}` is behind the plane `{plane}`, seen from the eye: it lights nothing that is seen",
                light.name
            );
            let cure = "move it to the eye's side of the plane";
            let path = checked.path.key("lights").index(i);
            warnings.add(WarningCode::LightOfNoUse, path.error(what, cure));
        }
    }
}

/// True if all of a light is on the other side of a plane than the eye.
fn is_behind(light: &LightKind, plane: &Plane, eye: DVec3) -> bool {
    let height = |p: DVec3| (p - plane.origin()).dot(plane.normal());
    let above = height(eye).signum();
    // As near to it as that, rounding may decide.
    let below = |p: DVec3| height(p) * above < -1e-6 * (p - plane.origin()).length();
    match light {
        LightKind::Point { position, .. } | LightKind::Spot { position, .. } => below(*position),
        LightKind::Directional { direction, .. } => direction.dot(plane.normal()) * above > 1e-6,
        LightKind::Area(area) => area.bounds.corners().into_iter().all(below),
    }
}

/// Warns about spot lights in whose cone nothing is that shows lights.
pub fn cones(checked: &Checked, warnings: &mut Warnings) {
    let scene = &checked.world.scene;
    let material = |owner: u32| &scene.materials[scene.objects[owner as usize].material as usize];
    let showing =
        |(shape, owner): (_, &u32)| Material::shows_lights(material(*owner)).then_some(shape);
    for (i, light) in scene.lights.iter().enumerate() {
        let LightKind::Spot {
            position,
            direction,
            cos_cutoff,
            ..
        } = light.kind
        else {
            continue;
        };
        let cone = Cone {
            apex: position,
            axis: direction,
            angle: libm::acos(cos_cutoff.clamp(-1.0, 1.0)),
        };
        let mut shapes = scene
            .shapes
            .iter()
            .zip(&scene.owners)
            .filter_map(showing)
            .peekable();
        if shapes.peek().is_some() && shapes.all(|shape| cone.misses(shape)) {
            let what = format!(
                "nothing that shows light is in the cone of light `{}`",
                light.name
            );
            let cure = "turn it (`look_at`), or widen its `cone_angle` (degrees from the axis to the edge)";
            let path = checked.path.key("lights").index(i).key("spot");
            warnings.add(WarningCode::LightOfNoUse, path.error(what, cure));
        }
    }
}

/// The part of space that a spot light shines into.
struct Cone {
    apex: DVec3,
    axis: DVec3,
    /// From the axis to the edge, in radians.
    angle: f64,
}

impl Cone {
    /// True if the shape lies outside, for sure: a ball around it does, or the cone runs away from the plane.
    fn misses(&self, shape: &Shape) -> bool {
        const MARGIN: f64 = 1e-6;
        let between = |a: DVec3, b: DVec3| libm::acos(a.dot(b).clamp(-1.0, 1.0));
        if let Shape::Plane(plane) = shape.plain() {
            let side = (self.apex - plane.origin()).dot(plane.normal()).signum();
            let towards = -side * plane.normal();
            return between(self.axis, towards) - self.angle > std::f64::consts::FRAC_PI_2 + MARGIN;
        }
        shape.bounds().is_some_and(|bounds| {
            let way = bounds.center() - self.apex;
            let (distance, radius) = (way.length(), 0.5 * bounds.size().length());
            distance > radius
                && between(self.axis, way / distance) - libm::asin(radius / distance)
                    > self.angle + MARGIN
        })
    }
}
