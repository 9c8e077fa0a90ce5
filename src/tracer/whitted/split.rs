//! How a transparent surface shares light between the reflected and the transmitted ray.

use super::Tracer;
use crate::math::{DVec3, Rgb};
use crate::probe::{Absence, Event, Probe, tell};
use crate::shading::{Interaction, Material, optics};
use crate::world::Entered;
use crate::world::interface::Change;

/// What a transparent surface does with a ray that arrived.
pub struct Split {
    /// The share of the light that is reflected.
    pub reflected: Rgb,
    /// What goes through, or why nothing does.
    pub transmitted: Result<Through, Absence>,
}

/// What goes through a surface.
pub struct Through {
    /// Its share of the light.
    pub share: Rgb,
    /// Where it goes.
    pub direction: DVec3,
    /// The open objects that a ray is inside of that went through.
    pub beyond: Entered,
}

impl<P: Probe> Tracer<'_, P> {
    /// A transparent surface reflects the share F of what it would let through (Fresnel): Wr = Kr + F Kt,
    /// Wt = (1 - F) Kt. Under total internal reflection F is 1, in every model.
    pub(super) fn split_by_fresnel(
        &mut self,
        at: &Interaction,
        m: &Material,
        change: &Change,
    ) -> Split {
        let [n1, n2] = change
            .media
            .map(|medium| self.world.scene.medium_ior(medium));
        let refracted = optics::refract(-at.to_viewer, at.normal, n1, n2);
        let reflectance = refracted.map_or(1.0, |t| {
            let (cos_i, cos_t) = (at.normal.dot(at.to_viewer), -at.normal.dot(t));
            self.settings.fresnel.reflectance(cos_i, cos_t, n1, n2)
        });
        tell!(
            self.probe,
            Event::Boundary {
                n1,
                n2,
                reflectance,
            }
        );
        let share = m.transmission * (1.0 - reflectance);
        Split {
            reflected: m.mirror + m.transmission * reflectance,
            transmitted: match refracted {
                Err(k) if k < 0.0 => Err(Absence::TotalInternalReflection { k }),
                Ok(direction) if !share.is_black() => Ok(Through {
                    share,
                    direction,
                    beyond: change.entered,
                }),
                _ => Err(Absence::NoTransmission),
            },
        }
    }
}
