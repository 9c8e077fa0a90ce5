//! The ray tree as boxes: what stands in them, their colours, and where they stand.

use crate::probe::RayKind;
use crate::trace::document::{AbsentRay, Document, RayInTree, RayNode, RayOutcome, TraversalStep};
use crate::trace::format::{counted, num, percent};

pub use crate::scene::limits::MAX_DIAGRAM_NODES as MAX_NODES;

/// Size of a box, in pixels.
pub const WIDTH: f64 = 168.0;
/// Height of a box.
pub const HEIGHT: f64 = 56.0;
/// Free space around a box.
pub const GAP: f64 = 14.0;
/// From one level of the tree to the next.
const LEVEL: f64 = 92.0;

/// A ray, a bundle of shadow rays, or a ray that was not sent, as a box of the diagram.
pub struct Figure<'a> {
    /// The number of the box above it.
    pub parent: Option<usize>,
    /// Its first line: kind, number, light.
    pub title: String,
    /// Its second line: how the ray ended, or why it was not sent.
    pub end: String,
    /// Its third line: its part of the pixel's brightness.
    pub percent: String,
    /// What it brings back, as a screen shows it; of L rays whether the light is seen.
    pub fill: [u8; 3],
    /// The colour of its kind.
    pub color: &'static str,
    /// The rays that it stands for: 0 if the ray was not sent.
    pub rays: u64,
    /// Steps through the accelerator.
    pub steps: &'a [TraversalStep],
}

/// The top left corner of a box, in pixels.
#[derive(Clone, Copy)]
pub struct Corner {
    /// From the left.
    pub x: f64,
    /// From the top.
    pub y: f64,
}

/// The rays of a pixel as boxes, parents first, up to [`MAX_NODES`], and how many rays were left out. The shadow rays to an area
/// light are one box.
pub fn figures(document: &Document) -> (Vec<Figure<'_>>, u64) {
    let mut boxes = Boxes::default();
    for sample in &document.samples {
        // The box of each ray, and the bundle that is going on.
        let mut places: Vec<usize> = Vec::new();
        let mut bundle: Option<Bundle> = None;
        for ray in sample.rays() {
            let parent = ray.parent.and_then(|parent| places.get(parent)).copied();
            // Below a bundle nothing hangs.
            let parent = parent.filter(|place| *place != usize::MAX);
            let share = document.fraction(sample, ray.contribution);
            if let Some(of) = Bundle::of(&ray, parent) {
                let mut going = match bundle.take() {
                    Some(going) if going.is_of(&of) => going,
                    other => {
                        other.map(|done| boxes.push(done.figure()));
                        of
                    }
                };
                going.add(ray.node.outcome, share);
                places.push(usize::MAX);
                bundle = Some(going);
                continue;
            }
            if let Some(done) = bundle.take() {
                boxes.push(done.figure());
            }
            let place = boxes.push(figure(document, &ray, parent, share));
            places.push(place);
            for absent in absences(ray.node, place) {
                boxes.push(absent);
            }
        }
        if let Some(done) = bundle.take() {
            boxes.push(done.figure());
        }
    }
    let shown: u64 = boxes.figures.iter().map(|figure| figure.rays).sum();
    (boxes.figures, boxes.rays - shown)
}

/// The first boxes, how many there are in all, and the rays that they stand for.
#[derive(Default)]
struct Boxes<'a> {
    figures: Vec<Figure<'a>>,
    count: usize,
    rays: u64,
}

impl<'a> Boxes<'a> {
    /// Adds a box if there is room, and gives its number.
    fn push(&mut self, figure: Figure<'a>) -> usize {
        self.rays += figure.rays;
        if self.figures.len() < MAX_NODES {
            self.figures.push(figure);
        }
        self.count += 1;
        self.count - 1
    }
}

/// Shadow rays to an area light from one hit.
struct Bundle<'a> {
    parent: Option<usize>,
    light: &'a str,
    rays: u64,
    lit: u64,
    blocked: u64,
    share: f64,
}

