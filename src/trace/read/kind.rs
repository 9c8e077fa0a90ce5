//! Kinds of values in JSON.

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueKind {
    /// `{...}`: its keys, each before its value.
    Object,
    /// `[...]`.
    List,
    /// `"..."`.
    Text,
    /// `"..."` with a backslash.
    EscapedText,
    /// A number, which may be beyond what 64 bits hold.
    Number,
    /// NaN, or infinity.
    NoNumber,
    /// `true` or `false`.
    Truth,
    /// `null`.
    Null,
}
