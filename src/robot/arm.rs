//! A planar arm of revolute joints: a chain of capsules from a fixed base.

use super::Part;
use super::range::{LARGEST, check_limits, check_positive, check_range};
use crate::error::{Code, Error};
use crate::geometry::Point;
use serde::Serialize;

/// The largest number of links an arm may have.
pub const MAX_LINKS: usize = 8;

/// The largest joint limit, in radians.
const WIDEST_LIMIT: f64 = 100.0;

/// An arm of 1 to [`MAX_LINKS`] links. A configuration holds one angle per joint, in radians, counter-clockwise, each
/// relative to the link before. Links may overlap each other. A joint without limits is a circle; with limits it is an
/// interval of the real line, in which nothing wraps.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Arm {
    base: Point,
    links: Vec<f64>,
    radius: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    joint_limits: Option<Vec<[f64; 2]>>,
}

impl Arm {
    /// An arm: base and lengths in metres, `radius` half the width of its links (0 makes them segments), joint limits in
    /// radians, one pair per link if given.
    ///
    /// # Errors
    /// `not-finite`, `out-of-range` or `wrong-dimension`, with a pointer into the `robot` object of a scenario: a number
    /// that is not finite, coordinates beyond 1e6, no link or more than [`MAX_LINKS`], a length that is not positive, a
    /// negative radius, limits that are not one increasing pair per link within [-100, 100].
    pub fn new(base: Point, links: Vec<f64>, radius: f64, joint_limits: Option<Vec<[f64; 2]>>) -> Result<Self, Error> {
        for (i, &coordinate) in base.coords.iter().enumerate() {
            check_range(&format!("/base/{i}"), "a coordinate", coordinate, -LARGEST)?;
        }
        if links.is_empty() || links.len() > MAX_LINKS {
            let sentence = format!("an arm has 1 to {MAX_LINKS} links, not {}", links.len());
            return Err(Error::new(Code::OutOfRange, "/links", sentence));
        }
        for (i, &length) in links.iter().enumerate() {
            check_positive(&format!("/links/{i}"), "the length of a link", length, LARGEST)?;
        }
        check_range("/radius", "a radius", radius, 0.0)?;
        if let Some(limits) = joint_limits.as_ref().filter(|limits| limits.len() != links.len()) {
            let sentence = format!("joint_limits must hold one pair per link: {}, not {}", links.len(), limits.len());
            return Err(Error::new(Code::WrongDimension, "/joint_limits", sentence));
        }
        for (i, &limits) in joint_limits.iter().flatten().enumerate() {
            check_limits(&format!("/joint_limits/{i}"), "a joint limit", limits, WIDEST_LIMIT)?;
        }
        Ok(Self { base: Point::new(base.x + 0.0, base.y + 0.0), links, radius: radius + 0.0, joint_limits })
    }

    /// The position of the base, in metres.
    pub fn base(&self) -> Point {
        self.base
    }

    /// The lengths of the links from the base outwards, in metres.
    pub fn links(&self) -> &[f64] {
        &self.links
    }

    /// Half the width of the links, in metres.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The limits (low, high) of each joint in radians, if the arm has limits.
    pub fn joint_limits(&self) -> Option<&[[f64; 2]]> {
        self.joint_limits.as_deref()
    }

    /// The sum of the links' lengths, in metres: the largest distance of the tip from the base.
    pub fn reach(&self) -> f64 {
        self.links.iter().sum()
    }

    /// The positions of all joints at `q`, from the base to the tip, in metres: `links + 1` points, the rest of the array
    /// repeats the tip. O(links).
    pub fn joints(&self, q: &[f64]) -> [Point; MAX_LINKS + 1] {
        let mut points = [self.base; MAX_LINKS + 1];
        let (mut angle, mut at) = (0.0, self.base);
        for (i, &length) in self.links.iter().enumerate() {
            angle += q[i];
            let (sin, cos) = libm::sincos(angle);
            at = Point::new(at.x + length * cos, at.y + length * sin);
            points[i + 1] = at;
        }
        points[self.links.len()..].fill(at);
        points
    }

    /// The position of the end effector at `q`, in metres.
    pub fn end_effector(&self, q: &[f64]) -> Point {
        self.joints(q)[self.links.len()]
    }

    /// The links at `q` as capsules, from the base outwards.
    pub fn footprint(&self, q: &[f64]) -> Vec<Part> {
        let joints = self.joints(q);
        let link = |i: usize| Part::Capsule { a: joints[i], b: joints[i + 1], radius: self.radius };
        (0..self.links.len()).map(link).collect()
    }

    /// An upper bound on how far any point of each link can travel while the joints turn by `delta` (radians, any size) at
    /// constant rates: link i moves at most the sum over m <= i of L_m |sum over j <= m of delta_j|, since joint m swings
    /// about the one before with the absolute rate of link m. In metres, one number per link. O(links).
    ///
    /// Source: the bound on displacement of Schwarzer, Saha and Latombe 2005, "Adaptive dynamic collision checking for
    /// single and multiple articulated robots in complex environments", with signed rates.
    pub fn travel(&self, delta: &[f64]) -> [f64; MAX_LINKS] {
        let mut travel = [0.0; MAX_LINKS];
        let (mut rate, mut sum) = (0.0, 0.0);
        for (i, &length) in self.links.iter().enumerate() {
            rate += delta[i];
            sum += length * f64::abs(rate);
            travel[i] = sum;
        }
        travel
    }
}

/// A position for the end effector of an arm, and optionally the orientation of its last link.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Target {
    /// The position of the tip in the world, in metres.
    pub point: Point,
    /// The angle of the last link in the world, in radians, in any number of turns; any angle if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<f64>,
}

/// What sentences call a link: they count from 1, data from 0.
pub(crate) fn link_name(part: usize) -> String {
    format!("link {}", part + 1)
}
