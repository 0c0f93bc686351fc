//! The columns of a path: their names, units and numbers.

use super::{PathRows, RowTiming};
use crate::path::RobotColumns;
use planarium::scenario::Scenario;

/// A column.
pub struct Column {
    /// Its name, without the unit: `t`, `x`, `theta`, `joint_0`, `vx`.
    pub name: String,
    pub unit: &'static str,
    pub numbers: Vec<f64>,
}

/// The columns of a path: the time if there is one, the configuration, the velocities if there are some, and longitude and
/// latitude if the map has these. Places are those of the map, in metres.
pub struct Table {
    pub columns: Vec<Column>,
    /// How many of the first columns are the time and the configuration.
    read: usize,
}

impl Table {
    /// The columns of rows that were checked.
    pub fn of(scenario: &Scenario, rows: &PathRows) -> Self {
        let PathRows { configurations, timing, .. } = rows;
        let frame = scenario.frame();
        let robot = match RobotColumns::of(scenario.robot()) {
            // The rows of a disc may have its heading.
            RobotColumns::Place { .. } => RobotColumns::Place { turns: configurations[0].len() == 3 },
            joints => joints,
        };
        let is_place = matches!(robot, RobotColumns::Place { .. });
        let mut columns = Vec::new();
        if let Some(RowTiming { times, .. }) = timing {
            columns.push(Column { name: "t".to_owned(), unit: "s", numbers: times.clone() });
        }
        let coordinates = robot.coordinates();
        for (k, (meaning, is_angle)) in coordinates.iter().enumerate() {
            let number = |q: &Vec<f64>| if is_place && k < 2 { frame.to_metres([q[0], q[1]])[k] } else { q[k] };
            columns.push(Column {
                name: meaning.replace(' ', "_"),
                unit: if *is_angle { "rad" } else { "m" },
                numbers: configurations.iter().map(number).collect(),
            });
        }
        let read = columns.len();
        if let Some(RowTiming { velocities, .. }) = timing {
            for (k, (meaning, is_angle)) in coordinates.iter().enumerate() {
                columns.push(Column {
                    name: match &**meaning {
                        "x" => "vx".to_owned(),
                        "y" => "vy".to_owned(),
                        "theta" => "omega".to_owned(),
                        joint => format!("{}_speed", joint.replace(' ', "_")),
                    },
                    unit: if *is_angle { "rad/s" } else { "m/s" },
                    numbers: velocities.iter().map(|velocity| velocity[k]).collect(),
                });
            }
        }
        if is_place && frame.has_degrees() {
            for (k, name) in ["lon", "lat"].into_iter().enumerate() {
                let number = |q: &Vec<f64>| frame.to_units([q[0], q[1]])[k];
                let numbers = configurations.iter().map(number).collect();
                columns.push(Column { name: name.to_owned(), unit: "deg", numbers });
            }
        }
        Self { columns, read }
    }

    /// The time and the configuration row by row, and how many numbers a row has.
    pub fn numbers(&self) -> (usize, Vec<f64>) {
        let columns = &self.columns[..self.read];
        let rows = columns.first().map_or(0, |column| column.numbers.len());
        (self.read, (0..rows).flat_map(|i| columns.iter().map(move |column| column.numbers[i])).collect())
    }
}
