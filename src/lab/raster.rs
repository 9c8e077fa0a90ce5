//! Scan conversion, the other way to a picture: triangles are projected onto the screen, and each is filled row by row.
//!
//! Eye rays only: what a picture has by shadow rays, reflection and refraction is not here. Between the corners of a triangle
//! something is blended: the colours of its corners (Gouraud 1971, "Continuous shading of curved surfaces") or their normals
//! (Phong 1975, "Illumination for computer generated pictures"). Of several triangles at a pixel the nearest counts (Catmull
//! 1974, depth buffer). Whether a pixel's middle is inside of a triangle is decided by the tracer's own edge functions, so that
//! both ways see the same triangle at every pixel.

mod projection;
pub(super) mod scanline;
mod shade;
mod table;

pub use scanline::{RowSpan, ScreenBlend};
pub use table::row_table;

use std::fmt;
use std::str::FromStr;

use crate::geometry::{Hit, Intersection, Shear, Triangle};
use crate::math::{DVec3, Interval, Ray, Rgb};
use crate::probe::NONE;
use crate::scene::printable::excerpt;
use crate::scene::{Scene, Settings};
use crate::shading::ShadingModel;
use crate::tracer::Film;
pub(super) use projection::Projection;
use shade::Shade;

/// How triangles are filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Filling {
    /// What is computed at the corners, and what at each pixel; `None` as the settings or the scene say, else by Phong's model.
    pub shading: Option<ShadingModel>,
    /// How what the corners have is blended between them.
    pub blend: ScreenBlend,
}

impl fmt::Display for Filling {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let affine = match self.blend {
            ScreenBlend::Perspective => "",
            ScreenBlend::Affine => ", blended on the screen",
        };
        match self.shading {
            Some(model) => write!(f, "{} shading, row by row{affine}", model.name()),
            None => write!(f, "row by row{affine}"),
        }
    }
}

impl FromStr for Filling {
    type Err = String;

    /// The name of a shading model, and `affine` behind a comma.
    fn from_str(text: &str) -> Result<Self, String> {
        let (name, blend) = match text.split_once(',') {
            Some((name, "affine")) => (name, ScreenBlend::Affine),
            _ => (text, ScreenBlend::Perspective),
        };
        let named = ShadingModel::ALL.into_iter().find(|m| m.word() == name);
        let shading = named.ok_or_else(|| {
            format!(
                "`{}` is no way to fill triangles; there are flat, gouraud and phong, and `,affine` behind them",
                excerpt(text)
            )
        })?;
        Ok(Self {
            shading: Some(shading),
            blend,
        })
    }
}

/// Picture by scan conversion.
pub struct RasterPicture {
    /// The picture.
    pub film: Film,
    /// The triangle at each pixel, by its primitive's id; [`NONE`] where there is the background.
    pub primitives: Vec<u32>,
    /// The spans of the row that was asked for, in the order in which they were filled.
    pub spans: Vec<FilledSpan>,
    /// The primitives that are no triangles and are left out.
    pub left_out: Vec<u32>,
}

/// Span of a triangle in a row of pixels.
#[derive(Clone, Copy, Debug)]
pub struct FilledSpan {
    /// The triangle, by its primitive's id.
    pub primitive: u32,
    /// Its number within its object.
    pub number: u32,
    /// Its ends.
    pub span: RowSpan,
    /// Colours at its ends.
    pub colors: [Rgb; 2],
    /// Pixels whose middle it covers.
    pub covered: u32,
    /// Those of them where nothing nearer had been drawn.
    pub drawn: u32,
}

/// Where the picture is drawn.
struct Canvas<'a> {
    settings: &'a Settings,
    filling: Filling,
    screen: Projection<'a>,
    /// 1 / depth of what is drawn at each pixel.
    nearest: Vec<f64>,
    raster: RasterPicture,
}

