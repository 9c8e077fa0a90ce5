//! The ray tree as boxes: what stands in them, their colours, and where they stand.

use crate::probe::RayKind;
use crate::trace::document::{Document, RayInTree, RayNode, RayOutcome, SampleTree};
use crate::trace::format::{num, percent};

pub use crate::scene::limits::MAX_DIAGRAM_NODES as MAX_NODES;

/// Size of a box, in pixels.
pub const WIDTH: f64 = 168.0;
/// Height of a box.
pub const HEIGHT: f64 = 56.0;
/// Free space around a box.
pub const GAP: f64 = 14.0;
/// From one level of the tree to the next.
const LEVEL: f64 = 92.0;

/// A ray as a box of the diagram.
pub struct Figure<'a> {
    /// The ray.
    pub node: &'a RayNode,
    /// The number of the box above it.
    pub parent: Option<usize>,
    /// Its first line: kind, and number or light.
    pub title: String,
    /// Its second line: how the ray ended.
    pub end: String,
    /// Its third line: its part of the pixel's brightness.
    pub percent: String,
    /// What it brings back, as a screen shows it; of L rays whether the light is seen.
    pub fill: [u8; 3],
    /// The colour of its kind.
    pub color: &'static str,
}

/// The top left corner of a box, in pixels.
#[derive(Clone, Copy)]
pub struct Corner {
    /// From the left.
    pub x: f64,
    /// From the top.
    pub y: f64,
}

/// The rays of a pixel as boxes, parents first, up to [`MAX_NODES`], and how many were left out.
pub fn figures(document: &Document) -> (Vec<Figure<'_>>, usize) {
    let mut figures = Vec::new();
    let mut count = 0;
    for sample in &document.samples {
        let first = count;
        for ray in sample.rays() {
            if count < MAX_NODES {
                figures.push(figure(document, sample, first, &ray));
            }
            count += 1;
        }
    }
    let left_out = count - figures.len();
    (figures, left_out)
}

/// The box of a ray; `first`: the number of its sample's eye ray.
fn figure<'a>(
    document: &Document,
    sample: &SampleTree,
    first: usize,
    ray: &RayInTree<'a>,
) -> Figure<'a> {
    let node = ray.node;
    let end = match (&node.hit, node.outcome) {
        (Some(hit), _) => format!("{} t={}", hit.object, num(hit.t)),
        (None, Some(RayOutcome::Lit)) => "lit".to_owned(),
        (None, Some(_)) => "miss".to_owned(),
        (None, None) => "cut".to_owned(),
    };
    let fill = match node.outcome {
        Some(RayOutcome::Lit) => [255, 244, 190],
        Some(RayOutcome::Blocked) => [60, 60, 60],
        _ => (node.radiance.unwrap_or_default() * document.settings.exposure).to_srgb8(),
    };
    let light = node.light.as_deref().unwrap_or_default();
    Figure {
        node,
        parent: ray.parent.map(|parent| first + parent),
        title: match node.kind {
            RayKind::Light => format!("L {light}"),
            kind => format!("{} {}", kind.letter(), node.id),
        },
        end,
        percent: percent(document.fraction(sample, ray.contribution)),
        fill,
        color: match node.kind {
            RayKind::Incident => "#444444",
            RayKind::Light => "#b8860b",
            RayKind::Reflected => "#c03030",
            RayKind::Transmitted => "#2060c0",
        },
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
