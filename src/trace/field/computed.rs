//! Fields that stand in no document: they are computed from what is recorded.

use serde_json::Value;

use super::equations::{EQUATIONS, number};
use crate::probe::{Event, NONE, RayKind, Term};
use crate::scene::printable::excerpt;
use crate::trace::{Outcome, View};

/// A field that is computed, if the name is that of one. An error if this ray does not have it.
pub fn computed(view: View, id: u32, name: &str) -> Option<Result<Value, String>> {
    let node = view.trace.tree.node(id);
    let (first, rest) = name.split_once('.').unwrap_or((name, ""));
    Some(match first {
        "rays" => Ok(node.size.into()),
        "lit" => lit(view, id),
        "angle" | "normal_angle" | "n_dot_v" => angle(view, id, first),
        surface if EQUATIONS.contains(&surface) => number(view, id, surface, rest),
        "terms" if !rest.is_empty() => term(view, id, rest),
        "absent" if !rest.is_empty() => absent(view, id, rest),
        "order" => Ok(steps(view, id).into()),
        "steps" => Ok(steps(view, id).len().into()),
        _ => return None,
    })
}

/// Whether an L ray reaches its light.
fn lit(view: View, id: u32) -> Result<Value, String> {
    match view.trace.tree.node(id).outcome {
        Some(Outcome::Lit) => Ok("lit".into()),
        Some(Outcome::Blocked(_)) => Ok("blocked".into()),
        _ => Err("`lit` is a field of L rays, such as 160,120/L:lamp.lit".to_owned()),
    }
}

/// Angles between a ray and the surface that it hits, in degrees.
fn angle(view: View, id: u32, name: &str) -> Result<Value, String> {
    let surface = view.surface_hit(id);
    let at = surface
        .ok_or_else(|| format!("`{name}`: this ray hits nothing"))?
        .at;
    let degrees = |cosine: f64| libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
    let cosine = at.normal.dot(at.to_viewer);
    Ok(match name {
        "n_dot_v" => cosine.into(),
        "angle" => degrees(cosine).into(),
        _ => degrees(at.normal.dot(at.geometric_normal)).into(),
    })
}

/// A term such as `diffuse:lamp`, or a factor of it such as `diffuse:lamp.n_dot_l`.
fn term(view: View, id: u32, name: &str) -> Result<Value, String> {
    let mut told = Vec::new();
    for (_, event) in view.trace.tree.own_events(id) {
        let Event::Term {
            term,
            light,
            sample,
        } = event
        else {
            continue;
        };
        let own = term_name(view, term, *light, *sample);
        let rest = name.strip_prefix(own.as_str());
        let rest = rest.filter(|rest| rest.is_empty() || rest.starts_with('.'));
        if let Some(rest) = rest {
            let factors = factors(view, id, term, (*light, u32::from(*sample)))?;
            return match rest.strip_prefix('.') {
                None => serde_json::to_value(term.value()).map_err(|e| e.to_string()),
                Some(factor) => factors.get(factor).cloned().ok_or_else(|| {
                    let names: Vec<&str> = factors
                        .as_object()
                        .map_or(Vec::new(), |all| all.keys().map(String::as_str).collect());
                    format!("term {own} has the factors {}", names.join(", "))
                }),
            };
        }
        told.push(own);
    }
    let told = if told.is_empty() {
        "none".to_owned()
    } else {
        told.join(", ")
    };
    Err(format!(
        "this ray has no term {}; there are {told}",
        excerpt(name)
    ))
}

