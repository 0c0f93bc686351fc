//! Composite planning: the configurations of two or three robots as one, by RRT-Connect.
//!
//! LaValle 2006, "Planning Algorithms", section 7.2. A motion moves all robots at once, each straight at a constant rate, and all
//! arrive at the same time. It is free if each robot's own motion is proven free of obstacles, and each pair's proven apart. The
//! metric of a robot is the time that it takes at its speed; times of robots combine by the root of the sum of their squares.

use super::document::Fleet;
use super::motion::{Footprint, Motion, Pair, Pose};
use super::result::{FleetReason, FleetStats};
use super::trajectory::Trajectory;
use crate::error::{Code, Error};
use crate::path::{Improvement, Wanted, split};
use crate::planner::{DEFAULT_TOLERANCE, Planner, PlannerOptions, RrtConnectOptions};
use crate::problem::{Contact, Problem, Status, Validity};
use crate::space::{Coordinate, MAX_DIMENSION, Metric, MotionSpace, ProductSpace, Space};
use crate::world::SMALL;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// The configurations of all robots, one after the other.
type Joint = [f64; MAX_DIMENSION];

crate::options! {
    /// Options of composite planning.
    pub struct CompositeOptions for &[];
    /// Longest step of a tree.
    step: Option<f64>, in 1e-6..=1e7, "Step", unit "s", else "it adapts to the scene: a fifth of the largest distance in the space at first, half as long where that is refused";
    /// Number of shortcuts tried between random points of the path: more make it shorter.
    shortcut: u64 = 200, in 0.0..=1e6, "Shortcuts";
    /// Number of shortcuts in a single coordinate of one robot tried after that.
    partial_shortcut: u64 = 200, in 0.0..=1e6, "Partial shortcuts";
    /// Number of iterations without a path after which the planner gives up.
    max_iterations: u32 = 200_000, in 1.0..=4e9, "Most iterations";
}

/// The planner. An iteration is one of RRT-Connect, or an attempt at improving its path.
pub(super) struct Composite {
    problem: Problem<MotionSpace<MAX_DIMENSION>>,
    planner: Box<dyn Planner<MotionSpace<MAX_DIMENSION>>>,
    iteration: u32,
    wanted: Wanted,
    seed: u64,
    improvement: Option<Improvement<MotionSpace<MAX_DIMENSION>>>,
    trajectories: Vec<Trajectory>,
    pair_checks: Arc<AtomicU64>,
}

impl Composite {
    pub fn new(fleet: &Fleet, options: &CompositeOptions, seed: u64) -> Result<Self, Error> {
        let robots = fleet.robots();
        let unsupported = |sentence: String| Error::new(Code::Unsupported, "/robots", sentence);
        if !(2..=3).contains(&robots.len()) {
            let sentence = format!("composite plans for 2 or 3 robots, not for {}", robots.len());
            return Err(unsupported(sentence));
        }
        let dimensions: Vec<usize> = robots.iter().map(|member| member.robot.dimension()).collect();
        let all = dimensions.iter().sum::<usize>();
        if all > MAX_DIMENSION {
            let sentence = format!("composite plans in at most {MAX_DIMENSION} coordinates; these robots have {all}");
            return Err(unsupported(sentence));
        }
        let space = space(fleet);
        let pair_checks = Arc::new(AtomicU64::new(0));
        let mut members = Vec::with_capacity(robots.len());
        let mut first = 0;
        for (i, member) in robots.iter().enumerate() {
            let world = &fleet.worlds()[fleet.kinds()[i]];
            let own = MotionSpace::new(world.default_space());
            let [start, goal] = [&member.start, &member.goal].map(|q| own.state(q));
            let validity = world.checker::<SMALL>(&own, DEFAULT_TOLERANCE).fitted(&start, &goal).validity();
            members.push(Member {
                validity,
                footprint: fleet.footprints()[i].clone(),
                first,
                dimension: dimensions[i],
            });
            first += dimensions[i];
        }
        let validity = Apart { members, slack: fleet.slack(), pair_checks: Arc::clone(&pair_checks) };
        let ends = |of: fn(&super::FleetRobot) -> &Vec<f64>| {
            space.state(&robots.iter().flat_map(of).copied().collect::<Vec<f64>>())
        };
        let (start, goal) = (ends(|member| &member.start), ends(|member| &member.goal));
        let mut problem = Problem::new(space, Box::new(validity), start, goal)?;
        problem.records_events = false;
        let planner = PlannerOptions::RrtConnect(RrtConnectOptions { step: options.step, ..Default::default() });
        let planner = planner.begin(&problem, seed)?;
        let (shortcuts, partial_shortcuts) = (options.shortcut, options.partial_shortcut);
        let wanted = Wanted { reduce: true, shortcuts, partial_shortcuts, blend: 0.0 };
        let (iteration, improvement, trajectories) = (0, None, Vec::new());
        Ok(Self { problem, planner, iteration, wanted, seed, improvement, trajectories, pair_checks })
    }

