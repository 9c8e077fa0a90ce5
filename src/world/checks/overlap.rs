//! Transparent objects of equal priority that overlap in part: which of them is in the overlap is a guess.

use super::{Checked, bounds};
use crate::geometry::Aabb;
use crate::math::{DVec3, Interval, Ray};
use crate::scene::warning::{WarningCode, Warnings};
use crate::world::World;

/// Pairs of objects that are looked at.
const MOST_PAIRS: usize = 256;

/// Points that are looked at in each of three boxes of a pair.
const POINTS: u32 = 64;

/// Steps of a sequence of points that fill a box evenly: the powers of 1/g, where g^4 = g + 1.
/// Source: Roberts 2018, "The unreasonable effectiveness of quasirandom sequences".
const STEPS: DVec3 = DVec3::new(
    0.819_172_513_396_164_5,
    0.671_043_606_703_789_3,
    0.549_700_477_901_970_3,
);

/// Warns about pairs of which a point in both was found, a point in the one alone, and a point in the other alone. One
/// inside of the other is no guess.
pub fn check(checked: &Checked, warnings: &mut Warnings) {
    let (world, scene) = (checked.world, &checked.world.scene);
    let is_transparent = |object: u32| {
        let material = scene.objects[object as usize].material;
        scene.materials[material as usize].is_transmissive()
    };
    let bodies: Vec<(u32, Aabb)> = (0..scene.objects.len() as u32)
        .filter(|o| is_transparent(*o) && !world.is_open(*o))
        .filter_map(|o| Some((o, bounds(scene.shapes_of(o))?)))
        .collect();
    let pairs = bodies.iter().enumerate().flat_map(|(i, a)| {
        let others = bodies[i + 1..].iter();
        others.map(move |b| (a, b))
    });
    let in_doubt = |(a, b): &(&(u32, Aabb), &(u32, Aabb))| {
        scene.objects[a.0 as usize].material != scene.objects[b.0 as usize].material
            && scene.medium_priority(a.0) == scene.medium_priority(b.0)
            && meet(&a.1, &b.1)
    };
    for ((a, in_a), (b, in_b)) in pairs.filter(in_doubt).take(MOST_PAIRS) {
        let common = Aabb {
            min: in_a.min.max(in_b.min),
            max: in_a.max.min(in_b.max),
        };
        let inside = |object: &u32, point| is_inside(world, *object, point);
        let found = points(&common).any(|p| inside(a, p) && inside(b, p))
            && points(in_a).any(|p| inside(a, p) && !inside(b, p))
            && points(in_b).any(|p| inside(b, p) && !inside(a, p));
        if found {
            let name = |object: &u32| &scene.objects[*object as usize].name;
            let what = format!(
                "`{}` and `{}` are transparent, overlap in part, and have equal priority: the smaller one is in the overlap",
                name(a),
                name(b)
            );
            let cure = "give the material of the one that is there a higher \"priority\"";
            warnings.add(WarningCode::EqualPriority, checked.path.error(what, cure));
        }
    }
}

/// Points that fill a box evenly.
fn points(bounds: &Aabb) -> impl Iterator<Item = DVec3> {
    let (min, size) = (bounds.min, bounds.size());
    (1..=POINTS).map(move |i| min + size * (f64::from(i) * STEPS).fract())
}

/// True if a ray from the point leaves the object more often than it enters it.
fn is_inside(world: &World, object: u32, point: DVec3) -> bool {
    let ray = Ray::new(point, DVec3::new(0.36, 0.48, 0.8));
    let crossings = world.crossings(&ray, Interval::FORWARD);
    let own = crossings.iter().filter(|c| c.object == object);
    let leaves = own.filter_map(|c| c.enters.map(|enters| if enters { -1 } else { 1 }));
    leaves.sum::<i32>() > 0
}

fn meet(a: &Aabb, b: &Aabb) -> bool {
    a.min.cmple(b.max).all() && b.min.cmple(a.max).all()
}
