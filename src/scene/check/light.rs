//! Light that is not there, and lights that cannot show.

use crate::math::Rgb;
use crate::scene::Scene;
use crate::scene::read::error::FieldPath;
use crate::scene::warning::{WarningCode, Warnings};
use crate::shading::{LightKind, Material};

/// Warns if some object shows nothing but light that falls on it, and none does.
pub fn nothing_shines(scene: &Scene, path: &FieldPath, warnings: &mut Warnings) {
    let any = |object: usize, is: &dyn Fn(&Material) -> bool| {
        scene.materials_of(&scene.objects[object]).any(is)
    };
    let lit = scene
        .lights
        .iter()
        .any(|light| !strength(&light.kind).is_black());
    let ambient = |m: &Material| {
        let checker = m.checker.as_ref().map_or(Rgb::BLACK, |c| c.ambient);
        !(m.ambient * scene.ambient).is_black() || !(checker * scene.ambient).is_black()
    };
    let all = 0..scene.objects.len();
    if lit || all.clone().any(|o| any(o, &ambient)) {
        return;
    }
    let shows_only_light = |m: &Material| m.shows_lights() && !m.sends_rays() && !m.is_emissive();
    let mut black = all.clone().filter(|o| any(*o, &shows_only_light));
    let Some(first) = black.next() else {
        return;
    };
    let name = &scene.objects[first].name;
    let more = match black.count() {
        0 => String::new(),
        n => format!(" and {n} more"),
    };
    let what = format!("no light falls on `{name}`{more}: there is no light and no ambient light");
    let cure = if let Some(lamp) = all.clone().find(|o| any(*o, &Material::is_emissive)) {
        let name = &scene.objects[lamp].name;
        format!(
            "what shines by itself lights nothing until it is a light: {{\"area\": {{\"name\": \"lamp\", \"object\": \"{name}\"}}}}"
        )
    } else {
        let [x, y, z] = scene.camera.eye.to_array();
        format!(
            "add one to \"lights\": {{\"point\": {{\"name\": \"lamp\", \"position\": [{x}, {y}, {z}], \"intensity\": [1, 1, 1]}}}}"
        )
    };
    warnings.add(WarningCode::NoLight, path.key("lights").error(what, cure));
}

/// Warns about lights of no strength, and about all lights if no object shows them.
pub fn of_no_use(scene: &Scene, path: &FieldPath, warnings: &mut Warnings) {
    let path = path.key("lights");
    for (i, light) in scene.lights.iter().enumerate() {
        if strength(&light.kind).is_black() {
            let what = format!("light `{}` has no strength: it lights nothing", light.name);
            let cure = "give it an intensity above 0, or leave it out";
            warnings.add(WarningCode::LightOfNoUse, path.index(i).error(what, cure));
        }
    }
    let mut used = scene.objects.iter().flat_map(|o| scene.materials_of(o));
    if !scene.lights.is_empty() && !scene.objects.is_empty() && !used.any(Material::shows_lights) {
        let what = "no object shows the lights: no material has `diffuse` or `specular`";
        let cure = "give a material `diffuse`, or leave the lights out";
        warnings.add(WarningCode::LightOfNoUse, path.error(what, cure));
    }
}

/// What a light sends out, before attenuation.
fn strength(light: &LightKind) -> Rgb {
    match light {
        LightKind::Point { intensity, .. }
        | LightKind::Directional { intensity, .. }
        | LightKind::Spot { intensity, .. } => *intensity,
        LightKind::Area(area) => area.radiance,
    }
}
