//! `raytree find`: the pixels whose ray trees satisfy a query.

use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::command_line::words;
use super::output::{Destination, Target};
use super::settings::SceneArgs;
use super::{Completion, Failure, output};
use crate::accel::fastest;
use crate::lab::find::{FoundPixels, find};
use crate::scene::Settings;
use crate::trace::TreeQuery;
use crate::trace::format::counted;
use crate::trace::query::unknown_names;
use crate::tracer::image::png;

/// Pixels that are listed if the user names no number.
const LISTED: usize = 10;

/// The properties and quantities of rays, for `--help`.
pub const HELP: &str = "\
A query is true or false of the eye ray of a pixel:
  hit, miss, back                  it ends on a surface, on none, on a surface from inside
  hits:NAME, material:NAME         it ends on such an object or material
  part:NAME                        it ends on such a part: wall, top, what a csg is made of
  lit:NAME, blocked:NAME           where it ends, such a light arrives, or something is in its way
  absent:REASON                    where it ends, a ray is not sent, as in absent:depth-limit
  path:TT>NAME                     two transmitted rays follow, and the second ends on such an object
  tir                              total internal reflection, in any ray that follows
  depth, rays, t, red, green, blue, luminance, n1, n2, reflectance,
  n_dot_l:NAME, r_dot_v:NAME, diffuse:NAME, specular:NAME
                                   quantities, compared with a number: depth >= 3, t < 0.01
A name is that of an object, material or light; * stands for any letters: hits:ball*.
Parts are joined by and, or, not and brackets. some(...) is true if it is true of any ray of the
tree; I, L, R, T are true of rays of that kind: some(R and hits:floor).";

#[derive(Args)]
pub struct Find {
    #[command(flatten)]
    scene: SceneArgs,
    /// What the ray tree of a pixel must satisfy, such as 'hits:ball and not lit:lamp', 'tir', 'some(R and t < 1)'
    #[arg(value_name = "QUERY")]
    query: TreeQuery,
    /// Stop after so many pixels; without, all are counted and ten are listed
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    first: Option<u32>,
    /// Write a PNG file in which those pixels are white
    #[arg(long, value_name = "FILE", conflicts_with = "first")]
    mask: Option<PathBuf>,
    /// As JSON, all pixels
    #[arg(long)]
    json: bool,
}

impl Find {
    pub fn run(&self) -> Result<Completion, Failure> {
        let scene = self.scene.read()?;
        let target = Target {
            flag: "--mask",
            path: self.mask.as_deref(),
            endings: &["png"],
        };
        let [mask] = output::open(&scene.files, [target])?;
        let (world, settings) = self.scene.build(scene, fastest)?;
        if let Some(unknown) = unknown_names(&self.query, &world.scene) {
            self.scene.notices.warn(unknown);
            self.scene.notices.deny(self.scene.label(), 1)?;
        }
        let most = self.first.map_or(usize::MAX, |n| n as usize);
        let bar = progress_bar(&settings, self.scene.notices.quiet);
        let watch = |_: &[(u32, u32)], searched| {
            bar.inc(searched);
            ControlFlow::Continue(())
        };
        let threads = self.scene.settings.threads;
        let found = find(&world, &settings, &self.query, most, threads, &watch);
        bar.finish_and_clear();
        if let Some(mask) = mask {
            write_mask(mask, &settings, &found)?;
        }
        if self.json {
            self.write_json(&settings, &found)?;
        } else {
            let scene = words(&self.scene.scene, &settings, &world.scene);
            self.write_text(&found, &scene)?;
        }
        Ok(if found.pixels.is_empty() {
            Completion::No
        } else {
            Completion::Whole
        })
    }

    /// The pixels on standard output, and on standard error how many there are; `scene` is the scene with its settings.
    fn write_text(&self, found: &FoundPixels, scene: &str) -> Result<Completion, Failure> {
        let wanted = self.first.map_or(LISTED, |n| n as usize);
        let listed = &found.pixels[..wanted.min(found.pixels.len())];
        output::to_stdout_by(|out| {
            listed
                .iter()
                .try_for_each(|(x, y)| writeln!(out, "{x},{y}"))
        })?;
        if self.scene.notices.quiet {
            return Ok(Completion::Whole);
        }
        let (count, searched) = (found.pixels.len(), found.searched);
        let more = match count - listed.len() {
            0 => "",
            _ => "; the first are listed, --first N lists more",
        };
        let which = if found.complete { "" } else { " so far" };
        eprintln!("{count} of {}{which}{more}", counted(searched, "pixel"));
        if let Some((x, y)) = listed.first() {
            eprintln!(
                "the ray tree of the first: raytree trace {scene} --pixel {x},{y} --format text"
            );
        }
        Ok(Completion::Whole)
    }

    fn write_json(&self, settings: &Settings, found: &FoundPixels) -> Result<Completion, Failure> {
        let (width, height) = settings.size();
        let json = serde_json::json!({
            "format": "raytree-find/1",
            "scene": self.scene.scene,
            "image": { "width": width, "height": height },
            "count": found.pixels.len(),
            "searched": found.searched,
            "complete": found.complete,
            "pixels": found.pixels,
        });
        output::to_stdout(format!("{json}\n").as_bytes())
    }
}

/// Writes the pixels that were found in white on black.
fn write_mask(to: Destination, settings: &Settings, found: &FoundPixels) -> Result<(), Failure> {
    let (width, height) = settings.size();
    let mut bytes = vec![0; width as usize * height as usize];
    for (x, y) in &found.pixels {
        bytes[*y as usize * width as usize + *x as usize] = 255;
    }
    let png = png::encode_grey(width, height, &bytes).map_err(std::io::Error::other);
    to.write(|out| out.write_all(&png?))
}

/// A bar on standard error, hidden where that is no terminal.
fn progress_bar(settings: &Settings, quiet: bool) -> ProgressBar {
    if quiet {
        return ProgressBar::hidden();
    }
    let (width, height) = settings.size();
    let pixels = u64::from(width) * u64::from(height);
    let bar = ProgressBar::with_draw_target(Some(pixels), ProgressDrawTarget::stderr());
    let style = ProgressStyle::with_template("{wide_bar} {percent:>3} %  {eta} left");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
