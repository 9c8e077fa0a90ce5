//! Parametric patches as triangles, to see what that costs: in accuracy, since they are flat, and in number.
//!
//! Leaves of a surface that are cut alike meet at the same points but for rounding; where one is cut twice as often as its
//! neighbour, a corner stands in the middle of an edge, and rays slip through. That is what the exact test is for.

use std::sync::Arc;

use super::limits::MAX_PRIMITIVES;
use super::{Object, Scene, VertexData};
use crate::geometry::{Shape, SurfacePatch, Triangle};
use crate::math::{DVec2, DVec3};

/// How many squares along u and v each leaf of a patch has if so many are wanted: no more than a scene has room for.
pub fn squares_that_fit(scene: &Scene, wanted: u32) -> u32 {
    let leaves = scene.shapes.iter().filter(|shape| is_patch(shape)).count();
    if leaves == 0 {
        return wanted;
    }
    let room = MAX_PRIMITIVES.saturating_sub(scene.shapes.len()) / (2 * leaves);
    wanted.min((room as u32).isqrt()).max(1)
}

fn is_patch(shape: &Shape) -> bool {
    matches!(shape.plain(), Shape::Patch(_))
}

/// The scene with each leaf of a patch as `squares` x `squares` x 2 triangles, or as many as fit.
pub fn tessellated(mut scene: Scene, squares: u32) -> Scene {
    if !scene.shapes.iter().any(is_patch) {
        return scene;
    }
    let squares = squares_that_fit(&scene, squares);
    let old = std::mem::take(&mut scene.shapes);
    let mut left = old.into_iter();
    let ends: Vec<usize> = {
        let starts = scene.objects.iter().skip(1).map(|o| o.first_primitive);
        starts
            .map(|s| s as usize)
            .chain([scene.owners.len()])
            .collect()
    };
    scene.owners.clear();
    let mut taken = 0;
    for (number, (object, end)) in scene.objects.iter_mut().zip(ends).enumerate() {
        let own: Vec<Shape> = left.by_ref().take(end - taken).collect();
        taken = end;
        object.first_primitive = scene.shapes.len() as u32;
        // All shapes of an object are of one kind.
        if own.first().is_some_and(is_patch) {
            scene.shapes.extend(triangles(&own, squares, object));
        } else {
            scene.shapes.extend(own);
        }
        scene.owners.resize(scene.shapes.len(), number as u32);
    }
    scene
}

/// The triangles of some leaves, without their normals.
pub fn triangles_of(leaves: &[SurfacePatch], squares: u32) -> Vec<Shape> {
    let mut grid = Grid::default();
    for leaf in leaves {
        grid.add(leaf, squares);
    }
    grid.triangles
}

/// The triangles of an object's leaves; the object gets their normals and texture coordinates.
fn triangles(leaves: &[Shape], squares: u32, object: &mut Object) -> Vec<Shape> {
    let mut grid = Grid::default();
    for leaf in leaves {
        if let Shape::Patch(patch) = leaf.plain() {
            grid.add(patch, squares);
        }
    }
    object.vertices = Some(Arc::new(VertexData {
        normal_indices: grid.corners.clone(),
        normals: Arc::new(grid.normals),
        uv_indices: grid.corners,
        uvs: Arc::new(grid.uvs),
        of_surface: true,
    }));
    grid.triangles
}

/// Points on leaves, and the triangles between them.
#[derive(Default)]
struct Grid {
    points: Vec<DVec3>,
    normals: Vec<DVec3>,
    uvs: Vec<DVec2>,
    corners: Vec<[u32; 3]>,
    triangles: Vec<Shape>,
}

impl Grid {
    fn add(&mut self, patch: &SurfacePatch, squares: u32) {
        let first = self.points.len() as u32;
        let place = |i: u32| f64::from(i) / f64::from(squares);
        for j in 0..=squares {
            for i in 0..=squares {
                let at = patch.surface([place(i), place(j)]);
                self.points.push(at.point);
                self.normals.push(at.normal);
                self.uvs.push(at.uv);
            }
        }
        let number = |i: u32, j: u32| first + j * (squares + 1) + i;
        for j in 0..squares {
            for i in 0..squares {
                let [a, b, c, d] =
                    [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(u, v)| number(i + u, j + v));
                self.add_triangle([a, b, c]);
                self.add_triangle([a, c, d]);
            }
        }
    }

