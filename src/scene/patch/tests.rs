//! Laws of patches, on scenes of all kinds, and the message for each mistake.

use crate::scene::{Edit, Patch, Scene, SceneSource, from_json, list, load, source};

const SCENE: &str = r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]},
"materials": {"glass": {"ior": 1.5, "transmission": [1, 1, 1]}, "a.b=c": {"diffuse": [1, 0, 0]}, "glass.ior": {},
  "floor": {"checker": {"diffuse": [1, 1, 1], "size": 0.5}}},
"lights": [{"point": {"name": "lamp", "position": [1, 2, 3], "intensity": [1, 0.5, 0.25]}},
  {"directional": {"name": "sun", "direction": [0, -1, 0], "intensity": [1, 1, 1]}}],
"objects": [{"sphere": {"name": "ball", "material": "glass", "center": [0, 0, 0], "radius": 1}},
  {"group": {"name": "pair", "transform": [{"rotate": {"axis": [0, 1, 0], "degrees": 10}}, {"translate": [1, 0, 0]}], "objects": [
    {"sphere": {"name": "left", "material": "floor", "center": [-3, 0, 0], "radius": 1}},
    {"sphere": {"name": "right.001", "material": "a.b=c", "center": [3, 0, 0], "radius": 1}}]}}]}"#;

fn typed(text: &str) -> Edit {
    Edit::Typed(text.to_owned())
}

fn changed(edits: &[Edit]) -> Result<(Scene, Patch), String> {
    let source = SceneSource::text(SCENE).expect("a scene");
    source.changed(edits).map_err(|e| e.to_string())
}

/// All of a scene but its hash and its changes, to the bit.
fn bits(scene: &Scene) -> String {
    let Scene {
        camera,
        background,
        ambient,
        materials,
        lights,
        objects,
        shapes,
        settings,
        ..
    } = scene;
    format!(
        "{camera:?} {background:?} {ambient:?} {materials:?} {lights:?} {objects:?} {shapes:?} {settings:?}"
    )
}

/// The change of the first, taken back by the second: one of each kind of value.
#[rustfmt::skip]
const THERE_AND_BACK: [[&str; 2]; 16] = [
    ["material.glass.ior=1.3", "material.glass.ior=1.5"],
    ["materials.glass.ior += 0.25", "material.glass.ior+=-0.25"],
    ["material.glass.ior*=2", "material.glass.ior=1.5"],
    ["material.glass.mirror=[1,1,1]", "material.glass.mirror=null"],
    ["material.\"glass\".ior=2", "material.glass.ior=1.5"],
    ["material.a.b=c.diffuse=[0,1,0]", "material.\"a.b=c\".diffuse=[1,0,0]"],
    ["material.floor.checker.size=2", "material.floor.checker.size=0.5"],
    ["material.floor.checker=null", "material.floor.checker={\"diffuse\":[1,1,1],\"size\":0.5}"],
    ["light.lamp.intensity=[1,0.5,0]", "light.lamp.intensity[2]=0.25"],
    ["light.lamp.position+=[1,0,-1]", "light.lamp.position=[1,2,3]"],
    ["object.pair/left.center[0]*=2", "object.pair/left.center[0]=-3"],
    ["object.pair/right.001.radius=2", "object.pair/right.001.radius=1"],
    ["object.pair.transform[0].rotate.degrees=20", "object.pair.transform[0].rotate.degrees=10"],
    ["object.ball.material=\"floor\"", "object.ball.material=\"glass\""],
    ["camera.eye=[0,1,5]", "camera.eye[1]=0"],
    ["background[1]=0.5", "background=[0,0,0]"],
];

#[test]
fn a_change_is_seen_and_taken_back_it_leaves_the_same_bits() {
    let whole = from_json(SCENE).expect("a scene");
    for [there, back] in THERE_AND_BACK {
        let (scene, patch) = changed(&[typed(there)]).unwrap_or_else(|e| panic!("{there}: {e}"));
        assert_ne!(bits(&scene), bits(&whole), "{there}");
        assert_ne!(scene.hash, whole.hash, "{there}");
        assert!(
            patch.count() == 1 || there.contains("checker=null"),
            "{there}: {}",
            patch.to_json()
        );
        let (scene, patch) = changed(&[typed(there), typed(back)]).expect("and back");
        assert_eq!(
            (bits(&scene), &scene.hash),
            (bits(&whole), &whole.hash),
            "{back}"
        );
        assert!(patch.is_empty() && scene.changes.is_empty(), "{back}");
    }
}

