//! Emitted scenes.
