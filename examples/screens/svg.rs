//! A terminal's screen as SVG: text in runs of one style; blocks, dots and lines of boxes as shapes, so that no font matters.

use std::collections::BTreeMap;
use std::fmt::Write as _;

/// The size of a cell.
const CELL: (f64, f64) = (9.0, 18.0);
/// Space around the screen.
const MARGIN: f64 = 12.0;
const BACKGROUND: Color = (16, 16, 16);
const FOREGROUND: Color = (229, 229, 229);

type Color = (u8, u8, u8);

/// The first sixteen colours of a terminal.
const PALETTE: [u32; 16] = [
    0x00_00_00, 0xcd_31_31, 0x0d_bc_79, 0xe5_e5_10, 0x24_72_c8, 0xbc_3f_bc, 0x11_a8_cd, 0xe5_e5_e5,
    0x66_66_66, 0xf1_4c_4c, 0x23_d1_8b, 0xf5_f5_43, 0x3b_8e_ea, 0xd6_70_d6, 0x29_b8_db, 0xff_ff_ff,
];

/// Quadrants of a cell: upper left 1, upper right 2, lower left 4, lower right 8.
const QUADRANTS: [(char, u8); 13] = [
    ('▀', 3),
    ('▄', 12),
    ('█', 15),
    ('▌', 5),
    ('▐', 10),
    ('▘', 1),
    ('▝', 2),
    ('▖', 4),
    ('▗', 8),
    ('▚', 9),
    ('▞', 6),
    ('▛', 7),
    ('▟', 14),
];
const MORE_QUADRANTS: [(char, u8); 2] = [('▙', 13), ('▜', 11)];

/// Lines from the middle of a cell: up, right, down, left; 1 for a single one, 2 for a double one, 3 for a thick one.
const LINES: [(char, [u8; 4]); 33] = [
    ('─', [0, 1, 0, 1]),
    ('│', [1, 0, 1, 0]),
    ('┌', [0, 1, 1, 0]),
    ('┐', [0, 0, 1, 1]),
    ('└', [1, 1, 0, 0]),
    ('┘', [1, 0, 0, 1]),
    ('├', [1, 1, 1, 0]),
    ('┤', [1, 0, 1, 1]),
    ('┬', [0, 1, 1, 1]),
    ('┴', [1, 1, 0, 1]),
    ('┼', [1, 1, 1, 1]),
    ('═', [0, 2, 0, 2]),
    ('║', [2, 0, 2, 0]),
    ('╔', [0, 2, 2, 0]),
    ('╗', [0, 0, 2, 2]),
    ('╚', [2, 2, 0, 0]),
    ('╝', [2, 0, 0, 2]),
    ('╭', [0, 1, 1, 0]),
    ('╮', [0, 0, 1, 1]),
    ('╰', [1, 1, 0, 0]),
    ('╯', [1, 0, 0, 1]),
    ('━', [0, 3, 0, 3]),
    ('┃', [3, 0, 3, 0]),
    ('┏', [0, 3, 3, 0]),
    ('┓', [0, 0, 3, 3]),
    ('┗', [3, 3, 0, 0]),
    ('┛', [3, 0, 0, 3]),
    ('╵', [1, 0, 0, 0]),
    ('╶', [0, 1, 0, 0]),
    ('╷', [0, 0, 1, 0]),
    ('╴', [0, 0, 0, 1]),
    ('╹', [3, 0, 0, 0]),
    ('╻', [0, 0, 3, 0]),
];

/// What is drawn, before it is written.
#[derive(Default)]
struct Drawing {
    /// Backgrounds of cells, which lie below all else, by their colours.
    backs: BTreeMap<Color, String>,
    /// Blocks and dots by their colours.
    fills: BTreeMap<Color, String>,
    /// Lines by their colours.
    strokes: BTreeMap<Color, String>,
    texts: String,
}

