//! A task that is ready: its scenes are built, its pixels drawn, its reference trees traced.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::ask::Ask;
use super::error::TaskError;
use super::parse::{bend, beside, names, parse, read, set, tolerances};
use super::pictures::BentPictures;
use super::scene::{MAX_PIXELS, TaskScene, reference};
use super::steady::{self, draw};
use super::{CheckFile, PictureFile, PixelsFile, Say, TaskFile};
use crate::accel::fastest;
use crate::grade::attempts::Attempts;
use crate::grade::tolerance::Tolerances;
use crate::scene::effects::effects;
use crate::scene::{Bend, Bends, Scene, load};
use crate::trace::facts::PixelFacts;
use crate::trace::query::unknown_names;
use crate::world::World;

/// Checks of a task at most.
const MAX_CHECKS: usize = 1000;

/// What reads a scene by the name that a task has for it: as `raytree view` takes it, and the scene.
pub type SceneReader<'a> = &'a dyn Fn(&str) -> Result<(String, Scene), TaskError>;

/// Reads scenes beside a task on the disk, and built-in ones.
fn on_disk(task: &str) -> impl Fn(&str) -> Result<(String, Scene), TaskError> {
    move |name| {
        let path = beside(task, name).map_err(|what| TaskError::Task {
            file: task.to_owned(),
            what,
        })?;
        let scene = load(&path)?;
        Ok((path, scene))
    }
}

/// A task.
#[derive(Clone)]
pub struct Task {
    /// What it is called.
    pub name: String,
    /// BLAKE3 of its file, in hexadecimal digits.
    pub hash: String,
    /// Whether numbers that are right given the student's own count.
    pub follow: bool,
    /// How much messages tell.
    pub say: Say,
    /// Percent that are enough.
    pub pass: u32,
    /// Bends that count as right, too.
    pub accept: Vec<Bend>,
    /// Which attempts count.
    pub attempts: Option<Attempts>,
    /// How far off values may be.
    pub tolerances: Tolerances,
    /// The scenes, each with the settings it is traced with.
    pub scenes: Vec<TaskScene>,
    /// The checks.
    pub checks: Vec<Check>,
    /// What is strange, such as pixels that are not steady.
    pub warnings: Vec<String>,
}

/// A check.
#[derive(Clone)]
pub struct Check {
    /// Unique name.
    pub id: String,
    /// For people.
    pub title: String,
    /// Points, in thousandths.
    pub points: u64,
    /// Indices of checks of which half of the points must be earned first.
    pub needs: Vec<usize>,
    /// Whether students see values and addresses.
    pub visible: bool,
    /// Index of the scene.
    pub scene: usize,
    /// What is asked.
    pub kind: CheckKind,
    /// Points that a student with a bend earns, for the self-test.
    pub expect: Vec<(Bend, [f64; 2])>,
}

/// What a check asks.
#[derive(Clone)]
pub enum CheckKind {
    /// Ray trees.
    Trees {
        /// Our trees of the pixels.
        pixels: Vec<PixelFacts>,
        /// The quantities.
        ask: Ask,
        /// Rays below this depth are not asked.
        depth: Option<usize>,
    },
    /// A picture.
    Picture {
        /// What is asked of it.
        asked: PictureFile,
        /// Ours, and those of the bends.
        pictures: Arc<BentPictures>,
    },
    /// A Monte Carlo estimate of a light's diffuse term.
    Estimate {
        /// What is asked.
        asked: super::EstimateFile,
        /// Our references, one a pixel.
        references: Vec<crate::grade::estimate::EstimateReference>,
    },
}

impl Task {
    /// Reads a task and traces its references, on the threads of the present pool.
    pub fn load(path: &str) -> Result<Self, TaskError> {
        let (file, text) = read(path)?;
        Self::new(path, &file, &text, Bends::default(), &on_disk(path))
    }

    /// The task in a text, whose scenes come from elsewhere: by the name that the task has for them.
    pub fn of_text(
        path: &str,
        text: &str,
        bends: Bends,
        scenes: SceneReader,
    ) -> Result<Self, TaskError> {
        let file = parse(text).map_err(|what| TaskError::Task {
            file: path.to_owned(),
            what,
        })?;
        Self::new(path, &file, text, bends, scenes)
    }

