//! JSON as a plain tree: read from text, written as text.
//!
//! The contracts are read from this tree and not straight into structs, so that every refusal can say where it stands.

mod names;
mod node;
mod read;
mod write;

pub(crate) use names::Names;
pub(crate) use node::push_field;
pub use node::{MAX_DEPTH, MAX_TEXT, Node};
