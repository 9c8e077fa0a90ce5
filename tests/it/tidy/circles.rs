//! Which file needs which, and the circles among them.

use std::collections::BTreeSet;

use super::house::House;
use super::uses::paths;

/// The files that each file needs: those that define what its code names. Passing names on to others needs nothing, and
/// the parts of a module may use what their parents share with them.
pub fn needs(house: &House) -> Vec<BTreeSet<usize>> {
    house
        .files
        .iter()
        .map(|file| {
            let named = paths(&file.code());
            let single: BTreeSet<&str> = named
                .iter()
                .filter_map(|path| path.first().map(String::as_str))
                .collect();
            let imported = file
                .uses
                .iter()
                .filter(|u| u.name != "*" && (!u.public || single.contains(u.name.as_str())))
                .map(|u| &u.path);
            let inline = named.iter().filter(|path| path.len() > 1);
            let all = imported.chain(inline);
            all.filter_map(|path| house.definer(&House::absolute(file, path)?))
                .filter(|other| !file.module.starts_with(&house.files[*other].module))
                .collect()
        })
        .collect()
}

/// Sets of files each of which needs all the others, directly or not.
pub fn circles(needs: &[BTreeSet<usize>]) -> Vec<Vec<usize>> {
    let reach: Vec<BTreeSet<usize>> = (0..needs.len()).map(|from| reached(needs, from)).collect();
    let mut found = Vec::new();
    let mut done = BTreeSet::new();
    for from in 0..needs.len() {
        let circle: Vec<usize> = reach[from]
            .iter()
            .copied()
            .filter(|to| reach[*to].contains(&from))
            .collect();
        if circle.len() > 1 && circle.iter().all(|file| done.insert(*file)) {
            found.push(circle);
        }
    }
    found
}

/// All files that one needs, directly or not.
fn reached(needs: &[BTreeSet<usize>], from: usize) -> BTreeSet<usize> {
    let mut reached = BTreeSet::new();
    let mut open = vec![from];
    while let Some(file) = open.pop() {
        open.extend(needs[file].iter().filter(|next| reached.insert(**next)));
    }
    reached
}

/// A line for each circle: its files, each with those of them that it needs.
pub fn told(house: &House) -> Vec<String> {
    let needs = needs(house);
    let name = |file: usize| house.files[file].name.trim_end_matches(".rs");
    let line = |circle: &Vec<usize>| {
        let parts: Vec<String> = circle
            .iter()
            .map(|file| {
                let inside = needs[*file].iter().filter(|n| circle.contains(n));
                let others: Vec<&str> = inside.map(|n| name(*n)).collect();
                format!("{} -> {}", name(*file), others.join(", "))
            })
            .collect();
        format!(
            "a circle of {} files:\n    {}",
            circle.len(),
            parts.join("\n    ")
        )
    };
    circles(&needs).iter().map(line).collect()
}
