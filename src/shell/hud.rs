//! What every player sees beside the world: few words, gone when they are known.

use super::menu::caps::{self, with_alpha};
use super::menu::prompts::{self, Cap, Device};
use super::menu::view::{ALARM, INK, PAPER, WARM};
use super::notices::Notices;
use super::settings::progress::clock;
use super::settings::{Bindings, Deed};
use super::text::{Face, Style, Symbol, Text};
use crate::game::{Away, Back, View, World};
use crate::level::Skill;
use std::fmt::Write;
use std::mem::take;

/// Seconds of an area's name: until it is there, until it begins to go, until it is gone. What goes, goes quickly: half gone
/// it cannot be read.
const NAME: [f32; 3] = [0.6, 4.4, 5.0];
/// The same of the first prompts, of a checkpoint, of a secret.
const PROMPTS: [f32; 3] = [0.8, 9.9, 10.5];
const WORD: [f32; 3] = [0.2, 2.9, 3.3];
/// Share of the last second of a notice in which it goes: who reads slowly can read it until then.
const NOTICE_GOES: f32 = 0.4;
/// Seconds in which the picture comes out of the dark after another world was entered.
const CURTAIN: f32 = 0.8;
/// Seconds in which the flash of a death is over, and the most it covers.
const FLASH: f32 = 0.4;
const BRIGHT: f32 = 0.5;
/// Size of the picture's height that lengths are meant for.
const DESIGN: f32 = 720.0;
/// Heights of lines as shares of the picture's height.
const NAME_AT: f32 = 0.235;
const WORD_AT: f32 = 0.135;
const NOTICE_AT: f32 = 0.075;
const PROMPTS_AT: f32 = 0.935;
/// How dark the picture is made behind large words, behind small ones and behind problems, so that they read before a bright
/// sky and a lit gate: letters have at least 4.5 times the light of what is behind them.
const SHADE: f32 = 0.78;
const PLATE: f32 = 0.72;
const PROBLEM_PLATE: f32 = 0.84;
/// Height of a plate behind a line, how much of that is over the baseline, and how far it reaches beyond the words, in sizes
/// of the letters.
const PLATE_HEIGHT: f32 = 2.0;
const PLATE_OVER: f32 = 1.36;
const PLATE_BESIDE: f32 = 1.1;
/// Heights of the lines of a problem, and the room between two problems and at their sides, at that height.
const PROBLEM_LINES: [f32; 2] = [21.0, 20.0];
const PROBLEM_GAP: f32 = 16.0;
const PROBLEM_ROOM: f32 = 12.0;
/// Widest problem that is told in one line, as a share of the picture's width.
const PROBLEM_WIDTH: f32 = 0.46;

/// A word in passing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Word {
    Checkpoint,
    Secret,
}

/// The keys or buttons of a prompt, and what they do.
type Prompt = ([Option<Cap>; 2], &'static str);

/// Seconds in which a lesson comes, and in which it goes.
const LESSON: [f32; 2] = [0.5, 0.35];

/// What the prompts show, made anew when a key is bound or another device is used.
#[derive(Debug)]
struct Prompts {
    device: Device,
    bindings: Bindings,
    groups: [Prompt; 6],
    lessons: [(Skill, [Prompt; 1]); 5],
}

/// What is shown, and since when.
#[derive(Debug, Default)]
pub struct Hud {
    area: Option<usize>,
    named: f32,
    begun: f32,
    word: Option<(Word, f32)>,
    secrets: u32,
    began_at: f64,
    deaths: u32,
    /// How dark the picture still is, 0 to 1.
    curtain: f32,
    /// How bright it still is after a death, 0 to 1.
    flash: f32,
    prompts: Option<Prompts>,
    /// What is told where the hero is, and how much of it is there, 0 to 1.
    lesson: Option<(Skill, f32)>,
    /// Room to put words together in.
    words: String,
}

/// What the display is drawn from.
pub struct Scene<'a> {
    /// The world that is played.
    pub world: &'a World,
    /// The moment that is drawn.
    pub view: &'a View,
    /// What went wrong, and what is said in passing.
    pub notices: &'a Notices,
    /// What does what, on what is in use.
    pub bindings: &'a Bindings,
    /// What the player has used last.
    pub device: Device,
    /// Why time stands still, if it does without a menu.
    pub held: Option<&'static str>,
    /// Nobody can play: the keys are of no use.
    pub is_shown_only: bool,
    /// Share of the picture's width on the left that is covered.
    pub covered: f32,
}

