//! What a submission gives, sorted: trees by scene and pixel, pictures by name.

use std::collections::HashMap;

use crate::grade::submission::{HIDDEN, Submission};
use crate::grade::task::Task;
use crate::scene::printable::excerpt;
use crate::trace::facts::PixelFacts;
use crate::trace::format::counted;
use crate::trace::query::Pattern;
use crate::trace::read::read_trees;

/// Problems of a submission that are kept.
const MOST_PROBLEMS: usize = 50;

/// Scenes that a problem lists.
const LISTED: usize = 8;

/// A submission that was read.
#[derive(Default)]
pub struct Given {
    /// Trees by the index of their scene in the task, and their pixel; of two of one pixel that.
    trees: HashMap<(usize, (u32, u32)), Result<PixelFacts, String>>,
    /// Pictures: names and bytes.
    pub pictures: Vec<(String, Vec<u8>)>,
    /// What could not be read, in words.
    pub problems: Vec<String>,
}

impl Given {
    /// Reads all trees of a submission.
    pub fn new(task: &Task, submission: Submission) -> Self {
        let mut given = Self {
            problems: submission.problems,
            ..Self::default()
        };
        for file in submission.files {
            let start = file.bytes.iter().find(|byte| !byte.is_ascii_whitespace());
            if matches!(start, Some(b'{' | b'[')) || file.name.ends_with("json") {
                let before = given.problems.len();
                given.read(task, &file.name, &file.bytes);
                given.hide(before, &file.name);
            } else {
                given.pictures.push((file.name, file.bytes));
            }
        }
        given.problems.truncate(MOST_PROBLEMS);
        given
    }

    /// Counts the problems of a file of hidden pixels: their words could tell where those are.
    fn hide(&mut self, before: usize, name: &str) {
        let count = self.problems.len() - before;
        if name.contains(HIDDEN) && count > 0 {
            self.problems.truncate(before);
            self.problems.push(format!(
                "hidden pixels: {} in what was printed",
                counted(count as u64, "problem")
            ));
        }
    }

    /// Tells a problem, unless it is told already.
    fn tell(&mut self, problem: Option<String>) {
        let is_new = |problem: &String| !self.problems.contains(problem);
        self.problems.extend(problem.filter(is_new));
    }

    fn read(&mut self, task: &Task, name: &str, bytes: &[u8]) {
        for tree in read_trees(bytes, name) {
            let tree = match tree {
                Ok(tree) => tree,
                Err(error) => {
                    self.problems.push(error.in_a_line());
                    continue;
                }
            };
            self.problems.extend(
                tree.problems
                    .iter()
                    .map(|problem| format!("{name}: {problem}")),
            );
            let Some(pixel) = tree.pixel.or_else(|| only_pixel(task)) else {
                self.problems.push(format!(
                    "{name}: a tree does not tell its pixel; write \"pixel\": [x, y]"
                ));
                continue;
            };
            let scenes = scenes_of(task, name, &tree);
            self.tell(about_scene(task, name, &tree, &scenes));
            for scene in scenes {
                let twice = || {
                    Err(format!(
                        "{name}: there are two trees of pixel {},{}",
                        pixel.0, pixel.1
                    ))
                };
                let entry = self.trees.entry((scene, pixel));
                entry
                    .and_modify(|tree| *tree = twice())
                    .or_insert_with(|| Ok(tree.clone()));
            }
        }
    }

    /// The tree of a pixel, or what is wrong with it.
    pub fn tree(&self, scene: usize, pixel: (u32, u32)) -> Result<Option<&PixelFacts>, &str> {
        match self.trees.get(&(scene, pixel)) {
            None => Ok(None),
            Some(Ok(tree)) => Ok(Some(tree)),
            Some(Err(problem)) => Err(problem),
        }
    }

    /// The picture of a name, in which `*` stands for any letters, in whatever folder.
    pub fn picture(&self, pattern: &str) -> Option<&(String, Vec<u8>)> {
        let pattern = Pattern(pattern.to_owned());
        let fits = |name: &str| pattern.matches(name.rsplit('/').next().unwrap_or(name));
        self.pictures.iter().find(|(name, _)| fits(name))
    }

    /// Adds a tree, for tracers that are run and for the self-test.
    pub fn add(&mut self, scene: usize, pixel: (u32, u32), tree: PixelFacts) {
        self.trees.insert((scene, pixel), Ok(tree));
    }
}

/// The pixel of a task that asks for one alone.
fn only_pixel(task: &Task) -> Option<(u32, u32)> {
    use crate::grade::task::CheckKind;
    let mut pixels = task.checks.iter().filter_map(|check| match &check.kind {
        CheckKind::Trees { pixels, .. } => Some(pixels.iter().filter_map(|p| p.pixel)),
        _ => None,
    });
    let first = pixels.next()?.next()?;
    pixels
        .flatten()
        .all(|pixel| pixel == first)
        .then_some(first)
}

/// What is wrong with the scene that a tree says it is of, or that its file is named after. `scenes` are those it is taken for.
fn about_scene(task: &Task, file: &str, tree: &PixelFacts, scenes: &[usize]) -> Option<String> {
    let name = |index: &usize| excerpt(&task.scenes[*index].world.scene.name);
    let asked: Vec<String> = (0..task.scenes.len().min(LISTED))
        .map(|index| name(&index))
        .collect();
    match (&tree.scene, scenes) {
        (Some(told), _) if !is_asked(task, told) => Some(format!(
            "{file}: is of the scene `{}`, and the task asks {}",
            excerpt(told),
            asked.join(", ")
        )),
        (None, []) => Some(format!(
            "{file}: does not tell which scene it is of; name the file after the scene"
        )),
        _ => None,
    }
}

/// The name of a file without folders and endings.
fn stem(path: &str) -> &str {
    let name = path.rsplit('/').next().unwrap_or(path);
    name.split('.').next().unwrap_or(name)
}

/// True if a scene of the task has this name, or its file has it.
fn is_asked(task: &Task, name: &str) -> bool {
    let mut scenes = task.scenes.iter();
    scenes.any(|scene| scene.world.scene.name == name || stem(&scene.path) == name)
}

/// The scenes of the task that a tree is of: by its own word, else by the name of its file, else the only one.
fn scenes_of(task: &Task, file: &str, tree: &PixelFacts) -> Vec<usize> {
    let file = stem(file);
    let named = |name: &str| {
        let scenes = task.scenes.iter().enumerate();
        let those =
            scenes.filter(|(_, scene)| scene.world.scene.name == name || stem(&scene.path) == name);
        those.map(|(index, _)| index).collect::<Vec<_>>()
    };
    let by_word = tree.scene.as_deref().map(named).unwrap_or_default();
    if !by_word.is_empty() {
        return by_word;
    }
    let by_file = named(file);
    if !by_file.is_empty() || task.scenes.len() > 1 {
        return by_file;
    }
    vec![0]
}
