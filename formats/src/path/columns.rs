//! What the columns of a path mean, by their names or their number, and the configurations made of them.

use super::{Angles, ColumnRead, MAX_WAYPOINTS, PathFormat, PathOptions, PathRead, PathReport, Rows};
use crate::error::{Code, FormatError, quoted};
use planarium::robot::Joint;
use planarium::scenario::MapFrame;
use std::f64::consts::PI;

/// What a configuration consists of.
pub enum Robot {
    /// x and y, and theta of a robot that turns.
    Place { turns: bool },
    /// Joints, and whether each is an angle.
    Joints(Vec<bool>),
}

impl Robot {
    pub fn of(robot: &planarium::scenario::Robot) -> Self {
        match robot {
            planarium::scenario::Robot::Arm(arm) => {
                Self::Joints(arm.joint_types().iter().map(|joint| matches!(joint, Joint::Revolute { .. })).collect())
            }
            other => Self::Place { turns: other.dimension() == 3 },
        }
    }

    /// What each coordinate means, and whether it is an angle.
    pub fn coordinates(&self) -> Vec<(String, bool)> {
        match self {
            Self::Place { turns } => {
                let all = [("x", false), ("y", false), ("theta", true)];
                all[..2 + usize::from(*turns)]
                    .iter()
                    .map(|&(meaning, is_angle)| (meaning.to_owned(), is_angle))
                    .collect()
            }
            Self::Joints(joints) => {
                joints.iter().enumerate().map(|(i, &is_angle)| (format!("joint {i}"), is_angle)).collect()
            }
        }
    }

    /// The columns that it needs, in words.
    fn wanted(&self) -> String {
        match self {
            Self::Place { turns: false } => "x and y".to_owned(),
            Self::Place { turns: true } => "x, y and theta".to_owned(),
            Self::Joints(joints) => format!("joint_0 to joint_{}", joints.len() - 1),
        }
    }
}

/// What a column is by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    X,
    Y,
    Longitude,
    Latitude,
    Theta,
    QuaternionZ,
    QuaternionW,
    Joint(usize),
    Other,
}

/// The unit of a column, and by what its numbers are multiplied.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Unit {
    name: &'static str,
    factor: f64,
}

/// The units by the words for them.
const UNITS: [(&[&str], Unit); 5] = [
    (&["m", "metre", "metres", "meter", "meters"], Unit { name: "m", factor: 1.0 }),
    (&["cm"], Unit { name: "cm", factor: 0.01 }),
    (&["mm"], Unit { name: "mm", factor: 0.001 }),
    (&["rad", "rads", "radian", "radians"], Unit { name: "rad", factor: 1.0 }),
    (&["deg", "degs", "degree", "degrees", "°"], Unit { name: "deg", factor: PI / 180.0 }),
];

fn unit(word: &str) -> Option<Unit> {
    UNITS.iter().find(|(words, _)| words.contains(&word)).map(|(_, unit)| *unit)
}

/// The largest angle that is taken for radians without a word: two turns.
const MOST_TURNED: f64 = 4.0 * PI;

