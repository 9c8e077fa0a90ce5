//! What must hold for every input, however bad.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::probe::Silent;
use raytree::scene::{Scene, SceneError, load_from_memory};
use raytree::trace::export::{Dot, Svg, Text};
use raytree::trace::{PixelTrace, RayTree, Recorder, View, document, explain, ledger};
use raytree::tracer::{draw, pixel};
use raytree::world::World;

use super::memory::{Memory, counted};
use super::written_out::written_out;

/// A scene file or a model, `main`, and the files beside it.
#[derive(Clone, Debug, Default)]
pub struct Case {
    /// The file that is loaded.
    pub main: String,
    /// All files by their names.
    pub files: BTreeMap<String, Vec<u8>>,
}

/// A law that does not hold.
#[derive(Clone, Debug)]
pub struct Broken {
    /// Which.
    pub law: &'static str,
    /// How.
    pub how: String,
}

/// What became of an input.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// True if it is a scene.
    pub accepted: bool,
    /// What reading it took.
    pub memory: Memory,
}

/// Memory that reading anything may take, and the factor on the bytes of the input.
const BASE: usize = 64 << 10;
pub const FACTOR: usize = 64;

/// A leaf of a patch counts as so many bytes of input: it takes up to a kilobyte.
const LEAF: usize = 16;

/// The edge of the picture that is made of what is accepted, and the rays of each pixel.
const EDGE: u32 = 8;
const RAYS: u64 = 40;

thread_local! {
    /// Where this thread panicked last, while its panics are caught.
    static CAUGHT: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Panics of inputs are noted instead of printed.
pub fn catch_panics() {
    static ONCE: std::sync::Once = std::sync::Once::new();
    ONCE.call_once(|| {
        // Made once for all messages: no input's memory.
        let _ = raytree::scene::file::schema();
        let usual = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            CAUGHT.with(|caught| match caught.try_borrow_mut() {
                Ok(mut place) if place.is_some() => {
                    *place = Some(info.to_string().replace('\n', " "));
                }
                _ => usual(info),
            });
        }));
    });
}

/// Does the work; its panic, if it has one, is a broken law.
pub fn without_panic<T>(work: impl FnOnce() -> Result<T, Broken>) -> Result<T, Broken> {
    CAUGHT.with(|caught| *caught.borrow_mut() = Some(String::new()));
    let done = catch_unwind(AssertUnwindSafe(work));
    let how = CAUGHT.with(|caught| caught.borrow_mut().take());
    done.unwrap_or_else(|_| Err(broken("no panic", how.unwrap_or_default())))
}

fn broken(law: &'static str, how: impl Into<String>) -> Broken {
    Broken {
        law,
        how: how.into(),
    }
}

impl Case {
    /// A case whose main file is `scene.json` if there is one, else `m.obj`.
    pub fn new(files: BTreeMap<String, Vec<u8>>) -> Self {
        let main = if files.contains_key("scene.json") {
            "scene.json"
        } else {
            "m.obj"
        };
        Self {
            main: main.to_string(),
            files,
        }
    }

    /// Bytes of all files, each as often as it is named: a model that a scene shows ten times is read ten times. So are parts, which
    /// are resolved at each use. A patch is kept as up to 256 leaves, each of which has as many points.
    pub fn size(&self) -> usize {
        let size = |name: &str| self.files.get(name).map_or(0, Vec::len);
        let scene = self.files.get("scene.json").map_or(&[][..], Vec::as_slice);
        let weight = written_out(scene);
        let models = weight.models.max(1) * (size("m.obj") + size("x.mtl"));
        weight.bytes + models + 256 * LEAF * weight.patches
    }

    /// Reads it, and checks all laws of reading. `work` is what well-formed files cost: bytes of memory in all, for
    /// each byte of input.
    pub fn read(&self, work: Option<f64>) -> Result<(Option<Scene>, Outcome), Broken> {
        let size = self.size();
        without_panic(|| {
            let held = self.files.clone();
            let (read, memory) = counted(|| load_from_memory(&self.main, held));
            let outcome = Outcome {
                accepted: read.is_ok(),
                memory,
            };
            if memory.peak > BASE + FACTOR * size {
                return Err(broken(
                    "memory",
                    format!("{} bytes for {size} bytes of input", memory.peak),
                ));
            }
            if let Some(work) = work
                && memory.total as f64 > BASE as f64 + 2.5 * work * size as f64
            {
                return Err(broken(
                    "work",
                    format!("{} bytes in all for {size} bytes of input", memory.total),
                ));
            }
            match read {
                Ok(scene) => Ok((Some(scene), outcome)),
                Err(error) => self.check_message(&error).map(|()| (None, outcome)),
            }
        })
    }

