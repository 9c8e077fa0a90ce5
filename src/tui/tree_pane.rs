//! The ray tree, a row a ray. Only the rows on the screen are made, however large the tree is.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};

use super::draw::write;
use super::rows::{Row, RowKind, Rows};
use super::session::Session;
use super::theme;
use crate::probe::{Event, RayKind};
use crate::trace::format::num;
use crate::trace::{Node, Outcome};
use crate::tracer::picture::ColorLevel;

/// Columns that a level of the tree takes.
const INDENT: usize = 2;

/// Columns behind the names: t, share, colour.
const COLUMNS: usize = 24;

/// The first row that is shown in a pane of `height` rows: the current one stays in the middle.
pub fn first_row(session: &Session, height: u16) -> usize {
    let height = usize::from(height);
    let last = session.rows.len().saturating_sub(height);
    session.row().saturating_sub(height / 2).min(last)
}

/// Its title.
pub fn title(session: &Session) -> Line<'static> {
    Line::raw(format!(" ray tree: {} rays ", session.tree().nodes.len()))
}

/// The rows around the current one that a pane of `height` rows shows, with their numbers.
pub fn shown(session: &Session, height: u16) -> impl Iterator<Item = (usize, Row)> {
    let first = first_row(session, height);
    let numbers = first..first + usize::from(height);
    numbers.map_while(|number| Some((number, session.rows.get(number)?)))
}

/// Draws them.
pub fn draw(session: &Session, level: ColorLevel, place: Rect, buffer: &mut Buffer) {
    let current = session.row();
    let shift = shift(session, current, place.width);
    for (y, (number, row)) in (place.y..).zip(shown(session, place.height)) {
        let at = Rect {
            y,
            height: 1,
            ..place
        };
        draw_row(session, row, number == current, shift, level, at, buffer);
    }
}

/// Levels that are left out at the left side, so that a deep current row has room for its name.
fn shift(session: &Session, current: usize, width: u16) -> usize {
    let depth = session
        .rows
        .get(current)
        .map_or(0, |row| Rows::depth(session.tree(), row));
    let room = usize::from(width).saturating_sub(COLUMNS + 20) / INDENT;
    (depth as usize).saturating_sub(room.max(2))
}

fn draw_row(
    session: &Session,
    row: Row,
    current: bool,
    shift: usize,
    level: ColorLevel,
    place: Rect,
    buffer: &mut Buffer,
) {
    let mut line = Line::default();
    line.push_span(Span::raw(if current { theme::POINTER } else { " " }).bold());
    line.push_span(Span::raw(guides(session, row, shift)).style(theme::dim()));
    let fold = match session.rows.has_children(row) {
        true if session.rows.is_closed(row) => "▸",
        true => "▾",
        false => " ",
    };
    let end = if row.kind == RowKind::Absent {
        line.push_span(Span::styled(absence(session, row), theme::dim()));
        Line::default()
    } else if row.kind == RowKind::Bundle {
        line.push_span(Span::raw(fold));
        let kind = RayKind::Light;
        line.push_span(Span::styled(kind.letter(), theme::kind_style(kind)));
        bundle(session, row, level, &mut line)
    } else {
        let node = session.tree().node(row.node);
        line.push_span(Span::raw(fold));
        let kind = node.ray.kind;
        line.push_span(Span::styled(kind.letter(), theme::kind_style(kind)));
        line.push_span(Span::raw(format!(" {}", name(session, node))));
        columns(session, row.node, level)
    };
    let width = place.width.saturating_sub(end.width() as u16);
    write(buffer, place.x, place.y, &line, width);
    write(buffer, place.x + width, place.y, &end, place.width - width);
    if current {
        // The colours at the end stay as they are: reversed they would lie.
        let marked = Rect {
            x: place.x + 1,
            width: place
                .width
                .saturating_sub(if row.kind == RowKind::Absent { 1 } else { 4 }),
            ..place
        };
        buffer.set_style(marked.intersection(buffer.area), theme::current());
    }
}

