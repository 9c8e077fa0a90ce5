//! The function of this program that does what an event tells.

use crate::accel::AccelKind;
use crate::probe::{Event, RayKind, Term};
use crate::trace::View;

/// A function, and the file that it stands in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SourcePlace {
    /// From the top of the repository.
    pub file: &'static str,
    /// Its name.
    pub function: &'static str,
}

const fn place(file: &'static str, function: &'static str) -> SourcePlace {
    SourcePlace { file, function }
}

/// Where the code of an event is.
pub fn source(view: View, event: &Event) -> SourcePlace {
    match event {
        Event::Sample { .. } => place("src/tracer/pixel/camera_sample.rs", "camera_sample"),
        Event::Ray(sent) => sender(sent.kind),
        Event::Visit(_) => traversal(view.settings.accel),
        Event::Test { primitive, .. } => {
            let shape = view.world.scene.shapes.get(*primitive as usize);
            intersection(shape.map_or("", |shape| shape.kind()))
        }
        Event::LightSamples { .. } => place("src/tracer/direct.rs", "add_area_light"),
        Event::Hit(_) => place("src/shading/interaction.rs", "new"),
        Event::Miss => place("src/tracer/whitted.rs", "background"),
        Event::Lit | Event::Blocked(_) => place("src/tracer/direct.rs", "is_occluded"),
        Event::Term { term, .. } => match term {
            Term::Ambient { .. } => place("src/shading/point.rs", "ambient"),
            Term::Emission { .. } => place("src/shading/point.rs", "emitted"),
            Term::Blended { .. } => place("src/tracer/corners.rs", "blended"),
            Term::Background { .. } => place("src/tracer/whitted.rs", "background"),
            _ => place("src/shading/point.rs", "eval"),
        },
        Event::Passed { .. } => place("src/world/interface.rs", "next_interface"),
        Event::Boundary { .. } => place("src/shading/optics.rs", "reflectance"),
        Event::Absent { kind, .. } => sender(*kind),
        Event::Return { .. } => place("src/tracer/whitted.rs", "shade"),
    }
}

/// Where it is decided whether and where a ray is sent.
fn sender(kind: RayKind) -> SourcePlace {
    match kind {
        RayKind::Incident => place("src/scene/camera.rs", "ray"),
        RayKind::Light => place("src/tracer/light_sampler.rs", "shadow_ray"),
        RayKind::Reflected => place("src/shading/point.rs", "reflected"),
        RayKind::Transmitted => place("src/shading/point.rs", "transmitted"),
    }
}

/// The walk through an acceleration structure.
fn traversal(accel: AccelKind) -> SourcePlace {
    match accel {
        AccelKind::List => place("src/accel/list.rs", "search"),
        AccelKind::Bsp | AccelKind::BspAxis | AccelKind::BspPolygon => {
            place("src/accel/bsp/traverse.rs", "search")
        }
        AccelKind::BspSah | AccelKind::Kd => place("src/accel/fast/compact/traverse.rs", "search"),
        AccelKind::Grid => place("src/accel/grid.rs", "search"),
        AccelKind::Octree | AccelKind::Bvh | AccelKind::BvhSpheres => {
            place("src/accel/bvh/traverse.rs", "search")
        }
        AccelKind::Wide => place("src/accel/fast/bvh8/single.rs", "search"),
    }
}

/// The test of a ray against a shape of a kind.
fn intersection(kind: &str) -> SourcePlace {
    let file = match kind {
        "triangle" => "src/geometry/triangle.rs",
        "sphere" => "src/geometry/sphere.rs",
        "plane" => "src/geometry/plane.rs",
        "box" => "src/geometry/cuboid.rs",
        "disc" => "src/geometry/disc.rs",
        "polygon" => "src/geometry/polygon.rs",
        "cylinder" | "cone" | "paraboloid" | "hyperboloid" => "src/geometry/quadric.rs",
        "quadric" => "src/geometry/quadric/boxed.rs",
        "torus" => "src/geometry/torus.rs",
        "quartic" => "src/geometry/quartic.rs",
        "csg" => "src/geometry/shape/csg.rs",
        "mesh" => "src/geometry/shared_mesh.rs",
        "patch" => "src/geometry/patch.rs",
        _ => "src/geometry/shape.rs",
    };
    place(file, "intersect")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;
    use crate::scene::load;
    use crate::trace::trace_pixel;
    use crate::world::World;

    /// Every place of every event of some pixels: the file is there and has the function.
    #[test]
    fn the_places_are_there() {
        let mut places = BTreeSet::new();
        for (name, at) in [
            ("whitted", (32, 24)),
            ("nested-glass", (30, 24)),
            ("glass-block", (32, 24)),
            ("soft-shadow", (24, 36)),
            ("room", (32, 30)),
            ("gouraud", (32, 24)),
        ] {
            for accel in AccelKind::ALL {
                let world = World::new(load(name).expect(name), accel);
                let settings = world.scene.settings.with(|s| {
                    (s.image.width, s.image.height) = (64, 48);
                    s.accel = accel;
                    s.light.samples = 4;
                });
                let trace = trace_pixel(&world, &settings, at, true);
                let view = View {
                    world: &world,
                    settings: &settings,
                    trace: &trace,
                };
                let events = trace.tree.events.iter();
                places.extend(
                    events
                        .map(|event| source(view, event))
                        .map(|p| (p.file, p.function)),
                );
            }
        }
        assert!(places.len() >= 18, "{places:?}");
        for (file, function) in places {
            let shown = crate::trace::explain::source_text(SourcePlace { file, function });
            assert!(
                shown.is_some(),
                "{function} in {file} is not in the list of files"
            );
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
            let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{file}: {e}"));
            let heads = [format!("fn {function}("), format!("fn {function}<")];
            assert!(
                heads.iter().any(|head| text.contains(head)),
                "{function} in {file}"
            );
        }
    }
}
