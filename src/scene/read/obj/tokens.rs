//! The words of a line: numbers, and numbers of vertices.

use crate::scene::read::error::Problem;

/// The words of a line up to a comment, without the first, which says what the line is.
pub fn rest(line: &str) -> impl Iterator<Item = &str> {
    let words = line.split_ascii_whitespace().skip(1);
    words.take_while(|word| !word.starts_with('#'))
}

/// The first `N` of some words as numbers, finite and not beyond `max`. `key` is what the line is.
pub fn numbers<'a, const N: usize>(
    key: &str,
    mut words: impl Iterator<Item = &'a str>,
    max: f64,
) -> Result<[f64; N], Problem> {
    let (mut values, mut found) = ([0.0; N], 0);
    for word in words.by_ref().take(N) {
        let Ok(value) = word.parse::<f64>() else {
            return Err(Problem::new(
                format!("`{key}` has `{word}`, which is not a number"),
                "write numbers with a decimal point, such as 0.5",
            ));
        };
        if !value.is_finite() || value.abs() > max {
            return Err(Problem::new(
                format!("`{key}` has `{word}`, which is no usable number"),
                format!("write a finite number between -{max:e} and {max:e}"),
            ));
        }
        values[found] = value;
        found += 1;
    }
    if found < N {
        return Err(Problem::new(
            format!("`{key}` needs {N} numbers and has {found}"),
            "complete the line; perhaps the file was cut off",
        ));
    }
    Ok(values)
}

/// The number of a vertex, a texture coordinate or a normal, counted from 0. Files count from 1 up, or from -1 down:
/// backwards from the last one so far, of which there are `count`.
pub fn index(corner: &str, part: &str, what: &str, count: usize) -> Result<u32, Problem> {
    let index: i64 = part.parse().map_err(|_| {
        Problem::new(
            format!("the corner `{corner}` has `{part}`, which is not a number of a {what}"),
            "write v, v/vt, v//vn or v/vt/vn with whole numbers",
        )
    })?;
    let from_zero = if index > 0 {
        usize::try_from(index - 1).ok()
    } else {
        usize::try_from(index.unsigned_abs())
            .ok()
            .and_then(|back| count.checked_sub(back))
    };
    let Some(found) = from_zero.filter(|found| *found < count) else {
        return Err(Problem::new(
            format!("the corner `{corner}` asks for {what} {index}, and there are {count} so far"),
            if count == 0 {
                "list them before the faces that use them".to_string()
            } else {
                format!(
                    "write a number from 1 to {count}, or from -1 to -{count} to count backwards"
                )
            },
        ));
    };
    Ok(found as u32)
}
