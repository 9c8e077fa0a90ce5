//! `raytree diff`: where two ray trees of a pixel differ, and which law is broken.

use std::str::FromStr as _;

use clap::{Args, ValueEnum};

use super::changes::ChangeArgs;
use super::command_line::words;
use super::notices::Notices;
use super::output::to_stdout;
use super::settings::{SceneArgs, SettingsArgs};
use super::trees::{TreeSource, facts_of, parse_side, read_file};
use super::{Completion, Failure};
use crate::accel::clearest;
use crate::grade::compare::{Compared, TreeComparison};
use crate::grade::diff::{Sides, TreeDiff};
use crate::grade::follow::PixelReference;
use crate::grade::marks::CausingTree;
use crate::grade::output::difference;
use crate::grade::quantity::QuantityKind;
use crate::grade::tolerance::{Allowance, Tolerances};
use crate::scene::printable::shell_word;
use crate::scene::{Bends, Settings};
use crate::trace::facts::PixelFacts;
use crate::world::World;

#[derive(Args)]
pub struct Diff {
    /// What is right: SCENE@X,Y, a pixel of a scene; or a file of ray trees
    #[arg(value_name = "A")]
    a: String,
    /// What is compared with it: a file of ray trees, - for standard input, or SCENE@X,Y
    #[arg(value_name = "B")]
    b: String,
    #[command(flatten)]
    changes: ChangeArgs,
    #[command(flatten)]
    notices: Notices,
    /// Quantities to compare, with commas between; without, all that B tells
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_quantity)]
    ask: Vec<QuantityKind>,
    /// How far a quantity may be off: absolute, and relative to its size
    #[arg(long, value_name = "KIND=ABS[,REL]", value_parser = parse_tolerance)]
    tol: Vec<(QuantityKind, Allowance)>,
    /// Causes that are told at most
    #[arg(long, value_name = "N", default_value_t = 10)]
    max: usize,
    /// Mistakes that B makes, where B is a scene
    #[arg(long, value_name = "NAME[,NAME]")]
    bend_b: Option<Bends>,
    /// What to write
    #[arg(long, value_enum, default_value_t)]
    format: DiffFormat,
    #[command(flatten)]
    settings: SettingsArgs,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum DiffFormat {
    /// For reading
    #[default]
    Text,
    /// For programs: format raytree-diff/1
    Json,
    /// A page for a browser, with both trees side by side
    Html,
}

impl Diff {
    pub fn run(&self) -> Result<Completion, Failure> {
        let (a, b) = (parse_side(&self.a)?, parse_side(&self.b)?);
        let TreeSource::Scene { scene, pixel } = &a else {
            return self.files(&a, &b);
        };
        let (world, settings) = self.traced(scene)?;
        let ours = facts_of(&world, &settings, *pixel)?;
        let theirs = self.side(&b, *pixel)?;
        let of = PixelReference {
            scene: Some((&world, &settings)),
            pixel: *pixel,
            facts: &ours,
        };
        self.tell(of, &theirs, &world.scene.name)
    }

    /// Two files: without a scene, what is wrong before something else is its cause.
    fn files(&self, a: &TreeSource, b: &TreeSource) -> Result<Completion, Failure> {
        let TreeSource::File(path) = a else {
            return Ok(Completion::Whole);
        };
        let mut ours = read_file(path, None)?;
        let pixel = ours.pixel.unwrap_or_default();
        // Of what is no number nothing can be said.
        for ray in &mut ours.rays {
            ray.facts
                .retain(|(_, fact)| *fact != crate::trace::facts::Fact::Nothing);
        }
        let theirs = self.side(b, pixel)?;
        let of = PixelReference {
            scene: None,
            pixel,
            facts: &ours,
        };
        let name = ours.scene.clone().unwrap_or_else(|| path.clone());
        self.tell(of, &theirs, &name)
    }

    fn traced(&self, scene: &str) -> Result<(World, Settings), Failure> {
        let args = SceneArgs {
            scene: scene.to_owned(),
            changes: self.changes.clone(),
            notices: self.notices,
            settings: self.settings.clone(),
        };
        args.build(args.read()?, clearest)
    }

