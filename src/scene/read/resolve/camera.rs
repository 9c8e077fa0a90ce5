//! Camera of a scene file.

use super::checks::{direction, point, positive};
use crate::scene::Camera;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::CameraFile;

/// Camera, if the file gives it a view direction and an up direction.
pub fn camera(file: &CameraFile, path: &FieldPath) -> Result<Camera, SceneError> {
    let eye = point(file.eye, &path.key("eye"))?;
    let look_at = point(file.look_at, &path.key("look_at"))?;
    let up = direction(file.up, &path.key("up"))?;
    let fov = file.vertical_fov;
    if !(fov > 0.0 && fov < 180.0) {
        return Err(path.key("vertical_fov").error(
            format!("a field of view of {fov} degrees is not possible"),
            "write an angle between 0 and 180 degrees; 45 looks natural",
        ));
    }
    if eye == look_at {
        return Err(path.error(
            "`eye` and `look_at` are the same point, so there is no direction to look in",
            "move one of them",
        ));
    }
    let half_height = file.half_height;
    let half_height = half_height.map(|height| positive(height, &path.key("half_height")));
    let half_height = half_height.transpose()?;
    let camera = Camera::new(eye, look_at, up, fov.to_radians()).ok_or_else(|| {
        path.key("up").error(
            "`up` is parallel to the view direction, so nothing says which way is up in the picture",
            "choose another `up`: looking straight down, [0, 0, -1] will do",
        )
    })?;
    Ok(Camera {
        half_height: half_height.unwrap_or(camera.half_height),
        ..camera
    })
}
