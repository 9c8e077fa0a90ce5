//! The flags that several commands share.

pub mod samples;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use self::samples::SampleArgs;
use super::{Failure, building};
use crate::accel::AccelKind;
use crate::accel::fastest;
use crate::geometry::{Arithmetic, Offset, Precision, Quadratic, Shape, TriangleTest};
use crate::math::{LightSampling, Sampler};
use crate::scene::effects::effects;
use crate::scene::{AreaLightSampling, Effect, Image, Recursion, Scene, Settings, limits};
use crate::shading::Fresnel;
use crate::world::World;

/// What decides on the accelerator if the user does not.
pub type Decide = fn(&[Shape]) -> AccelKind;

/// Which scene, and how it is traced. What is not given is what the scene asks for.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// A built-in scene, a .json scene file or an .obj file
    pub scene: String,
    #[command(flatten)]
    pub settings: SettingsArgs,
}

/// The knobs.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Settings")]
pub struct SettingsArgs {
    /// Size of the picture in pixels [default: 320x240]
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub size: Option<(u32, u32)>,
    /// Shadow rays to an area light, a hit
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(limits::MAX_LIGHT_SAMPLES)))]
    pub light_samples: Option<u32>,
    /// Where on an area light they go
    #[arg(long, value_enum)]
    sampler: Option<SamplerArg>,
    /// In proportion to what places on an area light are chosen
    #[arg(long, value_enum)]
    light_sampling: Option<LightSamplingArg>,
    /// How often a ray may bounce
    #[arg(long, value_name = "N")]
    depth: Option<u32>,
    /// Do not send rays that could add less than this to the pixel
    #[arg(long, value_name = "W", value_parser = parse_not_negative)]
    min_weight: Option<f64>,
    /// How transparent surfaces share light between reflection and transmission
    #[arg(long, value_enum)]
    fresnel: Option<FresnelArg>,
    /// Factor on the picture before it is clamped
    #[arg(long, value_name = "X", value_parser = parse_not_negative)]
    exposure: Option<f64>,
    /// Effects to leave out, though the scene calls for them
    #[arg(long, value_name = "EFFECT", value_delimiter = ',', value_parser = effect_names())]
    without: Vec<Effect>,
    /// Seed of all random numbers
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// How hits are found; never changes the picture. Where it is not given: auto for pictures; for looking at rays a
    /// BSP tree, or wide for large scenes
    #[arg(long, value_name = "ACCEL", value_parser = accels())]
    accel: Option<AccelArg>,
    /// Rays that the whole picture may cost
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    max_rays: Option<u64>,
    /// Threads; 0 for one a core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = parse_threads)]
    pub threads: usize,
    #[command(flatten)]
    pub samples: SampleArgs,
    #[command(flatten)]
    arithmetic: ArithmeticArgs,
}

/// Arithmetic other than raytree's own, to see what goes wrong with it: see `raytree stability`.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Other arithmetic, to see what goes wrong (see raytree stability)")]
struct ArithmeticArgs {
    /// How triangles are tested [default: watertight]
    #[arg(long, value_name = "TEST", value_parser = named(TriangleTest::ALL, TriangleTest::name))]
    triangle: Option<TriangleTest>,
    /// Where rays start that leave a surface: none, fixed:EPS (metres along the normal) or bounded [default: bounded]
    #[arg(long, value_name = "OFFSET")]
    offset: Option<Offset>,
    /// How spheres are tested [default: stable]
    #[arg(long, value_name = "FORMULA", value_parser = named(Quadratic::ALL, Quadratic::name))]
    quadratic: Option<Quadratic>,
    /// The numbers that shapes are tested with [default: double]
    #[arg(long, value_name = "BITS", value_parser = named(Precision::ALL, Precision::name))]
    precision: Option<Precision>,
}

impl ArithmeticArgs {
    fn over(&self, asked: Arithmetic) -> Arithmetic {
        Arithmetic {
            triangle: self.triangle.unwrap_or(asked.triangle),
            offset: self.offset.unwrap_or(asked.offset),
            quadratic: self.quadratic.unwrap_or(asked.quadratic),
            precision: self.precision.unwrap_or(asked.precision),
        }
    }
}

#[derive(ValueEnum, Clone, Copy, Debug)]
enum SamplerArg {
    /// The middles of a grid: hard bands
    Grid,
    /// Anywhere by chance: noise
    Random,
    /// By chance, one in each cell of a grid
    Stratified,
    /// Sobol's sequence, scrambled: the least noise
    Sobol,
}

#[derive(ValueEnum, Clone, Copy, Debug)]
enum LightSamplingArg {
    /// To its area
    Area,
    /// To what they bring to a matt surface, so that only what stands in the way is noise
    Projected,
}

#[derive(ValueEnum, Clone, Copy, Debug)]
enum FresnelArg {
    /// The material's coefficients at every angle
    None,
    /// Schlick's approximation
    Schlick,
    /// Fresnel's equations
    Exact,
}

