//! The current ray's way through the acceleration structure: nodes visited and skipped, shapes tested.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Style, Stylize as _};
use ratatui::text::{Line, Span};

use super::draw::write;
use super::session::Session;
use super::theme;
use crate::probe::{Choice, Event, NONE, Verdict, Visit};
use crate::trace::format::num;

/// Its title.
pub fn title(session: &Session) -> Line<'static> {
    let steps = session.steps();
    let here = session.cursor().position();
    let kind = session.settings.accel.name();
    if steps.contains(&here) {
        let (n, of) = (here - steps.start + 1, steps.len());
        return Line::raw(format!(" {kind} step {n} of {of} "));
    }
    Line::raw(format!(" {kind}: {} steps ", steps.len()))
}

/// The first step that is shown in a pane of `height` rows: the current one stays in the middle.
pub fn first_step(session: &Session, height: u16) -> usize {
    let steps = session.steps();
    let height = usize::from(height);
    let last = steps.end.saturating_sub(height).max(steps.start);
    let here = session.cursor().position();
    here.saturating_sub(height / 2).clamp(steps.start, last)
}

/// Draws the steps around the current one.
pub fn draw(session: &Session, place: Rect, buffer: &mut Buffer) {
    let steps = session.steps();
    if steps.is_empty() {
        let text = "this ray was not searched for anything";
        write(
            buffer,
            place.x,
            place.y,
            &Line::from(text).style(theme::dim()),
            place.width,
        );
        return;
    }
    let here = session.cursor().position();
    let shown = first_step(session, place.height)..steps.end;
    for (y, index) in (place.y..place.bottom()).zip(shown) {
        let current = index == here;
        let mut line = Line::from(Span::raw(if current { theme::POINTER } else { " " }).bold());
        match session.tree().events.get(index) {
            Some(Event::Visit(visit)) => line.extend(visited(session, visit)),
            Some(Event::Test {
                primitive,
                verdict,
                t,
            }) => line.extend(tested(session, *primitive, *verdict, *t)),
            _ => {}
        }
        write(buffer, place.x, y, &line, place.width);
        if current {
            let row = Rect::new(place.x + 1, y, place.width.saturating_sub(1), 1);
            buffer.set_style(row.intersection(buffer.area), theme::current());
        }
    }
}

/// A node: what is done and why not more, then where it is split and which part of the ray is inside.
fn visited(session: &Session, visit: &Visit) -> Vec<Span<'static>> {
    let child = |id: u32| {
        if id == NONE {
            "empty".to_owned()
        } else {
            id.to_string()
        }
    };
    let (near, far) = (child(visit.near), child(visit.far));
    let choice = match visit.choice {
        Choice::Leaf => " leaf".to_owned(),
        Choice::Cell => " cell".to_owned(),
        Choice::Both => format!(" near {near}, far {far}"),
        Choice::BothInDoubt => format!(" near {near}, far {far} (in doubt)"),
        Choice::NearSplitBeyond => format!(" near {near}, not {far}: plane beyond"),
        Choice::NearRunsAway => format!(" near {near}, not {far}: runs away"),
        Choice::FarSplitBefore => format!(" far {far}, not {near}: plane before"),
        Choice::SkippedCloserHit => " skipped: a closer hit is known".to_owned(),
        Choice::SkippedOutside => " skipped: outside the box".to_owned(),
        Choice::Children => " the children it meets, nearest first".to_owned(),
        Choice::SkippedMissed => " skipped: misses its box".to_owned(),
    };
    let [t0, t1] = visit.interval.map(short);
    let plane = session.world.accel.plane(visit.node);
    let plane = plane.map_or_else(String::new, |(n, d)| {
        let name = plane_name(n.to_array(), d);
        if visit.t_split.is_nan() {
            format!("{name}, ")
        } else {
            format!("{name} at t {}, ", short(visit.t_split))
        }
    });
    let node = format!("node {}", visit.node);
    let place = format!("  {plane}inside t {t0}..{t1}");
    let skipped = matches!(
        visit.choice,
        Choice::SkippedCloserHit | Choice::SkippedOutside | Choice::SkippedMissed
    );
    let style = if skipped { theme::dim() } else { Style::new() };
    vec![
        Span::styled(node, style.bold()),
        Span::styled(choice, style),
        Span::styled(place, theme::dim()),
    ]
}

/// x = d across an axis, else the normal.
fn plane_name(n: [f64; 3], d: f64) -> String {
    let axis = (0..3).find(|i| n[*i].abs() == 1.0);
    if let Some(i) = axis {
        return format!("{} = {}", ["x", "y", "z"][i], short(d * n[i] + 0.0));
    }
    let [x, y, z] = n.map(short);
    format!("({x}, {y}, {z}).p = {}", short(d))
}

/// A shape: crossed or not, and where.
fn tested(session: &Session, primitive: u32, verdict: Verdict, t: f64) -> Vec<Span<'static>> {
    let scene = &session.world.scene;
    let name = &scene.object_of(primitive).name;
    let number = scene.local_index(primitive);
    let text = format!("  test {name} {number}: ");
    let result = match verdict {
        Verdict::Hit => Span::raw(format!("hit at t {}", short(t))).bold(),
        Verdict::Miss => Span::styled("miss", theme::dim()),
        Verdict::TooFar => Span::styled(format!("too far, t {}", short(t)), theme::dim()),
        Verdict::Behind => Span::styled(format!("behind, t {}", short(t)), theme::dim()),
    };
    vec![Span::raw(text), result]
}

fn short(x: f64) -> String {
    if x.is_infinite() {
        return "∞".to_owned();
    }
    if x == 0.0 || (1e-3..1e5).contains(&x.abs()) {
        let text = format!("{x:.3}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    num(x)
}
