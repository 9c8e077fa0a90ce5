//! Console directives: a command of this program and what it prints. Nothing is run: the few commands that print the same on
//! every machine are answered here.

use std::fmt::Write as _;

use super::chapter::Chapter;
use super::course::Course;
use super::names::scene_path;
use super::stage::Stage;
use crate::lab::raster::{Filling, raster, row_table};
use crate::lab::stability::table::as_text;
use crate::lab::stability::{CASES, Case, Outcome};
use crate::scene::effects::findings;
use crate::scene::printable::{excerpt, printable};

/// What a command prints.
pub fn console(course: &Course, chapter: &Chapter, command: &str) -> Result<String, String> {
    let words: Vec<&str> = command.split_whitespace().collect();
    match words[..] {
        ["raytree", "effects", scene] => {
            let path = scene_path(&chapter.folder, scene)?;
            let source = course.source(&path).map_err(|e| e.to_string())?;
            let scene = source.scene().map_err(|e| e.to_string())?;
            let mut out = String::new();
            for found in findings(&scene) {
                let state = if found.on { "on" } else { "off" };
                let name = found.effect.name();
                let _ = writeln!(out, "{name:13} {state:4} {}", printable(&found.reason));
            }
            Ok(out)
        }
        ["raytree", "raster", scene, "--row", row, ref more @ ..] => {
            let path = scene_path(&chapter.folder, scene)?;
            let stage = course.stage(chapter, Some(&path), &[]);
            let stage = stage.map_err(|e| e.to_string())?;
            row_of(&stage, row, more)
        }
        ["raytree", "stability"] => Ok(stability(None)),
        ["raytree", "stability", name] => {
            let case = CASES.into_iter().find(|case| case.name == name);
            let case = case.ok_or_else(|| format!("there is no hard case `{}`", excerpt(name)))?;
            Ok(stability(Some(case)))
        }
        _ => Err(format!(
            "console shows `raytree effects SCENE`, `raytree raster SCENE --row Y [--shading MODEL]` and `raytree stability [CASE]`, not `{}`",
            excerpt(command)
        )),
    }
}

/// How a row of pixels is filled.
fn row_of(stage: &Stage, row: &str, more: &[&str]) -> Result<String, String> {
    let row: u32 = row
        .parse()
        .map_err(|_| format!("`{}` is no row", excerpt(row)))?;
    let filling: Filling = match more {
        [] => Filling::default(),
        ["--shading", model] => model.parse()?,
        _ => return Err("behind --row there is only --shading MODEL".to_owned()),
    };
    let scene = &stage.world.scene;
    let drawn = raster(scene, &stage.settings, filling, Some(row));
    Ok(row_table(scene, row, &drawn))
}

/// The table of all hard cases, or of one.
fn stability(only: Option<Case>) -> String {
    let asked = CASES
        .into_iter()
        .filter(|case| only.is_none_or(|only| only.name == case.name));
    let measured: Vec<(Case, Vec<Outcome>)> = asked.map(|case| (case, (case.measure)())).collect();
    as_text(&measured, only.is_some())
}
