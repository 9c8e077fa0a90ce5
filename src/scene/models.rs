//! Shading models in a scene: what its objects ask for, and what the settings say instead.

use super::{Scene, Settings};
use crate::geometry::Hit;
use crate::shading::{Interaction, ShadingModel};

impl Scene {
    /// The model by which a primitive is shaded, if the settings or its object name one.
    pub fn model(&self, primitive: u32, settings: &Settings) -> Option<ShadingModel> {
        settings.shading.or(self.object_of(primitive).shading)
    }

    /// True if an object asks for a model.
    pub fn names_models(&self) -> bool {
        self.objects.iter().any(|object| object.shading.is_some())
    }

    /// Interaction at a hit as it is shaded with these settings: with the normal of the plane where the model is flat, else as
    /// [`Scene::shaded`] gives it.
    pub fn shaded_with(&self, (hit, at): (&Hit, &Interaction), settings: &Settings) -> Interaction {
        if self.model(hit.primitive, settings) == Some(ShadingModel::Flat) {
            return at.flat();
        }
        *self.shaded((hit, at), settings.effects, &mut None)
    }
}