    /// The task with references of one who makes a mistake, for those that count as right, and for the self-test.
    pub fn bent(path: &str, bends: Bends) -> Result<Self, TaskError> {
        let (file, text) = read(path)?;
        Self::new(path, &file, &text, bends, &on_disk(path))
    }

    /// The pixels that are asked, a line each: the scene's name, the column and the row.
    pub fn asked_pixels(&self) -> Vec<String> {
        let mut lines = BTreeSet::new();
        for check in &self.checks {
            let name = &self.scenes[check.scene].world.scene.name;
            let mut add = |(x, y): (u32, u32)| lines.insert((name, y, x));
            match &check.kind {
                CheckKind::Trees { pixels, .. } => {
                    for pixel in pixels.iter().filter_map(|pixel| pixel.pixel) {
                        add(pixel);
                    }
                }
                CheckKind::Estimate { references, .. } => {
                    for reference in references {
                        add(reference.pixel);
                    }
                }
                CheckKind::Picture { .. } => {}
            }
        }
        let lines = lines.into_iter();
        lines
            .map(|(name, y, x)| format!("{name} {x} {y}\n"))
            .collect()
    }

    fn new(
        path: &str,
        file: &TaskFile,
        text: &str,
        bends: Bends,
        scenes: SceneReader,
    ) -> Result<Self, TaskError> {
        let wrong = |what: String| TaskError::Task {
            file: path.to_owned(),
            what,
        };
        let mut task = Self {
            name: file.name.clone(),
            hash: blake3::hash(text.as_bytes()).to_hex().to_string(),
            follow: file.follow,
            say: file.say,
            pass: file.pass,
            accept: names(&file.accept).map_err(wrong)?,
            attempts: file.attempts,
            tolerances: tolerances(file).map_err(wrong)?,
            scenes: Vec::new(),
            checks: Vec::new(),
            warnings: Vec::new(),
        };
        if file.format != "raytree-task/1" {
            return Err(wrong(format!(
                "`format` is `{}`; write raytree-task/1",
                file.format
            )));
        }
        if file.checks.is_empty() || file.checks.len() > MAX_CHECKS {
            return Err(wrong(format!(
                "has {} checks; 1 to {MAX_CHECKS} are possible",
                file.checks.len()
            )));
        }
        for check in &file.checks {
            let scene = task.scene(path, file, check, scenes)?;
            let check = task
                .check(check, scene, bends)
                .map_err(|what| wrong(format!("check `{}`: {what}", check.id)))?;
            task.checks.push(check);
        }
        Ok(task)
    }

    /// The index of a check's scene, which is loaded if it is new.
    fn scene(
        &mut self,
        path: &str,
        file: &TaskFile,
        check: &CheckFile,
        scenes: SceneReader,
    ) -> Result<usize, TaskError> {
        let label = if check.without.is_empty() {
            check.scene.clone()
        } else {
            format!("{} without {}", check.scene, check.without.join(", "))
        };
        if let Some(index) = self.scenes.iter().position(|scene| scene.label == label) {
            return Ok(index);
        }
        let wrong = |what: String| TaskError::Task {
            file: path.to_owned(),
            what: format!("check `{}`: {what}", check.id),
        };
        let (scene_path, scene) = scenes(&check.scene).map_err(|error| match error {
            TaskError::Task { what, .. } => wrong(what),
            error @ TaskError::Scene(_) => error,
        })?;
        let mut settings = scene.settings;
        settings.effects = effects(&scene);
        let size = file
            .size
            .as_ref()
            .map(|size| ("size".to_owned(), size.clone()));
        let given = file
            .settings
            .iter()
            .map(|(key, value)| (key.replace('_', "-"), value.to_string()));
        let without =
            (!check.without.is_empty()).then(|| ("without".to_owned(), check.without.join(",")));
        for (flag, value) in size.into_iter().chain(given).chain(without) {
            set(&mut settings, &flag, &value).map_err(wrong)?;
        }
        settings.accel = fastest(&scene.shapes);
        settings.bends = Bends::default();
        let world = World::new(scene.computed_with(settings.arithmetic), settings.accel);
        self.scenes.push(TaskScene {
            label,
            path: scene_path,
            world: Arc::new(world),
            settings,
        });
        Ok(self.scenes.len() - 1)
    }

