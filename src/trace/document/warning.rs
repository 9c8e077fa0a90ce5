//! A warning about a scene, as JSON has it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scene::{Warning, WarningCode};

/// A warning about the scene.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct DocumentWarning {
    /// Its kind; the book lists them.
    pub code: WarningCode,
    /// The file that it is about, or the name of the scene.
    pub file: String,
    /// The line, from 1, where it was found first; absent if there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// The path of the field, such as `camera.vertical_fov`; absent if it is about none.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub field: String,
    /// What is strange.
    pub message: String,
    /// What to do.
    pub cure: String,
    /// How often it was found.
    pub count: u64,
}

impl From<&Warning> for DocumentWarning {
    fn from(warning: &Warning) -> Self {
        let problem = &warning.problem;
        Self {
            code: warning.code,
            file: problem.file.clone(),
            line: problem.position.map(|(line, _)| line),
            field: problem.field.clone(),
            message: problem.problem.what.clone(),
            cure: problem.problem.cure.clone(),
            count: warning.count,
        }
    }
}

/// Warnings as JSON has them.
pub fn list(warnings: &[Warning]) -> Vec<DocumentWarning> {
    warnings.iter().map(DocumentWarning::from).collect()
}
