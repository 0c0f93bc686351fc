//! A planar arm: a chain of capsules from a fixed base, each link turning or sliding against the one before.

use super::Part;
use super::range::{LARGEST, check_limits, check_positive, check_range, check_size, checked_margin};
use crate::error::{Code, Error, Number};
use crate::geometry::Point;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// The largest number of links an arm may have.
pub const MAX_LINKS: usize = 8;

/// The largest joint limit and the largest fixed angle, in radians.
const WIDEST_LIMIT: f64 = 100.0;

/// How a link moves against the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Joint {
    /// It turns: the coordinate is its angle to the link before, in radians, counter-clockwise.
    Revolute {
        /// The least and the greatest angle, within [-100, 100]; without limits the joint is a circle.
        limits: Option<[f64; 2]>,
    },
    /// It slides: the coordinate is what the link is longer than its given length, in metres.
    Prismatic {
        /// The least and the greatest coordinate. The link is nowhere shorter than 0.
        range: [f64; 2],
        /// The fixed angle of the link to the one before, in radians, within [-100, 100].
        angle: f64,
    },
}

impl Joint {
    /// A joint that turns without limits.
    pub const CIRCLE: Self = Self::Revolute { limits: None };

    /// The range of its coordinate: radians, or metres of a prismatic joint; `None` for a circle.
    pub fn range(&self) -> Option<[f64; 2]> {
        match *self {
            Self::Revolute { limits } => limits,
            Self::Prismatic { range, .. } => Some(range),
        }
    }

    /// The angle of its link to the one before at this coordinate, in radians.
    #[inline(always)]
    pub fn angle(&self, coordinate: f64) -> f64 {
        match *self {
            Self::Revolute { .. } => coordinate,
            Self::Prismatic { angle, .. } => angle,
        }
    }

    /// What its link is longer than its given length at this coordinate, in metres.
    #[inline(always)]
    pub fn extension(&self, coordinate: f64) -> f64 {
        match *self {
            Self::Revolute { .. } => 0.0,
            Self::Prismatic { .. } => coordinate,
        }
    }

    /// Whether it slides.
    pub fn is_prismatic(&self) -> bool {
        matches!(self, Self::Prismatic { .. })
    }
}

/// The joint as documents have it.
impl Serialize for Joint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Revolute { limits: None } => serializer.serialize_str("revolute"),
            Self::Revolute { limits: Some(limits) } => {
                let mut object = serializer.serialize_struct("Joint", 2)?;
                object.serialize_field("type", "revolute")?;
                object.serialize_field("limits", limits)?;
                object.end()
            }
            Self::Prismatic { range, angle } => {
                let mut object = serializer.serialize_struct("Joint", 3)?;
                object.serialize_field("type", "prismatic")?;
                object.serialize_field("range", range)?;
                object.serialize_field("angle", angle)?;
                object.end()
            }
        }
    }
}

/// An arm of 1 to [`MAX_LINKS`] links. A configuration holds one number per joint: the angle of its link to the link before, in
/// radians, counter-clockwise, or what a prismatic link is longer than its given length, in metres. Links may overlap each
/// other. A revolute joint without limits is a circle; any other is an interval of the real line, in which nothing wraps.
#[derive(Debug, Clone, PartialEq)]
pub struct Arm {
    base: Point,
    links: Vec<f64>,
    radius: f64,
    joints: Vec<Joint>,
    /// The range of each joint, if all have one.
    limits: Option<Vec<[f64; 2]>>,
    margin: f64,
}

impl Arm {
    /// An arm of revolute joints: base and lengths in metres, `radius` half the width of its links (0 makes them segments),
    /// joint limits in radians, one pair per link if given.
    ///
    /// # Errors
    /// `not-finite`, `out-of-range` or `wrong-dimension`, with a pointer into the `robot` object of a scenario: a number
    /// that is not finite, coordinates beyond 1e6, no link or more than [`MAX_LINKS`], a length that is not positive, a
    /// negative radius, limits that are not one increasing pair per link within [-100, 100].
    pub fn new(base: Point, links: Vec<f64>, radius: f64, joint_limits: Option<Vec<[f64; 2]>>) -> Result<Self, Error> {
        check_chain(base, &links, radius)?;
        if let Some(limits) = joint_limits.as_ref().filter(|limits| limits.len() != links.len()) {
            let sentence = format!("joint_limits must hold one pair per link: {}, not {}", links.len(), limits.len());
            return Err(Error::new(Code::WrongDimension, "/joint_limits", sentence));
        }
        for (i, &limits) in joint_limits.iter().flatten().enumerate() {
            check_limits(&format!("/joint_limits/{i}"), "a joint limit", limits, WIDEST_LIMIT)?;
        }
        let joint = |i: usize| Joint::Revolute { limits: joint_limits.as_ref().map(|limits| limits[i]) };
        let joints = (0..links.len()).map(joint).collect();
        Ok(Self::of(base, links, radius, joints))
    }

