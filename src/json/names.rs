//! Which names there have been so far.

use crate::order;

/// Finds the name of each number.
type Namer<'a> = &'a dyn Fn(u32) -> &'a str;

/// Numbers from 0 on in runs, each sorted by name: as long as the powers of two that make up their count, the longest first. So
/// a name is found in O(log^2 n), and one added in as much on average.
#[derive(Default)]
pub(crate) struct Names {
    numbers: Vec<u32>,
}

impl Names {
    /// Whether one of the numbers has the name.
    pub fn has(&self, name: &str, of: Namer) -> bool {
        let (mut rest, mut is_found) = (&self.numbers[..], false);
        while let Some(last) = rest.len().checked_ilog2() {
            let (run, others) = rest.split_at(1 << last);
            is_found |= run.binary_search_by(|&i| of(i).cmp(name)).is_ok();
            rest = others;
        }
        is_found
    }

    /// Adds the next number, which has a name that none has yet.
    pub fn add(&mut self, of: Namer) {
        let count = self.numbers.len() as u32 + 1;
        self.numbers.push(count - 1);
        let run = (count - (1 << count.trailing_zeros())) as usize;
        order::sort(&mut self.numbers[run..], &|a, b| of(a).cmp(of(b)));
    }
}