/// The factors of a term by name. A blended term has lists of what its corners have: `weight`, `n_dot_l`, `r_dot_v` and `corners`, the
/// values there.
fn factors(view: View, id: u32, term: &Term, light: (u32, u32)) -> Result<Value, String> {
    let Term::Blended { kind, .. } = term else {
        let factors = crate::trace::document::TermFactors::from(term);
        return serde_json::to_value(factors).map_err(|e| e.to_string());
    };
    let corners = view.corner_terms(id, *kind, light);
    let corners = corners.ok_or_else(|| "the corners of this term are not known".to_owned())?;
    let mut lists = serde_json::Map::new();
    let weights = corners.map(|corner| corner.weight).to_vec();
    lists.insert("weight".to_owned(), weights.into());
    let cosines = [
        ("n_dot_l", corners.map(|corner| corner.n_dot_l())),
        ("r_dot_v", corners.map(|corner| corner.r_dot_v())),
    ];
    for (name, cosines) in cosines {
        if cosines.iter().any(Option::is_some) {
            lists.insert(name.to_owned(), cosines.to_vec().into());
        }
    }
    let values = corners.map(|corner| corner.value());
    let values = serde_json::to_value(values).map_err(|e| e.to_string())?;
    lists.insert("corners".to_owned(), values);
    Ok(Value::Object(lists))
}

/// A term by its kind and its light.
pub fn term_name(view: View, term: &Term, light: u32, sample: u16) -> String {
    let kind = term.kind().name();
    match (light, sample) {
        (NONE, _) => kind.to_owned(),
        (light, 0) => format!("{kind}:{}", view.light_name(light)),
        (light, sample) => format!("{kind}:{}~{sample}", view.light_name(light)),
    }
}

/// Why a ray is not sent, or that it is: `T`, `R`, `L:lamp`, and a number of it such as `T.k`.
fn absent(view: View, id: u32, name: &str) -> Result<Value, String> {
    let (ray, number) = match name.split_once('.') {
        Some((ray, number)) => (ray, Some(number)),
        None => (name, None),
    };
    let tree = &view.trace.tree;
    let is_it = |kind: RayKind, light: u32| match (ray.strip_prefix("L:"), light) {
        (Some(_), NONE) | (None, _) => kind.letter() == ray,
        (Some(wanted), light) => kind == RayKind::Light && view.light_name(light) == wanted,
    };
    if let Some(number) = number {
        let document = crate::trace::document::of(view);
        let path = crate::trace::address::path_of(view, id);
        let document = crate::trace::address::subtree(document, &path)?;
        let node = document.samples.into_iter().find_map(|s| s.root);
        let mut absent = node.into_iter().flat_map(|node| node.absent);
        let found =
            absent.find(|a| a.kind.letter() == ray || a.light.as_deref() == ray.strip_prefix("L:"));
        let found = serde_json::to_value(found).map_err(|e| e.to_string())?;
        let missing = || format!("`absent.{}` is no number here", excerpt(name));
        return found.get(number).cloned().ok_or_else(missing);
    }
    let reason = tree.own_events(id).find_map(|(_, event)| match event {
        Event::Absent {
            kind,
            light,
            reason,
        } if is_it(*kind, *light) => Some(reason.name()),
        _ => None,
    });
    if let Some(reason) = reason {
        return Ok(reason.into());
    }
    let sent = tree
        .children(id)
        .map(|child| &tree.node(child).ray)
        .any(|sent| is_it(sent.kind, sent.light));
    if sent {
        return Ok("sent".into());
    }
    Err(format!(
        "no ray {} is sent from here, and no reason is told: the surface asks for none",
        excerpt(ray)
    ))
}

/// The steps of a ray's traversal, each in a word or two.
pub fn steps(view: View, id: u32) -> Vec<String> {
    let own = view.trace.tree.own_events(id);
    own.filter_map(|(_, event)| step(view, event)).collect()
}

/// A step of the traversal in a word or two; none for other events.
pub fn step(view: View, event: &Event) -> Option<String> {
    match event {
        Event::Visit(visit) if visit.is_skipped() => Some(format!("skip {}", visit.node)),
        Event::Visit(visit) => Some(format!("node {}", visit.node)),
        Event::Test { primitive, .. } => {
            let scene = &view.world.scene;
            let name = &scene.object_of(*primitive).name;
            let owner = scene.owners[*primitive as usize];
            Some(match scene.shapes_of(owner).len() {
                0 | 1 => name.clone(),
                _ => format!("{name} {}", scene.local_index(*primitive)),
            })
        }
        _ => None,
    }
}
