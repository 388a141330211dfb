//! What the player must be told: problems that last until they are solved, and short notices that fade.

use crate::cli::terminal;
use std::time::Duration;

/// How long a notice stays.
const STAY: Duration = Duration::from_secs(4);

/// What a problem is about; one problem of each at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// The level file.
    Level,
    /// The tuning file.
    Tuning,
    /// The shaders.
    Shaders,
    /// The hero's model.
    Hero,
    /// A game controller, or the window.
    Device,
    /// The recording.
    Recording,
    /// What was read of settings and progress.
    Settings,
    /// Settings that could not be saved.
    Unsaved,
    /// What has been reached and could not be saved.
    Progress,
    /// A sound's file.
    Sound,
}

impl Topic {
    /// For people.
    pub fn name(self) -> &'static str {
        match self {
            Topic::Level => "Level",
            Topic::Tuning => "Tuning",
            Topic::Shaders => "Shaders",
            Topic::Hero => "Hero",
            Topic::Device => "Device",
            Topic::Recording => "Recording",
            Topic::Settings | Topic::Unsaved => "Settings",
            Topic::Progress => "Progress",
            Topic::Sound => "Sound",
        }
    }

    /// What the game makes of it.
    pub fn remedy(self) -> &'static str {
        match self {
            Topic::Level | Topic::Tuning | Topic::Shaders | Topic::Hero => {
                "the last good state goes on"
            }
            Topic::Device | Topic::Recording => "the game goes on",
            Topic::Sound => "the game goes on without it",
            Topic::Settings => "the game goes on with what it could read",
            Topic::Unsaved => "not saved, they hold until the game is left",
            Topic::Progress => "not saved, the game goes on and tries again at the next checkpoint",
        }
    }
}

/// Everything to be told.
#[derive(Debug, Default)]
pub struct Notices {
    problems: Vec<(Topic, String)>,
    notice: Option<(String, Duration)>,
}

impl Notices {
    /// A problem that lasts, in place of the last one about this topic. It is said in the terminal too, once.
    pub fn fail(&mut self, topic: Topic, reason: impl ToString) {
        let problem = (topic, reason.to_string());
        if !self.problems.contains(&problem) {
            terminal::say(format!("{}; {}", problem.1, topic.remedy()));
        }
        self.solve(topic);
        self.problems.push(problem);
    }

    /// There is no problem with this topic any more.
    pub fn solve(&mut self, topic: Topic) {
        self.problems.retain(|(t, _)| *t != topic);
    }

    /// Says something in passing.
    pub fn say(&mut self, text: impl ToString) {
        self.notice = Some((text.to_string(), STAY));
    }

    /// Lets time pass.
    pub fn advance(&mut self, elapsed: Duration) {
        self.notice = self
            .notice
            .take()
            .filter(|(_, left)| *left > elapsed)
            .map(|(t, left)| (t, left - elapsed));
    }

    /// The problems, the oldest first.
    pub fn problems(&self) -> &[(Topic, String)] {
        &self.problems
    }

    /// The notice, and how visible it still is: 1, then falling to 0.
    pub fn notice(&self) -> Option<(&str, f32)> {
        self.notice
            .as_ref()
            .map(|(text, left)| (text.as_str(), left.as_secs_f32().min(1.0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_could_not_be_written_is_not_said_to_be_read() {
        for topic in [Topic::Unsaved, Topic::Progress] {
            assert!(topic.remedy().starts_with("not saved"), "{topic:?}");
        }
        assert!(Topic::Settings.remedy().contains("read"));
    }

    #[test]
    fn a_problem_stays_until_solved_and_a_notice_fades() {
        let mut notices = Notices::default();
        notices.fail(Topic::Level, "first");
        notices.fail(Topic::Level, "second");
        notices.say("saved");
        notices.advance(Duration::from_millis(3500));
        assert_eq!(notices.problems(), [(Topic::Level, "second".to_string())]);
        assert_eq!(notices.notice(), Some(("saved", 0.5)));
        notices.advance(Duration::from_secs(1));
        notices.solve(Topic::Level);
        assert!(notices.problems().is_empty() && notices.notice().is_none());
    }
}