/// The screen as an SVG file; `title` tells what it shows.
pub fn drawing(screen: &vt100::Screen, title: &str) -> String {
    let (rows, cols) = screen.size();
    let mut drawing = Drawing::default();
    for row in 0..rows {
        drawing.row(screen, row, cols);
    }
    let (width, height) = (
        f64::from(cols) * CELL.0 + 2.0 * MARGIN,
        f64::from(rows) * CELL.1 + 2.0 * MARGIN,
    );
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{title}\">\n\
         <title>{title}</title>\n<rect width=\"{width}\" height=\"{height}\" rx=\"8\" fill=\"{}\"/>\n\
         <g transform=\"translate({MARGIN} {MARGIN})\">\n",
        hex(BACKGROUND)
    );
    for (color, path) in drawing.backs.iter().chain(&drawing.fills) {
        let _ = writeln!(
            out,
            "<path shape-rendering=\"crispEdges\" fill=\"{}\" d=\"{path}\"/>",
            hex(*color)
        );
    }
    for (color, path) in &drawing.strokes {
        let _ = writeln!(
            out,
            "<path fill=\"none\" stroke=\"{}\" d=\"{path}\"/>",
            hex(*color)
        );
    }
    let _ = write!(
        out,
        "<g xml:space=\"preserve\" font-family=\"ui-monospace, Menlo, Consolas, 'DejaVu Sans Mono', monospace\" font-size=\"15\">\n{}</g>\n</g>\n</svg>\n",
        drawing.texts
    );
    out
}

impl Drawing {
    fn row(&mut self, screen: &vt100::Screen, row: u16, cols: u16) {
        let mut run = Run::default();
        let mut backs = Vec::new();
        for col in 0..cols {
            let Some(cell) = screen.cell(row, col) else {
                continue;
            };
            let (fg, bg) = colors(cell);
            backs.push(bg);
            let sign = cell.contents().chars().next().unwrap_or(' ');
            let style = (fg, cell.bold(), cell.underline());
            if self.shape(sign, fg, col, row) || (sign == ' ' && !cell.underline()) {
                run.space();
                continue;
            }
            // What is no letter may be wider or narrower in a font: it stands by itself.
            if run.style != style || !sign.is_ascii() || run.alone || run.spaces > 1 {
                run.end(&mut self.texts, row);
                run = Run {
                    style,
                    start: col,
                    alone: !sign.is_ascii(),
                    ..Run::default()
                };
            }
            run.put(cell.contents());
        }
        run.end(&mut self.texts, row);
        self.backgrounds(&backs, row);
    }

    fn backgrounds(&mut self, backs: &[Color], row: u16) {
        let y = f64::from(row) * CELL.1;
        let mut col = 0;
        while col < backs.len() {
            let same = backs[col..]
                .iter()
                .take_while(|back| **back == backs[col])
                .count();
            if backs[col] != BACKGROUND {
                let path = self.backs.entry(backs[col]).or_default();
                *path += &rectangle(col as f64 * CELL.0, y, same as f64 * CELL.0, CELL.1);
            }
            col += same;
        }
    }

    /// Draws a sign that is a shape; false if it is none.
    fn shape(&mut self, sign: char, fg: Color, col: u16, row: u16) -> bool {
        let (x, y, (w, h)) = (f64::from(col) * CELL.0, f64::from(row) * CELL.1, CELL);
        let named = |(name, _): &&(char, u8)| *name == sign;
        if let Some((_, parts)) = QUADRANTS.iter().chain(&MORE_QUADRANTS).find(named) {
            let path = self.fills.entry(fg).or_default();
            for (top, half) in [(0.0, parts & 3), (h / 2.0, parts >> 2)] {
                let (left, wide) = match half {
                    0 => continue,
                    1 => (0.0, w / 2.0),
                    2 => (w / 2.0, w / 2.0),
                    _ => (0.0, w),
                };
                *path += &rectangle(x + left, y + top, wide, h / 2.0);
            }
            return true;
        }
        if let dots @ 1..=255 = (sign as u32).wrapping_sub(0x2800) {
            const PLACES: [(u8, u8); 8] = [
                (0, 0),
                (0, 1),
                (0, 2),
                (1, 0),
                (1, 1),
                (1, 2),
                (0, 3),
                (1, 3),
            ];
            let path = self.fills.entry(fg).or_default();
            for (_, (i, j)) in (0..).zip(PLACES).filter(|(bit, _)| dots >> bit & 1 == 1) {
                *path += &rectangle(
                    x + 1.5 + f64::from(i) * 4.5,
                    y + 1.5 + f64::from(j) * 4.5,
                    2.0,
                    2.0,
                );
            }
            return true;
        }
        let Some((_, arms)) = LINES.iter().find(|(name, _)| *name == sign) else {
            return false;
        };
        let path = self.strokes.entry(fg).or_default();
        let (cx, cy) = (x + w / 2.0, y + h / 2.0);
        let ends = [(cx, y), (x + w, cy), (cx, y + h), (x, cy)];
        for ((ex, ey), arm) in ends.into_iter().zip(arms) {
            let offsets: &[f64] = match arm {
                0 => continue,
                1 => &[0.0],
                2 => &[-1.5, 1.5],
                _ => &[-1.0, 0.0, 1.0],
            };
            for off in offsets {
                let (dx, dy) = if ex == cx { (*off, 0.0) } else { (0.0, *off) };
                let _ = write!(path, "M{} {}L{} {}", cx + dx, cy + dy, ex + dx, ey + dy);
            }
        }
        true
    }
}

