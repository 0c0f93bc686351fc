//! The files that commands write: what is there is lost only if an earlier run wrote it, and only once the new one is
//! complete.
//!
//! A file is examined before the work begins and again before it is written. It is refused if it is an input, another
//! output of the same command, or contains anything but an earlier document of its kind. The new document is written
//! into another file of the same folder, which then takes its place. Pipes and devices are written as they are.

use crate::files::{self, failed};
use planarium::Error;
use planarium::error::Code;
use serde::de::{Deserialize, Deserializer, Error as _, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt::{self, Display};
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufReader, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// The most symbolic links to a file that does not exist yet.
const MOST_LINKS: usize = 40;

/// A kind of document: its name in a sentence, and how an earlier one is recognised.
#[derive(Clone, Copy)]
pub struct Kind {
    name: &'static str,
    mark: Mark,
}

/// What every document of a kind has.
#[derive(Clone, Copy)]
enum Mark {
    /// JSON with this `format`.
    Format(&'static str),
    /// JSON with all these fields, of an object or of every object of a list.
    Fields(&'static [&'static str]),
    /// These bytes at its beginning.
    Start(&'static [u8]),
    Roadmap,
}

impl Kind {
    pub const PLAN: Self = Self::fields("a result of this command", &["scenario", "query", "planner", "path", "stats"]);
    pub const FLEET_PLAN: Self =
        Self::fields("a plan of a fleet", &["fleet", "planner", "robots", "makespan", "stats"]);
    pub const NAVIGATION_PLAN: Self =
        Self::fields("a result of this command", &["scenario", "query", "path", "policy", "rollouts", "reached"]);
    pub const COMPARISON: Self = Self::fields("a comparison", &["method", "reached", "collisions", "planned"]);
    pub const REACH: Self = Self::fields("a result of this command", &["scenario", "method", "target", "solutions"]);
    pub const OPTIMUM: Self = Self::fields("a shortest path", &["length", "path", "method", "exact"]);
    pub const CERTIFICATE: Self = Self::format("a certificate", "planarium-certificate-1");
    pub const POLICY: Self = Self::format("a policy", "planarium-policy-1");
    pub const SCENARIO: Self = Self::format("a scenario", planarium::scenario::FORMAT);
    pub const FLEET: Self = Self::format("a fleet", planarium::fleet::FORMAT);
    pub const NAVIGATION: Self = Self::format("a navigation task", planarium::navigation::FORMAT);
    pub const ROADMAP: Self = Self { name: "a roadmap", mark: Mark::Roadmap };
    pub const OMPL_LOG: Self = Self { name: "a log of a sweep", mark: Mark::Start(b"Planarium version ") };

    /// Text whose first line has the names of columns.
    pub const fn table(header: &'static str) -> Self {
        Self { name: "a table of this command", mark: Mark::Start(header.as_bytes()) }
    }

    const fn fields(name: &'static str, fields: &'static [&'static str]) -> Self {
        Self { name, mark: Mark::Fields(fields) }
    }

    const fn format(name: &'static str, format: &'static str) -> Self {
        Self { name, mark: Mark::Format(format) }
    }

    /// Whether a file contains a document of this kind.
    fn is_in(self, path: &Path) -> io::Result<bool> {
        let starts_with = |start: &[u8]| -> io::Result<bool> {
            let mut begin = Vec::new();
            File::open(path)?.take(start.len() as u64).read_to_end(&mut begin)?;
            Ok(begin == start)
        };
        let outline = || -> io::Result<Outline> {
            // What is not JSON has no outline.
            Ok(serde_json::from_reader(BufReader::new(File::open(path)?)).unwrap_or_default())
        };
        match self.mark {
            Mark::Start(start) => starts_with(start),
            Mark::Format(format) => Ok(outline()?.format.as_deref() == Some(format)),
            Mark::Fields(fields) => {
                let known = outline()?.fields;
                Ok(fields.iter().all(|field| known.iter().any(|name| name == field)))
            }
            Mark::Roadmap => Ok(starts_with(&planarium::run::storage::MAGIC)?
                || starts_with(GRAPHML)?
                || outline()?.format.is_some_and(|format| format.starts_with("planarium-roadmap-"))),
        }
    }
}

/// The beginning of a roadmap as GraphML.
const GRAPHML: &[u8] =
    b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n\
    <key id=\"scenario\" for=\"graph\"";

/// The fields of a JSON object and its `format`; of a list, those of its first object.
#[derive(Default)]
struct Outline {
    fields: Vec<String>,
    format: Option<String>,
}

impl<'de> Deserialize<'de> for Outline {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        struct Fields;
        impl<'de> Visitor<'de> for Fields {
            type Value = Outline;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object, or a list of objects")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Outline, A::Error> {
                let mut outline = Outline::default();
                while let Some(name) = map.next_key::<String>()? {
                    if name == "format" {
                        outline.format = map.next_value::<serde_json::Value>()?.as_str().map(str::to_owned);
                    } else {
                        map.next_value::<IgnoredAny>()?;
                    }
                    outline.fields.push(name);
                }
                Ok(outline)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Outline, A::Error> {
                let first = list.next_element::<Outline>()?.ok_or_else(|| A::Error::custom("an empty list"))?;
                while list.next_element::<Outline>()?.is_some() {}
                Ok(first)
            }
        }
        source.deserialize_any(Fields)
    }
}

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

    /// Refuses a file that is an input or an earlier output. Only regular files and new ones are told apart.
    ///
    /// # Errors
    /// `would-overwrite`
    pub fn claim(&mut self, name: &str) -> Result<(), Error> {
        let Some(identity) = Identity::of(Path::new(name)) else { return Ok(()) };
        if let Some((what, other, _)) = self.files.iter().find(|(_, _, other)| *other == identity) {
            return Err(would_overwrite(name, &format!("it is {what} of this command ({other:?})")));
        }
        self.files.push(("another output", name.to_owned(), identity));
        Ok(())
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

/// The error for a file that is not written.
pub fn would_overwrite(name: &str, why: &dyn Display) -> Error {
    Error::new(Code::WouldOverwrite, "", format!("{name:?} is not written: {why}; it is left as it is"))
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

/// Where a file that does not exist will be: links to it are followed, and its folder has one name.
fn new_file(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let folder = fs::canonicalize(folder)?;
        let Some(name) = path.file_name() else { break };
        let file = folder.join(name);
        match fs::read_link(&file) {
            Ok(target) => path = folder.join(target),
            Err(_) => return Ok(file),
        }
    }
    Err(io::Error::new(ErrorKind::InvalidInput, "it is not the name of a file"))
}

/// Which file it is, whatever names it has.
#[derive(Debug, PartialEq, Eq)]
enum Identity {
    /// The device and the number of a file.
    #[cfg(unix)]
    Number(u64, u64),
    /// Where there are no numbers, or no file yet.
    Path(PathBuf),
}

impl Identity {
    /// The identity of a regular file, or of one that does not exist; `None` of folders, pipes and devices.
    fn of(path: &Path) -> Option<Self> {
        match fs::metadata(path) {
            #[cfg(unix)]
            Ok(found) => Self::of_found(&found),
            #[cfg(not(unix))]
            Ok(found) => found.is_file().then(|| fs::canonicalize(path).ok().map(Self::Path)).flatten(),
            Err(_) => new_file(path).ok().map(Self::Path),
        }
    }

    #[cfg(unix)]
    fn of_found(found: &Metadata) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        found.is_file().then(|| Self::Number(found.dev(), found.ino()))
    }

    #[cfg(unix)]
    fn of_descriptor(descriptor: std::os::fd::BorrowedFd) -> Option<Self> {
        let file = File::from(descriptor.try_clone_to_owned().ok()?);
        Self::of_found(&file.metadata().ok()?)
    }

    /// The regular file that standard input comes from.
    fn of_input() -> Option<Self> {
        #[cfg(unix)]
        return Self::of_descriptor(std::os::fd::AsFd::as_fd(&io::stdin()));
        #[cfg(not(unix))]
        None
    }

    /// The regular file that standard output goes into.
    fn of_output() -> Option<Self> {
        #[cfg(unix)]
        return Self::of_descriptor(std::os::fd::AsFd::as_fd(&io::stdout()));
        #[cfg(not(unix))]
        None
    }
}

/// Whether standard output goes into this input, which is a file or standard input.
pub fn is_standard_output(input: &str) -> bool {
    let Some(output) = Identity::of_output() else { return false };
    let input = if input == "-" { Identity::of_input() } else { Identity::of(Path::new(input)) };
    input == Some(output)
}
