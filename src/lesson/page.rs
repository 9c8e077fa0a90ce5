//! Page of a chapter: its text with the numbers of today's tracer in it, and the blocks between.

use super::chapter::Chapter;
use super::course::Course;
use super::directive::{self, BlockDirective};
use super::exercise::shown;
use super::files::CourseError;
use super::names::scene_path;
use super::stage::Stage;
use super::value::{LessonValue, words_and_settings};
use crate::lab::raster::Filling;
use crate::lab::show::ShowMode;
use crate::scene::printable::excerpt;

/// A part of a page.
#[derive(Clone, Debug, PartialEq)]
pub enum PagePart {
    /// Text in Markdown.
    Text(String),
    /// What the program prints, as it is: with the directive that asks for it.
    Block(String, String),
    /// A picture.
    Picture(PagePicture),
    /// Where the exercise of this name is offered.
    Exercise(String),
}

/// A picture of a page; it is rendered where it is shown, in the size that fits there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PagePicture {
    /// Its scene, if it is not that of the chapter.
    pub scene: Option<String>,
    /// Its settings, by the names of flags.
    pub settings: Vec<(String, String)>,
    /// What is shown in the place of colours, if the picture says.
    pub show: Option<ShowMode>,
    /// True if the picture shows colours although the chapter has none yet.
    pub colors: bool,
    /// How its triangles are filled, if it is made by scan conversion.
    pub filling: Option<Filling>,
    /// Pixels that are marked.
    pub marks: Vec<(u32, u32)>,
}

/// The page of a chapter.
pub fn page(course: &Course, chapter: &Chapter) -> Result<Vec<PagePart>, CourseError> {
    let file = format!("{}/text.md", chapter.folder);
    let mut parts = Vec::new();
    let mut text = String::new();
    let mut stages = Stages::new(course, chapter);
    for (number, line) in (1..).zip(chapter.text.lines()) {
        let told = |what: String| CourseError::new(&file, format!("line {number}: {what}"));
        match directive::alone(line) {
            Some(inner) if directive::is_block(inner) => {
                let part = block(course, chapter, &mut stages, inner).map_err(told)?;
                if !text.trim().is_empty() {
                    parts.push(PagePart::Text(std::mem::take(&mut text)));
                }
                text.clear();
                parts.push(part);
            }
            _ => {
                let value = |inner: &str| stages.value(inner);
                text += &directive::filled(line, value).map_err(told)?;
                text.push('\n');
            }
        }
    }
    if !text.trim().is_empty() {
        parts.push(PagePart::Text(text));
    }
    Ok(parts)
}

/// A block that stands alone on its line.
fn block(
    course: &Course,
    chapter: &Chapter,
    stages: &mut Stages,
    inner: &str,
) -> Result<PagePart, String> {
    let (words, settings) = words_and_settings(inner);
    let (first, rest) = words.split_once(' ').unwrap_or((words.as_str(), ""));
    Ok(match first {
        "exercise" => {
            if chapter.exercise(rest).is_none() {
                return Err(format!("there is no exercise `{}` here", excerpt(rest)));
            }
            PagePart::Exercise(rest.to_owned())
        }
        "picture" if rest.is_empty() => PagePart::Picture(picture(course, chapter, settings)?),
        "file" => {
            let name = super::files::CourseFiles::beside(&chapter.folder, rest)?;
            let text = course.files.text(&name).map_err(|e| e.to_string())?;
            PagePart::Block(format!("{rest}:"), text.to_owned())
        }
        "console" => PagePart::Block(
            format!("$ {rest}"),
            super::console::console(course, chapter, rest)?,
        ),
        _ => {
            let directive: BlockDirective = words.parse()?;
            let (scene, settings) = scene_of(settings);
            let stage = stages.stage(scene.as_deref())?;
            PagePart::Block(
                directive.title(&settings),
                directive.text(stage, &settings)?,
            )
        }
    })
}

