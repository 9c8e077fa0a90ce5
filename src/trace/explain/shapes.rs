//! The arithmetic of a ray's test against a shape: from the numbers of the shape and of the ray to each crossing.

use super::{Explanation, bodies, patches};
use crate::geometry::{
    Cuboid, Disc, Intersection, MeshSteps, Plane, Polygon, Shape, SharedMesh, Shear, Sphere,
    Triangle,
};
use crate::math::{DVec3, Interval, Ray};
use crate::scene::Leaf;
use crate::trace::format::{counted, num, vec3};

/// Adds the arithmetic of a test. A shape in a space of its own is tested there. `parts` are those of a csg.
pub fn add(explanation: Explanation, (shape, parts): (&Shape, &[Leaf]), ray: &Ray) -> Explanation {
    match shape {
        Shape::Triangle(triangle) => self::triangle(explanation, triangle, ray),
        Shape::Sphere(sphere) => self::sphere(explanation, sphere, ray),
        Shape::Plane(plane) => self::plane(explanation, plane, ray),
        Shape::Cuboid(cuboid) => self::cuboid(explanation, cuboid, ray),
        Shape::Disc(disc) => self::disc(explanation, disc, ray),
        Shape::Patch(patch) => patches::add(explanation, patch, &Shear::new(ray)),
        Shape::Body(body) => bodies::add(explanation, (body, parts), ray),
        Shape::Polygon(polygon) => self::polygon(explanation, polygon, ray),
        Shape::Mesh(mesh) => self::mesh(explanation, mesh, ray),
        Shape::Transformed(transformed) => {
            let own = transformed.transform.ray_to_object(ray);
            let explanation = explanation
                .row("o in its space", vec3(own.origin))
                .row("d in its space", vec3(own.direction));
            add(explanation, (&transformed.shape, parts), &own)
        }
        Shape::Naive(naive) => add(explanation, (&naive.shape, parts), ray),
    }
}

/// t where a ray crosses a plane N.p = d.
fn crossing(explanation: Explanation, n: DVec3, d: f64, ray: &Ray) -> Explanation {
    let (n_o, n_d) = (n.dot(ray.origin), n.dot(ray.direction));
    let t = (d - n_o) / n_d;
    explanation.row("N", vec3(n)).row(
        "t of the plane",
        format!(
            "(d - N.o) / (N.direction) = ({} - {}) / {} = {}",
            num(d),
            num(n_o),
            num(n_d),
            num(t)
        ),
    )
}

fn plane(explanation: Explanation, plane: &Plane, ray: &Ray) -> Explanation {
    let n = plane.normal();
    crossing(explanation, n, n.dot(plane.origin()), ray)
}

fn disc(explanation: Explanation, disc: &Disc, ray: &Ray) -> Explanation {
    let n = disc.frame.w;
    let t = n.dot(disc.center - ray.origin) / n.dot(ray.direction);
    let from_center = (ray.at(t) - disc.center).length();
    crossing(explanation, n, n.dot(disc.center), ray).row(
        "from the centre",
        format!(
            "{}, inside if at most {}",
            num(from_center),
            num(disc.radius)
        ),
    )
}

fn polygon(explanation: Explanation, polygon: &Polygon, ray: &Ray) -> Explanation {
    let n = polygon.normal();
    let walk = polygon.walk(&Shear::new(ray));
    let side = if walk.is_inside() {
        "odd: inside"
    } else {
        "even: outside"
    };
    let t = n.dot(polygon.center() - ray.origin) / n.dot(ray.direction);
    crossing(explanation, n, n.dot(polygon.center()), ray)
        .row("t", num(t))
        .row("corners", polygon.edges().count().to_string())
        .row(
            "walk to infinity",
            format!("crosses {} edges: {side}", walk.crossed),
        )
}

fn triangle(explanation: Explanation, triangle: &Triangle, ray: &Ray) -> Explanation {
    let [a, b, c] = triangle.corners;
    let mut explanation =
        explanation.row("a, b, c", format!("{}, {}, {}", vec3(a), vec3(b), vec3(c)));
    if let Some(n) = triangle.normal() {
        explanation = crossing(explanation, n, n.dot(a), ray);
    }
    let edges = triangle.edges(&Shear::new(ray));
    let [u, v, w] = edges.functions;
    let area = u + v + w;
    let explanation = explanation
        .row(
            "edge functions",
            format!("{}, {}, {}", num(u), num(v), num(w)),
        )
        .row(
            "",
            "twice the areas of the parts, seen along the ray; inside if all have the same sign",
        );
    if !edges.inside || area == 0.0 {
        return explanation;
    }
    let weights = [u / area, v / area, w / area].map(num);
    explanation.row(
        "weights of a, b, c",
        format!("each over their sum: {}", weights.join(", ")),
    )
}

