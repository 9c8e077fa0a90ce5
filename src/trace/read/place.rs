//! Where in a document something stands: the path of a field, such as `root.children[1].direction[0]`.

use std::fmt;

/// Where the rays of a document stand.
#[derive(Debug, Default)]
pub struct RayPlaces(pub Vec<RayPlace>);

/// Where a ray stands.
#[derive(Clone, Copy, Debug)]
pub enum RayPlace {
    /// `root`.
    Root,
    /// `samples[n].root`.
    SampleRoot(usize),
    /// The document itself, as in a line of flat rays.
    Top,
    /// One of the children of ray number `.0`.
    Child(usize, usize),
}

/// Where something stands.
#[derive(Clone, Copy)]
pub enum FieldPlace<'a> {
    /// The whole document.
    Top,
    /// A ray, by its number among those of the document.
    Ray(&'a RayPlaces, usize),
    /// A field of an object.
    Key(&'a FieldPlace<'a>, &'a str),
    /// An item of a list.
    Item(&'a FieldPlace<'a>, usize),
}

impl FieldPlace<'_> {
    /// The field of this name.
    pub fn key<'b>(&'b self, name: &'b str) -> FieldPlace<'b> {
        FieldPlace::Key(self, name)
    }

    /// The item of this number.
    pub fn item(&self, index: usize) -> FieldPlace<'_> {
        FieldPlace::Item(self, index)
    }
}

impl RayPlaces {
    fn path(&self, ray: usize) -> String {
        let mut children = Vec::new();
        let mut place = self.0[ray];
        let start = loop {
            match place {
                RayPlace::Child(parent, child) => {
                    children.push(child);
                    place = self.0[parent];
                }
                RayPlace::Root => break "root".to_owned(),
                RayPlace::SampleRoot(n) => break format!("samples[{n}].root"),
                RayPlace::Top => break String::new(),
            }
        };
        let children = children
            .iter()
            .rev()
            .map(|child| format!(".children[{child}]"));
        let path = start + &children.collect::<String>();
        path.strip_prefix('.').map_or(path.clone(), str::to_owned)
    }
}

impl fmt::Display for FieldPlace<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Top => Ok(()),
            Self::Ray(places, ray) => f.write_str(&places.path(*ray)),
            Self::Key(of, name) => {
                let outer = of.to_string();
                let dot = if outer.is_empty() { "" } else { "." };
                write!(f, "{outer}{dot}{name}")
            }
            Self::Item(of, index) => write!(f, "{of}[{index}]"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_paths() {
        let places = RayPlaces(vec![
            RayPlace::SampleRoot(2),
            RayPlace::Child(0, 1),
            RayPlace::Child(1, 0),
        ]);
        let ray = FieldPlace::Ray(&places, 2);
        let hit = ray.key("hit");
        let point = hit.key("point");
        assert_eq!(
            point.item(1).to_string(),
            "samples[2].root.children[1].children[0].hit.point[1]"
        );
        let flat = RayPlaces(vec![RayPlace::Top, RayPlace::Child(0, 3)]);
        assert_eq!(FieldPlace::Ray(&flat, 0).key("ior").to_string(), "ior");
        assert_eq!(
            FieldPlace::Ray(&flat, 1).key("ior").to_string(),
            "children[3].ior"
        );
        assert_eq!(FieldPlace::Top.key("pixel").item(0).to_string(), "pixel[0]");
    }
}