/// What a column is by its name, and its unit if the name has one.
fn named(name: &str) -> (Role, Option<Unit>) {
    let name = name.trim().to_lowercase();
    let bracket = name.find(['[', '(']).filter(|_| name.ends_with([']', ')']));
    let (base, own) = match bracket {
        Some(at) => (name[..at].trim(), unit(name[at + 1..name.len() - 1].trim())),
        None => match name.rsplit_once(['_', ' ']) {
            Some((base, word)) if unit(word).is_some() => (base, unit(word)),
            _ => (&*name, None),
        },
    };
    // Only the last part of a name such as pose.position.x, and of one such as pos_x.
    let ends = |words: &[&str]| {
        words.iter().any(|word| {
            base.strip_suffix(word).is_some_and(|rest| {
                rest.is_empty()
                    || ["position.", "position_", "pos_", "pos.", "pose.", "pose_"]
                        .iter()
                        .any(|end| rest.ends_with(end))
            })
        })
    };
    let turned = |word: &str| {
        let is_orientation = |rest: &str| rest.ends_with("orientation.") || rest.ends_with("orientation_");
        base == format!("q{word}") || base == format!("q_{word}") || base.strip_suffix(word).is_some_and(is_orientation)
    };
    let role = if ends(&["x"]) {
        Role::X
    } else if ends(&["y"]) {
        Role::Y
    } else if ["lon", "lng", "long", "longitude"].contains(&base) {
        Role::Longitude
    } else if ["lat", "latitude"].contains(&base) {
        Role::Latitude
    } else if ends(&["theta", "yaw", "heading", "th"]) {
        Role::Theta
    } else if turned("z") {
        Role::QuaternionZ
    } else if turned("w") {
        Role::QuaternionW
    } else {
        let number =
            ["joint_", "joint", "theta_", "theta", "q_", "q"].iter().find_map(|before| base.strip_prefix(before));
        number.and_then(|number| number.parse().ok()).map_or(Role::Other, Role::Joint)
    };
    (role, own)
}

/// A coordinate of the configuration, and the columns that it is made of.
struct Source {
    meaning: String,
    columns: Vec<usize>,
    is_angle: bool,
    unit: Option<Unit>,
}

impl Source {
    fn new(meaning: impl Into<String>, column: usize, is_angle: bool, unit: Option<Unit>) -> Self {
        Self { meaning: meaning.into(), columns: vec![column], is_angle, unit }
    }
}

/// The waypoints made of rows.
pub fn assembled(
    mut rows: Rows,
    robot: &Robot,
    frame: &MapFrame,
    options: &PathOptions,
) -> Result<PathRead, FormatError> {
    let count = rows.numbers.len().checked_div(rows.width).unwrap_or(0);
    if count == 0 {
        return Err(FormatError::new(Code::Truncated, "the file has no waypoint"));
    }
    if count > MAX_WAYPOINTS {
        let sentence = format!("there are {count} waypoints; at most {MAX_WAYPOINTS} are read");
        return Err(FormatError::new(Code::WorldTooLarge, sentence));
    }
    let (sources, in_degrees) = match &rows.names {
        Some(names) => by_names(names, robot)?,
        None => (by_number(&rows, robot)?, false),
    };
    if in_degrees && !frame.has_degrees() {
        let sentence = "the path has longitude and latitude, but the map has none";
        return Err(FormatError::new(Code::InvalidFile, sentence));
    }
    // GeoJSON has the coordinates of a map that is GeoJSON, whatever their unit is.
    let in_units = in_degrees || rows.format == PathFormat::GeoJson;
    check_finite(&rows, &sources)?;
    let factors = sources.iter().map(|source| factor(&rows, source, options)).collect::<Result<Vec<f64>, _>>()?;
    let mut waypoints = Vec::with_capacity(count);
    for row in rows.numbers.chunks_exact(rows.width) {
        let mut q: Vec<f64> = Vec::with_capacity(sources.len());
        for (source, factor) in sources.iter().zip(&factors) {
            q.push(match source.columns[..] {
                [z, w] => 2.0 * libm::atan2(row[z], row[w]),
                _ => row[source.columns[0]] * factor,
            });
        }
        if let Robot::Place { .. } = robot {
            let place = [q[0], q[1]];
            [q[0], q[1]] = if in_units { frame.from_units(place) } else { frame.from_metres(place) };
        }
        waypoints.push(q);
    }
    let columns = (0..rows.width).map(|column| read_column(&rows, &sources, column, options)).collect();
    let offset = if let Robot::Place { .. } = robot { frame.offset() } else { [0.0; 2] };
    let notes = std::mem::take(&mut rows.notes);
    let report = PathReport { format: rows.format, waypoints: count, columns, dropped: rows.dropped, offset, notes };
    Ok(PathRead { waypoints, report })
}

