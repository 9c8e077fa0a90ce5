//! Surfaces as scenes hold them: Bezier patches and NURBS, checked and cut into leaves.

use glam::DVec4;

use super::grid::MAX_DEGREE;
use super::{SurfacePatch, knots, leaves};
use crate::math::DVec3;
use crate::math::rounding::gamma;

/// Bezier patches that form one surface. u and v run over each patch from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct BezierSurface {
    /// The degrees along u and along v, 1 to 5.
    pub degree: [usize; 2],
    /// The patches: each `degree[1] + 1` rows of `degree[0] + 1` points. A row runs along u.
    pub patches: Vec<Vec<Vec<DVec3>>>,
    /// The weights of the points, above 0; `None` if all are 1.
    pub weights: Option<Vec<Vec<Vec<f64>>>>,
    /// Of leaves of a larger surface, which are not cut further: u and v at the first corner of each and at its last. `None` if they
    /// run from 0 to 1.
    pub ranges: Option<Vec<[[f64; 2]; 2]>>,
}

/// A non-uniform rational B-spline surface. u and v run from 0 to 1 over all of it.
#[derive(Clone, Debug, PartialEq)]
pub struct NurbsSurface {
    /// The degrees along u and along v, 1 to 5.
    pub degree: [usize; 2],
    /// The knots along u and along v: never falling, as many as there are points plus the degree plus 1.
    pub knots: [Vec<f64>; 2],
    /// The points, in rows along u.
    pub points: Vec<Vec<DVec3>>,
    /// The weights of the points, above 0; `None` if all are 1.
    pub weights: Option<Vec<Vec<f64>>>,
}

impl BezierSurface {
    /// The surface as leaves, or what is wrong with it.
    pub fn leaves(&self) -> Result<Vec<SurfacePatch>, String> {
        check_degree(self.degree)?;
        if let Some(weights) = &self.weights
            && weights.len() != self.patches.len()
        {
            return Err(format!(
                "there are {} patches but weights for {}: give each patch its weights, or leave them out",
                self.patches.len(),
                weights.len()
            ));
        }
        if let Some(ranges) = &self.ranges
            && ranges.len() != self.patches.len()
        {
            return Err(format!(
                "there are {} patches but ranges for {}: give each patch its range, or leave them out",
                self.patches.len(),
                ranges.len()
            ));
        }
        let size = self.degree.map(|d| d + 1);
        let range = |i: usize| {
            self.ranges
                .as_ref()
                .map_or([[0.0; 2], [1.0; 2]], |all| all[i])
        };
        let mut patches = Vec::new();
        for (i, points) in self.patches.iter().enumerate() {
            let weights = self.weights.as_ref().map(|w| w[i].as_slice());
            let named = |error| format!("patch {i}: {error}");
            let rows = weighted(points, weights).map_err(named)?;
            if [rows[0].len(), rows.len()] != size {
                return Err(named(format!(
                    "it has {} rows of {} points; degree {:?} takes {} rows of {}",
                    rows.len(),
                    rows[0].len(),
                    self.degree,
                    size[1],
                    size[0]
                )));
            }
            patches.push(SurfacePatch::new(size, rows.concat().into(), range(i)));
        }
        if self.ranges.is_some() {
            return Ok(patches);
        }
        leaves::cut(&patches)
    }
}

impl NurbsSurface {
    /// The surface as leaves, or what is wrong with it.
    pub fn leaves(&self) -> Result<Vec<SurfacePatch>, String> {
        check_degree(self.degree)?;
        let rows = weighted(&self.points, self.weights.as_deref())?;
        let [p, q] = self.degree;
        check_knots("u", p, &self.knots[0], rows[0].len())?;
        check_knots("v", q, &self.knots[1], rows.len())?;
        // First every row along u, then, of each piece of it, every column along v.
        let along_u: Vec<Vec<knots::Piece>> = rows
            .iter()
            .map(|row| knots::pieces(p, &self.knots[0], row))
            .collect();
        let mut columns = columns(&along_u);
        weld(&mut columns);
        let along_v: Vec<Vec<knots::Piece>> = columns
            .iter()
            .map(|column| knots::pieces(q, &self.knots[1], column))
            .collect();
        let mut rows = self::columns(&along_v);
        weld(&mut rows);
        let unit = |knots: &[f64], degree: usize, x: f64| {
            let (first, last) = (knots[degree], knots[knots.len() - 1 - degree]);
            (x - first) / (last - first)
        };
        let mut patches = Vec::new();
        for (j, v) in along_v[0].iter().enumerate() {
            for (i, u) in along_u[0].iter().enumerate() {
                let part = rows[j * q..=(j + 1) * q]
                    .iter()
                    .flat_map(|row| &row[i * p..=(i + 1) * p]);
                let ends = |k: usize| {
                    let place = [
                        (&self.knots[0], p, u.ends[k]),
                        (&self.knots[1], q, v.ends[k]),
                    ];
                    place.map(|(knots, degree, x)| unit(knots, degree, x))
                };
                let (size, control) = ([p + 1, q + 1], part.copied().collect());
                patches.push(SurfacePatch::new(size, control, [ends(0), ends(1)]));
            }
        }
        leaves::cut(&patches)
    }
}

