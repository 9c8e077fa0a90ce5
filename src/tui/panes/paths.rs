//! Ray paths pane: the rays in the scene, seen from one side. Objects are outlines, rays have the colours of their kinds.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Color;
use ratatui::style::Stylize as _;
use ratatui::symbols::Marker;
use ratatui::text::{Line, Span};
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::{Canvas, Context, Line as Stroke, Points};

use super::text::write;
use super::theme;
use crate::debug::cell::{self, NodeCell};
use crate::debug::extent::{MAX_DRAWN, with_ray};
use crate::debug::fan::Fan;
use crate::debug::outline::{of_one, turns};
use crate::debug::projection::Viewport;
use crate::debug::{Axis, ObjectOutline, Session};
use crate::math::DVec3;
use crate::probe::{Event, RayKind};
use crate::trace::explain::UNKNOWN;
use crate::trace::{Node, Outcome};

const OUTLINE: Color = Color::Rgb(120, 120, 120);
/// The cell of the node that is visited, its split plane, and the shape that is tested.
const CELL: Color = Color::Rgb(40, 165, 85);
const SPLIT: Color = Color::Rgb(30, 160, 170);
const TESTED: Color = Color::Rgb(190, 80, 200);

/// Dots of a dash, and dashes at most.
const DASH: f64 = 4.0;
const MOST_DASHES: f64 = 1000.0;

/// Its title: from where, and how space lies.
pub fn title(axis: Axis) -> Line<'static> {
    let text = match axis {
        Axis::Top => " scene from the top: x →, z ↓ ",
        Axis::Front => " scene from the front: x →, y ↑ ",
        Axis::Side => " scene from the side: z ←, y ↑ ",
    };
    Line::raw(text)
}

/// The rays and outlines with their projection.
struct Drawing<'a> {
    session: &'a Session,
    outlines: &'a [ObjectOutline],
    axis: Axis,
    fan: Option<Fan>,
    viewport: Viewport,
}

/// Draws the scene and the rays of the tree.
pub fn draw(
    session: &Session,
    outlines: &[ObjectOutline],
    (axis, fan): (Axis, Option<Fan>),
    area: Rect,
    buffer: &mut Buffer,
) {
    // Braille: two dots a cell to the right, four down.
    let (columns, rows) = (2.0 * f64::from(area.width), 4.0 * f64::from(area.height));
    let current = session.node().map(|id| session.tree().node(id));
    let extent = current.map_or(session.extent, |node| with_ray(session.extent, node));
    let Some(viewport) = Viewport::new(extent, axis, columns, rows) else {
        return;
    };
    let drawing = Drawing {
        session,
        outlines,
        axis,
        fan,
        viewport,
    };
    Canvas::default()
        .x_bounds(viewport.x)
        .y_bounds(viewport.y)
        .marker(Marker::Braille)
        .paint(|context| drawing.paint(context))
        .render(area, buffer);
    legend(session, area, buffer);
}

