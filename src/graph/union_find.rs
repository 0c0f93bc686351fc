//! Connected vertices: disjoint sets, merged by size (Galler and Fischer 1964, "An improved equivalence
//! algorithm"), with path halving.

/// Disjoint sets of the numbers from 0.
#[derive(Debug, Clone, Default)]
pub struct UnionFind {
    parents: Vec<u32>,
    sizes: Vec<u32>,
}

impl UnionFind {
    /// Adds the next number as a set of its own.
    pub fn add(&mut self) {
        self.parents.push(self.parents.len() as u32);
        self.sizes.push(1);
    }

    /// The representative of the set of `i`. Nearly constant time.
    pub fn find(&mut self, i: usize) -> usize {
        let mut at = i;
        while self.parents[at] as usize != at {
            self.parents[at] = self.parents[self.parents[at] as usize];
            at = self.parents[at] as usize;
        }
        at
    }

    /// Merges the sets of `a` and `b`; returns whether they were distinct.
    pub fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.find(a), self.find(b));
        if a == b {
            return false;
        }
        let (small, large) = if self.sizes[a] < self.sizes[b] { (a, b) } else { (b, a) };
        self.parents[small] = large as u32;
        self.sizes[large] += self.sizes[small];
        true
    }
}
