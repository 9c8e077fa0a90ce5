//! The rays in the scene, seen from one side: objects as outlines, rays in the colours of their kinds.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Color;
use ratatui::style::Stylize as _;
use ratatui::symbols::Marker;
use ratatui::text::{Line, Span};
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::{Canvas, Context, Line as Stroke, Points};

use super::outline::{Outline, turns};
use super::session::{MAX_DRAWN, Session};
use super::theme;
use crate::geometry::Aabb;
use crate::math::{DVec3, Ray};
use crate::probe::RayKind;
use crate::trace::{Node, Outcome};

const OUTLINE: Color = Color::Rgb(120, 120, 120);

/// From where the scene is seen, without perspective.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// From above: x to the right, z downwards.
    Top,
    /// From the front: x to the right, y upwards.
    Front,
    /// From the right side: z to the left, y upwards.
    Side,
}

impl Axis {
    /// The next view.
    #[must_use]
    pub fn next(self) -> Self {
        match self {
            Self::Top => Self::Front,
            Self::Front => Self::Side,
            Self::Side => Self::Top,
        }
    }

    /// Where a point or a vector lies in the drawing: to the right, upwards.
    pub fn flat(self, p: DVec3) -> [f64; 2] {
        match self {
            Self::Top => [p.x, -p.z],
            Self::Front => [p.x, p.y],
            Self::Side => [-p.z, p.y],
        }
    }
}

/// Its title: from where, and how space lies.
pub fn title(axis: Axis) -> Line<'static> {
    let text = match axis {
        Axis::Top => " scene from the top: x →, z ↓ ",
        Axis::Front => " scene from the front: x →, y ↑ ",
        Axis::Side => " scene from the side: z ←, y ↑ ",
    };
    Line::raw(text)
}

/// What the drawing shows, and how large a dot is.
struct Drawing<'a> {
    session: &'a Session,
    outlines: &'a [Outline],
    axis: Axis,
    x: [f64; 2],
    y: [f64; 2],
    dot: f64,
}

/// Draws the scene and the rays of the tree.
pub fn draw(session: &Session, outlines: &[Outline], axis: Axis, place: Rect, buffer: &mut Buffer) {
    let Some((x, y, dot)) = bounds(shown(session), axis, place) else {
        return;
    };
    let drawing = Drawing {
        session,
        outlines,
        axis,
        x,
        y,
        dot,
    };
    Canvas::default()
        .x_bounds(x)
        .y_bounds(y)
        .marker(Marker::Braille)
        .paint(|context| drawing.paint(context))
        .render(place, buffer);
    legend(place, buffer);
}

/// The extent of the tree, and the current ray whatever it brings; but not the light that an L ray goes to.
fn shown(session: &Session) -> Aabb {
    let Some(id) = session.node() else {
        return session.extent;
    };
    let node = session.tree().node(id);
    let ray = Ray::new(node.ray.origin, node.ray.direction);
    let end = match node.outcome {
        Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => ray.at(hit.t),
        _ => ray.origin,
    };
    session.extent.union(Aabb::around([ray.origin, end]))
}

