//! A vessel of glass with water and a bubble in it, made of solids that know what is inside of them.

use raytree::math::DVec3;

use super::support::Mesh;

/// How the solids of a vessel are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Make {
    Sphere,
    Box,
    Globe,
}

/// A solid around (0, y, 0): its half size, and the priority of its material.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    pub name: &'static str,
    pub ior: f64,
    pub priority: i32,
    pub half: f64,
    pub y: f64,
}

/// Glass with a hollow, water in it that reaches `overlap` into the wall, and a bubble of air in the water.
pub fn vessel(overlap: f64) -> [Solid; 4] {
    let solid = |name, ior, priority, half, y| Solid {
        name,
        ior,
        priority,
        half,
        y,
    };
    [
        solid("glass", 1.5, 1, 1.0, 0.0),
        solid("hollow", 1.0, 2, 0.8, 0.0),
        solid("water", 1.33, 3, 0.8 + overlap, 0.0),
        solid("bubble", 1.0, 4, 0.3, 0.2),
    ]
}

impl Solid {
    pub fn object(&self, make: Make) -> String {
        let Self {
            name, half: r, y, ..
        } = self;
        let head = format!(r#""name": "{name}", "material": "{name}""#);
        match make {
            Make::Sphere => {
                format!(r#"{{"sphere": {{{head}, "center": [0, {y}, 0], "radius": {r}}}}}"#)
            }
            Make::Box => {
                let (low, high) = (y - r, y + r);
                format!(
                    r#"{{"box": {{{head}, "min": [-{r}, {low}, -{r}], "max": [{r}, {high}, {r}]}}}}"#
                )
            }
            Make::Globe => {
                let Mesh { points, faces } = self.globe();
                let points: Vec<[f64; 3]> = points.iter().map(DVec3::to_array).collect();
                format!(r#"{{"mesh": {{{head}, "vertices": {points:?}, "triangles": {faces:?}}}}}"#)
            }
        }
    }

    /// A globe of triangles, convex.
    pub fn globe(&self) -> Mesh {
        Mesh::globe(7, 12, 0.0).moved(|p| self.half * p + self.y * DVec3::Y)
    }

    pub fn material(&self) -> String {
        let Self {
            name,
            ior,
            priority,
            ..
        } = self;
        format!(r#""{name}": {{"transmission": [1, 1, 1], "ior": {ior}, "priority": {priority}}}"#)
    }
}

/// A solid with what tells whether a point is inside.
pub struct Body {
    pub solid: Solid,
    pub make: Make,
    /// Of a globe, the plane of every face: a point on it and its normal.
    pub faces: Vec<(DVec3, DVec3)>,
}

impl Body {
    pub fn new(solid: Solid, make: Make) -> Self {
        let globe = solid.globe();
        let plane = |face| {
            let [a, b, c] = globe.corners(face);
            (a, (b - a).cross(c - a).normalize())
        };
        Self {
            solid,
            make,
            faces: (0..globe.faces.len()).map(plane).collect(),
        }
    }

    /// Whether a point is inside; `None` if it is too near to the surface for simple arithmetic to tell.
    pub fn contains(&self, p: DVec3) -> Option<bool> {
        let local = p - self.solid.y * DVec3::Y;
        let depth = match self.make {
            Make::Sphere => self.solid.half - local.length(),
            Make::Box => self.solid.half - local.abs().max_element(),
            // Behind the planes of all faces.
            Make::Globe => {
                let behind = self.faces.iter().map(|(a, normal)| normal.dot(a - p));
                behind.fold(f64::INFINITY, f64::min)
            }
        };
        (depth.abs() > 1e-9).then_some(depth > 0.0)
    }
}
