//! Every sound there is: one line each, with its file, its variations and how loud it is in the whole.
//!
//! The files are made by the scripts in `assets/source/sound`.

/// Writes the sounds: an enum, their files' names, how many variations there are, and their loudness.
macro_rules! sounds {
    ($($(#[$about:meta])+ $sound:ident = $file:literal, $variants:literal, $decibels:literal;)+) => {
        /// A sound that is heard once.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Sound {
            $($(#[$about])+ $sound,)+
        }

        impl Sound {
            /// All of them, in the order above.
            pub const ALL: &[Sound] = &[$(Sound::$sound,)+];

            /// The name of its files, without their numbers.
            pub fn name(self) -> &'static str {
                match self {
                    $(Sound::$sound => $file,)+
                }
            }

            /// How many variations there are.
            pub fn variants(self) -> u8 {
                match self {
                    $(Sound::$sound => $variants,)+
                }
            }

            /// How loud it is in the whole, in decibels beside its file's own loudness.
            pub fn decibels(self) -> f32 {
                match self {
                    $(Sound::$sound => $decibels,)+
                }
            }
        }
    };
}

sounds! {
    /// A step on rock.
    StepRock = "step_rock", 6, -5.0;
    /// A step on dressed stone.
    StepMasonry = "step_masonry", 6, -5.0;
    /// A step on planks.
    StepTimber = "step_timber", 6, -4.5;
    /// A step on iron.
    StepIron = "step_iron", 6, -6.0;
    /// Down from a small height.
    LandSoft = "land_soft", 4, -5.0;
    /// Down from a great height.
    LandHard = "land_hard", 4, -2.0;
    /// Push off, breath, cloth.
    Jump = "jump", 4, -8.0;
    /// Cloth that moves.
    Cloth = "cloth", 4, -11.0;
    /// Against a wall or a ceiling.
    Bump = "bump", 4, -6.0;
    /// Off a wall.
    WallJump = "wall_jump", 4, -6.0;
    /// Hands on a ledge.
    Grab = "grab", 4, -6.0;
    /// The next hold of a wall.
    Scrape = "scrape", 4, -10.0;
    /// The next rung of a ladder.
    Rung = "rung", 4, -7.0;
    /// The next grip of a vine.
    Rope = "rope", 4, -8.0;
    /// A crusher comes down.
    Slam = "slam", 3, 0.0;
    /// A machine starts or stops.
    Clunk = "clunk", 3, -7.0;
    /// Stone over stone.
    Door = "door", 3, -4.0;
    /// A plate gives way.
    Lever = "lever", 3, -4.0;
    /// The lantern's handle.
    Swing = "swing", 3, -9.0;
    /// A body into deep water.
    Splash = "splash", 3, -2.0;
    /// A drop in a cave.
    Drip = "drip", 3, -6.0;
    /// The lodestone wakes.
    Checkpoint = "checkpoint", 1, -3.0;
    /// A hidden place is found.
    Secret = "secret", 1, -3.0;
    /// The hero dies.
    Death = "death", 1, -3.0;
    /// The hero is back.
    Respawn = "respawn", 1, -4.0;
    /// The goal is reached.
    Goal = "goal", 1, -1.0;
    /// Another entry of a menu.
    MenuMove = "menu_move", 1, -4.0;
    /// An entry is chosen.
    MenuChoose = "menu_choose", 1, -3.0;
    /// Back out of a menu.
    MenuBack = "menu_back", 1, -3.0;
}

impl Sound {
    /// The file of a variation, counted from 0.
    pub fn file(self, variant: u8) -> String {
        match self.variants() {
            1 => format!("{}.ogg", self.name()),
            _ => format!("{}_{}.ogg", self.name(), variant + 1),
        }
    }
}

/// Writes the loops: an enum, their files' names, their loudness, and from how many places at once each may be heard.
macro_rules! loops {
    ($($(#[$about:meta])+ $sound:ident = $file:literal, $decibels:literal, $voices:literal;)+) => {
        /// A sound that goes on, louder and softer.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Loop {
            $($(#[$about])+ $sound,)+
        }

        impl Loop {
            /// All of them, in the order above.
            pub const ALL: &[Loop] = &[$(Loop::$sound,)+];

            /// Its file.
            pub fn file(self) -> &'static str {
                match self {
                    $(Loop::$sound => concat!($file, ".ogg"),)+
                }
            }

            /// How loud it is in the whole at most, in decibels beside its file's own loudness.
            pub fn decibels(self) -> f32 {
                match self {
                    $(Loop::$sound => $decibels,)+
                }
            }

            /// From how many places at once it may be heard.
            pub const fn voices(self) -> usize {
                match self {
                    $(Loop::$sound => $voices,)+
                }
            }
        }
    };
}

loops! {
    /// Wind over stone, with gusts.
    Wind = "wind", -4.0, 1;
    /// Air that rushes past.
    Fall = "fall", -2.0, 1;
    /// The cape in it.
    Cape = "cape", -9.0, 1;
    /// Boots and a glove along a wall.
    Slide = "slide", 0.0, 1;
    /// A lamp that burns.
    Hum = "hum", -8.0, 1;
    /// Water that laps.
    Water = "water", -2.0, 1;
    /// A lift's winch.
    Motor = "motor", -1.0, 3;
    /// Its chain.
    Chain = "chain", -6.0, 3;
    /// Slats over rollers.
    Belt = "belt", -3.0, 2;
}

impl Loop {
    /// Which of all levels are those of its voices.
    pub fn slots(self) -> std::ops::Range<usize> {
        let before = Loop::ALL.iter().take(self as usize);
        let first = before.map(|other| other.voices()).sum();
        first..first + self.voices()
    }

    /// The first of them.
    pub fn slot(self) -> usize {
        self.slots().start
    }
}

/// How many voices all loops have together.
pub const LOOPS: usize = {
    let (mut sum, mut index) = (0, 0);
    while index < Loop::ALL.len() {
        sum += Loop::ALL[index].voices();
        index += 1;
    }
    sum
};

/// A piece of music.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Piece {
    /// Of the open quarry at dusk, and of the heights.
    #[default]
    Dusk,
    /// Of the works and the depths.
    Deep,
}

/// A layer of a piece; all layers of a piece are equally long.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Layer {
    /// What is always there.
    Pad,
    /// Soft drums and a low string: while one moves.
    Pulse,
    /// Strings and bells: where the place has something to tell.
    Melody,
    /// Bowed iron: when danger is near.
    Tension,
}

impl Piece {
    /// Both.
    pub const ALL: &[Piece] = &[Piece::Dusk, Piece::Deep];

    /// The file of a layer.
    pub fn file(self, layer: Layer) -> &'static str {
        match (self, layer) {
            (Piece::Dusk, Layer::Pad) => "dusk_pad.ogg",
            (Piece::Dusk, Layer::Pulse) => "dusk_pulse.ogg",
            (Piece::Dusk, Layer::Melody) => "dusk_melody.ogg",
            (Piece::Dusk, Layer::Tension) => "dusk_tension.ogg",
            (Piece::Deep, Layer::Pad) => "deep_pad.ogg",
            (Piece::Deep, Layer::Pulse) => "deep_pulse.ogg",
            (Piece::Deep, Layer::Melody) => "deep_melody.ogg",
            (Piece::Deep, Layer::Tension) => "deep_tension.ogg",
        }
    }
}

impl Layer {
    /// All of them, in the order above.
    pub const ALL: [Layer; 4] = [Layer::Pad, Layer::Pulse, Layer::Melody, Layer::Tension];
}
