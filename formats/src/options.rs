//! What a file does not say: the robot, a query, and how doubtful cells are read.

/// How files are read. The default leaves everything to the files.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// The robot; by default that of the format, or a point.
    pub robot: RobotChoice,
    /// The start of a further query, the first of the scenario: x and y, and for robots that turn theta (0 if it is
    /// absent), in metres and radians, in the coordinates of the file. Together with `goal`.
    pub start: Option<Vec<f64>>,
    /// The goal of that query.
    pub goal: Option<Vec<f64>>,
    /// What unknown cells are.
    pub unknown: Unknown,
    /// Of pictures without metadata, the brightness from 0 to 1 from which a cell is free (0.5 by default); of grids of
    /// numbers, the number from which a cell is occupied (by default they may contain 0 and 1 only, and -1 for
    /// unknown).
    pub threshold: Option<f64>,
    /// Metres per cell, for grids and pictures that do not say it; 1 by default.
    pub scale: Option<f64>,
    /// Islands of fewer occupied cells than this are dropped. Cells that touch at a side or a corner are one island.
    pub min_island: usize,
    /// How far in metres obstacles of grids may grow so that there are fewer of them: blocks of cells become occupied
    /// if any of theirs is. 0, the default, keeps every cell.
    pub simplify: f64,
}

/// What unknown cells are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unknown {
    /// Obstacles.
    #[default]
    Occupied,
    /// Free.
    Free,
}

/// The robot of the scenario. Lengths in metres, angles in radians.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub enum RobotChoice {
    /// The robot that the format defines, such as the car of parking cases; else a point.
    #[default]
    Format,
    /// A disc; a point if the radius is 0.
    Disc {
        /// The radius.
        radius: f64,
    },
    /// A polygon that moves and turns about the origin.
    Footprint {
        /// Its corners in order.
        corners: Vec<[f64; 2]>,
    },
    /// A rectangular car; its place is the middle of the rear axle.
    Car {
        /// From bumper to bumper.
        length: f64,
        /// From side to side.
        width: f64,
        /// Between the axles, which are as far from the bumpers as each other.
        wheelbase: f64,
        /// The largest steering angle to either side.
        steering: f64,
    },
}

impl RobotChoice {
    /// A rectangle about the origin: its extent along the heading, and across.
    pub fn rectangle(length: f64, width: f64) -> Self {
        let [x, y] = [length / 2.0, width / 2.0];
        Self::Footprint { corners: vec![[-x, -y], [x, -y], [x, y], [-x, y]] }
    }
}
