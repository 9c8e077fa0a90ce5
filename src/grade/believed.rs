//! What a student's tree says of a ray, as far as it says anything; else what is computed, else ours.

use crate::geometry::{Hit, Intersection, Shear};
use crate::math::{DVec3, Interval, Ray};
use crate::probe::RayKind;
use crate::scene::Settings;
use crate::shading::Interaction;
use crate::trace::facts::{FactName, RayFacts};
use crate::tracer::corners::HitCorners;
use crate::tracer::laws::Laws;
use crate::world::World;

/// What becomes of points and origins that are nearly those that are computed. With each of both readings some quantities of a
/// right tracer follow, and with the other they do not; so both are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NearPoints {
    /// They count as computed: a ray from the told origin would meet its own surface, or not, by chance.
    Computed,
    /// They are taken as told: with the student's own way to leave a surface, which a grazing ray makes large.
    Told,
}

/// Points nearer than this to what is computed are nearly that, in metres: twice the offset that many tracers have.
const NEAR: f64 = 2e-4;

impl NearPoints {
    /// The point that counts, of one that is told and one that is computed.
    fn point(self, told: DVec3, computed: DVec3) -> DVec3 {
        if self == Self::Computed && told.distance(computed) <= NEAR {
            computed
        } else {
            told
        }
    }

    /// The origin that counts, of one that is told and that of the ray that is sent.
    fn origin(self, told: DVec3, sent: &SentRay) -> DVec3 {
        let Some((point, normal)) = sent.surface else {
            return self.point(told, sent.origin);
        };
        if told.distance(sent.origin) > NEAR {
            return told;
        }
        // Above the surface the student's own offset may be kept; in it or below a ray meets its own surface by chance. Where
        // the laws start below the surface, an origin above it is another one.
        let above = |origin: DVec3| (origin - point).dot(normal);
        let is_kept = above(told) > 0.0 && (self == Self::Told || above(sent.origin) < 0.0);
        if is_kept { told } else { sent.origin }
    }
}

/// A ray that the laws send.
#[derive(Clone, Copy, Debug)]
pub struct SentRay {
    /// Where it starts.
    pub origin: DVec3,
    /// Its direction; of length 1 unless a law is bent.
    pub direction: DVec3,
    /// The point of the surface that it leaves, and the normal there on the side to which it should go; none for eye rays.
    pub surface: Option<(DVec3, DVec3)>,
}

impl SentRay {
    /// A ray that leaves a surface: T behind it, all others on the side of the viewer, wherever a wrong direction leads.
    pub fn from_surface(kind: RayKind, at: &Interaction, origin: DVec3, direction: DVec3) -> Self {
        let normal = match kind {
            RayKind::Transmitted => -at.geometric_normal,
            _ => at.geometric_normal,
        };
        Self {
            origin,
            direction,
            surface: Some((at.point, normal)),
        }
    }
}

/// A ray of our tree, and the student's ray of the same name.
#[derive(Clone, Copy)]
pub struct Believed<'a> {
    /// Ours.
    pub ours: &'a RayFacts,
    /// The student's, if there is one.
    pub theirs: Option<&'a RayFacts>,
    /// How points that are nearly as computed are read.
    pub near: NearPoints,
}

/// Where a ray ends, by the student's own numbers.
pub struct BelievedVertex {
    /// The primitive.
    pub primitive: u32,
    /// The point with its normals.
    pub at: Interaction,
    /// The corners of its triangle, if light is blended between them.
    pub corners: Option<HitCorners>,
}