/// What is said of a column.
fn read_column(rows: &Rows, sources: &[Source], column: usize, options: &PathOptions) -> ColumnRead {
    let source = sources.iter().find(|source| source.columns.contains(&column));
    let name = rows.names.as_ref().map_or_else(|| (column + 1).to_string(), |names| names[column].clone());
    let unit = match source {
        Some(Source { unit: Some(unit), .. }) => unit.name,
        Some(Source { columns, .. }) if columns.len() == 2 => "",
        Some(Source { is_angle: false, .. }) => "m",
        Some(_) if options.angles == Some(Angles::Degrees) => "deg",
        Some(_) => "rad",
        None => "",
    };
    ColumnRead { name, meaning: source.map(|source| source.meaning.clone()), unit }
}

/// The columns of a robot by their names, and whether they are longitude and latitude.
fn by_names(names: &[String], robot: &Robot) -> Result<(Vec<Source>, bool), FormatError> {
    let roles: Vec<(Role, Option<Unit>)> = names.iter().map(|name| named(name)).collect();
    let listed = || names.iter().map(|name| quoted(name.as_bytes())).collect::<Vec<_>>().join(", ");
    let find = |role: Role| -> Result<Option<usize>, FormatError> {
        let mut with = (0..roles.len()).filter(|&i| roles[i].0 == role);
        match (with.next(), with.next()) {
            (Some(one), Some(other)) => {
                let [one, other] = [one, other].map(|i| quoted(names[i].as_bytes()));
                let sentence = format!("the columns {one} and {other} mean the same");
                Err(FormatError::new(Code::Contradiction, sentence))
            }
            (found, _) => Ok(found),
        }
    };
    let missing = || {
        let sentence = format!("the robot needs the columns {}, but the file has {}", robot.wanted(), listed());
        FormatError::new(Code::WrongColumns, sentence)
    };
    let fitting = |i: usize, is_angle: bool| match roles[i].1 {
        Some(unit) if is_angle != ["rad", "deg"].contains(&unit.name) => {
            let name = quoted(names[i].as_bytes());
            Err(FormatError::new(Code::InvalidFile, format!("the column {name} cannot have the unit {}", unit.name)))
        }
        unit => Ok(unit),
    };
    match robot {
        Robot::Place { turns } => {
            let (mut in_degrees, mut place) = (false, [find(Role::X)?, find(Role::Y)?]);
            if place.contains(&None) {
                (in_degrees, place) = (true, [find(Role::Longitude)?, find(Role::Latitude)?]);
            }
            let [Some(x), Some(y)] = place else { return Err(missing()) };
            let mut sources = Vec::new();
            for (meaning, column) in [("x", x), ("y", y)] {
                if in_degrees {
                    let degrees = Unit { name: "deg", factor: 1.0 };
                    sources.push(Source::new(meaning, column, false, Some(degrees)));
                } else {
                    sources.push(Source::new(meaning, column, false, fitting(column, false)?));
                }
            }
            if *turns {
                sources.push(match (find(Role::Theta)?, find(Role::QuaternionZ)?, find(Role::QuaternionW)?) {
                    (Some(theta), ..) => Source::new("theta", theta, true, fitting(theta, true)?),
                    (None, Some(z), Some(w)) => {
                        Source { meaning: "theta".to_owned(), columns: vec![z, w], is_angle: true, unit: None }
                    }
                    _ => return Err(missing()),
                });
            }
            Ok((sources, in_degrees))
        }
        Robot::Joints(joints) => {
            let number = |role: Role| match role {
                Role::Joint(number) => Some(number),
                Role::Theta if joints.len() == 1 => Some(0),
                _ => None,
            };
            let mut own: Vec<(usize, usize)> =
                (0..roles.len()).filter_map(|i| Some((number(roles[i].0)?, i))).collect();
            own.sort_unstable();
            if own.len() != joints.len() {
                return Err(missing());
            }
            if let Some(pair) = own.windows(2).find(|pair| pair[0].0 + 1 != pair[1].0) {
                let [one, other] = [pair[0].1, pair[1].1].map(|i| quoted(names[i].as_bytes()));
                let sentence = format!("the columns {one} and {other} are not numbered one after the other");
                return Err(FormatError::new(Code::Contradiction, sentence));
            }
            let source = |(i, &(_, column)): (usize, &(usize, usize))| {
                Ok(Source::new(format!("joint {i}"), column, joints[i], fitting(column, joints[i])?))
            };
            Ok((own.iter().enumerate().map(source).collect::<Result<_, FormatError>>()?, false))
        }
    }
}

