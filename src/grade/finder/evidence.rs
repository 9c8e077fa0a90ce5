//! What a submission tells of its mistakes: trees, colours of pixels, pictures.

use std::collections::HashSet;

use super::Tally;
use crate::grade::compare::{Compared, Status, TreeComparison};
use crate::grade::follow::{Consequences, PixelReference};
use crate::grade::marks::{Given, agree_in_picture};
use crate::grade::picture::read_picture;
use crate::grade::quantity::QuantityKind;
use crate::grade::task::{BentPictures, CheckKind, PictureFile, Task, reference};
use crate::math::Rgb;
use crate::scene::Bends;
use crate::trace::facts::{Fact, PixelFacts};
use crate::tracer::Film;

/// Pixels with trees that are looked at, and of these without errors at least, if there are so many: they speak against a bend
/// that would show at them.
const MOST_PIXELS: usize = 40;
const WITHOUT_ERRORS: usize = 10;

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
        /// How many of its values do not agree.
        errors: u64,
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
        let (mut all, mut at_pixels) = (Vec::new(), Vec::new());
        let mut seen = HashSet::new();
        for check in &task.checks {
            match &check.kind {
                CheckKind::Trees { pixels, .. } => {
                    for ours in pixels {
                        let at = ours.pixel.unwrap_or_default();
                        let theirs = given.tree(check.scene, at).ok().flatten();
                        if let Some(theirs) = theirs
                            && seen.insert((check.scene, at))
                        {
                            at_pixels.push(Self::pixel(task, check.scene, ours, theirs));
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
        let (mut wrong, mut right): (Vec<_>, Vec<_>) =
            at_pixels.into_iter().partition(|p| p.errors() > 0);
        wrong.truncate(MOST_PIXELS - right.len().min(WITHOUT_ERRORS));
        right.truncate(MOST_PIXELS - wrong.len());
        all.extend(wrong);
        all.extend(right);
        all
    }

    fn pixel(task: &Task, scene: usize, ours: &'a PixelFacts, theirs: &'a PixelFacts) -> Self {
        let of = pixel_reference(task, scene, ours);
        let comparison = TreeComparison::new(of, theirs, &task.tolerances);
        // A right tree whose colour is wrong tells of its colour.
        let is_right = comparison.all.iter().all(|c| c.status != Status::Wrong);
        let errors = wrong_colors(task, ours, theirs);
        if theirs.rays.is_empty() || is_right && errors > 0 {
            return Self::Color {
                scene,
                ours,
                theirs,
                errors,
            };
        }
        Self::Tree {
            scene,
            ours,
            theirs,
            compared: comparison.all,
        }
    }

    /// True for the tree of a pixel.
    pub fn is_tree(&self) -> bool {
        matches!(self, Self::Tree { .. })
    }

    /// How many things are wrong in themselves.
    pub fn errors(&self) -> u64 {
        match self {
            Self::Tree { compared, .. } => {
                let wrong = compared.iter().filter(|c| c.status == Status::Wrong);
                wrong.count() as u64
            }
            Self::Color { errors, .. } | Self::Picture { errors, .. } => *errors,
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
                let of = pixel_reference(task, *scene, ours);
                let bent = Consequences::new(of, theirs, bends);
                for compared in compared {
                    let made = bent.find(compared.ray, &compared.name);
                    add_tree_fact(task, compared, made, tally);
                }
            }
            Self::Color {
                scene,
                ours,
                theirs,
                ..
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

/// How many values of a pixel's colour that the student tells are not ours: linear, and of 8 bits.
fn wrong_colors(task: &Task, ours: &PixelFacts, theirs: &PixelFacts) -> u64 {
    let pairs = [
        (QuantityKind::Color, &ours.color, &theirs.color),
        (QuantityKind::Srgb8, &ours.srgb8, &theirs.srgb8),
    ];
    let is_wrong = |(quantity, ours, theirs): &(QuantityKind, &Option<Fact>, &Option<Fact>)| {
        let (Some(ours), Some(theirs)) = (ours, theirs) else {
            return false;
        };
        !task.tolerances.agree(*quantity, ours, theirs)
    };
    pairs.iter().filter(|pair| is_wrong(pair)).count() as u64
}

fn add_tree_fact(task: &Task, compared: &Compared, made: [Option<&Fact>; 2], tally: &mut Tally) {
    let Some(theirs) = &compared.theirs else {
        return;
    };
    // A vector of length 1 speaks against no mistake: whoever sends a ray may make its direction a unit vector.
    if compared.quantity == QuantityKind::Unit && compared.status == Status::Right {
        return;
    }
    let agree = |a: &Fact, b: &Fact| task.tolerances.agree(compared.quantity, a, b);
    let is_wrong = compared.status == Status::Wrong;
    // By each reading: whether the bend makes another value than our law, and whether the student has it.
    let readings = [0, 1].map(|reading| {
        let right = compared.follows[reading].as_ref().unwrap_or(&compared.ours);
        let made = made[reading];
        let telling = made.is_some_and(|made| !agree(right, made));
        (telling, made.is_some_and(|made| agree(made, theirs)))
    });
    let explained = readings.iter().find(|(_, explained)| *explained);
    match explained {
        Some((telling, _)) => tally.add(*telling, true, is_wrong),
        // Against the bend speaks what it makes by both readings.
        None => tally.add(
            readings.iter().all(|(telling, _)| *telling),
            false,
            is_wrong,
        ),
    }
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
