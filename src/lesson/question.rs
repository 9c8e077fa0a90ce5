//! A question about a ray, put before its answer is shown. The answer stands in no file: it is traced.

use super::near::is_near;
use super::stage::Stage;
use super::value::{AskedValue, LessonValue};
use crate::debug::asked;
use crate::geometry::Hit;
use crate::sampling::stream::{splitmix64, uniform2};
use crate::scene::Scene;
use crate::trace::address::node_at;
use crate::trace::address::{AddressPart, path_of};
use crate::trace::facts::TreePath;
use crate::trace::field::{FieldValue, field, steps};
use crate::trace::{Address, Outcome, View};

/// Pixels that are tried for a further question of the same kind.
const TRIED: u32 = 400;

/// How an answer is given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AnswerForm {
    /// A number.
    Number,
    /// So many numbers.
    Numbers(usize),
    /// One of these words.
    Word(Vec<String>),
}

/// A question.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The ray, if one is asked about.
    pub ray: Option<AskedRay>,
    /// How the answer is given.
    pub form: AnswerForm,
    /// The answer.
    pub answer: FieldValue,
}

/// The ray that a question is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AskedRay {
    /// The pixel.
    pub pixel: (u32, u32),
    /// The ray.
    pub path: TreePath,
    /// What of it is asked.
    pub field: String,
    /// The first event of the pixel's log that may not be shown yet.
    pub horizon: usize,
}

impl AskedRay {
    /// The address of what is asked.
    pub fn address(&self) -> Address {
        Address {
            scene: None,
            pixel: self.pixel,
            path: self.path.clone(),
            part: Some(AddressPart::Field(self.field.clone())),
        }
    }
}

impl Question {
    /// The question of an exercise; from the second try on, the same about another pixel.
    pub fn new(stage: &Stage, asked: &LessonValue, tries: u32) -> Result<Self, String> {
        let AskedValue::Field(address, name) = &asked.what else {
            let answer = asked.value(stage)?;
            return Ok(Self {
                ray: None,
                form: AnswerForm::of(&answer, Vec::new()),
                answer,
            });
        };
        let stage = &stage.with(&asked.settings)?;
        let first = Self::about(stage, address, name, address.pixel)?;
        if tries == 0 {
            return Ok(first);
        }
        Ok(Self::again(stage, address, name, tries).unwrap_or(first))
    }

    fn about(
        stage: &Stage,
        address: &Address,
        name: &str,
        pixel: (u32, u32),
    ) -> Result<Self, String> {
        let trace = stage.traced(pixel)?;
        let view = stage.view(&trace);
        let answer = field(view, &address.path, name)?;
        let mut ray = AskedRay {
            pixel,
            path: address.path.clone(),
            field: name.to_owned(),
            horizon: 0,
        };
        ray.horizon = asked::asked(view, &ray.address())?.horizon;
        let node = node_at(view, &ray.path)?;
        Ok(Self {
            form: AnswerForm::of(&answer, words(view, node, name)),
            answer,
            ray: Some(ray),
        })
    }

    /// A question about another pixel, drawn by the number of tries, whose tree has the same rays down to the one that is asked about,
    /// and ends on the same object.
    fn again(stage: &Stage, address: &Address, name: &str, tries: u32) -> Option<Self> {
        let way = |pixel: (u32, u32)| {
            let trace = stage.traced(pixel).ok()?;
            Some(way(stage.view(&trace), &address.path))
        };
        let wanted = way(address.pixel)?;
        let (width, height) = stage.settings.size();
        let (x, y) = address.pixel;
        let key = splitmix64(u64::from(tries) << 40 | u64::from(x) << 20 | u64::from(y));
        (0..TRIED).find_map(|number| {
            let draw = |size: u32, x: f64| ((x * f64::from(size)) as u32).min(size - 1);
            let [u, v] = uniform2(key, number);
            let pixel = (draw(width, u), draw(height, v));
            let is_like = pixel != address.pixel && way(pixel).as_ref() == Some(&wanted);
            let question = is_like.then(|| Self::about(stage, address, name, pixel).ok())??;
            (!question.is_guessed(None)).then_some(question)
        })
    }
}

