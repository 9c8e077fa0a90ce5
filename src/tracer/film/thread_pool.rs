//! A pool of threads whose stacks hold the deepest recursion of the tracer.

use crate::scene::limits::MAX_DEPTH;

/// Bytes for each level of recursion: several times what a level takes in an unoptimised build. Memory that is not
/// touched is not used.
const BYTES_A_LEVEL: usize = 32 * 1024;

/// Runs `work` where parallel iterators spread over `threads` threads (0: one a core), each with a stack that is
/// deep enough for [`MAX_DEPTH`] bounces. If the system gives no such threads, it runs on the calling one.
pub fn install<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .stack_size(MAX_DEPTH as usize * BYTES_A_LEVEL)
        .build();
    match pool {
        Ok(pool) => pool.install(work),
        Err(_) => work(),
    }
}
