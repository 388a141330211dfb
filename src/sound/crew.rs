//! Who of many is heard, when there are only so many voices: the loudest, and who has a voice keeps it.

/// The voices of a loop, and who has them.
#[derive(Clone, Debug)]
pub struct Crew<const VOICES: usize> {
    of: [Option<usize>; VOICES],
}

impl<const VOICES: usize> Default for Crew<VOICES> {
    fn default() -> Self {
        Crew { of: [None; VOICES] }
    }
}

impl<const VOICES: usize> Crew<VOICES> {
    /// Gives a voice each to the loudest of all, who are known by their numbers. Who had one and is still among them keeps it,
    /// so that nobody jumps from side to side. A voice that nobody has is silent.
    pub fn seat<T: Copy>(
        &mut self,
        all: impl Iterator<Item = (usize, T)>,
        gain: impl Fn(T) -> f32,
    ) -> [Option<T>; VOICES] {
        let loudness = |one: &Option<(usize, T)>| one.map_or(0.0, |(_, level)| gain(level));
        let mut loudest = [None; VOICES];
        for one in all {
            let mut one = Some(one);
            for place in &mut loudest {
                if loudness(&one) > loudness(place) {
                    std::mem::swap(place, &mut one);
                }
            }
        }
        let mut seated = self.of.map(|owner| {
            let is_owner = |one: &&mut Option<(usize, T)>| one.map(|(i, _)| i) == owner;
            owner.and_then(|_| loudest.iter_mut().find(is_owner)?.take())
        });
        let mut others = loudest.into_iter().flatten();
        for voice in seated.iter_mut().filter(|voice| voice.is_none()) {
            *voice = others.next();
        }
        self.of = seated.map(|one| one.map(|(i, _)| i));
        seated.map(|one| one.map(|(_, level)| level))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seat(crew: &mut Crew<2>, gains: &[f32]) -> [f32; 2] {
        let gains = gains.iter().copied().enumerate();
        crew.seat(gains, |gain| gain)
            .map(|gain| gain.unwrap_or(0.0))
    }

    #[test]
    fn the_loudest_are_heard_and_keep_their_voices() {
        let mut crew = Crew::default();
        assert_eq!(seat(&mut crew, &[0.0, 0.0, 0.0]), [0.0, 0.0]);
        assert_eq!(seat(&mut crew, &[0.25, 0.0, 0.5]), [0.5, 0.25]);
        assert_eq!(seat(&mut crew, &[0.75, 0.0, 0.5]), [0.5, 0.75]);
        assert_eq!(seat(&mut crew, &[0.75, 1.0, 0.5]), [1.0, 0.75]);
        assert_eq!(seat(&mut crew, &[0.0, 1.0, 0.0]), [1.0, 0.0]);
    }
}
