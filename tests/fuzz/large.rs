//! Long files of one kind of line, the shortest there is: what grows with the file must grow no faster than it.

use std::collections::BTreeMap;

use raytree::accel::AccelKind;
use raytree::scene::load_from_memory;
use raytree::world::World;

use super::laws::{Case, catch_panics};
use super::memory::counted;
use super::on_one_thread;

const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

/// A model and its MTL file, or a scene, from a piece that stands in it `count` times; `#` in a piece is its number.
fn case(head: &str, piece: &str, tail: &str, count: usize, name: &str) -> Case {
    let body: String = if piece.contains('#') {
        (0..count)
            .map(|i| piece.replace('#', &i.to_string()))
            .collect()
    } else {
        piece.repeat(count)
    };
    let long = format!("{head}{}{tail}", body.trim_end_matches(','));
    let mut files = BTreeMap::from([(
        "m.obj".to_string(),
        format!("mtllib x.mtl\n{CORNERS}usemtl a\nf 1 2 3\n"),
    )]);
    files.insert(name.to_string(), long);
    Case::new(
        files
            .into_iter()
            .map(|(name, text)| (name, text.into_bytes()))
            .collect(),
    )
}

/// A name, the file, and what it is made of: head, piece, tail.
type Long<'a> = (&'a str, &'a str, String, &'a str, &'a str);

fn made(bytes: usize, long: Vec<Long<'static>>) -> Vec<(&'static str, Case)> {
    let of = |(name, file, head, piece, tail): Long<'static>| {
        (name, case(&head, piece, tail, bytes / piece.len(), file))
    };
    long.into_iter().map(of).collect()
}

/// Models and their MTL files, about `bytes` long.
fn models(bytes: usize) -> Vec<(&'static str, Case)> {
    let obj = "m.obj";
    let end = "f 1 2 3\n";
    let model = || format!("mtllib x.mtl\n{CORNERS}");
    let all = || model() + "vn 0 0 1\nvt 0 0\n";
    let same = "f 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n";
    let crossed = "f 1 4 2 3 1 2 4 3 1 4 3 2 1 4 2 3 1 2 4 3 1 4 3 2\n";
    let long: Vec<Long> = vec![
        ("materials", "x.mtl", String::new(), "newmtl #\n", ""),
        ("of one name", "x.mtl", String::new(), "newmtl a\n", ""),
        ("libraries", obj, model(), "mtllib x.mtl\n", end),
        ("missing libraries", obj, model(), "mtllib #\n", end),
        ("used materials", obj, model(), "usemtl #\nf 1 2 3\n", ""),
        ("unknown materials", obj, model(), "usemtl #\n", end),
        ("parts", obj, model(), "g\nf 1 2 3\n", ""),
        ("names", obj, model(), "g #\n", end),
        ("points", obj, model(), "v 0 0 0\n", end),
        ("faces", obj, model(), "f 1 2 3\n", ""),
        ("faces with all", obj, all(), "f 1/1/1 2/1/1 3/1/1\n", ""),
        ("faces without area", obj, all(), same, end),
        ("crossed faces", obj, all(), crossed, end),
        ("two corners", obj, all(), "f 1 1\n", end),
        ("empty lines", obj, model(), "\n", end),
        ("a wrong word", obj, model() + "v 0 0 ", "x", "\n"),
    ];
    made(bytes, long)
}

