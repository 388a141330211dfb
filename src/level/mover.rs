//! What moves: platforms, lifts, doors, crushers, and the regions that ride on them or move by themselves.

use super::feature::is_default;
use super::{Feature, Material};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// Features that move together along a path.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mover {
    /// Unique name.
    pub id: String,
    /// What moves, where it is drawn. Ids are unique among all features of the level.
    pub features: Vec<Feature>,
    /// Where it stops, in order.
    pub path: Vec<Stop>,
    /// What follows the last stop.
    #[serde(default, skip_serializing_if = "is_default")]
    pub repeat: Repeat,
    /// What sets it going.
    #[serde(default, skip_serializing_if = "is_default")]
    pub starts: Starts,
    /// For how long it stays at its last stop after nobody rides it any more, in seconds; then it goes back the way that it came.
    /// Paths that are gone once only.
    #[serde(default, skip_serializing_if = "is_default")]
    pub back: Option<f64>,
    /// What calls it to an end of its path. Paths that are gone once only.
    #[serde(default, skip_serializing_if = "is_default")]
    pub calls: Vec<Call>,
}

/// A trigger that calls a mover to an end of its path.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Call {
    /// The id of the trigger.
    pub by: String,
    /// Where to.
    pub to: End,
}

/// An end of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum End {
    /// Its first stop.
    First,
    /// Its last stop.
    Last,
}

/// How much more up than sideways a way must go to count as upright.
const UPRIGHT: f64 = 3.0;

/// Whether a way leads up or down rather than sideways, or nowhere.
pub fn is_upright(way: DVec2) -> bool {
    way != DVec2::ZERO && way.y.abs() >= UPRIGHT * way.x.abs()
}

impl Mover {
    /// How far from where it was drawn it begins, m.
    pub fn parked(&self) -> DVec2 {
        self.path.first().map_or(DVec2::ZERO, |stop| stop.at)
    }

    /// The offsets between which it goes, in order; the way back to the beginning included.
    pub fn legs(&self) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
        let stops = || self.path.iter().map(|stop| stop.at);
        let back = match self.repeat {
            Repeat::Loop => stops().next_back().zip(stops().next()),
            _ => None,
        };
        stops().zip(stops().skip(1)).chain(back)
    }

    /// The parts that crush: the iron of what goes up and down.
    pub fn crushers(&self) -> impl Iterator<Item = &Feature> {
        let stamps = self.legs().any(|(from, to)| is_upright(to - from));
        let parts = self.features.iter();
        let is_iron = |f: &Feature| f.kind.is_terrain() && f.material == Material::Iron;
        parts.filter(move |feature| stamps && is_iron(feature))
    }
}

/// A stop of a path, and the way from it to the next one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stop {
    /// How far from where it was drawn, in metres; rounded to the grid.
    pub at: DVec2,
    /// How long it stays, in seconds.
    #[serde(default, skip_serializing_if = "is_default")]
    pub wait: f64,
    /// How long the way to the next stop takes, in seconds; 0 if there is none.
    #[serde(default, skip_serializing_if = "is_default")]
    pub seconds: f64,
    /// How the speed changes on that way.
    #[serde(default, skip_serializing_if = "is_default")]
    pub easing: Easing,
}

/// How the speed changes on the way between two stops.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Easing {
    /// Not at all: it starts and stops dead.
    #[default]
    Linear,
    /// It grows evenly over the first half of the time and falls over the second.
    Eased,
}

/// What follows the last stop of a path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Repeat {
    /// The first stop again, on the way that the last stop names.
    #[default]
    Loop,
    /// The same way back, then all over again.
    PingPong,
    /// Nothing: it stays there.
    Once,
}

/// What sets a mover going.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Starts {
    /// The beginning of the level.
    #[default]
    AtOnce,
    /// A body that enters the trigger with this id.
    On(String),
    /// A body that comes to stand on it, or takes hold of it.
    Ridden,
}