    /// The facts of B.
    fn side(&self, side: &TreeSource, pixel: (u32, u32)) -> Result<PixelFacts, Failure> {
        match side {
            TreeSource::File(path) => read_file(path, Some(pixel)),
            TreeSource::Scene { scene, pixel } => {
                let (world, settings) = self.traced(scene)?;
                let bends = self.bend_b.unwrap_or(settings.bends);
                facts_of(&world, &settings.with(|s| s.bends = bends), *pixel)
            }
        }
    }

    fn tell(
        &self,
        of: PixelReference,
        theirs: &PixelFacts,
        scene: &str,
    ) -> Result<Completion, Failure> {
        for problem in &theirs.problems {
            self.notices.warn(problem);
        }
        let tolerances = Tolerances(self.tol.iter().copied().collect());
        let told: Vec<QuantityKind> = theirs
            .rays
            .iter()
            .flat_map(|ray| {
                ray.facts
                    .iter()
                    .map(|(name, _)| QuantityKind::of(ray.kind, name))
            })
            .collect();
        let asks = |quantity: QuantityKind| match quantity {
            QuantityKind::Sent => true,
            QuantityKind::Unit => self.ask.is_empty() || self.ask.contains(&quantity),
            _ if self.ask.is_empty() => told.contains(&quantity),
            _ => self.ask.contains(&quantity),
        };
        let diff = TreeDiff::new(of, theirs, &tolerances, &asks);
        let open = |compared: &Compared| self.open(of, compared);
        let sides = Sides {
            scene,
            pixel: of.pixel,
            a: &self.a,
            b: &self.b,
            open: &open,
        };
        let text = match self.format {
            DiffFormat::Text => diff.to_text(sides, self.max),
            DiffFormat::Json => format!("{:#}\n", diff.to_json(sides)),
            DiffFormat::Html => {
                let comparison = TreeComparison::new(of, theirs, &tolerances);
                let kept = CausingTree::new(of.pixel, comparison, &|c| asks(c.quantity));
                difference((sides, &diff), of.facts, &kept, self.max)
            }
        };
        to_stdout(text.as_bytes())?;
        Ok(if diff.is_empty() {
            Completion::Whole
        } else {
            Completion::No
        })
    }

    /// The command that opens our tree at a ray, in a picture of the size that was compared.
    fn open(&self, of: PixelReference, compared: &Compared) -> String {
        let scene = self
            .a
            .rsplit_once('@')
            .map_or(self.a.as_str(), |(scene, _)| scene);
        let (x, y) = of.pixel;
        let words = if let Some((world, settings)) = of.scene {
            words(scene, settings, &world.scene)
        } else {
            let size = self.settings.size();
            let size = size.map_or(String::new(), |(w, h)| format!(" --size {w}x{h}"));
            shell_word(scene) + &size
        };
        format!("raytree view {words} --at {x},{y}{}", compared.path)
    }
}

fn parse_quantity(text: &str) -> Result<QuantityKind, String> {
    QuantityKind::from_str(text).map_err(|_| {
        use strum::VariantArray as _;
        let names: Vec<&str> = QuantityKind::VARIANTS.iter().map(|q| q.name()).collect();
        format!("`{text}` is no quantity; there are {}", names.join(", "))
    })
}

fn parse_tolerance(text: &str) -> Result<(QuantityKind, Allowance), String> {
    let wrong =
        || format!("`{text}` is no tolerance; write KIND=ABS or KIND=ABS,REL, such as t=1e-4,1e-3");
    let (kind, values) = text.split_once('=').ok_or_else(wrong)?;
    let (absolute, relative) = values.split_once(',').unwrap_or((values, "0"));
    let number = |text: &str| {
        let x = text.trim().parse::<f64>().ok();
        x.filter(|x| x.is_finite() && *x >= 0.0).ok_or_else(wrong)
    };
    let allowance = Allowance {
        absolute: number(absolute)?,
        relative: number(relative)?,
    };
    Ok((parse_quantity(kind)?, allowance))
}
