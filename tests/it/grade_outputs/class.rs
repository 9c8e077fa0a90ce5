//! A class in a folder: a task with its scene, and what students handed in.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use assert_cmd::Command;
use raytree::accel::AccelKind;
use raytree::scene::{self, Bends, Settings};
use raytree::trace::{View, document, trace_pixel};
use raytree::world::World;
use serde_json::{Value, json};

const TASK: &str = r#"
format = "raytree-task/1"
name = "Hits & <b>terms</b>"
size = "64x48"
settings = { depth = 0 }
pass = 60

[[check]]
id = "hits"
title = "What eye rays meet"
points = 4
scene = "hits.json"
pixels = [[20, 40], [32, 24], [44, 30]]
ask = ["outcome", "object", "t"]
depth = 0

[[check]]
id = "light"
title = "Diffuse light <script>alert(1)</script>"
points = 2
needs = ["hits"]
scene = "hits.json"
pixels = [[20, 40], [32, 24], [44, 30]]
ask = ["law:diffuse", "color"]
depth = 0

[[check]]
id = "secret"
title = "Diffuse light elsewhere"
points = 3
visible = false
scene = "hits.json"
pixels = [[28, 24]]
ask = ["law:diffuse", "color"]
depth = 0
"#;

/// The pixels that are asked, the last one by the hidden check alone.
const PIXELS: [(u32, u32); 4] = [(20, 40), (32, 24), (44, 30), HIDDEN];

/// The pixel that is asked by the hidden check alone.
pub const HIDDEN: (u32, u32) = (28, 24);

/// What is wrong with a submission.
#[derive(Clone, Copy)]
pub enum Mistake {
    /// Nothing.
    None,
    /// A law is bent.
    Bend(&'static str),
    /// The t of all hits, multiplied.
    Scaled(f64),
}

/// A folder with a task and submissions.
pub struct Class(tempfile::TempDir);

impl Class {
    /// Three submissions in `in/`: one right, one with a mistake, one of no bytes.
    pub fn new() -> Self {
        let class = Self(tempfile::tempdir().expect("a folder"));
        let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/tasks/hits.json");
        fs::copy(scene, class.path("hits.json")).expect("copied");
        fs::write(class.path("task.toml"), TASK).expect("written");
        fs::create_dir(class.path("in")).expect("a folder");
        class.hand_in("ada", Mistake::None);
        class.hand_in("bo", Mistake::Bend("cos-missing"));
        fs::create_dir(class.path("in/empty")).expect("a folder");
        class
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes `in/NAME.ndjson`.
    pub fn hand_in(&self, name: &str, mistake: Mistake) {
        fs::write(self.path(&format!("in/{name}.ndjson")), trees(mistake)).expect("written");
    }

    /// The status, what was written to standard output, and what was told.
    pub fn run(&self, arguments: &str) -> (i32, String, String) {
        self.run_with(&arguments.split_whitespace().collect::<Vec<_>>(), &[])
    }

    /// The same with words as they are, and with environment variables.
    pub fn run_with(&self, words: &[&str], variables: &[(&str, &str)]) -> (i32, String, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
        command.current_dir(self.0.path()).arg("grade").args(words);
        command.envs(variables.iter().copied());
        let output = command.output().expect("it runs");
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        let status = output.status.code().expect("a status");
        (status, text(output.stdout), text(output.stderr))
    }

    /// The JSON of all submissions.
    pub fn json(&self, flags: &str) -> Value {
        let all = self.submissions().join(" ");
        let (status, out, told) = self.run(&format!(
            "task.toml {all} --output json=/dev/stdout {flags}"
        ));
        assert_eq!(status, 0, "{told}");
        serde_json::from_str(&out).expect("JSON")
    }

    /// All of `in/` in the order of names.
    pub fn submissions(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path("in")).expect("a folder");
        let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("UTF-8");
        let mut names: Vec<String> = entries
            .map(|entry| format!("in/{}", name(entry.expect("an entry"))))
            .collect();
        names.sort();
        names
    }

    /// A file that was written as the output of one submission.
    pub fn written(&self, kind: &str, file: &str, name: &str, flags: &str) -> String {
        let arguments =
            format!("task.toml in/{name}.ndjson --output {kind}={file} {flags} --threads 1");
        let (status, _, told) = self.run(&arguments);
        assert_eq!(status, 0, "{told}");
        fs::read_to_string(self.path(file)).expect("written")
    }

    /// The output for Classroom 50.
    pub fn classroom(&self, name: &str) -> String {
        let submission = format!("in/{name}.ndjson");
        let words = [
            "task.toml",
            &submission,
            "--output",
            "classroom50=result.json",
        ];
        let time = ["--datetime", "2026-02-28T23:59:00Z"];
        let variables = [
            ("CLASSROOM", "graphics"),
            ("ASSIGNMENT", "hits"),
            ("OWNER", name),
            ("SUBMISSION_TAG", "submit/1"),
            ("COMMIT_URL", "https://example.org/c"),
            ("RELEASE_URL", "https://example.org/r"),
        ];
        let (status, _, told) = self.run_with(&[&words[..], &time].concat(), &variables);
        assert_eq!(status, 0, "{told}");
        fs::read_to_string(self.path("result.json")).expect("written")
    }
}

/// The trees of all pixels, a line each.
pub fn trees(mistake: Mistake) -> String {
    static WORLD: OnceLock<(World, Settings)> = OnceLock::new();
    let (world, settings) = WORLD.get_or_init(|| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/tasks/hits.json");
        let scene = scene::load(path.to_str().expect("UTF-8")).expect("a scene");
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (64, 48);
            s.recursion.depth = 0;
        });
        (World::new(scene, AccelKind::List), settings)
    });
    let bends: Bends = match mistake {
        Mistake::Bend(name) => name.parse().expect("a bend"),
        _ => Bends::default(),
    };
    let settings = settings.with(|s| s.bends = bends);
    let line = |at: &(u32, u32)| {
        let trace = trace_pixel(world, &settings, *at, false);
        let document = document::of(View {
            world,
            settings: &settings,
            trace: &trace,
        });
        let mut value = serde_json::to_value(&document).expect("writable");
        if let Mistake::Scaled(factor) = mistake {
            let t = &mut value["samples"][0]["root"]["hit"]["t"];
            if let Some(ours) = t.as_f64() {
                *t = json!(ours * factor);
            }
        }
        format!("{value}\n")
    };
    PIXELS.iter().map(line).collect()
}
