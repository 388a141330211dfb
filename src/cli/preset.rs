//! How much the picture may cost: three presets, and which of them a machine can bear.

use serde::{Deserialize, Serialize};

/// Milliseconds that a frame of [`Preset::Medium`] may take for that preset to be kept, and for the next one to be
/// tried: 60 frames a second leave 16.7 ms, and a level has heavier places than the one that is measured.
const MEDIUM_MS: f64 = 11.0;
const HIGH_MS: f64 = 2.5;

/// How much the picture may cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Preset {
    /// For machines without a graphics processor.
    Low,
    /// For small graphics processors.
    #[default]
    Medium,
    /// Everything.
    High,
}

impl Preset {
    /// All presets, the cheapest first.
    pub const ALL: [Preset; 3] = [Preset::Low, Preset::Medium, Preset::High];

    /// As the command line has it.
    pub fn name(self) -> &'static str {
        match self {
            Preset::Low => "low",
            Preset::Medium => "medium",
            Preset::High => "high",
        }
    }

    /// The preset of a name.
    pub fn named(name: &str) -> Option<Preset> {
        Preset::ALL.into_iter().find(|preset| preset.name() == name)
    }

    /// The preset for a machine that takes so many milliseconds for a frame of [`Preset::Medium`].
    pub fn for_frame_time(milliseconds: f64) -> Preset {
        match milliseconds {
            ms if ms <= HIGH_MS => Preset::High,
            ms if ms <= MEDIUM_MS => Preset::Medium,
            _ => Preset::Low,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faster_machines_get_more() {
        let presets = [0.0, 2.5, 2.6, 11.0, 11.1, 500.0].map(Preset::for_frame_time);
        let [low, medium, high] = Preset::ALL;
        assert_eq!(presets, [high, high, medium, medium, low, low]);
        assert_eq!(Preset::for_frame_time(f64::NAN), low);
    }

    #[test]
    fn names_lead_back() {
        assert!(
            Preset::ALL
                .iter()
                .all(|p| Preset::named(p.name()) == Some(*p))
        );
        assert_eq!(Preset::named("ultra"), None);
    }
}
