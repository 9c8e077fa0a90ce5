//! What a submission tells of its mistakes: trees, colours of pixels, pictures.

use std::collections::HashSet;

use super::Tally;
use crate::grade::compare::{Compared, Status, TreeComparison, find};
use crate::grade::follow::{PixelReference, expected};
use crate::grade::marks::{Given, agree_in_picture};
use crate::grade::picture::read_picture;
use crate::grade::quantity::QuantityKind;
use crate::grade::task::{BentPictures, CheckKind, PictureFile, Task, reference};
use crate::math::Rgb;
use crate::scene::Bends;
use crate::trace::facts::{Fact, PixelFacts};
use crate::tracer::Film;

/// Pixels with trees that are looked at.
const MOST_PIXELS: usize = 40;

/// One thing that was handed in, beside ours.
pub enum Evidence<'a> {
    /// The tree of a pixel.
    Tree {
        /// Index of its scene.
        scene: usize,
        /// Ours.
        ours: &'a PixelFacts,
        /// The student's.
        theirs: &'a PixelFacts,
        /// Both compared.
        compared: Vec<Compared>,
    },
    /// The colour of a pixel alone.
    Color {
        /// Index of its scene.
        scene: usize,
        /// Ours.
        ours: &'a PixelFacts,
        /// The student's.
        theirs: &'a PixelFacts,
    },
    /// A picture.
    Picture {
        /// Index of its scene.
        scene: usize,
        /// What is asked of it.
        asked: &'a PictureFile,
        /// Ours, and those of the bends.
        pictures: &'a BentPictures,
        /// The student's.
        theirs: Film,
        /// How many pixels do not agree.
        errors: u64,
    },
}

impl<'a> Evidence<'a> {
    /// All that a submission tells.
    pub fn of(task: &'a Task, given: &'a Given) -> Vec<Self> {
        let mut all = Vec::new();
        let mut seen = HashSet::new();
        for check in &task.checks {
            match &check.kind {
                CheckKind::Trees { pixels, .. } => {
                    for ours in pixels {
                        let at = ours.pixel.unwrap_or_default();
                        let theirs = given.tree(check.scene, at).ok().flatten();
                        if let Some(theirs) = theirs
                            && seen.insert((check.scene, at))
                            && all.len() < MOST_PIXELS
                        {
                            all.push(Self::pixel(task, check.scene, ours, theirs));
                        }
                    }
                }
                CheckKind::Picture { asked, pictures } => {
                    let film = &pictures.right;
                    let exposure = task.scenes[check.scene].settings.image.exposure;
                    let size = (film.width, film.height);
                    let theirs = given.picture(&asked.file);
                    let theirs =
                        theirs.and_then(|(_, bytes)| read_picture(bytes, size, exposure).ok());
                    if let Some(theirs) = theirs {
                        let pairs = film.pixels.iter().zip(&theirs.pixels);
                        let errors = pairs
                            .filter(|(a, b)| !agree_in_picture(task, asked, exposure, (**a, **b)));
                        all.push(Self::Picture {
                            scene: check.scene,
                            asked,
                            pictures,
                            errors: errors.count() as u64,
                            theirs,
                        });
                    }
                }
                CheckKind::Estimate { .. } => {}
            }
        }
        all
    }

    fn pixel(task: &Task, scene: usize, ours: &'a PixelFacts, theirs: &'a PixelFacts) -> Self {
        if theirs.rays.is_empty() {
            return Self::Color {
                scene,
                ours,
                theirs,
            };
        }
        let comparison =
            TreeComparison::new(pixel_reference(task, scene, ours), theirs, &task.tolerances);
        Self::Tree {
            scene,
            ours,
            theirs,
            compared: comparison.all,
        }
    }

    /// How many things are wrong in themselves.
    pub fn errors(&self) -> u64 {
        match self {
            Self::Tree { compared, .. } => {
                let wrong = compared.iter().filter(|c| c.status == Status::Wrong);
                wrong.count() as u64
            }
            Self::Color { .. } => 1,
            Self::Picture { errors, .. } => *errors,
        }
    }

