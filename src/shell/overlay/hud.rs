//! What every player sees beside the world: few words, small, gone when they are known.

use super::style::{ACCENT, ALARM};
use super::{Fonts, Info};
use imgui::{DrawListMut, FontId, Ui};

/// Seconds of the level's name: until it is there, until it begins to go, until it is gone.
const TITLE: [f64; 3] = [0.8, 3.2, 4.4];
/// The same of the hint.
const HINT: [f64; 3] = [1.2, 8.0, 9.5];
/// Seconds in which the message at the goal appears.
const GOAL: f64 = 0.6;

const WHITE: [f32; 3] = [0.96, 0.95, 0.92];
const WARM: [f32; 3] = [ACCENT[0], ACCENT[1], ACCENT[2]];

/// Where text goes, and how.
struct Pen<'a> {
    ui: &'a Ui,
    list: DrawListMut<'a>,
    left: f32, // what a panel covers
    size: [f32; 2],
}

impl Pen<'_> {
    /// Centred text at a share of the picture's height, with a soft shadow that separates it from any ground.
    fn centred(&self, font: FontId, text: &str, height: f32, [r, g, b]: [f32; 3], alpha: f32) {
        if alpha <= 0.0 {
            return;
        }
        let _font = self.ui.push_font(font);
        let [width, line] = self.ui.calc_text_size(text);
        let place = [
            ((self.left + self.size[0] - width) / 2.0).round(),
            (self.size[1] * height - line / 2.0).round(),
        ];
        // Below and to both sides, softly: dark enough on a bright sky, no outline on a dark wall.
        let offset = (line / 16.0).max(1.0);
        for (dx, dy) in [(0.0, 1.0), (1.0, 0.0), (-1.0, 0.0), (1.0, 1.0)] {
            let shadow = [place[0] + dx * offset, place[1] + dy * offset];
            self.list
                .add_text(shadow, [0.02, 0.03, 0.05, alpha * 0.45], text);
        }
        self.list.add_text(place, [r, g, b, alpha], text);
    }

    /// The same on a dark plate, for small text over a busy picture.
    fn plated(&self, font: FontId, text: &str, height: f32, colour: [f32; 3], alpha: f32) {
        let [width, line] = self.ui.calc_text_size(text);
        let middle = [(self.left + self.size[0]) / 2.0, self.size[1] * height];
        let half = [width / 2.0 + line, line * 0.9];
        let corner = |sign: f32| [middle[0] + sign * half[0], middle[1] + sign * half[1]];
        self.list
            .add_rect(corner(-1.0), corner(1.0), [0.02, 0.03, 0.06, 0.6 * alpha])
            .filled(true)
            .rounding(line * 0.5)
            .build();
        self.centred(font, text, height, colour, alpha);
    }

    /// Darkens the whole picture.
    fn veil(&self, alpha: f32) {
        self.list
            .add_rect([0.0; 2], self.size, [0.02, 0.03, 0.06, alpha])
            .filled(true)
            .build();
    }
}

/// Draws over the world and below the panels; `left` is the width that a panel covers.
pub fn draw(ui: &Ui, fonts: Fonts, info: &Info, left: f32) {
    let size = ui.io().display_size;
    let list = ui.get_background_draw_list();
    let pen = Pen {
        ui,
        list,
        left,
        size,
    };
    match (info.paused, info.pause_notice, info.view.won_at) {
        (true, Some(reason), _) => pause(&pen, fonts, info, reason),
        (_, _, Some(won)) => goal(&pen, fonts, info, won),
        _ => beginning(&pen, fonts, info),
    }
    if let Some((text, alpha)) = info.notices.notice() {
        pen.plated(fonts.body, text, 0.07, WARM, alpha);
    }
}

/// Where we are, and what the keys are.
fn beginning(pen: &Pen, fonts: Fonts, info: &Info) {
    let now = info.view.time;
    pen.centred(
        fonts.title,
        &info.play.summary.level,
        0.24,
        WHITE,
        shown(now, TITLE),
    );
    if pen.left == 0.0 {
        pen.plated(fonts.body, hint(info), 0.93, WHITE, 0.85 * shown(now, HINT));
    }
}

/// That it is done, and how long it took.
fn goal(pen: &Pen, fonts: Fonts, info: &Info, won: f64) {
    let alpha = ((info.view.time - won) / GOAL).clamp(0.0, 1.0) as f32;
    let time = clock(info.view.run_time());
    let again = if info.pads > 0 { "Back" } else { "R" };
    pen.centred(fonts.title, "You reached the goal", 0.24, WARM, alpha);
    pen.plated(
        fonts.body,
        &format!("{time}      {again}  once more"),
        0.315,
        WHITE,
        alpha,
    );
}

/// That time stands still, and what one can do about it. Above the hero, who stands in the middle.
fn pause(pen: &Pen, fonts: Fonts, info: &Info, reason: &str) {
    let keys = if info.pads > 0 {
        "Start  go on      Back  restart      Q  quit"
    } else {
        "Esc  go on      R  restart      F1  tools      Q  quit"
    };
    pen.veil(0.45);
    pen.centred(fonts.title, reason, 0.24, WHITE, 1.0);
    pen.plated(fonts.body, keys, 0.315, WHITE, 0.9);
}

/// A small panel for what is broken, over everything, whether or not the overlay is open.
pub fn problems(ui: &Ui, info: &Info) {
    if info.notices.problems().is_empty() {
        return;
    }
    let [width, _] = ui.io().display_size;
    let line = ui.current_font_size();
    ui.window("Problems")
        .position([width - line, line], imgui::Condition::Always)
        .position_pivot([1.0, 0.0])
        .size_constraints([line * 20.0, 0.0], [line * 36.0, line * 30.0])
        .no_decoration()
        .movable(false)
        .always_auto_resize(true)
        .focus_on_appearing(false)
        .build(|| {
            let _wrap = ui.push_text_wrap_pos_with_pos(line * 34.0);
            for (topic, reason) in info.notices.problems() {
                ui.text_colored(
                    ALARM,
                    format!("{}: the last good state goes on", topic.name()),
                );
                ui.text(reason);
            }
        });
}

/// The keys, or the buttons if there is a controller: whoever plugs one in wants to play with it.
fn hint(info: &Info) -> &'static str {
    if info.pads > 0 {
        "Stick  run      A  jump      B  crouch      Back  restart      Start  pause"
    } else {
        "Arrows or A D  run      Space  jump      Down  crouch      R  restart      Esc  pause      F1  tools"
    }
}

/// How visible something is that comes, stays and goes.
fn shown(now: f64, [there, going, gone]: [f64; 3]) -> f32 {
    let (come, go) = (now / there, (gone - now) / (gone - going));
    come.min(go).clamp(0.0, 1.0) as f32
}

/// Minutes, seconds and hundredths.
fn clock(seconds: f64) -> String {
    let hundredths = (seconds * 100.0).floor() as u64;
    format!(
        "{}:{:02}.{:02}",
        hundredths / 6000,
        hundredths / 100 % 60,
        hundredths % 100
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_comes_stays_and_goes() {
        assert_eq!(
            [0.0, 0.4, 2.0, 3.8, 5.0].map(|t| shown(t, TITLE)),
            [0.0, 0.5, 1.0, 0.5, 0.0]
        );
    }

    #[test]
    fn times_are_written_as_on_a_watch() {
        assert_eq!(
            [0.0, 59.999, 83.456].map(clock),
            ["0:00.00", "0:59.99", "1:23.45"]
        );
    }
}
