//! The Monte Carlo task: a right tracer never fails, whatever its seed, and each mistake of the sampling does.
//!
//! The right tracer here is written from the formula alone: L = Le A cos cos' / (pi r^2) kd, where the panel is seen from the floor.

use glam::DVec3;
use raytree::grade::marks::Given;
use raytree::grade::report::Marked;
use raytree::grade::selftest::SelfTest;
use raytree::grade::task::{AskedEstimate, CheckKind, Task};
use raytree::scene::{Bend, Law};
use raytree::trace::facts::PixelFacts;
use raytree::tracer::thread_pool;
use serde_json::Value;

use super::flat::{self, closest::eye_ray, lesson};
use super::random::Random;

/// Right tracers that hand in; with `RAYTREE_RUNS=2000` that many.
const RUNS: u64 = 60;

fn soft() -> Task {
    let path = lesson("tasks/soft.toml");
    let path = path.to_str().expect("UTF-8");
    thread_pool::install(0, || Task::load(path)).expect("a task")
}

/// The scene as one who reads its file knows it.
struct Panel {
    corner: DVec3,
    u: DVec3,
    v: DVec3,
    ball: (DVec3, f64),
    /// Le kd, in luminance.
    brightness: f64,
}

impl Panel {
    fn read() -> Self {
        let text = std::fs::read_to_string(lesson("tasks/soft.json")).expect("there");
        let scene: Value = serde_json::from_str(&text).expect("JSON");
        let vector = |place: &str| {
            let list = scene.pointer(place).expect(place);
            DVec3::from_array([0, 1, 2].map(|axis| list[axis].as_f64().expect("a number")))
        };
        let radius = scene.pointer("/objects/2/sphere/radius");
        let light = vector("/materials/panel/emission") * vector("/materials/floor/diffuse");
        Self {
            corner: vector("/objects/0/quad/corner"),
            u: vector("/objects/0/quad/u"),
            v: vector("/objects/0/quad/v"),
            ball: (
                vector("/objects/2/sphere/center"),
                radius.and_then(Value::as_f64).expect("a number"),
            ),
            brightness: light.dot(DVec3::new(0.2126, 0.7152, 0.0722)),
        }
    }

    /// What the point (a, b) of the panel, from 0 to 1, gives a point of the floor.
    fn sample(&self, floor: DVec3, [a, b]: [f64; 2]) -> f64 {
        let across = self.u.cross(self.v);
        let way = self.corner + a * self.u + b * self.v - floor;
        let (r2, r) = (way.length_squared(), way.length());
        let cos_floor = way.y / r;
        let cos_panel = -way.dot(across) / (r * across.length());
        // The ball is in the way where the line comes nearer to its centre than its radius, between both ends.
        let (center, radius) = self.ball;
        let along = ((center - floor).dot(way) / r2).clamp(0.0, 1.0);
        let is_dark = (floor + along * way - center).length() < radius;
        if is_dark || cos_floor <= 0.0 || cos_panel <= 0.0 {
            return 0.0;
        }
        self.brightness * across.length() * cos_floor * cos_panel / (std::f64::consts::PI * r2)
    }
}

/// What a tracer hands in that takes the points of the panel that `points` gives.
fn handed_in(task: &Task, mut points: impl FnMut(u64) -> Vec<[f64; 2]>) -> Given {
    let panel = Panel::read();
    let mut given = Given::default();
    for check in &task.checks {
        let CheckKind::Estimate { asked, references } = &check.kind else {
            panic!("only estimates are asked");
        };
        let camera = flat::read(&task.scenes[check.scene].world.scene).camera;
        for reference in references {
            let (eye, direction) = eye_ray(&camera, reference.pixel, (320, 240));
            let floor = eye - eye.y / direction.y * direction;
            let points = points(asked.samples);
            let facts = PixelFacts {
                pixel: Some(reference.pixel),
                estimates: points.iter().map(|p| panel.sample(floor, *p)).collect(),
                ..PixelFacts::default()
            };
            given.add(check.scene, reference.pixel, facts);
        }
    }
    given
}

