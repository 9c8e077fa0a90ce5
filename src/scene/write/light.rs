//! Light in a scene file.

use super::fields::Fields;
use super::inverse::{angle, point_along};
use crate::scene::{Scene, flat};
use crate::shading::{Light, LightKind};

/// A light, or why it cannot be written.
pub fn light(scene: &Scene, light: &Light) -> Result<String, String> {
    let name = &light.name;
    let fields = Fields::default().text("name", name);
    Ok(match &light.kind {
        LightKind::Point {
            position,
            intensity,
            attenuation,
        } => fields
            .row("position", &position.to_array())
            .row("intensity", &intensity.channels())
            .row("attenuation", attenuation)
            .kind("point"),
        LightKind::Directional {
            direction,
            intensity,
        } => fields
            .row("direction", &direction.to_array())
            .row("intensity", &intensity.channels())
            .kind("directional"),
        LightKind::Spot {
            position,
            direction,
            intensity,
            attenuation,
            cos_cutoff,
            exponent,
        } => {
            let look_at = point_along(*position, *direction);
            let look_at =
                look_at.ok_or_else(|| format!("no point gives the axis of light `{name}`"))?;
            let cos = |degrees: f64| libm::cos(degrees.to_radians());
            let near = libm::acos(*cos_cutoff).to_degrees();
            let cone = angle(near, *cos_cutoff, cos).filter(|cone| (0.0..=180.0).contains(cone));
            let cone = cone.ok_or_else(|| format!("no angle gives the cone of light `{name}`"))?;
            fields
                .row("position", &position.to_array())
                .row("look_at", &look_at.to_array())
                .row("intensity", &intensity.channels())
                .row("attenuation", attenuation)
                .number("cone_angle", cone)
                .number("exponent", *exponent)
                .kind("spot")
        }
        LightKind::Area(area) => {
            let object = flat::shining(scene, area).map(|o| &scene.objects[o as usize].name);
            let object = object.ok_or_else(|| format!("no object shines as light `{name}`"))?;
            fields.text("object", object).kind("area")
        }
    })
}
