//! The motions of the others that one robot plans among, by place, and the proofs that its own are apart from them.

use super::motion::{CLEAR, Footprint, Motion, Pair, Pose};
use super::roadmap::Roadmap;
use super::trajectory::Trajectory;
use crate::geometry::{Aabb, Boxes, sort_numbers, sort_stably};
use std::collections::BTreeSet;
use std::sync::Arc;

/// After this many comparisons of edges, of boxes around edges and of motions, an iteration begins no further proof: its
/// expansion goes on in the next one.
const MOST_WORK: u64 = 1 << 17;

/// What a robot plans among.
#[derive(Clone, Copy)]
pub(super) struct Scene<'a> {
    /// The robot that plans.
    pub robot: usize,
    pub speed: f64,
    pub roadmap: &'a Roadmap,
    /// Of every robot, this one included.
    pub footprints: &'a [Footprint],
    /// Of every robot.
    pub trajectories: &'a [Arc<Trajectory>],
    /// The robots to keep clear of; this one does not count.
    pub among: &'a [usize],
    pub slack: f64,
}

impl Scene<'_> {
    /// A motion of one of the others beside one of this robot.
    pub fn pair<'a>(&'a self, other: usize, motions: [&'a Motion; 2]) -> Pair<'a> {
        Pair { footprints: [&self.footprints[other], &self.footprints[self.robot]], motions, slack: self.slack }
    }
}

/// Room for the motions that are found beside one; there are rarely more.
const FOUND: usize = 16;

/// The iteration has done its work. The next one does the same again, with the results of all proofs so far.
pub(super) struct Pause;

/// The results of the proofs of a part of an expansion, in their order, so that it may be spread over several
/// iterations.
#[derive(Default)]
pub(super) struct Proofs {
    results: Vec<bool>,
    /// How many of them have been asked for in this iteration.
    asked: usize,
    /// The comparisons of this iteration.
    work: u64,
    /// Whether this iteration has added a result.
    has_new: bool,
    /// The proofs of motions that the robot may take, since they were last read.
    pub checks: u64,
}

impl Proofs {
    /// Whether a pair of motions is proven apart.
    pub fn is_apart(&mut self, pair: &Pair, counts: bool) -> Result<bool, Pause> {
        let at = self.asked;
        if at == self.results.len() {
            if self.has_new && self.work > MOST_WORK {
                return Err(Pause);
            }
            self.has_new = true;
            self.checks += u64::from(counts);
            self.results.push(pair.is_apart_counted(&mut self.work));
        }
        self.asked += 1;
        Ok(self.results[at])
    }

    /// Counts motions that were compared, unless this iteration repeats what an earlier one did.
    fn compared(&mut self, count: usize) {
        if self.asked == self.results.len() {
            self.work += count as u64;
        }
    }

    /// Begins an iteration.
    pub fn begin(&mut self) {
        (self.asked, self.work, self.has_new) = (0, 0, false);
    }

    /// A part of the expansion is complete: its results are not asked for again.
    pub fn complete(&mut self) {
        self.results.clear();
        self.asked = 0;
    }
}

/// The motions of the others of a scene, as they are when it is made.
pub(super) struct Traffic {
    /// Of one robot after another, in the order of the scene, its motions in order.
    motions: Vec<(usize, Motion)>,
    /// The box of each, with a disc around the robot.
    boxes: Boxes,
}

impl Traffic {
    /// The motions of the others. O(n log n) for n motions.
    pub fn new(scene: &Scene) -> Self {
        let others = scene.among.iter().copied().filter(|&other| other != scene.robot);
        let motions: Vec<(usize, Motion)> =
            others.flat_map(|other| scene.trajectories[other].motions().map(move |motion| (other, motion))).collect();
        let boxes: Vec<Aabb> =
            motions.iter().map(|(other, motion)| motion.covered(&scene.footprints[*other])).collect();
        Self { boxes: Boxes::new(&boxes), motions }
    }

    /// The others' motions that overlap a motion of the scene's robot in time, and whose boxes meet its own, in order.
    fn beside<'a>(
        &'a self,
        scene: &Scene,
        motion: &Motion,
        proofs: &mut Proofs,
    ) -> impl Iterator<Item = &'a (usize, Motion)> + use<'a> {
        let near = motion.covered(&scene.footprints[scene.robot]).grown(CLEAR * scene.slack);
        let mut found = Vec::with_capacity(FOUND);
        self.boxes.any(&near, |number| {
            let (_, other) = &self.motions[number];
            if other.begin <= motion.end && motion.begin <= other.end {
                found.push(number as u32);
            }
            false
        });
        sort_numbers(&mut found, &|a, b| a.cmp(&b));
        proofs.compared(found.len());
        found.into_iter().map(|number| &self.motions[number as usize])
    }

    /// The first of the others from which a motion is not proven apart, and its motion that is in the way.
    pub fn first_in_conflict(
        &self,
        scene: &Scene,
        motion: &Motion,
        proofs: &mut Proofs,
    ) -> Result<Option<(usize, Motion)>, Pause> {
        for (other, theirs) in self.beside(scene, motion, proofs) {
            if !proofs.is_apart(&scene.pair(*other, [theirs, motion]), true)? {
                return Ok(Some((*other, *theirs)));
            }
        }
        Ok(None)
    }

    /// When others make a pose unsafe: each of them with intervals of time, those of one motion in order.
    fn conflicts(&self, scene: &Scene, at: Pose, proofs: &mut Proofs) -> Result<Vec<(usize, [f64; 2])>, Pause> {
        let stand = Motion::standing([0.0, f64::INFINITY], at);
        let (mut conflicts, mut intervals) = (Vec::new(), Vec::new());
        for (other, theirs) in self.beside(scene, &stand, proofs) {
            let pair = scene.pair(*other, [theirs, &stand]);
            pair.add_conflicts(&mut intervals, |pair| proofs.is_apart(pair, false))?;
            conflicts.extend(intervals.drain(..).map(|interval| (*other, interval)));
        }
        Ok(conflicts)
    }

    /// The others that make a pose unsafe at some time.
    pub fn in_conflict(&self, scene: &Scene, at: Pose, proofs: &mut Proofs) -> Result<BTreeSet<usize>, Pause> {
        Ok(self.conflicts(scene, at, proofs)?.into_iter().map(|(other, _)| other).collect())
    }

    /// The safe intervals of a pose, in order.
    pub fn safe_intervals(&self, scene: &Scene, at: Pose, proofs: &mut Proofs) -> Result<Vec<[f64; 2]>, Pause> {
        let mut conflicts = self.conflicts(scene, at, proofs)?;
        sort_stably(&mut conflicts, |(_, a), (_, b)| a[0].total_cmp(&b[0]));
        let (mut safe, mut from) = (Vec::new(), 0.0);
        for (_, [begin, end]) in conflicts {
            if begin > from {
                safe.push([from, begin]);
            }
            from = f64::max(from, end);
        }
        if from < f64::INFINITY {
            safe.push([from, f64::INFINITY]);
        }
        Ok(safe)
    }
}
