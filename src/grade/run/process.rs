//! A process of a student's program, within its limits.
//!
//! It writes into files, not pipes: so nothing waits for a pipe that a process which outlives it keeps open.

use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use tempfile::NamedTempFile;

use crate::scene::printable::excerpt;

/// Bytes of what a process prints at most.
const MAX_OUTPUT_BYTES: u64 = 64 << 20;
/// Bytes at the end of the standard error stream that are looked at.
const MAX_SAID_BYTES: u64 = 4 << 10;

/// Limits of a process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProcessLimits {
    /// Seconds from its start to its end; and of computing time.
    pub seconds: u32,
    /// MiB of memory; 0 for no limit.
    pub mebibytes: u32,
}

impl Default for ProcessLimits {
    fn default() -> Self {
        Self {
            seconds: 10,
            mebibytes: 1024,
        }
    }
}

/// How a process ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ended {
    /// With success.
    Well,
    /// With an exit status.
    Status(i32),
    /// By a signal that is not ours.
    Signal(i32),
    /// At the time limit.
    OutOfTime,
    /// Because it printed too much.
    TooMuch,
    /// Because we are to stop.
    Stopped,
    /// It did not start, and why.
    NotStarted(String),
}

/// A process that has ended.
pub struct EndedProcess {
    /// How.
    pub ended: Ended,
    /// What it printed, to the end of a line if it was cut.
    pub printed: Vec<u8>,
    /// The last line of its error stream, to be shown as it is.
    pub said: String,
}

impl Ended {
    /// What went wrong, in words; `said` is the last line of its error stream.
    pub fn failure(&self, limits: ProcessLimits, said: &str) -> Option<String> {
        let ProcessLimits { seconds, mebibytes } = limits;
        let why = match self {
            Self::Well => return None,
            Self::Status(status) => format!("exit status {status}"),
            Self::Signal(signal @ 9) => format!(
                "ended by signal {signal}: perhaps more than {seconds} s of computing time or {mebibytes} MiB of memory"
            ),
            Self::Signal(signal) => format!("ended by signal {signal}"),
            Self::OutOfTime => format!("ended at the time limit of {seconds} s"),
            Self::TooMuch => format!("ended after {} MiB of output", MAX_OUTPUT_BYTES >> 20),
            Self::Stopped => "stopped".to_owned(),
            Self::NotStarted(why) => format!("cannot be started: {why}"),
        };
        Some(if said.is_empty() {
            why
        } else {
            format!("{why}: {said}")
        })
    }
}

/// Runs `program` behind the words of `wrap` in a folder, to its end or to a limit.
pub fn run(
    (wrap, program): (&[String], &[String]),
    folder: &Path,
    limits: ProcessLimits,
    stop: &AtomicBool,
) -> EndedProcess {
    let tried = || -> io::Result<EndedProcess> {
        let (printed, mut printed_end) = unnamed()?;
        let (said, mut said_end) = unnamed()?;
        let length = printed.try_clone()?;
        let mut command = command(wrap, program, limits);
        command
            .current_dir(folder)
            .env_clear()
            .env("PATH", std::env::var_os("PATH").unwrap_or_default())
            .env("LANG", "C.UTF-8")
            .env("HOME", folder)
            .stdin(Stdio::null())
            .stdout(printed)
            .stderr(said);
        let mut child = command.spawn()?;
        // The command keeps its ends of the files otherwise.
        drop(command);
        let limit = wait(&mut child, limits, stop, &length);
        let status = end(&mut child)?;
        let mut bytes = Vec::new();
        printed_end
            .by_ref()
            .take(MAX_OUTPUT_BYTES)
            .read_to_end(&mut bytes)?;
        let is_cut = bytes.len() as u64 >= MAX_OUTPUT_BYTES;
        if is_cut || limit.is_some() {
            let whole = memchr::memrchr(b'\n', &bytes).map_or(0, |at| at + 1);
            bytes.truncate(whole);
        }
        let limit = if is_cut { Some(Ended::TooMuch) } else { limit };
        Ok(EndedProcess {
            ended: limit.unwrap_or_else(|| of_status(status)),
            printed: bytes,
            said: last_line(&mut said_end)?,
        })
    };
    tried().unwrap_or_else(|e| EndedProcess {
        ended: Ended::NotStarted(excerpt(&e.to_string())),
        printed: Vec::new(),
        said: String::new(),
    })
}

/// A file without a name: the end to write, and one to read.
fn unnamed() -> io::Result<(File, File)> {
    let file = NamedTempFile::new()?;
    let reader = file.reopen()?;
    Ok((file.into_file(), reader))
}

