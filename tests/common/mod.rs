//! How property tests draw their cases.

use proptest::test_runner::{Config, RngSeed};

/// By default `cases` cases, the same in every run, so that a change, not chance, makes a test fail. `RAYTREE_CASES=n`
/// asks for n others, new in every run: this is how failures are searched for. Each one found is kept beside the tests
/// in a `.proptest-regressions` file and tried first ever after.
pub fn config(cases: u32) -> Config {
    let asked = std::env::var("RAYTREE_CASES")
        .ok()
        .and_then(|n| n.parse().ok());
    Config {
        cases: asked.unwrap_or(cases),
        rng_seed: asked.map_or(RngSeed::Fixed(1980), |_| RngSeed::Random),
        ..Config::default()
    }
}
