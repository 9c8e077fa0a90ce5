//! The ray tree as a page for a browser, where every ray can be unfolded. It needs nothing else: no script, no link out, no
//! request.
//!
//! A page of ten thousand rays has to stay within 5 MB: end tags that HTML does not ask for are left out, the style breaks lines
//! and draws squares, and the sentences about rays that were not sent stand once, below the tree.

mod about;
mod equation;
mod missing;
mod ray;
mod sample;

use std::fmt;

use super::{heading, xml};
use crate::trace::document::Document;

/// A document as a page, written by `Display`.
pub struct Html<'a> {
    /// The ray tree.
    pub document: &'a Document,
    /// A drawing of the ray paths to put above the tree, as HTML; may be empty.
    pub drawing: &'a str,
}

/// What the page looks like. `p` is a text of many lines, `e` an equation, `a` what is absent. The first letter of a ray is its
/// kind, and the square behind its line has the colour `--c`.
const STYLE: &str = "\
:root{color-scheme:light dark;--fg:#1b1b1b;--bg:#fff;--soft:#f3f3f3;--dim:#666;--line:#bbb;--ink:#fff;
--I:#444;--L:#8a6200;--R:#b52b2b;--T:#1d59b5}
@media(prefers-color-scheme:dark){:root{--fg:#e6e6e6;--bg:#161616;--soft:#232323;--dim:#a0a0a0;--line:#555;--ink:#161616;
--I:#c8c8c8;--L:#e0b64c;--R:#f08a80;--T:#83b4f5}}
body{font:16px/1.45 system-ui,sans-serif;margin:1.5rem auto;max-width:76rem;padding:0 1rem;color:var(--fg);background:var(--bg)}
h1{font-size:1.4rem;overflow-wrap:anywhere}h2{font-size:1.1rem;margin:1.4rem 0 .4rem}
.I{--k:var(--I)}.L{--k:var(--L)}.R{--k:var(--R)}.T{--k:var(--T)}
b,[class]>summary::first-letter,p.L::first-letter{color:var(--ink);background:var(--k);border-radius:.25em;padding:0 .4em;
margin-right:.3em;font-weight:700}
[style]::after{content:'';display:inline-block;width:1em;height:1em;background:var(--c);outline:1px solid var(--line);
vertical-align:-.13em;margin-left:.6em}
.c::after{width:2.6em;height:2.6em;vertical-align:middle}
main{overflow-x:auto}
main details{border-left:2px solid var(--k,var(--line));margin:.25rem 0;padding-left:.7rem;min-width:17rem}
main details details details details details details details details details{padding-left:.15rem}
summary{cursor:pointer;padding:.1rem 0}summary:hover{background:var(--soft)}
main p,main li{white-space:pre-line;overflow-wrap:anywhere;margin:.25rem 0;font:.83rem/1.5 ui-monospace,monospace}
main .e{background:var(--soft);padding:.3rem .6rem;border-radius:.3em}main .a{color:var(--dim)}
.d{display:flex;flex-wrap:wrap;gap:1rem}figure{margin:0;flex:1 1 18rem;min-width:0;max-width:26rem}figcaption,.note{color:var(--dim);font-size:.85rem}
svg{width:100%;height:auto;background:var(--soft);border-radius:.4em;display:block}
path,circle{fill:none;stroke:var(--k,var(--line));stroke-linecap:round;vector-effect:non-scaling-stroke}
dt{font-weight:600}dd{margin:0 0 .4rem 1.2rem}";

impl fmt::Display for Html<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let document = self.document;
        let title = xml::escape(&heading(document));
        writeln!(
            f,
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
<meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n<style>\n{STYLE}\n</style></head>\n\
<body>\n<h1>{title}</h1>"
        )?;
        about::pixel(f, document)?;
        if !self.drawing.is_empty() {
            writeln!(f, "<h2>Where the rays go</h2>\n{}", self.drawing)?;
        }
        writeln!(f, "<h2>The ray tree</h2>")?;
        about::letters(f)?;
        f.write_str("<main>\n")?;
        for sample in &document.samples {
            sample::tree(f, document, sample)?;
        }
        f.write_str("</main>\n")?;
        about::truncation(f, document)?;
        missing::sentences(f, document)?;
        writeln!(f, "</body></html>")
    }
}
