//! Objects: their names, their materials, and their shapes in the world.

use super::checks::{self, direction, point, positive};
use super::placement::placed;
use super::{Builder, shapes};
use crate::geometry::{Aabb, Shape, Sphere, Triangle};
use crate::math::{DVec2, DVec3, Transform};
use crate::scene::error::{Place, Problem, SceneError};
use crate::scene::file::{MeshFile, ObjFile, ObjectFile, TransformStep, Vector};
use crate::scene::limits::{MAX_COORDINATE, MAX_GROUP_DEPTH, MAX_PRIMITIVES};
use crate::scene::mesh::Mesh;
use crate::scene::nearest::nearest;
use crate::scene::{Object, VertexData, obj};
use crate::shading::Material;

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
struct Header<'a> {
    name: String,
    map: Option<Transform>,
    place: Place<'a>,
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
    fn material(&self, name: &str, place: &Place) -> Result<u32, SceneError> {
        let names = || self.scene.materials.iter().map(|m| m.name.as_str());
        if let Some(i) = names().position(|known| known == name) {
            return Ok(i as u32);
        }
        let listed = names().take(12).collect::<Vec<_>>().join(", ");
        let cure = match nearest(name, names()) {
            Some(near) => format!("did you mean `{near}`? There are: {listed}"),
            None if listed.is_empty() => format!("describe it: \"materials\": {{\"{name}\": ...}}"),
            None => format!("describe it under \"materials\", or use one of: {listed}"),
        };
        let place = place.key("material");
        Err(place.error(format!("there is no material `{name}`"), cure))
    }

    /// Begins an object: what is put in from now on belongs to it.
    fn begin(&mut self, name: &str, material: u32, place: &Place) -> Result<(), SceneError> {
        checks::name(name, &place.key("name"))?;
        if !self.names.insert(name.to_string()) {
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
    fn put(&mut self, shape: Shape, place: &Place) -> Result<(), SceneError> {
        if self.scene.shapes.len() >= MAX_PRIMITIVES {
            return Err(place.error(
                format!("the scene has more than {MAX_PRIMITIVES} triangles and other shapes"),
                "use models with fewer triangles",
            ));
        }
        if let Some(bounds) = shape.bounds() {
            near(bounds.min, place)?;
            near(bounds.max, place)?;
        }
        self.scene.shapes.push(shape);
        self.scene.owners.push(self.scene.objects.len() as u32 - 1);
        Ok(())
    }

    fn single(&mut self, header: &Header, material: u32, shape: Shape) -> Result<(), SceneError> {
        self.begin(&header.name, material, &header.place)?;
        self.put(shape, &header.place)
    }

    /// Puts in a mesh. Triangles without area are left out: nothing can hit them, and they have no normal.
    fn mesh(&mut self, header: &Header, material: u32, mesh: Mesh) -> Result<(), SceneError> {
        self.begin(&header.name, material, &header.place)?;
        let Mesh {
            mut points,
            triangles,
            lines,
            mut corners,
        } = mesh;
        let mut mirrored = false;
        if let Some(map) = &header.map {
            points.iter_mut().for_each(|p| *p = map.point(*p));
            let turned = |n: &DVec3| {
                if *n == DVec3::ZERO {
                    *n
                } else {
                    map.normal(*n)
                }
            };
            corners.normals.iter_mut().for_each(|n| *n = turned(n));
            mirrored = map.flips_handedness();
        }
        // In a mirror, what ran counter-clockwise runs clockwise.
        let order = |t: [u32; 3]| if mirrored { [t[0], t[2], t[1]] } else { t };
        let mut kept = VertexData {
            normals: corners.normals,
            uvs: corners.uvs,
            ..VertexData::default()
        };
        let (mut flat, mut first) = (0, 0);
        for (i, t) in triangles.iter().enumerate() {
            let triangle = Triangle {
                corners: order(*t).map(|i| points[i as usize]),
            };
            if triangle.normal().is_none() {
                first = if flat == 0 { i } else { first };
                flat += 1;
                continue;
            }
            self.put(Shape::Triangle(triangle), &header.place)?;
            kept.normal_indices
                .extend(corners.normal_indices.get(i).copied().map(order));
            kept.uv_indices
                .extend(corners.uv_indices.get(i).copied().map(order));
        }
        if flat > 0 {
            let which = match lines.get(first) {
                Some(line) => format!("the first is on line {line}"),
                None => format!("the first is number {first}"),
            };
            self.warn(&format!(
                "object `{}`: {flat} of {} triangles have no area ({which}): they are left out",
                header.name,
                triangles.len()
            ));
        }
        let plain = kept.normal_indices.is_empty() && kept.uv_indices.is_empty();
        if let Some(object) = self.scene.objects.last_mut() {
            object.vertices = (!plain).then_some(kept);
        }
        Ok(())
    }

    /// Puts in what an OBJ file holds: with a material from the scene file one object, else one for each part.
    fn obj(&mut self, file: &ObjFile, header: &Header) -> Result<(), SceneError> {
        let material = match &file.material {
            Some(name) => Some(self.material(name, &header.place)?),
            None => None,
        };
        let place = header.place.key("file");
        let text = self.files.read(&file.file).map_err(|p| place.wrap(p))?;
        let text = text.ok_or_else(|| {
            place.error(
                format!("there is no file `{}`", file.file),
                "check the spelling; the path starts in the folder of the scene file",
            )
        })?;
        let own_materials = material.is_none();
        let read = obj::parse(&text, &file.file, &mut self.files, own_materials)?;
        read.warnings.iter().for_each(|w| self.warn(w));

        if let Some(material) = material {
            let mut whole = Mesh::default();
            for part in read.parts {
                whole.append(part.mesh);
            }
            return self.mesh(header, material, whole);
        }
        let mut numbers = Vec::with_capacity(read.materials.len());
        for found in read.materials {
            numbers.push(self.own_material(found, &header.name, &header.place)?);
        }
        let several = read.parts.len() > 1;
        for (i, part) in read.parts.into_iter().enumerate() {
            let material = match part.material.and_then(|m| numbers.get(m)) {
                Some(material) => *material,
                None => self.grey(&header.place)?,
            };
            let name = if several {
                self.part_name(&header.name, &part.name, i)
            } else {
                header.name.clone()
            };
            let header = Header {
                name,
                map: header.map,
                place: header.place.clone(),
            };
            self.mesh(&header, material, part.mesh)?;
        }
        Ok(())
    }

    /// A name that no other object has: the part's own, or its number.
    fn part_name(&self, object: &str, part: &str, number: usize) -> String {
        let part = if part.is_empty() { "part" } else { part };
        let name = format!("{object}/{part}");
        if self.names.contains(&name) {
            format!("{name}#{number}")
        } else {
            name
        }
    }

    /// A material of an MTL file. If the scene has one of that name already, the object's name goes before it.
    fn own_material(
        &mut self,
        mut material: Material,
        object: &str,
        place: &Place,
    ) -> Result<u32, SceneError> {
        let known = |name: &str| self.scene.materials.iter().any(|m| m.name == name);
        if known(&material.name) {
            material.name = format!("{object}/{}", material.name);
        }
        let number = self.scene.materials.len();
        if known(&material.name) {
            material.name = format!("{}#{number}", material.name);
        }
        checks::name(&material.name, place)?;
        self.scene.materials.push(material);
        Ok(number as u32)
    }

    /// The material of what has none.
    fn grey(&mut self, place: &Place) -> Result<u32, SceneError> {
        let name = "grey (no material given)";
        if let Some(i) = self.scene.materials.iter().position(|m| m.name == name) {
            return Ok(i as u32);
        }
        let grey = obj::default_material(name);
        self.own_material(grey, "", place)
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

fn points(list: &[Vector], place: &Place) -> Result<Vec<DVec3>, SceneError> {
    let inside = |v: &Vector| v.iter().all(|c| c.abs() <= MAX_COORDINATE);
    if let Some(i) = list.iter().position(|v| !inside(v)) {
        point(list[i], &place.index(i))?;
    }
    Ok(list.iter().copied().map(DVec3::from).collect())
}

fn directions(list: &[Vector], place: &Place) -> Result<Vec<DVec3>, SceneError> {
    let unit = |(i, v): (usize, &Vector)| direction(*v, &place.index(i));
    list.iter().enumerate().map(unit).collect()
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

/// The two triangles of a parallelogram.
fn quad(corner: DVec3, u: DVec3, v: DVec3) -> Mesh {
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    Mesh {
        points: vec![corner, corner + u, corner + u + v, corner + v],
        corners: VertexData {
            uv_indices: triangles.clone(),
            uvs: vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y],
            ..VertexData::default()
        },
        triangles,
        ..Mesh::default()
    }
}

/// The mesh that stands in the scene file.
fn inline(file: &MeshFile, place: &Place) -> Result<Mesh, SceneError> {
    let count = file.vertices.len();
    for (i, triangle) in file.triangles.iter().enumerate() {
        for (j, index) in triangle.iter().enumerate() {
            if *index as usize >= count {
                return Err(place.key("triangles").index(i).index(j).error(
                    format!("there is no vertex {index}"),
                    format!("there are {count} vertices, counted from 0"),
                ));
            }
        }
    }
    let same = |found: usize, key: &str| {
        if found == count {
            return Ok(());
        }
        Err(place.key(key).error(
            format!("there are {found} {key} for {count} vertices"),
            "give one for each vertex, or none at all",
        ))
    };
    let mut corners = VertexData::default();
    if let Some(normals) = &file.normals {
        same(normals.len(), "normals")?;
        corners.normals = directions(normals, &place.key("normals"))?;
        corners.normal_indices.clone_from(&file.triangles);
    }
    if let Some(uvs) = &file.uvs {
        same(uvs.len(), "uvs")?;
        for (i, [u, v]) in uvs.iter().enumerate() {
            point([*u, *v, 0.0], &place.key("uvs").index(i))?;
        }
        corners.uvs = uvs.iter().copied().map(DVec2::from).collect();
        corners.uv_indices.clone_from(&file.triangles);
    }
    Ok(Mesh {
        points: points(&file.vertices, &place.key("vertices"))?,
        triangles: file.triangles.clone(),
        lines: Vec::new(),
        corners,
    })
}
