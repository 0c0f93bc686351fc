//! The files of a sweep: rows of trials as CSV or as lines of JSON, and beside them their times.
//!
//! Rows come in the order of trials. Each begins with the fingerprint of its experiment and the number of its trial, so a file
//! tells what it belongs to; only the first shard begins with the names of columns. So the files of all shards, one after
//! another, are the file of one run. Times differ between runs and have a file of their own.

use super::shard::Shard;
use crate::files::{failed, would_overwrite};
use crate::output::{check_writable, replace};
use clap::ValueEnum;
use csv::{ReaderBuilder, Terminator, WriterBuilder};
use planarium::Error;
use planarium::error::Code;
use planarium::experiment::{Experiment, cell_text};
use planarium::json;
use serde_json::Value;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Seek, SeekFrom, Take, Write};
use std::ops::Range;
use std::path::Path;

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    Csv,
    /// One object per line
    Json,
}

const TIMES: [&str; 3] = ["trial", "build_seconds", "search_seconds"];

/// A row as it is read: its cells as text, and its times, NaN if they are unknown.
pub struct Row {
    pub trial: u64,
    pub cells: Vec<String>,
    pub seconds: [f64; 2],
}

/// The files of one shard of an experiment: rows, and times.
pub struct Rows {
    names: [String; 2],
    format: Format,
    experiment: String,
    pub columns: Vec<String>,
    pub trials: Range<u64>,
    /// Whether the file begins with the names of columns.
    has_header: bool,
}

/// A line, or several with a line break in quotes.
struct Record {
    /// Where it begins in its file, in bytes.
    start: u64,
    /// How many bytes a sweep writes for it.
    length: u64,
    cells: Vec<String>,
}

impl Rows {
    /// The rows of a shard in the file of this name; the times of `runs.csv` are in `runs.times.csv`.
    pub fn new(experiment: &Experiment, name: &str, format: Format, shard: Shard) -> Self {
        let trials = shard.trials(experiment.trial_count());
        let times = format!("{}.times.csv", name.strip_suffix(".csv").unwrap_or(name));
        let (hex, columns) = (format!("{:016x}", experiment.fingerprint()), experiment.columns());
        Self { names: [name.to_owned(), times], format, experiment: hex, columns, trials, has_header: shard.is_first() }
    }

    /// The names of the two files.
    pub fn names(&self) -> &[String; 2] {
        &self.names
    }

    /// Opens the files to be continued after their last complete row; returns the number of the trial that comes next.
    /// With `force`, a file that cannot be continued is replaced by an empty one.
    ///
    /// # Errors
    /// Nothing is changed: `other-experiment` if the file of rows has anything but the experiment's rows up to the next
    /// one; `would-overwrite` if that of times has anything but times. `file`.
    pub fn resume(&self, force: bool) -> Result<(u64, Writer), Error> {
        let forced = |error: Error, name: &str| match error.code() {
            Code::OtherExperiment | Code::WouldOverwrite if force => emptied(name),
            _ => Err(error),
        };
        let next = match self.examine_rows() {
            Ok((next, _)) => next,
            Err(error) => forced(error, &self.names[0]).map(|()| self.trials.start)?,
        };
        self.examine_times(next).map(drop).or_else(|error| forced(error, &self.names[1]))?;
        let [rows, times] = &self.names;
        let files = [opened(rows)?, opened(times)?];
        // Another sweep may have ended since.
        let (next, size) = self.examine_rows()?;
        let times_size = self.examine_times(next)?;
        for (file, name, size) in [(&files[0], rows, size), (&files[1], times, times_size)] {
            file.set_len(size).map_err(|error| failed("write", name, &error))?;
        }
        let mut writer = Writer { names: self.names.clone(), files, pending: Default::default() };
        if self.has_header {
            if size == 0 && self.format == Format::Csv {
                writer.pending[0] = csv_line(&self.columns);
            }
            if times_size == 0 {
                writer.pending[1] = csv_line(&TIMES);
            }
        }
        writer.flush()?;
        Ok((next, writer))
    }

