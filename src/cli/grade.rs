//! `raytree grade`: marks what students hand in.

mod bends;
mod export;
mod merge;
mod outputs;
mod selftest;
mod shard;
mod small_file;
mod students;

use std::path::{Path, PathBuf};

use clap::Args;

use self::export::ExportKind;
use self::outputs::{Outputs, parse_output};
use self::shard::Shard;
use self::small_file::{broken, text_of};
use self::students::{Entry, entries};
use super::output::to_stdout;
use super::run_programs::RunArgs;
use super::{Completion, Failure};
use crate::grade::attempts::EarlierScores;
use crate::grade::output::{Audience, OutputKind, is_datetime};
use crate::grade::report::Report;
use crate::grade::submission::Submission;
use crate::grade::task::{Task, TaskError};
use crate::scene::read::files::unreadable;
use crate::scene::{Bend, Bends, FileId};
use crate::tracer::thread_pool;

#[allow(clippy::struct_excessive_bools)] // Each is a flag.
#[derive(Args)]
pub struct Grade {
    /// The task: what is asked, in TOML or JSON
    #[arg(value_name = "TASK", required_unless_present_any = ["bends", "merge"])]
    task: Option<String>,
    /// What was handed in: folders, .zip archives, files of ray trees
    #[arg(value_name = "SUBMISSION")]
    submissions: Vec<PathBuf>,
    /// List the mistakes that are known by name
    #[arg(long, conflicts_with = "task")]
    bends: bool,
    /// Write an output of a kind into a file, html also into a folder; without, text goes to standard output
    #[arg(long, value_name = "KIND=FILE", value_parser = parse_output)]
    output: Vec<(OutputKind, PathBuf)>,
    /// The students of the course, a line `name,id` each: those who handed in nothing are listed, too
    #[arg(long, value_name = "FILE")]
    students: Option<PathBuf>,
    /// The earlier attempts of the one student who is marked: Gradescope's submission_metadata.json
    #[arg(long, value_name = "FILE")]
    metadata: Option<PathBuf>,
    /// Leave out what is hidden from students
    #[arg(long)]
    student: bool,
    /// Mark part K of N of the submissions; its JSON is for --merge
    #[arg(long, value_name = "K/N")]
    shard: Option<Shard>,
    /// Put the JSON of shards together, as if one run had made it
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["task", "bends", "students", "shard"])]
    merge: Vec<PathBuf>,
    /// When the submission was handed in, for classroom50: YYYY-MM-DDTHH:MM:SSZ; without, now
    #[arg(long, value_name = "TIME", value_parser = parse_datetime)]
    datetime: Option<String>,
    /// Make a grader for a platform out of the task (needs -o)
    #[arg(long, value_enum, value_name = "PLATFORM", requires = "archive", conflicts_with_all = ["submissions", "output", "bends", "merge"])]
    export: Option<ExportKind>,
    /// The archive that --export makes
    #[arg(
        short = 'o',
        value_name = "FILE.zip",
        id = "archive",
        requires = "export"
    )]
    archive: Option<PathBuf>,
    /// The raytree that is put into the archive; without, this one
    #[arg(long, value_name = "FILE", requires = "export")]
    program: Option<PathBuf>,
    /// Exit with status 4 if a submission is below the pass mark
    #[arg(long)]
    exit_code: bool,
    /// Test the task itself: what each known mistake earns in it, and whether it is named
    #[arg(long, conflicts_with_all = ["submissions", "output"])]
    selftest: bool,
    /// List the pixels that the task asks, a scene, a column and a row a line
    #[arg(long, conflicts_with_all = ["submissions", "output", "selftest"])]
    show: bool,
    /// Threads; 0 for one a core
    #[arg(long, value_name = "N", default_value_t = 0)]
    threads: usize,
    // Last, as the heading of its flags goes on.
    #[command(flatten)]
    programs: RunArgs,
}

impl Grade {
    pub fn run(&self) -> Result<Completion, Failure> {
        if self.bends {
            return bends::list();
        }
        if !self.merge.is_empty() {
            return merge::run(&self.merge, &self.output);
        }
        let path = self.task.as_deref().unwrap_or_default();
        if let (Some(kind), Some(archive)) = (self.export, &self.archive) {
            let task = thread_pool::install(self.threads, || {
                Task::load(path).map_err(|error| input(&error))
            })?;
            return kind.write(path, &task, archive, self.program.as_deref());
        }
        if self.show {
            let tasks = thread_pool::install(self.threads, || tasks(path))?;
            let text: String = tasks.iter().take(1).flat_map(Task::asked_pixels).collect();
            return to_stdout(text.as_bytes());
        }
        if self.selftest {
            return selftest::run(self.threads, || tasks(path));
        }
        self.mark(path)
    }

