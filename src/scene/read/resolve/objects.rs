//! Objects: their names, their materials, and their shapes in the world.

use rayon::prelude::*;

use super::checks::{self, direction, point, positive};
use super::meshes::{directions, inline, points, quad};
use super::placement::placed;
use super::{Builder, shapes};
use crate::geometry::{Aabb, Disc, Shape, Sphere, Triangle};
use crate::math::{DVec3, Transform};
use crate::scene::limits::{MAX_COORDINATE, MAX_GROUP_DEPTH, MAX_PRIMITIVES};
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::{Place, Problem, SceneError};
use crate::scene::read::file::{ObjectFile, TransformStep, Vector};
use crate::scene::read::mesh::Mesh;
use crate::scene::{Object, VertexData};

/// The group that objects stand in.
#[derive(Clone, Debug, Default)]
struct Group {
    /// What their names begin with.
    prefix: String,
    /// Where it is placed.
    map: Option<Transform>,
    depth: usize,
}

/// An object whose name and placing are known.
pub struct Header<'a> {
    /// Its name with those of its groups.
    pub name: String,
    /// Its way into the world.
    pub map: Option<Transform>,
    /// Its place in the file.
    pub place: Place<'a>,
}

impl Builder {
    /// All objects of the file.
    pub fn objects(&mut self, objects: &[ObjectFile], place: &Place) -> Result<(), SceneError> {
        self.group(objects, &Group::default(), place)
    }

    fn group(
        &mut self,
        objects: &[ObjectFile],
        group: &Group,
        place: &Place,
    ) -> Result<(), SceneError> {
        if group.depth > MAX_GROUP_DEPTH {
            return Err(place.error(
                format!("groups are nested more than {MAX_GROUP_DEPTH} deep"),
                "put the objects of an inner group into an outer one",
            ));
        }
        for (i, object) in objects.iter().enumerate() {
            self.object(object, group, &place.index(i))?;
        }
        Ok(())
    }

    fn object(
        &mut self,
        object: &ObjectFile,
        group: &Group,
        place: &Place,
    ) -> Result<(), SceneError> {
        match object {
            ObjectFile::Sphere(s) => {
                let place = place.key("sphere");
                let center = point(s.center, &place.key("center"))?;
                let radius = positive(s.radius, &place.key("radius"))?;
                let header = header(&s.name, &s.transform, group, place)?;
                let material = self.material(&s.material, &header.place)?;
                let turn_shows = self.scene.materials[material as usize].checker.is_some();
                let sphere = Sphere { center, radius };
                let shape = shapes::sphere(sphere, header.map.as_ref(), turn_shows);
                self.single(&header, material, shape)
            }
            ObjectFile::Disc(d) => {
                let place = place.key("disc");
                let center = point(d.center, &place.key("center"))?;
                let normal = direction(d.normal, &place.key("normal"))?;
                let radius = positive(d.radius, &place.key("radius"))?;
                let header = header(&d.name, &d.transform, group, place)?;
                let material = self.material(&d.material, &header.place)?;
                let disc = Disc::new(center, normal, radius);
                let turn_shows = self.scene.materials[material as usize].checker.is_some();
                let shape = shapes::disc(disc, header.map.as_ref(), turn_shows);
                self.single(&header, material, shape)
            }
            ObjectFile::Plane(p) => {
                let place = place.key("plane");
                let point = point(p.point, &place.key("point"))?;
                let normal = direction(p.normal, &place.key("normal"))?;
                let header = header(&p.name, &p.transform, group, place)?;
                let material = self.material(&p.material, &header.place)?;
                let at = header.map.map_or(point, |map| map.point(point));
                near(at, &header.place)?;
                let shape = shapes::plane(point, normal, header.map.as_ref());
                self.single(&header, material, shape)
            }
            ObjectFile::Box(b) => {
                let place = place.key("box");
                let bounds = bounds(b.min, b.max, &place)?;
                let header = header(&b.name, &b.transform, group, place)?;
                let material = self.material(&b.material, &header.place)?;
                let shape = shapes::cuboid(bounds, header.map.as_ref());
                self.single(&header, material, shape)
            }
            ObjectFile::Triangle(t) => {
                let place = place.key("triangle");
                let mesh = Mesh {
                    points: points(&t.corners, &place.key("corners"))?,
                    triangles: vec![[0, 1, 2]],
                    corners: match &t.normals {
                        None => VertexData::default(),
                        Some(normals) => VertexData {
                            normals: directions(normals, &place.key("normals"))?,
                            normal_indices: vec![[0, 1, 2]],
                            ..VertexData::default()
                        },
                    },
                    ..Mesh::default()
                };
                let header = header(&t.name, &t.transform, group, place)?;
                let material = self.material(&t.material, &header.place)?;
                self.mesh(&header, material, mesh)
            }
            ObjectFile::Quad(q) => {
                let place = place.key("quad");
                let corner = point(q.corner, &place.key("corner"))?;
                let u = point(q.u, &place.key("u"))?;
                let v = point(q.v, &place.key("v"))?;
                let header = header(&q.name, &q.transform, group, place)?;
                let material = self.material(&q.material, &header.place)?;
                self.mesh(&header, material, quad(corner, u, v))
            }
            ObjectFile::Mesh(m) => {
                let place = place.key("mesh");
                let mesh = inline(m, &place)?;
                let header = header(&m.name, &m.transform, group, place)?;
                let material = self.material(&m.material, &header.place)?;
                self.mesh(&header, material, mesh)
            }
            ObjectFile::Obj(o) => {
                let header = header(&o.name, &o.transform, group, place.key("obj"))?;
                self.obj(o, &header)
            }
            ObjectFile::Group(g) => {
                let header = header(&g.name, &g.transform, group, place.key("group"))?;
                let inner = Group {
                    prefix: format!("{}/", header.name),
                    map: header.map,
                    depth: group.depth + 1,
                };
                self.group(&g.objects, &inner, &header.place.key("objects"))
            }
        }
    }