    /// A row as a line.
    pub fn line(&self, cells: &[Value]) -> Vec<u8> {
        if self.format == Format::Csv {
            return csv_line(&cells.iter().map(cell_text).collect::<Vec<_>>());
        }
        let field = |(name, cell)| format!("{}:{}", json::to_string::<String>(name), json::to_string::<Value>(cell));
        format!("{{{}}}\n", self.columns.iter().zip(cells).map(field).collect::<Vec<_>>().join(",")).into_bytes()
    }

    /// Reads all complete rows, with their times.
    pub fn read(&self, mut each: impl FnMut(Row) -> Result<(), Error>) -> Result<(), Error> {
        let times = records(&self.names[1], Format::Csv, &[]).map_err(|error| self.unreadable(1, error))?;
        let mut times = times.filter_map(|record| timed(&record.ok()?.cells)).peekable();
        self.each(|trial, cells| {
            while times.next_if(|(other, _)| *other < trial).is_some() {}
            let seconds = times.next_if(|(other, _)| *other == trial).map_or([f64::NAN; 2], |(_, seconds)| seconds);
            each(Row { trial, cells, seconds })
        })?;
        Ok(())
    }

    /// The number of the trial that comes next, and the size of the complete rows in bytes. All of the file is the
    /// experiment's: the rows are as they were written, and what follows them is the beginning of the next one.
    fn examine_rows(&self) -> Result<(u64, u64), Error> {
        let mut next = self.trials.start;
        let size = self.each(|trial, _| {
            next = trial + 1;
            Ok(())
        })?;
        let hex = &self.experiment;
        let expected = match self.format {
            Format::Csv if size == 0 && self.has_header => csv_line(&self.columns),
            Format::Csv => format!("{hex},{next},").into_bytes(),
            Format::Json => format!("{{\"experiment\":\"{hex}\",\"trial\":{next},").into_bytes(),
        };
        let rest = beginning(&self.names[0], size, expected.len()).map_err(|error| self.unreadable(0, error))?;
        let is_complete = next == self.trials.end;
        if !rest.is_empty() && (is_complete || !expected.starts_with(&rest)) {
            return Err(self.other(next, "it goes on with something else"));
        }
        Ok((next, size))
    }

    /// Calls with the number and the cells of each complete row; returns the size of all of them in bytes.
    fn each(&self, mut each: impl FnMut(u64, Vec<String>) -> Result<(), Error>) -> Result<u64, Error> {
        let records = records(&self.names[0], self.format, &self.columns).map_err(|error| self.unreadable(0, error))?;
        let (mut records, mut next, mut size) = (records.peekable(), self.trials.start, 0);
        let mut needs_header = self.format == Format::Csv && self.has_header;
        while let Some(record) = records.next() {
            let Record { start, length, cells } = record.map_err(|why| self.other(next, &why))?;
            // A row can be cut within a quoted line break.
            if self.format == Format::Csv
                && cells.len() < self.columns.len()
                && records.peek().is_none()
                && !needs_header
            {
                return Ok(size);
            }
            // Else there are empty lines, or quotes and line breaks that a sweep does not write.
            if start != size {
                return Err(self.other(next, "it has lines that a sweep does not write"));
            }
            size += length;
            if std::mem::take(&mut needs_header) {
                if cells != self.columns {
                    return Err(self.other(next, "it has other columns"));
                }
                continue;
            }
            if cells.len() != self.columns.len() || cells[0] != self.experiment {
                return Err(self.other(next, "it has a row of another experiment"));
            }
            if cells[1] != next.to_string() || next >= self.trials.end {
                return Err(self.other(next, &format!("it has trial {} of the same experiment", cells[1])));
            }
            each(next, cells)?;
            next += 1;
        }
        Ok(size)
    }