impl<'a> Bundle<'a> {
    /// The bundle that a ray belongs to, without it; none if it is no ray to an area light.
    fn of(ray: &RayInTree<'a>, parent: Option<usize>) -> Option<Self> {
        ray.node.sample?;
        Some(Self {
            parent,
            light: ray.node.light.as_deref()?,
            rays: 0,
            lit: 0,
            blocked: 0,
            share: 0.0,
        })
    }

    fn is_of(&self, other: &Self) -> bool {
        (self.parent, self.light) == (other.parent, other.light)
    }

    fn add(&mut self, outcome: Option<RayOutcome>, share: f64) {
        self.rays += 1;
        self.lit += u64::from(outcome == Some(RayOutcome::Lit));
        self.blocked += u64::from(outcome == Some(RayOutcome::Blocked));
        self.share += share;
    }

    fn figure(self) -> Figure<'a> {
        let seen = if self.lit >= self.blocked { LIT } else { DARK };
        Figure {
            parent: self.parent,
            title: format!("{} to {}", counted(self.rays, "L ray"), self.light),
            end: format!("{} lit, {} blocked", self.lit, self.blocked),
            percent: percent(self.share),
            fill: seen,
            color: color(RayKind::Light),
            rays: self.rays,
            steps: &[],
        }
    }
}

/// Boxes of L rays that see their light, and of those that do not.
const LIT: [u8; 3] = [255, 244, 190];
const DARK: [u8; 3] = [60, 60, 60];

/// The box of a ray.
fn figure<'a>(
    document: &Document,
    ray: &RayInTree<'a>,
    parent: Option<usize>,
    share: f64,
) -> Figure<'a> {
    let node = ray.node;
    let end = match (&node.hit, node.outcome) {
        (Some(hit), Some(RayOutcome::Blocked)) => {
            format!("blocked by {} t={}", hit.object, num(hit.t))
        }
        (Some(hit), _) => format!("{} t={}", hit.object, num(hit.t)),
        (None, Some(RayOutcome::Lit)) => "lit".to_owned(),
        (None, Some(_)) => "miss".to_owned(),
        (None, None) => "cut".to_owned(),
    };
    let fill = match node.outcome {
        Some(RayOutcome::Lit) => LIT,
        Some(RayOutcome::Blocked) => DARK,
        _ => (node.radiance.unwrap_or_default() * document.settings.exposure).to_srgb8(),
    };
    let light = node.light.as_deref().unwrap_or_default();
    let gap = if light.is_empty() { "" } else { " " };
    let title = format!("{} {}{gap}{light}", node.kind.letter(), node.id);
    Figure {
        parent,
        title,
        end,
        percent: percent(share),
        fill,
        color: color(node.kind),
        rays: 1,
        steps: &node.traversal,
    }
}

/// The rays that were not sent from a hit, equal ones together, as boxes below box `place`.
fn absences(node: &RayNode, place: usize) -> Vec<Figure<'_>> {
    let mut groups: Vec<(&AbsentRay, u64)> = Vec::new();
    for absent in &node.absent {
        let same = |(other, _): &&mut (&AbsentRay, u64)| {
            (other.kind, &other.light, other.reason) == (absent.kind, &absent.light, absent.reason)
        };
        match groups.iter_mut().rev().take(MAX_GROUPS).find(same) {
            Some((_, count)) => *count += 1,
            None => groups.push((absent, 1)),
        }
    }
    let boxed = |(absent, count): (&AbsentRay, u64)| {
        let light = absent.light.as_deref().unwrap_or_default();
        let gap = if light.is_empty() { "" } else { " " };
        let times = if count > 1 {
            format!(" x {count}")
        } else {
            String::new()
        };
        Figure {
            parent: Some(place),
            title: format!("no {}{gap}{light}{times}", absent.kind.letter()),
            end: absent.reason.words().to_owned(),
            percent: String::new(),
            fill: [255; 3],
            color: color(absent.kind),
            rays: 0,
            steps: &[],
        }
    };
    groups.into_iter().map(boxed).collect()
}

/// Groups of absent rays that are compared with the next one.
const MAX_GROUPS: usize = 16;

/// The colour of a kind of ray.
fn color(kind: RayKind) -> &'static str {
    match kind {
        RayKind::Incident => "#444444",
        RayKind::Light => "#b8860b",
        RayKind::Reflected => "#c03030",
        RayKind::Transmitted => "#2060c0",
    }
}

