//! A planner of a fleet as a value that is stepped.

use super::composite::{self, Composite};
use super::document::Fleet;
use super::motion::Pose;
use super::options::{FleetOptions, FleetPlannerOptions};
use super::pbs::Pbs;
use super::prioritized::Prioritized;
use super::result::{Blocked, BlockedNames, FleetReason, FleetResult, FleetStats, RobotTrajectory};
use super::roadmap::Roadmap;
use super::trajectory::{Trajectory, moved_until_next};
use crate::error::{Code, Error, quoted};
use crate::fingerprint::Fingerprint;
use crate::problem::{Status, Stepped};
use crate::random::check_seed;

/// A planner of a fleet: a value that is stepped. How its iterations are divided into steps does not change its result.
pub struct FleetPlanner {
    fleet: Fleet,
    id: &'static str,
    seed: u64,
    algorithm: Algorithm,
    most: u64,
    iterations: u64,
    status: Status,
    /// Whether a plan was found and refused, as its times are too late for doubles.
    is_refused: bool,
}

enum Algorithm {
    Pbs(Box<Pbs>),
    Prioritized(Box<Prioritized>),
    Composite(Box<Composite>),
}

impl Stepped for FleetPlanner {
    fn iterate(&mut self) {
        self.iterations += 1;
        let (status, most) = match &mut self.algorithm {
            Algorithm::Pbs(planner) => (planner.iterate(&self.fleet), Some(self.most)),
            Algorithm::Prioritized(planner) => (planner.iterate(&self.fleet), Some(self.most)),
            // It limits its planner itself, and not the improvement of the path.
            Algorithm::Composite(planner) => (planner.iterate(&self.fleet, self.most as u32), None),
        };
        let is_over = status == Status::Running && most == Some(self.iterations);
        self.status = if is_over { Status::Exhausted } else { status };
        if self.status == Status::Solved && self.is_too_late() {
            (self.status, self.is_refused) = (Status::Exhausted, true);
        }
    }

    /// `Solved` once every robot has a trajectory; `Exhausted` if there is no plan, for the reason that [`FleetPlanner::reason`]
    /// gives.
    fn status(&self) -> Status {
        self.status
    }

    fn iterations(&self) -> u64 {
        self.iterations
    }
}

impl FleetPlanner {
    /// Begins, with [`FleetOptions`], or with the options of a planner alone. Import [`Stepped`] to step it.
    ///
    /// # Errors
    /// `out-of-range` and `not-finite` for values of options; `out-of-range` with a pointer into `/order` if it does not name
    /// every robot once; `unsupported` for an order of another planner than `prioritized`, and for a composite of fewer than two
    /// or more than three robots, or of more than eight coordinates.
    pub fn new(fleet: &Fleet, options: impl Into<FleetOptions>) -> Result<Self, Error> {
        let options = options.into();
        check_seed(options.seed)?;
        let planner = options.planner();
        if options.order.is_some() && !matches!(planner, FleetPlannerOptions::Prioritized(_)) {
            let sentence = "only prioritized planning has an order of priorities";
            return Err(Error::new(Code::Unsupported, "/order", sentence));
        }
        planner.check()?;
        let (algorithm, most) = match &planner {
            FleetPlannerOptions::Pbs(pbs) => {
                (Algorithm::Pbs(Box::new(Pbs::new(fleet, pbs, options.seed)?)), pbs.most_iterations(fleet))
            }
            FleetPlannerOptions::Composite(composite) => {
                let planner = Composite::new(fleet, composite, options.seed)?;
                (Algorithm::Composite(Box::new(planner)), u64::from(composite.max_iterations))
            }
            FleetPlannerOptions::Prioritized(prioritized) => {
                let order = order(fleet, options.order.as_deref())?;
                let planner = Prioritized::new(fleet, prioritized, order, options.seed, options.order.is_some())?;
                (Algorithm::Prioritized(Box::new(planner)), prioritized.max_iterations)
            }
        };
        Ok(Self {
            fleet: fleet.clone(),
            id: planner.id(),
            seed: options.seed,
            algorithm,
            most,
            iterations: 0,
            status: Status::Running,
            is_refused: false,
        })
    }

    /// Whether a robot arrives so late that doubles cannot represent its motions to within the slack.
    fn is_too_late(&self) -> bool {
        let slack = self.fleet.slack();
        self.fleet.robots().iter().enumerate().any(|(i, member)| {
            let arrival = self.trajectory(i).map_or(0.0, Trajectory::arrival);
            moved_until_next(arrival, member.speed) > slack
        })
    }

    /// The fleet.
    pub fn fleet(&self) -> &Fleet {
        &self.fleet
    }

