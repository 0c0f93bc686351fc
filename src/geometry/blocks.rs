//! The edges that a sweeping line meets, in order: a sequence that changes anywhere.

/// The most edges of a block.
const MOST: usize = 512;

/// A sequence in blocks, so that what enters moves only those of its block. No block is empty.
#[derive(Default)]
pub(super) struct Blocks(Vec<Vec<u32>>);

/// A block and a place in it; for the end, the number of blocks and 0.
pub(super) type Place = (usize, usize);

impl Blocks {
    /// The place of the first of which the condition is false; it is true of all before, and of none after.
    pub fn first_without(&self, is_true: impl Fn(u32) -> bool) -> Place {
        let is_true = |&e: &u32| is_true(e);
        let block = self.0.partition_point(|block| block.last().is_some_and(is_true));
        (block, self.0.get(block).map_or(0, |block| block.partition_point(is_true)))
    }

    pub fn get(&self, (block, at): Place) -> Option<u32> {
        self.0.get(block)?.get(at).copied()
    }

    /// The one before a place.
    pub fn before(&self, (block, at): Place) -> Option<u32> {
        match at.checked_sub(1) {
            Some(before) => self.get((block, before)),
            None => self.0[..block].last()?.last().copied(),
        }
    }

    /// Removes the one at a place, and returns the place of the next.
    pub fn remove(&mut self, (block, at): Place) -> Place {
        let edges = &mut self.0[block];
        edges.remove(at);
        if at < edges.len() {
            return (block, at);
        }
        if edges.is_empty() {
            self.0.remove(block);
            return (block, 0);
        }
        (block + 1, 0)
    }

    /// Inserts edges before the one at a place.
    pub fn insert(&mut self, (block, at): Place, edges: &[u32]) {
        if edges.is_empty() {
            return;
        }
        if self.0.is_empty() {
            self.0.push(Vec::new());
        }
        // At the end of a block rather than at the start of the next, which may be none.
        let (block, at) = if at == 0 && block > 0 { (block - 1, self.0[block - 1].len()) } else { (block, at) };
        let full = &mut self.0[block];
        full.splice(at..at, edges.iter().copied());
        if full.len() > MOST {
            // Of many edges at one point there are more than two halves.
            let rest = full.split_off(MOST / 2);
            self.0.splice(block + 1..block + 1, rest.chunks(MOST / 2).map(<[u32]>::to_vec));
        }
    }
}
