//! Trees for people: reasons in words, numbers of things with the right ending, no sign before nothing.

use raytree::accel::AccelKind;
use raytree::probe::AbsenceReason;
use raytree::scene;
use raytree::trace::export::{Dot, Html, Svg, Text, json};
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::world::World;
use strum::VariantNames as _;

fn traced(name: &str, at: (u32, u32), samples: u32) -> Document {
    let world = World::new(scene::load(name).expect("built in"), AccelKind::Bsp);
    let settings = world.scene.settings.with(|s| {
        (s.image.width, s.image.height) = (32, 24);
        s.light.samples = samples;
        s.recursion.depth = 2;
    });
    let trace = trace_pixel(&world, &settings, at, true);
    document::of(View {
        world: &world,
        settings: &settings,
        trace: &trace,
    })
}

#[test]
fn reasons_and_numbers_are_plain_words_in_every_format_for_people() {
    let mut reasons = std::collections::BTreeSet::new();
    for (name, samples) in [
        ("whitted", 1),
        ("nested-glass", 1),
        ("soft-shadow", 1),
        ("lamps", 4),
        ("triangle", 1),
    ] {
        for at in [(16, 12), (10, 14), (20, 18), (1, 1)] {
            let document = traced(name, at, samples);
            let mut written = Vec::new();
            json::write(&mut written, &document).expect("written");
            let written = String::from_utf8(written).expect("UTF-8");
            let text = Text(&document).to_string();
            let drawing = "";
            let page = Html {
                document: &document,
                drawing,
            }
            .to_string();
            let pictures = [Svg(&document).to_string(), Dot(&document).to_string()];
            for shown in [&text, &page, &pictures[0], &pictures[1]] {
                for slug in AbsenceReason::VARIANTS.iter().chain(&["too-far"]) {
                    assert!(!shown.contains(slug), "{name} {at:?}: {slug}");
                }
                for plural in ["1 rays", "1 samples", "1 steps"] {
                    for before in [" ", "(", ">"] {
                        assert!(
                            !shown.contains(&format!("{before}{plural}")),
                            "{name} {at:?}: {plural}"
                        );
                    }
                }
                assert!(!shown.contains("-0.0 %"), "{name} {at:?}");
            }
            for slug in AbsenceReason::VARIANTS {
                if written.contains(&format!("\"{slug}\"")) {
                    reasons.insert(*slug);
                    let reason = serde_json::from_str(&format!("\"{slug}\""));
                    let reason: AbsenceReason = reason.expect("a reason");
                    assert!(
                        text.contains(&format!(": {}\n", reason.words())),
                        "{name} {at:?}: {slug}"
                    );
                }
            }
        }
    }
    assert!(reasons.len() >= 4, "{reasons:?}");
    assert!(
        Text(&traced("triangle", (1, 1), 1))
            .to_string()
            .contains(", 1 ray\n")
    );
}
