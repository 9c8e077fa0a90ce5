//! Effects that the user switches, and the remark about everything that is not computed as usual.

use crate::scene::Effects;
use crate::scene::Settings;
use crate::scene::effects::Finding;

/// The effects with one switched; an error if the scene does not call for it, so that it could change nothing.
pub fn switched(effects: Effects, finding: &Finding) -> Result<Effects, String> {
    let Finding { effect, on, reason } = finding;
    if !on {
        return Err(format!("{} would change nothing: {reason}", effect.name()));
    }
    Ok(if effects.has(*effect) {
        effects.without(*effect)
    } else {
        effects.with(*effect)
    })
}

/// Laws that are bent, a shading that is not the scene's, arithmetic other than the default, and effects that the scene calls for
/// and that are left out.
pub fn deviations(settings: &Settings, findings: &[Finding]) -> Option<String> {
    let bends = settings.bends;
    let mut told: Vec<_> = (!bends.is_empty())
        .then(|| format!("bend {bends}"))
        .into_iter()
        .collect();
    told.extend(
        settings
            .shading
            .map(|model| format!("shading {}", model.word())),
    );
    let list = settings.arithmetic.deviations().into_iter();
    told.extend(list.map(|d| format!("{} {}", d.choice, d.value)));
    let left_out: Vec<&str> = findings
        .iter()
        .filter(|f| f.on && !settings.effects.has(f.effect))
        .map(|f| f.effect.name())
        .collect();
    if !left_out.is_empty() {
        told.push(format!("without {}", left_out.join(", ")));
    }
    (!told.is_empty()).then(|| told.join(", "))
}
