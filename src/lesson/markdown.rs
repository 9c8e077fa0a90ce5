//! The Markdown of chapters: a subset that the terminal, a pipe and the book show alike.

use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};

use crate::scene::printable::excerpt;

/// A block of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TextBlock {
    /// A heading of a level from 1.
    Heading(usize, Words),
    /// A paragraph.
    Paragraph(Words),
    /// An item of a list: how deep, what stands before it, its words.
    Item(usize, String, Words),
    /// What somebody else says.
    Quote(Words),
    /// Lines that are shown as they are.
    Code(Vec<String>),
    /// A table: its head, then its rows.
    Table(Vec<Vec<Words>>),
}

/// Words, each run with its style.
pub type Words = Vec<(String, WordStyle)>;

/// How words are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WordStyle {
    /// As they are.
    #[default]
    Plain,
    /// `*emphasis*`.
    Emphasis,
    /// `**strong**`.
    Strong,
    /// `` `code` ``.
    Code,
    /// The text of a link.
    Link,
}

/// The blocks of a text; an error if it uses what is not in the subset.
pub fn blocks(text: &str) -> Result<Vec<TextBlock>, String> {
    let mut reader = Reader::default();
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        reader.take(event)?;
    }
    Ok(reader.blocks)
}

/// Words without their styles.
pub fn plain(words: &Words) -> String {
    words.iter().map(|(text, _)| text.as_str()).collect()
}

/// The words of a short text of one paragraph, such as a hint; what is no paragraph is taken as it is.
pub fn words(text: &str) -> Words {
    match blocks(text).as_deref() {
        Ok([TextBlock::Paragraph(words)]) => words.clone(),
        _ => vec![(text.to_owned(), WordStyle::Plain)],
    }
}

#[derive(Default)]
struct Reader {
    blocks: Vec<TextBlock>,
    words: Words,
    styles: Vec<WordStyle>,
    /// For each open list the number of its next item, if it is numbered.
    lists: Vec<Option<u64>>,
    /// What stands before the item that is open, until its first words are there.
    mark: Option<String>,
    quoted: bool,
    code: Option<String>,
    table: Vec<Vec<Words>>,
}

impl Reader {
    fn take(&mut self, event: Event) -> Result<(), String> {
        match event {
            Event::Start(tag) => self.start(&tag)?,
            Event::End(tag) => self.end(tag),
            Event::Text(text) => match &mut self.code {
                Some(code) => code.push_str(&text),
                None => self.word(&text),
            },
            Event::Code(text) => self.words.push((text.to_string(), WordStyle::Code)),
            Event::SoftBreak | Event::HardBreak => self.word(" "),
            other => return Err(not_in_subset(&format!("{other:?}"))),
        }
        Ok(())
    }

    fn word(&mut self, text: &str) {
        let style = self.styles.last().copied().unwrap_or_default();
        match self.words.last_mut() {
            Some((last, known)) if *known == style => last.push_str(text),
            _ => self.words.push((text.to_owned(), style)),
        }
    }

    fn start(&mut self, tag: &Tag) -> Result<(), String> {
        match tag {
            Tag::Paragraph
            | Tag::Heading { .. }
            | Tag::Table(_)
            | Tag::TableHead
            | Tag::TableRow
            | Tag::TableCell => {
                if matches!(tag, Tag::TableHead | Tag::TableRow) {
                    self.table.push(Vec::new());
                }
            }
            Tag::BlockQuote(None) => self.quoted = true,
            Tag::CodeBlock(kind) => {
                let is_known = match kind {
                    CodeBlockKind::Indented => true,
                    CodeBlockKind::Fenced(language) => language.len() <= 20,
                };
                if !is_known {
                    return Err(not_in_subset("a block of code with attributes"));
                }
                self.code = Some(String::new());
            }
            Tag::List(first) => {
                self.flush();
                self.lists.push(*first);
            }
            Tag::Item => {
                let mark = match self.lists.last_mut() {
                    Some(Some(number)) => {
                        *number += 1;
                        format!("{}.", *number - 1)
                    }
                    _ => "-".to_owned(),
                };
                self.mark = Some(mark);
            }
            Tag::Emphasis => self.styles.push(WordStyle::Emphasis),
            Tag::Strong => self.styles.push(WordStyle::Strong),
            Tag::Link { .. } => self.styles.push(WordStyle::Link),
            other => return Err(not_in_subset(&format!("{other:?}"))),
        }
        Ok(())
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Heading(level) => {
                let words = std::mem::take(&mut self.words);
                self.blocks.push(TextBlock::Heading(number(level), words));
            }
            TagEnd::Paragraph | TagEnd::Item => self.flush(),
            TagEnd::BlockQuote(_) => self.quoted = false,
            TagEnd::CodeBlock => {
                let code = self.code.take().unwrap_or_default();
                let lines = code.lines().map(str::to_owned).collect();
                self.blocks.push(TextBlock::Code(lines));
            }
            TagEnd::List(_) => {
                self.lists.pop();
            }
            TagEnd::Emphasis | TagEnd::Strong | TagEnd::Link => {
                self.styles.pop();
            }
            TagEnd::TableCell => {
                let words = std::mem::take(&mut self.words);
                if let Some(row) = self.table.last_mut() {
                    row.push(words);
                }
            }
            TagEnd::Table => {
                let rows = std::mem::take(&mut self.table);
                self.blocks.push(TextBlock::Table(rows));
            }
            _ => {}
        }
    }

    /// Ends the block that the words so far make.
    fn flush(&mut self) {
        let words = std::mem::take(&mut self.words);
        if words.is_empty() {
            return;
        }
        let depth = self.lists.len();
        self.blocks.push(if depth > 0 {
            TextBlock::Item(depth, self.mark.take().unwrap_or_default(), words)
        } else if self.quoted {
            TextBlock::Quote(words)
        } else {
            TextBlock::Paragraph(words)
        });
    }
}

fn number(level: HeadingLevel) -> usize {
    level as usize
}

/// That something is not in the subset.
fn not_in_subset(what: &str) -> String {
    format!(
        "this is not in the Markdown of lessons: {}; it has headings, paragraphs, lists, tables, code, emphasis, links and quotes",
        excerpt(what)
    )
}
