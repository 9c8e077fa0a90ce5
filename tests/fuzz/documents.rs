//! Scene files, made by chance: nearly right, with all that a scene can have, and here and there what it must not have.

mod objects;

use super::dice::Dice;
use super::words::{HARD, NAMES, WRONG};

/// A scene file in the making.
pub struct Document<'d> {
    dice: &'d mut Dice,
    /// One number or name in so many is hard, and one in so many wrong.
    hard: usize,
    wrong: usize,
    names: usize,
}

/// The text of a scene file.
pub fn document(dice: &mut Dice) -> String {
    let hard = [3, 10, 100, 1000][dice.below(4)];
    let wrong = [20, 400, 1_000_000, 1_000_000][dice.below(4)];
    Document {
        dice,
        hard,
        wrong,
        names: 0,
    }
    .scene()
}

impl Document<'_> {
    fn scene(&mut self) -> String {
        let mut fields = vec![format!("\"format\": \"raytree-scene/{}\"", 1 + self.slip())];
        let camera = [("eye", 3), ("look_at", 3), ("up", 0), ("vertical_fov", 1)];
        let camera = camera.map(|(key, size)| match (key, size) {
            ("up", _) if self.dice.one_in(2) => String::new(),
            ("eye", _) => format!("\"eye\": [{}, {}, 5]", self.number(), self.number()),
            ("vertical_fov", _) => format!("\"{key}\": {}", self.angle()),
            _ => format!("\"{key}\": {}", self.vector()),
        });
        fields.push(format!("\"camera\": {{{}}}", joined(&camera)));
        let optional = [
            format!("\"name\": \"{}\"", self.name()),
            format!("\"background\": {}", self.color()),
            format!("\"ambient\": {}", self.color()),
            format!("\"settings\": {{{}}}", self.settings()),
            "\"note\": \"n\"".to_string(),
        ];
        fields.extend(optional.into_iter().filter(|_| self.dice.one_in(2)));
        let materials: Vec<_> = ["a", "b", "c"]
            .iter()
            .map(|name| format!("\"{name}\": {}", self.material()))
            .collect();
        fields.push(format!("\"materials\": {{{}}}", materials.join(",")));
        let objects: Vec<_> = (0..=self.dice.few(12)).map(|_| self.object(0)).collect();
        fields.push(format!("\"objects\": [{}]", objects.join(",\n")));
        if self.dice.one_in(3) {
            fields.push(format!("\"parts\": {{{}}}", self.parts()));
        }
        let lights: Vec<_> = (0..self.dice.few(5)).map(|_| self.light()).collect();
        fields.push(format!("\"lights\": [{}]", lights.join(",")));
        // The order of fields is free; now and then one is missing or there twice.
        let turn = self.dice.below(fields.len());
        fields.rotate_left(turn);
        if self.slip() == 1 {
            fields.pop();
        }
        if self.slip() == 1 {
            fields.push(fields[0].clone());
        }
        format!("{{{}}}", fields.join(",\n"))
    }

    /// Two parts, of which now and then the second uses the first, and seldom the first the second.
    fn parts(&mut self) -> String {
        let one = self.object(38);
        let other = self.object(38);
        let back = if self.dice.one_in(20) {
            self.used()
        } else {
            self.object(40)
        };
        let on = if self.dice.one_in(2) {
            self.used()
        } else {
            self.object(40)
        };
        format!("\"p\": [{one}, {back}], \"q\": [{other}, {on}]")
    }

    /// 1 where something shall be wrong, else 0.
    fn slip(&mut self) -> usize {
        usize::from(self.dice.one_in(self.wrong))
    }

    fn number(&mut self) -> String {
        if self.slip() == 1 {
            self.dice.pick(&WRONG).to_string()
        } else if self.dice.one_in(self.hard) {
            self.dice.pick(&HARD).to_string()
        } else if self.dice.one_in(2) {
            format!("{:.0}", self.dice.between(-4.0, 4.0))
        } else {
            format!("{:.3}", self.dice.between(-4.0, 4.0))
        }
    }

    /// From 0 up.
    fn positive(&mut self) -> String {
        let number = self.number();
        let digits = number.trim_start_matches('-');
        if digits == "0" {
            "1".to_string()
        } else {
            digits.to_string()
        }
    }

    fn or_zero(&mut self) -> String {
        if self.dice.one_in(2) {
            "0".to_string()
        } else {
            self.positive()
        }
    }

    fn vector(&mut self) -> String {
        let size = 3 + self.slip() - self.slip();
        let numbers: Vec<_> = (0..size).map(|_| self.number()).collect();
        format!("[{}]", numbers.join(","))
    }

    fn angle(&mut self) -> String {
        if self.dice.one_in(self.hard) {
            self.number()
        } else {
            format!("{:.2}", self.dice.between(1.0, 170.0))
        }
    }

    /// Channels from 0 to 1, now and then others.
    fn color(&mut self) -> String {
        let channels: Vec<_> = (0..3)
            .map(|_| match self.dice.below(self.hard) {
                0 => self.positive(),
                1 => "1e12".to_string(),
                _ => format!("{:.2}", self.dice.between(0.0, 1.0)),
            })
            .collect();
        format!("[{}]", channels.join(","))
    }

    fn material(&mut self) -> String {
        let fields = [
            Some(format!("\"diffuse\": {}", self.color())),
            self.dice
                .one_in(2)
                .then(|| String::from("\"specular\": [0.5, 0.5, 0.5], \"shininess\": 9")),
            self.dice
                .one_in(3)
                .then(|| String::from("\"mirror\": [0.5, 1, 0.9]")),
            self.dice
                .one_in(3)
                .then(|| String::from("\"transmission\": [0.9, 1, 0.5]")),
            self.dice
                .one_in(3)
                .then(|| format!("\"ior\": {}", self.positive())),
            self.dice
                .one_in(3)
                .then(|| format!("\"emission\": {}", self.color())),
            self.dice
                .one_in(4)
                .then(|| format!("\"ambient\": {}", self.color())),
            self.dice.one_in(4).then(|| {
                format!(
                    "\"checker\": {{\"diffuse\": {}, \"size\": {}}}",
                    self.color(),
                    self.positive()
                )
            }),
        ];
        let fields: Vec<_> = fields.into_iter().flatten().collect();
        format!("{{{}}}", joined(&fields))
    }

    fn settings(&mut self) -> String {
        let whole = |d: &mut Self, most: usize| match d.slip() {
            1 => d.number(),
            _ => (1 + d.dice.below(most)).to_string(),
        };
        let fields = [
            format!("\"size\": [{}, {}]", whole(self, 400), whole(self, 400)),
            format!("\"samples\": {}", whole(self, 5000)),
            format!(
                "\"sampling\": \"{}\"",
                self.dice.pick(&["regular", "jittered"])
            ),
            format!("\"light_samples\": {}", whole(self, 70_000)),
            format!(
                "\"sampler\": \"{}\"",
                self.dice.pick(&["grid", "random", "stratified", "sobol"])
            ),
            format!(
                "\"depth\": {}",
                self.dice
                    .pick(&["0", "1", "5", "1000", "1001", "4294967295"])
            ),
            format!(
                "\"min_weight\": {}",
                self.dice.pick(&["0", "0.001", "1e-320", "1e12", "2"])
            ),
            format!(
                "\"seed\": {}",
                self.dice
                    .pick(&["0", "7", "18446744073709551615", "-1", "1.5"])
            ),
            format!(
                "\"fresnel\": \"{}\"",
                self.dice.pick(&["none", "schlick", "exact"])
            ),
            format!("\"exposure\": {}", self.positive()),
        ];
        let kept: Vec<_> = fields.into_iter().filter(|_| self.dice.one_in(3)).collect();
        kept.join(",")
    }

    fn light(&mut self) -> String {
        let name = self.new_name();
        let kind = self.dice.below(4);
        let rest = match kind {
            0 => format!(
                "\"position\": {}, \"intensity\": {}",
                self.vector(),
                self.color()
            ),
            1 => format!(
                "\"direction\": {}, \"intensity\": {}",
                self.vector(),
                self.color()
            ),
            2 => format!(
                "\"position\": {}, \"look_at\": {}, \"intensity\": {}, \"cone_angle\": {}",
                self.vector(),
                self.vector(),
                self.color(),
                self.angle()
            ),
            _ => format!("\"object\": \"o{}\"", self.dice.below(6)),
        };
        let attenuation = if kind.is_multiple_of(2) && self.dice.one_in(2) {
            format!(
                ", \"attenuation\": [{}, {}, {}]",
                self.or_zero(),
                self.or_zero(),
                self.or_zero()
            )
        } else {
            String::new()
        };
        let kind = ["point", "directional", "spot", "area"][kind];
        format!("{{\"{kind}\": {{\"name\": \"{name}\", {rest}{attenuation}}}}}")
    }

    fn name(&mut self) -> String {
        self.dice.pick(&NAMES).to_string()
    }

    /// A name that nothing has yet, unless something is wrong.
    fn new_name(&mut self) -> String {
        if self.slip() == 1 {
            return self.name();
        }
        self.names += 1;
        format!("o{}", self.names - 1)
    }
}

fn joined(fields: &[String]) -> String {
    let there: Vec<_> = fields
        .iter()
        .filter(|f| !f.is_empty())
        .map(String::as_str)
        .collect();
    there.join(", ")
}
