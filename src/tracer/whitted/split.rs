//! How a surface shares light between the reflected and the transmitted ray.

use super::{Path, Tracer};
use crate::math::{DVec3, Rgb};
use crate::probe::{Event, Probe};
use crate::shading::{Entered, Interaction, Material, optics};
use crate::tracer::boundary::Change;

/// What a surface does with a ray that arrived: the two directions and their shares.
pub struct Split {
    pub reflected: Rgb,
    pub transmitted: Rgb,
    /// The refracted direction, or the negative k of total internal reflection.
    pub refracted: Result<DVec3, f64>,
    /// The open objects that a ray is inside of that went through.
    pub beyond: Entered,
}

impl<P: Probe> Tracer<'_, P> {
    /// How the surface shares light between reflection and transmission.
    ///
    /// A transparent surface reflects the share F of what it would let through (Fresnel): Wr = Kr + F Kt,
    /// Wt = (1 - F) Kt. Under total internal reflection F is 1, in every model.
    pub(super) fn split(
        &mut self,
        path: &Path,
        at: &Interaction,
        m: &Material,
        change: Option<&Change>,
    ) -> Split {
        let Some(&Change { media, entered }) = change else {
            return Split {
                reflected: m.mirror,
                transmitted: Rgb::BLACK,
                refracted: Err(0.0),
                beyond: path.entered,
            };
        };
        let [n1, n2] = media.map(|medium| self.world.scene.medium_ior(medium));
        let refracted = optics::refract(-at.to_viewer, at.normal, n1, n2);
        let share = refracted.map_or(1.0, |t| {
            let (cos_i, cos_t) = (at.normal.dot(at.to_viewer), -at.normal.dot(t));
            self.settings.fresnel.reflectance(cos_i, cos_t, n1, n2)
        });
        self.probe.event(Event::Boundary {
            n1,
            n2,
            reflectance: share,
        });
        Split {
            reflected: m.mirror + m.transmission * share,
            transmitted: m.transmission * (1.0 - share),
            refracted,
            beyond: entered,
        }
    }
}