/// What a ray met.
fn name(session: &Session, node: &Node) -> String {
    let scene = &session.world.scene;
    let object = |primitive| &scene.object_of(primitive).name;
    let to = if node.ray.kind == RayKind::Light {
        format!("to {}: ", session.view().light_name(node.ray.light))
    } else {
        String::new()
    };
    match node.outcome {
        Some(Outcome::Hit(hit)) => format!("{to}{}", object(hit.primitive)),
        Some(Outcome::Blocked(hit)) => format!("{to}blocked by {}", object(hit.primitive)),
        Some(Outcome::Lit) => format!("{to}lit"),
        Some(Outcome::Miss) => format!("{to}background"),
        None => format!("{to}not finished"),
    }
}

/// The rays to an area light, together: writes the name, gives the share of the pixel and the colour.
fn bundle(session: &Session, row: Row, level: ColorLevel, line: &mut Line) -> Line<'static> {
    let (view, tree) = (session.view(), session.tree());
    let Some(Event::LightSamples { light, samples }) = tree.events.get(row.event as usize) else {
        return Line::default();
    };
    let bundle = view.light_estimate(row.node, *light);
    let name = view.light_name(*light);
    line.push_span(Span::raw(format!(
        " {samples} to {name}: {} lit, {} blocked",
        bundle.lit, bundle.blocked
    )));
    let pixel = view.trace.pixel.color.luminance();
    let weight = tree.sample_of_node(row.node).map_or(1.0, |s| s.weight);
    let brought = tree.node(row.node).throughput * bundle.mean * weight;
    let share = if pixel > 0.0 {
        brought.luminance() / pixel * 100.0
    } else {
        0.0
    };
    Line::from(vec![
        Span::raw(format!(" {share:>6.1} % ")),
        theme::swatch(bundle.mean * session.settings.image.exposure, level),
        Span::raw(" "),
    ])
}

/// t, share of the pixel, colour.
fn columns(session: &Session, id: u32, level: ColorLevel) -> Line<'static> {
    let node = session.tree().node(id);
    let t = match node.outcome {
        Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => num3(hit.t),
        Some(Outcome::Lit) => num3(node.ray.t_max),
        _ => "∞".to_owned(),
    };
    let share = format!("{:.1}", session.view().fraction(id) * 100.0);
    let color = if node.ray.kind == RayKind::Light {
        session.tree().lit_by(id)
    } else {
        node.radiance
    };
    Line::from(vec![
        Span::raw(format!(" t {t:>8} {share:>6} % ")),
        theme::swatch(color * session.settings.image.exposure, level),
        Span::raw(" "),
    ])
}

fn num3(x: f64) -> String {
    if x.is_infinite() {
        "∞".to_owned()
    } else if (1e-3..1e5).contains(&x) {
        format!("{x:.3}")
    } else {
        num(x)
    }
}

fn absence(session: &Session, row: Row) -> String {
    match session.tree().events.get(row.event as usize) {
        Some(Event::Absent {
            kind,
            light,
            reason,
        }) => {
            let name = session.view().light_name(*light);
            let to = if name.is_empty() {
                String::new()
            } else {
                format!(" to {name}")
            };
            format!(" no {}{to}: {}", kind.letter(), reason.name())
        }
        _ => String::new(),
    }
}

/// The guide lines before a row: for each ray around it whether more follows below that.
fn guides(session: &Session, row: Row, shift: usize) -> String {
    let tree = session.tree();
    let mut parts: Vec<&str> = Vec::new();
    let (mut at, mut own) = (row, true);
    let depth = Rows::depth(tree, row) as usize;
    // From the row to the root, but no further left than the pane reaches.
    for _ in shift..depth {
        parts.push(match (session.rows.is_last(tree, at), own) {
            (true, true) => "└─",
            (false, true) => "├─",
            (true, false) => "  ",
            (false, false) => "│ ",
        });
        own = false;
        let Some(parent) = Rows::parent(tree, at) else {
            break;
        };
        at = Row {
            event: tree.node(parent).first_event,
            end: tree.node(parent).last_event,
            node: parent,
            kind: RowKind::Ray,
        };
    }
    if shift > 0 {
        parts.push("…");
    }
    parts.reverse();
    parts.concat()
}