/// The pieces of rows, as columns across them. Pieces that follow each other share a point, which is taken once.
fn columns(rows: &[Vec<knots::Piece>]) -> Vec<Vec<DVec4>> {
    let joined = |pieces: &Vec<knots::Piece>| -> Vec<DVec4> {
        let first = pieces[0].points[0];
        std::iter::once(first)
            .chain(
                pieces
                    .iter()
                    .flat_map(|piece| piece.points[1..].iter().copied()),
            )
            .collect()
    };
    let rows: Vec<Vec<DVec4>> = rows.iter().map(joined).collect();
    (0..rows[0].len())
        .map(|i| rows.iter().map(|row| row[i]).collect())
        .collect()
}

/// Makes the last row the first one to the bit if they differ by rounding only: a surface closed by knots that go on beyond its
/// ends computes both.
fn weld(rows: &mut [Vec<DVec4>]) {
    let largest = rows
        .iter()
        .flatten()
        .map(|p| p.abs().max_element())
        .fold(0.0, f64::max);
    let [first, .., last] = rows else { return };
    let same = first
        .iter()
        .zip(last.iter())
        .all(|(a, b)| (*a - *b).abs().max_element() <= gamma(64) * largest);
    if same {
        last.clone_from(first);
    }
}

fn check_degree(degree: [usize; 2]) -> Result<(), String> {
    if degree.iter().all(|d| (1..=MAX_DEGREE).contains(d)) {
        Ok(())
    } else {
        Err(format!(
            "the degrees are {degree:?}; each must be 1 to {MAX_DEGREE}"
        ))
    }
}

/// The points with their weights, in rows of equal length.
fn weighted(
    points: &[Vec<DVec3>],
    weights: Option<&[Vec<f64>]>,
) -> Result<Vec<Vec<DVec4>>, String> {
    let length = points.first().map_or(0, Vec::len);
    if length == 0 {
        return Err("there are no points: give rows of points".to_owned());
    }
    if let Some(row) = points.iter().position(|row| row.len() != length) {
        return Err(format!(
            "row {row} has {} points and row 0 has {length}: give all rows equally many",
            points[row].len()
        ));
    }
    if weights.is_some_and(|w| w.len() != points.len() || w.iter().any(|row| row.len() != length)) {
        return Err(format!(
            "give {} rows of {length} weights, as of points, or leave them out",
            points.len()
        ));
    }
    if let Some(p) = points
        .iter()
        .flatten()
        .find(|p| !p.is_finite() || p.abs().max_element() >= 1e150)
    {
        return Err(format!(
            "the point {p} is not finite, or too far away to compute with"
        ));
    }
    let good = |w: &f64| (1e-150..1e150).contains(w);
    if let Some(w) = weights.and_then(|rows| rows.iter().flatten().find(|w| !good(w))) {
        return Err(format!(
            "the weight {w} must be a finite number above 0: the surface would leave its points' hull"
        ));
    }
    let weight = |j: usize, i: usize| weights.map_or(1.0, |rows| rows[j][i]);
    let rows = points.iter().enumerate();
    Ok(rows
        .map(|(j, row)| {
            row.iter()
                .enumerate()
                .map(|(i, p)| p.extend(weight(j, i)))
                .collect()
        })
        .collect())
}

fn check_knots(axis: &str, degree: usize, knots: &[f64], points: usize) -> Result<(), String> {
    if points <= degree {
        return Err(format!(
            "degree {degree} along {axis} takes at least {} points there, not {points}",
            degree + 1
        ));
    }
    let expected = points + degree + 1;
    if knots.len() != expected {
        return Err(format!(
            "there are {} knots along {axis}; {points} points of degree {degree} take {points} + {degree} + 1 = {expected}",
            knots.len()
        ));
    }
    if let Some(knot) = knots.iter().find(|k| !k.is_finite()) {
        return Err(format!(
            "the knot {knot} along {axis} is not a finite number"
        ));
    }
    if let Some(i) = (1..expected).find(|i| knots[i - 1] > knots[*i]) {
        return Err(format!(
            "the knots along {axis} fall from {} to {}: sort them",
            knots[i - 1],
            knots[i]
        ));
    }
    let (first, last) = (knots[degree], knots[points]);
    if first >= last {
        return Err(format!(
            "the knots along {axis} leave nothing between {first} and {last}: spread them out"
        ));
    }
    let torn = |i: &usize| knots[*i] == knots[i + degree] && first < knots[*i] && knots[*i] < last;
    if let Some(i) = (0..points).find(torn) {
        return Err(format!(
            "the knot {} along {axis} repeats more than {degree} times, which tears the surface: make two \
             surfaces of it",
            knots[i]
        ));
    }
    Ok(())
}
