//! The files that commands write: what is there is lost only if an earlier run wrote it, and only once the new one is
//! complete.
//!
//! A file is examined before the work begins and again before it is written. It is refused if it is an input, another
//! output of the same command, or contains anything but an earlier document of its kind. The new document is written
//! into another file of the same folder, which then takes its place. Pipes and devices are written as they are.

use crate::files::{self, failed, would_overwrite};
use crate::identity::{Identity, new_file};
use crate::kind::Kind;
use clap::Args;
use planarium::Error;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// What a file is for that is not an input.
const OUTPUT: &str = "another output";

/// The outputs of a command, beside its inputs.
pub struct Outputs {
    force: bool,
    /// What each file is for, its name, and which file it is.
    files: Vec<(&'static str, String, Identity)>,
}

impl Outputs {
    /// No outputs yet, beside these inputs; `force` replaces files of other contents.
    pub fn beside<'a>(inputs: impl IntoIterator<Item = &'a str>, force: bool) -> Self {
        let identified = inputs.into_iter().filter_map(|name| {
            let of = if name == "-" { Identity::of_input() } else { Identity::of(Path::new(name)) };
            Some(("an input", name.to_owned(), of?))
        });
        Self { force, files: identified.collect() }
    }

    /// The output for a document: standard output if no file is named.
    ///
    /// # Errors
    /// `would-overwrite`, `file`
    pub fn add(&mut self, name: Option<&str>, kind: Kind) -> Result<Output, Error> {
        if let Some(name) = name {
            self.claim(name)?;
            Place::of(name, kind, self.force)?;
        }
        Ok(Output { name: name.map(str::to_owned), kind, force: self.force })
    }

    /// Refuses a file that is an input or an earlier output. Only regular files and new ones are compared.
    ///
    /// # Errors
    /// `would-overwrite`
    pub fn claim(&mut self, name: &str) -> Result<(), Error> {
        let Some(identity) = Identity::of(Path::new(name)) else { return Ok(()) };
        if let Some((what, other, _)) = self.files.iter().find(|(_, _, other)| *other == identity) {
            return Err(would_overwrite(name, &format!("it is {what} of this command ({other:?})")));
        }
        self.files.push((OUTPUT, name.to_owned(), identity));
        Ok(())
    }

    /// Refuses a further input that is an output.
    ///
    /// # Errors
    /// `would-overwrite`
    pub fn check_input(&self, name: &str) -> Result<(), Error> {
        let identity = Identity::of(Path::new(name));
        match self.files.iter().find(|(what, _, other)| *what == OUTPUT && Some(other) == identity.as_ref()) {
            Some((_, output, _)) => Err(would_overwrite(output, &format!("it is an input of this command ({name:?})"))),
            None => Ok(()),
        }
    }

    /// Refuses standard output if it goes into an output that is written from its beginning, or continued.
    ///
    /// # Errors
    /// `would-overwrite`
    pub fn claim_apart_from_standard_output(&mut self, name: &str) -> Result<(), Error> {
        if Identity::of_output().is_some_and(|output| Identity::of(Path::new(name)) == Some(output)) {
            return Err(would_overwrite(name, &"standard output goes into the same file"));
        }
        self.claim(name)
    }
}

/// Where the document of a command goes.
#[derive(Args)]
pub struct Destination {
    /// Write the document to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    pub force: bool,
}

impl Destination {
    /// The output of a document, and room for further ones beside the inputs.
    ///
    /// # Errors
    /// Those of [`Outputs::add`]
    pub fn beside<'a>(
        &self,
        inputs: impl IntoIterator<Item = &'a str>,
        kind: Kind,
    ) -> Result<(Outputs, Output), Error> {
        let mut outputs = Outputs::beside(inputs, self.force);
        let out = outputs.add(self.out.as_deref(), kind)?;
        Ok((outputs, out))
    }
}

/// Where a document goes.
pub struct Output {
    /// `None` for standard output.
    name: Option<String>,
    kind: Kind,
    force: bool,
}

