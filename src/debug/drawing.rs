//! A drawing of a document's ray paths for its page: the scene's outlines and the rays, seen along each axis.

use std::collections::HashMap;
use std::fmt::{self, Write as _};

use super::extent::{MAX_DRAWN, VISIBLE_SHARE, fitted};
use super::outline::outlines;
use super::projection::Viewport;
use super::{Axis, ObjectOutline};
use crate::geometry::Aabb;
use crate::math::DVec3;
use crate::probe::RayKind;
use crate::scene::Scene;
use crate::trace::Document;
use crate::trace::document::{RayNode, SampleTree};

/// Size of a view, in the units of its picture: fine enough for whole numbers.
const SIZE: [f64; 2] = [1440.0, 1080.0];

/// Where the drawing is seen from, and how space lies.
const VIEWS: [(Axis, &str); 3] = [
    (Axis::Top, "from above: x →, z ↓"),
    (Axis::Front, "from the front: x →, y ↑"),
    (Axis::Side, "from the side: z ←, y ↑"),
];

/// What is further away from the view than so many of its sizes is not drawn.
const FAR: f64 = 1000.0;

/// Three views as HTML with SVG in it; empty if no ray hits anything. Colours come from the page: classes are the letters of rays.
pub fn drawing(scene: &Scene, document: &Document) -> String {
    let rays = document.samples.iter().flat_map(SampleTree::rays);
    let mut rays: Vec<&RayNode> = rays.map(|ray| ray.node).collect();
    let mut out = String::new();
    if !rays.iter().any(|ray| ray.hit.is_some()) {
        return out;
    }
    let count = rays.len();
    rays.truncate(MAX_DRAWN);
    let (extent, outlines) = (extent(scene, document), outlines(scene));
    for (axis, caption) in VIEWS {
        let Some(viewport) = Viewport::new(extent, axis, SIZE[0], SIZE[1]) else {
            continue;
        };
        // Writing to a string cannot fail.
        let _ = AxisView { axis, viewport }.write(&mut out, &outlines, &rays, caption);
    }
    let more = if count > MAX_DRAWN {
        format!("<p class=note>The first {MAX_DRAWN} of {count} rays are drawn.\n")
    } else {
        String::new()
    };
    format!("<div class=d>\n{out}</div>\n{more}")
}

/// A box around the rays that matter to the pixel, and the objects that they hit.
fn extent(scene: &Scene, document: &Document) -> Aabb {
    let numbers: HashMap<&str, u32> = scene
        .objects
        .iter()
        .zip(0..)
        .map(|(object, number)| (object.name.as_str(), number))
        .collect();
    let (mut points, mut met) = (Aabb::EMPTY, Vec::new());
    for sample in &document.samples {
        for ray in sample.rays().take(MAX_DRAWN) {
            let share = document.fraction(sample, ray.contribution);
            if ray.node.kind == RayKind::Light || ray.level > 0 && share < VISIBLE_SHARE {
                continue;
            }
            let origin = DVec3::from_array(ray.node.origin);
            points = points.union(Aabb::around([origin]));
            if let Some(hit) = &ray.node.hit {
                points = points.union(Aabb::around([DVec3::from_array(hit.point)]));
                met.extend(numbers.get(hit.object.as_str()));
            }
        }
    }
    fitted(scene, points, met)
}

/// A view along an axis.
struct AxisView {
    axis: Axis,
    viewport: Viewport,
}

