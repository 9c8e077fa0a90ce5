//! `raytree raster`: the picture by scan conversion.

use std::path::PathBuf;

use clap::Args;

use super::output::{self, Target};
use super::render::files;
use super::settings::SceneArgs;
use super::{ColorArg, Completion, Failure};
use crate::accel::fastest;
use crate::lab::raster::{Filling, RasterPicture, ScreenBlend, raster, row_table};
use crate::scene::Scene;
use crate::scene::printable::printable;
use crate::tracer::image::terminal;

pub const HELP: &str = "Triangles are projected onto the screen and filled row by row: no shadows, no reflection, no \
refraction. One sample at each pixel's middle; settings of samples and rays change nothing. With \
--shading flat a triangle has one colour, computed in its middle. Other shapes than triangles are left out.";

#[derive(Args)]
pub struct Raster {
    /// Write a PNG file, or a PFM file (linear radiance, 32-bit floats) if the name ends in .pfm; without, the picture
    /// is drawn as text
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Blend linearly on the screen, as if all depths were the same
    #[arg(long)]
    affine: bool,
    /// Tell how this row of pixels was filled, from the top: each span with its ends
    #[arg(long, value_name = "Y", conflicts_with = "output")]
    row: Option<u32>,
    /// Colours of the text picture
    #[arg(long, value_enum, default_value_t = ColorArg::Auto)]
    color: ColorArg,
    #[command(flatten)]
    scene: SceneArgs,
}

impl Raster {
    pub fn run(&self) -> Result<Completion, Failure> {
        let scene = self.scene.read()?;
        let [picture] = output::open(&scene.files, [self.target()])?;
        scene.check_faces()?;
        let (world, mut settings) = self.scene.build(scene, fastest)?;
        if self.output.is_none() && self.row.is_none() && !self.scene.settings.gives("size") {
            (settings.image.width, settings.image.height) =
                super::render::size_of_terminal(&settings);
        }
        if let Some(row) = self.row.filter(|row| *row >= settings.image.height) {
            let last = settings.image.height - 1;
            return Err(Failure::Usage(format!(
                "--row {row}: the picture has the rows 0 to {last}"
            )));
        }
        let blend = if self.affine {
            ScreenBlend::Affine
        } else {
            ScreenBlend::Perspective
        };
        let filling = Filling {
            shading: None,
            blend,
        };
        let drawn = raster(&world.scene, &settings, filling, self.row);
        self.tell_left_out(&world.scene, &drawn);
        let exposure = settings.image.exposure;
        if let Some(row) = self.row {
            output::to_stdout(row_table(&world.scene, row, &drawn).as_bytes())?;
        } else if let Some(file) = picture {
            files::picture(file, &drawn.film, exposure)?;
        } else {
            let text = terminal::lines(&drawn.film, exposure, self.color.level());
            output::to_stdout(text.as_bytes())?;
        }
        self.scene
            .notices
            .deny(self.scene.label(), world.scene.warnings.len())?;
        Ok(Completion::Whole)
    }

    fn target(&self) -> Target<'_> {
        Target {
            flag: "--output",
            path: self.output.as_deref(),
            endings: files::PICTURE,
        }
    }

    /// Tells of shapes that are no triangles.
    fn tell_left_out(&self, scene: &Scene, drawn: &RasterPicture) {
        let Some(&first) = drawn.left_out.first() else {
            return;
        };
        let (kind, name) = (
            scene.shapes[first as usize].kind(),
            printable(&scene.object_of(first).name),
        );
        let count = drawn.left_out.len();
        let rest = match count {
            1 => " is".to_owned(),
            _ => format!(" and {} more shapes are", count - 1),
        };
        self.scene.notices.warn(format!(
            "only triangles are filled: the {kind} `{name}`{rest} left out (shapes written as meshes are seen)"
        ));
    }
}
