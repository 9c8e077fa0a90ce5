//! The sandbox around what students hand in: the best that works here, without being asked.

use std::fmt;
use std::process::{Command, Stdio};

use super::command::split;
use super::place::{RunFolder, SubmissionCopy};
use crate::scene::printable::excerpt;

/// What processes are wrapped in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sandbox {
    /// Bubblewrap: no network, no other process, files are read only but for the submission's own.
    Bubblewrap,
    /// util-linux's `unshare` with these words: no network.
    Unshare(&'static [&'static str]),
    /// What the teacher wrote.
    Given(Vec<String>),
    /// None works here, or none is wanted.
    None(&'static str),
}

const BUBBLEWRAP: [&str; 11] = [
    "bwrap",
    "--unshare-all",
    "--die-with-parent",
    "--new-session",
    "--ro-bind",
    "/",
    "/",
    "--dev",
    "/dev",
    "--proc",
    "/proc",
];

/// From the strictest: with a list of processes of its own, without, and where there are no namespaces of processes.
const UNSHARE: [&[&str]; 3] = [
    &[
        "unshare",
        "--user",
        "--map-current-user",
        "--net",
        "--ipc",
        "--pid",
        "--fork",
        "--kill-child",
        "--mount-proc",
        "--",
    ],
    &[
        "unshare",
        "--user",
        "--map-current-user",
        "--net",
        "--ipc",
        "--pid",
        "--fork",
        "--kill-child",
        "--",
    ],
    &["unshare", "--user", "--net", "--"],
];

impl Sandbox {
    /// What is asked for, else the best that works.
    pub fn new(asked: Option<&str>) -> Result<Self, String> {
        if let Some(wrap) = asked {
            let words = split(wrap)?;
            return Ok(if words.is_empty() {
                Self::None("as asked")
            } else {
                Self::Given(words)
            });
        }
        if works(&[&BUBBLEWRAP[..], &["--"]].concat()) {
            return Ok(Self::Bubblewrap);
        }
        let unshare = UNSHARE.into_iter().find(|words| works(words));
        Ok(unshare.map_or(
            Self::None("neither bwrap nor unshare works here"),
            Self::Unshare,
        ))
    }

    /// The words before the program's own.
    pub fn words(&self, copy: &SubmissionCopy, folder: &RunFolder) -> Vec<String> {
        let path = |path: &std::path::Path| path.to_string_lossy().into_owned();
        match self {
            Self::Bubblewrap => {
                let top = path(copy.top());
                let elsewhere = copy.top().parent().map(path).unwrap_or_default();
                let (own, out) = (path(copy.path()), path(folder.out()));
                let words = BUBBLEWRAP.map(str::to_owned).into_iter();
                // Where others are run at the same time there is nothing but this submission.
                let binds = [
                    "--tmpfs",
                    &elsewhere,
                    "--ro-bind",
                    &top,
                    &top,
                    "--bind",
                    &own,
                    &own,
                    "--bind",
                    &out,
                    &out,
                    "--",
                ];
                words.chain(binds.map(str::to_owned)).collect()
            }
            Self::Unshare(words) => words.iter().map(|word| (*word).to_owned()).collect(),
            Self::Given(words) => {
                let top = path(copy.top());
                words
                    .iter()
                    .map(|word| word.replace("{folder}", &top))
                    .collect()
            }
            Self::None(_) => Vec::new(),
        }
    }
}

/// True if a program can be started behind these words.
fn works(words: &[&str]) -> bool {
    let Some((program, rest)) = words.split_first() else {
        return false;
    };
    let status = Command::new(program)
        .args(rest)
        .arg("true")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    cfg!(unix) && status.is_ok_and(|status| status.success())
}

impl fmt::Display for Sandbox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("sandbox: ")?;
        match self {
            Self::Bubblewrap => f.write_str(
                "bwrap (no network, no other processes, files are read only but for the submission's own)",
            ),
            Self::Unshare(words) if words.contains(&"--pid") => {
                f.write_str("unshare (no network, processes end with the program; files are not protected)")
            }
            Self::Unshare(_) => f.write_str("unshare (no network; files are not protected)"),
            Self::Given(words) => write!(f, "as asked: {}", excerpt(&words.join(" "))),
            Self::None(why) => write!(f, "none ({why}): network and files are not protected"),
        }?;
        if cfg!(unix) {
            Ok(())
        } else {
            f.write_str("; only time and output are limited on this system")
        }
    }
}
