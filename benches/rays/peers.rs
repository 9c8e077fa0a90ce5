//! Other crates that find hits, each used as its documentation says, in single precision.

use std::time::Duration;

use bvh::aabb::{Aabb as BvhBox, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use glam::Vec3A;
use kdtree_ray::{AABB as KdBox, Bounded as KdBounded, KDTree};
use nalgebra::{Point3, Vector3};
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray as Ray32, RayHit};
use obvhs::triangle::Triangle as Triangle32;
use parry3d::query::RayCast;
use parry3d::shape::TriMesh;
use raytree::geometry::Triangle;

use super::sent::Sent;

/// The crates: the first is what all others are compared with.
pub const NAMES: [&str; 5] = ["obvhs BVH2", "obvhs CWBVH", "parry3d", "bvh", "kdtree-ray"];

/// One crate's structure over some triangles.
pub enum Peer {
    /// obvhs 0.4, binary, medium build.
    Bvh2(Bvh2, Vec<Triangle32>),
    /// obvhs 0.4, eight children in 80 bytes, medium build.
    CwBvh(CwBvh, Vec<Triangle32>),
    /// parry3d 0.31.
    Parry(Box<TriMesh>),
    /// bvh 0.13: yields the shapes whose boxes are met, in no order.
    Bvh(Bvh<f32, 3>, Vec<Boxed>),
    /// kdtree-ray 1.2: returns the shapes whose cells are met, in no order.
    Kd(KDTree, Vec<Boxed>),
}

/// A triangle for the crates that know only boxes.
pub struct Boxed {
    triangle: Triangle32,
    node: usize,
}

impl Boxed {
    fn corners(&self) -> [Vec3A; 2] {
        let Triangle32 { v0, v1, v2 } = self.triangle;
        [v0.min(v1).min(v2), v0.max(v1).max(v2)]
    }
}

impl Bounded<f32, 3> for Boxed {
    fn aabb(&self) -> BvhBox<f32, 3> {
        let [min, max] = self.corners().map(|p| Point3::new(p.x, p.y, p.z));
        BvhBox::with_bounds(min, max)
    }
}

impl BHShape<f32, 3> for Boxed {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl KdBounded for Boxed {
    fn bound(&self) -> KdBox {
        let [min, max] = self.corners().map(|p| cgmath::Vector3::new(p.x, p.y, p.z));
        KdBox::new(min, max)
    }
}

impl Peer {
    /// Builds the structure of the crate of this name.
    pub fn build(name: &str, triangles: &[Triangle]) -> Self {
        let corner = |p: raytree::math::DVec3| Vec3A::from(p.as_vec3());
        let mut single: Vec<Triangle32> = triangles
            .iter()
            .map(|t| {
                let [v0, v1, v2] = t.corners.map(corner);
                Triangle32 { v0, v1, v2 }
            })
            .collect();
        let params = BvhBuildParams::medium_build();
        let boxed = |single: Vec<Triangle32>| {
            let boxed = |triangle| Boxed { triangle, node: 0 };
            single.into_iter().map(boxed).collect::<Vec<_>>()
        };
        // In the order of the leaves, so that a leaf's triangles lie next to each other.
        let sorted = |single: &[Triangle32], order: &[u32]| {
            order.iter().map(|&i| single[i as usize]).collect()
        };
        match name {
            "obvhs BVH2" => {
                let tree = build_bvh2_from_tris(&single, params, &mut Duration::default());
                let leaves = sorted(&single, &tree.primitive_indices);
                Self::Bvh2(tree, leaves)
            }
            "obvhs CWBVH" => {
                let tree = build_cwbvh_from_tris(&single, params, &mut Duration::default());
                let leaves = sorted(&single, &tree.primitive_indices);
                Self::CwBvh(tree, leaves)
            }
            "parry3d" => {
                let point = |p: Vec3A| parry3d::math::Vector::new(p.x, p.y, p.z);
                let corners = |t: Triangle32| [t.v0, t.v1, t.v2].map(point);
                let corners: Vec<_> = single.drain(..).flat_map(corners).collect();
                let count = corners.len() as u32 / 3;
                let faces = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
                let mesh = TriMesh::new(corners, faces.collect());
                Self::Parry(Box::new(mesh.expect("at least one triangle")))
            }
            "bvh" => {
                let mut shapes = boxed(single);
                Self::Bvh(Bvh::build(&mut shapes), shapes)
            }
            _ => {
                let shapes = boxed(single);
                Self::Kd(KDTree::build(&shapes), shapes)
            }
        }
    }

