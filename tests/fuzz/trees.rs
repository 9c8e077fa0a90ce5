//! Ray trees from anywhere: well-formed ones with bytes changed, and flat rays made by chance, are facts or messages, within
//! bounds.

use raytree::scene;
use raytree::scene::printable::is_printable;
use raytree::trace::facts::{Fact, PixelFacts, Step};
use raytree::trace::read::limits::{MAX_ERRORS, MAX_PROBLEMS};
use raytree::trace::read::{ReadError, read_trees};
use raytree::trace::{View, document, trace_pixel};
use raytree::world::World;

use super::bytes;
use super::dice::Dice;
use super::laws::{FACTOR, catch_panics, without_panic};
use super::memory::counted;
use super::words::WRONG;

/// Bytes of an error at most.
const ERROR: usize = 1 << 10;

/// Lines that a student's tracer might print.
const LINES: &str = "\
{\"pixel\":[1,2],\"id\":0,\"kind\":\"I\",\"origin\":[0,0,0],\"direction\":[0,NaN,-1],\"outcome\":\"hit\"}
{\"pixel\":[1,2],\"id\":1,\"parent\":0,\"kind\":\"L\",\"light\":\"lamp\",\"sample\":1,\"t_max\":Infinity}
{\"pixel\":[1,2],\"id\":2,\"parent\":0,\"kind\":\"R\",\"hit\":{\"t\":1e999,\"objekt\":\"b\\u0061ll\"}}
{\"pixel\":[1,2],\"color\":0.5,\"mean\":{\"value\":0.5,\"samples\":9}}
{\"pixel\":{\"x\":3,\"y\":4},\"root\":{\"kind\":\"I\",\"terms\":[{\"term\":\"diffuse\",\"light\":\"lamp\",\"value\":[1,2,3]}]}}
";

fn well_formed() -> Vec<Vec<u8>> {
    let traced = |name: &str, at: (u32, u32)| {
        let scene = scene::load(name).expect("a built-in scene");
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (16, 12);
            s.recursion.depth = 2;
            s.light.samples = 2;
        });
        let world = World::new(scene, settings.accel);
        let trace = trace_pixel(&world, &settings, at, true);
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        serde_json::to_vec(&document::of(view)).expect("writable")
    };
    let mut known = vec![LINES.as_bytes().to_vec()];
    known.extend(
        ["triangle", "mirrors", "glass-block", "soft-shadow"].map(|name| traced(name, (8, 7))),
    );
    known
}

/// Flat rays with chance kinds, names and parents.
fn flat(dice: &mut Dice) -> Vec<u8> {
    let mut text = String::new();
    for _ in 0..=dice.few(40) {
        let kind = dice.pick(&["I", "R", "T", "L", "X"]);
        let (id, parent) = (dice.below(12), dice.below(12));
        let number = if dice.one_in(4) {
            dice.pick(&WRONG)
        } else {
            "0.5"
        };
        let field = dice.pick(&[
            "ior", "t_max", "weight", "color", "sample", "origin", "mine", "kind",
        ]);
        text += &format!(
            "{{\"pixel\":[{},0],\"kind\":\"{kind}\",\"id\":{id},\"parent\":{parent},\"{field}\":{number}}}\n",
            dice.below(2)
        );
    }
    text.into_bytes()
}

/// Whether what was read is in order.
fn check_facts(pixel: &PixelFacts) -> Result<(), String> {
    let numbers = |fact: &Fact| match fact {
        Fact::Number(x) => vec![*x],
        Fact::Vector(v) => v.to_vec(),
        Fact::Pair(p) => p.to_vec(),
        Fact::Color(c) => c.channels().to_vec(),
        Fact::Word(_) | Fact::Steps(_) | Fact::Nothing => Vec::new(),
    };
    let mut paths: Vec<_> = pixel.rays.iter().map(|ray| &ray.path).collect();
    paths.sort();
    paths.dedup();
    if paths.len() != pixel.rays.len() {
        return Err("two rays of one name".to_owned());
    }
    for (number, ray) in pixel.rays.iter().enumerate() {
        let step = ray.path.steps.last();
        let parent = ray.parent.map(|parent| &pixel.rays[parent].path);
        let fits = match (parent, step) {
            (None, None) => true,
            (Some(parent), Some(step)) => {
                ray.parent < Some(number) && parent.then(step.clone()) == ray.path
            }
            _ => false,
        };
        let sorted = ray.facts.windows(2).all(|pair| pair[0].0 < pair[1].0);
        let finite = ray
            .facts
            .iter()
            .flat_map(|(_, fact)| numbers(fact))
            .all(f64::is_finite);
        if !fits || !sorted || !finite {
            return Err(format!(
                "ray {}: fits {fits}, sorted {sorted}, finite {finite}",
                ray.path
            ));
        }
        if let Some(step @ Step::Light(name, _)) = step
            && !name.is_empty()
            && step.to_string().parse().as_ref() != Ok(step)
        {
            return Err(format!("a step is not read as it is written: {step}"));
        }
    }
    let told = &pixel.problems;
    let clean = told
        .iter()
        .all(|text| text.chars().all(is_printable) && text.chars().count() < 1000);
    if told.len() > MAX_PROBLEMS + 2 || !clean {
        return Err(format!("problems: {told:?}"));
    }
    Ok(())
}

fn check_error(error: &ReadError, file: &[u8]) -> Result<(), String> {
    let lines = file.split(|byte| *byte == b'\n').count();
    let told = error.to_string();
    let clean = told.chars().all(|c| is_printable(c) || c == '\n') && told.chars().count() < 1400;
    if told.lines().count() != 2 || !clean || !(1..=lines).contains(&error.line) {
        return Err(format!("{told:?} of {lines} lines"));
    }
    Ok(())
}

/// Whether there was a pixel; an error is a broken law.
fn check(file: &[u8]) -> Result<bool, String> {
    let read = || Ok(counted(|| read_trees(file, "a.json")));
    let (answers, memory) = without_panic(read).map_err(|broken| broken.how)?;
    // A few bytes may be an error, whose text is bounded; so is the number of errors.
    let errors = answers.iter().filter(|answer| answer.is_err()).count();
    let most = (64 << 10) + FACTOR * file.len() + ERROR * errors;
    if errors > MAX_ERRORS + 1 || memory.peak > most {
        return Err(format!(
            "{} bytes of memory for {}",
            memory.peak,
            file.len()
        ));
    }
    if answers.is_empty() {
        return Err("no answer".to_owned());
    }
    for answer in &answers {
        match answer {
            Ok(pixel) => check_facts(pixel)?,
            Err(error) => check_error(error, file)?,
        }
    }
    Ok(answers.iter().any(Result::is_ok))
}

#[test]
fn whatever_is_in_a_tree_it_is_facts_or_messages() {
    catch_panics();
    let known = well_formed();
    for file in &known {
        assert_eq!(check(file), Ok(true));
    }
    let many = super::environment("RAYTREE_FUZZ_TREES").unwrap_or(6000);
    let (mut taken, mut refused) = (0, 0);
    for number in 0..many {
        let dice = &mut Dice::new(12, number);
        let mut file = if dice.one_in(3) {
            flat(dice)
        } else {
            known[dice.below(known.len())].clone()
        };
        let other = &known[dice.below(known.len())];
        if !dice.one_in(8) {
            bytes::change(dice, &mut file, other);
        }
        match check(&file) {
            Ok(true) => taken += 1,
            Ok(false) => refused += 1,
            Err(how) => panic!("tree {number}: {how}: {}", String::from_utf8_lossy(&file)),
        }
    }
    println!("{taken} with facts, {refused} without");
    assert!(taken > 200 && refused > 200, "{taken}, {refused}");
}