/// Waits until a process has ended, or to a limit: then it tells which. On Unix it is not reaped, so that its number, which is that
/// of its group, belongs to no other.
fn wait(
    child: &mut Child,
    limits: ProcessLimits,
    stop: &AtomicBool,
    printed: &File,
) -> Option<Ended> {
    let until = Instant::now() + Duration::from_secs(limits.seconds.into());
    let mut pause = Duration::from_millis(1);
    while !has_ended(child) {
        if stop.load(Ordering::Relaxed) {
            return Some(Ended::Stopped);
        }
        if Instant::now() >= until {
            return Some(Ended::OutOfTime);
        }
        if printed
            .metadata()
            .is_ok_and(|printed| printed.len() >= MAX_OUTPUT_BYTES)
        {
            return Some(Ended::TooMuch);
        }
        thread::sleep(pause);
        pause = (2 * pause).min(Duration::from_millis(20));
    }
    None
}

/// The last line that says something, of the end of the error stream.
fn last_line(file: &mut File) -> io::Result<String> {
    let length = file.seek(SeekFrom::End(0))?;
    file.seek(SeekFrom::Start(length.saturating_sub(MAX_SAID_BYTES)))?;
    let mut bytes = Vec::new();
    file.take(MAX_SAID_BYTES).read_to_end(&mut bytes)?;
    let text = String::from_utf8_lossy(&bytes);
    let line = text.lines().rfind(|line| !line.trim().is_empty());
    Ok(excerpt(line.unwrap_or_default().trim()))
}

#[cfg(unix)]
fn of_status(status: ExitStatus) -> Ended {
    use std::os::unix::process::ExitStatusExt as _;
    // Linux and macOS: the limit of computing time.
    const SIGXCPU: i32 = 24;
    match (status.code(), status.signal()) {
        (Some(0), _) => Ended::Well,
        (Some(code), _) => Ended::Status(code),
        (None, Some(SIGXCPU)) => Ended::OutOfTime,
        (None, signal) => Ended::Signal(signal.unwrap_or_default()),
    }
}

#[cfg(not(unix))]
fn of_status(status: ExitStatus) -> Ended {
    match status.code() {
        Some(0) => Ended::Well,
        code => Ended::Status(code.unwrap_or(-1)),
    }
}

/// The shell sets limits and becomes the program; no text of a student is read by it. Units: s, KiB, 512 bytes.
#[cfg(unix)]
fn command(wrap: &[String], program: &[String], limits: ProcessLimits) -> Command {
    use std::os::unix::process::CommandExt as _;
    let memory = match limits.mebibytes {
        0 => "unlimited".to_owned(),
        mebibytes => (u64::from(mebibytes) << 10).to_string(),
    };
    let set = [
        ("t", limits.seconds.to_string()),
        ("v", memory),
        ("f", (MAX_OUTPUT_BYTES / 512).to_string()),
        ("c", "0".to_owned()),
    ];
    // A limit that a system does not know is passed over, and so is one that is lower already.
    let set = set.map(|(what, most)| format!("ulimit -{what} {most} 2>/dev/null; "));
    let script = set.concat();
    let shell = ["sh", "-c", &(script + "exec \"$@\""), "sh"].map(str::to_owned);
    let words: Vec<&String> = wrap.iter().chain(&shell).chain(program).collect();
    // A session of its own has no terminal that it could write to; a group of its own, at least, can be ended as one.
    if has_setsid() {
        let mut command = Command::new("setsid");
        command.args(words);
        return command;
    }
    let mut command = Command::new(words[0]);
    command.args(&words[1..]).process_group(0);
    command
}

#[cfg(unix)]
fn has_setsid() -> bool {
    use std::sync::OnceLock;
    static FOUND: OnceLock<bool> = OnceLock::new();
    *FOUND.get_or_init(|| {
        let tried = Command::new("setsid")
            .arg("true")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status();
        tried.is_ok_and(|status| status.success())
    })
}

#[cfg(unix)]
fn has_ended(child: &Child) -> bool {
    use rustix::process::{Pid, WaitId, WaitIdOptions, waitid};
    let options = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
    !matches!(
        waitid(WaitId::Pid(Pid::from_child(child)), options),
        Ok(None)
    )
}

/// Ends a process and all of its group, and reaps it.
#[cfg(unix)]
fn end(child: &mut Child) -> io::Result<ExitStatus> {
    use rustix::process::{Pid, Signal, kill_process_group};
    // There may be no group yet, or no more: then there is the process alone, or nothing.
    let _ = kill_process_group(Pid::from_child(child), Signal::KILL);
    let _ = child.kill();
    child.wait()
}

#[cfg(not(unix))]
fn command(wrap: &[String], program: &[String], _: ProcessLimits) -> Command {
    let words: Vec<&String> = wrap.iter().chain(program).collect();
    let mut command = Command::new(words[0]);
    command.args(&words[1..]);
    command
}

#[cfg(not(unix))]
fn has_ended(child: &mut Child) -> bool {
    !matches!(child.try_wait(), Ok(None))
}

#[cfg(not(unix))]
fn end(child: &mut Child) -> io::Result<ExitStatus> {
    // It may have ended.
    let _ = child.kill();
    child.wait()
}
