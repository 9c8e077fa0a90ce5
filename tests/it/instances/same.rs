//! Uses of a mesh beside its triangles in the world, one by one: the same triangles at the same places.

use raytree::accel::AccelKind;
use raytree::geometry::{Arithmetic, TriangleTest};
use raytree::lab::raster::{Filling, raster};
use raytree::math::Ray;
use raytree::math::rounding::UNIT_ROUNDOFF;
use raytree::probe::Silent;
use raytree::scene::{Scene, flat};
use raytree::shading::ShadingModel;
use raytree::tracer::draw;
use raytree::world::World;

use super::places::{PLACES, in_parts, scene_of, small, written_out};

/// Eye rays of a picture.
fn rays(scene: &Scene, (width, height): (u32, u32)) -> Vec<Ray> {
    let pixels = (0..width * height).map(|i| (i % width, i / width));
    let middle = |(x, y)| [f64::from(x) + 0.5, f64::from(y) + 0.5];
    pixels
        .map(|pixel| scene.camera.ray(middle(pixel), (width, height)))
        .collect()
}

/// What t may differ by: both points are within their errors of the same triangle, and the ray's direction is rounded once more on
/// its way into the mesh.
fn slack(errors: f64, t: f64, cosine: f64) -> f64 {
    (errors + 16.0 * UNIT_ROUNDOFF * t) / cosine.abs().max(1e-12)
}

/// Eye rays, and the rays that are reflected where they arrive.
#[test]
fn rays_meet_the_same_triangles() {
    let [kept, flat] =
        [in_parts(&PLACES), written_out(&PLACES)].map(|s| World::new(s, AccelKind::Wide));
    let (mut all, mut other, mut uses) = (0_u32, 0_u32, 0_u32);
    let mut rays = rays(&kept.scene, (320, 240));
    for bounce in 0..2 {
        let mut next = Vec::new();
        for ray in &rays {
            let [a, b] = [&kept, &flat].map(|world| {
                let hit = world.closest(ray, 0.0, &mut Silent)?;
                let scene = &world.scene;
                let name = scene.object_of(hit.primitive).name.as_str();
                Some((name, scene.face_of(&hit), hit, scene.interaction(ray, &hit)))
            });
            all += 1;
            let (Some((name, face, hit, at)), Some((name_b, face_b, hit_b, at_b))) = (a, b) else {
                other += u32::from(a.is_some() != b.is_some());
                continue;
            };
            if (name, face) != (name_b, face_b) {
                other += 1;
                continue;
            }
            uses += u32::from(kept.scene.object_of(hit.primitive).instance);
            let errors = at.error.length() + at_b.error.length();
            let cosine = at.geometric_normal.dot(ray.direction);
            let off = (hit.t - hit_b.t).abs();
            assert!(
                off <= slack(errors, hit.t, cosine),
                "{name} {face}: {off:e}"
            );
            // Fronts, also of mirror images.
            assert_eq!(at.side, at_b.side, "{name} {face}");
            assert!(at.geometric_normal.distance(at_b.geometric_normal) < 1e-9);
            assert!(at.normal.distance(at_b.normal) < 1e-7, "{name} {face}");
            assert!(at.uv.distance(at_b.uv) < 1e-6, "{name} {face}");
            if bounce == 0 {
                let n = at.normal;
                let away = ray.direction - 2.0 * n.dot(ray.direction) * n;
                next.push(Ray::new(at.origin_towards(away), away.normalize()));
            }
        }
        rays = next;
    }
    assert!(uses > 40_000, "{uses}");
    assert!(
        f64::from(other) <= 1e-4 * f64::from(all),
        "{other} of {all}"
    );
}

