//! A self-test as a table.

use std::fmt::Write as _;

use super::{Naming, SelfTest, naming};
use crate::grade::output::points;
use crate::grade::report::Marked;
use crate::grade::task::Task;

impl SelfTest {
    /// How many bends are named alone, named among others, not named, and taken for another.
    pub fn naming(&self) -> [usize; 4] {
        [
            Naming::Named,
            Naming::Among,
            Naming::Unnamed,
            Naming::Misnamed,
        ]
        .map(|wanted| {
            self.bends
                .iter()
                .filter(|(bend, marked)| naming(*bend, marked) == wanted)
                .count()
        })
    }

    /// The table, and what is to be said.
    pub fn to_text(&self, task: &Task) -> String {
        let mut out = format!("{:22}", "");
        let heading: Vec<String> = task
            .checks
            .iter()
            .map(|check| format!("{:>10}", check.id))
            .collect();
        let _ = writeln!(out, "{}{:>10}  named", heading.concat(), "all");
        let mut line = |name: &str, marked: &Marked, named: &str| {
            let cells: Vec<String> = marked
                .marks
                .iter()
                .map(|mark| format!("{:>10}", points(mark.score)))
                .collect();
            let cells = cells.concat();
            let all = points(marked.score());
            let row = format!("{name:22}{cells}{all:>10}  {named}");
            let _ = writeln!(out, "{}", row.trim_end());
        };
        for marked in self.right.iter().chain(&self.wrong) {
            line(&marked.name, marked, "");
        }
        for (bend, marked) in &self.bends {
            let named = match naming(*bend, marked) {
                Naming::Named => "yes".to_owned(),
                Naming::Unnamed => "no".to_owned(),
                _ => marked
                    .diagnosis
                    .iter()
                    .flat_map(|d| &d.candidates)
                    .map(ToString::to_string)
                    .collect::<Vec<_>>()
                    .join("; "),
            };
            line(bend.name(), marked, &named);
        }
        let unseen: Vec<&str> = self.unseen.iter().map(|bend| bend.name()).collect();
        if !unseen.is_empty() {
            let _ = writeln!(
                out,
                "not told from a right tracer by what is asked: {}",
                unseen.join(", ")
            );
        }
        let [named, among, unnamed, misnamed] = self.naming();
        let all = self.bends.len();
        let _ = writeln!(
            out,
            "{named} of {all} bends are named alone, {among} among others, {unnamed} not, {misnamed} wrongly"
        );
        for failure in &self.failures {
            let _ = writeln!(out, "fails: {failure}");
        }
        for warning in task.warnings.iter().chain(&self.warnings) {
            let _ = writeln!(out, "warning: {warning}");
        }
        out
    }
}