    /// The size in bytes of the times of trials before this one. All of the file is times, in the order of trials.
    fn examine_times(&self, next: u64) -> Result<u64, Error> {
        let name = &self.names[1];
        let unreadable = |error: io::Error| self.unreadable(1, error);
        let refuse = |why: &str| Err(would_overwrite(name, &format!("it is to have the times of rows, and {why}")));
        let Some(file) = existing(name).map_err(unreadable)? else { return Ok(0) };
        let (header, mut lines) = (csv_line(&TIMES), BufReader::new(file));
        let (mut line, mut size, mut kept, mut last) = (Vec::new(), 0, 0, None);
        while lines.read_until(b'\n', &mut line).map_err(unreadable)? > 0 {
            let is_first = size == 0;
            size += line.len() as u64;
            let Some(whole) = line.strip_suffix(b"\n") else {
                let is_begun =
                    header.starts_with(&line) && is_first || line.iter().all(|&byte| b"0123456789.,".contains(&byte));
                return if is_begun { Ok(kept) } else { refuse("ends with something else") };
            };
            if is_first && line == header {
                kept = size;
            } else {
                let found = std::str::from_utf8(whole).ok().and_then(written_time);
                let Some(trial) = found.filter(|trial| self.trials.contains(trial) && last < Some(*trial)) else {
                    return refuse("contains something else");
                };
                if is_first && self.has_header {
                    return refuse("does not begin with their columns");
                }
                last = Some(trial);
                if trial < next {
                    kept = size;
                } else if let Some(other) = self.other_rows() {
                    return refuse(&format!("has those of {other:?}"));
                }
            }
            line.clear();
        }
        Ok(kept)
    }

    /// Another file of rows whose times have the same name.
    fn other_rows(&self) -> Option<String> {
        let name = &self.names[0];
        let other = name.strip_suffix(".csv").map_or_else(|| format!("{name}.csv"), str::to_owned);
        Path::new(&other).is_file().then_some(other)
    }

    fn unreadable(&self, file: usize, error: io::Error) -> Error {
        failed("read", &self.names[file], &error)
    }

    fn other(&self, next: u64, why: &str) -> Error {
        let Self { names: [name, _], experiment, .. } = self;
        let sentence = format!(
            "{name:?} cannot be continued: {why} where trial {next} of experiment {experiment} should be; it is left as it is"
        );
        Error::new(Code::OtherExperiment, "", sentence)
    }
}

/// The trial of a line of times, if it is as a sweep writes it.
fn written_time(line: &str) -> Option<u64> {
    let cells: Vec<&str> = line.split(',').collect();
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let is_seconds = |cell: &str| {
        cell.split_once('.').is_some_and(|(whole, part)| is_number(whole) && is_number(part) && part.len() == 9)
    };
    let [trial, build, search] = cells[..] else { return None };
    (is_number(trial) && is_seconds(build) && is_seconds(search)).then(|| trial.parse().ok()).flatten()
}

/// The trial and its seconds.
fn timed(cells: &[String]) -> Option<(u64, [f64; 2])> {
    let [trial, build, search] = cells else { return None };
    Some((trial.parse().ok()?, [build.parse().ok()?, search.parse().ok()?]))
}

/// A file that is there; `None` if there is none.
fn existing(name: &str) -> io::Result<Option<File>> {
    match std::fs::metadata(name) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        // A pipe would be waited for.
        Ok(found) if !found.is_file() => Err(io::Error::new(ErrorKind::InvalidInput, "it is not a regular file")),
        found => found.and_then(|_| File::open(name)).map(Some),
    }
}

