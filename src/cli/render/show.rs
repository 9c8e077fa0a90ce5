//! `raytree render --show`: the work of each pixel, or what its eye ray meets, in the place of its colour.

use super::{Completion, Failure, Render, files};
use crate::accel::AccelKind;
use crate::cli::output::{self, Destination};
use crate::lab::show::{ShowMode, ShownRange, ShownValue, show, summary};
use crate::math::Rgb;
use crate::scene::{Sampling, Settings};
use crate::trace::format::counted;
use crate::tracer::Film;
use crate::tracer::image::terminal;
use crate::world::World;

impl Render {
    /// Writes the picture of a mode: colours of a scale in PNG files and as text, the numbers themselves in PFM files.
    pub fn write_shown(
        &self,
        mode: ShowMode,
        (world, settings): (&World, &Settings),
        picture: Option<Destination>,
    ) -> Result<Completion, Failure> {
        let values = show(world, settings, mode, self.scene.settings.threads);
        let range = ShownRange::of(values.iter().copied()).unwrap_or(ShownRange(0.0, 0.0));
        let is_pfm = |file: &Destination| file.path().extension().is_some_and(|e| e == "pfm");
        let numbers = picture.as_ref().is_some_and(is_pfm);
        let pixel = |value: &ShownValue| match value {
            ShownValue::Number(x) if numbers => Rgb::grey(*x),
            value => range.color(*value),
        };
        let (width, height) = settings.size();
        let film = Film {
            width,
            height,
            pixels: values.iter().map(pixel).collect(),
            ..Film::default()
        };
        if let Some(file) = picture {
            files::picture(file, &film, 1.0)?;
        } else {
            let text = terminal::lines(&film, 1.0, self.color.level());
            output::to_stdout(text.as_bytes())?;
        }
        if let Some(why) = nothing_to_see(mode, &values, settings) {
            self.scene.notices.warn(why);
        }
        if let (false, Some(told)) = (self.scene.notices.quiet, summary(&values, mode)) {
            eprint!("{told}");
        }
        Ok(Completion::Whole)
    }
}

/// Why a picture is black, where the settings leave nothing to be shown.
fn nothing_to_see(mode: ShowMode, values: &[ShownValue], settings: &Settings) -> Option<String> {
    match mode {
        ShowMode::Error if values.iter().all(|v| *v == ShownValue::Nothing) => Some(format!(
            "--show error: nothing is known of the error of {} by `{}`; take at least 2 by chance, such as --samples 4 \
--sampling sobol",
            counted(settings.pixel.samples.into(), "sample"),
            Sampling::of(settings.pixel.sampler).name()
        )),
        ShowMode::Nodes if settings.accel == AccelKind::List => Some(
            "--show nodes: the accelerator `list` has no nodes; choose another, such as --accel bvh"
                .to_owned(),
        ),
        _ => None,
    }
}
