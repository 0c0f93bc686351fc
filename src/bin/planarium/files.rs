//! Reading and writing: files, standard input and output.

use crate::stdout;
use planarium::Error;
use planarium::error::Code;
use std::io::{self, ErrorKind, Read, Write};

/// The text of the file; of standard input for `-`.
pub fn read(name: &str) -> Result<String, Error> {
    let text = if name == "-" {
        let mut text = String::new();
        io::stdin().lock().read_to_string(&mut text).map(|_| text)
    } else {
        std::fs::read_to_string(name)
    };
    text.map_err(|error| unreadable(name, &error))
}

/// The bytes of the file; of standard input for `-`.
pub fn read_bytes(name: &str) -> Result<Vec<u8>, Error> {
    let bytes = if name == "-" {
        let mut bytes = Vec::new();
        io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        std::fs::read(name)
    };
    bytes.map_err(|error| unreadable(name, &error))
}

/// Writes the document and a line break to the file, or to standard output where no file is named.
pub fn write(document: &str, file: Option<&str>) -> Result<(), Error> {
    match file {
        Some(name) => write_bytes(format!("{document}\n").as_bytes(), name),
        None => print(document),
    }
}

/// Writes the bytes to the file.
pub fn write_bytes(bytes: &[u8], name: &str) -> Result<(), Error> {
    std::fs::write(name, bytes)
        .map_err(|error| Error::new(Code::File, "", format!("cannot write {}: {error}", quoted(name))))
}

/// Writes the text and a line break to standard output. A reader that has gone away is no error.
pub fn print(text: &str) -> Result<(), Error> {
    if stdout::was_closed() {
        return Err(Error::new(Code::File, "", "cannot write to standard output: it is closed"));
    }
    let mut out = io::stdout().lock();
    match writeln!(out, "{text}").and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Error::new(Code::File, "", format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Tells a person something, on standard error. Where that is closed, nobody listens.
pub fn say(message: &str) {
    let _ = writeln!(io::stderr().lock(), "{message}");
}

fn unreadable(name: &str, error: &io::Error) -> Error {
    Error::new(Code::File, "", format!("cannot read {}: {error}", quoted(name)))
}

fn quoted(name: &str) -> String {
    if name == "-" { "standard input".to_owned() } else { format!("{name:?}") }
}
