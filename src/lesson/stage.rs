//! A stage: a scene of the course, built, with the settings of a chapter. What is asked is computed there.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::chapter::Chapter;
use super::course::Course;
use super::exercise::Exercise;
use super::files::{CourseError, is_scene_file};
use crate::lab::raster::Filling;
use crate::lab::show::ShowMode;
use crate::scene::effects::effects;
use crate::scene::read::files::Files;
use crate::scene::settings::knobs::set_knob;
use crate::scene::{Edit, Scene, SceneError, SceneSource, Settings, source};
use crate::trace::{PixelTrace, View, trace_pixel};
use crate::world::World;

/// Pixels and rays of a picture of a course at most.
const MAX_PIXELS: u64 = 640 * 480;
const MAX_RAYS: u64 = 300_000_000;

/// A scene with settings.
#[derive(Clone)]
pub struct Stage {
    /// The scene: its path in the course, or the name of a built-in one.
    pub scene: String,
    /// Where it is read from, for changes.
    pub source: SceneSource,
    /// The scene as it was read.
    read: Arc<Scene>,
    /// The scene, computed with the settings' arithmetic, and its accelerator.
    pub world: Arc<World>,
    /// The settings.
    pub settings: Settings,
    /// What the picture shows in the place of colours.
    pub show: Option<ShowMode>,
    /// How the triangles of the picture are filled, if it is made by scan conversion.
    pub filling: Option<Filling>,
}

impl Course {
    /// Where a scene of the course is read from.
    pub fn source(&self, scene: &str) -> Result<SceneSource, CourseError> {
        let wrong = |e: SceneError| CourseError::new(scene, e.to_string());
        if !is_scene_file(scene) {
            return source(scene).map_err(wrong);
        }
        let text = self.files.text(scene)?.as_bytes().to_vec();
        let files = Files::in_memory(BTreeMap::from([(scene.to_owned(), text)]));
        let found = SceneSource::in_files(scene, files).map_err(wrong)?;
        found.ok_or_else(|| CourseError::new(scene, "is no scene file"))
    }

    /// The stage of an exercise.
    pub fn stage_of(&self, chapter: &Chapter, exercise: &Exercise) -> Result<Stage, CourseError> {
        self.stage(chapter, exercise.scene.as_deref(), &exercise.settings)
    }

    /// A scene (that of the chapter, if none is named) with the chapter's settings and more.
    pub fn stage(
        &self,
        chapter: &Chapter,
        scene: Option<&str>,
        more: &[(String, String)],
    ) -> Result<Stage, CourseError> {
        let name = scene.unwrap_or(&chapter.scene);
        let source = self.source(name)?;
        let scene = source.scene();
        let scene = scene.map_err(|e| CourseError::new(name, e.to_string()))?;
        let stage = Stage::new(name, source, scene, chapter, more);
        stage.map_err(|what| CourseError::new(&format!("{}/chapter.toml", chapter.folder), what))
    }
}

impl Stage {
    /// A scene that was read, with a chapter's settings and more.
    pub fn new(
        name: &str,
        source: SceneSource,
        scene: Scene,
        chapter: &Chapter,
        more: &[(String, String)],
    ) -> Result<Self, String> {
        let mut settings = scene.settings;
        if bounded(&mut settings).is_err() {
            // Scenes that are built in for other purposes.
            let usual = Settings::default().image;
            (settings.image.width, settings.image.height) = (usual.width, usual.height);
        }
        settings.effects = effects(&scene);
        chapter.features.limit(&mut settings);
        set(&mut settings, &chapter.settings)?;
        set(&mut settings, more)?;
        bounded(&mut settings)?;
        Ok(Self {
            scene: name.to_owned(),
            source,
            world: built(&scene, &settings),
            read: Arc::new(scene),
            settings,
            show: chapter.features.show(),
            filling: None,
        })
    }

    /// The stage with further settings.
    pub fn with(&self, more: &[(String, String)]) -> Result<Self, String> {
        let mut stage = self.clone();
        set(&mut stage.settings, more)?;
        bounded(&mut stage.settings)?;
        let built_of = |s: &Settings| (s.accel, s.arithmetic);
        if built_of(&stage.settings) != built_of(&self.settings) {
            stage.world = built(&self.read, &stage.settings);
        }
        Ok(stage)
    }

    /// The stage with a changed scene.
    pub fn changed(&self, changes: &[String]) -> Result<Self, String> {
        let edits: Vec<Edit> = changes.iter().cloned().map(Edit::Typed).collect();
        let (scene, _) = self.source.changed(&edits).map_err(|e| e.to_string())?;
        Ok(self.of_scene(scene))
    }

    /// The stage with another scene.
    pub fn of_scene(&self, scene: Scene) -> Self {
        let mut stage = self.clone();
        stage.world = built(&scene, &self.settings);
        stage.read = Arc::new(scene);
        stage
    }

    /// The recording of a pixel, with the steps through the accelerator; an error if it is not in the picture, or takes more rays than are allowed.
    pub fn traced(&self, at: (u32, u32)) -> Result<PixelTrace, String> {
        let (width, height) = self.settings.size();
        if at.0 >= width || at.1 >= height {
            return Err(format!(
                "pixel {},{} is not in the picture, which has {width}x{height}",
                at.0, at.1
            ));
        }
        let trace = trace_pixel(&self.world, &self.settings, at, true);
        if trace.pixel.truncated {
            return Err(format!(
                "pixel {},{} takes more than its share of the {} rays of a picture: its numbers would be those of a part; \
                 ask for fewer samples",
                at.0, at.1, self.settings.recursion.max_rays
            ));
        }
        Ok(trace)
    }

    /// A recording with all that explains it.
    pub fn view<'a>(&'a self, trace: &'a PixelTrace) -> View<'a> {
        View {
            world: &self.world,
            settings: &self.settings,
            trace,
        }
    }
}

/// The world of a scene with settings.
fn built(scene: &Scene, settings: &Settings) -> Arc<World> {
    let scene = scene.clone().computed_with(settings.arithmetic);
    Arc::new(World::new(scene, settings.accel))
}

/// Bounds the work that a course can ask for: whoever opens one has not read it.
fn bounded(settings: &mut Settings) -> Result<(), String> {
    let (width, height) = settings.size();
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(format!(
            "a picture of {width}x{height} is too large for a lesson; {MAX_PIXELS} pixels are the most"
        ));
    }
    settings.recursion.max_rays = settings.recursion.max_rays.min(MAX_RAYS);
    Ok(())
}

/// Sets knobs by their flags.
fn set(settings: &mut Settings, pairs: &[(String, String)]) -> Result<(), String> {
    pairs
        .iter()
        .try_for_each(|(flag, value)| set_knob(settings, flag, value))
}
