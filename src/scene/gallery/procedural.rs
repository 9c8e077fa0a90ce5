//! Procedural scenes, by name or by name and size: `spd:balls:3`.

use super::spd::{KINDS, Kind};
use super::{lecture, slanted};
use crate::scene::Scene;
use crate::scene::limits::MAX_PRIMITIVES;
use crate::scene::read::error::{Problem, SceneError};

/// Names of the procedural scenes, with the default size, and what each shows.
pub fn list() -> Vec<(String, &'static str)> {
    let sized = KINDS.iter().map(|kind| {
        let name = format!("{}:{}", kind.name, kind.size);
        (name, kind.note)
    });
    let plain = [
        (lecture::NAME, lecture::NOTE),
        (slanted::NAME, slanted::NOTE),
    ];
    let plain = plain.map(|(name, note)| (name.to_string(), note));
    plain.into_iter().chain(sized).collect()
}

/// Names without a size.
pub fn names() -> impl Iterator<Item = &'static str> {
    [lecture::NAME, slanted::NAME]
        .into_iter()
        .chain(KINDS.iter().map(|kind| kind.name))
}

/// Whether `spec` names one of these scenes, with whatever size.
pub fn is_named(spec: &str) -> bool {
    [lecture::NAME, slanted::NAME].contains(&spec) || kind(spec).is_some()
}

fn kind(spec: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| {
        let rest = spec.strip_prefix(kind.name);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(':'))
    })
}

/// The scene that `spec` names; `None` if it names none of these. It is an error if the size is no number or too
/// large.
pub fn load(spec: &str) -> Option<Result<Scene, SceneError>> {
    if spec == lecture::NAME {
        return lecture::scene().map(Ok);
    }
    if spec == slanted::NAME {
        return slanted::scene().map(Ok);
    }
    let kind = kind(spec)?;
    let size = spec[kind.name.len()..].strip_prefix(':');
    let scene = size
        .map_or(Ok(kind.size), |text| parse(kind, text))
        .and_then(|size| kind.scene(size).ok_or_else(|| problem(kind, "has no view")));
    Some(scene.map_err(|p| p.in_file(spec)))
}

/// Size from 1 up to where the scene would have too many shapes.
fn parse(kind: &Kind, text: &str) -> Result<u32, Problem> {
    let size: u32 = text
        .parse()
        .map_err(|_| problem(kind, &format!("has no size `{text}`")))?;
    let count = (kind.count)(size);
    if size == 0 {
        Err(problem(kind, "of size 0 is empty"))
    } else if count > MAX_PRIMITIVES as u64 {
        Err(problem(
            kind,
            &format!("of size {size} has more than {MAX_PRIMITIVES} shapes"),
        ))
    } else {
        Ok(size)
    }
}

fn problem(kind: &Kind, what: &str) -> Problem {
    let Kind { name, size, .. } = kind;
    let fits = |s: &u32| (kind.count)(*s) <= MAX_PRIMITIVES as u64;
    let largest = (1..=64).take_while(fits).last().unwrap_or(*size);
    Problem::new(
        format!("`{name}` {what}"),
        format!("sizes go from 1 to {largest}, such as {name}:{size}"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_bounded_before_anything_is_built() {
        let refused = |spec: &str| match load(spec) {
            Some(Err(e)) => e.to_string(),
            other => panic!("{spec}: {:?}", other.is_some()),
        };
        assert!(refused("spd:balls:7").contains("sizes go from 1 to 6"));
        for kind in KINDS {
            for wrong in ["", "0", "-1", "x", "4:4", "4294967295", "99999999999"] {
                let said = refused(&format!("{}:{wrong}", kind.name));
                assert!(said.contains("sizes go from 1"), "{said}");
            }
        }
        assert!(load("spd:ball").is_none() && load("spd:ballsy").is_none());
    }

    #[test]
    fn the_counts_are_those_of_the_scenes() {
        for kind in KINDS {
            for size in 1..=3 {
                let scene = kind.scene(size).expect("a view");
                assert_eq!(scene.name, format!("{}:{size}", kind.name));
                assert_eq!(
                    scene.shapes.len() as u64,
                    (kind.count)(size),
                    "{}",
                    scene.name
                );
                assert_eq!(scene.shapes.len(), scene.owners.len());
            }
        }
    }
}
