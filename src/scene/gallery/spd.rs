//! Haines' Standard Procedural Databases: scenes that grow with a number, with published counts of their rays.
//!
//! Source: Haines 1987, "A proposal for standard graphics environments", IEEE CG&A 7(11); geometry, cameras, lights
//! and materials after his generators (placed in the public domain, CC0). They have z up; here each point is turned
//! to y up when it is added, and nothing else changes.
//!
//! What differs: cylinders and cones are prisms of [`SIDES`] sides with smooth normals, and polygons are cut into
//! triangles, so there are more primitives than the original counts. A little ambient light is added, which the
//! original leaves open. The rules for counting rays are in [`Spd::new`].

mod balls;
mod gears;
mod mount;
mod rings;
mod tetra;
mod tree;

use glam::DMat3;

use super::builder::{SceneBuilder, matt};
use crate::geometry::{Shape, Sphere};
use crate::math::{DVec3, Frame, Rgb};
use crate::scene::{Camera, Scene, Settings};
use crate::shading::Material;

/// The sides of a prism that stands for a cylinder or a cone.
const SIDES: u32 = 16;

/// Camera rays along one edge of the picture: one for each corner of 512 x 512 pixels.
const CORNERS: u32 = 513;

/// One of the databases.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Its name; behind a colon follows its size.
    pub name: &'static str,
    /// What it shows.
    pub note: &'static str,
    /// The size of which the counts are published.
    pub size: u32,
    /// How many shapes there are at a size, or a number too large.
    pub count: fn(u32) -> u64,
    build: fn(&mut Spd, u32),
    view: Viewpoint,
}

/// Camera, z up, and positions of the lights.
#[derive(Clone, Copy, Debug)]
struct Viewpoint {
    from: [f64; 3],
    at: [f64; 3],
    up: [f64; 3],
    lights: &'static [[f64; 3]],
}

/// All databases.
pub const KINDS: [Kind; 6] = [
    balls::KIND,
    gears::KIND,
    mount::KIND,
    rings::KIND,
    tetra::KIND,
    tree::KIND,
];

impl Kind {
    /// The scene of this size; `None` only if its camera had no view direction.
    pub fn scene(&self, size: u32) -> Option<Scene> {
        let mut spd = Spd::new(&format!("{}:{size}", self.name), &self.view)?;
        (self.build)(&mut spd, size);
        Some(spd.builder.finish())
    }
}

/// Description of a surface as in the original databases.
struct Finish {
    color: [f64; 3],
    diffuse: f64,
    mirror: f64,
    highlight: f64,
    /// Degrees from the mirrored direction at which a highlight has half its strength; 0 without highlight.
    angle: f64,
    transmission: f64,
    ior: f64,
}

impl Finish {
    /// A surface that only scatters light.
    const MATT: Self = Self {
        color: [1.0; 3],
        diffuse: 1.0,
        mirror: 0.0,
        highlight: 0.0,
        angle: 0.0,
        transmission: 0.0,
        ior: 1.0,
    };
}

/// Database in the making, z up.
struct Spd {
    builder: SceneBuilder,
}

impl Spd {
    /// The rules of the measure: 513 x 513 camera rays through the corners of 512 x 512 pixels, 45 degrees from the
    /// first to the last; camera ray and 4 bounces; no minimum weight.
    ///
    /// Those are the rays through the *middles* of 513 x 513 pixels if the film is larger by 513/512:
    /// (2 (i + 1/2) / 513 - 1) 513/512 = 2 i / 512 - 1.
    fn new(name: &str, view: &Viewpoint) -> Option<Self> {
        let eye = y_up(DVec3::from(view.from));
        let backwards = eye - y_up(DVec3::from(view.at));
        let edge = f64::from(CORNERS);
        let camera = Camera {
            eye,
            frame: Frame::from_w_up(backwards, y_up(DVec3::from(view.up)))?,
            half_height: libm::tan(std::f64::consts::PI / 8.0) * edge / (edge - 1.0),
        };
        let settings = Settings::default().with(|s| {
            s.image.width = CORNERS;
            s.image.height = CORNERS;
            s.recursion.depth = 4;
            s.recursion.min_weight = 0.0;
        });
        let mut builder = SceneBuilder::new(name, camera, settings);
        builder.sky(Rgb::new(0.078, 0.361, 0.753), Rgb::grey(0.15));
        // Haines' rule for the intensity of each of n lights.
        let n = view.lights.len() as f64;
        for position in view.lights {
            let intensity = Rgb::grey(n.sqrt() / (2.0 * n));
            builder.light(y_up(DVec3::from(*position)), intensity);
        }
        Some(Self { builder })
    }

