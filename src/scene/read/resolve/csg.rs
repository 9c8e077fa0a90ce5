//! Solids that are cut from others: the tree of a scene file, with the names and materials of its leaves.

use super::checks;
use super::header::Header;
use super::resolver::Resolver;
use super::shapes::in_world;
use super::solids;
use super::transform::to_world;
use crate::geometry::{Body, Csg, CsgOp, CsgTree, HalfSpace, Polyhedron, Shape, Solid};
use crate::math::{DVec3, Transform};
use crate::scene::Leaf;
use crate::scene::check;
use crate::scene::limits::MAX_GROUP_DEPTH;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{Common, CsgFile, CsgOpFile, CsgPartFile};
use crate::scene::warning::WarningCode;

/// What the parts of a csg stand in.
#[derive(Clone)]
struct Above {
    /// What the names of the parts begin with.
    prefix: String,
    to_world: Option<Transform>,
    material: u32,
    /// Whether parts have this material and not their own.
    keeps_material: bool,
    depth: usize,
}

impl Resolver {
    /// Adds a csg as one object.
    pub fn add_csg(
        &mut self,
        file: &CsgFile,
        material: u32,
        header: &Header,
    ) -> Result<(), SceneError> {
        let above = Above {
            prefix: format!("{}/", header.name),
            to_world: header.to_world,
            material,
            keeps_material: header.material.is_some(),
            depth: 0,
        };
        let mut leaves = Vec::new();
        let tree = self.tree(file.op, &file.parts, &above, &mut leaves, &header.path)?;
        let csg = Csg::new(tree).map_err(|problem| {
            // What is wrong, then what to do.
            let (problem, cure) = problem
                .split_once(": ")
                .unwrap_or((&problem, "use fewer parts"));
            let what = format!("the csg `{}` {problem}", header.name);
            header.path.error(what, cure)
        })?;
        self.begin(header, material)?;
        if csg.bounds().is_empty() {
            let what = format!(
                "nothing is left of the csg `{}`: its parts do not meet",
                header.name
            );
            let cure = "move the parts of its intersections so that they share some space";
            self.warnings
                .add(WarningCode::EmptyCsg, header.path.error(what, cure));
            return Ok(());
        }
        self.add_shape(Shape::Body(Box::new(Body::Csg(csg))), &header.path)?;
        if let Some(object) = self.scene.objects.last_mut() {
            object.leaves = leaves;
        }
        Ok(())
    }