impl Believed<'_> {
    /// A word that the student tells.
    pub fn word(&self, name: &FactName) -> Option<&str> {
        self.theirs?.word(name)
    }

    fn vector(&self, name: &FactName) -> Option<DVec3> {
        self.theirs?.vector(name).map(DVec3::from_array)
    }

    fn number(&self, name: &FactName) -> Option<f64> {
        self.theirs?.number(name)
    }

    /// The corners of the triangle that is hit, with the student's own weights if they are told; none if light is not blended there.
    pub fn corners<L: Laws>(
        &self,
        laws: L,
        (world, settings): (&World, &Settings),
        ray: &Ray,
        hit: &Hit,
    ) -> Option<HitCorners> {
        let object = world.scene.object_of(hit.primitive);
        let told = self.theirs.and_then(|r| r.vector(&FactName::Barycentric));
        let hit = Hit {
            place: told.map_or(hit.place, |weights| object.in_order_of_file(weights)),
            ..*hit
        };
        HitCorners::of(laws, (&world.scene, settings), ray.origin, &hit)
    }

    /// The hit point with the student's own point and normals where they are told; the ray's direction has this length.
    pub fn interaction(&self, computed: Interaction, length: f64) -> Interaction {
        let normal = self.vector(&FactName::Normal);
        let geometric = self.vector(&FactName::GeometricNormal);
        let normal = normal.or(geometric).unwrap_or(computed.normal);
        // A normal on the other side says that the geometric one is there, too.
        let side = if normal.dot(computed.geometric_normal) < 0.0 {
            -1.0
        } else {
            1.0
        };
        let told = self.vector(&FactName::Point);
        Interaction {
            point: told.map_or(computed.point, |told| self.near.point(told, computed.point)),
            to_viewer: computed.to_viewer * length,
            normal,
            geometric_normal: geometric.unwrap_or(side * computed.geometric_normal),
            ..computed
        }
    }
}

/// The ray that the student sent, with unit direction, and the length that the direction has there; `sent` is what the laws
/// give.
pub fn believed_ray(believed: Believed, sent: Option<SentRay>) -> Option<(Ray, f64)> {
    let told = |name| believed.vector(name);
    let ours = |name| believed.ours.vector(name).map(DVec3::from_array);
    let origin = match (told(&FactName::Origin), &sent) {
        (Some(told), Some(sent)) => believed.near.origin(told, sent),
        (Some(told), None) => told,
        (None, Some(sent)) => sent.origin,
        (None, None) => ours(&FactName::Origin)?,
    };
    let direction = told(&FactName::Direction).or(sent.map(|sent| sent.direction));
    let direction = direction.or_else(|| ours(&FactName::Direction))?;
    let unit = direction.try_normalize()?;
    let is_unit = (direction.length() - 1.0).abs() < 1e-9;
    let length = if is_unit { 1.0 } else { direction.length() };
    let unit = if is_unit { direction } else { unit };
    Some((Ray::new(origin, unit), length))
}

/// The hit that the student tells: the primitive of the named object that the ray crosses nearest to the student's t; else what
/// was traced.
pub fn believed_hit(
    world: &World,
    believed: Believed,
    (ray, length): (&Ray, f64),
    traced: Option<Hit>,
) -> Option<Hit> {
    let scene = &world.scene;
    let Some(name) = believed.word(&FactName::Object) else {
        return traced;
    };
    let told = believed.number(&FactName::T).map(|t| t * length);
    let same = traced.filter(|hit| scene.object_of(hit.primitive).name == name);
    if let Some(hit) = same.filter(|hit| told.is_none_or(|t| (t - hit.t).abs() <= NEAR)) {
        return Some(hit);
    }
    let object = scene
        .objects
        .iter()
        .position(|object| object.name == name)? as u32;
    let first = scene.objects[object as usize].first_primitive;
    let shear = Shear::new(ray);
    let wanted = told.or(traced.map(|hit| hit.t))?;
    let mut best: Option<Hit> = None;
    for (primitive, shape) in (first..).zip(scene.shapes_of(object)) {
        // Both crossings of a solid, those behind the origin included.
        let mut from = f64::NEG_INFINITY;
        while let Intersection::Hit { t, place, part } =
            shape.intersect(ray, &shear, Interval::new(from, f64::INFINITY))
        {
            let nearer = |hit: &Hit| (t - wanted).abs() < (hit.t - wanted).abs();
            if best.as_ref().is_none_or(nearer) {
                best = Some(Hit {
                    t,
                    primitive,
                    part,
                    place,
                });
            }
            from = t;
        }
    }
    // The student's own t, on the surface's own coordinates.
    best.map(|hit| Hit { t: wanted, ..hit })
}