/// Draws the triangles of a scene, one after the other, and keeps the spans of row `row`.
pub fn raster(
    scene: &Scene,
    settings: &Settings,
    filling: Filling,
    row: Option<u32>,
) -> RasterPicture {
    let size = (settings.image.width, settings.image.height);
    let mut film = Film::black(size, &Settings::default());
    film.pixels.fill(scene.background);
    let count = film.pixels.len();
    let mut canvas = Canvas {
        settings,
        filling,
        screen: Projection::new(&scene.camera, size),
        nearest: vec![0.0; count],
        raster: RasterPicture {
            film,
            primitives: vec![NONE; count],
            spans: Vec::new(),
            left_out: Vec::new(),
        },
    };
    for (primitive, shape) in (0..).zip(&scene.shapes) {
        if shape.triangle_count() == 0 {
            canvas.raster.left_out.push(primitive);
        }
        for (part, triangle) in (0..).zip(shape.triangles()) {
            let face = ScreenFace {
                primitive,
                part,
                turned: shape.is_mirror_image(),
                triangle,
            };
            canvas.fill(scene, &face, row);
        }
    }
    canvas.raster
}

impl Canvas<'_> {
    /// Fills a triangle row by row.
    fn fill(&mut self, scene: &Scene, face: &ScreenFace, row: Option<u32>) {
        let corners = self.screen.polygon(&face.triangle);
        let Some(rows) = scanline::rows(&corners, self.screen.size.1) else {
            return;
        };
        let model = self.filling.shading;
        let model = model.or(scene.model(face.primitive, self.settings));
        let shade = Shade::new((scene, self.settings), model.unwrap_or_default(), face);
        for y in rows {
            let Some(span) = RowSpan::of(&corners, y, self.filling.blend) else {
                continue;
            };
            let [covered, drawn] = self.fill_row(face, &shade, &span, y);
            if row == Some(y) && covered > 0 {
                let colors = [span.from.x, span.to.x].map(|x| {
                    let ray = self.screen.ray(x, y);
                    shade.color(&ray, span.at(x).weights)
                });
                self.raster.spans.push(FilledSpan {
                    primitive: face.primitive,
                    number: scene.face_of(&face.hit(0.0, [0.0; 3])),
                    span,
                    colors,
                    covered,
                    drawn,
                });
            }
        }
    }

    /// Fills the pixels of a row whose middles are inside of the triangle; gives their number, and how many are nearest.
    fn fill_row(&mut self, face: &ScreenFace, shade: &Shade, span: &RowSpan, y: u32) -> [u32; 2] {
        let (mut covered, mut drawn) = (0, 0);
        for x in span.pixels(self.screen.size.0) {
            let middle = f64::from(x) + 0.5;
            let ray = self.screen.ray(middle, y);
            if !covers(&face.triangle, &ray) {
                continue;
            }
            covered += 1;
            let here = span.at(middle);
            let index = y as usize * self.screen.size.0 as usize + x as usize;
            if here.inverse_depth > self.nearest[index] {
                drawn += 1;
                self.nearest[index] = here.inverse_depth;
                self.raster.primitives[index] = face.primitive;
                self.raster.film.pixels[index] = shade.color(&ray, here.weights);
            }
        }
        [covered, drawn]
    }
}

/// Whether the eye ray through a pixel's middle meets the triangle.
fn covers(triangle: &Triangle, ray: &Ray) -> bool {
    let met = triangle.intersect(&Shear::new(ray), Interval::FORWARD);
    matches!(met, Intersection::Hit { .. })
}

/// Triangle on its way to the screen.
struct ScreenFace {
    primitive: u32,
    /// Its number in a mesh that is kept once.
    part: u32,
    /// True if it is a mirror image whose second and third corner were swapped.
    turned: bool,
    triangle: Triangle,
}

impl ScreenFace {
    /// The hit at a point that is given by the weights of the corners.
    fn hit_at(&self, ray: &Ray, weights: [f64; 3]) -> Hit {
        self.hit(
            (self.point(weights) - ray.origin).dot(ray.direction),
            weights,
        )
    }

    /// The point that is given by the weights of the corners.
    fn point(&self, weights: [f64; 3]) -> DVec3 {
        let [a, b, c] = self.triangle.corners;
        let [u, v, w] = weights;
        u * a + v * b + w * c
    }

    fn hit(&self, t: f64, [u, v, w]: [f64; 3]) -> Hit {
        Hit {
            t,
            primitive: self.primitive,
            part: self.part,
            place: if self.turned { [u, w, v] } else { [u, v, w] },
        }
    }
}
