//! The program `raytree`, built as these programs are.

use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

/// Where it is, in the folder of builds that the running program stands in as well. It is built when first asked for.
pub fn raytree() -> &'static PathBuf {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(|| {
        let own = std::env::current_exe().expect("a path");
        let builds = own.ancestors().nth(2).expect("a folder for each profile");
        let status = Command::new(env!("CARGO"))
            .args(["build", "--release", "--quiet", "--bin", "raytree"])
            .args([
                "--manifest-path",
                concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml"),
            ])
            .arg("--target-dir")
            .arg(builds.parent().expect("the folder of all builds"))
            .status();
        assert!(status.expect("cargo runs").success(), "it can be built");
        builds.join(format!("raytree{}", std::env::consts::EXE_SUFFIX))
    })
}
