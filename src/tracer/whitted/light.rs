//! What each light adds at a hit, unless something stands in its way.

use super::{Path, Tracer};
use crate::math::Rgb;
use crate::probe::{Absence, Event, Probe, RayKind, RayRecord, Term, counting, tell};
use crate::scene::Effect;
use crate::shading::{optics, phong};
use crate::tracer::area::AreaView;
use crate::tracer::foresight::Asked;
use crate::tracer::lights::{self, Question, Surface};

/// A place, and how it sees the light in question, if that is an area.
type Facing<'s> = (&'s Surface<'s>, Option<&'s AreaView<'s>>);

impl<P: Probe> Tracer<'_, P> {
    /// One light: a shadow ray to it, many to an area, and for each that arrives the diffuse and the specular term.
    pub(super) fn light(&mut self, sum: &mut Rgb, path: &Path, surface: &Surface, light: u32) {
        if let Some(asked) = path.foreseen.and_then(|f| f.asked(light)) {
            return self.light_as_foreseen(sum, surface, light, asked);
        }
        if self.world.scene.lights[light as usize].source.is_area() {
            return self.area_light(sum, path, surface, light);
        }
        self.one_sample(sum, path, (surface, None), (light, 0));
    }

    /// The same of an area. (On its own, so that scenes without areas pay nothing for it.)
    #[inline(never)]
    fn area_light(&mut self, sum: &mut Rgb, path: &Path, surface: &Surface, light: u32) {
        let settings = self.settings;
        let samples = settings.rays_to_area();
        let area = AreaView::new(&self.world.scene, settings, path.asker, surface, light);
        let facing = (surface, area.as_ref());
        if samples > 1 {
            if !P::LISTENS && settings.effects.has(Effect::Shadows) {
                return self.light_in_a_bundle(sum, facing, light, samples);
            }
            tell!(self.probe, Event::LightSamples { light, samples });
        }
        for sample in 0..samples {
            if !self.one_sample(sum, path, facing, (light, sample)) {
                break;
            }
        }
    }

    /// One sample of a light: its shadow ray, and what it brings. False if the budget has nothing left for it.
    #[inline]
    fn one_sample(
        &mut self,
        sum: &mut Rgb,
        path: &Path,
        facing: Facing,
        light: (u32, u32),
    ) -> bool {
        if self.no_more_light(light.0) {
            return false;
        }
        if let Some(question) = self.question(facing, light)
            && !self.shadowed(path, light, &question)
        {
            self.lit(sum, facing.0, light, &question);
        }
        true
    }

    /// The same with shadow rays that have been asked already.
    fn light_as_foreseen(
        &mut self,
        sum: &mut Rgb,
        surface: &Surface,
        light: u32,
        asked: &[Option<Asked>],
    ) {
        for (sample, asked) in (0..).zip(asked.iter().flatten()) {
            if self.no_more_light(light) {
                return;
            }
            self.spent += 1;
            if let Ok(question) = &asked.question {
                self.rays += 1;
                if !asked.blocked {
                    self.lit(sum, surface, (light, sample), question);
                }
            }
        }
    }

    /// The same with all shadow rays asked together.
    #[inline(never)]
    fn light_in_a_bundle(&mut self, sum: &mut Rgb, facing: Facing, light: u32, count: u32) {
        let mut bundle = std::mem::take(&mut self.bundle);
        bundle.questions.clear();
        for sample in 0..count {
            if self.no_more_light(light) {
                break;
            }
            let question = self.question(facing, (light, sample));
            bundle.questions.extend(question.map(|q| (sample, q)));
        }
        bundle.answer(self.world);
        for ((sample, question), blocked) in bundle.questions.iter().zip(&bundle.blocked) {
            if !blocked {
                self.lit(sum, facing.0, (light, *sample), question);
            }
        }
        self.bundle = bundle;
    }

    /// What is to be asked of a sample of a light, if anything.
    fn question(&mut self, facing: Facing, light: (u32, u32)) -> Option<Question> {
        let scene = &self.world.scene;
        self.spent += 1;
        match lights::question(scene, self.settings, facing, light) {
            Ok(question) => {
                self.rays += u64::from(self.settings.effects.has(Effect::Shadows));
                Some(question)
            }
            Err(reason) => {
                tell!(
                    self.probe,
                    Event::Absent {
                        kind: RayKind::Light,
                        light: light.0,
                        reason,
                    }
                );
                None
            }
        }
    }

    /// True, and told, if the budget allows no more questions to this light.
    fn no_more_light(&mut self, light: u32) -> bool {
        let out = self.out_of_rays();
        if out {
            tell!(
                self.probe,
                Event::Absent {
                    kind: RayKind::Light,
                    light,
                    reason: Absence::RayBudget,
                }
            );
        }
        out
    }

    /// Sends a shadow ray: true if anything stands before the light. Transparent things block it as well.
    fn shadowed(&mut self, path: &Path, (light, sample): (u32, u32), question: &Question) -> bool {
        let Question { ray, lit, .. } = question;
        if !self.settings.effects.has(Effect::Shadows) {
            tell!(
                self.probe,
                Event::Absent {
                    kind: RayKind::Light,
                    light,
                    reason: Absence::EffectOff,
                }
            );
            return false;
        }
        tell!(
            self.probe,
            Event::Ray(RayRecord {
                kind: RayKind::Light,
                sample: sample as u16,
                depth: path.depth + 1,
                light,
                medium: path.medium,
                origin: ray.origin,
                direction: ray.direction,
                t_max: lit.distance,
                weight: Rgb::WHITE,
            })
        );
        let blocker = self.world.blocker(ray, lit.distance, self.probe);
        tell!(self.probe, blocker.map_or(Event::Lit, Event::Blocked));
        tell!(
            self.probe,
            Event::Return {
                radiance: Rgb::BLACK,
            }
        );
        blocker.is_some()
    }

    /// What a light adds that nothing stands before.
    fn lit(&mut self, sum: &mut Rgb, surface: &Surface, light: (u32, u32), question: &Question) {
        let Question { lit, n_dot_l, .. } = question;
        let (at, m, kd) = (surface.at, surface.material, surface.diffuse);
        let diffuse = match lit.irradiance {
            Some(irradiance) if counting::AREAS => kd * irradiance,
            _ => phong::diffuse(kd, lit.intensity, *n_dot_l),
        };
        self.add(sum, Term::Diffuse, light, diffuse);
        if !m.specular.is_black() && self.settings.effects.has(Effect::Highlights) {
            let r = optics::reflect(-lit.direction, at.normal);
            let r_dot_v = r.dot(at.to_viewer);
            let specular = phong::specular(m.specular, lit.intensity, r_dot_v, m.shininess);
            self.add(sum, Term::Specular, light, specular);
        }
    }
}