    /// Why there is no plan; `None` unless the status is `Exhausted`.
    pub fn reason(&self) -> Option<FleetReason> {
        let known = match &self.algorithm {
            Algorithm::Pbs(planner) => planner.reason(),
            Algorithm::Prioritized(planner) => planner.orders().reason(),
            Algorithm::Composite(planner) => planner.reason(),
        };
        let known = if self.is_refused { Some(FleetReason::TooLate) } else { known };
        (self.status == Status::Exhausted).then(|| known.unwrap_or(FleetReason::IterationLimit))
    }

    /// How many robots have a trajectory; of `pbs` none, or all.
    pub fn planned(&self) -> usize {
        match &self.algorithm {
            Algorithm::Pbs(planner) => planner.planned(),
            Algorithm::Prioritized(planner) => planner.orders().planned(),
            Algorithm::Composite(planner) => planner.planned(),
        }
    }

    /// The robots in the order in which they plan, by their indices; without priorities, that of the document.
    pub fn order(&self) -> Vec<usize> {
        match &self.algorithm {
            Algorithm::Prioritized(planner) => planner.orders().order().to_vec(),
            Algorithm::Pbs(_) | Algorithm::Composite(_) => (0..self.fleet.footprints().len()).collect(),
        }
    }

    /// The trajectory of a robot, by its index; `None` before it has planned.
    pub fn trajectory(&self, robot: usize) -> Option<&Trajectory> {
        match &self.algorithm {
            Algorithm::Pbs(planner) => planner.trajectory(robot),
            Algorithm::Prioritized(planner) => planner.orders().trajectory(robot),
            Algorithm::Composite(planner) => planner.trajectory(robot),
        }
    }

    /// The robot that found no way last, once there is no plan; `None` if none is known.
    pub fn blocked(&self) -> Option<Blocked> {
        let known = match &self.algorithm {
            Algorithm::Pbs(planner) => planner.blocked(),
            Algorithm::Prioritized(planner) => planner.orders().blocked().cloned(),
            Algorithm::Composite(_) => None,
        };
        known.filter(|_| self.status == Status::Exhausted && !self.is_refused)
    }

    /// The roadmaps, one of every kind of robot; `None` of the composite.
    fn roadmaps(&self) -> Option<&[Roadmap]> {
        match &self.algorithm {
            Algorithm::Pbs(planner) => Some(planner.roadmaps()),
            Algorithm::Prioritized(planner) => Some(planner.roadmaps()),
            Algorithm::Composite(_) => None,
        }
    }

    /// The roadmap that a robot plans on, by its index: equal robots share one. Of the composite the trees of each robot have its
    /// own index.
    pub fn roadmap_of(&self, robot: usize) -> usize {
        if self.roadmaps().is_some() { self.fleet.kinds()[robot] } else { robot }
    }

    /// How many roadmaps there are.
    pub fn roadmap_count(&self) -> usize {
        self.roadmaps().map_or(self.fleet.footprints().len(), <[Roadmap]>::len)
    }

    /// How many vertices and edges a roadmap has.
    pub fn roadmap_size(&self, roadmap: usize) -> (usize, usize) {
        match &self.algorithm {
            Algorithm::Composite(planner) => (planner.vertices().len(), planner.edges().count()),
            Algorithm::Pbs(_) | Algorithm::Prioritized(_) => self
                .roadmaps()
                .map_or((0, 0), |roadmaps| (roadmaps[roadmap].vertex_count(), roadmaps[roadmap].edge_count())),
        }
    }

    /// The vertices of a roadmap from row `row` on, as poses: x, y, theta; theta of a disc is 0. Of the composite, the places of
    /// one robot in the vertices of the trees.
    pub fn vertices_since(&self, roadmap: usize, row: usize) -> Vec<Pose> {
        match &self.algorithm {
            Algorithm::Pbs(_) | Algorithm::Prioritized(_) => self.roadmaps().map_or_else(Vec::new, |roadmaps| {
                let roadmap = &roadmaps[roadmap];
                (row..roadmap.vertex_count()).map(|vertex| roadmap.pose(vertex as u32)).collect()
            }),
            Algorithm::Composite(planner) => {
                let (first, dimension) = composite::members(&self.fleet)[roadmap];
                planner.vertices()[row..].iter().map(|joint| composite::part(joint, first, dimension)).collect()
            }
        }
    }

    /// The edges of a roadmap from row `row` on: two vertex numbers each.
    pub fn edges_since(&self, roadmap: usize, row: usize) -> Vec<[u32; 2]> {
        match &self.algorithm {
            Algorithm::Pbs(_) | Algorithm::Prioritized(_) => {
                self.roadmaps().map_or_else(Vec::new, |roadmaps| roadmaps[roadmap].edges().skip(row).collect())
            }
            Algorithm::Composite(planner) => planner.edges().skip(row).collect(),
        }
    }

