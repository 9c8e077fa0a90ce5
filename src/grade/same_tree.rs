//! Whether two trees tell the same: so a student could not tell one from the other.

use rayon::prelude::*;

use super::pixel_tree::traced;
use super::quantity::QuantityKind;
use super::tolerance::Tolerances;
use crate::scene::{Bend, Settings};
use crate::trace::facts::{Fact, FactName, PixelFacts, RayFacts};
use crate::world::World;

/// The bends of a list whose tree of a pixel tells the same as that of `bend`; of a list that has it, `bend` is one of them. `None`
/// stands for our own laws.
pub fn bends_like(
    (world, settings): (&World, &Settings),
    at: (u32, u32),
    bend: Option<Bend>,
    among: &[Bend],
) -> Vec<Bend> {
    let tolerances = Tolerances::default();
    let tree = |bend: Option<Bend>| {
        let bends = bend.map(Into::into).unwrap_or_default();
        traced(world, &settings.with(|s| s.bends = bends), at)
    };
    let wanted = tree(bend);
    let is_like = |other: &&Bend| tell_the_same(&wanted, &tree(Some(**other)), &tolerances);
    among.par_iter().filter(is_like).copied().collect()
}

/// True if two trees have the same rays, which tell the same, and the same colour. The order in which shapes are tested is no part
/// of it.
pub fn tell_the_same(a: &PixelFacts, b: &PixelFacts, tolerances: &Tolerances) -> bool {
    let agree = |a: &Option<Fact>, b: &Option<Fact>| match (a, b) {
        (Some(a), Some(b)) => tolerances.agree(QuantityKind::Radiance, a, b),
        (None, None) => true,
        _ => false,
    };
    a.rays.len() == b.rays.len()
        && agree(&a.color, &b.color)
        && a.rays
            .iter()
            .zip(&b.rays)
            .all(|(a, b)| rays_tell_the_same(a, b, tolerances))
}

fn rays_tell_the_same(a: &RayFacts, b: &RayFacts, tolerances: &Tolerances) -> bool {
    let quantity = |name: &FactName| QuantityKind::of(a.kind, name);
    let told = |ray: &RayFacts| {
        let facts = ray.facts.iter();
        facts
            .filter(|(name, _)| quantity(name) != QuantityKind::Order)
            .count()
    };
    let agrees = |(name, ours): &(FactName, Fact)| {
        let theirs = b.get(name);
        quantity(name) == QuantityKind::Order
            || theirs.is_some_and(|theirs| {
                ours == theirs || tolerances.agree(quantity(name), ours, theirs)
            })
    };
    a.path == b.path && a.absent == b.absent && told(a) == told(b) && a.facts.iter().all(agrees)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::load;

    fn like(bend: Option<&str>, at: (u32, u32), among: &[&str]) -> Vec<String> {
        let scene = load("whitted").expect("built in");
        let settings = scene
            .settings
            .with(|s| (s.image.width, s.image.height) = (64, 48));
        let world = World::new(scene, settings.accel);
        let named = |name: &str| Bend::all().find(|b| b.name() == name).expect("a bend");
        let among: Vec<Bend> = among.iter().map(|name| named(name)).collect();
        let found = bends_like((&world, &settings), at, bend.map(named), &among);
        found.iter().map(|b| b.name().to_owned()).collect()
    }

    #[test]
    fn a_bend_is_like_itself_and_like_ours_where_it_shows_nothing() {
        let all = [
            "shadow-endless",
            "eta-inverted",
            "reflect-plus",
            "flat",
            "tir-black",
        ];
        // In the middle there is glass; above there is sky, and no bend shows.
        for bend in ["eta-inverted", "reflect-plus"] {
            assert_eq!(like(Some(bend), (32, 24), &all), [bend]);
        }
        let ours = like(None, (32, 24), &all);
        assert!(ours.contains(&"flat".to_owned()) && !ours.contains(&"eta-inverted".to_owned()));
        assert_eq!(like(Some("eta-inverted"), (32, 1), &all), all);
    }

    #[test]
    fn one_term_or_ray_more_is_not_the_same() {
        let scene = load("triangle").expect("built in");
        let settings = scene
            .settings
            .with(|s| (s.image.width, s.image.height) = (64, 48));
        let world = World::new(scene, settings.accel);
        let tree = traced(&world, &settings, (32, 24));
        let same = |other: &PixelFacts| {
            let tolerances = Tolerances::default();
            [
                tell_the_same(&tree, other, &tolerances),
                tell_the_same(other, &tree, &tolerances),
            ]
        };
        assert_eq!(same(&tree.clone()), [true; 2]);
        let changed = |change: &dyn Fn(&mut PixelFacts)| {
            let mut other = tree.clone();
            change(&mut other);
            assert_eq!(same(&other), [false; 2]);
        };
        changed(&|other| {
            other.rays.pop();
        });
        changed(&|other| {
            other.rays[0].facts.pop();
        });
        changed(&|other| other.color = None);
        changed(&|other| other.rays[0].absent.clear());
    }
}
