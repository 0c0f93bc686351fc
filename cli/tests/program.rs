//! The program itself, in a folder with a few scenarios.

use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::Once;

/// A disc between walls, one with a gap: a query around it, one behind the closed wall, and one whose goal is in that wall.
pub const ROOM: &str = r#"{
    "format": "planarium-scenario-1", "name": "room",
    "world": { "bounds": {"min": [0, 0], "max": [4, 2]}, "obstacles": [
        {"type": "polygon", "vertices": [[1, 0], [1.1, 0], [1.1, 1.5], [1, 1.5]]},
        {"type": "polygon", "vertices": [[3, 0], [3.1, 0], [3.1, 2], [3, 2]]} ] },
    "robot": {"type": "disc", "radius": 0.1},
    "queries": [ {"name": "around", "start": [0.5, 0.5], "goal": [2, 0.5]}, {"name": "cut-off", "start": [0.5, 0.5], "goal": [3.5, 1]},
                 {"name": "in-wall", "start": [0.5, 0.5], "goal": [3.05, 1]} ] }"#;

/// An arm of two links with limits.
const ARM: &str = r#"{ "format": "planarium-scenario-1", "name": "arm", "world": { "obstacles": [] },
    "robot": { "type": "arm", "base": [0, 0], "links": [1, 0.8], "joint_limits": [[-3, 3], [-2, 2]] }, "queries": [] }"#;

/// The exit code and the output of a finished program.
pub struct Finished {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Finished {
    #[track_caller]
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout)
            .unwrap_or_else(|error| panic!("{error}: {:?} {:?}", self.stdout, self.stderr))
    }

    /// The result of a run that ended like this, with a summary on standard error.
    #[track_caller]
    pub fn ended(&self, code: i32, status: &str) -> Value {
        let result = self.json();
        assert_eq!((self.code, &result["status"]), (code, &json!(status)), "{}", self.stderr);
        assert!(self.stderr.starts_with(&format!("{status}: ")), "{}", self.stderr);
        result
    }

    /// Checks the error on standard output, with exit code 2 and a message on standard error.
    #[track_caller]
    pub fn refuses(&self, code: &str, pointer: &str) {
        let error = &self.json()["error"];
        assert_eq!((self.code, &error["code"], &error["pointer"]), (2, &json!(code), &json!(pointer)), "{error}");
        let message = error["message"].as_str().expect("a message");
        assert!(self.stderr.starts_with("error: ") && self.stderr.contains(message), "{:?}", self.stderr);
        assert!(message.len() > 8, "{error}");
    }
}

/// A file of the folder in which the program runs.
pub fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Writes a file there; returns its name.
pub fn file(name: &str, contents: impl AsRef<[u8]>) -> &str {
    std::fs::write(path(name), contents).expect("the folder for test files can be written");
    name
}

pub fn text_of(name: &str) -> String {
    std::fs::read_to_string(path(name)).expect("it is written")
}

/// Starts the program with the words of a line, in a folder with room.json, arm.json and firs.json.
pub fn spawn(line: &str) -> Child {
    spawn_words(&line.split_whitespace().collect::<Vec<_>>())
}

fn spawn_words(words: &[&str]) -> Child {
    static WRITTEN: Once = Once::new();
    WRITTEN.call_once(|| {
        let firs = include_str!("../../www/scenes/firs.json");
        for (name, text) in [("room.json", ROOM), ("arm.json", ARM), ("firs.json", firs)] {
            file(name, text);
        }
    });
    let mut command = Command::new(env!("CARGO_BIN_EXE_planarium"));
    command.args(words).current_dir(env!("CARGO_TARGET_TMPDIR"));
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

pub fn planarium_with(line: &str, input: &str) -> Finished {
    finish(spawn(line), input)
}

/// The same with words that may contain blanks.
pub fn program(words: &[&str]) -> Finished {
    finish(spawn_words(words), "")
}

fn finish(mut child: Child, input: &str) -> Finished {
    // A program that refuses its arguments reads nothing: then the pipe is closed, and that is fine.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    let output = child.wait_with_output().expect("the program ends");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    let code = output.status.code().expect("no signal");
    Finished { code, stdout: text(output.stdout), stderr: text(output.stderr) }
}

pub fn planarium(line: &str) -> Finished {
    planarium_with(line, "")
}
