//! Equations of the surface that a ray hits, number by number: `sphere.b`, `quadric.disc`, `torus.c4`.
//!
//! A sphere's is the one of the lectures. The others are those of this tracer's tests, in the shape's own frame, where the ray's origin
//! is moved to t_c: see [`Quadric::arithmetic`](crate::geometry::Quadric::arithmetic) and
//! [`Torus::arithmetic`](crate::geometry::Torus::arithmetic).

use serde_json::Value;

use crate::geometry::pieces::Pieces;
use crate::geometry::{Body, QuadricSteps, Shape, Sphere};
use crate::math::Ray;
use crate::scene::printable::excerpt;
use crate::trace::{Outcome, View};

/// Words before the point of such a field.
pub const EQUATIONS: [&str; 4] = ["sphere", "quadric", "torus", "quartic"];

/// A number of the equation of the surface that a ray hits. An error if it is another surface, or the number is none of it.
pub fn number(view: View, id: u32, surface: &str, name: &str) -> Result<Value, String> {
    let node = view.trace.tree.node(id);
    let ray = Ray::new(node.ray.origin, node.ray.direction);
    let hit = match node.outcome {
        Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => Some(hit),
        _ => None,
    };
    let shape = hit.map(|hit| view.world.scene.shapes[hit.primitive as usize].plain());
    let numbers = match (surface, shape) {
        ("sphere", Some(Shape::Sphere(sphere))) => of_sphere(sphere, &ray),
        (_, Some(shape)) => of_body(surface, shape, &ray)?,
        (_, None) => return Err(not_one(surface)),
    };
    let found = numbers.iter().find(|(own, _)| *own == name);
    found.map(|(_, value)| value.clone()).ok_or_else(|| {
        let names: Vec<&str> = numbers.iter().map(|(own, _)| *own).collect();
        let name = excerpt(name);
        let names = names.join(", ");
        format!("`{surface}.{name}` is no field; there are {surface}.{names}")
    })
}

fn not_one(surface: &str) -> String {
    let what = match surface {
        "sphere" => "a sphere",
        "quadric" => "a quadric: a cylinder, cone, paraboloid, hyperboloid or `quadric`",
        "torus" => "a torus",
        _ => "a `quartic`",
    };
    format!("`{surface}` is a field of rays that hit {what}")
}

/// Numbers by name.
type Numbers = Vec<(&'static str, Value)>;

/// The quadratic a t^2 + b t + c = 0 of |o + t d - C|^2 = r^2, as the lectures have it.
/// t0 and t1 are null if the line misses.
fn of_sphere(sphere: &Sphere, ray: &Ray) -> Numbers {
    let f = ray.origin - sphere.center;
    let a = ray.direction.length_squared();
    let b = 2.0 * f.dot(ray.direction);
    let c = f.length_squared() - sphere.radius * sphere.radius;
    let span = sphere.span(ray);
    let t = |i: usize| span.map_or(Value::Null, |span| span[i].into());
    vec![
        ("a", a.into()),
        ("b", b.into()),
        ("c", c.into()),
        ("disc", (b * b - 4.0 * a * c).into()),
        ("t0", t(0)),
        ("t1", t(1)),
    ]
}

/// The equation of a body in its own frame.
fn of_body(surface: &str, shape: &Shape, ray: &Ray) -> Result<Numbers, String> {
    match (surface, shape) {
        (_, Shape::Transformed(moved)) => {
            of_body(surface, &moved.shape, &moved.transform.ray_to_object(ray))
        }
        (_, Shape::Body(body)) => match (surface, &**body) {
            ("quadric", Body::Quadric(quadric)) => Ok(of_quadric(&quadric.arithmetic(ray))),
            ("quadric", Body::BoxedQuadric(quadric)) => Ok(of_quadric(&quadric.arithmetic(ray))),
            ("torus", Body::Torus(torus)) => {
                let steps = torus.arithmetic(ray);
                Ok(of_quartic(steps.coefficients, steps.closest, &steps.pieces))
            }
            ("quartic", Body::Quartic(quartic)) => {
                let steps = quartic.arithmetic(ray);
                Ok(of_quartic(steps.coefficients, steps.middle, &steps.pieces))
            }
            _ => Err(not_one(surface)),
        },
        _ => Err(not_one(surface)),
    }
}

/// A s^2 + 2 B s + C = 0, s = t - t_c; t0 and t1 are its roots as t on the ray, null if there are none.
fn of_quadric(steps: &QuadricSteps) -> Numbers {
    let [x, y] = steps.roots;
    let root = |t: f64| match steps.discriminant {
        d if d > 0.0 => t.into(),
        _ => Value::Null,
    };
    vec![
        ("a", steps.a.into()),
        ("b", steps.b.into()),
        ("c", steps.c.into()),
        ("disc", steps.discriminant.into()),
        ("q", steps.q.into()),
        ("t_c", steps.t_c.into()),
        ("t0", root(x.min(y))),
        ("t1", root(x.max(y))),
    ]
}

/// c4 s^4 + c3 s^3 + c2 s^2 + c1 s + c0 = 0, s = t - t_c; `crossings` are the roots in the surface's reach, as t on the ray.
fn of_quartic([c0, c1, c2, c3, c4]: [f64; 5], t_c: f64, pieces: &Pieces) -> Numbers {
    let found = pieces.iter().filter_map(|piece| piece.crossing);
    let crossings: Vec<f64> = found.map(|c| t_c + c.polished.root).collect();
    vec![
        ("c0", c0.into()),
        ("c1", c1.into()),
        ("c2", c2.into()),
        ("c3", c3.into()),
        ("c4", c4.into()),
        ("t_c", t_c.into()),
        ("crossings", crossings.into()),
    ]
}
