//! The flags that several commands share.

use clap::{Args, ValueEnum};

use super::Failure;
use crate::accel::AccelKind;
use crate::scene::{Sampling, Scene, Settings, World, limits};
use crate::shading::Fresnel;

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
    /// Samples a pixel
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(limits::MAX_SAMPLES)))]
    samples: Option<u32>,
    /// Where the samples of a pixel lie
    #[arg(long, value_enum)]
    sampling: Option<SamplingArg>,
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
    /// Seed of all random numbers
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// How hits are found; never changes the picture
    #[arg(long, value_enum)]
    accel: Option<AccelArg>,
    /// Rays that the whole picture may cost
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    max_rays: Option<u64>,
    /// Threads; 0 for one a core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = parse_threads)]
    pub threads: usize,
}

#[derive(ValueEnum, Clone, Copy, Debug)]
enum SamplingArg {
    /// In the middles of a grid
    Regular,
    /// By chance, one in each cell of a grid
    Jittered,
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

#[derive(ValueEnum, Clone, Copy, Debug)]
enum AccelArg {
    /// Test every shape
    List,
    /// A BSP tree; the scene decides which planes split
    Bsp,
    /// A BSP tree split along the axes
    BspAxis,
    /// A BSP tree split by the scene's own polygons
    BspPolygon,
    /// A kd-tree: the best planes along the axes
    Kd,
    /// A tree of boxes, eight to a node: the fast one
    Wide,
}

impl SettingsArgs {
    /// The scene's settings with what the command line changes.
    pub fn over(&self, scene: &Scene) -> Settings {
        let asked = &scene.settings;
        let (width, height) = self.size.unwrap_or(asked.size());
        Settings {
            width,
            height,
            samples: self.samples.unwrap_or(asked.samples),
            sampling: self.sampling.map_or(asked.sampling, |s| match s {
                SamplingArg::Regular => Sampling::Regular,
                SamplingArg::Jittered => Sampling::Jittered,
            }),
            depth: self.depth.unwrap_or(asked.depth),
            min_weight: self.min_weight.unwrap_or(asked.min_weight),
            seed: self.seed.unwrap_or(asked.seed),
            fresnel: self.fresnel.map_or(asked.fresnel, |f| match f {
                FresnelArg::None => Fresnel::None,
                FresnelArg::Schlick => Fresnel::Schlick,
                FresnelArg::Exact => Fresnel::Exact,
            }),
            exposure: self.exposure.unwrap_or(asked.exposure),
            accel: self.accel.map_or(asked.accel, |a| match a {
                AccelArg::List => AccelKind::List,
                AccelArg::Bsp => AccelKind::Bsp,
                AccelArg::BspAxis => AccelKind::BspAxis,
                AccelArg::BspPolygon => AccelKind::BspPolygon,
                AccelArg::Kd => AccelKind::Kd,
                AccelArg::Wide => AccelKind::Wide,
            }),
            max_rays: self.max_rays.unwrap_or(asked.max_rays),
        }
    }
}

impl SceneArgs {
    /// Reads the scene, tells its warnings and builds its accelerator.
    pub fn load(&self) -> Result<(World, Settings), Failure> {
        let scene = crate::scene::load(&self.scene)?;
        for warning in &scene.warnings {
            eprintln!("warning: {warning}");
        }
        let settings = self.settings.over(&scene);
        Ok((World::new(scene, settings.accel), settings))
    }
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
        Ok(n) if n <= 1024 => Ok(n),
        _ => Err("must be a whole number from 0 to 1024".to_owned()),
    }
}