    /// An arm whose joints are given one by one, as many as links. A prismatic link goes on in the direction of the link before
    /// (the first in that of the x axis), turned by its fixed angle, and is its length plus its coordinate long.
    ///
    /// # Errors
    /// Those of [`Arm::new`], with pointers below `/joints` for what a joint holds; also if a prismatic link can become shorter
    /// than 0 or longer than 1e6.
    ///
    /// # Example
    /// A link that turns about the base, and a link that slides out of it by up to half a metre:
    ///
    /// ```
    /// use planarium::geometry::Point;
    /// use planarium::robot::{Arm, Joint};
    ///
    /// let slide = Joint::Prismatic { range: [0.0, 0.5], angle: 0.0 };
    /// let arm = Arm::with_joints(Point::new(0.0, 0.0), vec![1.0, 0.2], 0.05, vec![Joint::CIRCLE, slide])?;
    /// let tip = arm.end_effector(&[0.0, 0.3]);
    /// assert!((tip - Point::new(1.5, 0.0)).norm() < 1e-12);
    /// assert_eq!(arm.reach(), 1.7);
    /// # Ok::<(), planarium::Error>(())
    /// ```
    pub fn with_joints(base: Point, links: Vec<f64>, radius: f64, joints: Vec<Joint>) -> Result<Self, Error> {
        check_chain(base, &links, radius)?;
        if joints.len() != links.len() {
            let sentence = format!("joints must hold one joint per link: {}, not {}", links.len(), joints.len());
            return Err(Error::new(Code::WrongDimension, "/joints", sentence));
        }
        for (i, (joint, &length)) in joints.iter().zip(&links).enumerate() {
            let place = |field: &str| format!("/joints/{i}/{field}");
            match *joint {
                Joint::Revolute { limits } => {
                    limits.map_or(Ok(()), |limits| {
                        check_limits(&place("limits"), "a joint limit", limits, WIDEST_LIMIT)
                    })?;
                }
                Joint::Prismatic { range, angle } => {
                    check_limits(&place("range"), "an end of the range of a joint", range, LARGEST)?;
                    check_size(&place("angle"), "the angle of a joint", angle, WIDEST_LIMIT)?;
                    for (k, end) in range.into_iter().enumerate() {
                        let sentence = || {
                            let [length, end] = [length, end].map(Number);
                            format!("a link of length {length} and this coordinate must be 0 to 1e6 long; it is {end}")
                        };
                        if !(0.0..=LARGEST).contains(&(length + end)) {
                            return Err(Error::new(Code::OutOfRange, format!("{}/{k}", place("range")), sentence()));
                        }
                    }
                }
            }
        }
        Ok(Self::of(base, links, radius, joints))
    }

    /// The arm in its normal form.
    fn of(base: Point, links: Vec<f64>, radius: f64, mut joints: Vec<Joint>) -> Self {
        for joint in &mut joints {
            if let Joint::Prismatic { range, angle } = joint {
                *joint = Joint::Prismatic { range: range.map(|end| end + 0.0), angle: *angle + 0.0 };
            }
        }
        let limits = joints.iter().map(Joint::range).collect();
        Self { base: Point::new(base.x + 0.0, base.y + 0.0), links, radius: radius + 0.0, joints, limits, margin: 0.0 }
    }

    /// The same, to be planned for as if it were larger by this margin on all sides, in metres.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/margin`) if the margin is not a finite number from 0 to 1e6.
    pub fn with_margin(self, margin: f64) -> Result<Self, Error> {
        Ok(Self { margin: checked_margin(margin)?, ..self })
    }

    /// The position of the base, in metres.
    pub fn base(&self) -> Point {
        self.base
    }

    /// The lengths of the links from the base outwards, in metres; a prismatic link has this length at the coordinate 0.
    pub fn links(&self) -> &[f64] {
        &self.links
    }

    /// Half the width of the links, in metres.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// By how much it is planned for as larger, in metres.
    pub fn margin(&self) -> f64 {
        self.margin
    }

    /// The distance from the axes of the links that is kept free: radius and margin, in metres.
    pub fn kept_radius(&self) -> f64 {
        self.radius + self.margin
    }