impl Drawing<'_> {
    fn paint(&self, context: &mut Context) {
        for outline in self.outlines {
            self.outline(context, outline, OUTLINE);
        }
        self.traversal(context);
        // The eye rays of a row end where they hit: before a question none is drawn.
        let fan = self.fan.filter(|_| self.session.trace.is_whole());
        let fan = fan.map_or_else(Vec::new, |fan| fan.rays(self.session));
        for [from, to] in fan {
            self.line(context, from, to, theme::kind_color(RayKind::Incident));
        }
        let tree = self.session.tree();
        let current = self.session.node();
        let shown = tree.nodes.iter().take(MAX_DRAWN);
        for node in shown {
            let [a, b] = self.viewport.ends(node);
            if self.is_asked(node) {
                self.dashed(context, node);
            } else {
                self.line(context, a, b, theme::kind_color(node.ray.kind));
            }
        }
        if let Some(id) = current
            && !self.is_asked(tree.node(id))
        {
            self.thick(context, tree.node(id));
        }
        for node in tree.nodes.iter().take(MAX_DRAWN) {
            if matches!(node.outcome, Some(Outcome::Hit(_))) {
                let [_, hit] = self.viewport.ends(node);
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
            let style = theme::kind_style(node.ray.kind);
            if self.is_asked(node) {
                let start = node.ray.origin;
                self.print(context, start, Span::styled(UNKNOWN, style));
                return;
            }
            let [_, end] = self.viewport.ends(node);
            self.print(context, end, Span::styled("●", style));
        }
    }

    /// True if it is asked where a ray ends.
    fn is_asked(&self, node: &Node) -> bool {
        node.outcome.is_none() && !self.session.trace.is_whole()
    }

    /// A ray of which it is not known where it ends: dashes, as far as it can go.
    fn dashed(&self, context: &mut Context, node: &Node) {
        let [a, b] = self.viewport.ends(node);
        let step = (b - a).normalize_or_zero() * (DASH * self.viewport.dot);
        let count = ((b - a).length() / (DASH * self.viewport.dot)).min(MOST_DASHES) as u32;
        for dash in (0..=count).step_by(2) {
            let start = a + step * f64::from(dash);
            let color = theme::kind_color(node.ray.kind);
            self.line(context, start, start + step, color);
        }
    }

    /// The cell of the current step's node, its split plane, and the shape that is tested there.
    fn traversal(&self, context: &mut Context) {
        let event = self.session.cursor().position();
        // A plane that is seen from the front covers the cell: the cell lies over it.
        for [a, b] in cell::split(self.session, event) {
            self.line(context, a, b, SPLIT);
        }
        if let Some(cell) = NodeCell::of_event(self.session, event) {
            self.outline(context, &cell.outline(), CELL);
        }
        let Some(Event::Test { primitive, .. }) = self.session.tree().events.get(event) else {
            return;
        };
        let shape = self.session.world.scene.shapes.get(*primitive as usize);
        if let Some(outline) = shape.and_then(of_one) {
            self.outline(context, &outline, TESTED);
        }
    }

    fn line(&self, context: &mut Context, a: DVec3, b: DVec3, color: Color) {
        stroke(context, self.axis.project(a), self.axis.project(b), color);
    }

    /// The current ray: three dots wide.
    fn thick(&self, context: &mut Context, node: &Node) {
        let [a, b] = self.viewport.ends(node).map(|p| self.axis.project(p));
        let steep = (b[1] - a[1]).abs() > (b[0] - a[0]).abs();
        for by in [-self.viewport.dot, 0.0, self.viewport.dot] {
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
        let [x, y] = self.axis.project(at);
        if self.viewport.contains([x, y]) {
            context.print(x, y, what);
        }
    }

    fn outline(&self, context: &mut Context, outline: &ObjectOutline, color: Color) {
        match outline {
            ObjectOutline::Edges(edges) => {
                for [a, b] in edges {
                    self.line(context, *a, *b, color);
                }
            }
            ObjectOutline::Points(points) => {
                dots(context, points.iter().map(|p| self.axis.project(*p)), color);
            }
            ObjectOutline::Sphere(center, radius) => {
                let [x, y] = self.axis.project(*center);
                let points: Vec<_> = turns()
                    .map(|[c, s]| [x + radius * c, y + radius * s])
                    .collect();
                let next = points.iter().cycle().skip(1);
                for (a, b) in points.iter().zip(next) {
                    stroke(context, *a, *b, color);
                }
            }
            ObjectOutline::Plane(n, d) => self.plane(context, *n, *d, color),
        }
    }

    /// A plane that is seen from its edge is a line.
    fn plane(&self, context: &mut Context, n: DVec3, d: f64, color: Color) {
        let [a, b] = self.axis.project(n);
        if a.hypot(b) >= 1.0 - 1e-9 {
            let [start, end] = self.viewport.line([a, b], d);
            stroke(context, start, end, color);
        }
    }
}

/// A straight line, if its ends can be drawn at all.
fn stroke(context: &mut Context, a: [f64; 2], b: [f64; 2], color: Color) {
    if [a, b].concat().iter().all(|v| v.is_finite()) {
        context.draw(&Stroke::new(a[0], a[1], b[0], b[1], color));
    }
}

fn dots(context: &mut Context, points: impl Iterator<Item = [f64; 2]>, color: Color) {
    let coords: Vec<_> = points
        .filter(|p| p.iter().all(|v| v.is_finite()))
        .map(|[x, y]| (x, y))
        .collect();
    context.draw(&Points {
        coords: &coords,
        color,
    });
}

/// What the marks mean, in the frame below.
fn legend(session: &Session, area: Rect, buffer: &mut Buffer) {
    let mut line = Line::default();
    for kind in RayKind::ALL {
        line.push_span(Span::styled(
            format!(" {}", kind.letter()),
            theme::kind_style(kind),
        ));
    }
    line.push_span(" E eye * light ");
    let here = session.cursor().position();
    let event = session.tree().events.get(here);
    let is_split = match event {
        Some(Event::Visit(visit)) if !visit.is_skipped() => {
            session.world.accel.plane(visit.node).is_some()
        }
        _ => false,
    };
    let highlighted = [
        ("cell ", CELL, NodeCell::of_event(session, here).is_some()),
        ("split ", SPLIT, is_split),
        ("tested ", TESTED, matches!(event, Some(Event::Test { .. }))),
    ];
    for (name, color, _) in highlighted.into_iter().filter(|(.., is_shown)| *is_shown) {
        line.push_span(Span::raw(name).fg(color));
    }
    if usize::from(area.width) > line.width() {
        write(buffer, area.x + 1, area.bottom(), &line, area.width - 1);
    }
}
