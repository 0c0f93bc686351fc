//! Inspection of a scenario outside any run: contacts of a configuration, the robot's position, the picture of its
//! configuration space. For viewers; planners use [`Validity`].

mod clearance;

use clearance::Boundary;
pub use clearance::Clearance;

use crate::error::{Code, Error, Number, within};
use crate::geometry::{Aabb, Point};
use crate::planner::DEFAULT_TOLERANCE;
use crate::problem::{Contact, Validity};
use crate::random::{MAX_SEED, Random, Stream};
use crate::robot::Part;
use crate::scenario::{Obstacle, Robot};
use crate::space::{MAX_DIMENSION, MotionSpace, ProductSpace, Space};
use crate::world::{Configurations, PlanningWorld};

/// The most cells per side of a picture of the configuration space.
pub const MAX_CELLS: usize = 4096;

/// The most configurations that are drawn at once.
pub const MAX_SAMPLES: u64 = 1_000_000;

/// The number of draws in a row in collision after which the search for a free configuration ends.
const PATIENCE: u32 = 100_000;

/// Inspects one scenario. Every configuration must have the robot's number of finite entries up to 1e6 in size,
/// else the error is `wrong-dimension`, `not-finite` or `out-of-range` with the entry's pointer; the ends of a motion must lie
/// within the joint limits as well. Motions are checked with the default tolerance, which a run may refine.
pub struct Inspector {
    world: PlanningWorld,
    configurations: Configurations,
    validity: Box<dyn Validity<[f64; MAX_DIMENSION]>>,
    obstacles: Vec<Boundary>,
}

impl Inspector {
    /// An inspector of the scenario, with the default metric and tolerance.
    pub fn new(scenario: impl Into<PlanningWorld>) -> Self {
        let world = scenario.into();
        let configurations = Configurations::of(&world);
        let validity = world.checker(&MotionSpace::new(configurations.space().clone()), DEFAULT_TOLERANCE).validity();
        let obstacles = world.scenario().world().obstacles.iter().map(Boundary::of_obstacle).collect();
        Self { world, configurations, validity, obstacles }
    }

    fn space(&self) -> &ProductSpace<MAX_DIMENSION> {
        self.configurations.space()
    }

    /// How many numbers a configuration has.
    pub fn dimension(&self) -> usize {
        self.space().dimension()
    }

    /// The box to draw: the bounds, or else all obstacles and the arm's reach.
    pub fn extent(&self) -> Aabb {
        let world = self.world.scenario().world();
        let Robot::Arm(arm) = self.world.robot() else { return *self.world.bounds() };
        let reachable = Aabb::of(arm.base(), arm.base()).grown(arm.reach() + arm.radius());
        let everything = || world.obstacles.iter().map(Obstacle::aabb).fold(reachable, |all, one| all.union(&one));
        world.bounds.unwrap_or_else(everything)
    }

    /// For every coordinate, whether it wraps.
    pub fn circles(&self) -> Vec<bool> {
        (0..self.dimension()).map(|i| self.space().is_circle(i)).collect()
    }

    /// Every part of the robot that touches something at `q`, and what; empty if `q` is free.
    ///
    /// # Errors
    /// Of the configuration: see [`Inspector`].
    pub fn check(&self, q: &[f64]) -> Result<Vec<Contact>, Error> {
        self.configurations.refuse(q, "/q")?;
        Ok(self.validity.contacts(&self.space().state(q)))
    }

    /// The parts of the robot at `q`.
    ///
    /// # Errors
    /// Of the configuration: see [`Inspector`].
    pub fn footprint(&self, q: &[f64]) -> Result<Vec<Part>, Error> {
        self.configurations.refuse(q, "/q")?;
        Ok(self.world.robot().footprint(q))
    }

    /// The tip of the arm, the centre of the disc, or the origin of the body's frame, at `q`.
    ///
    /// # Errors
    /// Of the configuration: see [`Inspector`].
    pub fn end_effector(&self, q: &[f64]) -> Result<Point, Error> {
        self.configurations.refuse(q, "/q")?;
        Ok(match self.world.robot() {
            Robot::Arm(arm) => arm.end_effector(q),
            Robot::Disc(_) | Robot::RigidBody(_) | Robot::Car(_) => Point::new(q[0], q[1]),
        })
    }

    /// The configuration a fraction `t` in [0, 1] along the motion from `a` to `b`.
    ///
    /// # Errors
    /// Of the configurations (pointers `/a` and `/b`), and `out-of-range` for another `t`.
    pub fn interpolate(&self, a: &[f64], b: &[f64], t: f64) -> Result<Vec<f64>, Error> {
        self.refuse_part(a, b, t)?;
        let space = self.space();
        Ok(space.coordinates(&space.interpolate(&space.state(a), &space.state(b), t)).to_vec())
    }

    /// A faulty interpolation of a course report, for comparison: each angle turns as far as on the short way, but in the
    /// direction of the plain difference of the numbers given. Where they differ by more than half a turn, that is the wrong one,
    /// and the motion ends elsewhere than in `b`.
    ///
    /// # Errors
    /// As of [`Inspector::interpolate`].
    pub fn interpolate_by_sign(&self, a: &[f64], b: &[f64], t: f64) -> Result<Vec<f64>, Error> {
        self.refuse_part(a, b, t)?;
        let space = self.space();
        let turn = space.difference(&space.state(a), &space.state(b));
        let moved: Vec<f64> = (0..a.len()).map(|i| a[i] + t * turn[i].abs().copysign(b[i] - a[i])).collect();
        Ok(space.coordinates(&space.state(&moved)).to_vec())
    }

