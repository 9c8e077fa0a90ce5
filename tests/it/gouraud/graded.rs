//! Trees of a scene with Gouraud's model, compared with others.

use raytree::accel::AccelKind;
use raytree::grade::diff::TreeDiff;
use raytree::grade::follow::PixelReference;
use raytree::grade::tolerance::Tolerances;
use raytree::probe::TermKind;
use raytree::scene::effects::effects;
use raytree::scene::{self, Settings};
use raytree::shading::ShadingModel;
use raytree::trace::facts::{FactName, PixelFacts, pixel_facts};
use raytree::trace::{document, trace_pixel};
use raytree::world::World;

use super::{by, view};

fn facts(world: &World, settings: &Settings, at: (u32, u32)) -> PixelFacts {
    let trace = trace_pixel(world, settings, at, false);
    pixel_facts(&document::of(view(world, settings, &trace)))
}

#[test]
fn a_tree_by_phong_is_told_which_term_differs() {
    let scene = scene::load("gouraud").expect("built in");
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (65, 49);
        s.effects = effects(&scene);
    });
    let world = World::new(scene, AccelKind::Bsp);
    let compare = |theirs: &Settings, at| {
        let ours = facts(&world, &settings, at);
        let of = PixelReference {
            scene: Some((&world, &settings)),
            pixel: at,
            facts: &ours,
        };
        TreeDiff::new(
            of,
            &facts(&world, theirs, at),
            &Tolerances::default(),
            &|_| true,
        )
    };
    let mut told = 0;
    for at in (0..49)
        .flat_map(|y| (0..65).map(move |x| (x, y)))
        .step_by(7)
    {
        let own = compare(&settings, at);
        assert!(
            own.is_empty() && own.causes.is_empty(),
            "{at:?}: {:?}",
            own.causes
        );
        let phong = compare(&by(&settings, ShadingModel::Phong), at);
        for name in phong.causes.iter().map(|cause| &cause.first.name) {
            assert!(
                matches!(
                    name,
                    FactName::Term(..)
                        | FactName::CornerValue(..)
                        | FactName::Normal
                        | FactName::Shines(_)
                ),
                "{at:?}: {name:?}"
            );
        }
        told += u32::from(!phong.causes.is_empty());
    }
    assert!(told > 30, "{told}");
    // In the middle of the triangle it is the highlight.
    let phong = compare(&by(&settings, ShadingModel::Phong), (32, 24));
    let specular = FactName::Term(TermKind::Specular, Some("lamp".into()), 0);
    let all = phong.causes.iter();
    let all = all.flat_map(|cause| std::iter::once(&cause.first).chain(&cause.also));
    let names: Vec<&FactName> = all.map(|compared| &compared.name).collect();
    assert!(names.contains(&&specular), "{names:?}");
}