impl Hud {
    /// Begins anew, with the name of the place.
    pub fn begin(&mut self) {
        *self = Hud {
            curtain: self.curtain,
            flash: self.flash,
            deaths: self.deaths,
            prompts: self.prompts.take(),
            words: take(&mut self.words),
            ..Hud::default()
        };
    }

    /// Another world is entered: its picture comes out of the dark.
    pub fn draw_curtain(&mut self) {
        self.curtain = 1.0;
    }

    /// What the player is told now, if anything.
    pub fn told(&self) -> Option<Skill> {
        self.lesson.map(|(skill, _)| skill)
    }

    /// Over the whole picture: the dark that is left of a curtain, and the light that is left of a death, if flashes are
    /// shown; without them a death is dark.
    pub fn veil(&self, text: &mut Text, flashes: bool) {
        let [width, height] = text.size();
        let flash = if flashes { PAPER } else { INK };
        for (colour, left) in [
            (INK, self.curtain * self.curtain),
            (flash, BRIGHT * self.flash * self.flash),
        ] {
            if left > 0.0 {
                text.rect([0.0, 0.0, width, height], with_alpha(colour, left));
            }
        }
    }

    /// A checkpoint was reached.
    pub fn checkpoint(&mut self) {
        self.word = Some((Word::Checkpoint, 0.0));
    }

    /// Lets time pass, in seconds, for what the player is told where the hero is: one thing after the other, and nothing while the
    /// first prompts are there.
    pub fn teach(&mut self, seconds: f32, wanted: Option<Skill>) {
        let wanted = wanted.filter(|_| self.begun >= PROMPTS[2]);
        let [come, go] = LESSON;
        self.lesson = match (self.lesson, wanted) {
            (Some((skill, there)), wanted) if wanted == Some(skill) => {
                Some((skill, (there + seconds / come).min(1.0)))
            }
            (Some((skill, there)), _) if there > seconds / go => {
                Some((skill, there - seconds / go))
            }
            (_, wanted) => wanted.map(|skill| (skill, 0.0)),
        };
    }

    /// Lets time pass, in seconds, and sees what has changed.
    pub fn advance(&mut self, seconds: f32, view: &View) {
        if view.began_at != self.began_at {
            self.begin();
            self.began_at = view.began_at;
        }
        if self.area != Some(view.area) {
            (self.area, self.named) = (Some(view.area), 0.0);
        }
        if view.secrets > self.secrets {
            self.word = Some((Word::Secret, 0.0));
        }
        self.secrets = view.secrets;
        if view.deaths > self.deaths {
            self.flash = 1.0;
        }
        self.deaths = view.deaths;
        self.flash = (self.flash - seconds / FLASH).max(0.0);
        self.curtain = (self.curtain - seconds / CURTAIN).max(0.0);
        self.begun += seconds;
        self.take_turns(seconds);
    }

    /// The name of a place and a word in passing are not shown at once: who came second waits.
    fn take_turns(&mut self, seconds: f32) {
        let says = self.word.is_some_and(|(_, age)| shown(age, WORD) > 0.0);
        if self.named > 0.0 || !says {
            self.named += seconds;
        }
        let names = shown(self.named, NAME) > 0.0;
        if let Some((_, age)) = &mut self.word
            && (*age > 0.0 || !names)
        {
            *age += seconds;
        }
    }

    /// Draws it on the text's page.
    pub fn draw(&mut self, text: &mut Text, scene: &Scene) {
        let mut pen = Pen::new(text, scene);
        self.words.clear();
        if let Some(held) = scene.held {
            pen.name(held, None, 1.0);
        } else if let Some(won) = scene.view.won_at {
            let age = (scene.view.time - won) as f32;
            let (time, deaths) = (clock(scene.view.run_time()), scene.view.deaths);
            let _ = write!(self.words, "{time}   deaths {deaths}"); // a String takes everything
            pen.name("Goal reached", Some(&self.words), age.clamp(0.0, 1.0));
        } else if let Some(away) = &scene.view.away {
            waiting(&mut self.words, away, scene.view);
            pen.word(&self.words, 1.0);
        } else {
            self.place(&mut pen);
        }
        pen.notice();
    }

