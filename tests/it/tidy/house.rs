//! The sources as a tree of modules: what each file defines and imports, and where a path leads.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use super::lexer::{Token, closing, code};
use super::uses::{Use, uses};

/// A path of modules and names from the root of the crate.
pub type Names = Vec<String>;

/// A file below `src`.
pub struct File {
    /// Its path below `src`, with `/`.
    pub name: String,
    pub text: String,
    /// Its module: none for lib.rs.
    pub module: Names,
    pub uses: Vec<Use>,
    /// What it defines itself, and its modules.
    pub defines: BTreeSet<String>,
}

/// All files, those of the crate's root but main.rs, which is a crate of its own.
pub struct House {
    pub files: Vec<File>,
    modules: BTreeMap<Names, usize>,
}

/// Rust files below a folder, in order.
pub fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

impl House {
    /// The files below a folder.
    pub fn read(src: &Path) -> Self {
        let files = sources(src).into_iter().map(|path| {
            let name = path.strip_prefix(src).expect("below it").display();
            let text = fs::read_to_string(&path).expect("UTF-8");
            (name.to_string().replace('\\', "/"), text)
        });
        Self::of(files)
    }

    /// Files by name and text.
    pub fn of(files: impl Iterator<Item = (String, String)>) -> Self {
        let files: Vec<File> = files.map(|(name, text)| File::new(name, text)).collect();
        let modules = files
            .iter()
            .enumerate()
            .filter(|(_, file)| file.name != "main.rs")
            .map(|(i, file)| (file.module.clone(), i))
            .collect();
        Self { files, modules }
    }

    /// Where a path leads that stands in a file, as a path from the root; `None` if it leads out of the crate.
    pub fn absolute(file: &File, path: &[String]) -> Option<Names> {
        let here = file.module.clone();
        let first = path.first()?.as_str();
        let mut names = match first {
            "crate" => Vec::new(),
            "self" => here,
            "super" => here[..here.len().checked_sub(1)?].to_vec(),
            _ if file.defines.contains(first) => [here, vec![first.to_string()]].concat(),
            _ => {
                let import = file.uses.iter().find(|u| u.name == first)?;
                if import.path.first().map(String::as_str) == Some(first) {
                    return None;
                }
                Self::absolute(file, &import.path)?
            }
        };
        for name in &path[1..] {
            if name == "super" {
                names.pop();
            } else {
                names.push(name.clone());
            }
        }
        Some(names)
    }

    /// The file that defines what a path from the root leads to; `None` if that is a module.
    pub fn definer(&self, names: &[String]) -> Option<usize> {
        self.definer_within(names, 20)
    }

    fn definer_within(&self, names: &[String], patience: u32) -> Option<usize> {
        let known = (0..=names.len()).rev();
        let depth = known
            .filter(|n| self.modules.contains_key(&names[..*n]))
            .max()?;
        let index = self.modules[&names[..depth]];
        let file = &self.files[index];
        let name = names.get(depth)?;
        if file.defines.contains(name) || patience == 0 {
            return Some(index);
        }
        // Brought in from elsewhere by name, or perhaps with all that is there.
        let named = file.uses.iter().filter(|u| u.name == *name);
        let globs = file.uses.iter().filter(|u| u.name == "*");
        let follow = |u: &Use| {
            let mut path = Self::absolute(file, &u.path)?;
            if u.name == "*" {
                path.push(name.clone());
            }
            path.extend_from_slice(&names[depth + 1..]);
            (path != names).then(|| self.definer_within(&path, patience - 1))?
        };
        named.chain(globs).find_map(follow).or(Some(index))
    }
}

impl File {
    fn new(name: String, text: String) -> Self {
        let stem = name.trim_end_matches(".rs");
        let module = match stem {
            "lib" | "main" => Vec::new(),
            _ => stem.split('/').map(str::to_string).collect(),
        };
        let tokens = code(&text);
        let (uses, defines) = (uses(&tokens), defined(&tokens));
        Self {
            name,
            text,
            module,
            uses,
            defines,
        }
    }

    /// Its code.
    pub fn code(&self) -> Vec<Token<'_>> {
        code(&self.text)
    }

    /// The folder or file below the root that it belongs to.
    pub fn layer(&self) -> &str {
        self.module.first().map_or("", String::as_str)
    }
}

/// Names of the items that a file defines, modules included.
fn defined(tokens: &[Token]) -> BTreeSet<String> {
    items(tokens)
        .into_iter()
        .map(|item| item.name.to_string())
        .collect()
}

/// An item by its keyword.
pub struct Item<'t> {
    pub kind: &'t str,
    pub name: &'t str,
    /// True if other files see it.
    pub shared: bool,
}

/// The items that stand in no other.
pub fn items<'t>(tokens: &[Token<'t>]) -> Vec<Item<'t>> {
    const KINDS: [&str; 9] = [
        "fn", "struct", "enum", "trait", "type", "const", "static", "union", "mod",
    ];
    let (mut found, mut at) = (Vec::new(), 0);
    while at < tokens.len() {
        let kind = tokens[at].text;
        let named = match kind {
            "{" | "(" | "[" => {
                at = closing(tokens, at);
                None
            }
            "macro_rules" => tokens.get(at + 2),
            // `const fn` is a function.
            _ if KINDS.contains(&kind) => tokens.get(at + 1).filter(|n| !KINDS.contains(&n.text)),
            _ => None,
        };
        let before = at.checked_sub(1).map_or("", |before| tokens[before].text);
        found.extend(named.map(|name| Item {
            kind,
            name: name.text,
            shared: matches!(before, "pub" | ")"),
        }));
        at += 1;
    }
    found
}
