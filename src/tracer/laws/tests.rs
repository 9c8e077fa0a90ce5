//! Bent laws without a bend are ours, and each bend changes something.

use super::{Bent, Ours};
use crate::accel::AccelKind;
use crate::probe::{Event, Probe};
use crate::scene::{Bend, Bends, Settings, load};
use crate::tracer::pixel::PixelEstimator;
use crate::tracer::state::Tracer;
use crate::world::World;

/// Keeps all events as text: NaN is equal to itself there.
#[derive(Default)]
struct Log(Vec<String>);

impl Probe for Log {
    const TRAVERSAL: bool = false;

    fn event(&mut self, event: Event) {
        self.0.push(format!("{event:?}"));
    }
}

fn events(world: &World, settings: &Settings, at: (u32, u32), bends: Option<Bends>) -> Vec<String> {
    let mut log = Log::default();
    match bends {
        None => {
            let mut tracer = Tracer::by_laws(world, settings, &mut log, Ours);
            PixelEstimator::trace(&mut tracer, at)
        }
        Some(bends) => {
            let mut tracer = Tracer::by_laws(world, settings, &mut log, Bent(bends));
            PixelEstimator::trace(&mut tracer, at)
        }
    };
    log.0
}

#[test]
fn without_a_bend_they_are_ours() {
    for name in crate::scene::builtin::names() {
        let scene = load(name).expect("built in");
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (20, 15);
            s.light.samples = 2;
        });
        let world = World::new(scene, AccelKind::Bsp);
        for at in (0..15)
            .step_by(4)
            .flat_map(|y| (0..20).step_by(3).map(move |x| (x, y)))
        {
            let ours = events(&world, &settings, at, None);
            let bent = events(&world, &settings, at, Some(Bends::default()));
            assert!(ours == bent, "{name} {at:?}");
        }
    }
}

#[test]
fn bends_are_read_as_they_are_written() {
    for bend in Bend::all() {
        assert_eq!(bend.name().parse(), Ok(bend));
        assert_eq!(bend.name().parse(), Ok(Bends::from(bend)));
    }
    assert_eq!(
        "eta-inverted,shadow-none".parse(),
        Ok(Bends([Some(Bend::EtaInverted), Some(Bend::ShadowNone)]))
    );
    for wrong in ["", "eta", "eta-inverted,tir-straight", "a,b,c"] {
        assert!(wrong.parse::<Bends>().is_err(), "{wrong}");
    }
}
