//! Queries from anywhere: any text is a query or one clear message about a place in it.

use raytree::scene::printable::is_printable;
use raytree::trace::TreeQuery;

use super::bytes;
use super::dice::Dice;
use super::laws::{catch_panics, without_panic};
use super::memory::counted;

const KNOWN: [&str; 8] = [
    "hits:ball and not lit:lamp",
    "some(R and hits:floor) or (depth >= 3 and t < 0.01)",
    "path:TT>gl*ss",
    "tir",
    "n_dot_l:lamp <= 0.5e-3",
    "absent:depth-limit",
    "not not (miss or back)",
    "luminance > 0.25 and diffuse:lamp != 1",
];

/// A query of chance words.
fn words(dice: &mut Dice) -> String {
    const WORDS: [&str; 24] = [
        "and", "or", "not", "some(", "(", ")", "hit", "miss", "R", "hits:", "hits:a*", "lit:", "t",
        "<", ">=", "=", "0.5", "1e999", "nan", "path:TT>", "path:", "tir", "*", "\u{202e}",
    ];
    (0..=dice.few(60))
        .map(|_| dice.pick(&WORDS).to_owned() + " ")
        .collect()
}

fn check(text: &str) -> Result<bool, String> {
    let read = || Ok(counted(|| text.parse::<TreeQuery>()));
    let (query, memory) = without_panic(read).map_err(|broken| broken.how)?;
    if memory.peak > (64 << 10) + 256 * text.len() {
        return Err(format!("{} bytes of memory", memory.peak));
    }
    let Err(error) = query else {
        return Ok(true);
    };
    let told = error.to_string();
    if told.trim().is_empty() || !told.chars().all(|c| is_printable(c) || c == '\n') {
        return Err(format!("message {told:?}"));
    }
    Ok(false)
}

#[test]
fn whatever_is_in_a_query_it_is_one_or_a_message() {
    catch_panics();
    for text in [&KNOWN[..6], &KNOWN[6..7]].concat() {
        assert_eq!(check(text), Ok(true), "{text}");
    }
    let many = super::environment("RAYTREE_FUZZ_TREES").unwrap_or(6000);
    let (mut taken, mut refused) = (0, 0);
    for number in 0..many {
        let dice = &mut Dice::new(13, number);
        let mut text = if dice.one_in(2) {
            words(dice)
        } else {
            dice.pick(&KNOWN).to_owned()
        };
        if dice.one_in(2) {
            let mut file = text.into_bytes();
            let other = dice.pick(&KNOWN);
            bytes::change(dice, &mut file, other.as_bytes());
            text = String::from_utf8_lossy(&file).into_owned();
        }
        match check(&text) {
            Ok(true) => taken += 1,
            Ok(false) => refused += 1,
            Err(how) => panic!("query {number}: {how}: {text:?}"),
        }
    }
    println!("{taken} queries, {refused} messages");
    assert!(taken > 50 && refused > 200, "{taken}, {refused}");
}

#[test]
fn deep_and_long_queries_end_soon() {
    catch_panics();
    let start = std::time::Instant::now();
    for text in [
        "(".repeat(1 << 20),
        "not ".repeat(1 << 18),
        "some(".repeat(1 << 18),
        "hit and ".repeat(1 << 16) + "hit",
        "a".repeat(1 << 20),
    ] {
        assert!(check(&text).is_ok(), "{}", &text[..20]);
    }
    assert!(start.elapsed().as_secs() < 10, "{:?}", start.elapsed());
}