#[test]
fn a_change_as_a_patch_and_as_flags_is_the_change() {
    for [there, _] in THERE_AND_BACK {
        let (scene, patch) = changed(&[typed(there)]).expect("changed");
        let flags: Vec<Edit> = scene.changes.iter().map(|text| typed(text)).collect();
        let text = patch.to_json();
        let read = Edit::Patch(Patch::from_json(&text).expect("a patch"));
        for edits in [&flags[..], &[read]] {
            let (again, same) = changed(edits).unwrap_or_else(|e| panic!("{edits:?}: {e}"));
            assert_eq!(
                (bits(&again), again.hash),
                (bits(&scene), scene.hash.clone())
            );
            assert_eq!(
                (same, again.changes),
                (patch.clone(), scene.changes.clone())
            );
        }
    }
    // All of them at once, in either order of what does not concern the same value.
    let all: Vec<Edit> = [0, 3, 5, 6, 8, 10, 12, 14, 15]
        .map(|i: usize| typed(THERE_AND_BACK[i][0]))
        .to_vec();
    let (scene, patch) = changed(&all).expect("changed");
    let (other, same) = changed(&all.into_iter().rev().collect::<Vec<_>>()).expect("changed");
    assert_eq!(
        (bits(&other), other.hash, same),
        (bits(&scene), scene.hash, patch)
    );
}

#[test]
fn a_path_where_a_longer_name_could_be_meant_is_quoted() {
    let (scene, _) = changed(&[typed("material.\"glass\".ior=2")]).expect("changed");
    assert_eq!(scene.changes, ["material.\"glass\".ior=2"]);
    let (scene, _) = changed(&[typed("light.lamp.intensity*=2")]).expect("changed");
    assert_eq!(scene.changes, ["light.lamp.intensity=[2,1,0.5]"]);
    // Unquoted, the longest name is meant.
    assert!(changed(&[typed("material.glass.ior.ior=2")]).is_ok());
}

/// What is wrong, and what to do.
#[rustfmt::skip]
const MISTAKES: [[&str; 3]; 34] = [
    ["ior=2", "a scene has no `ior`", "what can be changed is camera, background"],
    ["materail.glass.ior=2", "a scene has no `materail`", "did you mean `material`?"],
    ["material=2", "the name of the material is missing", "KIND.NAME.FIELD=VALUE"],
    ["material.glas.ior=2", "there is no material `glas`", "did you mean `glass`?"],
    ["material.gold.ior=2", "there is no material `gold`", "there are a.b=c, floor, glass, glass.ior"],
    ["light.lmap.intensity=[1,1,1]", "there is no light `lmap`", "did you mean `lamp`?"],
    ["object.left.radius=1", "there is no object `left`", "there are ball, pair/left"],
    ["material.\"glass.ior=2", "the name has no closing", "KIND.NAME"],
    ["material.glass.iro=2", "iro", "did you mean `ior`?"],
    ["light.sun.position=[1,1,1]", "no field `position`", "possible here: direction"],
    ["material.glass.ior=two", "`two` is no value in JSON", "double quotation marks"],
    ["material.glass.ior=\"two\"", "what is expected is a number", "write"],
    ["material.glass.ior=1000", "1000 is not possible here", "a number from 0.01 to 100"],
    ["material.glass.ior=1e999", "`1e999` is no value", "write a number"],
    ["material.glass.ior", "there is no = and no value", "KIND.NAME"],
    ["material.glass.ior 2", "`2` stands where = should", "KIND.NAME"],
    ["material.glass.=2", "the name of a field is missing", "KIND.NAME"],
    ["material.glass.mirror[3]=1", "the list has no element [3]", "it has 3, counted from 0"],
    ["material.glass.mirror[x]=1", "`[x]` is no place in a list", "KIND.NAME"],
    ["material.glass.ior[0]=1", "what stands before [...] is no list", "leave the [...] out"],
    ["material.glass.iorr+=1", "there is no number here", "check the spelling"],
    ["material.glass.mirror+=[1,2]", "there is no number here", "write ="],
    ["material.glass.ior*=1e308", "is not possible here", "a number from"],
    ["material.glass=null", "single fields can be changed", "name the field"],
    ["object.ball.name=\"b\"", "keeps its name", "in the scene file"],
    ["object.pair.objects=[]", "the parts of `pair`", "object.pair/PART"],
    ["object.ball.radius=null", "radius", "\"radius\""],
    ["object.ball.material=\"gold\"", "there is no material `gold`", "glass"],
    ["camera=[1,2,3]", "single fields", "name the field"],
    ["camera.eye=[0,0,0]", "`eye` and `look_at` are the same point", "move one"],
    ["camera.eye=[0,0]", "a list of length 3", "[x, y, z]"],
    ["settings.samples=3", "a scene has no `settings`", "what can be changed"],
    ["background=[2e12,0,0]", "is not possible here", "0 to 1e12"],
    ["", "a scene has no ``", "what can be changed"],
];

