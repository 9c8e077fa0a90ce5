//! Names in a query that nothing in the scene has: such a query is never true, which a misspelt name should not hide.

use super::quantity::NodeQuantity;
use super::{Pattern, Property, TreeQuery};
use crate::geometry::Body;
use crate::scene::Scene;
use crate::scene::printable::excerpt;
use crate::scene::read::did_you_mean::did_you_mean;

/// Names that are listed where none is near.
const LISTED: usize = 6;

/// What has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Named {
    Object,
    Material,
    Part,
    Light,
}

/// In a sentence the first name of a query that no object, material, part or light of the scene has, with the name that may be meant.
/// Names with `*` stand for any, and are not looked up.
pub fn unknown_names(query: &TreeQuery, scene: &Scene) -> Option<String> {
    match query {
        TreeQuery::And(a, b) | TreeQuery::Or(a, b) => {
            unknown_names(a, scene).or_else(|| unknown_names(b, scene))
        }
        TreeQuery::Not(query) | TreeQuery::Some(query) => unknown_names(query, scene),
        TreeQuery::Is(property) => match property {
            Property::Hits(name) | Property::Path(_, name) => unknown(Named::Object, name, scene),
            Property::Material(name) => unknown(Named::Material, name, scene),
            Property::Part(name) => unknown(Named::Part, name, scene),
            Property::Lit(name) | Property::Blocked(name) => unknown(Named::Light, name, scene),
            Property::Kind(_)
            | Property::Hit
            | Property::Miss
            | Property::Front
            | Property::Back
            | Property::Absent(_) => None,
        },
        TreeQuery::Compare(quantity, ..) => match quantity {
            NodeQuantity::Factor(_, name) | NodeQuantity::Terms(_, name) => {
                unknown(Named::Light, name, scene)
            }
            _ => None,
        },
    }
}

fn unknown(named: Named, Pattern(name): &Pattern, scene: &Scene) -> Option<String> {
    let all: Vec<&str> = match named {
        Named::Object => scene.objects.iter().map(|o| o.name.as_str()).collect(),
        Named::Material => scene.materials.iter().map(|m| m.name.as_str()).collect(),
        Named::Part => parts(scene),
        Named::Light => scene.lights.iter().map(|l| l.name.as_str()).collect(),
    };
    // Where terms are of no light, as ambient light is, the light has no name.
    if name.is_empty() || name.contains('*') || all.contains(&name.as_str()) {
        return None;
    }
    let what = match named {
        Named::Object => "object",
        Named::Material => "material",
        Named::Part => "part",
        Named::Light => "light",
    };
    let cure = match did_you_mean(name, all.iter().copied()) {
        Some(near) => format!("did you mean `{}`?", excerpt(near)),
        None if all.is_empty() => format!("the scene has no {what}"),
        None => {
            let listed: Vec<String> = all.iter().take(LISTED).map(|name| excerpt(name)).collect();
            let more = if all.len() > LISTED { ", ..." } else { "" };
            format!("there are {}{more}", listed.join(", "))
        }
    };
    Some(format!("no {what} is named `{}`; {cure}", excerpt(name)))
}

/// The names of parts: those of the solids that are cut from others, then those that many shapes have.
fn parts(scene: &Scene) -> Vec<&str> {
    let leaves = scene.objects.iter().flat_map(|object| &object.leaves);
    let leaves = leaves.map(|leaf| leaf.name.as_str());
    leaves.chain(Body::PART_NAMES).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::load;

    #[test]
    fn names_that_the_scene_does_not_have_are_told_and_no_others() {
        let scene = load("soft-shadow").expect("built in");
        let object = &scene.objects[0].name;
        let (material, light) = (&scene.materials[0].name, &scene.lights[0].name);
        for known in [
            format!("hits:\"{object}\" and not lit:\"{light}\""),
            format!("some(material:\"{material}\") or diffuse:\"{light}\" > 0"),
            "hits:none* and lit:*x or tir".to_owned(),
            format!("path:R>\"{object}\""),
        ] {
            let query: TreeQuery = known.parse().expect("a query");
            assert_eq!(unknown_names(&query, &scene), None, "{known}");
        }
        for (text, what, name) in [
            (format!("hit and hits:{object}x"), "object", object),
            (format!("some(path:RT>{object}x)"), "object", object),
            (format!("not material:{material}x"), "material", material),
            (format!("miss or lit:{light}x"), "light", light),
            (format!("blocked:{light}x"), "light", light),
            (format!("n_dot_l:{light}x > 0"), "light", light),
            (format!("specular:{light}x > 0"), "light", light),
        ] {
            let query: TreeQuery = text.parse().expect("a query");
            let said = unknown_names(&query, &scene).expect("unknown");
            let wanted = format!("no {what} is named `{name}x`; did you mean `{name}`?");
            assert_eq!(said, wanted, "{text}");
        }
        let far: TreeQuery = "hits:zzzzzzzz".parse().expect("a query");
        let said = unknown_names(&far, &scene).expect("unknown");
        assert!(said.contains(object.as_str()), "{said}");
    }
}
