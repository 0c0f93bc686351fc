//! What a run is busy with.

use strum::{IntoStaticStr, VariantArray};

/// What a run is busy with. Its number is that in [`Phase::ALL`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Phase {
    /// Samples are drawn and become vertices.
    Sampling,
    /// Vertices are joined to their neighbours.
    Connecting,
    /// Samples become guards of a visibility roadmap, or links between them.
    Guarding,
    /// The roadmap is searched.
    Searching,
    /// A tree grows, or two.
    Growing,
    /// A path is there and gets shorter.
    Improving,
    /// Nothing is left to do.
    Done,
}

impl Phase {
    /// Every phase, in the order of their numbers.
    pub const ALL: &[Phase] = Phase::VARIANTS;

    /// The phase in a word, the same everywhere.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}
