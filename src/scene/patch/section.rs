//! Sections of a scene file that can be changed, and what has a name in them.

use serde_json::Value;

use crate::scene::limits::MAX_NAME_BYTES;
use crate::scene::printable::printable;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::Problem;

/// Names that a message lists at most.
const MOST_LISTED: usize = 12;

/// A section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    Camera,
    Background,
    Ambient,
    Materials,
    Lights,
    Objects,
    Parts,
}

/// Something with a name.
pub struct Element {
    /// Its name; that of an object in a group begins with the group's.
    pub name: String,
    /// Where its fields are: a JSON pointer (RFC 6901).
    pub pointer: String,
}

impl Section {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Camera,
        Self::Background,
        Self::Ambient,
        Self::Materials,
        Self::Lights,
        Self::Objects,
        Self::Parts,
    ];

    /// Its key in the file.
    pub fn key(self) -> &'static str {
        match self {
            Self::Materials => "materials",
            Self::Lights => "lights",
            Self::Objects => "objects",
            Self::Parts => "parts",
            _ => self.singular(),
        }
    }

    /// What it is called where one thing of it is meant.
    pub fn singular(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Background => "background",
            Self::Ambient => "ambient",
            Self::Materials => "material",
            Self::Lights => "light",
            Self::Objects => "object",
            Self::Parts => "part",
        }
    }

    /// Whether its things have names.
    pub fn has_names(self) -> bool {
        matches!(
            self,
            Self::Materials | Self::Lights | Self::Objects | Self::Parts
        )
    }

    /// The section that is called so.
    pub fn named(word: &str) -> Result<Self, Problem> {
        let mut all = Self::ALL.into_iter();
        all.find(|s| s.singular() == word || s.key() == word)
            .ok_or_else(|| {
                let shown = printable(word);
                Problem::new(format!("a scene has no `{shown}`"), Self::cure(word))
            })
    }

    /// What to do about a word that is no section.
    pub fn cure(word: &str) -> String {
        let all = Self::ALL.map(Self::singular);
        let guess = did_you_mean(word, all).map(|near| format!("did you mean `{near}`? "));
        format!(
            "{}what can be changed is {}",
            guess.unwrap_or_default(),
            all.join(", ")
        )
    }

    /// Refuses what would rename, remove or replace something, or part of it, as a whole. `what` is what is changed.
    pub fn check_fields(self, what: &str, fields: &Value) -> Result<(), Problem> {
        if matches!(self, Self::Background | Self::Ambient) {
            return Ok(());
        }
        let what = printable(what);
        let Value::Object(fields) = fields else {
            return Err(Problem::new(
                format!("of `{what}` single fields can be changed, not all of it"),
                "name the field that is changed",
            ));
        };
        if self.has_names() && self != Self::Materials && fields.contains_key("name") {
            return Err(Problem::new(
                format!("`{what}` keeps its name: it is what changes are told by"),
                "change the name in the scene file",
            ));
        }
        if matches!(self, Self::Objects | Self::Parts) && fields.contains_key("objects") {
            return Err(Problem::new(
                format!("the parts of `{what}` are changed one by one"),
                format!(
                    "name the part, as in {}.{what}/PART.FIELD=VALUE",
                    self.singular()
                ),
            ));
        }
        Ok(())
    }
}

/// What has a name in a section.
pub fn elements(scene: &Value, section: Section) -> Vec<Element> {
    let all = &scene[section.key()];
    let mut found = Vec::new();
    if let (Section::Parts, Value::Object(parts)) = (section, all) {
        for (name, objects) in parts {
            let at = format!("/{}/{}", section.key(), escaped(name));
            listed(objects, &format!("{name}/"), &at, &mut found);
        }
    } else if let Value::Object(named) = all {
        found.extend(named.keys().map(|name| Element {
            name: name.clone(),
            pointer: format!("/{}/{}", section.key(), escaped(name)),
        }));
    }
    listed(all, "", &format!("/{}", section.key()), &mut found);
    found
}

/// A name in a JSON pointer.
fn escaped(name: &str) -> String {
    name.replace('~', "~0").replace('/', "~1")
}

/// Adds the elements of a list, and of the groups in it.
fn listed(list: &Value, prefix: &str, at: &str, found: &mut Vec<Element>) {
    for (i, element) in list.as_array().into_iter().flatten().enumerate() {
        // The kind is the only key.
        let Some((kind, fields)) = element.as_object().and_then(|kinds| kinds.iter().next()) else {
            continue;
        };
        let name = format!("{prefix}{}", fields["name"].as_str().unwrap_or_default());
        // The reader refuses longer ones; their parts would have still longer ones.
        if name.len() > MAX_NAME_BYTES {
            continue;
        }
        let pointer = format!("{at}/{i}/{kind}");
        let inner = (format!("{name}/"), format!("{pointer}/objects"));
        listed(&fields["objects"], &inner.0, &inner.1, found);
        found.push(Element { name, pointer });
    }
}

/// The problem of a name that nothing has.
pub fn unknown(section: Section, name: &str, known: &[Element], scene: &Value) -> Problem {
    let kind = section.singular();
    let what = format!("there is no {kind} `{}`", printable(name));
    let names = || known.iter().map(|element| element.name.as_str());
    let guess = did_you_mean(name, names()).map(|near| format!("did you mean `{near}`? "));
    let first: Vec<&str> = names().take(MOST_LISTED).collect();
    let listed = match (known.len(), first.join(", ")) {
        (0, _) => format!("the scene file has no {}", section.key()),
        (count, listed) if count > MOST_LISTED => format!("there are {listed}, ..."),
        (1, listed) => format!("there is {listed}"),
        (_, listed) => format!("there are {listed}"),
    };
    let models = if has_models(scene) && section != Section::Lights {
        " (what a model brings with it is changed in its own files)"
    } else {
        ""
    };
    Problem::new(
        what,
        format!("{}{listed}{models}", guess.unwrap_or_default()),
    )
}

/// Whether a scene names models.
fn has_models(scene: &Value) -> bool {
    let objects = scene["objects"].as_array().into_iter().flatten();
    let mut kinds = objects.filter_map(Value::as_object);
    kinds.any(|kind| kind.contains_key("obj"))
}
