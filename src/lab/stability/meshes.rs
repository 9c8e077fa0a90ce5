//! Closed meshes: rays at edges and corners that triangles share.

use super::picture::{Panel, Picture, Place, Seen, panel};
use super::pinhole::Eye;
use super::{Case, Chance, Outcome, percent, under};
use crate::geometry::{Arithmetic, Intersection, Shape, Shear, Triangle, TriangleTest};
use crate::math::{DVec3, Interval, Ray};

pub const SHARED_EDGES: Case = Case {
    name: "shared-edges",
    hard: "rays aimed at the edges of a closed mesh (1e3 m from the origin)",
    source: "Woop, Benthin and Wald 2013",
    measure: || crossings(|[a, b, _], s| a.lerp(b, s)),
    picture: Picture {
        shows: "a globe from inside, rays at its edges",
        wrong: "slips through, or hits two",
        draw: |size| {
            let edges = ball(CENTER).iter().flat_map(edges).collect::<Vec<_>>();
            from_inside(size, 0.3, |eye, place| eye.ray_at_edge(&edges, place))
        },
    },
};

pub const SHARED_CORNERS: Case = Case {
    name: "shared-corners",
    hard: "rays aimed at its corners, where several triangles meet",
    source: "the same: from inside a closed mesh is crossed an odd number of times",
    measure: || crossings(|[a, _, _], _| a),
    picture: Picture {
        shows: "a globe from inside, rays at its corners",
        wrong: "slips through, or hits two",
        draw: |size| {
            let corners = ball(CENTER)
                .iter()
                .flat_map(|t| t.corners)
                .collect::<Vec<_>>();
            from_inside(size, 0.9, |eye, place| eye.ray_at_corner(&corners, place))
        },
    },
};

const RAYS: usize = 2000;

/// The middle of the mesh.
const CENTER: DVec3 = DVec3::splat(1e3);

/// A ball of triangles around `center`: an octahedron whose sides are cut into four, three times.
pub fn ball(center: DVec3) -> Vec<Triangle> {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let mut all: Vec<[DVec3; 3]> = Vec::new();
    for (s, t, u) in (0..8).map(|i| (i & 1, i >> 1 & 1, i >> 2)) {
        let sign = |bit: i32| 1.0 - 2.0 * f64::from(bit);
        all.push([x * sign(s), y * sign(t), z * sign(u)]);
    }
    for _ in 0..3 {
        all = all
            .into_iter()
            .flat_map(|[a, b, c]| {
                // The sum of two is the same either way, so neighbours agree about the middle.
                let [ab, bc, ca] = [a + b, b + c, c + a].map(DVec3::normalize);
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let place = |corners: [DVec3; 3]| Triangle {
        corners: corners.map(|p| p + center),
    };
    all.into_iter().map(place).collect()
}

/// Rays from inside to places on the edges that `aim` chooses: from inside, an odd number of triangles is crossed.
fn crossings(aim: fn([DVec3; 3], f64) -> DVec3) -> Vec<Outcome> {
    let mesh = ball(CENTER);
    let mut chance = Chance(3);
    let rays: Vec<Ray> = (0..RAYS)
        .map(|i| {
            let target = aim(mesh[i % mesh.len()].corners, chance.next());
            let origin = CENTER + 0.3 * chance.point();
            Ray::new(origin, (target - origin).normalize())
        })
        .collect();
    let outcome = |(arithmetic, ours, choice): (String, bool, Arithmetic)| {
        let shapes = all_under(choice, &mesh);
        let wrong = rays
            .iter()
            .filter(|ray| crossed(&shapes, ray).len().is_multiple_of(2));
        Outcome {
            arithmetic,
            ours,
            found: percent(wrong.count(), RAYS),
            allowed: 0.0,
            unit: "% of rays cross an even number of times",
        }
    };
    tests().map(outcome).to_vec()
}

/// The tests that are compared.
fn tests() -> [(String, bool, Arithmetic); 3] {
    TriangleTest::ALL.map(|triangle| {
        let choice = Arithmetic {
            triangle,
            ..Arithmetic::default()
        };
        if choice == Arithmetic::default() {
            return ("ours".to_owned(), true, choice);
        }
        (format!("--triangle {}", triangle.name()), false, choice)
    })
}

fn all_under(choice: Arithmetic, mesh: &[Triangle]) -> Vec<Shape> {
    mesh.iter()
        .map(|t| under(choice, Shape::Triangle(*t)))
        .collect()
}

/// The numbers of the triangles that a ray crosses.
fn crossed(shapes: &[Shape], ray: &Ray) -> Vec<usize> {
    let shear = Shear::new(ray);
    let hit = |shape: &Shape| {
        let found = shape.intersect(ray, &shear, Interval::FORWARD);
        matches!(found, Intersection::Hit { .. })
    };
    (0..shapes.len()).filter(|i| hit(&shapes[*i])).collect()
}

fn edges(triangle: &Triangle) -> [[DVec3; 2]; 3] {
    let [a, b, c] = triangle.corners;
    [[a, b], [b, c], [c, a]]
}

/// The ball's wall from inside, each triangle in a grey of its own. A ray is aimed where `aim` says, else at its pixel's middle. It
/// must cross the wall once, since the ball is convex.
fn from_inside(
    size: (u32, u32),
    reach: f64,
    aim: impl Fn(&Eye, Place) -> Option<Ray> + Sync,
) -> Vec<Panel> {
    let mesh = ball(CENTER);
    let to = DVec3::new(0.5, 0.4, -1.0);
    let eye = Eye::new(CENTER + DVec3::new(0.05, -0.1, 0.2), CENTER + to, reach);
    let grey = |t: &Triangle| {
        t.normal()
            .map_or(0.0, |n| 0.65 + 0.12 * libm::sin(40.0 * n.x + 17.0 * n.y))
    };
    let of = |(name, ours, choice): (String, bool, Arithmetic)| {
        let shapes = all_under(choice, &mesh);
        panel((&name, ours), size, |place| {
            let ray = aim(&eye, place).unwrap_or_else(|| eye.ray(place));
            let hit = crossed(&shapes, &ray);
            Seen {
                brightness: hit.first().map_or(0.0, |first| grey(&mesh[*first])),
                wrong: hit.len() != 1,
            }
        })
    };
    tests().map(of).to_vec()
}
