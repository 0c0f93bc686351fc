//! Motion planning that a person can watch.
#![deny(missing_docs)]