impl AxisView {
    fn write(
        &self,
        out: &mut String,
        outlines: &[ObjectOutline],
        rays: &[&RayNode],
        caption: &str,
    ) -> fmt::Result {
        let [width, height] = SIZE;
        writeln!(
            out,
            "<figure><svg viewBox=\"0 0 {width} {height}\" role=img aria-label=\"ray paths {caption}\">"
        )?;
        let mut edges = String::new();
        for outline in outlines {
            self.outline(out, &mut edges, outline)?;
        }
        writeln!(out, "<path d=\"{edges}\"/>")?;
        // The rays that bring the light to the eye lie above those that ask for it.
        for kind in [
            RayKind::Light,
            RayKind::Transmitted,
            RayKind::Reflected,
            RayKind::Incident,
        ] {
            let mut lines = String::new();
            for ray in rays.iter().filter(|ray| ray.kind == kind) {
                let [from, to] = self.ends(ray);
                self.line(&mut lines, from, to)?;
            }
            if !lines.is_empty() {
                writeln!(out, "<path class={} d=\"{lines}\"/>", kind.letter())?;
            }
        }
        writeln!(out, "</svg><figcaption>{caption}</figcaption></figure>")
    }

    /// Where a ray starts, and where it ends or has left the drawing.
    fn ends(&self, ray: &RayNode) -> [DVec3; 2] {
        let origin = DVec3::from_array(ray.origin);
        let span = 2.0 * self.viewport.span();
        let t = match &ray.hit {
            Some(hit) => hit.t,
            None => ray.t_max.unwrap_or(span).min(span),
        };
        [origin, origin + t * DVec3::from_array(ray.direction)]
    }

    /// Adds an outline: a circle to the picture, all else to the path of the edges.
    fn outline(
        &self,
        out: &mut String,
        edges: &mut String,
        outline: &ObjectOutline,
    ) -> fmt::Result {
        match outline {
            ObjectOutline::Edges(pairs) => {
                for [a, b] in pairs {
                    self.line(edges, *a, *b)?;
                }
            }
            ObjectOutline::Points(points) => {
                for point in points {
                    self.dot(edges, *point)?;
                }
            }
            ObjectOutline::Sphere(center, radius) => {
                let radius = radius / self.viewport.dot;
                if let (Some([x, y]), true) = (self.place(*center), radius < FAR * SIZE[0]) {
                    writeln!(out, "<circle cx={x:.0} cy={y:.0} r={radius:.0} />")?;
                }
            }
            ObjectOutline::Plane(normal, d) => {
                // A plane that is seen from its edge is a line.
                let [a, b] = self.axis.project(*normal);
                if a.hypot(b) >= 1.0 - 1e-9 {
                    let [from, to] = self.viewport.line([a, b], *d).map(|p| self.of_plane(p));
                    segment(edges, from, to)?;
                }
            }
        }
        Ok(())
    }

    fn line(&self, path: &mut String, from: DVec3, to: DVec3) -> fmt::Result {
        segment(path, self.place(from), self.place(to))
    }

    fn dot(&self, path: &mut String, at: DVec3) -> fmt::Result {
        match self.place(at) {
            Some([x, y]) => write!(path, "M{x:.0} {y:.0}h0"),
            None => Ok(()),
        }
    }

    /// A point in the picture; `None` if it is too far away.
    fn place(&self, at: DVec3) -> Option<[f64; 2]> {
        self.of_plane(self.axis.project(at))
    }

    fn of_plane(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let Viewport {
            x: ends_x,
            y: ends_y,
            dot,
        } = self.viewport;
        let at = [(x - ends_x[0]) / dot, (ends_y[1] - y) / dot];
        let is_near = at.iter().zip(SIZE).all(|(v, size)| v.abs() < FAR * size);
        is_near.then_some(at)
    }
}

/// Adds a line to a path, unless it is beside the picture.
fn segment(path: &mut String, from: Option<[f64; 2]>, to: Option<[f64; 2]>) -> fmt::Result {
    let Some((from, to)) = from.zip(to) else {
        return Ok(());
    };
    let beside = |i: usize| from[i].max(to[i]) < 0.0 || from[i].min(to[i]) > SIZE[i];
    if beside(0) || beside(1) {
        return Ok(());
    }
    let ([x, y], [to_x, to_y]) = (from, to);
    write!(path, "M{x:.0} {y:.0}L{to_x:.0} {to_y:.0}")
}
