//! The objects of a scene file, made by chance.

use super::Document;

impl Document<'_> {
    /// A part that is used, most likely one that is there.
    pub(super) fn used(&mut self) -> String {
        let (name, placed) = (self.new_name(), self.placed());
        let part = if self.slip() == 1 {
            "none"
        } else {
            self.dice.pick(&["p", "q"])
        };
        let material = if self.dice.one_in(4) {
            ", \"material\": \"a\""
        } else {
            ""
        };
        format!("{{\"use\": {{\"name\": \"{name}\"{placed}, \"part\": \"{part}\"{material}}}}}")
    }

    pub(super) fn object(&mut self, depth: usize) -> String {
        if depth < 40 && self.dice.one_in(if depth == 0 { 8 } else { 3 }) {
            let inner: Vec<_> = (0..=self.dice.few(2))
                .map(|_| self.object(depth + 1))
                .collect();
            let (name, placed) = (self.new_name(), self.placed());
            return format!(
                "{{\"group\": {{\"name\": \"{name}\"{placed}, \"objects\": [{}]}}}}",
                inner.join(",")
            );
        }
        if depth < 3 && self.dice.one_in(12) {
            return self.used();
        }
        if self.dice.one_in(2) {
            return self.newer(depth);
        }
        let rest = match self.dice.below(9) {
            0 => format!(
                "\"center\": {}, \"radius\": {}",
                self.vector(),
                self.positive()
            ),
            1 => format!(
                "\"point\": {}, \"normal\": {}",
                self.vector(),
                self.vector()
            ),
            2 => format!(
                "\"center\": {}, \"normal\": {}, \"radius\": {}",
                self.vector(),
                self.vector(),
                self.positive()
            ),
            3 => format!(
                "\"corners\": [{}, {}, {}]",
                self.vector(),
                self.vector(),
                self.vector()
            ),
            4 => format!(
                "\"corner\": {}, \"u\": {}, \"v\": {}",
                self.vector(),
                self.vector(),
                self.vector()
            ),
            5 => format!(
                "\"min\": [-1, {}, -2], \"max\": [{}, 2, 3]",
                self.number(),
                self.positive()
            ),
            6 => self.mesh(),
            _ => return self.obj(),
        };
        let kinds = ["sphere", "plane", "disc", "triangle", "quad", "box", "mesh"];
        let kind = kinds
            .into_iter()
            .find(|kind| belongs(kind, &rest))
            .unwrap_or("sphere");
        let material = if self.slip() == 1 {
            self.name()
        } else {
            self.dice.pick(&["a", "b", "c"]).to_string()
        };
        let (name, placed) = (self.new_name(), self.placed());
        format!(
            "{{\"{kind}\": {{\"name\": \"{name}\", \"material\": \"{material}\"{placed}, {rest}}}}}"
        )
    }

    /// A solid with parts, a polygon or a parametric surface.
    fn newer(&mut self, depth: usize) -> String {
        let (kind, rest) = match self.dice.below(10) {
            9 => ("polygon", self.polygon()),
            8 => ("bezier", self.bezier()),
            7 if depth < 40 => ("csg", self.csg(depth)),
            _ => self.solid(),
        };
        let (name, placed) = (self.new_name(), self.placed());
        format!("{{\"{kind}\": {{\"name\": \"{name}\", \"material\": \"a\"{placed}, {rest}}}}}")
    }

    /// The kind of a solid, and its own fields.
    fn solid(&mut self) -> (&'static str, String) {
        let (from, to) = (self.vector(), self.vector());
        let [r, s] = [self.positive(), self.number()];
        let open = if self.dice.one_in(4) {
            ", \"open\": true"
        } else {
            ""
        };
        let numbers = |d: &mut Self, n: usize| {
            let all: Vec<_> = (0..n - d.slip()).map(|_| d.number()).collect();
            all.join(",")
        };
        match self.dice.below(8) {
            0 => (
                "cylinder",
                format!("\"base\": {from}, \"top\": {to}, \"radius\": {r}{open}"),
            ),
            1 => (
                "cone",
                format!(
                    "\"base\": {from}, \"top\": {to}, \"radius\": {r}, \"top_radius\": {s}{open}"
                ),
            ),
            2 => (
                "paraboloid",
                format!("\"vertex\": {from}, \"top\": {to}, \"radius\": {r}{open}"),
            ),
            3 => {
                let sheets = 1 + self.dice.below(2) + self.slip();
                (
                    "hyperboloid",
                    format!(
                        "\"base\": {from}, \"top\": {to}, \"waist\": {s}, \"radius\": {r}, \"sheets\": {sheets}{open}"
                    ),
                )
            }
            4 => ("ellipsoid", format!("\"center\": {from}, \"radii\": {to}")),
            5 => {
                let all = numbers(self, 10);
                (
                    "quadric",
                    format!(
                        "\"coefficients\": [{all}], \"min\": [-1, {s}, -2], \"max\": [{r}, 2, 3]"
                    ),
                )
            }
            6 => {
                let all = numbers(self, 35);
                (
                    "quartic",
                    format!(
                        "\"coefficients\": [{all}], \"min\": [-1, {s}, -2], \"max\": [{r}, 2, 3]"
                    ),
                )
            }
            _ => (
                "torus",
                format!(
                    "\"center\": {from}, \"axis\": {to}, \"major\": {r}, \"minor\": {}",
                    self.positive()
                ),
            ),
        }
    }

    fn csg(&mut self, depth: usize) -> String {
        let op = self.dice.pick(&["union", "intersection", "difference"]);
        let parts: Vec<_> = (0..=self.dice.few(4))
            .map(|_| {
                let (kind, rest) = match self.dice.below(5) {
                    0 if depth < 40 => ("csg", self.csg(depth + 8)),
                    1 => (
                        "plane",
                        format!(
                            "\"point\": {}, \"normal\": {}",
                            self.vector(),
                            self.vector()
                        ),
                    ),
                    2 => (
                        "sphere",
                        format!(
                            "\"center\": {}, \"radius\": {}",
                            self.vector(),
                            self.positive()
                        ),
                    ),
                    _ => self.solid(),
                };
                let (name, placed) = (self.new_name(), self.placed());
                format!("{{\"{kind}\": {{\"name\": \"{name}\"{placed}, {rest}}}}}")
            })
            .collect();
        format!("\"op\": \"{op}\", \"parts\": [{}]", parts.join(","))
    }

    fn polygon(&mut self) -> String {
        let corners = |d: &mut Self| {
            let all: Vec<_> = (0..3 + d.dice.few(8)).map(|_| d.vector()).collect();
            format!("[{}]", all.join(","))
        };
        let mut polygon = format!("\"points\": {}", corners(self));
        if self.dice.one_in(3) {
            polygon += &format!(", \"holes\": [{}]", corners(self));
        }
        polygon
    }

    fn bezier(&mut self) -> String {
        let [m, n] = [1 + self.dice.below(3), 1 + self.dice.below(3)];
        let rows: Vec<_> = (0..=n)
            .map(|_| {
                let row: Vec<_> = (0..=m + self.slip()).map(|_| self.vector()).collect();
                format!("[{}]", row.join(","))
            })
            .collect();
        format!(
            "\"degree\": [{m}, {n}], \"patches\": [[{}]]",
            rows.join(",")
        )
    }

    fn obj(&mut self) -> String {
        let file = if self.dice.one_in(self.hard) {
            self.name()
        } else {
            "m.obj".to_string()
        };
        let material = if self.dice.one_in(2) {
            ", \"material\": \"a\""
        } else {
            ""
        };
        let (name, placed) = (self.new_name(), self.placed());
        format!("{{\"obj\": {{\"name\": \"{name}\"{material}{placed}, \"file\": \"{file}\"}}}}")
    }

    fn mesh(&mut self) -> String {
        let count = 3 + self.dice.few(30);
        let vertices: Vec<_> = (0..count).map(|_| self.vector()).collect();
        // More than 64 are kept once in a part.
        let least = if self.dice.one_in(8) { 65 } else { 0 };
        let triangles: Vec<_> = (0..least + self.dice.few(60))
            .map(|_| {
                let most = count + self.slip();
                let corner = |d: &mut Self| d.dice.below(most);
                format!("[{}, {}, {}]", corner(self), corner(self), corner(self))
            })
            .collect();
        let mut mesh = format!(
            "\"vertices\": [{}], \"triangles\": [{}]",
            vertices.join(","),
            triangles.join(",")
        );
        if self.dice.one_in(3) {
            let normals: Vec<_> = (0..count - self.slip()).map(|_| self.vector()).collect();
            mesh += &format!(", \"normals\": [{}]", normals.join(","));
        }
        if self.dice.one_in(3) {
            let uvs: Vec<_> = (0..count)
                .map(|_| format!("[{}, {}]", self.number(), self.number()))
                .collect();
            mesh += &format!(", \"uvs\": [{}]", uvs.join(","));
        }
        if self.dice.one_in(3) {
            let words = ["flat", "gouraud", "phong", "gourad"];
            let word = words[self.dice.below(3) + self.slip()];
            mesh += &format!(", \"shading\": \"{word}\"");
        }
        mesh
    }

    /// The transform of an object, with the comma before it; mostly none.
    fn placed(&mut self) -> String {
        if !self.dice.one_in(4) {
            return String::new();
        }
        let steps: Vec<_> = (0..self.dice.few(6))
            .map(|_| match self.dice.below(4) {
                0 => format!("{{\"translate\": {}}}", self.vector()),
                1 => format!(
                    "{{\"rotate\": {{\"axis\": {}, \"degrees\": {}}}}}",
                    self.vector(),
                    self.number()
                ),
                2 if self.dice.one_in(2) => format!("{{\"scale\": {}}}", self.number()),
                2 => format!("{{\"scale\": {}}}", self.vector()),
                _ => {
                    let row = |d: &mut Self| {
                        format!(
                            "[{}, {}, {}, {}]",
                            d.number(),
                            d.number(),
                            d.number(),
                            d.number()
                        )
                    };
                    format!(
                        "{{\"matrix\": [{}, {}, {}]}}",
                        row(self),
                        row(self),
                        row(self)
                    )
                }
            })
            .collect();
        format!(", \"transform\": [{}]", steps.join(","))
    }
}

/// True for the kind of object that has these fields.
fn belongs(kind: &str, fields: &str) -> bool {
    match kind {
        "disc" => fields.contains("normal") && fields.contains("radius"),
        "sphere" => fields.contains("radius") && !fields.contains("normal"),
        "plane" => fields.starts_with("\"point\""),
        "triangle" => fields.contains("\"corners\""),
        "quad" => fields.contains("\"corner\""),
        "box" => fields.contains("\"min\""),
        _ => fields.contains("\"vertices\""),
    }
}
