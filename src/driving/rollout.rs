//! One control held for a while: where the car goes, and how far.

use super::road::{MAX_STEPS, Road, check_finite};
use crate::error::{Code, Error, Number};
use crate::problem::{Control, Motion, Touched};
use crate::world::PlanningWorld;

/// Where a motion leads.
#[derive(Debug, Clone, PartialEq)]
pub struct Rollout {
    /// The start, the pose after each whole step that is proven free, and after the rest of a step at the end: (x, y, theta)
    /// in metres and radians.
    pub poses: Vec<[f64; 3]>,
    /// How long it is proven free, in seconds: the duration asked for, unless it was blocked.
    pub seconds: f64,
    /// What blocks it, if anything: see [`super::Drive::blocked`].
    pub blocked: Option<Option<Touched>>,
}

/// The motion from `q`, step by step. Each pose is computed from the start, so that nothing adds up. O(duration / step).
///
/// # Errors
/// `unsupported` where the robot is no car; `wrong-dimension`, `not-finite` or `out-of-range` with the pointers `/q`, `/v`,
/// `/phi` and `/duration`: a control beyond the limits of the car (but it may stand), a duration that is negative or of more
/// than [`MAX_STEPS`] steps.
pub fn rollout(scenario: impl Into<PlanningWorld>, q: &[f64], motion: Motion) -> Result<Rollout, Error> {
    let road = Road::new(&scenario.into())?;
    let start = road.pose(q, "/q")?;
    let Motion { control, duration } = motion;
    check_control(&road, control)?;
    check_finite(duration, "/duration")?;
    let step = road.car().integration_step();
    if duration < 0.0 || duration > step * MAX_STEPS as f64 {
        let [most, given] = [step * MAX_STEPS as f64, duration].map(Number);
        let sentence = format!("the duration must lie within [0, {most}] seconds, not {given}");
        return Err(Error::new(Code::OutOfRange, "/duration", sentence));
    }
    let mut rollout = Rollout { poses: vec![start], seconds: 0.0, blocked: None };
    if let Some(contact) = road.contacts(&start).first() {
        rollout.blocked = Some(Some(contact.with));
        return Ok(rollout);
    }
    let road = road.fitted(&start);
    let mut from = start;
    for i in 1u32.. {
        if rollout.seconds >= duration {
            break;
        }
        let until = duration.min(step * f64::from(i));
        if let Err(touched) = road.ahead(&from, control, until - rollout.seconds) {
            rollout.blocked = Some(touched);
            break;
        }
        from = road.after(&start, control, until);
        rollout.poses.push(from);
        rollout.seconds = until;
    }
    Ok(rollout)
}

/// Refuses a control that the car has not.
fn check_control(road: &Road, control: Control) -> Result<(), Error> {
    let named = [
        ("/v", "v", control.speed, road.car().speed(), control.speed == 0.0),
        ("/phi", "phi", control.steering, road.car().steering(), false),
    ];
    for (pointer, name, value, [low, high], is_allowed) in named {
        check_finite(value, pointer)?;
        if !is_allowed && !(low..=high).contains(&value) {
            let [low, high, value] = [low, high, value].map(Number);
            let sentence = format!("{name} must lie within [{low}, {high}], not {value}");
            return Err(Error::new(Code::OutOfRange, pointer, sentence));
        }
    }
    Ok(())
}
