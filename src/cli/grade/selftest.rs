//! `raytree grade --selftest`: what each known mistake earns in a task.

use crate::cli::output::to_stdout;
use crate::cli::{Completion, Failure};
use crate::grade::selftest::SelfTest;
use crate::grade::task::Task;
use crate::tracer::thread_pool;

/// Tests a task, which `load` reads together with each bend that counts as right.
pub fn run(
    threads: usize,
    load: impl Fn() -> Result<Vec<Task>, Failure> + Sync,
) -> Result<Completion, Failure> {
    let tested = thread_pool::install(threads, || {
        let tasks = load()?;
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