/// A picture by its settings.
fn picture(
    course: &Course,
    chapter: &Chapter,
    settings: Vec<(String, String)>,
) -> Result<PagePicture, String> {
    let mut picture = PagePicture::default();
    for (name, value) in settings {
        match name.as_str() {
            "S" => {
                let path = scene_path(&chapter.folder, &value)?;
                course.source(&path).map_err(|e| e.to_string())?;
                picture.scene = Some(path);
            }
            "show" if value == "color" => picture.colors = true,
            "raster" => picture.filling = Some(value.parse()?),
            "show" => picture.show = Some(shown(&value)?),
            "mark" => {
                let address: crate::trace::Address = value.parse()?;
                picture.marks.push(address.pixel);
            }
            _ => picture.settings.push((name, value)),
        }
    }
    Ok(picture)
}

/// The scene that settings name, and the others.
fn scene_of(settings: Vec<(String, String)>) -> (Option<String>, Vec<(String, String)>) {
    let (scenes, others): (Vec<_>, Vec<_>) =
        settings.into_iter().partition(|(name, _)| name == "S");
    (
        scenes.into_iter().next_back().map(|(_, value)| value),
        others,
    )
}

/// The stages that a page needs, each built once.
struct Stages<'a> {
    course: &'a Course,
    chapter: &'a Chapter,
    built: Vec<(Option<String>, Stage)>,
}

impl<'a> Stages<'a> {
    fn new(course: &'a Course, chapter: &'a Chapter) -> Self {
        Self {
            course,
            chapter,
            built: Vec::new(),
        }
    }

    /// The stage of a scene, as a directive names it.
    fn stage(&mut self, scene: Option<&str>) -> Result<&Stage, String> {
        let path = scene.map(|scene| scene_path(&self.chapter.folder, scene));
        let path = path.transpose()?;
        let place = self.built.iter().position(|(name, _)| *name == path);
        let place = if let Some(place) = place {
            place
        } else {
            let stage = self.course.stage(self.chapter, path.as_deref(), &[]);
            self.built.push((path, stage.map_err(|e| e.to_string())?));
            self.built.len() - 1
        };
        Ok(&self.built[place].1)
    }

    /// The text of a value.
    fn value(&mut self, inner: &str) -> Result<String, String> {
        let asked = LessonValue::parse(inner)?;
        let stage = self.stage(asked.scene.as_deref())?;
        let value = asked.value(stage)?;
        Ok(value.text(asked.digits))
    }
}

impl PagePicture {
    /// The stage of the picture, with what it shows.
    pub fn stage(&self, course: &Course, chapter: &Chapter) -> Result<Stage, CourseError> {
        let mut stage = course.stage(chapter, self.scene.as_deref(), &self.settings)?;
        if self.show.is_some() || self.colors {
            stage.show = self.show;
        }
        stage.filling = self.filling;
        Ok(stage)
    }

    /// What the picture is of, in words, for those who cannot see it.
    pub fn caption(&self) -> String {
        let mut words: Vec<String> = Vec::new();
        if let Some(show) = self.show {
            words.push(format!("showing {}", show.unit()));
        }
        if let Some(filling) = self.filling {
            words.push(filling.to_string());
        }
        for (name, value) in &self.settings {
            match name.as_str() {
                "size" => {}
                // Its name may be what an exercise asks.
                "bend" => words.push("a broken tracer".to_owned()),
                _ => words.push(format!("{name} {value}")),
            }
        }
        for (x, y) in &self.marks {
            words.push(format!("pixel {x},{y} is marked"));
        }
        let scene = self.scene.as_deref().map(|name| {
            let name = name.rsplit('/').next().unwrap_or(name);
            format!("scene {}", name.trim_end_matches(".json"))
        });
        match (scene, words.join(", ")) {
            (None, words) if words.is_empty() => "the scene".to_owned(),
            (None, words) => words,
            (Some(scene), words) if words.is_empty() => scene,
            (Some(scene), words) => format!("{scene}: {words}"),
        }
    }
}
