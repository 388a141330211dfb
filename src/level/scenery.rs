//! What is seen and not touched: one line for each kind, and with which piece of the asset it is drawn.

use super::feature::is_default;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A thing that is seen and not touched.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scenery {
    /// What it is.
    pub kind: SceneryKind,
    /// Its foot, or what it hangs from, in metres, in the plane of play.
    pub at: DVec2,
    /// How far behind (negative) or in front of the plane of play, in metres.
    #[serde(default)]
    pub depth: f64,
    /// Size, as a multiple of its usual one.
    #[serde(default = "one")]
    pub scale: f64,
    /// Degrees by which it is turned about its own upright axis, counter-clockwise seen from above. Where none is given, its
    /// place decides, so that no two look alike.
    #[serde(default, skip_serializing_if = "is_default")]
    pub turn: Option<f64>,
    /// Whether left and right are exchanged.
    #[serde(default, skip_serializing_if = "is_default")]
    pub flip: bool,
}

fn one() -> f64 {
    1.0
}

/// Writes the enum, the list of all its values, and the nodes of `assets/models/pieces.glb` that draw them.
macro_rules! kinds {
    ($($(#[$about:meta])+ $kind:ident = $node:literal)+) => {
        /// Kinds of scenery. What belongs to a rule of the game (spikes, lodestones, the gate) is no scenery: it is drawn
        /// with its feature.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
        pub enum SceneryKind {
            $($(#[$about])+ $kind,)+
        }

        impl SceneryKind {
            /// All kinds, in the order above.
            pub const ALL: &[SceneryKind] = &[$(SceneryKind::$kind,)+];

            /// The node of `assets/models/pieces.glb` that draws it.
            pub fn node(self) -> &'static str {
                match self {
                    $(SceneryKind::$kind => $node,)+
                }
            }
        }
    };
}

kinds! {
    /// A lamp on a post, lit.
    Lantern = "lantern"
    /// The same with its flame out.
    LanternDead = "lantern_dead"
    /// A lamp on a bracket, lit: its foot is the fixing on the wall behind.
    LanternWall = "lantern_wall"
    /// The same with its flame out.
    LanternWallDead = "lantern_wall_dead"
    /// A lamp on a chain, lit, that hangs down from `at`.
    LanternHanging = "lantern_hanging"
    /// The same with its flame out.
    LanternHangingDead = "lantern_hanging_dead"
    /// A whole round column with base and capital, 5 m tall.
    Pillar = "pillar"
    /// A fluted column, 5 m tall, chipped at its edges.
    PillarFluted = "pillar_fluted"
    /// A square pier of blocks, 4.6 m tall.
    PillarSquare = "pillar_square"
    /// The stump of a column, 2.5 m tall.
    PillarBroken = "pillar_broken"
    /// A column that lies on the ground in three pieces, 5 m long.
    PillarFallen = "pillar_fallen"
    /// A whole arch on two piers, 6 m wide and 5.5 m tall.
    Arch = "arch"
    /// The same with its crown fallen out.
    ArchBroken = "arch_broken"
    /// A cloth on a pole, 3.4 m tall.
    Banner = "banner"
    /// A torn cloth that hangs down 3 m from a cross-bar at `at`.
    BannerTorn = "banner_torn"
    /// A narrow pennant, hung down 4.5 m from `at`.
    BannerLong = "banner_long"
    /// A great toothed wheel, upright, 3 m across, half broken.
    Gear = "gear"
    /// A toothed wheel on its shaft, 1.4 m across.
    GearSmall = "gear_small"
    /// A screw press in its frame, 3.2 m tall.
    Press = "press"
    /// A drum with cranks and rope, 1.6 m tall.
    Winch = "winch"
    /// Cracked iron pipe with flanges and a bend, 3 m long.
    Pipe = "pipe"
    /// A burst riveted boiler, 2.6 m tall.
    Boiler = "boiler"
    /// The wheel that men walked in to lift stones, 4 m across.
    Treadwheel = "treadwheel"
    /// A block with a hook that hangs down 2 m from `at`.
    Pulley = "pulley"
    /// A tuft of grass.
    #[serde(alias = "Plant")]
    Grass = "grass"
    /// Fronds that lean outwards, 0.8 m tall.
    Fern = "fern"
    /// A low bush, 1 m tall.
    Bush = "bush"
    /// Reeds with brown heads, 1.8 m tall: at the water.
    Reed = "reed"
    /// A small twisted tree, 4 m tall, bent by the wind.
    Tree = "tree"
    /// A bare dead tree, 4.5 m tall.
    DeadTree = "dead_tree"
    /// Ivy that clings to a wall behind it: 2 m wide and tall about `at`.
    Ivy = "ivy"
    /// Strands that hang down 3 m from `at`.
    Vine = "vine"
    /// A group of pale mushrooms, 0.4 m tall.
    Mushrooms = "mushrooms"
    /// A rusty chain that hangs down 4 m from `at`.
    Chain = "chain"
    /// A frayed rope that hangs down 4 m from `at`, knotted at its end.
    Rope = "rope"
    /// A wooden crate, 0.9 m.
    Crate = "crate"
    /// A stack of three crates and a sack, 1.7 m tall.
    Crates = "crates"
    /// A barrel, 1 m tall.
    Barrel = "barrel"
    /// A quarry cart with a broken wheel and stones on it, 2.6 m long.
    Cart = "cart"
    /// A wooden ladder, 3 m, that leans back.
    Ladder = "ladder"
    /// Scaffold poles and two boards, 4.5 m wide and 4.5 m tall.
    Scaffold = "scaffold"
    /// The fallen head of a colossus, 3 m tall, half sunk in.
    StatueHead = "statue_head"
    /// A kneeling stone figure on a plinth, 2.8 m tall.
    StatueKneeling = "statue_kneeling"
    /// A stone tomb with a cracked lid, 2.2 m long.
    Tomb = "tomb"
    /// A heap of broken stones, 2 m wide.
    Rubble = "rubble"
    /// A few small stones.
    RubbleSmall = "rubble_small"
    /// Tumbled building blocks, 2.5 m wide.
    RubbleBlocks = "rubble_blocks"
    /// A cluster of stalactites that hangs down 1.8 m from `at`.
    Stalactite = "stalactite"
    /// A sitting bird, 0.3 m tall.
    Bird = "bird"
    /// A square tower, 14 m tall over a foot that goes down 10 m more: for the distance.
    Tower = "tower"
    /// The same broken open half way up.
    TowerRuin = "tower_ruin"
    /// Three arches of an aqueduct, 24 m long and 16 m tall, in ruins: for the distance.
    Aqueduct = "aqueduct"
    /// A stack of bare rock, 20 m tall: for the distance.
    CliffStack = "cliff_stack"
    /// A windmill with torn sails, 13 m tall: for the distance.
    Windmill = "windmill"
    /// A wooden crane of the quarry, 7 m tall, its jib to the right.
    Crane = "crane"
}
