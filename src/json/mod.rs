//! JSON: text read as a tree, a tree read as a type, and values written in one normal form.
//!
//! Text becomes a [`serde_json::Value`] first, so that text that is not JSON is reported before unknown fields; [`read`] turns
//! that into a type. Every error has a JSON pointer (RFC 6901).

mod document;
pub mod hex;
mod tree;
mod typed;
mod write;

pub(crate) use document::{objects, one_format, read_document};
pub use tree::parse;
#[cfg(all(target_arch = "wasm32", feature = "bindings"))]
pub(crate) use tree::{Unread, in_javascript, read_tree};
pub use typed::{by_type, not_negative, read, some_not_negative};
pub(crate) use write::finite_tree;
pub use write::to_string;

/// The longest text that is read, in bytes.
pub const MAX_TEXT: usize = 64 << 20;

/// Arrays and objects are nested less deep than this.
pub const MAX_DEPTH: u32 = 128;

/// Appends the name of a field to a JSON pointer, escaped.
pub(crate) fn push_field(pointer: &mut String, name: &str) {
    pointer.push('/');
    pointer.push_str(&name.replace('~', "~0").replace('/', "~1"));
}

/// Puts the name of a field before a JSON pointer, escaped: an error gets its pointer on its way out, so that values without
/// one cost nothing.
pub(crate) fn put_before(pointer: &mut String, name: &str) {
    let mut field = String::new();
    push_field(&mut field, name);
    pointer.insert_str(0, &field);
}
