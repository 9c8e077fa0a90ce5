//! Pages of chapters: computed in the background, since their numbers are traced, and kept.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;

use crate::lesson::Course;
use crate::lesson::page::{PagePart, page};
use crate::tracer::thread_pool;

/// The page of a chapter, or what is wrong with it.
pub type PageResult = Result<Vec<PagePart>, String>;

/// The pages that are known, and the one that is being computed.
#[derive(Default)]
pub struct Pages {
    known: BTreeMap<usize, PageResult>,
    coming: Option<(usize, Receiver<PageResult>)>,
}

impl Pages {
    /// The page of a chapter, if it is computed by now.
    pub fn get(&self, chapter: usize) -> Option<&PageResult> {
        self.known.get(&chapter)
    }

    /// Begins to compute a page, unless it is known or on its way.
    pub fn ask(&mut self, course: &Arc<Course>, chapter: usize) {
        let is_coming = self.coming.as_ref().is_some_and(|(n, _)| *n == chapter);
        if self.known.contains_key(&chapter) || is_coming {
            return;
        }
        let (sender, receiver) = channel();
        let course = Arc::clone(course);
        thread::spawn(move || {
            let made = thread_pool::install(0, || {
                let chapter = course.chapters.get(chapter);
                let chapter = chapter.ok_or_else(|| "there is no such chapter".to_owned())?;
                page(&course, chapter).map_err(|error| error.to_string())
            });
            // Whoever asked may be gone.
            drop(sender.send(made));
        });
        self.coming = Some((chapter, receiver));
    }

    /// Takes in the page that was computed. True if there is one.
    pub fn receive(&mut self) -> bool {
        let Some((chapter, receiver)) = &self.coming else {
            return false;
        };
        let made = match receiver.try_recv() {
            Ok(made) => made,
            Err(TryRecvError::Empty) => return false,
            Err(TryRecvError::Disconnected) => Err("its numbers cannot be computed".to_owned()),
        };
        self.known.insert(*chapter, made);
        self.coming = None;
        true
    }

    /// True while a page is computed.
    pub fn is_coming(&self) -> bool {
        self.coming.is_some()
    }
}
