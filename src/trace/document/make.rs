//! From the log and the world to the document: the one place where ids become names.

use super::settings::settings;
use super::step::finite;
use super::{
    AbsentRay, CornerValue, Document, DocumentCuts, FormatVersion, GroupFrame, HitPoint, ImageSize,
    LightSummary, MediumBoundary, PassedSurface, PixelColor, PixelIndex, PointOfLight, RayNode,
    RayOutcome, SampleTree, SceneId, TermValue, step,
};
use crate::math::Rgb;
use crate::probe::{Absence, Event, NONE, RayKind, RayRecord, Term};
use crate::trace::corner_terms::CornerTerm;
use crate::trace::tree::Sample;
use crate::trace::{LightEstimate, Outcome, SurfaceHit, View};

/// The document of a recorded pixel.
pub fn of(view: View) -> Document {
    with_samples(view, view.trace.tree.dropped, samples(view))
}

/// The document of a pixel whose samples are these; so many events are missing in them.
pub fn with_samples<S>(view: View, dropped: u64, samples: S) -> Document<S> {
    let (scene, trace) = (&view.world.scene, view.trace);
    let linear = trace.pixel.color;
    Document {
        format: FormatVersion::Raytree1,
        scene: SceneId {
            name: scene.name.clone(),
            hash: scene.hash.clone(),
            lights: scene.lights.iter().map(|l| l.name.clone()).collect(),
        },
        image: ImageSize {
            width: view.settings.image.width,
            height: view.settings.image.height,
        },
        pixel: PixelIndex {
            x: trace.x,
            y: trace.y,
        },
        warnings: super::list(&scene.warnings),
        settings: settings(view.settings, scene),
        color: PixelColor {
            linear,
            srgb8: view
                .settings
                .bends
                .srgb8(linear * view.settings.image.exposure),
        },
        rays: trace.pixel.rays,
        cut: (!trace.pixel.cuts.is_empty()).then(|| DocumentCuts {
            depth: trace.pixel.cuts.by_depth,
            weight: trace.pixel.cuts.by_weight,
            share: trace.pixel.cut_share(),
        }),
        standard_error: finite(trace.pixel.error),
        spoiled: trace.pixel.non_finite,
        truncated: (dropped > 0).then_some(dropped),
        samples,
    }
}

/// The samples with their trees. Nodes stand parents first, so from the back each finds its children done; without
/// recursion, since trees may be deep.
pub fn samples(view: View) -> Vec<SampleTree> {
    let tree = &view.trace.tree;
    let mut done: Vec<RayNode> = Vec::new();
    for id in (0..tree.nodes.len() as u32).rev() {
        let first = done.len() - tree.children(id).count();
        let children = done.drain(first..).rev().collect();
        done.push(ray_node(view, id, children));
    }
    let samples = tree.samples.iter();
    let sample_tree = |sample: &Sample| SampleTree {
        index: sample.index,
        film: sample.film,
        weight: sample.weight,
        root: sample
            .root
            .and_then(|root| std::iter::from_fn(|| done.pop()).find(|node| node.id == root)),
    };
    samples.map(sample_tree).collect()
}

/// One ray, given those that its hit sent.
fn ray_node(view: View, id: u32, children: Vec<RayNode>) -> RayNode {
    let tree = &view.trace.tree;
    let (this, scene) = (tree.node(id), &view.world.scene);
    let ray = &this.ray;
    let of_sums = |value: Rgb| (ray.kind != RayKind::Light).then_some(value);
    let hit = view.surface_hit(id);
    let mut node = RayNode {
        id,
        kind: ray.kind,
        depth: ray.depth,
        origin: ray.origin.to_array(),
        direction: ray.direction.to_array(),
        t_min: 0.0,
        t_max: finite(ray.t_max),
        weight: of_sums(ray.weight),
        throughput: of_sums(this.throughput),
        medium: scene.medium_name(ray.medium).to_owned(),
        ior: scene.medium_ior(ray.medium),
        outcome: this.outcome.map(outcome),
        passed: Vec::new(),
        hit: hit.as_ref().map(|hit| Box::new(hit_point(view, hit))),
        light: light_name(view, ray.light),
        sample: sample_number(view, ray.light, ray.sample),
        light_point: this.parent.and_then(|p| light_point(view, p, ray)),
        bundles: Vec::new(),
        boundary: None,
        terms: Vec::new(),
        radiance: of_sums(this.radiance),
        contribution: of_sums(this.contribution() * view.sample_weight(id)),
        absent: Vec::new(),
        children,
        traversal: Vec::new(),
    };
    for (_, event) in tree.own_events(id) {
        add_event(view, &mut node, event);
    }
    let estimates = view.light_estimates(id);
    node.bundles = estimates.iter().map(|e| light_summary(view, e)).collect();
    node
}

