//! Triangles that are there twice, in one place: which of the two is seen?

use super::picture::{Panel, Picture, Seen, panel};
use super::pinhole::Eye;
use super::polygons::{RAYS, grey, outcomes, t, triangle};
use super::{Case, Chance, Outcome};
use crate::accel::{Accel, AccelKind};
use crate::geometry::{Hit, Shape};
use crate::math::{DVec3, Interval, Ray};
use crate::probe::Silent;

pub const COPLANAR_TWINS: Case = Case {
    name: "coplanar-twins",
    hard: "one triangle twice, in two colours: which of them is seen?",
    source: "polygons in one plane; ours: of equal t the smaller number",
    measure: coplanar_twins,
    picture: Picture {
        shows: "a wall of triangles that are there twice",
        wrong: "the second of two is seen",
        draw: wall,
    },
};

const NAMES: [&str; 2] = ["the first that is found", "ours"];

/// The first that is found wins, unless a later one is nearer: then it is a matter of the order in which they are tested. Ours is
/// asked of every accelerator.
fn coplanar_twins() -> Vec<Outcome> {
    let mut chance = Chance(15);
    let corners = [chance.point(), chance.point(), chance.point()];
    let twins = [triangle(corners), triangle(corners)];
    let trees = AccelKind::ALL.map(|kind| Accel::build(kind, &twins));
    let (mut by_order, mut ours) = (0, 0);
    for _ in 0..RAYS {
        let (u, v) = (0.5 * chance.next(), 0.5 * chance.next());
        let target = corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v;
        let origin = target + 3.0 * chance.point().normalize();
        let ray = Ray::new(origin, (target - origin).normalize());
        let [one, other] = [[0, 1], [1, 0]].map(|order| first_found(&order, &twins, &ray));
        by_order += usize::from(one != other);
        let first = seen(&trees[0], &twins, &ray);
        ours += usize::from(trees.iter().any(|tree| seen(tree, &twins, &ray) != first));
    }
    let unit = "% of rays see another in another order";
    outcomes(unit, NAMES, [by_order, ours])
}

/// The nearest of the shapes, tested in this order; of equally near ones the first.
fn first_found(order: &[usize], shapes: &[Shape], ray: &Ray) -> Option<usize> {
    let mut best: Option<(f64, usize)> = None;
    for i in order {
        if let Some(t) = t(&shapes[*i], ray)
            && best.is_none_or(|(nearest, _)| t < nearest)
        {
            best = Some((t, *i));
        }
    }
    best.map(|(_, i)| i)
}

/// What our accelerator finds.
fn seen(tree: &Accel, shapes: &[Shape], ray: &Ray) -> Option<usize> {
    let hit: Option<Hit> = tree.closest(shapes, ray, Interval::FORWARD, &mut Silent);
    hit.map(|hit| hit.primitive as usize)
}

/// A wall of triangles, each of them twice in a row. The first that is found wins, in the order in which a tree comes to them; ours
/// is asked of every accelerator.
fn wall(size: (u32, u32)) -> Vec<Panel> {
    let shapes = wall_of_twins();
    let trees = AccelKind::ALL.map(|kind| Accel::build(kind, &shapes));
    let halves = Halves::of((0..shapes.len()).collect(), 0, &shapes);
    let eye = Eye::new(DVec3::new(0.1, 0.2, 3.0), DVec3::ZERO, 0.33);
    // The first of two is as it should be; the second is dark.
    let look = |found: Option<usize>| match found {
        Some(i) if i % 2 == 0 => Seen {
            brightness: 0.5 + 0.35 * grey(i / 2),
            wrong: false,
        },
        _ => Seen {
            brightness: 0.1,
            wrong: true,
        },
    };
    let naive = panel((NAMES[0], false), size, |place| {
        let ray = eye.ray(place);
        let mut order = Vec::new();
        halves.walk(ray.direction, &mut order);
        look(first_found(&order, &shapes, &ray))
    });
    let ours = panel((NAMES[1], true), size, |place| {
        let ray = eye.ray(place);
        let mut found = trees.iter().map(|tree| seen(tree, &shapes, &ray));
        let first = found.next().flatten();
        look(first.filter(|_| found.all(|other| other == first)))
    });
    vec![naive, ours]
}

/// Squares of about the same size that fill the window, each cut into two triangles.
fn wall_of_twins() -> Vec<Shape> {
    const COLUMNS: usize = 9;
    const ROWS: usize = 7;
    let mut chance = Chance(37);
    let mut corners = [[DVec3::ZERO; COLUMNS + 1]; ROWS + 1];
    for (row, corners) in corners.iter_mut().enumerate() {
        for (column, corner) in corners.iter_mut().enumerate() {
            let [x, y] =
                [(column, COLUMNS), (row, ROWS)].map(|(i, n)| 3.0 * i as f64 / n as f64 - 1.5);
            *corner = DVec3::new(x, y, 0.0) + 0.1 * chance.point();
        }
    }
    let places = (0..ROWS).flat_map(|y| (0..COLUMNS).map(move |x| (x, y)));
    places
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [
                corners[y][x],
                corners[y][x + 1],
                corners[y + 1][x + 1],
                corners[y + 1][x],
            ];
            [[a, b, c], [a, b, c], [a, c, d], [a, c, d]].map(triangle)
        })
        .collect()
}

/// The simplest tree: what there is, halved along x, y, z, x and so on, down to single triangles.
enum Halves {
    One(Vec<usize>),
    Two(usize, Box<[Self; 2]>),
}

impl Halves {
    fn of(mut items: Vec<usize>, depth: usize, shapes: &[Shape]) -> Self {
        if items.len() < 2 {
            return Self::One(items);
        }
        let axis = depth % 3;
        let middle = |i: usize| shapes[i].bounds().map_or(0.0, |b| (b.min + b.max)[axis]);
        items.sort_by(|a, b| middle(*a).total_cmp(&middle(*b)));
        let upper = items.split_off(items.len() / 2);
        let halves = [items, upper].map(|half| Self::of(half, depth + 1, shapes));
        Self::Two(axis, Box::new(halves))
    }

    /// All of it, the half first from which the ray comes.
    fn walk(&self, direction: DVec3, order: &mut Vec<usize>) {
        match self {
            Self::One(items) => order.extend(items),
            Self::Two(axis, halves) => {
                let [lower, upper] = &**halves;
                let [near, far] = if direction[*axis] < 0.0 {
                    [upper, lower]
                } else {
                    [lower, upper]
                };
                near.walk(direction, order);
                far.walk(direction, order);
            }
        }
    }
}
