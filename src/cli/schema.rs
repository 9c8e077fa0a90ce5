//! `raytree schema`: the formats, for editors and graders.

use clap::{Args, ValueEnum};

use super::{Completion, Failure, output};

#[derive(Args)]
pub struct Schema {
    /// Which format
    format: Format,
}

#[derive(ValueEnum, Clone, Copy)]
enum Format {
    /// Scene files
    Scene,
    /// Ray trees
    Tree,
    /// Flat scenes (`raytree scenes NAME --flat`)
    Flat,
}

impl Schema {
    pub fn run(&self) -> Result<Completion, Failure> {
        let schema = match self.format {
            Format::Scene => crate::scene::file::schema(),
            Format::Flat => crate::scene::flat::schema(),
            Format::Tree => crate::trace::document::schema(),
        };
        output::to_stdout(format!("{schema:#}\n").as_bytes())
    }
}
