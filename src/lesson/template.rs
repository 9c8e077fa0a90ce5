//! A small course to fill in: one chapter, with an exercise of most kinds. It passes its own check.

/// Its files, by their paths.
pub fn template() -> [(&'static str, &'static str); 5] {
    [
        ("course.toml", COURSE),
        ("README.md", README),
        ("01-first/chapter.toml", CHAPTER),
        ("01-first/text.md", TEXT),
        ("01-first/scene.json", SCENE),
    ]
}

const COURSE: &str = r#"format = "raytree-course/1"
id = "my-course"
title = "My course"
program = ">=0.1"
# The chapters, in order: each is a folder. A new one is added here.
chapters = ["01-first"]
"#;

const README: &str = r"A course for raytree.

    raytree lesson check .          is everything right?
    raytree lesson --lessons .      open it
    raytree lesson book pages       pages for mdBook

A chapter is a folder: its text, its exercises, its scenes. To add one, copy `01-first`, give the exercises new names, and
write its folder into `course.toml`. All kinds of exercises and directives are in raytree's book, in the chapter on writing
exercises.
";

const CHAPTER: &str = r#"format = "raytree-chapter/1"
title = "A first chapter"
# What the tracer can do from here on; what comes later is off.
enables = ["rays", "hits", "closest", "normals", "ambient", "diffuse", "shadows"]
scene = "scene.json"

[[exercise]]
id = "ball-t"
kind = "predict"
at = "160,120.t"
text = "At which t does the ray through this pixel hit the ball? The ball has radius 1, its middle is 5 metres away."
hints = ["Draw the ray and the ball from the side.", "The ray meets the ball before its middle.", "The distance to the middle, less the radius."]

[[exercise]]
id = "in-shadow"
kind = "find"
where = "hits:floor and blocked:lamp"
text = "Find a pixel of the floor that lies in the shadow of the ball."
hints = ["The lamp is above, on the right.", "Its shadow lies on the other side.", "Left of the ball, on the floor."]

[[exercise]]
id = "move-the-lamp"
kind = "change"
keep = ["camera", "objects", "materials"]
goal = [{ where = "hits:floor and blocked:lamp", count = [0, 0] }]
solution = ["light.lamp.position=[0,1,5]"]
text = "Move the lamp so that no shadow on the floor can be seen."
hints = ["The shadow lies opposite to the lamp.", "What is in shadow is what the lamp cannot see.", "What the lamp cannot see, you must not see either."]
"#;

const TEXT: &str = r"# A first chapter

A ray starts at the eye and goes through a pixel. Where it hits something first, at t, the colour of the pixel is computed.

    P = o + t d

{{picture mark=160,120}}

{{exercise ball-t}}

A surface is in the shadow of whatever stands between it and the lamp: {{count hits:floor and blocked:lamp}} pixels of the
floor are.

{{exercise in-shadow}}

{{exercise move-the-lamp}}
";

const SCENE: &str = r#"{
  "format": "raytree-scene/1",
  "name": "first",
  "camera": {"eye": [0, 1, 5], "look_at": [0, 1, 0], "vertical_fov": 40},
  "background": [0.1, 0.15, 0.25],
  "ambient": [0.2, 0.2, 0.2],
  "materials": {"grey": {"diffuse": [0.6, 0.6, 0.6]}, "red": {"diffuse": [0.8, 0.2, 0.1]}},
  "lights": [{"point": {"name": "lamp", "position": [4, 5, 2], "intensity": [1, 1, 1]}}],
  "objects": [
    {"sphere": {"name": "ball", "material": "red", "center": [0, 1, 0], "radius": 1}},
    {"plane": {"name": "floor", "material": "grey", "point": [0, 0, 0], "normal": [0, 1, 0]}}
  ]
}
"#;
