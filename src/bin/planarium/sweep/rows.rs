//! The files of a sweep: rows of trials as CSV or as lines of JSON, and beside them their times.
//!
//! Rows come in the order of trials. Each begins with the fingerprint of its experiment and the number of its trial, so a file tells
//! what it belongs to; only the first shard begins with the names of columns. So the files of all shards, one after another, are the
//! file of one run. Times differ between runs and have a file of their own.

use crate::arguments::Shard;
use crate::files::failed;
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

/// The cells of a line, and where it begins in its file.
type Record = Result<(u64, Vec<String>), Error>;

impl Rows {
    /// The rows of a shard in the file of this name; the times of `runs.csv` are in `runs.times.csv`.
    pub fn new(experiment: &Experiment, name: &str, format: Format, shard: Shard) -> Self {
        let trials = shard.trials(experiment.trial_count());
        let times = format!("{}.times.csv", name.strip_suffix(".csv").unwrap_or(name));
        let (hex, columns) = (format!("{:016x}", experiment.fingerprint()), experiment.columns());
        Self { names: [name.to_owned(), times], format, experiment: hex, columns, trials, has_header: shard.is_first() }
    }

    /// Opens the files to be continued after their last complete row; returns the number of the trial that comes next.
    ///
    /// # Errors
    /// `other-experiment` if a row is not the experiment's next one: then nothing is changed. `file`.
    pub fn resume(&self) -> Result<(u64, Writer), Error> {
        let mut next = self.trials.start;
        let size = self.each(|trial, _| {
            next = trial + 1;
            Ok(())
        })?;
        let times_size = self.times_before(next)?;
        let [rows, times] = &self.names;
        let mut writer = Writer {
            names: self.names.clone(),
            files: [appended(rows, size)?, appended(times, times_size)?],
            pending: Default::default(),
        };
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
        let mut times =
            records(&self.names[1], Format::Csv, &[])?.0.filter_map(|record| timed(&record.ok()?.1)).peekable();
        self.each(|trial, cells| {
            while times.next_if(|(other, _)| *other < trial).is_some() {}
            let seconds = times.next_if(|(other, _)| *other == trial).map_or([f64::NAN; 2], |(_, seconds)| seconds);
            each(Row { trial, cells, seconds })
        })?;
        Ok(())
    }

    /// Calls with the number and the cells of each complete row; returns the size of all of them in bytes.
    fn each(&self, mut each: impl FnMut(u64, Vec<String>) -> Result<(), Error>) -> Result<u64, Error> {
        let (records, size) = records(&self.names[0], self.format, &self.columns)?;
        let (mut records, mut next) = (records.peekable(), self.trials.start);
        let mut needs_header = self.format == Format::Csv && self.has_header;
        while let Some(record) = records.next() {
            let (start, cells) = record?;
            // A row can be cut within a quoted line break.
            let is_cut = self.format == Format::Csv && cells.len() < self.columns.len() && records.peek().is_none();
            if is_cut && start > 0 {
                return Ok(start);
            }
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

    /// The size in bytes of the times of trials before this one.
    fn times_before(&self, next: u64) -> Result<u64, Error> {
        let (records, size) = records(&self.names[1], Format::Csv, &[])?;
        for record in records {
            let (start, cells) = record?;
            if cells != TIMES && timed(&cells).is_none_or(|(trial, _)| trial >= next) {
                return Ok(start);
            }
        }
        Ok(size)
    }

    fn other(&self, next: u64, why: &str) -> Error {
        let Self { names: [name, _], experiment, .. } = self;
        let sentence = format!(
            "{name:?} cannot be continued: {why} where trial {next} of experiment {experiment} should be; it is left as it is"
        );
        Error::new(Code::OtherExperiment, "", sentence)
    }
}

/// The trial and its seconds.
fn timed(cells: &[String]) -> Option<(u64, [f64; 2])> {
    let [trial, build, search] = cells else { return None };
    Some((trial.parse().ok()?, [build.parse().ok()?, search.parse().ok()?]))
}

/// The records of a file up to its last line break, and their size in bytes; none if there is no such file. Of lines of JSON, the
/// cells are those of the columns, up to the first that is missing.
fn records<'a>(
    name: &'a str,
    format: Format,
    columns: &'a [String],
) -> Result<(Box<dyn Iterator<Item = Record> + 'a>, u64), Error> {
    let unreadable = move |error: io::Error| failed("read", name, &error);
    let mut file = match File::open(name) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok((Box::new(std::iter::empty()), 0)),
        file => file.map_err(unreadable)?,
    };
    let size = whole_lines(&mut file).map_err(unreadable)?;
    let file: Take<File> = file.take(size);
    let records: Box<dyn Iterator<Item = Record>> = match format {
        Format::Csv => {
            let reader = ReaderBuilder::new().has_headers(false).flexible(true).from_reader(file);
            Box::new(reader.into_records().map(move |record| {
                let record = record.map_err(|error| failed("read", name, &error))?;
                let start = record.position().map_or(0, |position| position.byte());
                Ok((start, record.iter().map(str::to_owned).collect()))
            }))
        }
        Format::Json => {
            let mut start = 0;
            Box::new(BufReader::new(file).lines().map(move |line| {
                let line = line.map_err(unreadable)?;
                let row = json::parse(&line)?;
                let cells = columns.iter().map_while(|column| row.get(column).map(cell_text)).collect();
                start += line.len() as u64 + 1;
                Ok((start - line.len() as u64 - 1, cells))
            }))
        }
    };
    Ok((records, size))
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

/// The file, cut to a size, to be appended to; locked as long as it is open.
fn appended(name: &str, size: u64) -> Result<File, Error> {
    let open = || {
        let file = OpenOptions::new().create(true).append(true).open(name)?;
        // File systems without locks are trusted.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(io::Error::new(ErrorKind::WouldBlock, "another sweep is writing it"));
        }
        file.set_len(size)?;
        Ok(file)
    };
    open().map_err(|error: io::Error| failed("write", name, &error))
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

    /// Writes what is pending: times first, so that a killed sweep leaves no row without its times.
    pub fn flush(&mut self) -> Result<(), Error> {
        for i in [1, 0] {
            self.files[i].write_all(&self.pending[i]).map_err(|error| failed("write", &self.names[i], &error))?;
            self.pending[i].clear();
        }
        Ok(())
    }
}