    /// The work so far.
    pub fn stats(&self) -> FleetStats {
        let stats = match &self.algorithm {
            Algorithm::Pbs(planner) => planner.stats(),
            Algorithm::Prioritized(planner) => planner.stats(),
            Algorithm::Composite(planner) => planner.stats(),
        };
        FleetStats { iterations: self.iterations, ..stats }
    }

    /// The sum, over all robots, of a number of their trajectories; 0 unless solved.
    fn total(&self, of: fn(&Trajectory) -> f64) -> f64 {
        if self.status != Status::Solved {
            return 0.0;
        }
        (0..self.fleet.footprints().len()).filter_map(|robot| self.trajectory(robot)).map(of).sum::<f64>() + 0.0
    }

    /// When the last robot arrives, in seconds; 0 unless solved.
    pub fn makespan(&self) -> f64 {
        let arrivals =
            (0..self.fleet.footprints().len()).filter_map(|robot| self.trajectory(robot)).map(Trajectory::arrival);
        if self.status == Status::Solved { arrivals.fold(0.0, f64::max) } else { 0.0 }
    }

    /// The sum of the arrivals of all robots, in seconds; 0 unless solved.
    pub fn sum_of_costs(&self) -> f64 {
        self.total(Trajectory::arrival)
    }

    /// 64-bit FNV-1a over the vertices and edges of all roadmaps or trees, the order of priorities, and the rows of all
    /// trajectories.
    pub fn fingerprint(&self) -> u64 {
        let mut fingerprint = Fingerprint::default();
        for roadmap in 0..self.roadmap_count() {
            self.vertices_since(roadmap, 0).iter().for_each(|pose| fingerprint.numbers(pose));
            let edges = self.edges_since(roadmap, 0);
            edges.iter().flatten().for_each(|&vertex| fingerprint.integer(u64::from(vertex)));
        }
        for robot in self.order() {
            fingerprint.integer(robot as u64);
            if let Some(trajectory) = self.trajectory(robot) {
                fingerprint.numbers(trajectory.times());
                trajectory.poses().iter().for_each(|pose| fingerprint.numbers(pose));
            }
        }
        fingerprint.value()
    }

    /// The result document.
    pub fn result(&self) -> FleetResult {
        let members = self.fleet.robots();
        let name = |&robot: &usize| members[robot].name.clone();
        let robots = (0..members.len()).filter_map(|robot| Some((robot, self.trajectory(robot)?)));
        let in_document = |(robot, trajectory): (usize, &Trajectory)| {
            let dimension = members[robot].robot.dimension();
            let path = trajectory.poses().iter().map(|pose| pose[..dimension].to_vec()).collect();
            RobotTrajectory { name: name(&robot), times: trajectory.times().to_vec(), path }
        };
        let blocked =
            |blocked: Blocked| BlockedNames { robot: name(&blocked.robot), by: blocked.by.iter().map(name).collect() };
        FleetResult {
            fleet: self.fleet.name().to_owned(),
            planner: self.id.to_owned(),
            seed: self.seed,
            status: self.status,
            reason: self.reason(),
            order: matches!(self.algorithm, Algorithm::Prioritized(_)).then(|| self.order().iter().map(name).collect()),
            robots: robots.map(in_document).collect(),
            makespan: self.makespan(),
            sum_of_costs: self.sum_of_costs(),
            waits: self.total(Trajectory::waits),
            blocked: self.blocked().map(blocked),
            stats: self.stats(),
            fingerprint: self.fingerprint(),
        }
    }
}

/// The order of priorities: the robots by their indices.
fn order(fleet: &Fleet, given: Option<&[String]>) -> Result<Vec<usize>, Error> {
    let count = fleet.robots().len();
    let Some(given) = given else { return Ok((0..count).collect()) };
    let mut order = Vec::with_capacity(count);
    for (i, word) in given.iter().enumerate() {
        let refuse = |sentence: String| Err(Error::new(Code::OutOfRange, format!("/order/{i}"), sentence));
        let index = word.parse().ok().filter(|index| *index < count);
        let Some(robot) = fleet.find(word).or(index) else {
            return refuse(format!("there is no robot {}", quoted(word)));
        };
        if order.contains(&robot) {
            return refuse(format!("robot {} is there already", quoted(word)));
        }
        order.push(robot);
    }
    if order.len() < count {
        let sentence = format!("the order names {} of {count} robots; it must name every one", order.len());
        return Err(Error::new(Code::OutOfRange, "/order", sentence));
    }
    Ok(order)
}
