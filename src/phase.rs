//! What a run is busy with.

/// What a run is busy with. Its number is that in [`Phase::ALL`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    pub const ALL: [Phase; 7] = [
        Phase::Sampling,
        Phase::Connecting,
        Phase::Guarding,
        Phase::Searching,
        Phase::Growing,
        Phase::Improving,
        Phase::Done,
    ];

    /// The phase in a word, the same everywhere.
    pub fn as_str(self) -> &'static str {
        match self {
            Phase::Sampling => "sampling",
            Phase::Connecting => "connecting",
            Phase::Guarding => "guarding",
            Phase::Searching => "searching",
            Phase::Growing => "growing",
            Phase::Improving => "improving",
            Phase::Done => "done",
        }
    }
}