    /// A run over some rays, which are brought into the crate's own form beforehand: how many of them hit.
    pub fn run<'a>(&'a self, rays: &'a [Sent], any: bool) -> Box<dyn Fn() -> usize + 'a> {
        let single: Vec<Ray32> = rays.iter().map(single).collect();
        match self {
            Self::Bvh2(tree, triangles) => Box::new(move || {
                let test = |ray: &Ray32, id: usize| triangles[id].intersect(ray);
                count(&single, |&ray| {
                    if any {
                        return !tree.ray_traverse_miss(ray, test);
                    }
                    let mut hit = RayHit::none();
                    tree.ray_traverse(ray, &mut hit, test);
                    hit.t < ray.tmax
                })
            }),
            Self::CwBvh(tree, triangles) => Box::new(move || {
                let test = |ray: &Ray32, id: usize| triangles[id].intersect(ray);
                count(&single, |&ray| {
                    if any {
                        return !tree.ray_traverse_miss(ray, test);
                    }
                    tree.ray_traverse(ray, &mut RayHit::none(), test)
                })
            }),
            Self::Parry(mesh) => {
                let to = |p: Vec3A| parry3d::math::Vector::new(p.x, p.y, p.z);
                let rays: Vec<_> = single
                    .iter()
                    .map(|r| {
                        (
                            parry3d::query::Ray::new(to(r.origin), to(r.direction)),
                            r.tmax,
                        )
                    })
                    .collect();
                Box::new(move || {
                    let hits = |(ray, end): &&(parry3d::query::Ray, f32)| {
                        mesh.cast_local_ray(ray, end.min(f32::MAX), false).is_some()
                    };
                    rays.iter().filter(hits).count()
                })
            }
            Self::Bvh(tree, shapes) => {
                let own = |r: &Ray32| {
                    let origin = Point3::new(r.origin.x, r.origin.y, r.origin.z);
                    let direction = Vector3::new(r.direction.x, r.direction.y, r.direction.z);
                    (bvh::ray::Ray::new(origin, direction), *r)
                };
                let rays: Vec<_> = single.iter().map(own).collect();
                Box::new(move || {
                    count(&rays, |(own, ray)| {
                        let met = tree.traverse_iterator(own, shapes);
                        closest(ray, any, met.map(|boxed| &boxed.triangle))
                    })
                })
            }
            Self::Kd(tree, shapes) => {
                let vector = |p: Vec3A| cgmath::Vector3::new(p.x, p.y, p.z);
                let own = |r: &Ray32| (vector(r.origin), vector(r.direction), *r);
                let rays: Vec<_> = single.iter().map(own).collect();
                Box::new(move || {
                    count(&rays, |(origin, direction, ray)| {
                        let met = tree.intersect(origin, direction);
                        closest(ray, any, met.into_iter().map(|id| &shapes[id].triangle))
                    })
                })
            }
        }
    }
}

fn single((ray, interval): &Sent) -> Ray32 {
    Ray32::new(
        ray.origin.as_vec3().into(),
        ray.direction.as_vec3().into(),
        interval.min as f32,
        interval.max as f32,
    )
}

fn count<T>(rays: &[T], hits: impl Fn(&T) -> bool) -> usize {
    rays.iter().filter(|ray| hits(ray)).count()
}

/// Whether one of the triangles is hit; all are asked unless any hit will do.
fn closest<'a>(ray: &Ray32, any: bool, triangles: impl Iterator<Item = &'a Triangle32>) -> bool {
    let mut ray = *ray;
    let end = ray.tmax;
    for triangle in triangles {
        ray.tmax = ray.tmax.min(triangle.intersect(&ray));
        if any && ray.tmax < end {
            return true;
        }
    }
    ray.tmax < end
}