    /// Adds a material.
    fn material(&mut self, name: &str, surface: &Finish) -> u32 {
        let [r, g, b] = surface.color;
        let color = Rgb::new(r, g, b);
        let shininess = if surface.angle > 0.0 {
            libm::log(0.5) / libm::log(libm::cos(surface.angle.to_radians()))
        } else {
            1.0
        };
        let matt = matt(name, color * surface.diffuse);
        self.builder.material(Material {
            specular: Rgb::grey(surface.highlight),
            shininess,
            mirror: color * surface.mirror,
            transmission: color * surface.transmission,
            ior: surface.ior,
            ..matt
        })
    }

    /// Begins an object.
    fn begin(&mut self, name: impl Into<String>, material: u32) {
        self.builder.begin(name, material);
    }

    fn sphere(&mut self, center: DVec3, radius: f64) {
        let center = y_up(center);
        self.builder.put(Shape::Sphere(Sphere { center, radius }));
    }

    fn triangle(&mut self, corners: [DVec3; 3]) {
        self.builder.triangle(corners.map(y_up));
    }

    fn quad(&mut self, corners: [DVec3; 4]) {
        self.builder.quad(corners.map(y_up));
    }

    /// A cone without its ends, as a prism: from `base` with radius `r0` to `apex` with radius `r1`.
    fn tube(&mut self, (base, r0): (DVec3, f64), (apex, r1): (DVec3, f64)) {
        let (base, apex) = (y_up(base), y_up(apex));
        let (axis, length) = ((apex - base).normalize(), (apex - base).length());
        let Frame { u, v, .. } = Frame::around(axis);
        let step = std::f64::consts::TAU / f64::from(SIDES);
        // The last side is the first again, to the bit: no gap.
        let around = (0..=SIDES).map(|i| {
            let angle = step * f64::from(i % SIDES);
            libm::cos(angle) * u + libm::sin(angle) * v
        });
        let around: Vec<DVec3> = around.collect();
        let normals: Vec<u32> = around
            .iter()
            .map(|&out| {
                let leaning = length * out + (r0 - r1) * axis;
                self.builder.normal(leaning.normalize())
            })
            .collect();
        for (out, n) in around.windows(2).zip(normals.windows(2)) {
            let ([p, q], [m, n]) = (out, n) else { continue };
            let [a, b] = [base + r0 * p, base + r0 * q];
            let [c, d] = [apex + r1 * q, apex + r1 * p];
            self.builder.smooth([a, b, c], [*m, *n, *n]);
            self.builder.smooth([a, c, d], [*m, *n, *m]);
        }
    }
}

/// Point with z up turned to y up.
fn y_up(p: DVec3) -> DVec3 {
    DVec3::new(p.x, p.z, -p.y)
}

/// The rotation about a unit axis, counter-clockwise seen against it. Source: Rodrigues 1840.
fn turn(axis: DVec3, angle: f64) -> DMat3 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let column = |v: DVec3| cos * v + sin * axis.cross(v) + (1.0 - cos) * axis.dot(v) * axis;
    DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z))
}

/// Geometric sum 1 + base + base^2 + ... + base^last, saturating. The base is at least 2.
fn geometric_sum(base: u64, last: u32) -> u64 {
    (0..=last.min(64)).fold(0u64, |sum, n| sum.saturating_add(base.saturating_pow(n)))
}
