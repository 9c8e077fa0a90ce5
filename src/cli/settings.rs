//! The flags that several commands share: a scene, a flag for every knob, and the number of threads.

pub mod check;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser as _, ValueParser};
use clap::error::Error;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};

use super::changes::ChangeArgs;
use super::notices::Notices;
use super::{Failure, build_progress};
use crate::accel::{AccelKind, fastest};
use crate::geometry::{PatchMethod, Shape};
use crate::scene::effects::effects;
use crate::scene::limits::{MAX_PRIMITIVES, MAX_THREADS};
use crate::scene::settings::knob::{Kind, Knob, Value, Word, parse_whole};
use crate::scene::settings::knobs::knobs;
use crate::scene::{Patch, Scene, SceneSource, Settings, label, source, squares_that_fit};
use crate::world::{World, checks};

/// What decides on the accelerator if the user does not.
pub type Decide = fn(&[Shape]) -> AccelKind;

/// The word of `--accel` that leaves the choice to the program.
const AUTO: Word = Word {
    name: "auto",
    doc: "The fastest for the scene, as measured",
};

/// Which scene, and how it is traced. What is not given is what the scene asks for.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// A built-in scene, a .json scene file, an .obj file, or - for a scene file on standard input
    pub scene: String,
    #[command(flatten)]
    pub changes: ChangeArgs,
    #[command(flatten)]
    pub notices: Notices,
    #[command(flatten)]
    pub settings: SettingsArgs,
}

/// A scene that was read.
pub struct ReadScene {
    pub scene: Scene,
    /// Where it comes from.
    pub source: SceneSource,
    /// What was changed of it.
    pub patch: Patch,
}

/// The knobs that are given, and the number of threads.
#[derive(Clone, Debug, Default)]
pub struct SettingsArgs {
    given: Vec<(&'static Knob, Value)>,
    /// Threads; 0 for one a core.
    pub threads: usize,
}

impl SettingsArgs {
    /// The value of a flag, if it is given.
    fn value(&self, flag: &str) -> Option<&Value> {
        let found = self.given.iter().find(|(knob, _)| knob.flag == flag);
        found.map(|(_, value)| value)
    }

    /// Whether a flag is given.
    pub fn gives(&self, flag: &str) -> bool {
        self.value(flag).is_some()
    }

    /// The size, if it is given.
    pub fn size(&self) -> Option<(u32, u32)> {
        match self.value("size")? {
            Value::Size([width, height]) => Some((*width, *height)),
            _ => None,
        }
    }

