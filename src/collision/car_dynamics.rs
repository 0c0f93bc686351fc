//! The dynamics of a car among obstacles: along exact arcs that are proven free; or by Euler's steps, of which only the
//! ends are tested.

use super::body_validity::placement;
use super::{BodyCollision, BodyMotion, LONGEST_DRIVE};
use crate::geometry::{arc_pose, euler_pose};
use crate::problem::{Control, Dynamics, Motion};
use crate::random::Random;
use crate::robot::Car;
use crate::space::steering::Turn;
use crate::space::{MotionSpace, Space};
use serde::Deserialize;
use std::sync::Arc;

/// The integration of the motion of a car.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Integration {
    /// Exact: constant controls give arcs of circles. Steps are proven free.
    #[default]
    Exact,
    /// By Euler's explicit method, a step of integration at a time, as in the course reports. Headings are exact; the
    /// places of a constant control lie on another circle, larger by the factor (a / 2) / sin(a / 2) and turned back by a / 2
    /// about the start, where a is the turn of a step. The motion between two steps is not tested, so nothing is proven.
    Euler,
}

/// The dynamics of a car in a space of placements (x, y, theta).
pub struct CarDynamics<const N: usize> {
    car: Car,
    space: MotionSpace<N>,
    collision: Arc<BodyCollision>,
    integration: Integration,
}

impl<const N: usize> CarDynamics<N> {
    /// The car in that space; `collision` is that of its shape.
    pub fn new(car: &Car, space: MotionSpace<N>, collision: Arc<BodyCollision>, integration: Integration) -> Self {
        Self { car: car.clone(), space, collision, integration }
    }

    fn turn_rate(&self, control: Control) -> f64 {
        self.car.turn_rate(control.speed, control.steering)
    }

    /// The placements after each step of Euler's method, angles not wrapped. Endless.
    fn euler(&self, from: &[f64; N], control: Control) -> impl Iterator<Item = [f64; 3]> + use<N> {
        let (speed, turn_rate, step) = (control.speed, self.turn_rate(control), self.car.integration_step());
        let next = move |pose: &[f64; 3]| Some(euler_pose(*pose, speed, turn_rate, step));
        std::iter::successors(Some(placement(from)), next).skip(1)
    }
}

impl<const N: usize> Dynamics<[f64; N]> for CarDynamics<N> {
    fn step(&self) -> f64 {
        self.car.integration_step()
    }

    fn sample(&self, random: &mut Random) -> Control {
        let mut within = |[low, high]: [f64; 2]| (low + (high - low) * random.uniform()).min(high) + 0.0;
        Control { speed: within(self.car.speed()), steering: within(self.car.steering()) }
    }

    fn extremes(&self) -> Vec<Control> {
        let ([backward, forward], [right, left]) = (self.car.speed(), self.car.steering());
        // As straight as possible.
        let straight = 0f64.max(right).min(left);
        let steerings = [straight, left, right];
        let mut extremes = Vec::new();
        for (speed, is_there) in [(forward, forward > 0.0), (backward, backward < 0.0)] {
            let differ =
                steerings.iter().enumerate().filter(|&(i, &steering)| is_there && (i == 0 || steering != straight));
            extremes.extend(differ.map(|(_, &steering)| Control { speed, steering }));
        }
        extremes
    }

    fn drive(&self, from: &[f64; N], control: Control, steps: u32) -> [f64; N] {
        if steps == 0 {
            return *from;
        }
        let duration = f64::from(steps) * self.step();
        let end = match self.integration {
            Integration::Exact => arc_pose(placement(from), control.speed, self.turn_rate(control), duration),
            Integration::Euler => self.euler(from, control).nth(steps as usize - 1).expect("the sequence is endless"),
        };
        self.space.state(&end)
    }

    fn free_steps(&self, from: &[f64; N], control: Control, steps: u32) -> u32 {
        match self.integration {
            Integration::Exact => {
                let (speed, turn_rate) = (control.speed, self.turn_rate(control));
                let most = LONGEST_DRIVE / (turn_rate * self.step()).abs();
                let steps = if most < f64::from(steps) { most as u32 } else { steps };
                let duration = f64::from(steps) * self.step();
                let motion = BodyMotion::Arc { from: placement(from), speed, turn_rate, duration };
                self.collision.free_steps(&motion, steps)
            }
            Integration::Euler => {
                let steps = self.euler(from, control).take(steps as usize);
                steps.take_while(|placement| self.collision.is_free(placement)).count() as u32
            }
        }
    }

    /// The metres driven, forwards or in reverse.
    fn length(&self, motion: Motion) -> f64 {
        motion.control.speed.abs() * motion.duration
    }

    /// Metres and radians along the arc, weighted. In a space of curves that is no bound: it has no motions by controls.
    fn reach(&self, motion: Motion) -> f64 {
        let weights = self.car.weights();
        let pace =
            weights.translation * motion.control.speed.abs() + weights.rotation * self.turn_rate(motion.control).abs();
        pace * motion.duration
    }

    fn steer(&self, from: &[f64; N], to: &[f64; N]) -> Vec<(Motion, [f64; N])> {
        let (Some(curve), Some((_, angle))) = (self.space.curve(from, to), self.car.turning_radius()) else {
            return Vec::new();
        };
        let [backward, forward] = self.car.speed();
        let mut at = placement(from);
        let mut motions: Vec<(Motion, [f64; N])> = Vec::with_capacity(curve.segments().len());
        for segment in curve.segments() {
            let steering = match segment.turn {
                Turn::Left => angle,
                Turn::Straight => 0.0,
                Turn::Right => -angle,
            };
            let control = Control { speed: if segment.length < 0.0 { backward } else { forward }, steering };
            let duration = segment.length / control.speed;
            at = arc_pose(at, control.speed, self.turn_rate(control), duration);
            motions.push((Motion { control, duration }, self.space.state(&at)));
        }
        if let Some((_, end)) = motions.last_mut() {
            *end = *to;
        }
        motions
    }
}
