//! Lessons: a course of chapters as data, whose numbers and answers are computed by the tracer when they are asked.
//!
//! A course is a folder of texts, scenes and exercises ([`Course`]). A chapter enables features of the tracer ([`Feature`]); its
//! text holds directives, which become numbers and pictures ([`mod@page`]); an exercise is answered ([`mod@answer`]), and what was
//! done is kept ([`CourseProgress`]). Nothing here prints, and no course can run anything.

pub mod answer;
pub mod book;
pub mod chapter;
pub mod check;

mod console;
pub mod course;
pub mod directive;
mod evaluate;
pub mod exercise;
pub mod feature;
pub mod files;
pub mod markdown;
pub mod names;
pub mod near;
pub mod off;
pub mod page;
pub mod picture;
pub mod plain;
pub mod progress;
pub mod question;
pub mod reader;
pub mod solution;
pub mod stage;
pub mod template;
pub mod value;
pub mod watch;
pub mod worked;
pub mod workspace;

pub use chapter::Chapter;
pub use course::Course;
pub use exercise::{Exercise, ExerciseKind};
pub use feature::{Feature, Features};
pub use progress::CourseProgress;
pub use stage::Stage;
