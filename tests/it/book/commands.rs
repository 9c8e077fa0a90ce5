//! The page of commands: each command with its arguments and flags, made of what `raytree help` prints.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::made::{cell, shows};
use super::{page, printed};

const PAGE: &str = "commands.md";

/// What stands in this many commands with the same words is told once.
const MANY: usize = 4;

/// The help of a command.
struct Help {
    /// Its words, such as `lesson check`.
    name: String,
    doc: String,
    usage: String,
    entries: Vec<Entry>,
    commands: Vec<String>,
}

/// An argument or a flag.
#[derive(Clone)]
struct Entry {
    name: String,
    doc: String,
    /// True if a heading of settings stands above it.
    setting: bool,
}

impl Entry {
    /// `--flag` without its value and its letter.
    fn flag(&self) -> Option<&str> {
        let start = self.name.find("--")?;
        self.name[start..].split([' ', '[', '=', ',']).next()
    }
}

/// The help of a command from its text: headings begin in the first column, entries in one of the first seven.
fn help(name: &str, text: &str) -> Help {
    let mut help = Help {
        name: name.to_owned(),
        doc: String::new(),
        usage: String::new(),
        entries: Vec::new(),
        commands: Vec::new(),
    };
    let mut heading = "";
    for line in text.lines() {
        let trimmed = line.trim();
        let indent = line.len() - line.trim_start().len();
        if indent == 0 {
            if let Some(usage) = line.strip_prefix("Usage: ") {
                usage.clone_into(&mut help.usage);
            } else if line.ends_with(':') {
                heading = line;
            } else if help.usage.is_empty() && !trimmed.is_empty() {
                help.doc = format!("{} {trimmed}", help.doc);
            }
        } else if heading == "Commands:" {
            let command = trimmed.split(' ').next().unwrap_or_default();
            if indent == 2 && command != "help" {
                help.commands.push(command.to_owned());
            }
        } else if indent < 8 && trimmed.starts_with(['-', '<', '[']) {
            let (name, doc) = trimmed.split_once("  ").unwrap_or((trimmed, ""));
            let setting = !["Options:", "Arguments:", "Run programs:"].contains(&heading);
            help.entries.push(Entry {
                name: name.to_owned(),
                doc: doc.trim().to_owned(),
                setting,
            });
        } else if let Some(entry) = help.entries.last_mut() {
            let value = trimmed.strip_prefix("- ");
            let value = value.and_then(|value| value.split_once(':'));
            if let Some((value, doc)) = value {
                let more = format!("; `{value}`: {}", doc.trim());
                entry.doc.push_str(&more);
            } else {
                entry.doc.push(' ');
                entry.doc.push_str(trimmed);
            }
        }
    }
    for entry in &mut help.entries {
        entry.doc = cell(&entry.doc).replace(" Possible values:;", ":");
    }
    help
}

/// The help of all commands, those of commands behind them.
fn all() -> Vec<Help> {
    let mut names = help("", &printed(&["help"])).commands;
    assert!(names.len() > 12, "the commands are there: {names:?}");
    let mut all = Vec::new();
    while !names.is_empty() {
        let name = names.remove(0);
        let words: Vec<&str> = name.split(' ').chain(["--help"]).collect();
        let help = help(&name, &printed(&words));
        let inner = help
            .commands
            .iter()
            .map(|command| format!("{name} {command}"));
        names.splice(0..0, inner);
        all.push(help);
    }
    all
}

/// Flags that many commands have with the same words.
fn common(all: &[Help]) -> Vec<Entry> {
    let mut counts: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut order: Vec<&Entry> = Vec::new();
    for entry in all
        .iter()
        .flat_map(|help| &help.entries)
        .filter(|e| e.flag().is_some() && !is_elsewhere(e))
    {
        let count = counts.entry((&entry.name, &entry.doc)).or_default();
        *count += 1;
        if *count == MANY {
            order.push(entry);
        }
    }
    order.into_iter().cloned().collect()
}

/// True for what the page of settings has.
fn is_elsewhere(entry: &Entry) -> bool {
    entry.setting
        && entry
            .flag()
            .is_some_and(|flag| page("settings.md").contains(&format!("| `{flag}` |")))
}

fn rows(entries: &[&Entry]) -> String {
    let mut out = String::new();
    if !entries.is_empty() {
        out += "\n| | |\n|---|---|\n";
    }
    for entry in entries {
        let _ = writeln!(
            out,
            "| `{}` | {} |",
            entry.name.replace('|', "\\|"),
            entry.doc
        );
    }
    out
}

/// The piece of a command.
fn told(help: &Help, common: &[Entry]) -> String {
    let is_common = |entry: &Entry| {
        common
            .iter()
            .any(|c| c.name == entry.name && c.doc == entry.doc)
    };
    let own: Vec<&Entry> = help
        .entries
        .iter()
        .filter(|e| !is_common(e) && !is_elsewhere(e))
        .collect();
    let mut out = format!(
        "{}.\n\n```text\n{}\n```\n{}",
        help.doc.trim(),
        help.usage,
        rows(&own)
    );
    let shared: Vec<String> = help
        .entries
        .iter()
        .filter(|e| is_common(e))
        .filter_map(|e| Some(format!("`{}`", e.flag()?)))
        .collect();
    let mut more = Vec::new();
    if help.entries.iter().any(is_elsewhere) {
        more.push("the [settings](settings.md) of a picture".to_owned());
    }
    if !shared.is_empty() {
        more.push(format!(
            "the [flags of many commands](#flags-of-many-commands) {}",
            shared.join(" ")
        ));
    }
    if !more.is_empty() {
        let _ = write!(out, "\nAlso {}.\n", more.join(", and "));
    }
    out
}

#[test]
fn every_command_and_flag_stands_on_the_page() {
    let all = all();
    let common = common(&all);
    let refs: Vec<&Entry> = common.iter().collect();
    let mut pieces: Vec<(String, String)> = all
        .iter()
        .map(|help| (help.name.clone(), told(help, &common)))
        .collect();
    pieces.push(("flags of many commands".to_owned(), rows(&refs)));
    shows(PAGE, &pieces);
    // What was made is whole: no flag was lost on the way.
    let text = page(PAGE) + &page("settings.md");
    for help in &all {
        let words: Vec<&str> = help.name.split(' ').chain(["--help"]).collect();
        let printed = printed(&words);
        let flags = printed
            .split([' ', '\n', ','])
            .filter(|word| word.starts_with("--") && word.len() > 4);
        for flag in flags.map(|flag| flag.trim_end_matches(['.', ';', ':', ')', ']'])) {
            let flag = flag.split(['[', '=']).next().unwrap_or_default();
            assert!(text.contains(flag), "{}: {flag}", help.name);
        }
    }
}

#[test]
fn every_command_has_its_heading_and_an_example() {
    let text = page(PAGE);
    for name in all().iter().map(|help| &help.name) {
        let example = text.lines().any(|line| {
            line.strip_prefix("$ raytree ")
                .is_some_and(|rest| rest == name || rest.starts_with(&format!("{name} ")))
        });
        assert!(
            text.contains(&format!("# raytree {name}\n")),
            "{name} has no heading"
        );
        assert!(example, "{name} has no example");
    }
}