    /// Problems, which are told whatever else is shown.
    pub fn problems(text: &mut Text, notices: &Notices) {
        let [width, height] = text.size();
        let unit = height / DESIGN;
        let style = body(15.0 * unit);
        let [title_line, line] = PROBLEM_LINES.map(|line| line * unit);
        let right = width - 24.0 * unit;
        let mut y = 34.0 * unit;
        for (topic, reason) in notices.problems() {
            let title = format!("{}: {}", topic.name(), topic.remedy());
            let paragraphs = reason.lines();
            let lines: Vec<&str> = paragraphs
                .flat_map(|words| text.broken(style, words, width * PROBLEM_WIDTH))
                .collect();
            let widest = lines
                .iter()
                .map(|words| text.width(style, words))
                .fold(text.width(style, &title), f32::max);
            let room = PROBLEM_ROOM * unit;
            let high = title_line + lines.len() as f32 * line;
            let (top, wide) = (y - line + 1.0 * unit, widest + 2.0 * room);
            let plate = [right - widest - room, top, wide, high + 0.4 * line];
            text.rect(plate, with_alpha(INK, PROBLEM_PLATE));
            text.ending(style.in_colour(ALARM), right, y, &title);
            y += title_line;
            for words in lines {
                text.ending(style, right, y, words);
                y += line;
            }
            y += PROBLEM_GAP * unit;
        }
    }

    fn place(&mut self, pen: &mut Pen) {
        let opacity = shown(self.named, NAME);
        if opacity > 0.0 {
            let level = &pen.scene.world.stage().level;
            let area = self.area.and_then(|area| level.areas.get(area));
            let name = area.map_or(level.name.as_str(), |area| area.name.as_str());
            pen.name(name, None, opacity);
        }
        if let Some((word, age)) = self.word {
            let found = self.secrets as usize;
            let of = pen.scene.world.stage().secret_count();
            match word {
                Word::Checkpoint => pen.word("Checkpoint", shown(age, WORD)),
                Word::Secret => {
                    let _ = write!(self.words, "Secret {found} of {of}"); // a String takes everything
                    pen.word(&self.words, shown(age, WORD));
                }
            }
        }
        if !pen.scene.is_shown_only {
            let (device, bindings) = (pen.scene.device, pen.scene.bindings);
            let known = self.prompts.take();
            let known = known.filter(|p| p.device == device && p.bindings == *bindings);
            let prompts = known.unwrap_or_else(|| Prompts::new(device, bindings));
            pen.prompts(&prompts.groups, shown(self.begun, PROMPTS));
            if let Some((skill, there)) = self.lesson {
                let mut lessons = prompts.lessons.iter();
                if let Some((_, lesson)) = lessons.find(|(of, _)| *of == skill) {
                    pen.prompts(lesson, there);
                }
            }
            self.prompts = Some(prompts);
        }
    }
}

impl Prompts {
    fn new(device: Device, bindings: &Bindings) -> Prompts {
        let deed = |deed| prompts::deed(deed, device, bindings);
        let one = |deed_of| [deed(deed_of), None];
        let run = match device {
            Device::Keys => [deed(Deed::Left), deed(Deed::Right)],
            Device::Pad(_) => [Some(Cap::Plate("Stick")), None],
        };
        Prompts {
            device,
            bindings: bindings.clone(),
            groups: [
                (run, "run"),
                (one(Deed::Jump), "jump"),
                (one(Deed::Up), "climb"),
                (one(Deed::Crouch), "crouch"),
                (one(Deed::Retry), "retry"),
                ([Some(prompts::pause(device)), None], "pause"),
            ],
            lessons: [
                (Skill::Crouch, [(one(Deed::Crouch), "crouch")]),
                (
                    Skill::Drop,
                    [(
                        [deed(Deed::Down), deed(Deed::Jump)],
                        "drop through the boards",
                    )],
                ),
                (Skill::WallJump, [(one(Deed::Jump), "jump off the wall")]),
                (Skill::Ledge, [(one(Deed::Up), "climb up from the ledge")]),
                (
                    Skill::Look,
                    [([prompts::look(device, bindings), None], "look up")],
                ),
            ],
        }
    }
}

fn body(px: f32) -> Style {
    Style {
        face: Face::Body,
        px,
        tracking: 0.02,
        colour: PAPER,
        shadow: 0.8,
    }
}

/// Where things go, and how large.
struct Pen<'a> {
    text: &'a mut Text,
    scene: &'a Scene<'a>,
    unit: f32,
    middle: f32,
    height: f32,
}