    /// The number of the material with this name.
    pub fn material(&self, name: &str, place: &Place) -> Result<u32, SceneError> {
        if let Some(&number) = self.known_materials.get(name) {
            return Ok(number);
        }
        let names = || self.scene.materials.iter().map(|m| m.name.as_str());
        let listed = names().take(12).collect::<Vec<_>>().join(", ");
        let cure = match did_you_mean(name, names()) {
            Some(near) => format!("did you mean `{near}`? There are: {listed}"),
            None if listed.is_empty() => format!("describe it: \"materials\": {{\"{name}\": ...}}"),
            None => format!("describe it under \"materials\", or use one of: {listed}"),
        };
        let place = place.key("material");
        Err(place.error(format!("there is no material `{name}`"), cure))
    }

    /// Begins an object: what is put in from now on belongs to it.
    pub fn begin(&mut self, name: &str, material: u32, place: &Place) -> Result<(), SceneError> {
        checks::name(name, &place.key("name"))?;
        let number = self.scene.objects.len() as u32;
        if self.names.insert(name.to_string(), number).is_some() {
            return Err(place.key("name").error(
                format!("there are two objects named `{name}`"),
                "give one of them a different name",
            ));
        }
        self.scene.objects.push(Object {
            name: name.to_string(),
            material,
            first_primitive: self.scene.shapes.len() as u32,
            vertices: None,
        });
        Ok(())
    }

    /// Puts a shape into the object that was begun last.
    pub fn put(&mut self, shape: Shape, place: &Place) -> Result<(), SceneError> {
        self.make_room(1, place)?;
        if let Some(bounds) = shape.bounds() {
            near(bounds.min, place)?;
            near(bounds.max, place)?;
        }
        self.scene.shapes.push(shape);
        self.scene.owners.push(self.scene.objects.len() as u32 - 1);
        Ok(())
    }

    /// Puts triangles into it; `make` finds the corners of one.
    pub fn put_all(
        &mut self,
        triangles: &[[u32; 3]],
        make: impl Fn(&[u32; 3]) -> Triangle + Sync,
        place: &Place,
    ) -> Result<(), SceneError> {
        self.make_room(triangles.len(), place)?;
        let corners = |t| make(t).corners.map(DVec3::abs);
        let reach = triangles
            .par_iter()
            .map(|t| corners(t).into_iter().fold(DVec3::ZERO, DVec3::max))
            .reduce(|| DVec3::ZERO, DVec3::max);
        near(reach, place)?;
        let shapes = &mut self.scene.shapes;
        shapes.reserve(triangles.len());
        shapes.par_extend(triangles.par_iter().map(|t| Shape::Triangle(make(t))));
        let owner = self.scene.objects.len() as u32 - 1;
        self.scene.owners.resize(shapes.len(), owner);
        Ok(())
    }

    /// Makes room for so many more objects and shapes, if there may be so many.
    pub fn expect(
        &mut self,
        objects: usize,
        shapes: usize,
        place: &Place,
    ) -> Result<(), SceneError> {
        self.make_room(shapes, place)?;
        self.scene.shapes.reserve(shapes);
        self.scene.objects.reserve(objects);
        self.names.reserve(objects);
        Ok(())
    }

    fn make_room(&self, more: usize, place: &Place) -> Result<(), SceneError> {
        if self.scene.shapes.len() + more <= MAX_PRIMITIVES {
            return Ok(());
        }
        Err(place.error(
            format!("the scene has more than {MAX_PRIMITIVES} triangles and other shapes"),
            "use models with fewer triangles",
        ))
    }

    fn single(&mut self, header: &Header, material: u32, shape: Shape) -> Result<(), SceneError> {
        self.begin(&header.name, material, &header.place)?;
        self.put(shape, &header.place)
    }
}

/// The full name of an object and its way into the world.
fn header<'a>(
    name: &str,
    steps: &[TransformStep],
    group: &Group,
    place: Place<'a>,
) -> Result<Header<'a>, SceneError> {
    checks::name(name, &place.key("name"))?;
    Ok(Header {
        name: format!("{}{name}", group.prefix),
        map: placed(steps, group.map.as_ref(), &place)?,
        place,
    })
}

/// Refuses what lies too far away, after all transforms.
fn near(p: DVec3, place: &Place) -> Result<(), SceneError> {
    if p.abs()
        .cmple(DVec3::splat(MAX_COORDINATE * 1.000_001))
        .all()
    {
        return Ok(());
    }
    Err(place.wrap(Problem::new(
        format!("the object reaches farther than {MAX_COORDINATE:e} metres from the origin"),
        "move it nearer, or make it smaller",
    )))
}

fn bounds(min: Vector, max: Vector, place: &Place) -> Result<Aabb, SceneError> {
    let min = point(min, &place.key("min"))?;
    let max = point(max, &place.key("max"))?;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if min[axis] >= max[axis] {
            return Err(place.error(
                format!(
                    "along {name} the box goes from min {} to max {}",
                    min[axis], max[axis]
                ),
                "make every number of `min` smaller than that of `max`; for a flat thing use a quad",
            ));
        }
    }
    Ok(Aabb { min, max })
}
