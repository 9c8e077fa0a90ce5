//! Names of strangers do nothing on a page: no tag and no request comes from them.

use raytree::scene::printable::is_printable;

use super::{from_text, markup, page_of, pages};

/// Tags that a page has.
const TAGS: &str = "!DOCTYPE html head meta title body h1 h2 p i b main details summary ol li div figure svg path circle \
                    figcaption dl dt dd";

/// What such a tag may have.
const ATTRIBUTES: &str = "html lang charset http-equiv content name id class style open viewBox role aria-label d cx cy r /";

/// Names that would be markup if they were not escaped; the last one turns text around.
const HOSTILE: [&str; 7] = [
    "<script>alert(1)</script>",
    "\"><img src=x onerror=alert(1)>",
    "</style><style>body{display:none}",
    "' onclick='alert(1)",
    "&lt;b&gt; & <b>",
    "</details></main><p id=r0>",
    "name \u{202e}\u{200b}",
];

/// What is wrong with the markup of a page.
fn problems(page: &str) -> Vec<String> {
    let mut problems = Vec::new();
    for (tag, _) in markup::tags(page) {
        let name = markup::name(tag).trim_start_matches('/');
        if !TAGS.split_whitespace().any(|known| known == name) {
            problems.push(format!("<{tag}>"));
        }
        // Values in quotes are no attributes.
        let outside: Vec<&str> = tag.split('"').step_by(2).collect();
        for word in outside.join(" ").split_whitespace().skip(1) {
            let attribute = word.split('=').next().unwrap_or_default();
            if !ATTRIBUTES
                .split_whitespace()
                .any(|known| known == attribute)
            {
                problems.push(format!("{attribute} in <{tag}>"));
            }
        }
    }
    problems
}

#[test]
fn a_page_has_no_script_and_loads_nothing() {
    for (name, _, page) in pages() {
        assert_eq!(problems(&page), [""; 0], "{name}");
        for word in [
            "<script", "http:", "https:", "url(", "@import", "href", "src=",
        ] {
            assert!(!page.contains(word), "{name}: {word}");
        }
        let policy = "content=\"default-src 'none'; style-src 'unsafe-inline'\"";
        assert!(page.contains(policy), "{name}");
        assert!(page.contains("prefers-color-scheme:dark") && page.contains("width=device-width"));
    }
}

#[test]
fn names_of_strangers_are_text() {
    for hostile in HOSTILE {
        let text = serde_json::json!({
            "format": "raytree-scene/1",
            "name": hostile,
            "camera": {"eye": [0, 0, 4], "look_at": [0, 0, 0]},
            "materials": {hostile: {"diffuse": [1, 1, 1], "specular": [1, 1, 1], "transmission": [1, 1, 1], "ior": 1.5}},
            "lights": [{"point": {"name": hostile, "position": [0, 3, 9], "intensity": [1, 1, 1]}}],
            "objects": [{"sphere": {"name": hostile, "material": hostile, "center": [0, 0, 0], "radius": 1}}]
        });
        let scene = from_text::scene(&text.to_string());
        let (_, page) = page_of(scene, |_| (), (16, 12), true);
        assert_eq!(problems(&page), [""; 0], "{hostile}");
        let (rays, open) = markup::rays(&page);
        assert!(rays.len() > 3 && open == 0, "{hostile}");
        assert!(
            page.chars().all(|c| c == '\n' || is_printable(c)),
            "{hostile}"
        );
        // It is there all the same: as object, light, material and in the title.
        let word = hostile
            .split(['<', '>', '&', '"', '\'', ' ', '/'])
            .find(|w| w.len() > 1);
        let word = word.expect("a word");
        assert!(page.matches(word).count() > 6, "{hostile}");
    }
}

/// The law can fail.
#[test]
fn markup_of_strangers_would_be_found() {
    let (_, _, page) = pages().swap_remove(0);
    for hostile in &HOSTILE[..4] {
        let broken = page.replacen("</h1>", &format!("{hostile}</h1>"), 1);
        let in_a_tag = page.replacen("<main>", &format!("<main {hostile}>"), 1);
        let all = [problems(&broken), problems(&in_a_tag)].concat();
        assert!(!all.is_empty(), "{hostile}");
    }
}