    fn check(&mut self, file: &CheckFile, scene: usize, bends: Bends) -> Result<Check, String> {
        let is_letter = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if file.id.is_empty() || !file.id.chars().all(is_letter) {
            return Err("its `id` must be of a-z, 0-9 and -".to_owned());
        }
        if self.checks.iter().any(|check| check.id == file.id) {
            return Err("there is another check of this `id`".to_owned());
        }
        let needs = file.needs.iter().map(|id| {
            let index = self.checks.iter().position(|check| check.id == *id);
            index.ok_or_else(|| format!("`needs` names `{id}`, and no check before has this id"))
        });
        let needs = needs.collect::<Result<_, _>>()?;
        let expect = file
            .expect
            .iter()
            .map(|(name, points)| Ok((bend(name)?, *points)));
        Ok(Check {
            id: file.id.clone(),
            title: if file.title.is_empty() {
                file.id.clone()
            } else {
                file.title.clone()
            },
            points: u64::from(file.points) * 1000,
            needs,
            visible: file.visible,
            scene,
            kind: self.kind(file, scene, bends)?,
            expect: expect.collect::<Result<_, String>>()?,
        })
    }

    fn kind(&mut self, file: &CheckFile, index: usize, bends: Bends) -> Result<CheckKind, String> {
        let scene = &self.scenes[index];
        let settings = scene.settings.with(|s| s.bends = bends);
        if let Some(picture) = &file.picture {
            if file.pixels.is_some() || !file.ask.is_empty() {
                return Err("a `picture` has no `pixels` and no `ask` of its own".to_owned());
            }
            if !["srgb8", "linear"].contains(&picture.ask.as_str()) {
                return Err(format!(
                    "`picture.ask` is `{}`; write srgb8 or linear",
                    picture.ask
                ));
            }
            return Ok(CheckKind::Picture {
                asked: picture.clone(),
                pictures: Arc::new(BentPictures::new(scene, bends)),
            });
        }
        let pixels = self.pixels(file, index)?;
        let scene = &self.scenes[index];
        if let Some(estimate) = &file.estimate {
            let references = crate::grade::estimate::references(scene, &pixels, estimate, bends)?;
            return Ok(CheckKind::Estimate {
                asked: estimate.clone(),
                references,
            });
        }
        let ask = Ask::new(&file.ask)?;
        if ask.is_empty() {
            return Err("asks nothing; write `ask`, such as [\"core\"]".to_owned());
        }
        Ok(CheckKind::Trees {
            pixels: pixels
                .iter()
                .map(|at| reference(scene, &settings, *at))
                .collect(),
            ask,
            depth: file.depth.map(|depth| depth as usize),
        })
    }

    /// The pixels of a check.
    fn pixels(&mut self, file: &CheckFile, index: usize) -> Result<Vec<(u32, u32)>, String> {
        let scene = &self.scenes[index];
        let (width, height) = scene.settings.size();
        match &file.pixels {
            None => Err("has no `pixels` and no `picture`; write pixels = [[160, 120]]".to_owned()),
            Some(PixelsFile::List(list)) if list.len() <= MAX_PIXELS => {
                let mut unsteady = Vec::new();
                for [x, y] in list {
                    if *x >= width || *y >= height {
                        return Err(format!(
                            "pixel [{x}, {y}] is outside the picture of {width}x{height}"
                        ));
                    }
                    if !steady::is_steady(scene, (*x, *y), file.depth) {
                        unsteady.push(format!("[{x}, {y}]"));
                    }
                }
                let pixels = list.iter().map(|[x, y]| (*x, *y)).collect();
                if !unsteady.is_empty() {
                    self.warnings.push(format!(
                        "check `{}`: a right tracer in single precision may differ at {}",
                        file.id,
                        unsteady.join(", ")
                    ));
                }
                Ok(pixels)
            }
            Some(PixelsFile::List(_)) => Err(format!("has more than {MAX_PIXELS} pixels")),
            Some(PixelsFile::Drawn(rule)) => {
                let query = rule.r#where.as_ref().and_then(|text| text.parse().ok());
                let unknown = query.and_then(|q| unknown_names(&q, &scene.world.scene));
                let unknown = unknown.map(|what| format!("check `{}`: `where`: {what}", file.id));
                self.warnings.extend(unknown);
                draw(&self.scenes[index], rule, file.depth)
            }
        }
    }
}
