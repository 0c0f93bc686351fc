//! The parts of an experiment, which several machines may run.

use std::ops::Range;

/// Part `index`, from 1, of `count` equal parts; all of it by default.
#[derive(Clone, Copy)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Default for Shard {
    fn default() -> Self {
        Self { index: 1, count: 1 }
    }
}

impl Shard {
    /// Reads `I/N`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
        let shard = parts
            .map(|(index, count)| Self { index, count })
            .filter(|shard: &Self| (1..=shard.count).contains(&shard.index));
        shard.ok_or_else(|| "a shard reads I/N, with I from 1 to N".to_owned())
    }

    /// Whether it is the first part.
    pub fn is_first(self) -> bool {
        self.index == 1
    }

    /// The trials of this part.
    pub fn trials(self, all: u64) -> Range<u64> {
        let until = |index: u64| (u128::from(all) * u128::from(index) / u128::from(self.count)) as u64;
        until(self.index - 1)..until(self.index)
    }
}