/// Text of one style.
#[derive(Default)]
struct Run {
    style: (Color, bool, bool),
    start: u16,
    text: String,
    cells: u16,
    spaces: u16,
    alone: bool,
}

impl Run {
    fn space(&mut self) {
        self.spaces += 1;
    }

    fn put(&mut self, sign: &str) {
        self.text += &" ".repeat(usize::from(self.spaces));
        self.text += if sign.is_empty() { " " } else { sign };
        self.cells += self.spaces + 1;
        self.spaces = 0;
    }

    fn end(&self, out: &mut String, row: u16) {
        if self.text.is_empty() {
            return;
        }
        let (x, y) = (
            f64::from(self.start) * CELL.0,
            f64::from(row) * CELL.1 + 13.5,
        );
        let ((color, bold, underline), text) = (self.style, escaped(&self.text));
        let length = f64::from(self.cells) * CELL.0;
        let bold = if bold { " font-weight=\"bold\"" } else { "" };
        let line = if underline {
            " text-decoration=\"underline\""
        } else {
            ""
        };
        let _ = writeln!(
            out,
            "<text x=\"{x}\" y=\"{y}\" textLength=\"{length}\" lengthAdjust=\"spacingAndGlyphs\" fill=\"{}\"{bold}{line}>{text}</text>",
            hex(color)
        );
    }
}

/// The colours of a cell.
fn colors(cell: &vt100::Cell) -> (Color, Color) {
    let mut fg = color(cell.fgcolor(), FOREGROUND);
    let bg = color(cell.bgcolor(), BACKGROUND);
    if cell.dim() {
        let half = |a: u8, b: u8| (u16::from(a) * 6 / 10 + u16::from(b) * 4 / 10) as u8;
        fg = (half(fg.0, bg.0), half(fg.1, bg.1), half(fg.2, bg.2));
    }
    if cell.inverse() { (bg, fg) } else { (fg, bg) }
}

fn color(color: vt100::Color, default: Color) -> Color {
    match color {
        vt100::Color::Default => default,
        vt100::Color::Rgb(r, g, b) => (r, g, b),
        vt100::Color::Idx(n @ 0..16) => {
            let [_, r, g, b] = PALETTE[usize::from(n)].to_be_bytes();
            (r, g, b)
        }
        vt100::Color::Idx(n @ 16..232) => {
            let step = |i: u8| if i == 0 { 0 } else { 55 + 40 * i };
            let n = n - 16;
            (step(n / 36), step(n / 6 % 6), step(n % 6))
        }
        vt100::Color::Idx(n) => {
            let grey = 8 + 10 * (n - 232);
            (grey, grey, grey)
        }
    }
}

fn rectangle(x: f64, y: f64, w: f64, h: f64) -> String {
    format!("M{x} {y}h{w}v{h}h{}z", -w)
}

fn hex((r, g, b): Color) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