    /// Adds what these bends explain of it.
    pub fn add(&self, task: &Task, bends: Bends, tally: &mut Tally) {
        let before = tally.explained;
        match self {
            Self::Tree {
                scene,
                ours,
                theirs,
                compared,
            } => {
                let bent = expected(pixel_reference(task, *scene, ours), theirs, bends);
                for compared in compared {
                    let made = find(&bent[compared.ray], &compared.name);
                    add_tree_fact(task, compared, made, tally);
                }
            }
            Self::Color {
                scene,
                ours,
                theirs,
            } => {
                let scene = &task.scenes[*scene];
                let settings = scene.settings.with(|s| s.bends = bends);
                let bent = reference(scene, &settings, ours.pixel.unwrap_or_default());
                let values = |facts: &PixelFacts| [facts.color.clone(), facts.srgb8.clone()];
                let kinds = [QuantityKind::Color, QuantityKind::Srgb8];
                let all = values(ours)
                    .into_iter()
                    .zip(values(&bent))
                    .zip(values(theirs));
                for (quantity, ((ours, bent), theirs)) in kinds.into_iter().zip(all) {
                    if let (Some(ours), Some(bent), Some(theirs)) = (ours, bent, theirs) {
                        let agree = |a: &Fact, b: &Fact| task.tolerances.agree(quantity, a, b);
                        let (is_ours, is_bent) = (agree(&ours, &theirs), agree(&bent, &theirs));
                        tally.add(!agree(&ours, &bent), is_bent, !is_ours);
                    }
                }
            }
            Self::Picture {
                scene,
                asked,
                pictures,
                theirs,
                errors,
            } => {
                // Pairs are not drawn: trees must tell them.
                let Bends([Some(bend), None]) = bends else {
                    tally.errors += errors;
                    return;
                };
                let exposure = task.scenes[*scene].settings.image.exposure;
                let bent = pictures.bent(bend).pixels.iter();
                for ((ours, bent), theirs) in
                    pictures.right.pixels.iter().zip(bent).zip(&theirs.pixels)
                {
                    let agree =
                        |a: &Rgb, b: &Rgb| agree_in_picture(task, asked, exposure, (*a, *b));
                    tally.add(
                        !agree(ours, bent),
                        agree(bent, theirs),
                        !agree(ours, theirs),
                    );
                }
            }
        }
        tally.pixels += u64::from(tally.explained > before);
        if let Self::Picture { .. } = self {
            tally.pixels += u64::from(tally.explained > before + 1);
        }
    }
}

fn add_tree_fact(task: &Task, compared: &Compared, made: Option<&Fact>, tally: &mut Tally) {
    let Some(theirs) = &compared.theirs else {
        return;
    };
    let agree = |a: &Fact, b: &Fact| task.tolerances.agree(compared.quantity, a, b);
    let right = compared.follows.as_ref().unwrap_or(&compared.ours);
    let is_wrong = compared.status == Status::Wrong;
    let explained = made.is_some_and(|made| agree(made, theirs));
    let telling = made.is_some_and(|made| !agree(right, made));
    tally.add(telling, explained, is_wrong);
}

impl Tally {
    /// Counts one value: whether the bend makes another one than our law, whether the student has the bend's, whether the student
    /// has it wrong.
    fn add(&mut self, telling: bool, is_bent: bool, is_wrong: bool) {
        self.telling += u64::from(telling);
        self.explained += u64::from(telling && is_bent);
        self.errors += u64::from(is_wrong);
        self.accounted += u64::from(is_wrong && is_bent);
    }
}

fn pixel_reference<'a>(task: &'a Task, scene: usize, ours: &'a PixelFacts) -> PixelReference<'a> {
    let scene = &task.scenes[scene];
    PixelReference {
        scene: Some((&scene.world, &scene.settings)),
        pixel: ours.pixel.unwrap_or_default(),
        facts: ours,
    }
}