#[test]
fn pictures_are_the_same() {
    let [kept, flat] = [in_parts(&PLACES), written_out(&PLACES)];
    let apart = |a: &Scene, b: &Scene, model: Option<ShadingModel>| {
        let settings = small(a, (160, 120)).with(|s| s.shading = model);
        let draw = |scene: &Scene| draw(&World::new(scene.clone(), AccelKind::Wide), &settings, 0);
        let [a, b] = [a, b].map(draw);
        let pairs = a.pixels.iter().zip(&b.pixels);
        let far = pairs.filter(|(a, b)| {
            let channels = a.channels().into_iter().zip(b.channels());
            channels.into_iter().any(|(x, y)| (x - y).abs() > 1e-6)
        });
        far.count()
    };
    // Shadows of meshes on each other and on themselves, reflections, squares of a chessboard; light at the corners of triangles.
    for model in [None, Some(ShadingModel::Flat), Some(ShadingModel::Gouraud)] {
        let far = apart(&kept, &flat, model);
        assert!(far <= 4, "{model:?}: {far}");
    }
    // With another test of triangles, in the mesh as in the world.
    let arithmetic = Arithmetic {
        triangle: TriangleTest::MollerTrumbore,
        ..Arithmetic::default()
    };
    let [kept, flat] = [kept, flat].map(|s| s.computed_with(arithmetic));
    let far = apart(&kept, &flat, None);
    assert!(far <= 8, "{far}");
}

#[test]
fn the_flat_form_is_the_same() {
    let [kept, flat] = [in_parts(&PLACES), written_out(&PLACES)];
    let mut pairs = flat::objects(&kept).zip(flat::objects(&flat));
    assert!(pairs.all(|(a, b)| a == b));
    assert_eq!(flat::objects(&kept).count(), flat::objects(&flat).count());
    assert!(flat::check_text(&kept).is_ok());
}

#[test]
fn scan_conversion_sees_the_same() {
    let [kept, flat] = [in_parts(&PLACES), written_out(&PLACES)];
    let settings = small(&kept, (160, 120));
    let [a, b] = [&kept, &flat].map(|s| raster(s, &settings, Filling::default(), Some(60)));
    assert!(a.left_out.is_empty());
    let numbers = |r: &raytree::lab::raster::RasterPicture| -> Vec<u32> {
        r.spans.iter().map(|s| s.number).collect()
    };
    assert_eq!(numbers(&a), numbers(&b));
    for (a, b) in a.film.pixels.iter().zip(&b.film.pixels) {
        for (x, y) in a.channels().into_iter().zip(b.channels()) {
            assert!((x - y).abs() < 1e-9, "{a:?} {b:?}");
        }
    }
}

/// The same at every size: the picture of a scene that is scaled as a whole.
#[test]
fn sizes_change_nothing() {
    let at = |size: f64| {
        let used = format!(
            r#"{{"use": {{"name": "u", "part": "p", "transform": [{{"rotate": {{"axis": [0, 1, 0], "degrees": 30}}}}, {{"scale": {size}}}]}}}}"#
        );
        let part = r#""p": [{"obj": {"name": "pot", "material": "clay", "file": "teapot.obj"}}]"#;
        let mut scene = scene_of(part, &used).expect("a scene");
        assert!(scene.objects[0].instance);
        scene.camera.eye *= size;
        let rays = rays(&scene, (120, 90));
        let world = World::new(scene, AccelKind::Bsp);
        let hit = |ray: &Ray| {
            let hit = world.closest(ray, 0.0, &mut Silent)?;
            let at = world.scene.interaction(ray, &hit);
            // A ray that leaves does not come back at once.
            let away = Ray::new(at.origin_towards(at.normal), at.geometric_normal);
            if let Some(again) = world.closest(&away, 0.0, &mut Silent) {
                assert!(again.part != hit.part && again.t > 1e-9 * size);
            }
            Some((hit.part, hit.t / size))
        };
        rays.iter().map(hit).collect::<Vec<_>>()
    };
    let [small, plain, large] = [1e-4, 1.0, 1e4].map(at);
    assert!(plain.iter().flatten().count() > 800);
    for other in [small, large] {
        let pairs = other.iter().zip(&plain);
        let differ = pairs.filter(|(a, b)| match (a, b) {
            (Some((p, t)), Some((q, s))) => {
                assert!(p != q || (t - s).abs() < 1e-9 * s, "{t} {s}");
                p != q
            }
            (a, b) => a.is_some() != b.is_some(),
        });
        assert!(differ.count() <= 1);
    }
}
