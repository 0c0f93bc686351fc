//! Where the tip of an arm is to go.

use crate::error::{Code, Error, Number};
use crate::robot::{Arm, LARGEST};
use crate::space::wrap;

pub use crate::robot::Target;

impl Target {
    /// Refuses a target that no arm, or not this arm, can be asked for; brings its orientation into (-pi, pi].
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (beyond 1e6), pointers `/target/0`, `/target/1` and `/orientation`; `unsupported`,
    /// pointer `/orientation`, for an orientation of an arm of one link, whose place decides its orientation.
    pub(super) fn checked(mut self, arm: &Arm) -> Result<Self, Error> {
        for i in 0..2 {
            check(self.point[i], &format!("/target/{i}"), "a coordinate of the target")?;
            self.point[i] += 0.0;
        }
        if let Some(angle) = &mut self.orientation {
            check(*angle, "/orientation", "the orientation")?;
            *angle = wrap(*angle);
            if arm.links().len() < 2 {
                let sentence = "an arm of one link cannot be asked for an orientation: its tip's place decides it";
                return Err(Error::new(Code::Unsupported, "/orientation", sentence));
            }
        }
        Ok(self)
    }
}

/// Refuses a number that is not finite, or beyond 1e6 in size.
pub(super) fn check(value: f64, pointer: &str, what: &str) -> Result<(), Error> {
    if !value.is_finite() {
        let sentence = format!("{what} must be a finite number, not {}", Number(value));
        return Err(Error::new(Code::NotFinite, pointer, sentence));
    }
    if value.abs() > LARGEST {
        let [most, value] = [LARGEST, value].map(Number);
        let sentence = format!("{what} must lie within [-{most}, {most}], not {value}");
        return Err(Error::new(Code::OutOfRange, pointer, sentence));
    }
    Ok(())
}

/// A configuration of the arm, checked and brought into its canonical form: angles of circles in (-pi, pi].
///
/// # Errors
/// `wrong-dimension`, `not-finite` or `out-of-range` (beyond 1e6, or outside the limits), with pointers below `pointer`.
pub(super) fn configuration(arm: &Arm, q: &[f64], pointer: &str) -> Result<[f64; crate::robot::MAX_LINKS], Error> {
    let count = arm.links().len();
    if q.len() != count {
        let sentence = format!("a configuration of this arm has {count} numbers, not {}", q.len());
        return Err(Error::new(Code::WrongDimension, pointer, sentence));
    }
    let mut angles = [0.0; crate::robot::MAX_LINKS];
    for (i, &angle) in q.iter().enumerate() {
        let place = format!("{pointer}/{i}");
        check(angle, &place, "a joint angle")?;
        if let Some(limits) = arm.joint_limits() {
            let [low, high] = limits[i];
            if !(low..=high).contains(&angle) {
                let [low, high, angle] = [low, high, angle].map(Number);
                let sentence = format!("joint {i} must lie within its limits [{low}, {high}], not {angle}");
                return Err(Error::new(Code::OutOfRange, place, sentence));
            }
            angles[i] = angle + 0.0;
        } else {
            angles[i] = wrap(angle);
        }
    }
    Ok(angles)
}
