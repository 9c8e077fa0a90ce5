//! Where the outputs of grading go.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use clap::ValueEnum as _;

use crate::cli::Failure;
use crate::cli::output::{Destination, Target, open_all, to_stdout};
use crate::grade::output::{Audience, Classroom, OutputKind, Page, pages, utc};
use crate::grade::report::Report;
use crate::scene::FileId;

/// The outputs that were asked for, each open.
pub struct Outputs(Vec<(OutputKind, Place)>);

/// Where an output goes.
enum Place {
    /// Into a file.
    File(Destination),
    /// Into a folder of pages.
    Folder(PathBuf),
}

impl Outputs {
    /// Opens all files before the work; none of them may be one that was `read`.
    pub fn open(asked: &[(OutputKind, PathBuf)], read: &[FileId]) -> Result<Self, Failure> {
        let is_file = |(kind, path): &&(OutputKind, PathBuf)| !is_folder(*kind, path);
        let targets: Vec<Target> = asked.iter().filter(is_file).map(target).collect();
        let mut files = open_all(read, &targets)?.into_iter().flatten();
        let places = asked.iter().filter_map(|(kind, path)| {
            let place = if is_folder(*kind, path) {
                Place::Folder(path.clone())
            } else {
                Place::File(files.next()?)
            };
            Some((*kind, place))
        });
        Ok(Self(places.collect()))
    }

    /// Writes all; if none was asked for, text to standard output.
    pub fn write(
        self,
        audience: Audience,
        report: &Report,
        datetime: Option<&str>,
    ) -> Result<(), Failure> {
        let classroom = || {
            let variable = |name: &str| std::env::var(name).ok().filter(|v| !v.is_empty());
            Classroom::new(&variable, datetime.map_or_else(now, str::to_owned))
        };
        let written = |kind: OutputKind| {
            kind.write(audience, report, &classroom)
                .map_err(Failure::Usage)
        };
        if self.0.is_empty() {
            to_stdout(written(OutputKind::Text)?.as_bytes())?;
        }
        for (kind, place) in self.0 {
            match place {
                Place::Folder(folder) => write_pages(&folder, &pages(audience, report))?,
                Place::File(file) => {
                    let text = written(kind)?;
                    file.write(|out| out.write_all(text.as_bytes()))?;
                }
            }
        }
        Ok(())
    }
}

/// The file of an output.
pub fn target((kind, path): &(OutputKind, PathBuf)) -> Target<'_> {
    Target {
        flag: "--output",
        path: Some(path),
        endings: kind.endings(),
    }
}

/// True if pages go into a folder of this name, not into one file.
fn is_folder(kind: OutputKind, path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    let names_file = ending.is_some_and(|ending| kind.endings().contains(&ending));
    kind == OutputKind::Html && (path.is_dir() || !path.exists() && !names_file)
}

/// Writes pages into a folder, which is made if it is not there.
fn write_pages(folder: &Path, pages: &[Page]) -> Result<(), Failure> {
    if !folder.is_dir() {
        fs::create_dir(folder).map_err(|source| Failure::Output {
            path: Some(folder.to_owned()),
            source,
        })?;
    }
    for page in pages {
        let path = folder.join(&page.file);
        let target = target_of_page(&path);
        for file in open_all(&[], &[target])?.into_iter().flatten() {
            file.write(|out| out.write_all(page.text.as_bytes()))?;
        }
    }
    Ok(())
}

fn target_of_page(path: &Path) -> Target<'_> {
    Target {
        flag: "--output",
        path: Some(path),
        endings: OutputKind::Html.endings(),
    }
}

fn now() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    utc(since.map_or(0, |since| since.as_secs()))
}

/// A kind and a file, from `KIND=FILE`.
pub fn parse_output(text: &str) -> Result<(OutputKind, PathBuf), String> {
    let kinds = || {
        let names: Vec<String> = OutputKind::value_variants()
            .iter()
            .filter_map(|kind| Some(kind.to_possible_value()?.get_name().to_owned()))
            .collect();
        format!(
            "`{text}` is no output; write KIND=FILE, where KIND is one of {}",
            names.join(", ")
        )
    };
    let (kind, file) = text
        .split_once('=')
        .filter(|(_, file)| !file.is_empty())
        .ok_or_else(kinds)?;
    let kind = OutputKind::from_str(kind, false).map_err(|_| kinds())?;
    Ok((kind, PathBuf::from(file)))
}