    /// How each link moves against the one before, from the base outwards.
    pub fn joint_types(&self) -> &[Joint] {
        &self.joints
    }

    /// Which joints are circles: revolute without limits.
    pub(crate) fn circles(&self) -> Vec<bool> {
        self.joints.iter().map(|joint| joint.range().is_none()).collect()
    }

    /// The range (low, high) of each joint, in radians, or metres of prismatic ones, if every joint has one; `None` if a joint
    /// is a circle.
    pub fn joint_limits(&self) -> Option<&[[f64; 2]]> {
        self.limits.as_deref()
    }

    /// Whether a joint is prismatic.
    pub fn has_prismatic_joint(&self) -> bool {
        self.joints.iter().any(Joint::is_prismatic)
    }

    /// The greatest length of each link, in metres.
    pub fn longest(&self) -> impl DoubleEndedIterator<Item = f64> + ExactSizeIterator {
        self.links.iter().zip(&self.joints).map(|(length, joint)| match joint {
            Joint::Revolute { .. } => *length,
            Joint::Prismatic { range, .. } => length + range[1],
        })
    }

    /// The sum of the links' greatest lengths, in metres: the tip is never farther from the base. It gets there if no
    /// prismatic link is at an angle to the one before, and no limit keeps it from stretching.
    pub fn reach(&self) -> f64 {
        self.longest().sum()
    }

    /// The positions of all joints at `q`, from the base to the tip, in metres: `links + 1` points, the rest of the array
    /// repeats the tip. O(links).
    pub fn joints(&self, q: &[f64]) -> [Point; MAX_LINKS + 1] {
        let mut points = [self.base; MAX_LINKS + 1];
        let (mut angle, mut at) = (0.0, self.base);
        for (i, (&length, joint)) in self.links.iter().zip(&self.joints).enumerate() {
            angle += joint.angle(q[i]);
            let length = length + joint.extension(q[i]);
            let (sin, cos) = libm::sincos(angle);
            at = Point::new(at.x + length * cos, at.y + length * sin);
            points[i + 1] = at;
        }
        points[self.links.len()..].fill(at);
        points
    }

    /// The angle of the last link at `q` in the world, in radians, not wrapped. O(links).
    pub fn last_angle(&self, q: &[f64]) -> f64 {
        self.joints.iter().zip(q).map(|(joint, &coordinate)| joint.angle(coordinate)).sum()
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

    /// An upper bound on how far any point of each link can travel while the joints move by `delta` (radians or metres, any
    /// size) at constant rates: link i moves at most the sum over m <= i of L_m |w_m| + |d_m|, where L_m is the greatest
    /// length of link m, w_m the sum of the turns up to it, since joint m swings about the one before with the absolute rate of
    /// link m, and d_m what link m grows. In metres, one number per link. O(links).
    ///
    /// Source: the bound on displacement of Schwarzer, Saha and Latombe 2005, "Adaptive dynamic collision checking for
    /// single and multiple articulated robots in complex environments", with signed rates.
    pub fn travel(&self, delta: &[f64]) -> [f64; MAX_LINKS] {
        let mut travel = [0.0; MAX_LINKS];
        let (mut rate, mut sum) = (0.0, 0.0);
        for (i, (length, joint)) in self.longest().zip(&self.joints).enumerate() {
            match joint {
                Joint::Revolute { .. } => rate += delta[i],
                Joint::Prismatic { .. } => sum += delta[i].abs(),
            }
            sum += length * f64::abs(rate);
            travel[i] = sum;
        }
        travel
    }
}

/// As in documents: `joint_limits` if all joints are revolute and have limits, nothing if all are circles, else `joints`.
impl Serialize for Arm {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Arm", 4)?;
        object.serialize_field("base", &self.base)?;
        object.serialize_field("links", &self.links)?;
        object.serialize_field("radius", &self.radius)?;
        match &self.limits {
            Some(limits) if !self.has_prismatic_joint() => object.serialize_field("joint_limits", limits)?,
            _ if self.joints.iter().all(|joint| *joint == Joint::CIRCLE) => (),
            _ => object.serialize_field("joints", &self.joints)?,
        }
        if self.margin > 0.0 {
            object.serialize_field("margin", &self.margin)?;
        }
        object.end()
    }
}

/// Returns an error unless base, lengths and radius describe an arm.
fn check_chain(base: Point, links: &[f64], radius: f64) -> Result<(), Error> {
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
    check_range("/radius", "a radius", radius, 0.0)
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
