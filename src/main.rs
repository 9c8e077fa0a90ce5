//! The command line of raytree.

use std::process::ExitCode;

fn main() -> ExitCode {
    raytree::cli::main()
}
