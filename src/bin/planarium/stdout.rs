//! Whether standard output was open when the program was started.
//!
//! Rust's runtime opens `/dev/null` in place of a closed standard output before `main`: what is written there is lost, and no
//! error tells. So the descriptor is looked at before the runtime starts, where the platform allows it.

use std::sync::atomic::{AtomicBool, Ordering};

static WAS_CLOSED: AtomicBool = AtomicBool::new(false);

/// Whether nothing can be written to standard output since it was closed from the start; `false` on platforms that do not tell.
pub fn was_closed() -> bool {
    WAS_CLOSED.load(Ordering::Relaxed)
}

/// Run by the C runtime before `main`.
#[cfg(target_os = "linux")]
#[allow(unsafe_code)] // The attribute alone: the function has the type that the section asks for and does nothing unsafe.
#[used]
#[unsafe(link_section = ".init_array")]
static LOOK: extern "C" fn() = {
    extern "C" fn look() {
        // Without /proc nothing is known.
        let is_closed =
            std::fs::exists("/proc/self/fd").unwrap_or(false) && std::fs::symlink_metadata("/proc/self/fd/1").is_err();
        WAS_CLOSED.store(is_closed, Ordering::Relaxed);
    }
    look
};
