//! Values, computed on a stage.

use rayon::prelude::*;

use super::stage::Stage;
use super::value::{AskedValue, Counter, LessonValue};
use crate::lab::find::find;
use crate::trace::Counts;
use crate::trace::field::{FieldValue, field};
use crate::trace::query::unknown_names;
use crate::tracer::{pixel, thread_pool};

impl LessonValue {
    /// The value on a stage, which is that of its scene.
    pub fn value(&self, stage: &Stage) -> Result<FieldValue, String> {
        let stage = &stage.with(&self.settings)?;
        match &self.what {
            AskedValue::Field(address, name) => {
                let trace = stage.traced(address.pixel)?;
                field(stage.view(&trace), &address.path, name)
            }
            AskedValue::Count(query) => {
                let (world, settings) = (&stage.world, &stage.settings);
                if let Some(unknown) = unknown_names(query, &world.scene) {
                    return Err(unknown);
                }
                let go_on = |_: &[(u32, u32)], _| std::ops::ControlFlow::Continue(());
                let found = find(world, settings, query, usize::MAX, 0, &go_on);
                Ok(FieldValue::Number(found.pixels.len() as f64))
            }
            AskedValue::Counter(counter) => Ok(FieldValue::Number(counter.of(stage))),
        }
    }
}

impl Counter {
    /// Its value for the picture of a stage.
    fn of(self, stage: &Stage) -> f64 {
        let (width, height) = stage.settings.size();
        let pixels = u64::from(width) * u64::from(height);
        let counted = |i: u64| {
            let at = ((i % u64::from(width)) as u32, (i / u64::from(width)) as u32);
            let mut counts = Counts::default();
            pixel(&stage.world, &stage.settings, at, &mut counts);
            [counts.rays(), counts.nodes, counts.tests]
        };
        let add = |a: [u64; 3], b: [u64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        let [rays, nodes, tests] = thread_pool::install(0, || {
            let all = (0..pixels).into_par_iter().map(counted);
            all.reduce(|| [0; 3], add)
        })
        .map(|n| n as f64);
        match self {
            Self::Rays => rays,
            Self::Nodes => nodes,
            Self::Tests => tests,
            Self::RaysPerPixel => rays / pixels as f64,
            Self::NodesPerRay => nodes / rays,
            Self::TestsPerRay => tests / rays,
        }
    }
}
