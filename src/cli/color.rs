//! Which colours a terminal shows.

use clap::ValueEnum;

use crate::tracer::image::ColorLevel;

/// The choice of colours on a terminal.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorArg {
    /// What the terminal can do; none in a pipe or with NO_COLOR
    Auto,
    /// 24 bits
    Truecolor,
    /// The palette of xterm
    #[value(name = "256")]
    Palette,
    /// Characters only
    Never,
}

impl ColorArg {
    /// The level for standard output.
    pub fn level(self) -> ColorLevel {
        match self {
            Self::Truecolor => ColorLevel::True,
            Self::Palette => ColorLevel::Palette,
            Self::Never => ColorLevel::Never,
            Self::Auto => match supports_color::on(supports_color::Stream::Stdout) {
                Some(level) if level.has_16m => ColorLevel::True,
                Some(level) if level.has_256 => ColorLevel::Palette,
                _ => ColorLevel::Never,
            },
        }
    }
}
