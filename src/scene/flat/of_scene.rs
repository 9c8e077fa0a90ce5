//! From a scene to its flat form.

mod csg;

use super::body::{of_body, rows};
use super::{
    FlatCamera, FlatChecker, FlatFormat, FlatLight, FlatMaterial, FlatObject, FlatScene,
    FlatSettings,
};
use crate::geometry::{Body, Hit, Polygon, Shape, SurfacePatch};
use crate::math::{DVec3, Frame, Transform};
use crate::scene::file::Triple;
use crate::scene::{Object, Scene};
use crate::shading::{Area, Light, LightKind, Material, ShadingModel};

/// The flat scene but for its objects, of which there may be millions: see [`objects`].
pub fn head(scene: &Scene) -> FlatScene {
    let (settings, camera) = (&scene.settings, &scene.camera);
    let Frame { u, v, w } = camera.frame;
    FlatScene {
        format: FlatFormat::V1,
        name: scene.name.clone(),
        settings: FlatSettings {
            depth: settings.recursion.depth,
            min_weight: settings.recursion.min_weight,
            fresnel: settings.fresnel,
            exposure: settings.image.exposure,
        },
        background: scene.background,
        ambient: scene.ambient,
        camera: FlatCamera {
            eye: camera.eye.to_array(),
            u: u.to_array(),
            v: v.to_array(),
            w: w.to_array(),
            half_height: camera.half_height,
            vertical_fov: (2.0 * libm::atan(camera.half_height)).to_degrees(),
        },
        materials: scene.materials.iter().map(material).collect(),
        lights: scene.lights.iter().map(|l| light(scene, l)).collect(),
        objects: Vec::new(),
    }
}

/// The shapes of a scene, in its order. A mesh that is kept once stands there as its triangles, as often as it is used: see
/// [`Scene::check_faces`].
pub fn objects(scene: &Scene) -> impl Iterator<Item = FlatObject> {
    (0..scene.shapes.len() as u32).flat_map(move |primitive| {
        let shape = &scene.shapes[primitive as usize];
        let faces = shape.mesh().map_or(1, |_| shape.triangle_count());
        (0..faces).filter_map(move |part| {
            let hit = Hit {
                t: 0.0,
                primitive,
                part,
                place: [0.0; 3],
            };
            let about = About {
                scene,
                object: scene.object_of(primitive),
                name: &scene.object_of(primitive).name,
                material: scene.material_of(primitive),
                hit,
                local: scene.face_of(&hit),
            };
            match shape.mesh() {
                Some(_) => about.shape(&Shape::Triangle(shape.triangle(part)?), None),
                None => about.shape(shape, None),
            }
        })
    })
}

fn material(m: &Material) -> FlatMaterial {
    FlatMaterial {
        name: m.name.clone(),
        ambient: m.ambient,
        diffuse: m.diffuse,
        specular: m.specular,
        shininess: m.shininess,
        mirror: m.mirror,
        transmission: m.transmission,
        ior: m.ior,
        priority: m.priority,
        emission: m.emission,
        checker: m.checker.map(|checker| FlatChecker {
            diffuse: checker.diffuse,
            ambient: checker.ambient,
            size: checker.size,
        }),
    }
}

fn light(scene: &Scene, light: &Light) -> FlatLight {
    let name = light.name.clone();
    match &light.kind {
        LightKind::Point {
            position,
            intensity,
            attenuation,
        } => FlatLight::Point {
            name,
            position: position.to_array(),
            intensity: *intensity,
            attenuation: *attenuation,
        },
        LightKind::Directional {
            direction,
            intensity,
        } => FlatLight::Directional {
            name,
            direction: direction.to_array(),
            intensity: *intensity,
        },
        LightKind::Spot {
            position,
            direction,
            intensity,
            attenuation,
            cos_cutoff,
            exponent,
        } => FlatLight::Spot {
            name,
            position: position.to_array(),
            direction: direction.to_array(),
            intensity: *intensity,
            attenuation: *attenuation,
            cos_cutoff: *cos_cutoff,
            exponent: *exponent,
        },
        LightKind::Area(area) => FlatLight::Area {
            name,
            object: shining(scene, area)
                .map_or_else(String::new, |o| scene.objects[o as usize].name.clone()),
        },
    }
}

/// The number of the object whose surface an area light is: that of which the same light would be made.
pub fn shining(scene: &Scene, area: &Area) -> Option<u32> {
    let mut objects = (0..).zip(&scene.objects);
    let found = objects.find(|(index, object)| {
        let emission = scene.materials[object.material as usize].emission;
        emission == area.radiance
            && Area::new(scene.shapes_of(*index), emission).as_ref() == Some(area)
    });
    found.map(|(index, _)| index)
}

/// What a shape belongs to.
struct About<'s> {
    scene: &'s Scene,
    object: &'s Object,
    /// The name of the object, or of a part of it.
    name: &'s str,
    material: &'s Material,
    /// Where it stands in the scene.
    hit: Hit,
    /// Its number within the object.
    local: u32,
}