    fn mark(&self, path: &str) -> Result<Completion, Failure> {
        if self.submissions.is_empty() && self.students.is_none() {
            let what = "nothing is named that was handed in; add folders, archives or files behind TASK, or --selftest to \
test the task itself";
            return Err(Failure::Usage(what.to_owned()));
        }
        let all = entries(&self.submissions, self.students.as_deref())?;
        for warning in &all.warnings {
            eprintln!("warning: {warning}");
        }
        let entries = match self.shard {
            Some(shard) => shard.of(&all.entries),
            None => &all.entries[..],
        };
        // A link that leads nowhere is what somebody handed in; a name of nothing is misspelt.
        for path in entries.iter().filter_map(|entry| entry.path.as_deref()) {
            std::fs::symlink_metadata(path)
                .map_err(|error| unreadable(&error).in_file(&path.to_string_lossy()))?;
        }
        let tasks = thread_pool::install(self.threads, || tasks(path))?;
        let Some(task) = tasks.first() else {
            return Ok(Completion::Whole);
        };
        for warning in &task.warnings {
            eprintln!("warning: {warning}");
        }
        let outputs = Outputs::open(&self.output, &self.read(path, task))?;
        let runner = self.programs.runner(&tasks)?;
        let mut report = thread_pool::install(self.threads, || {
            Report::new(&tasks, entries, |entry| match &runner {
                Some(runner) => runner.run(entry.read()),
                None => entry.read(),
            })
        });
        if let Some(runner) = &runner {
            for marked in &mut report.submissions {
                marked.problems.insert(0, runner.sandbox());
            }
        }
        if self.programs.is_stopped() {
            eprintln!("stopped: nothing is written");
            return Ok(Completion::Cut);
        }
        report.shard = self.shard.map(|shard| [shard.number, shard.count]);
        for (marked, entry) in report.submissions.iter_mut().zip(entries) {
            marked.id.clone_from(&entry.id);
        }
        self.count_attempts(task, &mut report)?;
        let audience = Audience {
            task,
            for_students: self.student,
        };
        outputs.write(audience, &report, self.datetime.as_deref())?;
        let below = report
            .submissions
            .iter()
            .any(|marked| marked.percent() < u64::from(task.pass));
        Ok(if self.exit_code && below {
            Completion::No
        } else {
            Completion::Whole
        })
    }

    /// Sets the score that counts by the earlier attempts, if they are told and the task has a rule.
    fn count_attempts(&self, task: &Task, report: &mut Report) -> Result<(), Failure> {
        let Some(path) = &self.metadata else {
            return Ok(());
        };
        let [marked] = &mut report.submissions[..] else {
            let what = "--metadata tells of one student, and several submissions are marked";
            return Err(Failure::Usage(what.to_owned()));
        };
        let text = text_of(path, "submission_metadata.json")?;
        let earlier = EarlierScores::from_metadata(&text).map_err(|what| broken(path, &what))?;
        let rule = task.attempts;
        marked.counted = rule.and_then(|rule| rule.counted(marked.score(), &earlier));
        Ok(())
    }

    /// The files that are read: no output may take their place.
    fn read(&self, path: &str, task: &Task) -> Vec<FileId> {
        let scenes = task.scenes.iter();
        let scenes = scenes.flat_map(|scene| scene.world.scene.files.iter().cloned());
        let named = [
            Some(Path::new(path)),
            self.students.as_deref(),
            self.metadata.as_deref(),
        ];
        let named = named.into_iter().flatten();
        let named = named.chain(self.submissions.iter().map(PathBuf::as_path));
        let named = named.filter_map(|path| FileId::at(path).ok());
        named.chain(scenes).collect()
    }
}

impl Entry {
    /// What was handed in.
    fn read(&self) -> Submission {
        let mut submission = match &self.path {
            Some(path) => Submission::read(path),
            None => Submission {
                problems: vec!["nothing was handed in".to_owned()],
                ..Submission::default()
            },
        };
        if let Some(name) = &self.name {
            submission.name.clone_from(name);
        }
        submission
    }
}

/// The task, and the task with each bend that counts as right.
fn tasks(path: &str) -> Result<Vec<Task>, Failure> {
    let task = Task::load(path).map_err(|error| input(&error))?;
    let accepted: Vec<Bend> = task.accept.clone();
    let mut tasks = vec![task];
    for bend in accepted {
        tasks.push(Task::bent(path, Bends::from(bend)).map_err(|error| input(&error))?);
    }
    Ok(tasks)
}

fn input(error: &TaskError) -> Failure {
    Failure::Input(error.to_string())
}

fn parse_datetime(text: &str) -> Result<String, String> {
    if is_datetime(text) {
        Ok(text.to_owned())
    } else {
        Err(format!(
            "`{text}` is no moment; write it in UTC, such as 2026-02-28T23:59:00Z"
        ))
    }
}
