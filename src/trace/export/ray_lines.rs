//! The rays of a tree as lines of a Wavefront OBJ file, for a viewer of models: a group for each kind of ray.

use std::fmt;

use crate::math::DVec3;
use crate::probe::RayKind;
use crate::scene::printable::printable;
use crate::trace::document::{Document, RayNode, RayOutcome, SampleTree};

/// A document written as OBJ lines by `Display`.
pub struct RayLines<'a>(pub &'a Document);

/// Length of a ray that leaves the scene where no ray ends anywhere, in metres.
const ALONE: f64 = 1.0;

/// A ray as a line.
struct Segment {
    kind: RayKind,
    is_blocked: bool,
    ends: [DVec3; 2],
}

impl fmt::Display for RayLines<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let document = self.0;
        writeln!(f, "# {}", printable(&super::heading(document)))?;
        writeln!(
            f,
            "# a ray that leaves the scene is drawn as long as the longest other one"
        )?;
        let rays = || {
            let samples = document.samples.iter();
            samples.flat_map(SampleTree::rays).map(|ray| ray.node)
        };
        let longest = rays().filter_map(length).fold(0.0, f64::max);
        let longest = if longest > 0.0 { longest } else { ALONE };
        let segments: Vec<Segment> = rays().map(|node| segment(node, longest)).collect();
        let mut point = 0;
        for name in GROUPS {
            let those = segments.iter().filter(|segment| group(segment) == name);
            let mut is_first = true;
            for Segment { ends, .. } in those {
                if std::mem::take(&mut is_first) {
                    writeln!(f, "g {name}")?;
                }
                for end in ends {
                    writeln!(f, "v {} {} {}", end.x, end.y, end.z)?;
                }
                writeln!(f, "l {} {}", point + 1, point + 2)?;
                point += 2;
            }
        }
        Ok(())
    }
}

/// The groups.
const GROUPS: [&str; 5] = [
    "eye_rays",
    "reflected_rays",
    "transmitted_rays",
    "shadow_rays_lit",
    "shadow_rays_blocked",
];

/// The group of a ray.
fn group(segment: &Segment) -> &'static str {
    GROUPS[match segment.kind {
        RayKind::Incident => 0,
        RayKind::Reflected => 1,
        RayKind::Transmitted => 2,
        RayKind::Light => 3 + usize::from(segment.is_blocked),
    }]
}

/// How long a ray is; none if it leaves the scene.
fn length(node: &RayNode) -> Option<f64> {
    match node.outcome {
        Some(RayOutcome::Lit) => node.t_max,
        _ => node.hit.as_ref().map(|hit| hit.t),
    }
}

fn segment(node: &RayNode, longest: f64) -> Segment {
    let (origin, direction) = (DVec3::from(node.origin), DVec3::from(node.direction));
    let length = length(node).unwrap_or(longest);
    Segment {
        kind: node.kind,
        is_blocked: node.outcome == Some(RayOutcome::Blocked),
        ends: [origin, origin + length * direction],
    }
}