    /// An error has two lines: where and what, and what to do; the place is one that there is.
    fn check_message(&self, error: &SceneError) -> Result<(), Broken> {
        let said = error.to_string();
        let odd = |why: &str| Err(broken("message", format!("{why}: {said}")));
        if said.lines().count() != 2 || said.chars().any(|c| c.is_control() && c != '\n') {
            return odd("not two plain lines");
        }
        if error.problem.what.trim().is_empty() || error.problem.cure.trim().is_empty() {
            return odd("half of it is missing");
        }
        let words = [
            "Some(",
            "Err(",
            "None",
            "struct ",
            "variant",
            "usize",
            "panicked",
            "unwrap",
            "expected value",
            // What the reader of models says by itself has no place.
            "up to this one",
        ];
        let own = words.iter().find(|word| {
            // It may quote what the file says.
            let mut files = self.files.values();
            said.contains(*word) && !files.any(|file| count(file, word.as_bytes()) > 0)
        });
        if let Some(word) = own {
            return odd(&format!("`{word}` is a programmer's word"));
        }
        let name = error.file.trim_start_matches("./");
        let Some(file) = self.files.get(name) else {
            return odd("it names no file of the input");
        };
        let Some((line, column)) = error.position else {
            // About a field, or about the whole file.
            let whole = [
                "is empty",
                "not a scene",
                "no face",
                "UTF-8",
                "at most",
                "more than",
                "without area",
                "no such file",
            ];
            let known = !error.field.is_empty() || whole.iter().any(|word| said.contains(word));
            return if known { Ok(()) } else { odd("no place") };
        };
        // In a model a lone CR ends a line, too.
        let model = name != "scene.json";
        let end = |b: &u8| *b == b'\n' || (model && *b == b'\r');
        let length = file.split(end).nth(line.wrapping_sub(1)).map(<[u8]>::len);
        match length {
            // The end of the file counts as a place.
            Some(length) if column <= length + 1 => Ok(()),
            None if line == 1 + count(file, b"\n") => Ok(()),
            _ => odd("there is no such place"),
        }
    }
}

/// What an accepted scene must do: its picture is made of finite numbers at a bounded cost, a pixel traced again is that of
/// the picture whatever finds the hits, its ledger closes, and it can be written down in every way.
pub fn check_picture(scene: &Scene, chance: usize) -> Result<(), Broken> {
    without_panic(|| picture(scene, chance))
}

fn picture(scene: &Scene, chance: usize) -> Result<(), Broken> {
    let accel = AccelKind::ALL[chance % AccelKind::ALL.len()];
    let settings = scene.settings.with(|s| {
        s.image.width = EDGE;
        s.image.height = EDGE;
        s.recursion.max_rays = RAYS * u64::from(EDGE * EDGE);
        s.accel = accel;
    });
    let world = World::new(scene.clone(), accel);
    let film = draw(&world, &settings, 1);
    if film.rays > settings.recursion.max_rays {
        return Err(broken(
            "budget",
            format!("{} rays of {}", film.rays, settings.recursion.max_rays),
        ));
    }
    let finite = |c: Rgb| c.channels().into_iter().all(|x| x.is_finite() && x >= 0.0);
    if let Some(odd) = film.pixels.iter().find(|c| !finite(**c)) {
        return Err(broken(
            "finite",
            format!("a pixel is {odd:?} by {}", accel.name()),
        ));
    }
    let at = (chance as u32 / 16 % EDGE, chance as u32 / 128 % EDGE);
    let mut recorder = Recorder::<true>::with_limit(200_000);
    let traced = pixel(&world, &settings, at, &mut recorder);
    let tree = RayTree::new(recorder);
    let trace = PixelTrace {
        x: at.0,
        y: at.1,
        pixel: traced,
        tree,
    };
    if traced.color != film.at(at.0, at.1) {
        return Err(broken(
            "replay",
            format!(
                "{:?} is not {:?} at {at:?}",
                traced.color,
                film.at(at.0, at.1)
            ),
        ));
    }
    let list = World::new(scene.clone(), AccelKind::List);
    let by_list = pixel(&list, &settings, at, &mut Silent);
    if by_list.color != traced.color {
        let how = format!(
            "{} says {:?}, the list {:?} at {at:?}",
            accel.name(),
            traced.color,
            by_list.color
        );
        return Err(broken("accelerators agree", how));
    }
    if trace.tree.dropped > 0 {
        return Ok(());
    }
    if let Some(node) = ledger::first_open(&trace.tree) {
        return Err(broken("ledger", format!("node {node} does not close")));
    }
    if ledger::pixel_sum(&trace) != traced.color {
        return Err(broken("ledger", "the samples do not add up to the pixel"));
    }
    written(
        View {
            world: &world,
            settings: &settings,
            trace: &trace,
        },
        chance,
    )
}

/// Every way to write a tree down ends well, and the JSON is JSON.
fn written(view: View, chance: usize) -> Result<(), Broken> {
    let document = document::of(view);
    let json = serde_json::to_string(&document).map_err(|e| broken("json", e.to_string()))?;
    serde_json::from_str::<serde_json::Value>(&json).map_err(|e| broken("json", e.to_string()))?;
    let shown = match chance / 1024 % 3 {
        0 => Text(&document).to_string(),
        1 => Dot(&document).to_string(),
        _ => Svg(&document).to_string(),
    };
    if shown.is_empty() {
        return Err(broken("written", "nothing is shown"));
    }
    for index in 0..view.trace.tree.events.len().min(100) {
        let _ = explain(view, index);
    }
    Ok(())
}

/// How often `piece` stands in `bytes`.
pub fn count(bytes: &[u8], piece: &[u8]) -> usize {
    let windows = bytes.windows(piece.len());
    // The first byte alone tells nearly all of them apart, and quicker than the whole.
    windows.filter(|w| w[0] == piece[0] && *w == piece).count()
}