/// The boxes' corners: leaves side by side in order, parents above the middle of their children.
pub fn layout(figures: &[Figure]) -> Vec<Corner> {
    let mut corners = vec![Corner { x: 0.0, y: 0.0 }; figures.len()];
    let mut spans: Vec<Option<[f64; 2]>> = vec![None; figures.len()];
    let mut depths = vec![0.0; figures.len()];
    for (i, figure) in figures.iter().enumerate() {
        depths[i] = figure.parent.map_or(0.0, |p| depths[p] + 1.0);
    }
    // Parents stand before their children, so from the back every child is placed before its parent. Leaves are
    // met from the last to the first: they are counted from the right, and turned over at the end.
    let mut from_right = 0.0;
    for (i, figure) in figures.iter().enumerate().rev() {
        let x = spans[i].map_or_else(
            || {
                from_right += WIDTH + GAP;
                -from_right
            },
            |[left, right]| f64::midpoint(left, right),
        );
        let y = 40.0 + depths[i] * LEVEL;
        corners[i] = Corner { x, y };
        if let Some(parent) = figure.parent {
            let [left, right] = spans[parent].unwrap_or([x, x]);
            spans[parent] = Some([left.min(x), right.max(x)]);
        }
    }
    for corner in &mut corners {
        corner.x += from_right + GAP;
    }
    corners
}

/// A colour as `#rrggbb`.
pub fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Black or white, whichever can be read on the colour.
pub fn ink([r, g, b]: [u8; 3]) -> &'static str {
    let brightness = 2 * u32::from(r) + 5 * u32::from(g) + u32::from(b);
    if brightness > 8 * 140 {
        "#000000"
    } else {
        "#ffffff"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::load;
    use crate::trace::document::SampleTree;
    use crate::trace::{View, document, trace_pixel};
    use crate::world::World;

    fn document_of(name: &str, at: (u32, u32)) -> Document {
        let scene = load(name).expect(name);
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (64, 48);
            s.light.samples = 16;
        });
        let world = World::new(scene, settings.accel);
        let trace = trace_pixel(&world, &settings, at, false);
        document::of(View {
            world: &world,
            settings: &settings,
            trace: &trace,
        })
    }

    /// Every ray has a box of its own or is counted in that of its bundle; every absence is told below the ray that has it.
    #[test]
    fn every_ray_and_absence_is_in_a_box() {
        let (mut bundles, mut total_reflections) = (0, 0);
        for (name, at) in [
            ("soft-shadow", (24, 36)),
            ("lamps", (30, 36)),
            ("nested-glass", (36, 14)),
            ("whitted", (32, 26)),
        ] {
            let document = document_of(name, at);
            let rays: Vec<_> = document.samples.iter().flat_map(SampleTree::rays).collect();
            let (figures, left_out) = figures(&document);
            assert_eq!(left_out, 0, "{name}");
            let of_bundle = |figure: &Figure| {
                let (count, _) = figure.title.split_once(" L ray")?;
                count.parse::<usize>().ok()
            };
            let sent = figures.iter().filter(|figure| figure.rays > 0);
            let told: usize = sent.map(|figure| of_bundle(figure).unwrap_or(1)).sum();
            assert_eq!(told, rays.len(), "{name}");
            bundles += figures.iter().filter_map(of_bundle).count();
            let absent: usize = rays.iter().map(|ray| ray.node.absent.len()).sum();
            let times = |figure: &Figure| {
                figure
                    .title
                    .rsplit_once(" x ")
                    .map_or(1, |(_, n)| n.parse().expect("a number"))
            };
            let told: usize = figures.iter().filter(|f| f.rays == 0).map(times).sum();
            assert_eq!(told, absent, "{name}");
            total_reflections += figures.iter().filter(|f| f.end.contains("total")).count();
            for (number, figure) in figures.iter().enumerate() {
                assert!(figure.parent.is_none_or(|parent| parent < number), "{name}");
            }
        }
        assert!(
            bundles > 1 && total_reflections > 0,
            "{bundles}, {total_reflections}"
        );
    }
}
