//! The page as tags: which there are, and what stands inside of what.

/// The tags of a page without their brackets, each with the text behind it.
pub fn tags(page: &str) -> Vec<(&str, &str)> {
    // A style has no tags, but may have brackets.
    let (head, rest) = page.split_once("<style>").expect("a style");
    let (_, rest) = rest.split_once("</style>").expect("its end");
    let parts = head.split('<').skip(1).chain(rest.split('<').skip(1));
    parts
        .map(|part| part.split_once('>').unwrap_or((part, "")))
        .collect()
}

/// The name of a tag.
pub fn name(tag: &str) -> &str {
    let end = tag.find(|c: char| c.is_whitespace());
    tag[..end.unwrap_or(tag.len())].trim_end_matches('/')
}

/// The number of the ray that a tag is for.
fn number(tag: &str) -> Option<u32> {
    let id = tag.split(' ').find_map(|word| word.strip_prefix("id=r"))?;
    Some(id.parse().expect("a number"))
}

/// The rays in the order of the page, each with the ray that it stands in; and how many folds are open at the end.
pub fn rays(page: &str) -> (Vec<(u32, Option<u32>)>, usize) {
    let (mut rays, mut around) = (Vec::new(), Vec::new());
    for (tag, _) in tags(page) {
        let ray = number(tag);
        if let Some(ray) = ray {
            rays.push((
                ray,
                around.iter().rev().find_map(|fold: &Option<u32>| *fold),
            ));
        }
        match name(tag) {
            "details" => around.push(ray),
            "/details" => assert!(around.pop().is_some(), "a fold ends that has not begun"),
            _ => {}
        }
    }
    (rays, around.len())
}

/// The paragraphs of a class, or of none, in order, each with the ray that it stands in.
pub fn paragraphs<'a>(page: &'a str, class: &str) -> Vec<(u32, &'a str)> {
    let (mut found, mut around) = (Vec::new(), Vec::new());
    let wanted = if class.is_empty() {
        "p".to_owned()
    } else {
        format!("p class={class}")
    };
    for (tag, text) in tags(page) {
        match name(tag) {
            "details" => around.push(number(tag)),
            "/details" => drop(around.pop()),
            _ => {}
        }
        if let (true, Some(ray)) = (tag == wanted, around.iter().rev().find_map(|fold| *fold)) {
            found.push((ray, text.trim_end()));
        }
    }
    found
}