/// The part of the plane that is drawn: the extent in the middle, with dots as wide as high. `None` if there is
/// nothing to be drawn or no room.
fn bounds(extent: Aabb, axis: Axis, place: Rect) -> Option<([f64; 2], [f64; 2], f64)> {
    let corners = extent.corners().map(|corner| axis.flat(corner));
    let range = |i: usize| {
        let values = corners.iter().map(|c| c[i]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
        (f64::midpoint(low, high), high - low)
    };
    let ((x, width), (y, height)) = (range(0), range(1));
    // Braille: two dots a cell to the right, four down.
    let (columns, rows) = (2.0 * f64::from(place.width), 4.0 * f64::from(place.height));
    let dot = (width / columns).max(height / rows);
    let (half_x, half_y) = (dot * columns / 2.0, dot * rows / 2.0);
    let all = [x, y, half_x, half_y, dot];
    (all.iter().all(|v| v.is_finite()) && dot > 0.0).then_some((
        [x - half_x, x + half_x],
        [y - half_y, y + half_y],
        dot,
    ))
}

impl Drawing<'_> {
    fn paint(&self, context: &mut Context) {
        for outline in self.outlines {
            self.outline(context, outline);
        }
        let tree = self.session.tree();
        let current = self.session.node();
        let shown = tree.nodes.iter().take(MAX_DRAWN);
        for node in shown {
            let [a, b] = self.ends(node);
            self.line(context, a, b, theme::kind_color(node.ray.kind));
        }
        if let Some(id) = current {
            self.thick(context, tree.node(id));
        }
        for node in tree.nodes.iter().take(MAX_DRAWN) {
            if matches!(node.outcome, Some(Outcome::Hit(_))) {
                let [_, hit] = self.ends(node);
                self.print(
                    context,
                    hit,
                    Span::styled("•", theme::kind_style(node.ray.kind)),
                );
            }
        }
        for light in &self.session.world.scene.lights {
            if let Some(position) = light.kind.position() {
                let style = theme::kind_style(RayKind::Light);
                self.print(context, position, Span::styled("*", style));
            }
        }
        let eye = self.session.world.scene.camera.eye;
        self.print(context, eye, Span::raw("E").bold());
        if let Some(id) = current {
            let node = tree.node(id);
            let [_, end] = self.ends(node);
            let style = theme::kind_style(node.ray.kind);
            self.print(context, end, Span::styled("●", style));
        }
    }

    /// Where a ray starts and where it ends, or leaves the drawing.
    fn ends(&self, node: &Node) -> [DVec3; 2] {
        let ray = Ray::new(node.ray.origin, node.ray.direction);
        let far = 2.0 * ((self.x[1] - self.x[0]) + (self.y[1] - self.y[0]));
        let t = match node.outcome {
            Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => hit.t,
            _ => node.ray.t_max.min(far),
        };
        [ray.origin, ray.at(t)]
    }

    fn line(&self, context: &mut Context, a: DVec3, b: DVec3, color: Color) {
        stroke(context, self.axis.flat(a), self.axis.flat(b), color);
    }

    /// The current ray: three dots wide.
    fn thick(&self, context: &mut Context, node: &Node) {
        let [a, b] = self.ends(node).map(|p| self.axis.flat(p));
        let steep = (b[1] - a[1]).abs() > (b[0] - a[0]).abs();
        for by in [-self.dot, 0.0, self.dot] {
            let aside = |p: [f64; 2]| {
                if steep {
                    [p[0] + by, p[1]]
                } else {
                    [p[0], p[1] + by]
                }
            };
            stroke(
                context,
                aside(a),
                aside(b),
                theme::kind_color(node.ray.kind),
            );
        }
    }

    fn print(&self, context: &mut Context, at: DVec3, what: Span<'static>) {
        let [x, y] = self.axis.flat(at);
        let inside = |v: f64, [low, high]: [f64; 2]| low <= v && v <= high;
        if inside(x, self.x) && inside(y, self.y) {
            context.print(x, y, what);
        }
    }

    fn outline(&self, context: &mut Context, outline: &Outline) {
        match outline {
            Outline::Edges(edges) => {
                for [a, b] in edges {
                    self.line(context, *a, *b, OUTLINE);
                }
            }
            Outline::Points(points) => {
                dots(context, points.iter().map(|p| self.axis.flat(*p)));
            }
            Outline::Sphere(center, radius) => {
                let [x, y] = self.axis.flat(*center);
                let points: Vec<_> = turns()
                    .map(|[c, s]| [x + radius * c, y + radius * s])
                    .collect();
                let next = points.iter().cycle().skip(1);
                for (a, b) in points.iter().zip(next) {
                    stroke(context, *a, *b, OUTLINE);
                }
            }
            Outline::Plane(n, d) => self.plane(context, *n, *d),
        }
    }

    /// A plane that is seen from its edge is the line a x + b y = d.
    fn plane(&self, context: &mut Context, n: DVec3, d: f64) {
        let [a, b] = self.axis.flat(n);
        let length = a.hypot(b);
        if length < 1.0 - 1e-9 {
            return;
        }
        let middle = [
            f64::midpoint(self.x[0], self.x[1]),
            f64::midpoint(self.y[0], self.y[1]),
        ];
        let off = a * middle[0] + b * middle[1] - d;
        let foot = [middle[0] - a * off, middle[1] - b * off];
        let far = (self.x[1] - self.x[0]) + (self.y[1] - self.y[0]);
        let end = |by: f64| [foot[0] - b * by, foot[1] + a * by];
        stroke(context, end(-far), end(far), OUTLINE);
    }
}

/// A straight line, if its ends can be drawn at all.
fn stroke(context: &mut Context, a: [f64; 2], b: [f64; 2], color: Color) {
    if [a, b].concat().iter().all(|v| v.is_finite()) {
        context.draw(&Stroke::new(a[0], a[1], b[0], b[1], color));
    }
}

fn dots(context: &mut Context, points: impl Iterator<Item = [f64; 2]>) {
    let coords: Vec<_> = points
        .filter(|p| p.iter().all(|v| v.is_finite()))
        .map(|[x, y]| (x, y))
        .collect();
    context.draw(&Points {
        coords: &coords,
        color: OUTLINE,
    });
}

/// What the marks mean, in the frame below.
fn legend(place: Rect, buffer: &mut Buffer) {
    let mut line = Line::default();
    for kind in RayKind::ALL {
        line.push_span(Span::styled(
            format!(" {}", kind.letter()),
            theme::kind_style(kind),
        ));
    }
    line.push_span(" E eye * light ");
    if usize::from(place.width) > line.width() {
        super::draw::write(buffer, place.x + 1, place.bottom(), &line, place.width - 1);
    }
}
