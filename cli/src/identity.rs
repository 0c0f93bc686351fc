//! Which file a name stands for: the names of inputs and outputs are compared by it.

use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The most symbolic links to a file that does not exist yet.
const MOST_LINKS: usize = 40;

/// Which file it is, whatever names it has.
#[derive(Debug, PartialEq, Eq)]
pub enum Identity {
    /// The device and the number of a file.
    #[cfg(unix)]
    Number(u64, u64),
    /// Where there are no numbers, or no file yet.
    Path(PathBuf),
}

impl Identity {
    /// The identity of a regular file, or of one that does not exist; `None` of folders, pipes and devices.
    pub fn of(path: &Path) -> Option<Self> {
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
    pub fn of_input() -> Option<Self> {
        #[cfg(unix)]
        return Self::of_descriptor(std::os::fd::AsFd::as_fd(&io::stdin()));
        #[cfg(not(unix))]
        None
    }

    /// The regular file that standard output goes into.
    pub fn of_output() -> Option<Self> {
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

/// Where a file that does not exist will be: links to it are followed, and its folder has one name.
pub fn new_file(path: &Path) -> io::Result<PathBuf> {
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
