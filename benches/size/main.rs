//! Large worlds: time and memory of reading, validation, set-up and the first query, and the time of a proof.
//!
//! `cargo bench --bench size`. `-- worlds` has many obstacles, `-- polygons` one polygon of many corners, `-- region` one region as
//! ten thousand rectangles and as one polygon; `-- boxes` compares the boxes of obstacles with parry's tree. A run pinned to one core
//! is quieter.

mod boxes;
#[path = "../counting.rs"]
mod counting;
mod shapes;

use counting::{Counting, measure};
use planarium::collision::{ArmValidity, BodyCollision, BodyMotion, CollisionWorld, DiscValidity};
use planarium::geometry::{Point, Polygon};
use planarium::problem::Validity;
use planarium::random::{Random, Stream};
use planarium::robot::{Arm, DiscRobot, RigidBody, Weights, joint_space};
use planarium::run::{Options, RrtConnectOptions, Status, start};
use planarium::scenario::{Obstacle, Query, Robot, Scenario, World};
use planarium::space::Metric;
use shapes::Kind;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

/// Counts allocated bytes.
#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Motions whose proofs are timed together.
const MOTIONS: usize = 1000;

/// Passes over the motions, of which the fastest counts.
const PASSES: usize = 12;

/// Seconds from which on the processor's clock is fine enough.
const COARSE: f64 = 0.02;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let most = arguments.iter().find_map(|argument| argument.parse().ok()).unwrap_or(usize::MAX);
    let tables: Vec<&String> = arguments.iter().filter(|argument| argument.parse::<usize>().is_err()).collect();
    let wanted = |table: &str| tables.is_empty() || tables.iter().any(|&name| name == table);
    if wanted("worlds") {
        println!(
            "\n| obstacles | text, MB | read, ms | most, MB | held, MB | set-up, ms | held, MB | first path of a disc, ms | of a body, ms | proofs of a point, µs | a disc | a body | an arm |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
        for count in [1000, 10_000, 100_000].into_iter().filter(|&count| count <= most) {
            worlds("rectangles", &shapes::map(count));
            worlds("discs", &shapes::discs(count));
        }
    }
    if wanted("polygons") {
        println!(
            "\n| corners of one polygon | text, MB | read, ms | most, MB | held, MB | its check alone, ms | set-up with pieces, ms | held, MB | proofs of a point, µs | a disc | a body | clearance of a body, µs |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|---|---|");
        for kind in Kind::ALL {
            for count in [100, 1000, 10_000, 100_000, 1_000_000].into_iter().filter(|&count| count <= most) {
                polygons(kind, count);
            }
        }
    }
    if wanted("region") {
        region();
    }
    if wanted("boxes") {
        boxes::compare();
    }
}

/// The result of a piece of work and its milliseconds: those of the processor, whose clock is too coarse for short work.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let (began, entered) = (spent(), Instant::now());
    let made = work();
    let wall = entered.elapsed().as_secs_f64();
    let spent = if wall < COARSE { wall } else { spent() - began };
    (made, spent * 1e3)
}

/// The last result of several passes of short work, and the milliseconds of the fastest, which nothing interrupted.
fn best<T>(mut work: impl FnMut() -> T) -> (T, f64) {
    let mut pass = || {
        let began = Instant::now();
        (work(), began.elapsed().as_secs_f64() * 1e3)
    };
    let mut fastest = pass();
    for _ in 1..PASSES {
        let (made, milliseconds) = pass();
        fastest = (made, fastest.1.min(milliseconds));
    }
    fastest
}

/// The seconds that this thread has run so far; the time of day where the system does not tell.
fn spent() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = text.as_deref().and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(
        || std::time::SystemTime::UNIX_EPOCH.elapsed().map_or(0.0, |since| since.as_secs_f64()),
        |nanoseconds| nanoseconds * 1e-9,
    )
}

fn megabytes(bytes: usize) -> f64 {
    bytes as f64 / 1e6
}

/// The milliseconds from a scenario to its first path.
fn first_path(scenario: &Scenario) -> String {
    let work = || {
        let options = Options::new(RrtConnectOptions::default());
        let mut run = start(scenario, options).expect("start and goal are free");
        run.step(u64::MAX)
    };
    match timed(work) {
        (Status::Solved, milliseconds) => format!("{milliseconds:.1}"),
        (status, milliseconds) => format!("{status:?} after {milliseconds:.0}"),
    }
}

