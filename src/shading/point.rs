//! Shading point: a material at a hit point. Each part of the shading equation is one of its methods.
//!
//! L = Le + Ka Ia + sum over lights (Kd (N.L) + Ks (R.V)^n) I + Wr L(R) + Wt L(T), Wr = Kr + F Kt, Wt = (1 - F) Kt
//!
//! Source: Whitted 1980, "An improved illumination model for shaded display"; F by Fresnel, see [`super::optics`].

use super::optics::{Fresnel, reflect, refract};
use super::{Effect, Effects, Interaction, LightSample, Material};
use crate::math::{DVec3, Rgb};
use crate::probe::{Absence, Term};

/// Material at a hit point, with what is simulated there.
#[derive(Clone, Copy, Debug)]
pub struct ShadingPoint<'a> {
    /// Hit point, with normals and the direction to the viewer.
    pub at: &'a Interaction,
    material: &'a Material,
    /// Ka and Kd at the point.
    ka: Rgb,
    kd: Rgb,
    effects: Effects,
}

/// Split of the light at the boundary of two media, by Fresnel's equations or what stands for them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FresnelSplit {
    /// Index of refraction on the side of the ray.
    pub n1: f64,
    /// Index of refraction on the other side.
    pub n2: f64,
    /// F: reflected share; 1 under total internal reflection, in every model.
    pub reflectance: f64,
    /// Refracted direction (unit), or under total internal reflection k, which is not positive.
    pub refracted: Result<DVec3, f64>,
}

/// Secondary ray that a surface calls for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Secondary {
    /// Direction (unit).
    pub direction: DVec3,
    /// Factor on the radiance that it brings back.
    pub weight: Rgb,
}

impl<'a> ShadingPoint<'a> {
    /// The point `at` of a surface of `material`, where `effects` are simulated.
    #[inline]
    pub fn new(at: &'a Interaction, material: &'a Material, effects: Effects) -> Self {
        let [ka, kd] = material.colors_at(at.uv);
        Self {
            at,
            material,
            ka,
            kd,
            effects,
        }
    }

    /// Le, if the surface sends out light.
    #[inline]
    pub fn emitted(&self) -> Option<Term> {
        let emission = self.material.emission;
        (!emission.is_black()).then_some(Term::Emission(emission))
    }

    /// Ka Ia, if it is not black. `ia` is the scene's ambient light.
    #[inline]
    pub fn ambient(&self, ia: Rgb) -> Option<Term> {
        if !self.effects.has(Effect::Ambient) {
            return None;
        }
        let term = Term::Ambient { ka: self.ka, ia };
        (!term.value().is_black()).then_some(term)
    }

    /// Whether lights matter here: the surface has a diffuse or a specular coefficient, and its effect is simulated. Or why not.
    #[inline]
    pub fn shows_lights(&self) -> Result<(), Absence> {
        if self.is_diffuse() || self.has_highlights() {
            return Ok(());
        }
        Err(if self.kd.is_black() && self.material.specular.is_black() {
            Absence::NoLocalLight
        } else {
            Absence::EffectOff
        })
    }

    #[inline]
    fn is_diffuse(&self) -> bool {
        !self.kd.is_black() && self.effects.has(Effect::Diffuse)
    }

    #[inline]
    fn has_highlights(&self) -> bool {
        !self.material.specular.is_black() && self.effects.has(Effect::Highlights)
    }

    /// Kd at the point.
    pub fn diffuse_color(&self) -> Rgb {
        self.kd
    }

    /// n: the exponent of highlights.
    pub fn shininess(&self) -> f64 {
        self.material.shininess
    }

    /// True if it is diffuse and has no highlights.
    pub fn is_matt(&self) -> bool {
        self.material.specular.is_black() && !self.kd.is_black()
    }

    /// f(L, V) I (N.L): the terms of a light of which nothing is hidden, one after the other.
    #[inline(always)]
    pub fn eval(&self, light: &LightSample, n_dot_l: f64, mut add: impl FnMut(Term)) {
        let (kd, intensity) = (self.kd, light.intensity);
        if self.effects.has(Effect::Diffuse) {
            add(match light.projected {
                Some(light) => Term::Projected { kd, light, n_dot_l },
                None => Term::Diffuse {
                    kd,
                    intensity,
                    n_dot_l,
                },
            });
        }
        if self.has_highlights() {
            add(Term::Specular {
                ks: self.material.specular,
                intensity,
                r_dot_v: reflect(-light.direction, self.at.normal).dot(self.at.to_viewer),
                shininess: self.material.shininess,
            });
        }
    }

    /// Split of the light where the index of refraction changes from `n1` to `n2`.
    pub fn split(&self, model: Fresnel, [n1, n2]: [f64; 2]) -> FresnelSplit {
        let (normal, to_viewer) = (self.at.normal, self.at.to_viewer);
        let refracted = refract(-to_viewer, normal, n1, n2);
        let reflectance = refracted.map_or(1.0, |t| {
            let (cos_i, cos_t) = (normal.dot(to_viewer), -normal.dot(t));
            model.reflectance(cos_i, cos_t, n1, n2)
        });
        FresnelSplit {
            n1,
            n2,
            reflectance,
            refracted,
        }
    }

    /// R, with Wr = Kr on an opaque surface and Kr + F Kt at a boundary; or why there is none.
    #[inline]
    pub fn reflected(&self, split: Option<&FresnelSplit>) -> Result<Secondary, Absence> {
        let m = self.material;
        let weight = split.map_or(m.mirror, |split| m.fresnel_weights(split.reflectance)[0]);
        if weight.is_black() {
            return Err(Absence::NoReflection);
        }
        if !self.effects.has(Effect::Reflection) {
            return Err(Absence::EffectOff);
        }
        let direction = reflect(-self.at.to_viewer, self.at.normal);
        let n_dot_r = self.at.geometric_normal.dot(direction);
        if n_dot_r <= 0.0 {
            return Err(Absence::BelowSurface { n_dot_r });
        }
        Ok(Secondary { direction, weight })
    }

    /// T, with Wt = (1 - F) Kt; or why there is none.
    #[inline]
    pub fn transmitted(&self, split: &FresnelSplit) -> Result<Secondary, Absence> {
        let [_, weight] = self.material.fresnel_weights(split.reflectance);
        let direction = match split.refracted {
            Err(k) => return Err(Absence::TotalInternalReflection { k }),
            Ok(_) if weight.is_black() => return Err(Absence::NoTransmission),
            Ok(direction) => direction,
        };
        if !self.effects.has(Effect::Refraction) {
            return Err(Absence::EffectOff);
        }
        // Through a surface means to the other side of it, by the geometric normal.
        let n_dot_r = self.at.geometric_normal.dot(direction);
        if n_dot_r >= 0.0 {
            return Err(Absence::BelowSurface { n_dot_r });
        }
        Ok(Secondary { direction, weight })
    }
}
