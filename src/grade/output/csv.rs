//! Marks as a table for spreadsheets: RFC 4180, a line a submission.

use super::document::GradeDocument;
use super::points;

/// The table. Students' ids are a column if there are any.
pub fn table(document: &GradeDocument) -> String {
    let has_ids = document.submissions.iter().any(|s| s.id.is_some());
    let mut header = vec!["name".to_owned()];
    header.extend(has_ids.then(|| "id".to_owned()));
    header.extend(["score", "max", "percent"].map(str::to_owned));
    let checks = document.submissions.first().map(|s| &s.checks[..]);
    header.extend(checks.unwrap_or_default().iter().map(|c| c.id.clone()));
    header.extend(["bends", "problems"].map(str::to_owned));
    let mut out = line(&header);
    for submission in &document.submissions {
        let mut cells = vec![submission.name.clone()];
        cells.extend(has_ids.then(|| submission.id.clone().unwrap_or_default()));
        cells.push(points(submission.score.0));
        cells.push(points(submission.max.0));
        cells.push(submission.percent.to_string());
        cells.extend(submission.checks.iter().map(|c| points(c.score.0)));
        let bends = submission.bends.iter().map(|b| b.names.join(" or "));
        cells.push(bends.collect::<Vec<_>>().join("; "));
        cells.push(submission.problems.join("; "));
        out += &line(&cells);
    }
    out
}

/// A line with its end.
fn line(cells: &[String]) -> String {
    let cells: Vec<String> = cells.iter().map(|text| cell(text)).collect();
    cells.join(",") + "\r\n"
}

/// A cell. Spreadsheets run what begins like a formula: such a text gets a `'` before it.
fn cell(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let text = if is_formula {
        format!("'{text}")
    } else {
        text.to_owned()
    };
    if text.contains([',', '"', '\r', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::cell;

    #[test]
    fn a_cell_is_one_cell_and_no_formula() {
        for (text, expected) in [
            ("alice", "alice"),
            ("=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0"),
            ("+1", "'+1"),
            ("-1", "'-1"),
            ("@a", "'@a"),
            ("\ta", "'\ta"),
            ("a=b", "a=b"),
            ("a, \"b\"", "\"a, \"\"b\"\"\""),
            ("=1,\n2", "\"'=1,\n2\""),
        ] {
            assert_eq!(cell(text), expected);
        }
    }
}