/// The point of an area light that an L ray from the hit of `parent` goes to.
fn light_point(view: View, parent: u32, ray: &RayRecord) -> Option<Box<PointOfLight>> {
    let asked = view.asked_point(parent, (ray.light, u32::from(ray.sample)))?;
    Some(Box::new(PointOfLight {
        point: asked.point.to_array(),
        radiance: asked.radiance,
        area: asked.area,
        cosine: asked.cosine,
        distance: asked.distance,
        samples: asked.samples,
    }))
}

/// Adds what an event of a ray says to its node.
fn add_event(view: View, node: &mut RayNode, event: &Event) {
    let scene = &view.world.scene;
    match *event {
        Event::Term {
            term,
            sample,
            light,
        } => node.terms.push(TermValue {
            term: term.kind(),
            light: light_name(view, light),
            sample: sample_number(view, light, sample),
            value: term.value(),
            factors: (&term).into(),
            corners: corner_values(view, node.id, &term, (light, u32::from(sample))),
        }),
        Event::Absent {
            kind,
            light,
            reason,
        } => node
            .absent
            .push(absent_ray(kind, light_name(view, light), reason)),
        Event::Boundary {
            n1,
            n2,
            reflectance,
        } => {
            let touching = view.touching(node.id).into_iter().map(str::to_owned);
            node.boundary = Some(Box::new(MediumBoundary {
                n1,
                n2,
                reflectance,
                touching: touching.collect(),
            }));
        }
        Event::Passed { hit, medium } => node.passed.push(PassedSurface {
            t: hit.t,
            object: scene.object_of(hit.primitive).name.clone(),
            primitive: scene.face_of(&hit),
            medium: scene.medium_name(medium).to_owned(),
        }),
        Event::Visit(visit) => node.traversal.push(step::visit(view.world, &visit)),
        Event::Test {
            primitive,
            verdict,
            t,
        } => node
            .traversal
            .push(step::test(scene, primitive, verdict, t)),
        _ => {}
    }
}

/// The corners of a blended term.
fn corner_values(
    view: View,
    node: u32,
    term: &Term,
    light: (u32, u32),
) -> Option<Box<[CornerValue; 3]>> {
    let Term::Blended { kind, .. } = *term else {
        return None;
    };
    let corners = view.corner_terms(node, kind, light)?;
    let value = |corner: CornerTerm| CornerValue {
        weight: corner.weight,
        n_dot_l: corner.n_dot_l(),
        r_dot_v: corner.r_dot_v(),
        value: corner.value(),
    };
    Some(Box::new(corners.map(value)))
}

fn outcome(outcome: Outcome) -> RayOutcome {
    match outcome {
        Outcome::Hit(_) => RayOutcome::Hit,
        Outcome::Miss => RayOutcome::Miss,
        Outcome::Lit => RayOutcome::Lit,
        Outcome::Blocked(_) => RayOutcome::Blocked,
    }
}

fn hit_point(view: View, surface: &SurfaceHit) -> HitPoint {
    let (hit, at) = (&surface.hit, &surface.at);
    let frames = view.world.scene.frames_of(surface.object);
    let frames = frames.map(|frame| GroupFrame {
        group: frame.name.clone(),
        to_world: frame.matrix(),
    });
    HitPoint {
        t: hit.t,
        point: at.point.to_array(),
        object: surface.object.name.clone(),
        primitive: surface.primitive,
        part: surface.part.map(str::to_owned),
        barycentric: surface.barycentric,
        gradient: surface.gradient.map(|g| g.to_array()),
        uv: at.uv.to_array(),
        geometric_normal: at.geometric_normal.to_array(),
        normal: at.normal.to_array(),
        side: at.side,
        material: surface.material.name.clone(),
        shading: surface.shading,
        frames: frames.collect(),
    }
}

fn light_summary(view: View, estimate: &LightEstimate) -> LightSummary {
    LightSummary {
        light: view.light_name(estimate.light).to_owned(),
        samples: view.settings.rays_to_area(),
        lit: estimate.lit,
        blocked: estimate.blocked,
        mean: estimate.mean,
        standard_error: estimate.standard_error,
    }
}

fn absent_ray(kind: RayKind, light: Option<String>, absence: Absence) -> AbsentRay {
    let mut absent = AbsentRay {
        kind,
        reason: absence.into(),
        light,
        k: None,
        n_dot_l: None,
        n_dot_r: None,
        cos_angle: None,
        weight: None,
    };
    match absence {
        Absence::TotalInternalReflection { k } => absent.k = Some(k),
        Absence::FacingAway { n_dot_l } => absent.n_dot_l = Some(n_dot_l),
        Absence::BelowSurface { n_dot_r } => absent.n_dot_r = Some(n_dot_r),
        Absence::OutsideCone { cos_angle } => absent.cos_angle = Some(cos_angle),
        Absence::MinWeight { weight } => absent.weight = Some(weight),
        _ => {}
    }
    absent
}

fn light_name(view: View, light: u32) -> Option<String> {
    (light != NONE).then(|| view.light_name(light).to_owned())
}

/// The number of a light's sample, if the light is an area.
fn sample_number(view: View, light: u32, sample: u16) -> Option<u32> {
    view.is_area(light).then_some(u32::from(sample))
}
