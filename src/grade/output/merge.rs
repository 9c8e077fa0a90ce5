//! Documents of shards made one: the same bytes as those of one run.

use super::document::{FORMAT, GradeDocument, Readers};
use super::unknown;

/// A document from its text.
pub fn parse(text: &str) -> Result<GradeDocument, String> {
    let document: GradeDocument = serde_json::from_str(text).map_err(|error| {
        format!(
            "is no {FORMAT}: {error}; write one with `raytree grade TASK ... --output json=FILE`"
        )
    })?;
    if document.format != FORMAT {
        return Err(format!(
            "its `format` is not {FORMAT}; write it again with this program"
        ));
    }
    Ok(document)
}

/// One document of several, in the order of their shards; of documents that are no shards in the order given.
pub fn merge(mut parts: Vec<GradeDocument>) -> Result<GradeDocument, String> {
    parts.sort_by_key(|part| part.shard.map_or(0, |[number, _]| number));
    complete(&parts)?;
    let mut parts = parts.into_iter();
    let Some(mut whole) = parts.next() else {
        return Err("there is nothing to merge; name the documents".to_owned());
    };
    for part in parts {
        if part.task != whole.task {
            return Err(format!(
                "the documents are of two tasks, or of two versions of one: `{}`, {}, and `{}`, {}; mark with the same task",
                whole.task.name, whole.task.hash, part.task.name, part.task.hash
            ));
        }
        if part.r#for != whole.r#for {
            return Err("some documents are made with --student, and some without".to_owned());
        }
        if part.program != whole.program {
            return Err(format!(
                "the documents are of {} and of {}; mark with the same program",
                whole.program, part.program
            ));
        }
        whole.submissions.extend(part.submissions);
    }
    whole.shard = None;
    whole.unknown = match whole.r#for {
        Readers::Teachers => unknown::groups(&whole.submissions),
        Readers::Students => Vec::new(),
    };
    Ok(whole)
}

/// An error if a shard is not there, or is there twice.
fn complete(parts: &[GradeDocument]) -> Result<(), String> {
    let shards: Vec<[usize; 2]> = parts.iter().filter_map(|part| part.shard).collect();
    if shards.is_empty() {
        return Ok(());
    }
    if shards.len() < parts.len() {
        return Err("some documents are shards, and some are not".to_owned());
    }
    let count = shards[0][1];
    if shards.iter().any(|[_, of]| *of != count) {
        return Err("the documents are shards of different --shard K/N".to_owned());
    }
    for number in 1..=count {
        match shards.iter().filter(|[k, _]| *k == number).count() {
            0 => return Err(format!("shard {number}/{count} is missing")),
            1 => {}
            _ => return Err(format!("shard {number}/{count} is there twice")),
        }
    }
    Ok(())
}
