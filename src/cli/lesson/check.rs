//! `raytree lesson check`: a course as its author checks it.

use std::fmt::Write as _;
use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;

use super::course;
use crate::cli::output::{to_stdout, to_stdout_by};
use crate::cli::{Completion, Failure};
use crate::lesson::check::{MAX_SECONDS, check};
use crate::scene::printable::printable;
use crate::trace::export::json;
use crate::trace::format::counted;

#[derive(Args)]
pub struct CheckCourse {
    /// The course: its folder, or a .zip archive of it; without, the one that the program brings along
    dir: Option<PathBuf>,
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl CheckCourse {
    pub fn run(&self, lessons: Option<&Path>) -> Result<Completion, Failure> {
        let course = course(self.dir.as_deref().or(lessons))?;
        let progress = std::io::stderr().is_terminal();
        let findings = check(&course, MAX_SECONDS, &mut |chapter| {
            if progress {
                eprintln!("{:3}  {}", chapter.number, chapter.title);
            }
        });
        if self.json {
            to_stdout_by(|out| json::write(out, &json!({ "findings": findings })))?;
        } else {
            let mut out: String = findings
                .iter()
                .map(|finding| printable(&finding.to_string()).into_owned() + "\n")
                .collect();
            let (chapters, exercises) = (course.chapters.len(), course.exercises().count());
            let _ = writeln!(
                out,
                "{}, {}: {}",
                counted(chapters as u64, "chapter"),
                counted(exercises as u64, "exercise"),
                match findings.len() {
                    0 => "nothing is wrong".to_owned(),
                    n => counted(n as u64, "finding"),
                }
            );
            to_stdout(out.as_bytes())?;
        }
        Ok(if findings.is_empty() {
            Completion::Whole
        } else {
            Completion::No
        })
    }
}