#[derive(Clone, Copy, Debug)]
enum AccelArg {
    /// The fastest for the scene, as measured.
    Auto,
    /// This one.
    Kind(AccelKind),
}

impl SettingsArgs {
    /// The scene's settings with what the command line changes; `accel` decides where it says nothing.
    pub fn over(&self, scene: &Scene, accel: Decide) -> Settings {
        let asked = &scene.settings;
        let (width, height) = self.size.unwrap_or(asked.size());
        Settings {
            image: Image {
                width,
                height,
                exposure: self.exposure.unwrap_or(asked.image.exposure),
            },
            pixel: self.samples.over(&asked.pixel),
            light: AreaLightSampling {
                samples: self.light_samples.unwrap_or(asked.light.samples),
                sampler: self.sampler.map_or(asked.light.sampler, |s| match s {
                    SamplerArg::Grid => Sampler::Grid,
                    SamplerArg::Random => Sampler::Random,
                    SamplerArg::Stratified => Sampler::Stratified,
                    SamplerArg::Sobol => Sampler::Sobol,
                }),
                density: self
                    .light_sampling
                    .map_or(asked.light.density, |s| match s {
                        LightSamplingArg::Area => LightSampling::Area,
                        LightSamplingArg::Projected => LightSampling::Projected,
                    }),
            },
            recursion: Recursion {
                depth: self.depth.unwrap_or(asked.recursion.depth),
                min_weight: self.min_weight.unwrap_or(asked.recursion.min_weight),
                max_rays: self.max_rays.unwrap_or(asked.recursion.max_rays),
            },
            effects: self
                .without
                .iter()
                .fold(effects(scene), |set, effect| set.without(*effect)),
            seed: self.seed.unwrap_or(asked.seed),
            fresnel: self.fresnel.map_or(asked.fresnel, |f| match f {
                FresnelArg::None => Fresnel::None,
                FresnelArg::Schlick => Fresnel::Schlick,
                FresnelArg::Exact => Fresnel::Exact,
            }),
            accel: match self.accel {
                None => accel(&scene.shapes),
                Some(AccelArg::Auto) => fastest(&scene.shapes),
                Some(AccelArg::Kind(kind)) => kind,
            },
            arithmetic: self.arithmetic.over(asked.arithmetic),
        }
    }
}

impl SceneArgs {
    /// Reads the scene, tells its warnings and builds its accelerator: what `accel` says if the user does not.
    pub fn load(&self, accel: Decide) -> Result<(World, Settings), Failure> {
        let scene = crate::scene::load(&self.scene)?;
        for warning in &scene.warnings {
            eprintln!("warning: {warning}");
        }
        let settings = self.settings.over(&scene, accel);
        samples::check(&settings.pixel)?;
        for effect in settings.left_out(&scene) {
            eprintln!("note: {} is left out: {}", effect.name(), effect.without());
        }
        for deviation in settings.arithmetic.deviations() {
            eprintln!(
                "note: --{} {}: {}",
                deviation.choice, deviation.value, deviation.note
            );
        }
        let scene = scene.computed_with(settings.arithmetic);
        Ok((building::world(scene, settings.accel), settings))
    }
}

/// The names of all accelerators, and `auto`.
fn accels() -> impl TypedValueParser<Value = AccelArg> {
    let auto = PossibleValue::new("auto").help("The fastest for the scene, as measured");
    let kinds = AccelKind::ALL.map(|kind| PossibleValue::new(kind.name()).help(kind.note()));
    PossibleValuesParser::new(std::iter::once(auto).chain(kinds)).map(|name| {
        let kind = AccelKind::ALL.into_iter().find(|kind| kind.name() == name);
        kind.map_or(AccelArg::Auto, AccelArg::Kind)
    })
}

/// One of a closed set, by its name.
fn named<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.map(name)).try_map(move |text| {
        let found = all.into_iter().find(|one| name(*one) == text);
        found.ok_or("is not among the possible values")
    })
}

fn effect_names() -> impl TypedValueParser<Value = Effect> {
    let names = Effect::ALL.map(|e| PossibleValue::new(e.name()).help(e.without()));
    PossibleValuesParser::new(names).map(|name| {
        let effect = Effect::ALL.into_iter().find(|e| e.name() == name);
        effect.unwrap_or(Effect::Shadows)
    })
}

fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let wrong = || format!("`{text}` is no size; write WIDTHxHEIGHT, such as 320x240");
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(wrong)?;
    let number = |digits: &str| digits.trim().parse::<u32>().map_err(|_| wrong());
    let (width, height) = (number(width)?, number(height)?);
    limits::size_problem(width, height).map_or(Ok((width, height)), Err)
}

fn parse_not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() && x >= 0.0 => Ok(x),
        _ => Err("must be a number of at least 0".to_owned()),
    }
}

fn parse_threads(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(n) if n <= limits::MAX_THREADS => Ok(n),
        _ => Err(format!(
            "must be a whole number from 0 to {}",
            limits::MAX_THREADS
        )),
    }
}