    /// The distance from `a` to `b` in the default metric: radians summed over joints, or metres.
    ///
    /// # Errors
    /// Of the configurations (pointers `/a` and `/b`).
    pub fn distance(&self, a: &[f64], b: &[f64]) -> Result<f64, Error> {
        self.refuse_motion(a, b)?;
        Ok(self.space().distance(&self.space().state(a), &self.space().state(b)))
    }

    /// The fraction at which the motion from `a` to `b` first cannot be proven free; `None` if all of it is proven.
    ///
    /// # Errors
    /// Of the configurations (pointers `/a` and `/b`).
    pub fn first_hit(&self, a: &[f64], b: &[f64]) -> Result<Option<f64>, Error> {
        self.refuse_motion(a, b)?;
        Ok(self.validity.first_hit(&self.space().state(a), &self.space().state(b)))
    }

    /// The angles that the picture of the configuration space shows: low and high of each of the two joints.
    ///
    /// # Errors
    /// `unsupported` for anything but an arm of two links.
    pub fn configuration_space_range(&self) -> Result<[[f64; 2]; 2], Error> {
        match self.world.robot() {
            Robot::Arm(_) if self.dimension() == 2 => Ok([self.space().range(0), self.space().range(1)]),
            _ => Err(Error::new(Code::Unsupported, "", "only an arm of two links has a square of configurations")),
        }
    }

    /// The configuration space of an arm of two links as a picture: one byte per cell, 1 for collision, checked at the
    /// centre of the cell; row by row from the lowest angle of the second joint, each row from the lowest of the first.
    ///
    /// # Errors
    /// `unsupported` for another robot; `out-of-range` for fewer than 1 or more than [`MAX_CELLS`] cells per side.
    pub fn configuration_space(&self, width: usize, height: usize) -> Result<Vec<u8>, Error> {
        let range = self.configuration_space_range()?;
        for (pointer, cells) in [("/width", width), ("/height", height)] {
            if cells == 0 || cells > MAX_CELLS {
                let sentence = format!("a picture has 1 to {MAX_CELLS} cells per side, not {cells}");
                return Err(Error::new(Code::OutOfRange, pointer, sentence));
            }
        }
        let center = |joint: usize, cell: usize, cells: usize| {
            let [low, high] = range[joint];
            low + (high - low) * ((cell as f64 + 0.5) / cells as f64)
        };
        let mut cells = Vec::with_capacity(width * height);
        for row in 0..height {
            for column in 0..width {
                let q = [center(0, column, width), center(1, row, height)];
                cells.push(u8::from(!self.validity.is_free(&self.space().state(&q))));
            }
        }
        Ok(cells)
    }

    /// Rows of `n` configurations drawn uniformly from the space of the robot, all of them or only those that are free: the
    /// same that a planner of this seed draws with its uniform sampler. O(n) draws and, if they must be free, as many
    /// checks as it takes.
    ///
    /// # Errors
    /// `out-of-range` for more than [`MAX_SAMPLES`] or another seed than 0 to 2^53 - 1; `unsupported` if 100,000 draws in a
    /// row are in collision.
    pub fn samples(&self, n: u64, seed: u64, is_free: bool) -> Result<Vec<f64>, Error> {
        for (pointer, given, most) in [("/n", n, MAX_SAMPLES), ("/seed", seed, MAX_SEED)] {
            if given > most {
                let [given, most] = [given, most].map(|count| Number(count as f64));
                let sentence = format!("{} must lie within [0, {most}], not {given}", &pointer[1..]);
                return Err(Error::new(Code::OutOfRange, pointer, sentence));
            }
        }
        let mut random = Random::new(seed, Stream::Samples);
        let mut rows = Vec::with_capacity(n as usize * self.dimension());
        let mut refused = 0;
        while rows.len() < n as usize * self.dimension() {
            let state = self.space().sample(&mut random);
            if !is_free || self.validity.is_free(&state) {
                rows.extend_from_slice(self.space().coordinates(&state));
                refused = 0;
                continue;
            }
            refused += 1;
            if refused == PATIENCE {
                let sentence = format!("of {PATIENCE} configurations drawn in a row, none is free");
                return Err(Error::new(Code::Unsupported, "/free", sentence));
            }
        }
        Ok(rows)
    }

    /// Refuses ends that are no configurations or lie outside the joint limits.
    fn refuse_motion(&self, a: &[f64], b: &[f64]) -> Result<(), Error> {
        self.configurations.refuse_outside(a, "/a")?;
        self.configurations.refuse_outside(b, "/b")
    }

    /// The same, or if `t` is no fraction of it.
    fn refuse_part(&self, a: &[f64], b: &[f64], t: f64) -> Result<(), Error> {
        self.refuse_motion(a, b)?;
        within("/t", "t", t, 0.0..=1.0).map(drop)
    }
}
