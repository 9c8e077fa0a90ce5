//! Tests of flat rays.

use super::{all, error, one, paths};
use crate::math::Rgb;
use crate::probe::RayKind;
use crate::trace::facts::{Fact, PixelFacts};

#[test]
fn flat_rays_become_a_tree_in_any_order() {
    let lines = [
        r#"{"pixel":[1,2],"id":4,"parent":3,"kind":"L","light":"lamp"}"#,
        r#"{"pixel":[1,2],"id":3,"parent":1,"kind":"R","ior":1.0}"#,
        r#"{"pixel":[9,9],"id":1,"kind":"I"}"#,
        r#"{"pixel":[1,2],"id":2,"parent":1,"kind":"L","light":"lamp","sample":3}"#,
        r#"{"pixel":[1,2],"id":1,"parent":-1,"kind":"I"}"#,
        r#"{"pixel":[1,2],"color":[0,0.5,1]}"#,
    ];
    for turn in 0..lines.len() {
        let turned: Vec<&str> = (0..lines.len())
            .map(|i| lines[(i + turn) % lines.len()])
            .collect();
        let pixels: Vec<PixelFacts> = all(&turned.join("\n"))
            .into_iter()
            .map(|p| p.expect("a tree"))
            .collect();
        let of = |at| pixels.iter().find(|p| p.pixel == Some(at)).expect("told");
        let first = of((1, 2));
        let mut names = paths(first);
        assert_eq!(names[0], "");
        names.sort();
        assert_eq!(names, ["", "/L:lamp~3", "/R", "/R/L:lamp"]);
        assert_eq!(first.color, Some(Fact::Color(Rgb::new(0.0, 0.5, 1.0))));
        let deep = first
            .rays
            .iter()
            .find(|ray| ray.path.depth() == 2)
            .expect("told");
        let parent = &first.rays[deep.parent.expect("it has one")];
        assert_eq!(parent.kind, RayKind::Reflected);
        assert_eq!(paths(of((9, 9))), [""]);
        assert_eq!(first.problems, [""; 0]);
    }
    let samples = "{\"kind\":\"I\",\"id\":1}\n{\"kind\":\"I\",\"id\":2,\"sample\":1}\n{\"kind\":\"T\",\"parent\":2}";
    assert_eq!(paths(&one(samples)), ["", ":1", ":1/T"]);
}

#[test]
fn what_breaks_flat_rays_is_told() {
    for (lines, said) in [
        (
            "{\"kind\":\"R\",\"parent\":7}",
            "no ray of this pixel has this `id`",
        ),
        ("{\"kind\":\"R\"}", "is of kind R, and no ray sent it"),
        (
            "{\"kind\":\"I\",\"id\":1}\n{\"kind\":\"R\",\"id\":1,\"parent\":1}",
            "a.json:2:1: 1 is the `id` of another",
        ),
        (
            "{\"kind\":\"I\"}\n{\"kind\":\"I\"}",
            "is a second eye ray of sample 0",
        ),
        (
            "{\"kind\":\"I\",\"id\":1}\n{\"kind\":\"T\",\"id\":2,\"parent\":3}\n{\"kind\":\"R\",\"id\":3,\"parent\":2}",
            "hangs on itself",
        ),
        (
            "{\"kind\":\"I\",\"id\":1}\n{\"kind\":\"T\",\"parent\":1}\n{\"kind\":\"T\",\"parent\":1}",
            "a.json:3:1: is a second T ray",
        ),
        (
            "{\"kind\":\"I\",\"color\":1}\n{\"color\":1}",
            "another line tells, too",
        ),
        ("{\"kind\":\"I\",\"id\":1.5}", "id: is 1.5"),
    ] {
        let told = error(lines);
        assert!(told.contains(said), "{told}, not {said}");
    }
    // A broken line breaks its pixel and no other.
    let lines = "{\"pixel\":[1,1],\"kind\":\"I\"}\n{\"pixel\":[2,2],\"kind\":\"I\"}\n{\"pixel\":[1,1],\"kind\":\"X\"}\n{\"pixel\":[1,1],\"color\":1}";
    let answers = all(lines);
    assert_eq!(answers.len(), 2);
    let error = answers[0].as_ref().expect_err("broken");
    assert_eq!((error.pixel, error.line), (Some((1, 1)), 3));
    assert!(answers[1].is_ok());
}