/// A body of 0.3 m times 0.15 m.
fn body() -> Polygon {
    let corners = [[-0.15, -0.075], [0.15, -0.075], [0.15, 0.075], [-0.15, 0.075]];
    Polygon::new(&corners.map(Point::from)).expect("a rectangle")
}

/// The scenario of a robot that crosses ten metres of the world.
fn crossing(world: &World, robot: impl Into<Robot>) -> Scenario {
    let robot = robot.into();
    let aabb = world.bounds.expect("it has bounds");
    let middle = ((aabb.min.x + aabb.max.x) / 2.0).round();
    let ends = [middle - 5.0, middle + 5.0].map(|x| {
        let mut place = vec![x; 2];
        place.resize(robot.dimension(), 0.0);
        place
    });
    let [from, to] = ends;
    Scenario::new("size", world.clone(), robot, [Query::new("across", from, to)]).expect("a scenario")
}

/// Prints the row of a world of many obstacles, a metre apart.
fn worlds(name: &str, world: &World) {
    let disc = crossing(world, DiscRobot::new(0.1).expect("a radius"));
    let text = disc.to_json_string();
    let ((scenario, read), held, most) = measure(|| timed(|| Scenario::parse(&text).expect("it reads back")));
    assert_eq!(scenario.world().obstacles.len(), world.obstacles.len());
    let ((prepared, set_up), tree, _) = measure(|| timed(|| CollisionWorld::from(world)));
    let shape = RigidBody::new(body(), Weights::default());
    let paths = [first_path(&disc), first_path(&crossing(world, shape))];
    let proofs = proofs(&prepared, world, 1.0);
    println!(
        "| {} {name} | {:.1} | {read:.0} | {:.0} | {:.0} | {set_up:.1} | {:.1} | {} | {} | {proofs} |",
        world.obstacles.len(),
        text.len() as f64 / 1e6,
        megabytes(most),
        megabytes(held),
        megabytes(tree),
        paths[0],
        paths[1],
    );
}

/// Prints the row of one polygon.
fn polygons(kind: Kind, count: usize) {
    let corners = kind.corners(count);
    let (polygon, check) = timed(|| Polygon::new(&corners).expect("a simple polygon"));
    let world = shapes::around([Obstacle::Polygon(polygon)]);
    let robot = Arm::new(Point::new(-50.0, -50.0), vec![1.0], 0.0, None).expect("an arm");
    let scenario = Scenario::new("size", world.clone(), robot, []).expect("a scenario");
    let text = scenario.to_json_string();
    let (read, held, most) = measure(|| timed(|| Scenario::parse(&text).expect("it reads back")));
    let ((prepared, set_up), tree, _) = measure(|| {
        timed(|| {
            let prepared = CollisionWorld::from(&world);
            black_box(BodyCollision::new(&body(), prepared.clone(), 1e-4));
            prepared
        })
    });
    println!(
        "| {count}, {} | {:.1} | {:.0} | {:.0} | {:.0} | {check:.1} | {set_up:.1} | {:.1} | {} |",
        kind.name(),
        text.len() as f64 / 1e6,
        read.1,
        megabytes(most),
        megabytes(held),
        megabytes(tree),
        proofs_at_border(&prepared, &corners),
    );
}

/// One region of a hundred times a hundred rectangles, and as one polygon.
fn region() {
    println!(
        "\n| region | set-up with pieces, µs | proofs near, µs: a point | a disc | a body | far: a point | a disc | a body | first path of a disc, ms | of a body, ms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (name, world) in shapes::regions() {
        let (prepared, milliseconds) = best(|| {
            let prepared = CollisionWorld::from(&world);
            black_box(BodyCollision::new(&body(), prepared.clone(), 1e-4));
            prepared
        });
        // Beside the region's border, and beyond it.
        let mut rows = Vec::new();
        for from in [[100.2, 0.0], [140.0, 0.0]] {
            let mut random = Random::new(1, Stream::Samples);
            let motions: Vec<[[f64; 3]; 2]> = (0..MOTIONS)
                .map(|_| {
                    let [x, y, turn, a, b, c] = std::array::from_fn(|_| random.uniform());
                    let start = [from[0] + 0.2 + x, 100.0 * y, TAU * turn];
                    [start, [start[0] + 2.0 * a - 1.0, start[1] + 4.0 * b - 2.0, start[2] + c]]
                })
                .collect();
            rows.push(times(&prepared, &motions));
        }
        let disc = shapes::past(&world, DiscRobot::new(0.1).expect("a radius"));
        let shape = RigidBody::new(body(), Weights::default());
        println!(
            "| {name} | {:.0} | {} | {} | {} | {} |",
            milliseconds * 1e3,
            rows[0],
            rows[1],
            first_path(&disc),
            first_path(&shapes::past(&world, shape)),
        );
    }
}

