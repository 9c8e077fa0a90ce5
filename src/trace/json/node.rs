//! From the log to the nodes of the document.

use super::{
    AbsentNode, Boundary, BundleNode, HitNode, Lazy, Node, PassedNode, Step, TermNode, Tested,
};
use crate::math::{DVec3, Rgb};
use crate::probe::{Absence, Event, NONE, RayKind, Term, Verdict, Visit};
use crate::shading::Side;
use crate::trace::LightEstimate;
use crate::trace::View;
use crate::trace::surface_hit::SurfaceHit;
use crate::trace::tree::Outcome;

/// One node, its children still to be visited.
pub fn node(view: View<'_>, id: u32) -> Node<Lazy<'_>> {
    let tree = &view.trace.tree;
    let this = tree.node(id);
    let sent = &this.ray;
    let sums = sent.kind != RayKind::Light;
    let arrival = view.surface_hit(id);
    let scene = &view.world.scene;
    let mut boundary = None;
    let (mut terms, mut absent, mut traversal) = (Vec::new(), Vec::new(), Vec::new());
    let mut passed = Vec::new();
    for (_, event) in tree.own_events(id) {
        match *event {
            Event::Term {
                term,
                sample,
                light,
                value,
            } => {
                let light = (light, u32::from(sample));
                terms.push(term_node(view, id, arrival.as_ref(), (term, light), value));
            }
            Event::Absent {
                kind,
                light,
                reason,
            } => absent.push(absent_node(view, kind, light, reason)),
            Event::Boundary {
                n1,
                n2,
                reflectance,
            } => {
                boundary = Some(Boundary {
                    n1,
                    n2,
                    reflectance,
                    touching: view.touching(id).into_iter().map(str::to_owned).collect(),
                });
            }
            Event::Passed { hit, medium } => passed.push(PassedNode {
                t: hit.t,
                object: scene.object_of(hit.primitive).name.clone(),
                primitive: scene.local_index(hit.primitive),
                medium: scene.medium_name(medium).to_owned(),
            }),
            Event::Visit(visit) => traversal.push(visit_step(view, &visit)),
            Event::Test {
                primitive,
                verdict,
                t,
            } => traversal.push(test_step(view, primitive, verdict, t)),
            _ => {}
        }
    }
    Node {
        id,
        kind: sent.kind.letter(),
        depth: sent.depth,
        origin: sent.origin.to_array(),
        direction: sent.direction.to_array(),
        t_min: 0.0,
        t_max: finite(sent.t_max),
        weight: sums.then_some(sent.weight),
        throughput: sums.then_some(this.throughput),
        medium: scene.medium_name(sent.medium).to_owned(),
        ior: scene.medium_ior(sent.medium),
        outcome: this.outcome.map(|outcome| match outcome {
            Outcome::Hit(_) => "hit",
            Outcome::Miss => "miss",
            Outcome::Lit => "lit",
            Outcome::Blocked(_) => "blocked",
        }),
        passed,
        hit: arrival.as_ref().map(hit_node),
        light: light_name(view, sent.light),
        sample: view.is_area(sent.light).then(|| u32::from(sent.sample)),
        bundles: view
            .light_estimates(id)
            .iter()
            .map(|b| bundle_node(view, b))
            .collect(),
        boundary,
        terms,
        radiance: sums.then_some(this.radiance),
        contribution: sums.then_some(this.contribution()),
        absent,
        children: Lazy { view, node: id },
        traversal,
    }
}

fn hit_node(arrival: &SurfaceHit) -> HitNode {
    let SurfaceHit {
        hit,
        at,
        object,
        primitive,
        material,
    } = arrival;
    let has_corners = hit.barycentric != [0.0; 3];
    HitNode {
        t: hit.t,
        point: at.point.to_array(),
        object: object.name.clone(),
        primitive: *primitive,
        barycentric: has_corners.then_some(hit.barycentric),
        uv: at.uv.to_array(),
        geometric_normal: at.geometric_normal.to_array(),
        normal: at.normal.to_array(),
        side: match at.side {
            Side::Front => "front",
            Side::Back => "back",
        },
        material: material.name.clone(),
    }
}

/// A term with the factors that it was made of.
fn term_node(
    view: View,
    node: u32,
    arrival: Option<&SurfaceHit>,
    (term, light): (Term, (u32, u32)),
    value: Rgb,
) -> TermNode {
    let plain = TermNode {
        term: term.name(),
        light: light_name(view, light.0),
        sample: view.is_area(light.0).then_some(light.1),
        value,
        ..TermNode::default()
    };
    let Some(arrival) = arrival else {
        return plain;
    };
    let lighting = view.lighting(node, light);
    let intensity = lighting.map(|l| l.light.intensity);
    match term {
        Term::Emission | Term::Background => plain,
        Term::Ambient => TermNode {
            ka: Some(arrival.material.ambient_at(arrival.at.uv)),
            ambient_light: Some(view.world.scene.ambient),
            ..plain
        },
        Term::Diffuse => TermNode {
            kd: lighting.map(|l| l.kd),
            intensity,
            n_dot_l: lighting.map(|l| l.n_dot_l),
            projected_solid_angle: lighting.and_then(|l| l.projected),
            ..plain
        },
        Term::Specular => TermNode {
            ks: Some(arrival.material.specular),
            intensity,
            r_dot_v: lighting.map(|l| l.r_dot_v.max(0.0)),
            shininess: Some(arrival.material.shininess),
            ..plain
        },
    }
}

fn bundle_node(view: View, bundle: &LightEstimate) -> BundleNode {
    BundleNode {
        light: view.light_name(bundle.light).to_owned(),
        samples: view.settings.rays_to_area(),
        lit: bundle.lit,
        blocked: bundle.blocked,
        mean: bundle.mean,
        standard_error: bundle.standard_error,
    }
}

fn absent_node(view: View, kind: RayKind, light: u32, reason: Absence) -> AbsentNode {
    let mut node = AbsentNode {
        kind: kind.letter(),
        reason: reason.name(),
        light: light_name(view, light),
        ..AbsentNode::default()
    };
    match reason {
        Absence::TotalInternalReflection { k } => node.k = Some(k),
        Absence::FacingAway { n_dot_l } => node.n_dot_l = Some(n_dot_l),
        Absence::BelowSurface { n_dot_r } => node.n_dot_r = Some(n_dot_r),
        Absence::OutsideCone { cos_angle } => node.cos_angle = Some(cos_angle),
        Absence::MinWeight { weight } => node.weight = Some(weight),
        _ => {}
    }
    node
}

fn visit_step(view: View, visit: &Visit) -> Step {
    let child = |id: u32| (id != NONE).then_some(id);
    Step::Visit {
        node: visit.node,
        plane: view.world.accel.plane(visit.node).map(|(n, d)| {
            let DVec3 { x, y, z } = n;
            [x, y, z, d]
        }),
        t_split: finite(visit.t_split),
        interval: visit.interval.map(finite),
        near: child(visit.near),
        far: child(visit.far),
        visit: visit.choice.visit(),
        reason: visit.choice.reason(),
    }
}

fn test_step(view: View, primitive: u32, verdict: Verdict, t: f64) -> Step {
    let scene = &view.world.scene;
    Step::Test {
        test: Tested {
            object: scene.object_of(primitive).name.clone(),
            primitive: scene.local_index(primitive),
        },
        result: verdict.name(),
        t: finite(t),
        reason: verdict.reason(),
    }
}

fn light_name(view: View, light: u32) -> Option<String> {
    (light != NONE).then(|| view.light_name(light).to_owned())
}

/// JSON has no infinity and no NaN: an open end is null.
fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}