impl<'a> Pen<'a> {
    fn new(text: &'a mut Text, scene: &'a Scene<'a>) -> Pen<'a> {
        let [width, height] = text.size();
        Pen {
            unit: height / DESIGN,
            middle: width * (1.0 + scene.covered) / 2.0,
            height,
            text,
            scene,
        }
    }

    /// A name over a thin line that fades to both sides, and a line below it.
    fn name(&mut self, name: &str, below: Option<&str>, opacity: f32) {
        let unit = self.unit;
        let style = Style {
            face: Face::Display,
            px: 46.0 * unit,
            tracking: 0.04,
            colour: with_alpha(PAPER, opacity),
            shadow: 1.0,
        };
        let y = self.height * NAME_AT;
        let (wide, high) = (self.text.width(style, name) + 420.0 * unit, 250.0 * unit);
        self.shade(y + 16.0 * unit, [wide, high], SHADE * opacity);
        self.text.centred(style, self.middle, y, name);
        let [line, thick] = [y + 24.0 * unit, (1.3 * unit).max(1.0).round()].map(f32::round);
        let reach = self.text.width(style, name) / 2.0 + 40.0 * unit;
        let [full, none] = [0.7 * opacity, 0.0].map(|a| with_alpha(WARM, a));
        let gap = 14.0 * unit;
        let (left, right) = (self.middle - reach, self.middle + gap);
        self.text
            .shaded([left, line, reach - gap, thick], [none, full, none, full]);
        self.text
            .shaded([right, line, reach - gap, thick], [full, none, full, none]);
        let at = [self.middle, line + thick / 2.0];
        self.text
            .symbol(Symbol::Lozenge, at, 9.0 * unit, with_alpha(WARM, opacity));
        if let Some(below) = below {
            let style = body(24.0 * unit).in_colour(with_alpha(PAPER, opacity));
            self.text
                .centred(style, self.middle, y + 62.0 * unit, below);
        }
    }

    /// A soft dark spot behind words.
    fn shade(&mut self, y: f32, size: [f32; 2], opacity: f32) {
        let colour = with_alpha(INK, opacity);
        self.text.glow([self.middle, y], size, colour);
    }

    /// A dark plate behind a line of small words.
    fn plate(&mut self, [left, right]: [f32; 2], baseline: f32, px: f32, opacity: f32) {
        let beside = PLATE_BESIDE * px;
        let top = baseline - PLATE_OVER * px;
        let plate = [
            left - beside,
            top,
            right - left + 2.0 * beside,
            PLATE_HEIGHT * px,
        ];
        self.text
            .pill(plate, true, with_alpha(INK, PLATE * opacity));
    }

    /// A word with a light beside it.
    fn word(&mut self, word: &str, opacity: f32) {
        if opacity <= 0.0 {
            return;
        }
        let unit = self.unit;
        let style = body(23.0 * unit).in_colour(with_alpha(WARM, opacity));
        let y = self.height * WORD_AT;
        let width = self.text.width(style, word);
        let start = self.middle - width / 2.0;
        let at = [start - 20.0 * unit, y - self.text.cap_height(style) / 2.0];
        self.plate([at[0], start + width], y, style.px, opacity);
        self.text
            .glow(at, [90.0 * unit; 2], with_alpha(WARM, 0.45 * opacity));
        self.text
            .symbol(Symbol::Lozenge, at, 12.0 * unit, style.colour);
        self.text.write(style, start, y, word);
    }

    /// What is said in passing.
    fn notice(&mut self) {
        if let Some((words, left)) = self.scene.notices.notice() {
            let opacity = (left / NOTICE_GOES).min(1.0);
            let style = body(20.0 * self.unit).in_colour(with_alpha(PAPER, opacity));
            let y = self.height * NOTICE_AT;
            let half = self.text.width(style, words) / 2.0;
            let ends = [self.middle - half, self.middle + half];
            self.plate(ends, y, style.px, opacity);
            self.text.centred(style, self.middle, y, words);
        }
    }

    /// The keys, or the buttons, of the device in use.
    fn prompts(&mut self, groups: &[Prompt], opacity: f32) {
        if opacity <= 0.0 {
            return;
        }
        let px = 17.0 * self.unit;
        let style = body(px).in_colour(with_alpha(PAPER, opacity));
        let (between, within) = (px * 1.9, px * 0.5);
        let width = |pen: &Pen, (found, words): &Prompt| {
            let widths = found.iter().flatten();
            let all: f32 = widths
                .map(|cap| caps::width(pen.text, cap, px) + within)
                .sum();
            all + pen.text.width(style, words)
        };
        let all: f32 = groups
            .iter()
            .map(|group| width(self, group) + between)
            .sum();
        let baseline = (self.height * PROMPTS_AT).round();
        let mut x = self.middle - (all - between) / 2.0;
        self.plate([x, x + all - between], baseline, px, opacity);
        for (found, words) in groups {
            for cap in found.iter().flatten() {
                x = caps::draw(self.text, cap, x, baseline, px, style.colour) + within;
            }
            x = self.text.write(style, x, baseline, words) + between;
        }
    }
}

/// What is waited for, and how long still, for a hero who is nowhere.
fn waiting(words: &mut String, away: &Away, view: &View) {
    let place = match (away.back, view.checkpoint) {
        (Back::Last, Some(_)) => "checkpoint",
        (Back::Earlier, _) => "earlier checkpoint",
        (Back::Last | Back::Start | Back::Anew, _) => "start",
    };
    let left = away.until.map(|until| (until - view.time).max(0.0));
    let _ = match left {
        Some(left) => write!(words, "Waiting until the {place} is free: {left:.1} s"),
        None => write!(words, "The {place} is closed"),
    }; // a String takes everything
}

/// How visible something is that comes, stays and goes.
fn shown(now: f32, [there, going, gone]: [f32; 3]) -> f32 {
    let (come, go) = (now / there, (gone - now) / (gone - going));
    come.min(go).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    #[test]
    fn a_name_comes_stays_and_goes() {
        let times = [0.0, 0.3, 2.0, 4.7, 6.0].map(|t| shown(t, NAME));
        for (found, wanted) in times.into_iter().zip([0.0, 0.5, 1.0, 0.5, 0.0]) {
            assert!((found - wanted).abs() < 1e-6, "{times:?}");
        }
    }

    #[test]
    fn a_wait_says_for_what_and_how_long() {
        let said = |back, until, checkpoint: Option<DVec2>| {
            let view = View {
                time: 3.0,
                checkpoint,
                ..View::at(DVec2::ZERO)
            };
            let mut words = String::new();
            waiting(&mut words, &Away::new(2.0, until, back), &view);
            words
        };
        let camp = Some(DVec2::ONE);
        assert_eq!(
            said(Back::Last, Some(4.25), camp),
            "Waiting until the checkpoint is free: 1.2 s"
        );
        assert_eq!(
            said(Back::Last, Some(2.9), None),
            "Waiting until the start is free: 0.0 s"
        );
        assert_eq!(
            said(Back::Earlier, Some(4.0), camp),
            "Waiting until the earlier checkpoint is free: 1.0 s"
        );
        assert_eq!(said(Back::Last, None, None), "The start is closed");
    }

    #[test]
    fn a_name_and_a_word_take_turns() {
        let seen = |hud: &Hud| {
            let word = hud.word.map_or(0.0, |(_, age)| shown(age, WORD));
            (shown(hud.named, NAME) > 0.0, word > 0.0)
        };
        let after = |hud: &mut Hud, seconds: f32| {
            for _ in 0..(seconds * 10.0) as u32 {
                hud.take_turns(0.1);
                assert_ne!(seen(hud), (true, true));
            }
            seen(hud)
        };
        let mut hud = Hud::default();
        assert_eq!(after(&mut hud, 1.0), (true, false));
        hud.checkpoint();
        assert_eq!(after(&mut hud, 3.0), (true, false), "the word waits");
        assert_eq!(after(&mut hud, 2.0), (false, true), "and has its turn");
        hud.named = 0.0;
        assert_eq!(after(&mut hud, 1.0), (false, true), "now the name waits");
        assert_eq!(after(&mut hud, 2.0), (true, false), "and has its turn");
    }

    /// The brightest sky behind words, as a share of white: none of the golden skies has more.
    const SKY: f32 = 0.93;

    fn light([r, g, b, _]: [f32; 4]) -> f32 {
        let linear = |c: f32| match c <= 0.04045 {
            true => c / 12.92,
            false => ((c + 0.055) / 1.055).powf(2.4),
        };
        0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)
    }

    #[test]
    fn words_read_before_the_brightest_sky() {
        for (ink, plate) in [
            (PAPER, SHADE),
            (PAPER, PLATE),
            (WARM, PLATE),
            (PAPER, PROBLEM_PLATE),
            (ALARM, PROBLEM_PLATE),
        ] {
            let behind = INK.map(|ink| SKY + (ink - SKY) * plate);
            let contrast = (light(ink) + 0.05) / (light(behind) + 0.05);
            assert!(contrast >= 4.5, "{ink:?} on {plate}: {contrast}");
        }
    }
}