#[test]
fn a_mistake_is_told_with_its_cure() {
    for [text, what, cure] in MISTAKES {
        let said = changed(&[typed(text)])
            .map(|(_, p)| p.to_json())
            .expect_err(text);
        let (first, second) = said.split_once('\n').expect("two lines");
        assert!(first.contains(what), "{text}: `{what}` is not in\n{said}");
        assert!(second.contains(cure), "{text}: `{cure}` is not in\n{said}");
        assert_eq!(said.lines().count(), 2, "{said}");
    }
}

#[test]
fn a_patch_of_a_stranger_is_bounded_and_changes_nothing_else() {
    let wrong = |text: &str| {
        let patch = Patch::from_json(text).map_err(|p| p.what);
        let changed = patch.and_then(|patch| changed(&[Edit::Patch(patch)]));
        changed.map(|(_, patch)| patch.to_json()).expect_err(text)
    };
    for (text, what) in [
        ("[]", "this is no patch"),
        ("{", "this is no patch"),
        (r#"{"settings": {"samples": 4}}"#, "a patch has no settings"),
        (r#"{"name": "x"}"#, "a patch has no `name`"),
        (r#"{"lights": []}"#, "`lights` is no object"),
        (r#"{"lights": {"lamp": null}}"#, "single fields"),
        (r#"{"lights": {"lmp": {}}}"#, "there is no light `lmp`"),
        (
            r#"{"materials": {"new": {}}}"#,
            "there is no material `new`",
        ),
        (
            r#"{"objects": {"ball": {"file": "../../etc/passwd"}}}"#,
            "file",
        ),
    ] {
        assert!(wrong(text).contains(what), "{}", wrong(text));
    }
    assert!(wrong(&format!("{{\"camera\": {}", " ".repeat(1 << 17))).contains("bytes"));
    assert!(wrong(&"[".repeat(60_000)).contains("no patch"));
}

#[test]
fn no_patch_leads_out_of_the_folder_of_the_scene() {
    let file = r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]},
        "objects": [{"obj": {"name": "cup", "file": "cup.obj"}}]}"#;
    let folder = tempfile::tempdir().expect("a folder");
    let inner = folder.path().join("inner");
    std::fs::create_dir(&inner).expect("a folder");
    let cup = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for (path, text) in [
        ("inner/a.json", file),
        ("inner/cup.obj", cup),
        ("inner/b.obj", cup),
        ("out.obj", cup),
    ] {
        std::fs::write(folder.path().join(path), text).expect("written");
    }
    let path = inner.join("a.json");
    let source = source(path.to_str().expect("UTF-8")).expect("a scene");
    let to = |file: &str| {
        let edit = typed(&format!("object.cup.file=\"{file}\""));
        source.changed(&[edit]).map_err(|e| e.to_string())
    };
    assert!(to("b.obj").is_ok());
    for out in ["../out.obj", "/etc/passwd"] {
        let said = to(out).map(drop).expect_err("outside");
        assert!(said.contains("leads out of the scene's folder"), "{said}");
    }
}

#[test]
fn without_changes_every_scene_is_the_same() {
    let computed = crate::scene::generated();
    let names = list().into_iter().map(|(name, _)| name.to_owned());
    let names = names.chain(computed.into_iter().map(|(name, _)| name));
    for name in names {
        let whole = load(&name).expect("a scene");
        if whole.shapes.len() > 20_000 {
            continue;
        }
        let source = source(&name).expect("a source");
        let eye = whole.camera.eye;
        let same = format!("camera.eye=[{:?},{:?},{:?}]", eye.x, eye.y, eye.z);
        let edits = [typed(&same), Edit::Patch(Patch::default())];
        let (scene, patch) = source
            .changed(&edits)
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(patch.is_empty(), "{name}: {}", patch.to_json());
        assert_eq!(scene.hash, whole.hash, "{name}");
        if whole.shapes.len() < 500 {
            assert_eq!(bits(&scene), bits(&whole), "{name}");
        }
    }
}
