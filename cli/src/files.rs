//! Reading files and standard input, and writing to standard output; [`output`](crate::output) writes files.

use crate::identity::is_standard_output;
use planarium::Error;
use planarium::error::Code;
use planarium::json;
use planarium::scenario::Scenario;
use serde_json::Value;
use std::fmt::Display;
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether standard output was closed from the start; `false` on platforms where this is unknown.
///
/// Rust's runtime opens `/dev/null` in place of a closed standard output before `main`, and output is lost without an error. So
/// the descriptor is checked before the runtime starts.
static WAS_CLOSED: AtomicBool = AtomicBool::new(false);

/// Whether standard output goes into an input: then nothing is printed.
static IS_INPUT: AtomicBool = AtomicBool::new(false);

/// Run by the C runtime before `main`.
#[cfg(target_os = "linux")]
#[allow(unsafe_code)] // The attribute alone: the function has the required type and does nothing unsafe.
#[used]
#[unsafe(link_section = ".init_array")]
static CHECK: extern "C" fn() = {
    extern "C" fn check() {
        // Without /proc this is unknown.
        let is_closed =
            std::fs::exists("/proc/self/fd").unwrap_or(false) && std::fs::symlink_metadata("/proc/self/fd/1").is_err();
        WAS_CLOSED.store(is_closed, Ordering::Relaxed);
    }
    check
};

/// The scenario of the file. `other` is the name of a second input and its file, which cannot both be standard input.
pub fn scenario(name: &str, other: Option<(&str, &str)>) -> Result<Scenario, Error> {
    Scenario::read(&document(name, other)?)
}

/// The same as a tree, whatever its format.
pub fn document(name: &str, other: Option<(&str, &str)>) -> Result<Value, Error> {
    refuse_both(name, other)?;
    json::parse(&read(name)?)
}

/// Refuses a second input that is standard input if the first is.
pub fn refuse_both(name: &str, other: Option<(&str, &str)>) -> Result<(), Error> {
    match other.filter(|_| name == "-") {
        Some((what, "-")) => {
            let sentence = format!("scenario and {what} cannot both come from standard input");
            Err(Error::new(Code::Usage, "", sentence))
        }
        _ => Ok(()),
    }
}

/// The text of the file; of standard input for `-`.
pub fn read(name: &str) -> Result<String, Error> {
    text(name, read_bytes(name)?)
}

/// The bytes of a file as text.
pub fn text(name: &str, bytes: Vec<u8>) -> Result<String, Error> {
    String::from_utf8(bytes).map_err(|_| failed("read", name, &"it is not valid UTF-8"))
}

/// The bytes of the file; of standard input for `-`. A file that standard output goes into is refused.
pub fn read_bytes(name: &str) -> Result<Vec<u8>, Error> {
    read_at_most(name, u64::MAX)
}

/// The first `most` bytes of a file.
pub fn read_at_most(name: &str, most: u64) -> Result<Vec<u8>, Error> {
    if is_standard_output(name) {
        IS_INPUT.store(true, Ordering::Relaxed);
        return Err(would_overwrite(name, &"it is an input of this command, and standard output goes into it"));
    }
    let mut bytes = Vec::new();
    let result = if name == "-" {
        io::stdin().lock().take(most).read_to_end(&mut bytes)
    } else {
        File::open(name).and_then(|file| file.take(most).read_to_end(&mut bytes))
    };
    result.map(|_| bytes).map_err(|error| match error.kind() {
        ErrorKind::IsADirectory => failed("read", name, &"it is a folder, not a file"),
        _ => failed("read", name, &error),
    })
}

/// Writes the text and a line break to standard output. A closed pipe is not an error.
pub fn print(text: &str) -> Result<(), Error> {
    print_bytes(format!("{text}\n").as_bytes())
}

/// Writes all bytes to standard output.
pub fn print_bytes(bytes: &[u8]) -> Result<(), Error> {
    let unwritten =
        |why: &dyn Display| Err(Error::new(Code::File, "", format!("cannot write to standard output: {why}")));
    if WAS_CLOSED.load(Ordering::Relaxed) {
        return unwritten(&"it is closed");
    }
    if IS_INPUT.load(Ordering::Relaxed) {
        return unwritten(&"it goes into an input of this command");
    }
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => unwritten(&error),
        _ => Ok(()),
    }
}

/// Prints a message on standard error. A closed standard error is not an error.
pub fn say(message: &str) {
    let _ = writeln!(io::stderr().lock(), "{message}");
}

pub fn failed(what: &str, name: &str, why: &dyn Display) -> Error {
    let quoted = if name == "-" { "standard input".to_owned() } else { format!("{name:?}") };
    Error::new(Code::File, "", format!("cannot {what} {quoted}: {why}"))
}

/// The error for a file that is not written.
pub fn would_overwrite(name: &str, why: &dyn Display) -> Error {
    Error::new(Code::WouldOverwrite, "", format!("{name:?} is not written: {why}; it is left as it is"))
}