    pub fn iterate(&mut self, fleet: &Fleet, most: u32) -> Status {
        match &mut self.improvement {
            Some(improvement) => improvement.attempt(&self.problem),
            None => {
                self.iteration += 1;
                let status = self.planner.iterate(&self.problem, self.iteration);
                if status != Status::Solved {
                    let is_over = self.iteration == most || self.planner.is_full();
                    return if is_over { Status::Exhausted } else { status };
                }
                let graph = self.planner.graph();
                let path = self.planner.path().into_iter().map(|vertex| *graph.state(vertex)).collect();
                self.improvement = Some(Improvement::new(path, self.wanted, self.seed));
            }
        }
        let Some(improvement) = self.improvement.as_ref().filter(|improvement| improvement.is_done()) else {
            return Status::Running;
        };
        self.trajectories = self.timed(fleet, improvement.path());
        Status::Solved
    }

    /// The trajectories of the robots along a path: the slowest one decides how long a motion takes.
    fn timed(&self, fleet: &Fleet, path: &[Joint]) -> Vec<Trajectory> {
        let path = split(self.problem.space(), path);
        let members = members(fleet);
        let mut trajectories: Vec<Trajectory> =
            members.iter().map(|member| Trajectory::standing(part(&path[0], member.0, member.1))).collect();
        let mut time = 0.0;
        for ends in path.windows(2) {
            let durations = members.iter().enumerate().map(|(i, &(first, dimension))| {
                let [from, to] = [&ends[0], &ends[1]].map(|q| part(q, first, dimension));
                fleet.footprints()[i].travel(from, to) / fleet.robots()[i].speed
            });
            time += durations.fold(0.0, f64::max);
            for (trajectory, &(first, dimension)) in trajectories.iter_mut().zip(&members) {
                trajectory.add(time, part(&ends[1], first, dimension));
            }
        }
        trajectories
    }

    /// Why it has given up, if it has not for the number of its iterations.
    pub fn reason(&self) -> Option<FleetReason> {
        self.planner.is_full().then_some(FleetReason::GraphFull)
    }

    pub fn trajectory(&self, robot: usize) -> Option<&Trajectory> {
        self.trajectories.get(robot)
    }

    pub fn planned(&self) -> usize {
        self.trajectories.len()
    }

    /// The trajectories of all robots, once solved.
    pub fn take_solution(&mut self) -> Vec<Arc<Trajectory>> {
        self.trajectories.drain(..).map(Arc::new).collect()
    }

    /// The vertices of both trees: the configurations of all robots, one after the other.
    pub fn vertices(&self) -> &[Joint] {
        self.planner.graph().states()
    }

    /// The edges of both trees.
    pub fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.planner.graph().edges().iter().map(|edge| edge.map(|vertex| vertex.0))
    }

    pub fn stats(&self) -> FleetStats {
        let improving = self.improvement.as_ref().map_or(0, |improvement| improvement.motion_checks);
        FleetStats {
            vertices: self.vertices().len() as u64,
            edges: self.planner.graph().edges().len() as u64,
            motion_checks: self.planner.growth().counters.motion_checks + improving,
            pair_checks: self.pair_checks.load(Ordering::Relaxed),
            ..FleetStats::default()
        }
    }
}

/// Of every robot, its first coordinate and how many it has.
pub(super) fn members(fleet: &Fleet) -> Vec<(usize, usize)> {
    let mut first = 0;
    let of = |member: &super::FleetRobot| {
        let dimension = member.robot.dimension();
        first += dimension;
        (first - dimension, dimension)
    };
    fleet.robots().iter().map(of).collect()
}