/// At most this number of bytes of a file from a position; none if there is no such file.
fn beginning(name: &str, start: u64, most: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    if let Some(mut file) = existing(name)? {
        file.seek(SeekFrom::Start(start))?;
        file.take(most as u64).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// The records of a file up to its last line break; none if there is no such file. Of lines of JSON, the cells are
/// those of the columns, up to the first that is missing.
fn records<'a>(
    name: &str,
    format: Format,
    columns: &'a [String],
) -> io::Result<Box<dyn Iterator<Item = Result<Record, String>> + 'a>> {
    let Some(mut file) = existing(name)? else { return Ok(Box::new(std::iter::empty())) };
    let size = whole_lines(&mut file)?;
    let file: Take<File> = file.take(size);
    Ok(match format {
        Format::Csv => {
            let reader = ReaderBuilder::new().has_headers(false).flexible(true).from_reader(file);
            Box::new(reader.into_records().map(|record| {
                let record = record.map_err(|error| format!("it is not a table ({error})"))?;
                let start = record.position().map_or(0, |position| position.byte());
                let cells: Vec<String> = record.iter().map(str::to_owned).collect();
                Ok(Record { start, length: csv_line(&cells).len() as u64, cells })
            }))
        }
        Format::Json => {
            let mut start = 0;
            Box::new(BufReader::new(file).split(b'\n').map(move |line| {
                let unreadable = |why: &dyn std::fmt::Display| format!("it has no line of JSON ({why})");
                let line = line.map_err(|error| unreadable(&error))?;
                let text = std::str::from_utf8(&line).map_err(|error| unreadable(&error))?;
                if !(text.starts_with('{') && text.ends_with('}')) {
                    return Err(unreadable(&"there is something around an object"));
                }
                let row = json::parse(text).map_err(|error| unreadable(&error))?;
                let cells = columns.iter().map_while(|column| row.get(column).map(cell_text)).collect();
                let record = Record { start, length: line.len() as u64 + 1, cells };
                start += record.length;
                Ok(record)
            }))
        }
    })
}

/// The size of a file up to its last line break; the file is at its beginning again.
fn whole_lines(file: &mut File) -> io::Result<u64> {
    let mut end = file.seek(SeekFrom::End(0))?;
    let mut block = Vec::new();
    while end > 0 {
        let start = end.saturating_sub(1 << 16);
        file.seek(SeekFrom::Start(start))?;
        block.clear();
        file.take(end - start).read_to_end(&mut block)?;
        if let Some(last) = block.iter().rposition(|byte| *byte == b'\n') {
            end = start + last as u64 + 1;
            break;
        }
        end = start;
    }
    file.rewind()?;
    Ok(end)
}

/// The file, to be appended to; locked as long as it is open.
fn opened(name: &str) -> Result<File, Error> {
    let open = || {
        if let Ok(found) = std::fs::metadata(name) {
            check_writable(Path::new(name), &found)?;
        }
        let file = OpenOptions::new().create(true).append(true).open(name)?;
        // File systems without locks are trusted.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(io::Error::new(ErrorKind::WouldBlock, "another sweep is writing it"));
        }
        Ok(file)
    };
    open().map_err(|error: io::Error| failed("write", name, &error))
}

/// Puts an empty file in the place of one that no sweep is writing.
fn emptied(name: &str) -> Result<(), Error> {
    let file = opened(name)?;
    let empty = || replace(&std::fs::canonicalize(name)?, Some(&file.metadata()?), &[]);
    empty().map_err(|error| failed("write", name, &error))
}

fn csv_line<T: AsRef<[u8]>>(cells: &[T]) -> Vec<u8> {
    let mut writer =
        WriterBuilder::new().terminator(Terminator::Any(b'\n')).buffer_capacity(512).from_writer(Vec::new());
    writer.write_record(cells).expect("memory can be written");
    writer.into_inner().expect("memory can be written")
}

/// Appends rows and times.
pub struct Writer {
    names: [String; 2],
    files: [File; 2],
    /// What is not written yet.
    pending: [Vec<u8>; 2],
}

impl Writer {
    /// Appends the line of a trial, and its times.
    pub fn push(&mut self, trial: u64, line: &[u8], [build, search]: [f64; 2]) {
        self.pending[0].extend_from_slice(line);
        self.pending[1].extend_from_slice(format!("{trial},{build:.9},{search:.9}\n").as_bytes());
    }

    /// Waits until all that was written is on the disk.
    pub fn sync(&mut self) -> Result<(), Error> {
        self.flush()?;
        for (file, name) in self.files.iter().zip(&self.names) {
            file.sync_all().map_err(|error| failed("write", name, &error))?;
        }
        Ok(())
    }

    /// Writes what is pending: times first, so that a killed sweep leaves no row without its times.
    pub fn flush(&mut self) -> Result<(), Error> {
        for i in [1, 0] {
            self.files[i].write_all(&self.pending[i]).map_err(|error| failed("write", &self.names[i], &error))?;
            self.pending[i].clear();
        }
        Ok(())
    }
}