impl Output {
    /// Writes a document and a line break.
    ///
    /// # Errors
    /// `file`; `would-overwrite` if the file was changed since the command began
    pub fn write(&self, document: &str) -> Result<(), Error> {
        self.write_bytes(format!("{document}\n").as_bytes())
    }

    /// Writes all bytes, as [`Output::write`] does.
    pub fn write_bytes(&self, bytes: &[u8]) -> Result<(), Error> {
        let Some(name) = &self.name else { return files::print_bytes(bytes) };
        let written = match Place::of(name, self.kind, self.force)? {
            Place::StandardOutput => return files::print_bytes(bytes),
            Place::Stream => OpenOptions::new().write(true).open(name).and_then(|mut stream| stream.write_all(bytes)),
            Place::File { target, before } => replace(&target, before.as_ref(), bytes),
        };
        written.map_err(|error| failed("write", name, &error))
    }
}

/// What a name stands for.
enum Place {
    /// A regular file that standard output goes into: written through it, so that nothing before is lost.
    StandardOutput,
    /// A pipe or a device.
    Stream,
    /// A file, with the metadata of the one that it replaces.
    File { target: PathBuf, before: Option<Metadata> },
}

impl Place {
    /// Examines a name; nothing is changed.
    fn of(name: &str, kind: Kind, force: bool) -> Result<Self, Error> {
        let path = Path::new(name);
        let unwritable = |error: io::Error| failed("write", name, &error);
        let found = match fs::metadata(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let target = new_file(path).map_err(unwritable)?;
                return Ok(Self::File { target, before: None });
            }
            found => found.map_err(unwritable)?,
        };
        if found.is_dir() {
            return Err(failed("write", name, &"it is a folder"));
        }
        if !found.is_file() {
            return Ok(Self::Stream);
        }
        if Identity::of_output().is_some_and(|output| Identity::of(path) == Some(output)) {
            return Ok(Self::StandardOutput);
        }
        check_writable(path, &found).map_err(unwritable)?;
        if !force && found.len() > 0 && !kind.is_in(path).map_err(|error| failed("read", name, &error))? {
            let why = format!("it contains something else than {}; --force replaces it", kind.name);
            return Err(would_overwrite(name, &why));
        }
        Ok(Self::File { target: fs::canonicalize(path).map_err(unwritable)?, before: Some(found) })
    }
}

/// Refuses a file that may not be written: to replace it, only its folder would have to be writable.
pub fn check_writable(path: &Path, found: &Metadata) -> io::Result<()> {
    if found.permissions().readonly() {
        return Err(io::Error::new(ErrorKind::PermissionDenied, "it is read-only"));
    }
    OpenOptions::new().write(true).open(path).map(drop)
}

/// Writes a new file of the same folder, which then takes the place of the target and has its permissions.
pub fn replace(target: &Path, before: Option<&Metadata>, bytes: &[u8]) -> io::Result<()> {
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let (mut file, temporary) = temporary_in(folder)?;
    let mut write = || {
        file.write_all(bytes)?;
        if let Some(before) = before {
            keep_owner(&file, before);
            file.set_permissions(before.permissions())?;
        }
        file.sync_all()?;
        fs::rename(&temporary, target)
    };
    let written = write();
    match &written {
        Err(_) => drop(fs::remove_file(&temporary)),
        // The new name survives a power cut; file systems that cannot promise it are trusted.
        Ok(()) => drop(File::open(folder).and_then(|folder| folder.sync_all())),
    }
    written
}

/// A new file with a name that no other file of the folder has.
fn temporary_in(folder: &Path) -> io::Result<(File, PathBuf)> {
    let mut number = 0;
    loop {
        let path = folder.join(format!(".planarium-{}-{number}.partial", std::process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => number += 1,
            file => return Ok((file?, path)),
        }
    }
}

/// Gives a file the owner and the group of another, as far as that is allowed.
#[cfg(unix)]
fn keep_owner(file: &File, before: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let _ = fchown(file, Some(before.uid()), Some(before.gid()));
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}
