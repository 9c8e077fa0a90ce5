//! Transparency in MTL files: `d`, `Tr`, `Tf` and the models of illumination.

use raytree::math::Rgb;

use super::{RED, grey, material, matt, paint};

#[test]
fn d_counts_before_tr_in_any_order() {
    let conflict: &[&str] = &["m.mtl:1 opacity-conflict"];
    paint("Kd 1 0 0\nd 1.0\nTr 1.0\n", matt(RED), conflict);
    paint("Tr 1.0\nd 1.0\nKd 1 0 0\n", matt(RED), conflict);
    paint("Kd 1 0 0\nd 1\nTr 0.5\n", matt(RED), conflict);
    paint("Kd 1 0 0\nd 1\nTr 0\n", matt(RED), &[]);
    let (half, told) = material("d 0.3\nTr 0.7\n");
    assert_eq!((half.transmission, told.len()), (grey(0.7), 0));
    let (half, told) = material("Tr 0.2\nd 0.25\n");
    assert_eq!(
        (half.transmission, &told[..]),
        (grey(0.75), &["m.mtl:1 opacity-conflict".to_owned()][..])
    );
}

#[test]
fn what_is_wholly_transparent_is_told() {
    for lines in [
        "Kd 1 0 0\nTr 1.0\nillum 2\n",
        "d 0\n",
        "Tr 1\n",
        "Tr 1\nNi 1.45\nillum 1\n",
        "Tr 1.5\n",
    ] {
        let (invisible, told) = material(lines);
        assert_eq!(invisible.transmission, Rgb::WHITE, "{lines}");
        assert_eq!(
            told.last().map(String::as_str),
            Some("m.mtl:1 invisible"),
            "{lines}"
        );
    }
    for lines in [
        "Tr 0.99\n",
        "d 0\nNi 1.5\nillum 7\n",
        "d 0\nillum 4\nNi 1.5\n",
    ] {
        assert_eq!(material(lines).1.len(), 0, "{lines}");
    }
}

#[test]
fn glass_by_its_model_of_illumination() {
    let glass = "Kd 0 0 0\nKs 0.3 0.3 0.3\nTf 0.9 0.9 0.9\nNi 1.5\n";
    for illum in [4, 6, 7, 9] {
        let (glass, told) = material(&format!("{glass}illum {illum}\n"));
        assert_eq!((glass.transmission, glass.ior), (grey(0.9), 1.5), "{illum}");
        // Models 4 and 6 have a mirror beside.
        let mirrors = matches!(illum, 4 | 6);
        assert_eq!(
            told,
            ["m.obj:0 sum-above-one"][usize::from(!mirrors)..],
            "{illum}"
        );
        // (1 - F) Kt passes, F Kt is reflected; model 7 has no other mirror.
        let [reflected, passed] = glass.fresnel_weights(0.04);
        assert!((passed.channels()[0] - 0.9 * 0.96).abs() < 1e-15);
        if illum == 7 {
            assert!((reflected.channels()[0] - 0.9 * 0.04).abs() < 1e-15);
        }
    }
    let (green, _) = material("Kd 0.5\nTf 0 0.8 0\nNi 1.3\nillum 7\n");
    assert_eq!(green.transmission, Rgb::new(0.0, 0.8, 0.0));
    let (filtered, _) = material("d 0.5\nTf 1 0.5 0\n");
    assert_eq!(filtered.transmission, Rgb::new(0.5, 0.25, 0.0));
}

#[test]
fn a_filter_in_an_opaque_material() {
    for lines in [
        "illum 4\nTf 1 1 1\nNi 1\n",
        "illum 4\nTf 1.00 1.00 1.00\nNi 1.00\n",
        "illum 2\nTf 1 1 1\nNi 1.5\n",
        "Tf 0 0 0\nd 1\n",
        "Tf 1\nillum 4\n",
    ] {
        paint(&format!("{lines}Kd 1 0 0\n"), matt(RED), &[]);
        assert_eq!(material(lines).0.transmission, Rgb::BLACK, "{lines}");
    }
    for lines in [
        "illum 2\nTf 0.9 0.9 0.9\n",
        "illum 4\nTf 0.5 0.5 0.5\nNi 1\n",
        "illum 7\nTf 0.9 0.9 0.9\nNi 1.5\nd 1\n",
    ] {
        let (opaque, told) = material(lines);
        assert_eq!(opaque.transmission, Rgb::BLACK, "{lines}");
        assert_eq!(told, ["m.mtl:1 opaque-filter"], "{lines}");
    }
}
