//! An index of one type, behind the face.

use super::{Answer, MAX_CONFIGURATIONS, Neighbours};
use crate::error::{Code, Error, Number};
use crate::graph::VertexId;
use crate::nearest::{Nearest, Neighbour};
use crate::space::Space;
use crate::world::Configurations;

/// An index with the space that it is of, and what may go in.
pub(super) struct Held<S, I> {
    pub space: S,
    pub index: I,
    pub configurations: Configurations,
    /// How many configurations it may hold.
    pub most: usize,
}

impl<S: Space, I: Nearest<S>> Held<S, I> {
    /// What the index answers to a question about `q`.
    fn ask(&self, q: &[f64], ask: impl Fn(&S::State, &mut Vec<Neighbour>) -> usize) -> Result<Answer, Error> {
        self.configurations.refuse_outside(q, "/q")?;
        let mut neighbours = Vec::new();
        let visited = ask(&self.space.state(q), &mut neighbours);
        Ok(Answer { neighbours, visited })
    }
}

impl<S: Space, I: Nearest<S>> Neighbours for Held<S, I> {
    fn dimension(&self) -> usize {
        self.configurations.dimension()
    }

    fn len(&self) -> usize {
        self.index.len()
    }

    fn add(&mut self, rows: &[f64]) -> Result<(), Error> {
        refuse(&self.configurations, rows, self.len(), self.most)?;
        for q in rows.chunks_exact(self.dimension()) {
            let vertex = VertexId(self.len() as u32);
            self.index.insert(&self.space, vertex, self.space.state(q));
        }
        Ok(())
    }

    fn k_nearest(&self, q: &[f64], k: usize) -> Result<Answer, Error> {
        self.ask(q, |state, found| self.index.k_nearest(&self.space, state, k.min(self.len()), found))
    }

    fn within(&self, q: &[f64], radius: f64) -> Result<Answer, Error> {
        // Not a number, too.
        if !(radius >= 0.0 && radius.is_finite()) {
            let code = if radius.is_finite() { Code::OutOfRange } else { Code::NotFinite };
            let sentence = format!("a radius is a finite number, 0 or more, not {}", Number(radius));
            return Err(Error::new(code, "/radius", sentence));
        }
        self.ask(q, |state, found| self.index.within(&self.space, state, radius, found))
    }
}

/// Refuses rows that cannot be added to so many; the same code for every index.
fn refuse(configurations: &Configurations, rows: &[f64], held: usize, most: usize) -> Result<(), Error> {
    let dimension = configurations.dimension();
    if !rows.len().is_multiple_of(dimension) {
        let sentence = format!("rows have {dimension} numbers each; {} numbers are not whole rows", rows.len());
        return Err(Error::new(Code::WrongDimension, "/rows", sentence));
    }
    let wanted = held + rows.len() / dimension;
    if wanted > most {
        let kind = if most < MAX_CONFIGURATIONS { " of so many trees" } else { "" };
        let sentence = format!("an index{kind} holds {most} configurations at most, not {wanted}");
        return Err(Error::new(Code::TooLarge, "/rows", sentence));
    }
    for (row, q) in rows.chunks_exact(dimension).enumerate() {
        configurations.refuse_outside(q, "").map_err(|error| error.under(&format!("/rows/{row}")))?;
    }
    Ok(())
}