/// Microseconds of the proofs of motions of this length from free places of a world.
fn proofs(prepared: &CollisionWorld, world: &World, length: f64) -> String {
    let aabb = world.bounds.expect("it has bounds");
    let collision = BodyCollision::new(&body(), prepared.clone(), 1e-4);
    let mut random = Random::new(1, Stream::Samples);
    let mut motions = Vec::new();
    while motions.len() < MOTIONS {
        let [x, y, turn, way, by] = std::array::from_fn(|_| random.uniform());
        let along = |low: f64, high: f64, part: f64| low + (high - low) * part;
        let from = [along(aabb.min.x, aabb.max.x, x), along(aabb.min.y, aabb.max.y, y), TAU * turn];
        let (sin, cos) = (TAU * way).sin_cos();
        if collision.is_free(&from) {
            motions.push([from, [from[0] + length * cos, from[1] + length * sin, from[2] + by - 0.5]]);
        }
    }
    let arm = Arm::new(Point::new(aabb.min.x, aabb.min.y), vec![1.0; 3], 0.02, None).expect("an arm");
    let checker = ArmValidity::<3>::new(&arm, joint_space(&arm, Metric::Sum), prepared.clone(), 1e-4);
    let arms = microseconds(&motions, |[a, b]| {
        let angles = |q: &[f64; 3]| q.map(|x| x.rem_euclid(1.5));
        checker.is_motion_free(&angles(a), &angles(b))
    });
    format!("{} | {arms:.2}", times(prepared, &motions))
}

/// The same beside the border of a polygon, half a metre long, and the time of a body's distance.
fn proofs_at_border(prepared: &CollisionWorld, corners: &[Point]) -> String {
    let mut random = Random::new(1, Stream::Samples);
    let motions: Vec<[[f64; 3]; 2]> = (0..MOTIONS)
        .map(|_| {
            let [at, x, y, turn, a, b, c] = std::array::from_fn(|_| random.uniform());
            let at = corners[(at * corners.len() as f64) as usize];
            let start = [at.x + x - 0.5, at.y + y - 0.5, TAU * turn];
            [start, [start[0] + a - 0.5, start[1] + b - 0.5, start[2] + c - 0.5]]
        })
        .collect();
    let robot = BodyCollision::new(&body(), prepared.clone(), 1e-4);
    let clearance = microseconds(&motions, |[from, _]| robot.clearance(from) > 1.0);
    format!("{} | {clearance:.2}", times(prepared, &motions))
}

/// Microseconds of the proofs of a point, a disc and a body.
fn times(prepared: &CollisionWorld, motions: &[[[f64; 3]; 2]]) -> String {
    let mut columns = Vec::new();
    for radius in [0.0, 0.1] {
        let disc = DiscValidity::new(&DiscRobot::new(radius).expect("a radius"), prepared.clone());
        columns.push(microseconds(motions, |[a, b]| disc.is_motion_free(a, b)));
    }
    let robot = BodyCollision::new(&body(), prepared.clone(), 1e-4);
    columns.push(microseconds(motions, |&[from, to]| {
        robot.is_motion_free(&BodyMotion::Straight { from, delta: [0, 1, 2].map(|i| to[i] - from[i]) })
    }));
    columns.iter().map(|us| format!("{us:.2}")).collect::<Vec<_>>().join(" | ")
}

/// The least over all passes of the time of a check, in microseconds.
fn microseconds<M>(motions: &[M], check: impl Fn(&M) -> bool) -> f64 {
    // A few at a time: longer work is interrupted by other programs.
    let few = motions.chunks(20).map(|few| best(|| _ = black_box(few.iter().filter(|motion| check(motion)).count())).1);
    few.sum::<f64>() * 1e3 / motions.len() as f64
}