/// The pose of one robot.
pub(super) fn part(joint: &[f64], first: usize, dimension: usize) -> Pose {
    super::document::pose(&joint[first..first + dimension])
}

/// The space of all robots: differences count as the time that they take.
fn space(fleet: &Fleet) -> MotionSpace<MAX_DIMENSION> {
    let (mut coordinates, mut weights) = (Vec::new(), Vec::new());
    for (i, member) in fleet.robots().iter().enumerate() {
        let own: ProductSpace<SMALL> = fleet.worlds()[fleet.kinds()[i]].default_space();
        for j in 0..own.dimension() {
            let [low, high] = own.range(j);
            let is_circle = own.is_circle(j);
            coordinates.push(if is_circle { Coordinate::Circle } else { Coordinate::Interval { low, high } });
            weights.push(if is_circle { fleet.footprints()[i].reach() } else { 1.0 } / member.speed);
        }
    }
    MotionSpace::new(ProductSpace::new(&coordinates, Metric::Euclidean).weighted(&weights))
}

/// One of the robots.
struct Member {
    validity: Box<dyn Validity<[f64; SMALL]>>,
    footprint: Footprint,
    first: usize,
    dimension: usize,
}

impl Member {
    /// Its state in its own space.
    fn state(&self, joint: &Joint) -> [f64; SMALL] {
        let [x, y, theta] = part(joint, self.first, self.dimension);
        [x, y, theta, 0.0]
    }

    fn motion(&self, a: &Joint, b: &Joint) -> Motion {
        let [from, to] = [a, b].map(|q| part(q, self.first, self.dimension));
        Motion::new([0.0, 1.0], from, to)
    }
}

/// The collision checker of all robots at once.
struct Apart {
    members: Vec<Member>,
    slack: f64,
    pair_checks: Arc<AtomicU64>,
}

impl Apart {
    /// Two robots that are not proven apart while all move from one state to another at the same time.
    fn conflict(&self, a: &Joint, b: &Joint) -> Option<[usize; 2]> {
        let motions: Vec<Motion> = self.members.iter().map(|member| member.motion(a, b)).collect();
        let pairs = (0..motions.len()).flat_map(|i| (0..i).map(move |j| [j, i]));
        pairs.into_iter().find(|&[j, i]| {
            self.pair_checks.fetch_add(1, Ordering::Relaxed);
            let footprints = [&self.members[j].footprint, &self.members[i].footprint];
            !Pair { footprints, motions: [&motions[j], &motions[i]], slack: self.slack }.is_apart()
        })
    }
}

impl Validity<Joint> for Apart {
    /// Those with obstacles; `part` is the robot.
    fn contacts(&self, state: &Joint) -> Vec<Contact> {
        let of = |(part, member): (usize, &Member)| {
            let contacts = member.validity.contacts(&member.state(state));
            contacts.into_iter().map(move |contact| Contact { part, ..contact })
        };
        self.members.iter().enumerate().flat_map(of).collect()
    }

    fn is_free(&self, state: &Joint) -> bool {
        self.members.iter().all(|member| member.validity.is_free(&member.state(state)))
            && self.conflict(state, state).is_none()
    }

    fn is_motion_free(&self, a: &Joint, b: &Joint) -> bool {
        // Pairs of robots cost less than obstacles.
        self.conflict(a, b).is_none()
            && self.members.iter().all(|member| member.validity.is_motion_free(&member.state(a), &member.state(b)))
    }

    fn collision(&self, state: &Joint) -> Option<String> {
        let mut why: Vec<String> =
            self.members.iter().filter_map(|member| member.validity.collision(&member.state(state))).collect();
        why.extend(self.conflict(state, state).map(|[j, i]| format!("robot {j} touches robot {i}")));
        (!why.is_empty()).then(|| why.join(", "))
    }

    fn clearance_evaluations(&self) -> u64 {
        self.members.iter().map(|member| member.validity.clearance_evaluations()).sum()
    }

    fn unproven_motions(&self) -> u64 {
        self.members.iter().map(|member| member.validity.unproven_motions()).sum()
    }
}
