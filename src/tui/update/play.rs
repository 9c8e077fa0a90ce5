//! Play: steps that run by themselves, for a projector.

use std::time::{Duration, Instant};

use crate::debug::StepCommand;
use crate::tui::model::{Model, Play, PlayUnit};

/// Steps in a second at first, and at most.
const SLOWEST: u32 = 2;
const FASTEST: u32 = 64;

/// Begins to play; once more in the same direction doubles the speed.
pub fn play(model: &mut Model, forward: bool) {
    if model.session.is_none() {
        return;
    }
    let speed = match model.play {
        Some(play) if play.forward == forward => (2 * play.speed).min(FASTEST),
        _ => SLOWEST,
    };
    model.play = Some(Play {
        forward,
        speed,
        due: Instant::now() + pause(speed),
    });
    let direction = if forward { "forwards" } else { "backwards" };
    model.message = Some(format!(
        "playing {} {direction}, {speed} steps a second; any other key stops",
        unit(model.play_unit)
    ));
}

/// The next step, if it is due by `now`. At the end of the log it stops.
pub fn tick(model: &mut Model, now: Instant) {
    let (Some(play), Some(session)) = (&mut model.play, &mut model.session) else {
        model.play = None;
        return;
    };
    if now < play.due {
        return;
    }
    play.due = now + pause(play.speed);
    let before = session.cursor();
    let command = match (model.play_unit, play.forward) {
        (PlayUnit::Events, true) => StepCommand::Forward,
        (PlayUnit::Events, false) => StepCommand::Back,
        (PlayUnit::Rays, true) => StepCommand::NextSent,
        (PlayUnit::Rays, false) => StepCommand::PreviousSent,
        (PlayUnit::Levels, true) => StepCommand::NextOfLevel,
        (PlayUnit::Levels, false) => StepCommand::PreviousOfLevel,
    };
    if session.step(command).is_err() || session.cursor() == before {
        model.play = None;
        model.message = Some("this is the end of the log".to_owned());
    }
}

/// Chooses what a step is.
pub fn by(model: &mut Model) {
    model.play_unit = match model.play_unit {
        PlayUnit::Events => PlayUnit::Rays,
        PlayUnit::Rays => PlayUnit::Levels,
        PlayUnit::Levels => PlayUnit::Events,
    };
    model.message = Some(format!("> and < play {}", unit(model.play_unit)));
}

fn unit(unit: PlayUnit) -> &'static str {
    match unit {
        PlayUnit::Events => "events",
        PlayUnit::Rays => "rays",
        PlayUnit::Levels => "rays level by level",
    }
}

fn pause(speed: u32) -> Duration {
    Duration::from_secs(1) / speed
}
