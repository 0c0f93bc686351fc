//! A path as poses of ROS in YAML. Headings of robots that do not turn are those of the way to the next row.

use super::{PathRows, decimal};
use crate::error::{Code, FormatError, Place};
use planarium::geometry::wrap;
use planarium::scenario::Scenario;

/// The most seconds that the stamp of ROS holds, as a 32-bit number.
const MOST_SECONDS: f64 = 2_147_483_647.0;

/// A pose in the coordinates of the map.
struct Pose {
    place: [f64; 2],
    /// In radians.
    heading: f64,
    /// The time in seconds.
    time: Option<f64>,
}

impl Pose {
    /// The lines `position` and `orientation`, indented by this many blanks.
    fn lines(&self, blanks: usize) -> String {
        let ([x, y], (z, w)) = (self.place.map(decimal), libm::sincos(0.5 * wrap(self.heading)));
        let [z, w] = [z, w].map(decimal);
        let indent = " ".repeat(blanks);
        format!(
            "{indent}position: {{x: {x}, y: {y}, z: 0.0}}\n{indent}orientation: {{x: 0.0, y: 0.0, z: {z}, w: {w}}}\n"
        )
    }

    /// The time as ROS has it: whole seconds, and billionths of one; nothing without a time.
    ///
    /// # Errors
    /// `invalid-number` for a time before 0 or after the last that a stamp holds
    fn stamp(&self) -> Result<String, FormatError> {
        let Some(time) = self.time else { return Ok(String::new()) };
        if !(0.0..MOST_SECONDS).contains(&time) {
            let sentence = format!("the time is {time} s; a stamp of ROS holds from 0 to {MOST_SECONDS} s");
            return Err(FormatError::new(Code::InvalidNumber, sentence));
        }
        let (whole, part) = (time.floor(), ((time - time.floor()) * 1e9).round());
        let [seconds, billionths] = if part >= 1e9 { [whole + 1.0, 0.0] } else { [whole, part] };
        Ok(format!("    stamp: {{sec: {seconds}, nanosec: {billionths}}}\n"))
    }
}

fn poses(scenario: &Scenario, rows: &PathRows) -> Vec<Pose> {
    let PathRows { configurations, timing, .. } = rows;
    let ways = ways(configurations);
    let pose = |(i, q): (usize, &Vec<f64>)| Pose {
        place: scenario.frame().to_metres([q[0], q[1]]),
        heading: q.get(2).copied().unwrap_or(ways[i]),
        time: timing.as_ref().map(|timing| timing.times[i]),
    };
    configurations.iter().enumerate().map(pose).collect()
}

/// The direction from each place to the next other one; where there is none, that before, or 0.
fn ways(places: &[Vec<f64>]) -> Vec<f64> {
    let mut ways = vec![0.0; places.len()];
    let mut after = None;
    for (i, pair) in places.windows(2).enumerate().rev() {
        let [x, y] = [0, 1].map(|k| pair[1][k] - pair[0][k]);
        if x != 0.0 || y != 0.0 {
            let way = libm::atan2(y, x);
            if after.is_none() {
                ways[i + 1..].fill(way);
            }
            after = Some(way);
        }
        ways[i] = after.unwrap_or(0.0);
    }
    ways
}

/// A string of YAML, in quotes. Those of JSON are strings of YAML as well.
fn string(text: &str) -> String {
    let json = planarium::json::to_string(text);
    // JSON leaves these as they are; readers of YAML take them for ends of lines, or refuse them.
    let is_refused = |c: char| matches!(c, '\u{7f}'..='\u{9f}' | '\u{2028}' | '\u{2029}');
    json.chars().fold(String::new(), |text, c| {
        if is_refused(c) { text + &format!("\\u{:04x}", c as u32) } else { text + c.encode_utf8(&mut [0; 4]) }
    })
}

/// `nav_msgs/Path`; stamps are times since the start.
///
/// # Errors
/// `invalid-number` with the row
pub fn path(scenario: &Scenario, rows: &PathRows, frame_id: &str) -> Result<String, FormatError> {
    let id = string(frame_id);
    let mut text = format!("# A path of Planarium: nav_msgs/Path\nheader:\n  frame_id: {id}\nposes:\n");
    for (i, pose) in poses(scenario, rows).iter().enumerate() {
        let stamp = pose.stamp().map_err(|error| error.at(Place::Element(format!("row {i}"))))?;
        text += &format!("- header:\n{stamp}    frame_id: {id}\n  pose:\n{}", pose.lines(4));
    }
    Ok(text)
}

/// A list of poses, each with its frame.
pub fn waypoints(scenario: &Scenario, rows: &PathRows, frame_id: &str) -> String {
    let id = string(frame_id);
    let mut text = "# A path of Planarium: waypoints\n".to_owned();
    for pose in poses(scenario, rows) {
        text += &format!("- frame_id: {id}\n{}", pose.lines(2));
    }
    text
}
