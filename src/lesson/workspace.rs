//! Files that a student works on: scenes to be changed, and tasks for programs with their scenes.

use std::fmt::Write as _;

use super::answer::{load_task, start_text};
use super::chapter::Chapter;
use super::course::Course;
use super::exercise::ExerciseKind;
use super::files::is_scene_file;
use super::names::{given_files, scene_name, scene_path};
use crate::scene::flat::write_json;
use crate::tracer::thread_pool;

/// The path of the file that an exercise works on, from the folder of all; of a program the folder of its files.
pub fn work_path(chapter: &Chapter, id: &str, kind: &ExerciseKind) -> Option<String> {
    match kind {
        ExerciseKind::Change(_) => Some(format!("{}/{id}.json", chapter.folder)),
        ExerciseKind::Write { .. } => Some(format!("{}/{id}", chapter.folder)),
        _ => None,
    }
}

/// All files, by their paths.
pub fn start_files(course: &Course) -> Result<Vec<(String, Vec<u8>)>, String> {
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let mut list = String::new();
    for (chapter, exercise) in course.exercises() {
        let Some(path) = work_path(chapter, &exercise.id, &exercise.kind) else {
            continue;
        };
        match &exercise.kind {
            ExerciseKind::Change(task) => {
                let stage = course.stage_of(chapter, exercise);
                let stage = stage.map_err(|e| e.to_string())?;
                let text = start_text(&stage, task)?;
                let _ = writeln!(list, "raytree lesson answer {} {path}", exercise.id);
                files.push((path, text.into_bytes()));
            }
            ExerciseKind::Write { task } => {
                let _ = writeln!(
                    list,
                    "raytree lesson answer {} FOLDER     see {path}",
                    exercise.id
                );
                files.extend(of_task(course, task, &path)?);
            }
            _ => {}
        }
    }
    for name in course
        .files
        .names()
        .filter(|name| name.starts_with("hello/"))
    {
        let text = course.files.text(name).map_err(|e| e.to_string())?;
        files.push((name.to_owned(), text.as_bytes().to_vec()));
    }
    files.push(("README.txt".to_owned(), readme(&list).into_bytes()));
    Ok(files)
}

/// The task of a program, its scenes, and these flat, as a tracer of one's own reads them.
fn of_task(course: &Course, task: &str, folder: &str) -> Result<Vec<(String, Vec<u8>)>, String> {
    let text = course.files.text(task).map_err(|e| e.to_string())?;
    let mut files = vec![(format!("{folder}/task.toml"), text.as_bytes().to_vec())];
    let from = task.rsplit_once('/').map_or("", |(folder, _)| folder);
    let loaded = thread_pool::install(0, || load_task(course, task))?;
    for scene in &loaded.scenes {
        let name = scene_name(&scene.label);
        let path = scene_path(from, name)?;
        let [short, flat_name] = given_files(&scene.label);
        if is_scene_file(name) {
            let text = course.files.text(&path).map_err(|e| e.to_string())?;
            files.push((format!("{folder}/{short}"), text.as_bytes().to_vec()));
        }
        let whole = &scene.world.scene;
        whole.check_faces().map_err(|e| e.to_string())?;
        let mut flat = Vec::new();
        write_json(&mut flat, whole).map_err(|e| e.to_string())?;
        files.push((format!("{folder}/{flat_name}"), flat));
    }
    files.sort();
    files.dedup_by(|a, b| a.0 == b.0);
    Ok(files)
}

fn readme(list: &str) -> String {
    format!(
        "Files of the exercises that change scenes and write programs.\n\n\
         Change a file, then ask whether its goals hold:\n\n{list}\n\
         `raytree lesson watch` checks again whenever a file here changes.\n\
         What stands in a .flat.json file: the book, chapter \"A scene for your tracer\".\n"
    )
}
