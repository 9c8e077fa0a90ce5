//! Camera that has nothing in its picture.

use super::Checked;
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;
use crate::scene::warning::{WarningCode, Warnings};

/// Warns if every shape lies wholly outside of the pyramid of view.
pub fn check(checked: &Checked, warnings: &mut Warnings) {
    let scene = &checked.world.scene;
    let pyramid = Pyramid::new(checked);
    if scene.shapes.is_empty() || scene.shapes.iter().any(|shape| pyramid.may_show(shape)) {
        return;
    }
    let bounds = (0..scene.objects.len() as u32)
        .map(|object| scene.shapes_of(object))
        .map(|shapes| shapes.iter().filter_map(Shape::bounds))
        .map(|boxes| boxes.fold(Aabb::EMPTY, Aabb::union));
    let numbers = |p: DVec3| {
        let [x, y, z] = p.to_array().map(|c| (c * 1e4).round() / 1e4);
        format!("[{x}, {y}, {z}]")
    };
    let cure = match bounds.into_iter().position(|bounds| !bounds.is_empty()) {
        Some(object) => {
            let boxes = scene
                .shapes_of(object as u32)
                .iter()
                .filter_map(Shape::bounds);
            let middle = boxes.fold(Aabb::EMPTY, Aabb::union).center();
            format!(
                "look at `{}`: \"look_at\": {}",
                scene.objects[object].name,
                numbers(middle)
            )
        }
        None => "turn the camera around".to_owned(),
    };
    let what = "no object is in the picture: it shows the background alone";
    let path = checked.path.key("camera");
    warnings.add(WarningCode::NothingInView, path.error(what, cure));
}

/// All that the rays of the picture can meet: the part of space between four planes through the eye.
struct Pyramid {
    eye: DVec3,
    /// Directions of the edges.
    edges: [DVec3; 4],
    /// Normals of the sides, inwards.
    sides: [DVec3; 4],
}

impl Pyramid {
    fn new(checked: &Checked) -> Self {
        let (camera, settings) = (&checked.world.scene.camera, checked.settings);
        let (width, height) = settings.size();
        // Samples may lie outside of their pixel; and a little more, for rounding.
        let more = settings.pixel.filter_radius + 1.0;
        let (right, bottom) = (f64::from(width) + more, f64::from(height) + more);
        let corners = [
            [-more, -more],
            [right, -more],
            [right, bottom],
            [-more, bottom],
        ];
        let edges = corners.map(|film| camera.ray(film, (width, height)).direction);
        let ahead = -camera.frame.w;
        let sides = std::array::from_fn(|i| {
            let side = edges[i].cross(edges[(i + 1) % 4]);
            if side.dot(ahead) < 0.0 { -side } else { side }
        });
        Self {
            eye: camera.eye,
            edges,
            sides,
        }
    }

    /// False if a ray of the picture cannot meet the shape, for sure.
    fn may_show(&self, shape: &Shape) -> bool {
        if let Shape::Plane(plane) = shape.plain() {
            // A ray meets it if it runs towards its side.
            let side = (self.eye - plane.origin()).dot(plane.normal());
            return self
                .edges
                .iter()
                .any(|d| d.dot(plane.normal()) * side <= 0.0);
        }
        let Some(bounds) = shape.bounds() else {
            return true;
        };
        let corners = bounds.corners().map(|corner| corner - self.eye);
        let outside = |side: &DVec3| corners.iter().all(|corner| corner.dot(*side) < 0.0);
        !self.sides.iter().any(outside)
    }
}
