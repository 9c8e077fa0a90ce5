//! `raytree grade --merge`: the JSON of shards made one.

use std::io::Read as _;
use std::path::{Path, PathBuf};

use super::outputs::target;
use crate::cli::output::{open_all, to_stdout};
use crate::cli::{Completion, Failure};
use crate::grade::output::{GradeDocument, OutputKind, json, merge, parse, table};
use crate::scene::FileId;
use crate::scene::error::Problem;
use crate::scene::printable::excerpt;
use crate::scene::read::files::{regular, unreadable};

/// Merges files; JSON goes to standard output if no file is named for it.
pub fn run(files: &[PathBuf], asked: &[(OutputKind, PathBuf)]) -> Result<Completion, Failure> {
    for (kind, _) in asked {
        if !matches!(kind, OutputKind::Json | OutputKind::Csv) {
            return Err(Failure::Usage(
                "--merge writes json and csv; for other outputs run each shard with --output"
                    .into(),
            ));
        }
    }
    let read: Vec<FileId> = files.iter().filter_map(|f| FileId::at(f).ok()).collect();
    let targets: Vec<_> = asked.iter().map(target).collect();
    let places = open_all(&read, &targets)?;
    let parts: Result<Vec<GradeDocument>, Failure> = files.iter().map(|path| one(path)).collect();
    let document = merge(parts?).map_err(Failure::Input)?;
    if asked.is_empty() {
        return to_stdout(written(OutputKind::Json, &document)?.as_bytes());
    }
    for ((kind, _), place) in asked.iter().zip(places.into_iter().flatten()) {
        let text = written(*kind, &document)?;
        place.write(|out| out.write_all(text.as_bytes()))?;
    }
    Ok(Completion::Whole)
}

fn written(kind: OutputKind, document: &GradeDocument) -> Result<String, Failure> {
    match kind {
        OutputKind::Csv => Ok(table(document)),
        _ => json(document).map_err(Failure::Input),
    }
}

fn one(path: &Path) -> Result<GradeDocument, Failure> {
    let shown = excerpt(&path.to_string_lossy());
    let wrong = |what: String| Failure::Input(format!("{shown}: {what}"));
    let unread = |problem: Problem| Failure::Scene(problem.in_file(&path.to_string_lossy()));
    let (mut file, _) = regular(path, ".json").map_err(unread)?;
    let mut text = String::new();
    let read = file.read_to_string(&mut text);
    read.map_err(|error| unread(unreadable(&error)))?;
    parse(&text).map_err(wrong)
}
