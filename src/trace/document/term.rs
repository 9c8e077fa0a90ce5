//! A term of the shading equation with its factors.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::math::Rgb;
use crate::probe::{Factor, Term, TermKind};

/// A summand of a node's radiance: value = product of the factors that its kind names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TermValue {
    /// Which term.
    pub term: TermKind,
    /// The light that it comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<String>,
    /// Of an area light, the sample that it comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sample: Option<u32>,
    /// What it adds.
    pub value: Rgb,
    /// What it is the product of.
    #[serde(flatten)]
    pub factors: TermFactors,
    /// If it is blended between the corners of a triangle, the term at each of them, in the order of `hit.barycentric`: value is the
    /// sum of weight x value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corners: Option<Box<[CornerValue; 3]>>,
}

/// A term at a corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CornerValue {
    /// The corner's weight at the hit.
    pub weight: f64,
    /// Of lights: the cosine between the normal at the corner and the way from there to the light. Where it is negative the light is
    /// behind the corner, and the value is black.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub n_dot_l: Option<f64>,
    /// Specular: the cosine between the mirrored light and the viewer, at least 0, both as the corner sees them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub r_dot_v: Option<f64>,
    /// What the term is there, without the weight.
    pub value: Rgb,
}

/// The factors of a term, by name: those of its kind are there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TermFactors {
    /// Ambient: value = ka x ambient_light.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ka: Option<Rgb>,
    /// Ia, the light that is everywhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ambient_light: Option<Rgb>,
    /// Diffuse: value = kd x intensity x n_dot_l.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kd: Option<Rgb>,
    /// Specular: value = ks x intensity x r_dot_v ^ shininess; black where r_dot_v is 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ks: Option<Rgb>,
    /// What arrives from the light, attenuated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub intensity: Option<Rgb>,
    /// The cosine between normal and light.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n_dot_l: Option<f64>,
    /// P of an area light whose samples all bring the same: intensity x n_dot_l = radiance x P / (pi x samples).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub projected_solid_angle: Option<f64>,
    /// The cosine between the mirrored light and the viewer, at least 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub r_dot_v: Option<f64>,
    /// The exponent of the highlight.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shininess: Option<f64>,
}

impl From<&Term> for TermFactors {
    fn from(term: &Term) -> Self {
        let mut named = Self::default();
        for factor in term.factors() {
            match factor {
                ("ka", Factor::Color(c)) => named.ka = Some(c),
                ("ambient_light", Factor::Color(c)) => named.ambient_light = Some(c),
                ("kd", Factor::Color(c)) => named.kd = Some(c),
                ("ks", Factor::Color(c)) => named.ks = Some(c),
                ("intensity", Factor::Color(c)) => named.intensity = Some(c),
                ("n_dot_l", Factor::Number(x)) => named.n_dot_l = Some(x),
                ("projected_solid_angle", Factor::Number(x)) => {
                    named.projected_solid_angle = Some(x);
                }
                ("r_dot_v", Factor::Number(x)) => named.r_dot_v = Some(x),
                ("shininess", Factor::Number(x)) => named.shininess = Some(x),
                _ => {}
            }
        }
        named
    }
}