    fn tree<'f>(
        &mut self,
        op: CsgOpFile,
        parts: &'f [CsgPartFile],
        above: &Above,
        leaves: &mut Vec<Leaf>,
        path: &FieldPath<'f>,
    ) -> Result<CsgTree, SceneError> {
        let path = path.key("parts");
        if above.depth > MAX_GROUP_DEPTH {
            return Err(path.error(
                format!("parts are nested more than {MAX_GROUP_DEPTH} deep"),
                "put the parts of an inner csg into an outer one",
            ));
        }
        let mut trees = Vec::with_capacity(parts.len());
        for (i, part) in parts.iter().enumerate() {
            let common = part.common();
            let path = path.index(i).key(common.kind);
            trees.push(self.part(part, &common, above, leaves, &path)?);
        }
        let op = match op {
            CsgOpFile::Union => CsgOp::Union,
            CsgOpFile::Intersection => CsgOp::Intersection,
            CsgOpFile::Difference => CsgOp::Difference,
        };
        Ok(CsgTree::Op(op, trees))
    }

    fn part<'f>(
        &mut self,
        part: &'f CsgPartFile,
        common: &Common<'f>,
        above: &Above,
        leaves: &mut Vec<Leaf>,
        path: &FieldPath<'f>,
    ) -> Result<CsgTree, SceneError> {
        checks::name(common.name, &path.key("name"))?;
        check::rotations(common.transform, path, &mut self.warnings);
        let material = match common.material {
            Some(name) if !above.keeps_material => self.part_material(name, above, path)?,
            _ => above.material,
        };
        let own = Above {
            prefix: format!("{}{}/", above.prefix, common.name),
            to_world: to_world(common.transform, above.to_world.as_ref(), path)?,
            material,
            keeps_material: above.keeps_material,
            depth: above.depth + 1,
        };
        if let CsgPartFile::Csg(csg) = part {
            return self.tree(csg.op, &csg.parts, &own, leaves, path);
        }
        let name = format!("{}{}", above.prefix, common.name);
        if leaves.iter().any(|leaf: &Leaf| leaf.name == name) {
            return Err(path.key("name").error(
                format!("there are two parts named `{name}`"),
                "give one of them a different name",
            ));
        }
        leaves.push(Leaf { name, material });
        Ok(CsgTree::Leaf(solid(part, own.to_world.as_ref(), path)?))
    }

    /// The material of a part. Light passes all parts of a solid or none: what is inside is one medium, that of the whole.
    fn part_material(
        &self,
        name: &str,
        above: &Above,
        path: &FieldPath,
    ) -> Result<u32, SceneError> {
        let index = self.material(name, path)?;
        let lets_through = |i: u32| self.scene.materials[i as usize].is_transmissive();
        let whole = &self.scene.materials[above.material as usize].name;
        if lets_through(index) == lets_through(above.material) {
            return Ok(index);
        }
        Err(path.key("material").error(
            format!(
                "of `{name}` and `{whole}`, the material of the whole, only one lets light through"
            ),
            "take two transparent materials or two opaque ones: a solid is one medium inside",
        ))
    }
}

/// A leaf in the world.
fn solid(
    part: &CsgPartFile,
    map: Option<&Transform>,
    path: &FieldPath,
) -> Result<Solid, SceneError> {
    let shape = match part {
        CsgPartFile::Plane(p) => {
            let point = checks::point(p.point, &path.key("point"))?;
            let normal = checks::direction(p.normal, &path.key("normal"))?;
            let space = match map {
                Some(map) => HalfSpace::new(map.point(point), map.normal(normal)),
                None => HalfSpace::new(point, normal),
            };
            return Ok(Solid::HalfSpace(Box::new(space)));
        }
        CsgPartFile::Mesh(mesh) => {
            let points = checks::points(&mesh.vertices, &path.key("vertices"))?;
            let carried = |p: DVec3| map.map_or(p, |map| map.point(p));
            let points: Vec<DVec3> = points.into_iter().map(carried).collect();
            let polyhedron = Polyhedron::new(&points, &mesh.triangles).map_err(|problem| {
                let cure = "write a closed convex mesh, or use other solids";
                path.error(format!("the mesh `{}` {problem}", mesh.name), cure)
            })?;
            return Ok(Solid::Polyhedron(Box::new(polyhedron)));
        }
        CsgPartFile::Sphere(s) => solids::sphere(s, path)?,
        CsgPartFile::Box(b) => solids::cuboid(b, path)?,
        CsgPartFile::Cylinder(c) => solids::cylinder(c, path)?,
        CsgPartFile::Cone(c) => solids::cone(c, path)?,
        CsgPartFile::Paraboloid(p) => solids::paraboloid(p, path)?,
        CsgPartFile::Hyperboloid(h) => solids::hyperboloid(h, path)?,
        CsgPartFile::Ellipsoid(e) => solids::ellipsoid(e, path)?,
        CsgPartFile::Quadric(q) => solids::quadric(q, path)?,
        CsgPartFile::Torus(t) => solids::torus(t, path)?,
        CsgPartFile::Quartic(q) => solids::quartic(q, path)?,
        // Its parts are leaves of their own.
        CsgPartFile::Csg(csg) => return Err(path.error(format!("`{}` is no leaf", csg.name), "")),
    };
    Ok(Solid::Shape(in_world(shape, map)))
}