/// The columns of a robot by their number.
fn by_number(rows: &Rows, robot: &Robot) -> Result<Vec<Source>, FormatError> {
    let (width, coordinates) = (rows.width, robot.coordinates());
    let firsts = rows.numbers.iter().step_by(width);
    let grows = || rows.numbers.len() > width && firsts.clone().is_sorted_by(|a, b| a < b);
    let refuse = |why: &str| {
        let sentence = format!(
            "a row has {width} numbers, but the robot needs {}{why}; a first line with names, such as \"t,x,y,theta\", says what is what",
            robot.wanted()
        );
        Err(FormatError::new(Code::WrongColumns, sentence))
    };
    let is_still_place = matches!(robot, Robot::Place { turns: false });
    let skipped = match width {
        _ if width == coordinates.len() => 0,
        3 if is_still_place && grows() && rows.numbers[0] == 0.0 => {
            return refuse(", and the first could be a time");
        }
        // x, y and theta.
        3 if is_still_place => 0,
        _ if width == coordinates.len() + 1 && grows() => 1,
        _ if width == coordinates.len() + 1 => return refuse(", and the first are no times: they do not grow"),
        _ => return refuse(""),
    };
    let all = coordinates.into_iter().zip(skipped..);
    Ok(all.map(|((meaning, is_angle), column)| Source::new(meaning, column, is_angle, None)).collect())
}

/// By what the numbers of a source are multiplied.
fn factor(rows: &Rows, source: &Source, options: &PathOptions) -> Result<f64, FormatError> {
    match (source.unit, options.angles) {
        (Some(unit), _) => Ok(unit.factor),
        (None, Some(Angles::Degrees)) if source.is_angle => Ok(PI / 180.0),
        (None, None) if source.is_angle && source.columns.len() == 1 => {
            let angles = || rows.numbers.iter().skip(source.columns[0]).step_by(rows.width);
            let most = angles().fold(0.0, |most: f64, angle| most.max(angle.abs()));
            if most > MOST_TURNED && most <= 360.0 {
                let row = angles().position(|angle| angle.abs() > MOST_TURNED).unwrap_or_default();
                let sentence = format!(
                    "the {} {} looks like degrees, and nothing says what it is: choose degrees or radians by an option, or name the column \
                     theta_deg or theta_rad",
                    source.meaning,
                    rows.numbers[row * rows.width + source.columns[0]]
                );
                return Err(FormatError::new(Code::InvalidOption, sentence).at(rows.places.of(row)));
            }
            Ok(1.0)
        }
        _ => Ok(1.0),
    }
}

/// Refuses numbers that are not finite in the columns that are used, and quaternions that are none.
fn check_finite(rows: &Rows, sources: &[Source]) -> Result<(), FormatError> {
    for (i, row) in rows.numbers.chunks_exact(rows.width).enumerate() {
        for source in sources {
            let at = |sentence: String| FormatError::new(Code::InvalidNumber, sentence).at(rows.places.of(i));
            if let Some(column) = source.columns.iter().find(|&&column| !row[column].is_finite()) {
                return Err(at(format!("{} is {}, which is not finite", source.meaning, row[*column])));
            }
            if let [z, w] = source.columns[..]
                && !(0.5..1.5).contains(&(row[z] * row[z] + row[w] * row[w]))
            {
                return Err(at(format!("z = {} and w = {} are no quaternion of a turn in the plane", row[z], row[w])));
            }
        }
    }
    Ok(())
}