fn marked(task: &Task, given: &Given) -> Marked {
    Marked::of_given(
        std::slice::from_ref(task),
        task,
        "student".to_owned(),
        given,
    )
}

#[test]
fn a_right_tracer_never_fails_whatever_its_seed() {
    let runs = std::env::var("RAYTREE_RUNS").map_or(RUNS, |n| n.parse().expect("a number"));
    let task = soft();
    for seed in 1..=runs {
        let mut random = Random(seed);
        let given = handed_in(&task, |n| {
            (0..n).map(|_| [random.share(), random.share()]).collect()
        });
        let marked = marked(&task, &given);
        assert_eq!(
            marked.score(),
            marked.most(),
            "seed {seed}: {:?}",
            marked.marks
        );
    }
}

#[test]
fn a_right_tracer_that_stratifies_earns_all() {
    let task = soft();
    let mut random = Random(7);
    let given = handed_in(&task, |n| {
        // A grid of at least n cells, a point by chance in each.
        let side = (n as f64).sqrt().ceil() as u64;
        let mut cell = |i: u64| (i as f64 + random.share()) / side as f64;
        let cells = (0..side * side).map(|i| [cell(i % side), cell(i / side)]);
        cells.collect()
    });
    let marked = marked(&task, &given);
    assert_eq!(marked.score(), marked.most(), "{:?}", marked.marks);
}

#[test]
fn copied_means_and_few_samples_earn_nothing() {
    let task = soft();
    let CheckKind::Estimate { references, .. } = &task.checks[0].kind else {
        panic!("estimates are asked");
    };
    let score = |values: &dyn Fn(f64) -> Vec<f64>| {
        let mut given = Given::default();
        for reference in references {
            let facts = PixelFacts {
                pixel: Some(reference.pixel),
                estimates: values(reference.mean),
                ..PixelFacts::default()
            };
            given.add(task.checks[0].scene, reference.pixel, facts);
        }
        marked(&task, &given).score()
    };
    assert_eq!(score(&|mean| vec![mean; 100_000]), 0);
    assert_eq!(score(&|mean| vec![0.0, 2.0 * mean]), 0);
}

/// Where the mean is asked, a mean and a number of samples are enough.
#[test]
fn a_mean_is_enough_where_it_is_asked() {
    let mut task = soft();
    let given = |task: &Task, share: f64, samples: u64| {
        let mut given = Given::default();
        let CheckKind::Estimate { references, .. } = &task.checks[0].kind else {
            panic!("estimates are asked");
        };
        for reference in references {
            let facts = PixelFacts {
                pixel: Some(reference.pixel),
                mean: Some((share * reference.mean, samples)),
                ..PixelFacts::default()
            };
            given.add(task.checks[0].scene, reference.pixel, facts);
        }
        given
    };
    let score = |task: &Task, given: &Given| marked(task, given).score();
    let right = given(&task, 1.0, 8000);
    assert_eq!(score(&task, &right), 0);
    if let CheckKind::Estimate { asked, .. } = &mut task.checks[0].kind {
        asked.ask = AskedEstimate::Mean;
    }
    assert_eq!(score(&task, &right), task.checks[0].points);
    assert_eq!(score(&task, &given(&task, 1.2, 8000)), 0);
    assert_eq!(score(&task, &given(&task, 1.0, 100)), 0);
}

/// The check has power: each mistake of how lights with an area are sampled loses points.
#[test]
fn every_mistake_of_light_samples_shows() {
    let task = soft();
    let test = thread_pool::install(0, || SelfTest::new(&[task])).expect("tested");
    assert!(test.failures.is_empty(), "{:?}", test.failures);
    let unseen = test.unseen.iter();
    // The same points at all pixels are right at each single one.
    let shows = |bend: &Bend| bend.law() == Law::LightSamples && *bend != Bend::SamePoints;
    let unseen: Vec<_> = unseen.filter(|bend| shows(bend)).collect();
    assert!(unseen.is_empty(), "{unseen:?}");
    let seen = test.bends.iter();
    assert!(seen.filter(|(bend, _)| shows(bend)).count() >= 5);
}