impl About<'_> {
    /// A shape, in its own space if there is a way `to_world` from there that it does not survive.
    fn shape(&self, shape: &Shape, to_world: Option<&Transform>) -> Option<FlatObject> {
        let name = self.name.to_owned();
        let material = self.material.name.clone();
        Some(match shape {
            Shape::Triangle(triangle) => FlatObject::Triangle {
                name,
                primitive: self.local,
                corners: triangle.corners.map(|c| carried(c, to_world).to_array()),
                normals: self.normals(),
                shading: self.object.shading.filter(|m| *m == ShadingModel::Gouraud),
                uvs: self.material.checker.map(|_| self.uvs()),
                material,
            },
            Shape::Sphere(sphere) => FlatObject::Sphere {
                name,
                center: sphere.center.to_array(),
                radius: sphere.radius,
                to_world: to_world.map(rows),
                material,
            },
            Shape::Plane(plane) => {
                let point = carried(plane.origin(), to_world);
                let normal = to_world.map_or(plane.normal(), |map| map.normal(plane.normal()));
                FlatObject::Plane {
                    name,
                    point: point.to_array(),
                    normal: normal.to_array(),
                    axes: self.axes(&Frame::around(normal)),
                    material,
                }
            }
            Shape::Cuboid(cuboid) => FlatObject::Box {
                name,
                min: cuboid.bounds.min.to_array(),
                max: cuboid.bounds.max.to_array(),
                to_world: to_world.map(rows),
                material,
            },
            Shape::Polygon(polygon) => FlatObject::Polygon {
                name,
                primitive: self.local,
                loops: loops(polygon),
                axes: self.axes(&Frame::around(polygon.normal())),
                material,
            },
            Shape::Patch(patch) => of_patch(patch, name, self.local, material),
            Shape::Body(body) => match &**body {
                Body::Csg(csg) => self.csg(csg),
                body => of_body(body, name, material, to_world),
            },
            Shape::Disc(disc) => FlatObject::Disc {
                name,
                center: disc.center.to_array(),
                normal: disc.frame.w.to_array(),
                radius: disc.radius,
                axes: self.axes(&disc.frame),
                to_world: to_world.map(rows),
                material,
            },
            Shape::Transformed(moved) => self.shape(&moved.shape, Some(&moved.transform))?,
            // How it is tested is no part of the scene.
            Shape::Naive(naive) => self.shape(&naive.shape, to_world)?,
            // It stands there as its triangles.
            Shape::Mesh(_) => return None,
        })
    }

    /// Normals at the corners of a smooth triangle; none where the model is flat.
    fn normals(&self) -> Option<[Triple; 3]> {
        if self.object.shading == Some(ShadingModel::Flat) {
            return None;
        }
        let normals = self.scene.corner_normals(&self.hit)?;
        Some(self.turned(normals.map(|n| n.to_array())))
    }

    /// What the corners of a triangle have, in the order in which it has them in the world.
    fn turned<T>(&self, [a, b, c]: [T; 3]) -> [T; 3] {
        let shape = &self.scene.shapes[self.hit.primitive as usize];
        if shape.is_mirror_image() {
            [a, c, b]
        } else {
            [a, b, c]
        }
    }

    /// Surface coordinates at the corners of a triangle; without its own they are the weights of b and c.
    fn uvs(&self) -> [[f64; 2]; 3] {
        let own = self.object.vertices.as_ref().and_then(|data| {
            let corners = data.uv_indices.get(self.local as usize)?;
            Some(corners.map(|i| data.uvs[i as usize].to_array()))
        });
        self.turned(own.unwrap_or([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))
    }

    /// Where u and v run, if it can be seen.
    fn axes(&self, frame: &Frame) -> Option<[Triple; 2]> {
        let axes = [frame.u.to_array(), frame.v.to_array()];
        self.material.checker.map(|_| axes)
    }
}

fn carried(point: DVec3, to_world: Option<&Transform>) -> DVec3 {
    to_world.map_or(point, |map| map.point(point))
}

fn loops(polygon: &Polygon) -> Vec<Vec<Triple>> {
    let corners = |corners: &[DVec3]| corners.iter().map(DVec3::to_array).collect();
    polygon.loops().map(corners).collect()
}

/// A leaf of a parametric surface, number `primitive` of its object.
fn of_patch(patch: &SurfacePatch, name: String, primitive: u32, material: String) -> FlatObject {
    let width = patch.degree()[0] + 1;
    let (points, weights): (Vec<DVec3>, Vec<f64>) = patch.control_points().unzip();
    let row = |row: &[DVec3]| row.iter().map(DVec3::to_array).collect();
    FlatObject::Bezier {
        name,
        primitive,
        points: points.chunks(width).map(row).collect(),
        weights: weights.chunks(width).map(<[f64]>::to_vec).collect(),
        range: patch.range(),
        material,
    }
}
