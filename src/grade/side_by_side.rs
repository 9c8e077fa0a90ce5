//! Two trees side by side: a row a ray, aligned by its path. Rays below which all agrees are folded into one row.

use std::collections::BTreeMap;

use super::quantity::QuantityKind;
use super::tolerance::Tolerances;
use crate::scene::printable::printable;
use crate::trace::facts::{FactName, PixelFacts, RayFacts, TreePath};
use crate::trace::format::num;

/// A ray in two trees.
#[derive(Clone, Debug, PartialEq)]
pub struct RayPair {
    /// Where it is.
    pub path: TreePath,
    /// What it is in the one tree, if it is there.
    pub a: Option<String>,
    /// What it is in the other one.
    pub b: Option<String>,
    /// The first of its quantities that differs; none if all that both tell agree.
    pub differs: Option<FactName>,
    /// Rays below it that agree as well, and have no rows of their own.
    pub folded: usize,
}

impl RayPair {
    /// True if both trees have it and tell the same of it.
    pub fn is_same(&self) -> bool {
        self.a.is_some() && self.b.is_some() && self.differs.is_none()
    }
}

/// All rays of both trees, each behind the ray that sent it.
pub fn side_by_side(a: &PixelFacts, b: &PixelFacts, tolerances: &Tolerances) -> Vec<RayPair> {
    // The order of paths is that of a walk down the tree: a path comes right before all that go on from it.
    let mut paths: BTreeMap<&TreePath, [Option<&RayFacts>; 2]> = BTreeMap::new();
    for (side, tree) in [a, b].into_iter().enumerate() {
        for ray in &tree.rays {
            paths.entry(&ray.path).or_default()[side] = Some(ray);
        }
    }
    let pair = |(path, [a, b]): (&TreePath, [Option<&RayFacts>; 2])| RayPair {
        path: path.clone(),
        a: a.map(words),
        b: b.map(words),
        differs: a.zip(b).and_then(|(a, b)| difference(a, b, tolerances)),
        folded: 0,
    };
    folded(paths.into_iter().map(pair).collect())
}

/// Leaves out the rays below a ray if it and all of them agree.
fn folded(all: Vec<RayPair>) -> Vec<RayPair> {
    let mut rows: Vec<RayPair> = Vec::new();
    // From the last to the first: how many rows behind a ray hang on it, and whether they agree.
    for mut row in all.into_iter().rev() {
        let below = rows
            .iter()
            .rev()
            .take_while(|other| is_below(&other.path, &row.path))
            .count();
        let hanging = &rows[rows.len() - below..];
        if row.is_same() && hanging.iter().all(RayPair::is_same) {
            row.folded = hanging.iter().map(|other| 1 + other.folded).sum();
            rows.truncate(rows.len() - below);
        }
        rows.push(row);
    }
    rows.reverse();
    rows
}

fn is_below(path: &TreePath, above: &TreePath) -> bool {
    path.sample == above.sample
        && path.steps.len() > above.steps.len()
        && path.steps.starts_with(&above.steps)
}

/// The first quantity that both tell and that differs.
fn difference(a: &RayFacts, b: &RayFacts, tolerances: &Tolerances) -> Option<FactName> {
    let differs = |(name, ours): &&(FactName, _)| {
        let quantity = QuantityKind::of(a.kind, name);
        // The order in which shapes are tested is no part of the answer.
        quantity != QuantityKind::Order
            && b.get(name)
                .is_some_and(|theirs| !tolerances.agree(quantity, ours, theirs))
    };
    a.facts.iter().find(differs).map(|(name, _)| name.clone())
}

/// What a ray met, and what it brings.
fn words(ray: &RayFacts) -> String {
    let outcome = ray.word(&FactName::Outcome).unwrap_or("not told");
    let met = match (outcome, ray.word(&FactName::Object)) {
        ("hit", Some(object)) => object.to_owned(),
        ("blocked", Some(object)) => format!("blocked by {object}"),
        (outcome, _) => outcome.to_owned(),
    };
    let t = ray
        .number(&FactName::T)
        .map_or(String::new(), |t| format!(" t {}", num(t)));
    let brought = ray.color(&FactName::Radiance).filter(|c| !c.is_black());
    let brought = brought.map_or(String::new(), |c| {
        let [r, g, b] = c.channels().map(|x| format!("{x:.3}"));
        format!(" ({r} {g} {b})")
    });
    // Strangers choose the names.
    printable(&format!("{met}{t}{brought}")).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::pixel_tree::traced;
    use crate::scene::load;
    use crate::world::World;

    fn trees(scene: &str, at: (u32, u32)) -> [PixelFacts; 3] {
        let scene = load(scene).expect("built in");
        let settings = scene
            .settings
            .with(|s| (s.image.width, s.image.height) = (64, 48));
        let shallow = settings.with(|s| s.recursion.depth = 2);
        let world = World::new(scene, settings.accel);
        [
            traced(&world, &settings, at),
            traced(&world, &shallow, at),
            traced(&world, &settings, (at.0 + 1, at.1)),
        ]
    }

    #[test]
    fn a_tree_beside_itself_is_one_row() {
        let [tree, ..] = trees("nested-glass", (30, 24));
        let rows = side_by_side(&tree, &tree, &Tolerances::default());
        assert_eq!(rows.len(), 1, "{rows:?}");
        assert!(rows[0].is_same() && rows[0].a == rows[0].b);
        assert_eq!(rows[0].folded + 1, tree.rays.len());
    }

    /// Every ray of both trees is in a row or folded into one, once; what is folded is in both.
    #[test]
    fn every_ray_is_there_once() {
        let [deep, shallow, beside] = trees("nested-glass", (30, 24));
        for other in [&shallow, &beside] {
            let rows = side_by_side(&deep, other, &Tolerances::default());
            for (side, tree) in [(0, &deep), (1, other)] {
                let told = |row: &RayPair| [&row.a, &row.b][side].is_some();
                let count: usize = rows.iter().filter(|r| told(r)).map(|r| 1 + r.folded).sum();
                assert_eq!(count, tree.rays.len());
            }
            assert!(rows.iter().any(|row| !row.is_same()));
            let shown = |path: &TreePath| rows.iter().any(|row| row.path == *path);
            for ray in &deep.rays {
                let is_there = shown(&ray.path)
                    || rows
                        .iter()
                        .any(|r| r.folded > 0 && is_below(&ray.path, &r.path));
                assert!(is_there, "{}", ray.path);
            }
        }
        let rows = side_by_side(&deep, &shallow, &Tolerances::default());
        assert!(
            rows.iter().any(|row| row.b.is_none()),
            "rays that only one has"
        );
        assert!(rows.iter().all(|row| row.a.is_some()));
    }
}
