//! Only the dependencies are built.
