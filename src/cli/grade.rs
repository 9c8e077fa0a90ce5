//! `raytree grade`: marks what students hand in.

use std::path::PathBuf;

use clap::Args;

use super::output::to_stdout;
use super::run_programs::RunArgs;
use super::{Completion, Failure};
use crate::grade::output::{Audience, OutputKind};
use crate::grade::report::Report;
use crate::grade::selftest::SelfTest;
use crate::grade::submission::Submission;
use crate::grade::task::Task;
use crate::scene::{Bend, Bends};
use crate::tracer::thread_pool;

#[allow(clippy::struct_excessive_bools)] // Each is a flag.
#[derive(Args)]
pub struct Grade {
    /// The task: what is asked, in TOML or JSON
    #[arg(value_name = "TASK", required_unless_present = "bends")]
    task: Option<String>,
    /// What was handed in: folders, .zip archives, files of ray trees
    #[arg(value_name = "SUBMISSION")]
    submissions: Vec<PathBuf>,
    /// List the mistakes that are known by name
    #[arg(long, conflicts_with = "task")]
    bends: bool,
    /// Write an output of a kind into a file; without, text goes to standard output
    #[arg(long, value_name = "KIND=FILE", value_parser = parse_output)]
    output: Vec<(OutputKind, PathBuf)>,
    /// Leave out what is hidden from students
    #[arg(long)]
    student: bool,
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
            return list_bends();
        }
        let path = self.task.as_deref().unwrap_or_default();
        if self.selftest {
            return self.self_test(path);
        }
        if self.show {
            let tasks = thread_pool::install(self.threads, || tasks(path))?;
            let text: String = tasks.iter().take(1).flat_map(Task::asked_pixels).collect();
            return to_stdout(text.as_bytes());
        }
        let graded = thread_pool::install(self.threads, || {
            let tasks = tasks(path)?;
            let runner = self.programs.runner(&tasks)?;
            let mut report = Report::new(&tasks, &self.submissions, |path| {
                let submission = Submission::read(path);
                match &runner {
                    Some(runner) => runner.run(submission),
                    None => submission,
                }
            });
            if let Some(runner) = &runner {
                for marked in &mut report.submissions {
                    marked.problems.insert(0, runner.sandbox());
                }
            }
            Ok::<_, Failure>((tasks, report))
        });
        let (tasks, report) = graded?;
        if self.programs.is_stopped() {
            eprintln!("stopped: nothing is written");
            return Ok(Completion::Cut);
        }
        let Some(task) = tasks.first() else {
            return Ok(Completion::Whole);
        };
        for warning in &task.warnings {
            eprintln!("warning: {warning}");
        }
        let audience = Audience {
            task,
            for_students: self.student,
        };
        for (kind, file) in &self.output {
            let text = kind.write(audience, &report);
            std::fs::write(file, text).map_err(|source| Failure::Output {
                path: Some(file.clone()),
                source,
            })?;
        }
        if self.output.is_empty() {
            to_stdout(OutputKind::Text.write(audience, &report).as_bytes())?;
        }
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
}

impl Grade {
    fn self_test(&self, path: &str) -> Result<Completion, Failure> {
        let tested = thread_pool::install(self.threads, || {
            let tasks = tasks(path)?;
            let test = SelfTest::new(&tasks);
            let task = tasks.into_iter().next();
            Ok::<_, Failure>(test.zip(task))
        });
        let Some((test, task)) = tested? else {
            return Ok(Completion::Whole);
        };
        to_stdout(test.to_text(&task).as_bytes())?;
        Ok(if test.failures.is_empty() {
            Completion::Whole
        } else {
            Completion::No
        })
    }
}

/// The task, and the task with each bend that counts as right.
fn tasks(path: &str) -> Result<Vec<Task>, Failure> {
    let input = |error: crate::grade::task::TaskError| Failure::Input(error.to_string());
    let task = Task::load(path).map_err(input)?;
    let accepted: Vec<Bend> = task.accept.clone();
    let mut tasks = vec![task];
    for bend in accepted {
        tasks.push(Task::bent(path, Bends::from(bend)).map_err(input)?);
    }
    Ok(tasks)
}

/// All bends by law.
fn list_bends() -> Result<Completion, Failure> {
    let width = Bend::all().map(|bend| bend.name().len()).max().unwrap_or(0);
    let mut law = None;
    let lines = Bend::all().map(|bend| {
        let entry = bend.entry();
        let heading = if law.replace(entry.law) == Some(entry.law) {
            String::new()
        } else {
            format!("{}:\n", entry.law)
        };
        format!(
            "{heading}  {:width$}  {}\n  {:width$}    {}; shows in: {}\n",
            bend.name(),
            entry.note,
            "",
            entry.formula,
            entry.tell
        )
    });
    let text: String = lines.collect();
    to_stdout(text.as_bytes())
}

fn parse_output(text: &str) -> Result<(OutputKind, PathBuf), String> {
    use clap::ValueEnum as _;
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