/// Scene files, about `bytes` long.
fn scenes(bytes: usize) -> Vec<(&'static str, Case)> {
    let json = "scene.json";
    let open = || {
        let camera = r#""camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}"#;
        format!("{{\"format\": \"raytree-scene/1\", {camera}, \"materials\": {{\"a\": {{}}")
    };
    let then = |text: &str| format!("{}}}, {text}", open());
    let object = |kind: &str, text: &str| {
        then(&format!(
            "\"objects\": [{{\"{kind}\": {{\"name\": \"o\", \"material\": \"a\", {text}"
        ))
    };
    let points = r#""vertices": [[0,0,0],[1,0,0],[0,1,0]], "triangles": ["#;
    let ball = r#"{"sphere":{"name":"s#","material":"a","center":[0,0,0],"radius":1}},"#;
    let bounds = r#""min": [0,0,0], "max": [1,1,1], "transform": ["#;
    let long: Vec<Long> = vec![
        (
            "steps",
            json,
            object("box", bounds),
            "{\"scale\":1},",
            "]}}]}",
        ),
        (
            "triangles",
            json,
            object("mesh", points),
            "[0,1,2],",
            "]}}]}",
        ),
        (
            "vertices",
            json,
            object("mesh", r#""triangles": [[0,1,2]], "vertices": ["#),
            "[0,0,0],",
            "]}}]}",
        ),
        ("objects", json, then("\"objects\": ["), ball, "]}"),
        (
            "groups",
            json,
            then("\"objects\": ["),
            "{\"group\":{\"name\":\"a\",\"objects\":[]}},",
            "]}",
        ),
        ("materials in a scene", json, open(), ",\"#\":{}", "}}"),
        ("a long field", json, then("\""), "x", "\": 1}"),
        (
            "a long material",
            json,
            then("\"objects\": [{\"obj\": {\"name\": \"m\", \"file\": \"m.obj\", \"material\": \""),
            "x",
            "\"}}]}",
        ),
        (
            "a long number",
            json,
            then("\"ambient\": ["),
            "1",
            ", 0, 0]}",
        ),
        (
            "a long escape",
            json,
            then("\"name\": \""),
            "\\u00e9",
            "\"}",
        ),
        (
            "a long value",
            json,
            then("\"ambient\": \""),
            "\\u0007",
            "\"}",
        ),
        ("brackets", json, then("\"ambient\": "), "[", ""),
        (
            "models",
            json,
            then("\"objects\": ["),
            "{\"obj\":{\"name\":\"#\",\"file\":\"m.obj\"}},",
            "]}",
        ),
    ];
    made(bytes, long)
}

/// All of them, with their names.
fn cases(bytes: usize) -> Vec<(&'static str, Case)> {
    let mut all = models(bytes);
    all.extend(scenes(bytes));
    all
}

#[test]
fn memory_and_work_grow_with_the_file_and_no_faster() {
    catch_panics();
    let work = |case: &Case, name: &str| {
        let read = on_one_thread(|| case.read(None).map(|(_, outcome)| outcome.memory));
        read.unwrap_or_else(|broken| panic!("{name}: {}: {}", broken.law, broken.how))
            .total as f64
    };
    for ((name, small), (_, large)) in cases(40 << 10).iter().zip(&cases(80 << 10)) {
        let (less, more) = (work(small, name), work(large, name));
        let twice = large.size() as f64 / small.size() as f64;
        assert!(
            more <= 1.25 * twice * less + 65536.0,
            "{name}: {less} bytes become {more}"
        );
    }
}

/// The triangles of a model in a part are kept once, however often the part is used.
#[test]
fn a_thousand_uses_of_a_model_take_hardly_more_memory_than_one() {
    let peak = |uses: usize| {
        let used = (0..uses).map(|i| {
            format!("{{\"use\": {{\"name\": \"u{i}\", \"part\": \"p\", \"transform\": [{{\"translate\": [{i}, 0, 0]}}]}}}}")
        });
        let text = format!(
            "{{\"format\": \"raytree-scene/1\", \"camera\": {{\"eye\": [0, 1, 5], \"look_at\": [0, 1, 0]}},
            \"materials\": {{\"a\": {{}}}}, \"parts\": {{\"p\": [{{\"obj\": {{\"name\": \"b\", \"material\": \"a\",
            \"file\": \"b.obj\"}}}}]}}, \"objects\": [{}]}}",
            used.collect::<Vec<_>>().join(",")
        );
        let bunny = include_bytes!("../../scenes/bunny.obj").to_vec();
        let files = [
            ("s.json".to_owned(), text.into_bytes()),
            ("b.obj".to_owned(), bunny),
        ];
        on_one_thread(|| {
            let (world, memory) = counted(|| {
                let scene = load_from_memory("s.json", files.into_iter().collect());
                World::new(scene.expect("a scene"), AccelKind::Wide)
            });
            assert_eq!(world.scene.shapes.len(), uses);
            memory.peak
        })
    };
    let [one, all] = [1, 1000].map(peak);
    // Names, transforms, boxes of the accelerator and the text of the uses.
    assert!(all < one + 1000 * 3000, "{one} and {all} bytes");
}