/// The search in a mesh that is kept once, and the test of the triangle that it found.
fn mesh(explanation: Explanation, mesh: &SharedMesh, ray: &Ray) -> Explanation {
    let MeshSteps { boxes, triangles } = mesh.steps(ray, Interval::FORWARD);
    let all = mesh.triangles().len() as u64;
    let explanation = explanation
        .row("mesh", format!("{}, kept once", counted(all, "triangle")))
        .row(
            "search in it",
            format!("{boxes} boxes looked at, {triangles} of its triangles tested"),
        );
    let Intersection::Hit { part, .. } = mesh.intersect(ray, Interval::FORWARD) else {
        return explanation.row("", "the ray meets none");
    };
    let explanation = explanation.row("triangle met", format!("number {part}"));
    match mesh.triangles().get(part as usize) {
        Some(found) => triangle(explanation, found, ray),
        None => explanation,
    }
}

fn sphere(explanation: Explanation, sphere: &Sphere, ray: &Ray) -> Explanation {
    let f = ray.origin - sphere.center;
    let (a, b) = (ray.direction.length_squared(), f.dot(ray.direction));
    let c = f.length_squared() - sphere.radius * sphere.radius;
    let l = f - (b / a) * ray.direction;
    let discriminant = a * (sphere.radius * sphere.radius - l.length_squared());
    let explanation = explanation
        .row("f = o - centre", vec3(f))
        .row("a = d.d", num(a))
        .row("b = f.d", num(b))
        .row("c = f.f - r^2", num(c))
        .row(
            "b^2 - a c",
            format!("{}, computed as a (r^2 - l.l): l = {} is the point of the line that is nearest to the centre, from there", num(discriminant), vec3(l)),
        );
    match sphere.span(ray) {
        Some([near, far]) => explanation.row(
            "t = (-b -+ root) / a",
            format!("{} and {}", num(near), num(far)),
        ),
        None => explanation.row("", "below 0: the line misses the sphere"),
    }
}

fn cuboid(explanation: Explanation, cuboid: &Cuboid, ray: &Ray) -> Explanation {
    let mut explanation = explanation;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        let (min, max) = (cuboid.bounds.min[axis], cuboid.bounds.max[axis]);
        let told = if d == 0.0 {
            let place = if (min..=max).contains(&o) {
                "inside"
            } else {
                "outside"
            };
            format!(
                "{} to {}: the ray runs along it, {place}",
                num(min),
                num(max)
            )
        } else {
            let (t0, t1) = ((min - o) / d, (max - o) / d);
            format!(
                "{} to {}: inside for t from {} to {}",
                num(min),
                num(max),
                num(t0.min(t1)),
                num(t0.max(t1))
            )
        };
        explanation = explanation.row(name, told);
    }
    match cuboid.span(ray) {
        Some([enter, exit]) => explanation.row(
            "in the box",
            format!(
                "from the last entry, t = {}, to the first exit, t = {}",
                num(enter),
                num(exit)
            ),
        ),
        None => explanation.row(
            "in the box",
            "never: it leaves one pair of planes before it enters another",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::AccelKind;
    use crate::probe::{Event, Verdict};
    use crate::scene::load;
    use crate::trace::explain::explain;
    use crate::trace::{View, trace_pixel};
    use crate::world::World;

    /// Where a shape is hit, the t of the hit is among the numbers of its arithmetic, for every kind of shape.
    #[test]
    fn the_arithmetic_leads_to_t() {
        let mut kinds = std::collections::BTreeSet::new();
        for (name, at) in [
            ("whitted", (32, 24)),
            ("glass-block", (32, 24)),
            ("room", (32, 40)),
            ("lamps", (30, 20)),
            ("teapot", (30, 26)),
            ("quadrics", (8, 21)),
            ("torus", (42, 26)),
            ("csg", (17, 30)),
            ("polygons", (30, 30)),
            ("teapot-patches", (32, 24)),
        ] {
            let world = World::new(load(name).expect(name), AccelKind::List);
            let settings = world.scene.settings.with(|s| {
                (s.image.width, s.image.height) = (64, 48);
                s.pixel.samples = 1;
                s.light.samples = 1;
            });
            let trace = trace_pixel(&world, &settings, at, true);
            let view = View {
                world: &world,
                settings: &settings,
                trace: &trace,
            };
            for (index, event) in trace.tree.events.iter().enumerate() {
                let Event::Test {
                    primitive,
                    verdict: Verdict::Hit,
                    t,
                } = event
                else {
                    continue;
                };
                let shape = &world.scene.shapes[*primitive as usize];
                let told = explain(view, index);
                let rows: Vec<&str> = told
                    .rows
                    .iter()
                    .filter(|row| row.name != "t")
                    .map(|row| row.text.as_str())
                    .collect();
                let number = num(*t);
                let words = |text: &&str| text.split([' ', ',']).any(|word| word == number);
                assert!(rows.iter().any(words), "{number} in {rows:#?}");
                kinds.insert(shape.kind());
            }
        }
        assert!(kinds.len() >= 9, "{kinds:?}");
    }
}