    /// Adds a triangle, unless two corners are one point, as where an edge has collapsed.
    fn add_triangle(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners.map(|i| self.points[i as usize]);
        if a == b || b == c || c == a {
            return;
        }
        self.corners.push(corners);
        self.triangles
            .push(Shape::Triangle(Triangle { corners: [a, b, c] }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::AccelKind;
    use crate::geometry::{Arithmetic, PatchMethod};
    use crate::probe::Silent;
    use crate::scene::effects::effects;
    use crate::scene::{Effect, load};
    use crate::world::World;

    fn with(squares: u32) -> Scene {
        let scene = load("teapot-patches").expect("a scene");
        scene.computed_with(Arithmetic {
            patch: PatchMethod::Triangles(squares),
            ..Arithmetic::OURS
        })
    }

    #[test]
    fn objects_keep_their_shapes_and_nothing_else_changes() {
        let exact = load("teapot-patches").expect("a scene");
        let flat = with(3);
        for (number, (before, after)) in (0..).zip(exact.objects.iter().zip(&flat.objects)) {
            let (old, new) = (exact.shapes_of(number), flat.shapes_of(number));
            let leaves = old.iter().filter(|s| matches!(s, Shape::Patch(_))).count();
            assert_eq!(before.name, after.name);
            if leaves == 0 {
                assert_eq!(old.len(), new.len());
                continue;
            }
            let all = 18 * leaves;
            assert!(
                new.len() <= all && new.len() > all * 9 / 10,
                "{}",
                new.len()
            );
            assert!(new.iter().all(|s| matches!(s, Shape::Triangle(_))));
            let owned = flat.owners.iter().filter(|o| **o == number).count();
            assert_eq!(owned, new.len());
        }
        assert_eq!(flat.owners.len(), flat.shapes.len());
    }

    /// The chord of a curve is off it by the square of its length: twice as many squares, a quarter of the distance. So it is with
    /// blended normals, though no mesh of the scene calls for them.
    #[test]
    fn points_and_normals_come_nearer_with_the_square_of_the_number() {
        let scene = load("teapot-patches").expect("a scene");
        let (size, called_for) = ((80, 60), effects(&scene));
        assert!(!called_for.has(Effect::Smooth));
        let exact = World::new(scene, AccelKind::default());
        let seen = |world: &World, at: (u32, u32)| {
            let film = [f64::from(at.0) + 0.5, f64::from(at.1) + 0.5];
            let ray = world.scene.camera.ray(film, size);
            let hit = world.closest(&ray, 0.0, &mut Silent)?;
            let point = world.scene.interaction(&ray, &hit);
            let shape = &world.scene.shapes[hit.primitive as usize];
            let is_pot = matches!(shape, Shape::Patch(_) | Shape::Triangle(_));
            let mut flat = None;
            let shaded = world.scene.shaded((&hit, &point), called_for, &mut flat);
            is_pot.then_some((hit.t, shaded.normal))
        };
        let pixels = || (0..size.0 * size.1).map(|i| (i % size.0, i / size.0));
        let median_gaps = |squares: u32| {
            let world = World::new(with(squares), AccelKind::default());
            let pairs = pixels().filter_map(|at| Some((seen(&exact, at)?, seen(&world, at)?)));
            let gaps = pairs.map(|((t, n), (u, m))| [(t - u).abs(), (n - m).length()]);
            let gaps: Vec<[f64; 2]> = gaps.collect();
            assert!(gaps.len() > 500, "{}", gaps.len());
            [0, 1].map(|of| {
                let mut sorted: Vec<f64> = gaps.iter().map(|gap| gap[of]).collect();
                sorted.sort_by(f64::total_cmp);
                sorted[sorted.len() / 2]
            })
        };
        let gaps = [2, 4, 8, 16].map(median_gaps);
        for pair in gaps.windows(2) {
            for of in [0, 1] {
                let ratio = pair[0][of] / pair[1][of];
                assert!((3.0..5.0).contains(&ratio), "{gaps:?}");
            }
        }
    }

    #[test]
    fn there_are_no_more_squares_than_a_scene_has_room_for() {
        let scene = load("teapot-patches").expect("a scene");
        assert_eq!(squares_that_fit(&scene, 16), 16);
        let most = squares_that_fit(&scene, 64);
        assert!(most < 64, "{most}");
        let shapes = with(64).shapes.len();
        assert!(shapes <= MAX_PRIMITIVES, "{shapes}");
        assert!(shapes > MAX_PRIMITIVES * 9 / 10, "{shapes}");
    }
}
