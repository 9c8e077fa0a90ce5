//! What all test programs share: how property tests draw their cases.

use proptest::test_runner::{Config, RngSeed};

/// The number in an environment variable.
pub fn number(name: &str) -> Option<u32> {
    std::env::var(name).ok()?.parse().ok()
}

/// By default `cases` cases, the same in every run, so that a change, not chance, makes a test fail. `RAYTREE_CASES=n`
/// asks for n others, new in every run: this is how failures are searched for. Each one found is kept beside the tests
/// in a `.proptest-regressions` file and tried first ever after.
pub fn config(cases: u32) -> Config {
    let asked = number("RAYTREE_CASES");
    Config {
        cases: asked.unwrap_or(cases),
        rng_seed: asked.map_or(RngSeed::Fixed(1980), |_| RngSeed::Random),
        ..Config::default()
    }
}