impl Question {
    /// True if 0, 1, or zeros are near enough to the answer: whoever does not think says them.
    pub fn is_guessed(&self, tolerance: Option<f64>) -> bool {
        let lazy = match &self.answer {
            FieldValue::Number(_) => vec![FieldValue::Number(0.0), FieldValue::Number(1.0)],
            FieldValue::Numbers(list) => vec![FieldValue::Numbers(vec![0.0; list.len()])],
            FieldValue::Word(_) => Vec::new(),
        };
        lazy.iter()
            .any(|lazy| is_near(lazy, &self.answer, tolerance))
    }
}

/// The rays down to a ray and the objects that they end on.
fn way(view: View, path: &TreePath) -> Vec<(String, String)> {
    let tree = &view.trace.tree;
    let Ok(mut node) = node_at(view, path) else {
        return Vec::new();
    };
    let mut way = Vec::new();
    loop {
        let object = match tree.node(node).outcome {
            Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => {
                view.world.scene.object_of(hit.primitive).name.clone()
            }
            _ => String::new(),
        };
        way.push((path_of(view, node).to_string(), object));
        match tree.node(node).parent {
            Some(parent) => node = parent,
            None => return way,
        }
    }
}

/// Steps among which a step of a ray is: those that it takes, and for each node both that it is visited and that it is skipped.
fn steps_like(steps: &[String]) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for step in steps {
        let both = match step.split_once(' ') {
            Some(("node" | "skip", number)) => {
                vec![format!("node {number}"), format!("skip {number}")]
            }
            _ => vec![step.clone()],
        };
        words.extend(both);
    }
    words.sort();
    words.dedup();
    words
}

/// The words among which the answer is, if the field holds one.
fn words(view: View, node: u32, name: &str) -> Vec<String> {
    let scene = &view.world.scene;
    let own = |list: &[&str]| list.iter().map(|word| (*word).to_owned()).collect();
    match name.split(['.', '[']).next().unwrap_or(name) {
        "lit" => own(&["lit", "blocked"]),
        "outcome" => own(&["hit", "miss"]),
        "side" => own(&["front", "back"]),
        "part" => parts(scene),
        "object" => scene.objects.iter().map(|o| o.name.clone()).collect(),
        "material" => scene.materials.iter().map(|m| m.name.clone()).collect(),
        "absent" => own(&[
            "sent",
            "total-internal-reflection",
            "facing-away",
            "depth-limit",
            "min-weight",
            "no-reflection",
            "no-transmission",
            "effect-off",
        ]),
        "order" => steps_like(&steps(view, node)),
        "medium" => {
            let solid = scene.materials.iter().filter(|m| m.is_transmissive());
            let names = solid.map(|m| m.name.clone());
            std::iter::once("air".to_owned()).chain(names).collect()
        }
        _ => Vec::new(),
    }
}

/// The names of all parts of the scene's solids.
fn parts(scene: &Scene) -> Vec<String> {
    let leaves = scene.objects.iter().flat_map(|o| &o.leaves);
    let leaves = leaves.map(|leaf| leaf.name.clone());
    let own = (0u32..).zip(&scene.shapes).flat_map(|(primitive, _)| {
        let hit = move |part| Hit {
            t: 0.0,
            primitive,
            part,
            place: [0.0; 3],
        };
        (0..7).filter_map(move |part| scene.part_name(&hit(part)).map(str::to_owned))
    });
    let mut all: Vec<String> = leaves.chain(own).collect();
    all.sort();
    all.dedup();
    all
}

impl AnswerForm {
    /// The form of an answer; of a word, among these and itself.
    fn of(answer: &FieldValue, mut words: Vec<String>) -> Self {
        match answer {
            FieldValue::Number(_) => Self::Number,
            FieldValue::Numbers(list) => Self::Numbers(list.len()),
            FieldValue::Word(word) => {
                if !words.contains(word) {
                    words.push(word.clone());
                }
                words.dedup();
                Self::Word(words)
            }
        }
    }

    /// How an answer is written, for a prompt.
    pub fn asks(&self) -> String {
        match self {
            Self::Number => "a number".to_owned(),
            Self::Numbers(n) => format!("{n} numbers with commas between"),
            Self::Word(words) => words.join(" | "),
        }
    }
}
