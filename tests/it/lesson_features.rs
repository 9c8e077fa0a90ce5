//! Features of the lessons: what a chapter does not enable is switched off as a user would do it, costs nothing, and is told.

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use raytree::lesson::off::off;
use raytree::lesson::{Chapter, Course, Feature};
use raytree::probe::{Event, RayKind};
use raytree::scene::Settings;
use raytree::scene::effects::effects;
use raytree::scene::settings::knobs::set_knob;
use raytree::trace::{Counts, View, document, trace_pixel};
use raytree::tracer::{draw, render};
use raytree::world::World;
use strum::VariantArray as _;

/// A chapter of the embedded course with its scene, in a small picture.
struct Drawn {
    chapter: Chapter,
    world: World,
    settings: Settings,
}

fn small(settings: Settings) -> Settings {
    settings.with(|s| (s.image.width, s.image.height) = (48, 36))
}

fn chapters(course: &Course) -> Vec<Drawn> {
    let chapters = course.chapters.iter();
    let drawn = chapters.map(|chapter| {
        let stage = course.stage(chapter, None, &[]).expect("a stage");
        let scene = stage.world.scene.clone();
        Drawn {
            chapter: chapter.clone(),
            world: World::new(scene, stage.settings.accel),
            settings: small(stage.settings),
        }
    });
    drawn.collect()
}

/// Flags that leave out a feature, as a user types them.
fn flags_without(feature: Feature) -> &'static [(&'static str, &'static str)] {
    match feature {
        Feature::Smooth => &[("without", "smooth")],
        Feature::Ambient => &[("without", "ambient")],
        Feature::Diffuse => &[("without", "diffuse")],
        Feature::Highlights => &[("without", "highlights")],
        Feature::Shadows => &[("without", "shadows")],
        Feature::Reflection => &[("without", "reflection")],
        Feature::Refraction => &[("without", "refraction")],
        Feature::SoftShadows => &[("without", "soft-shadows")],
        Feature::Tree => &[("depth", "1")],
        Feature::Fresnel => &[("fresnel", "none")],
        Feature::Samples => &[("samples", "1")],
        Feature::LightRandom => &[("sampler", "grid")],
        _ => &[],
    }
}

fn bits(world: &World, settings: &Settings) -> Vec<[u64; 3]> {
    let pixels = draw(world, settings, 2).pixels;
    let bits = pixels.iter().map(|p| p.channels().map(f64::to_bits));
    bits.collect()
}

#[test]
fn a_chapters_picture_is_that_with_all_later_features_switched_off_by_flags() {
    let course = Course::embedded().expect("the course");
    let mut changes = BTreeSet::new();
    for Drawn {
        chapter,
        world,
        settings,
    } in chapters(&course)
    {
        let whole = small(
            world
                .scene
                .settings
                .with(|s| s.effects = effects(&world.scene)),
        );
        let mut by_hand = whole;
        let later = Feature::VARIANTS
            .iter()
            .filter(|f| !chapter.features.has(**f));
        for (flag, value) in later.flat_map(|f| flags_without(*f)) {
            set_knob(&mut by_hand, flag, value).expect("a flag");
        }
        for (flag, value) in &chapter.settings {
            set_knob(&mut by_hand, flag, value).expect("a flag");
        }
        let by_hand = small(by_hand);
        let drawn = bits(&world, &settings);
        assert!(drawn == bits(&world, &by_hand), "{}", chapter.folder);
        // In some chapters this is another picture than that of all features.
        if drawn != bits(&world, &whole) {
            changes.insert(chapter.number);
        }
    }
    assert!(changes.len() >= 5, "{changes:?}");
}

#[test]
fn what_is_not_enabled_is_not_done() {
    let course = Course::embedded().expect("the course");
    let (mut mirrors, mut glass) = (0, 0);
    for Drawn {
        chapter,
        world,
        settings,
    } in chapters(&course)
    {
        let (_, counts) = render::<Counts>(&world, &settings, 2, &|_, _| ControlFlow::Continue(()));
        let counts = counts.iter().fold(Counts::default(), Counts::plus);
        let has = |feature| chapter.features.has(feature);
        let name = &chapter.folder;
        let shows_lights = has(Feature::Diffuse) || has(Feature::Highlights);
        if !(has(Feature::Shadows) && shows_lights) {
            assert_eq!(counts.light, 0, "{name}");
        }
        if !has(Feature::Reflection) {
            assert_eq!(counts.reflected, 0, "{name}");
        }
        if !has(Feature::Refraction) {
            assert_eq!(counts.transmitted, 0, "{name}");
        }
        let is_set = |flag: &str| chapter.settings.iter().any(|(name, _)| name == flag);
        if !has(Feature::Samples) && !is_set("samples") {
            assert_eq!(counts.incident, 48 * 36, "{name}");
        }
        if !has(Feature::Boxes) && !has(Feature::Bsp) && !is_set("accel") {
            assert_eq!(counts.nodes, 0, "{name}");
        }
        mirrors += counts.reflected;
        glass += counts.transmitted;
    }
    assert!(mirrors > 0 && glass > 0, "later chapters have them");
}

#[test]
fn the_tree_names_what_is_off_and_says_it_of_each_ray() {
    let course = Course::embedded().expect("the course");
    let mut absent = BTreeSet::new();
    for Drawn {
        chapter,
        world,
        settings,
    } in chapters(&course)
    {
        let told = off(&course, &chapter, &world.scene);
        let effects: BTreeSet<&str> = told
            .iter()
            .filter_map(|off| Some(off.feature.effect()?.name()))
            .collect();
        for off in &told {
            let until = off.until.expect("the course enables all effects");
            assert!(until > chapter.number, "{}: {off:?}", chapter.folder);
            let later = &course.chapters[until - 1];
            assert!(later.enables.contains(&off.feature), "{off:?}");
        }
        for at in (0..36).flat_map(|y| (0..48).map(move |x| (x, y))) {
            let trace = trace_pixel(&world, &settings, at, false);
            let view = View {
                world: &world,
                settings: &settings,
                trace: &trace,
            };
            for event in &trace.tree.events {
                if let Event::Absent { kind, reason, .. } = event
                    && reason.name() == "effect-off"
                {
                    absent.insert((chapter.number, *kind));
                    let why = match kind {
                        RayKind::Reflected => effects.contains("reflection"),
                        RayKind::Transmitted => effects.contains("refraction"),
                        _ => ["shadows", "diffuse", "highlights"]
                            .iter()
                            .any(|name| effects.contains(name)),
                    };
                    assert!(why, "{} {at:?}: {kind:?}", chapter.folder);
                }
            }
            if at == (24, 18) {
                let document = document::of(view);
                let without = document.settings.without.iter().map(String::as_str);
                assert_eq!(
                    without.collect::<BTreeSet<_>>(),
                    effects,
                    "{}",
                    chapter.folder
                );
            }
        }
    }
    // Before chapter 9 lights cast no shadows, and before chapter 10 the wall is no mirror.
    let kinds: BTreeSet<RayKind> = absent.iter().map(|(_, kind)| *kind).collect();
    assert!(kinds.contains(&RayKind::Light), "{absent:?}");
}
