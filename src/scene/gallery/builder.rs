//! Scene built by a program, shape by shape, instead of read from a file.

use std::sync::Arc;

use crate::geometry::{Shape, Triangle};
use crate::math::{DVec3, Rgb};
use crate::scene::{Camera, Object, Scene, Settings};
use crate::shading::{Light, LightKind, Material};

/// Scene in the making: an object is begun, then its shapes are added.
pub struct SceneBuilder {
    scene: Scene,
}

impl SceneBuilder {
    /// An empty scene.
    pub fn new(name: &str, camera: Camera, settings: Settings) -> Self {
        let scene = Scene {
            name: name.to_string(),
            hash: String::new(),
            camera,
            background: Rgb::BLACK,
            ambient: Rgb::BLACK,
            materials: Vec::new(),
            lights: Vec::new(),
            objects: Vec::new(),
            frames: Vec::new(),
            shapes: Vec::new(),
            owners: Vec::new(),
            settings,
            warnings: Vec::new(),
            files: Vec::new(),
            changes: Vec::new(),
        };
        Self { scene }
    }

    /// Sets the background and the ambient light.
    pub fn sky(&mut self, background: Rgb, ambient: Rgb) {
        (self.scene.background, self.scene.ambient) = (background, ambient);
    }

    /// Adds a point light without attenuation.
    pub fn light(&mut self, position: DVec3, intensity: Rgb) {
        self.scene.lights.push(Light {
            name: format!("light {}", self.scene.lights.len() + 1),
            kind: LightKind::Point {
                position,
                intensity,
                attenuation: [1.0, 0.0, 0.0],
            },
        });
    }

    /// Adds a material; its index is what [`SceneBuilder::begin`] takes.
    pub fn material(&mut self, material: Material) -> u32 {
        self.scene.materials.push(material);
        self.scene.materials.len() as u32 - 1
    }

    /// Begins an object: the shapes that follow belong to it.
    pub fn begin(&mut self, name: impl Into<String>, material: u32) {
        self.scene.objects.push(Object {
            name: name.into(),
            material,
            shading: None,
            first_primitive: self.scene.shapes.len() as u32,
            mirrored: false,
            vertices: None,
            instance: false,
            leaves: Vec::new(),
            frame: None,
        });
    }

    /// Adds a shape to the object that was begun last.
    pub fn put(&mut self, shape: Shape) {
        if let Some(last) = self.scene.objects.len().checked_sub(1) {
            self.scene.shapes.push(shape);
            self.scene.owners.push(last as u32);
        }
    }

    /// Adds a flat triangle, its corners counter-clockwise seen from outside.
    pub fn triangle(&mut self, corners: [DVec3; 3]) {
        self.put(Shape::Triangle(Triangle { corners }));
    }

    /// Adds a convex, plane quadrangle as two triangles.
    pub fn quad(&mut self, [a, b, c, d]: [DVec3; 4]) {
        self.triangle([a, b, c]);
        self.triangle([a, c, d]);
    }

    /// Adds a unit normal for corners of the object's triangles; gives its index.
    pub fn normal(&mut self, normal: DVec3) -> u32 {
        let Some(object) = self.scene.objects.last_mut() else {
            return 0;
        };
        let vertices = Arc::make_mut(object.vertices.get_or_insert_default());
        Arc::make_mut(&mut vertices.normals).push(normal);
        vertices.normals.len() as u32 - 1
    }

    /// Adds a triangle with these normals, by index, at its corners. All triangles of one object are smooth, or none.
    pub fn smooth(&mut self, corners: [DVec3; 3], normals: [u32; 3]) {
        self.triangle(corners);
        let vertices = self.scene.objects.last_mut().map(|o| &mut o.vertices);
        if let Some(Some(vertices)) = vertices {
            Arc::make_mut(vertices).normal_indices.push(normals);
        }
    }

    /// The scene, with the hash of all that was added.
    pub fn finish(mut self) -> Scene {
        let mut hash = blake3::Hasher::new();
        let scene = &self.scene;
        let rest = (&scene.name, &scene.camera, &scene.materials, &scene.lights);
        hash.update(format!("{rest:?}").as_bytes());
        for bounds in scene.shapes.iter().filter_map(Shape::bounds) {
            for number in [bounds.min, bounds.max].map(|p| p.to_array()).concat() {
                hash.update(&number.to_le_bytes());
            }
        }
        self.scene.hash = hash.finalize().to_string();
        self.scene
    }
}

/// Material that only scatters light.
pub fn matt(name: &str, color: Rgb) -> Material {
    Material {
        name: name.to_string(),
        ambient: color,
        diffuse: color,
        specular: Rgb::BLACK,
        shininess: 1.0,
        mirror: Rgb::BLACK,
        transmission: Rgb::BLACK,
        ior: 1.0,
        priority: 0,
        emission: Rgb::BLACK,
        checker: None,
    }
}