    /// The scene's settings with what the command line changes; `accel` decides where it says nothing.
    pub fn over(&self, scene: &Scene, accel: Decide) -> Settings {
        let mut settings = scene.settings;
        settings.effects = effects(scene);
        settings.accel = match self.value("accel") {
            Some(value) if value.is(AUTO.name) => fastest(&scene.shapes),
            _ => accel(&scene.shapes),
        };
        let (first, then): (Vec<_>, Vec<_>) =
            self.given.iter().partition(|(k, _)| k.implies_others);
        for (knob, value) in first.into_iter().chain(then) {
            (knob.field.set)(&mut settings, value);
        }
        settings
    }
}

impl Args for SettingsArgs {
    fn augment_args(command: Command) -> Command {
        let threads = Arg::new("threads")
            .long("threads")
            .value_name("N")
            .help("Threads; 0 for one a core")
            .help_heading("Settings")
            .default_value("0")
            .value_parser(parse_threads);
        command.args(knobs().map(arg)).arg(threads)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for SettingsArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let value = |knob: &'static Knob| {
            let mut values = matches.get_many::<Value>(knob.flag)?;
            let value = match knob.kind {
                Kind::Choices(_) => Value::List(values.map(Value::to_string).collect()),
                _ => values.next_back()?.clone(),
            };
            Some((knob, value))
        };
        Ok(Self {
            given: knobs().filter_map(value).collect(),
            threads: matches.get_one("threads").copied().unwrap_or_default(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The flag of a knob.
fn arg(knob: &'static Knob) -> Arg {
    let default = (knob.field.get)(&Settings::default()).filter(|_| knob.shows_default);
    let default = default.map_or(String::new(), |value| format!(" [default: {value}]"));
    let arg = Arg::new(knob.flag)
        .long(knob.flag)
        .value_name(knob.value_name)
        .help(format!("{}{default}", knob.doc))
        .help_heading(knob.heading)
        .value_parser(parser(knob));
    let arg = match knob.kind {
        Kind::Choices(_) => arg.action(ArgAction::Append).value_delimiter(','),
        _ => arg,
    };
    let arg = knob.requires.into_iter().fold(arg, Arg::requires);
    knob.conflicts_with
        .into_iter()
        .fold(arg, Arg::conflicts_with)
}

/// The parser of a knob's values.
fn parser(knob: &Knob) -> ValueParser {
    let kind = knob.kind;
    match kind {
        Kind::Choice(words) | Kind::Choices(words) => {
            let auto = (knob.flag == "accel").then_some(AUTO);
            let words = auto.into_iter().chain(words()).map(|word| {
                let value = PossibleValue::new(word.name);
                match word.doc {
                    "" => value,
                    doc => value.help(doc),
                }
            });
            PossibleValuesParser::new(words).map(Value::Text).into()
        }
        _ => ValueParser::from(move |text: &str| kind.parse(text)),
    }
}

impl SceneArgs {
    /// Reads the scene and tells its warnings.
    pub fn read(&self) -> Result<Scene, Failure> {
        self.read_source().map(|read| read.scene)
    }

    /// Reads the scene with its changes, tells its warnings, and keeps where it comes from.
    pub fn read_source(&self) -> Result<ReadScene, Failure> {
        let (edits, file) = self.changes.edits()?;
        let source = match self.scene.as_str() {
            "-" => SceneSource::stdin()?,
            name => source(name)?,
        };
        let (mut scene, patch) = source.changed(&edits)?;
        scene.files.extend(file);
        self.notices.tell(&scene.warnings);
        Ok(ReadScene {
            scene,
            source,
            patch,
        })
    }

    /// Name of the scene in messages.
    pub fn label(&self) -> &str {
        label(&self.scene)
    }

    /// Builds the scene's accelerator: what `accel` says if the user does not. Tells all other warnings, which the scene then has,
    /// and fails if none is allowed.
    pub fn build(&self, scene: Scene, accel: Decide) -> Result<(World, Settings), Failure> {
        let notices = self.notices;
        let settings = self.settings.over(&scene, accel);
        check::pixel(&settings.pixel)?;
        for effect in settings.left_out(&scene) {
            let text = format!("{} is left out: {}", effect.name(), effect.without());
            notices.note(text);
        }
        for deviation in settings.arithmetic.deviations() {
            notices.note(format!(
                "--{} {}: {}",
                deviation.choice, deviation.value, deviation.note
            ));
        }
        if let PatchMethod::Triangles(wanted) = settings.arithmetic.patch {
            let squares = squares_that_fit(&scene, wanted);
            if squares < wanted {
                notices.note(format!(
                    "there is only room for --patch-test triangles:{squares}: a scene has at most {MAX_PRIMITIVES} shapes"
                ));
            }
        }
        let scene = scene.computed_with(settings.arithmetic);
        let mut world = build_progress::world(scene, settings.accel, notices.quiet);
        let found = checks::warnings(&world, &settings, self.label());
        notices.tell(&found);
        world.scene.warnings.extend(found);
        notices.deny(self.label(), world.scene.warnings.len())?;
        Ok((world, settings))
    }
}

fn parse_threads(text: &str) -> Result<usize, String> {
    parse_whole(text, 0..=MAX_THREADS as u64).map(|n| n as usize)
}
