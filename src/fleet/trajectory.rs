//! A trajectory: where one robot is at every time from 0 on, as rows of a time and a pose.

use super::motion::{Motion, Pose, difference};
use crate::geometry::{Aabb, Point, wrap};

/// A row for every time at which the motion changes; between two rows the robot moves at constant rates, the short way round, or
/// stands. It stands at the last pose forever.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    times: Vec<f64>,
    poses: Vec<Pose>,
    /// The box of all positions.
    around: Aabb,
}

/// How far a robot moves between a time and the next larger double, in metres.
pub(super) fn moved_until_next(time: f64, speed: f64) -> f64 {
    (time.next_up() - time) * speed
}

impl Trajectory {
    /// The robot stands at a pose from time 0 on.
    pub(super) fn standing(at: Pose) -> Self {
        Self { times: vec![0.0], poses: vec![at], around: box_of(at) }
    }

    /// A row more, at a time no earlier than the last.
    pub(super) fn add(&mut self, time: f64, pose: Pose) {
        self.times.push(time);
        self.poses.push(pose);
        self.around = self.around.union(&box_of(pose));
    }

    /// The box of all positions, in metres.
    pub(super) fn around(&self) -> &Aabb {
        &self.around
    }

    /// The times of the rows, in seconds: the first is 0, none is earlier than the one before.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The poses of the rows: x, y, theta; theta of a disc is 0.
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// When the robot arrives at its last pose, in seconds.
    pub fn arrival(&self) -> f64 {
        let last = self.poses[self.poses.len() - 1];
        let standing = self.poses.iter().rev().take_while(|pose| **pose == last).count();
        self.times[self.times.len() - standing]
    }

    /// How long the robot stands before its arrival, in seconds.
    pub fn waits(&self) -> f64 {
        let arrival = self.arrival();
        let rows = self.times.windows(2).zip(self.poses.windows(2));
        rows.filter(|(times, poses)| times[1] <= arrival && poses[0] == poses[1]).map(|(t, _)| t[1] - t[0]).sum::<f64>()
            + 0.0
    }

    /// The pose at a time, at least 0.
    pub fn at(&self, time: f64) -> Pose {
        let [x, y, theta] = self.motion_at(time).at(time);
        [x, y, wrap(theta)]
    }

    /// The row whose motion a time belongs to: the last that is not later.
    fn row(&self, time: f64) -> usize {
        self.times.partition_point(|row| *row <= time).max(1) - 1
    }

    /// The motion from a row on; that of the last one has no end.
    pub(super) fn motion(&self, row: usize) -> Motion {
        match self.times.get(row + 1) {
            Some(&end) => Motion::new([self.times[row], end], self.poses[row], self.poses[row + 1]),
            None => Motion::standing([self.times[row], f64::INFINITY], self.poses[row]),
        }
    }

    /// The motion at a time, at least 0.
    pub(super) fn motion_at(&self, time: f64) -> Motion {
        self.motion(self.row(time))
    }

    /// All motions, in order.
    pub(super) fn motions(&self) -> impl Iterator<Item = Motion> + '_ {
        (0..self.times.len()).map(|row| self.motion(row))
    }

    /// The motions at some time of an interval, in order.
    pub(super) fn during(&self, begin: f64, end: f64) -> impl Iterator<Item = Motion> + '_ {
        // A motion that ends as the interval begins counts.
        let first = self.times.partition_point(|row| *row < begin).max(1) - 1;
        (first..self.times.len()).take_while(move |&row| self.times[row] <= end).map(|row| self.motion(row))
    }

    /// The trajectory of these rows.
    ///
    /// # Errors
    /// A sentence, and the index of the row: if there is none, the first time is not 0, a time is earlier than the one before, or
    /// the robot turns by half a turn, so that the short way round is ambiguous.
    pub(super) fn of_rows(times: &[f64], poses: Vec<Pose>) -> Result<Self, (String, usize)> {
        if times.len() != poses.len() || times.is_empty() {
            return Err((format!("there are {} times and {} configurations", times.len(), poses.len()), 0));
        }
        if times[0] != 0.0 {
            return Err((format!("the first time is {}, not 0", times[0]), 0));
        }
        if let Some(i) = (1..times.len()).find(|&i| times[i] < times[i - 1]) {
            return Err((format!("the time {} is earlier than the one before", times[i]), i));
        }
        let is_ambiguous = |i: &usize| difference(poses[i - 1], poses[*i])[2].abs() >= std::f64::consts::PI - 1e-9;
        if let Some(i) = (1..times.len()).find(is_ambiguous) {
            return Err(("the robot turns by half a turn: the short way round is ambiguous".to_owned(), i));
        }
        if let Some(i) = (1..times.len()).find(|&i| times[i] == times[i - 1] && poses[i] != poses[i - 1]) {
            return Err(("the robot is at two places at the same time".to_owned(), i));
        }
        let around = poses.iter().map(|pose| box_of(*pose)).reduce(|a, b| a.union(&b)).expect("there is a row");
        Ok(Self { times: times.to_vec(), poses, around })
    }
}

/// The box of one position.
fn box_of([x, y, _]: Pose) -> Aabb {
    Aabb::of(Point::new(x, y), Point::new(x, y))
}
