//! The boxes of obstacles beside parry's tree: what decision 1 is about.

use super::{best, shapes, timed};
use parry2d_f64::bounding_volume;
use parry2d_f64::math::Vector;
use parry2d_f64::partitioning::{Bvh, BvhBuildStrategy};
use planarium::collision::Obstacles;
use planarium::geometry::{Aabb, Point};
use planarium::random::{Random, Stream};
use planarium::scenario::World;
use std::hint::black_box;

/// Queries that are timed together.
const QUERIES: usize = 1000;

/// Prints the table.
pub fn compare() {
    println!(
        "\n| boxes | set-up, ms: ours | `Bvh` | side of the query, m | met | all, ns: ours | `Bvh` | the first, ns: ours | `Bvh` |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for count in [64, 1000, 10_000, 100_000] {
        row("rectangles of a map", &shapes::map(count));
        row("random discs", &shapes::piled_discs(count));
    }
}

fn row(name: &str, world: &World) {
    let boxes: Vec<Aabb> = world.obstacles.iter().map(|obstacle| obstacle.aabb()).collect();
    let leaf = |aabb: &Aabb| {
        let corner = |p: Point| Vector::new(p.x, p.y);
        bounding_volume::Aabb::new(corner(aabb.min), corner(aabb.max))
    };
    let leaves: Vec<_> = boxes.iter().map(leaf).collect();
    let ours = built(|| Obstacles::new(world.obstacles.clone()));
    let theirs = built(|| Bvh::from_leaves(BvhBuildStrategy::Binned, &leaves));
    let bounds = world.bounds.expect("it has bounds");
    for side in [0.2, 1.0, 5.0] {
        let mut random = Random::new(1, Stream::Samples);
        let mut query = || {
            let [x, y] = [bounds.min.x, bounds.min.y].map(|low| low + (bounds.max.x - low - side) * random.uniform());
            Aabb { min: Point::new(x, y), max: Point::new(x + side, y + side) }
        };
        let queries: Vec<Aabb> = (0..QUERIES).map(|_| query()).collect();
        let asked: Vec<_> = queries.iter().map(leaf).collect();
        let mut met = [0, 0];
        let all = [
            best(|| {
                met[0] = 0;
                for near in &queries {
                    ours.0.any_near(near, |i| {
                        met[0] += usize::from(boxes[i].intersects(near));
                        false
                    });
                }
            }),
            best(|| met[1] = asked.iter().map(|near| theirs.0.intersect_aabb(near).count()).sum::<usize>()),
        ];
        assert_eq!(met[0], met[1], "both find the same boxes");
        let first = [
            best(|| {
                _ = black_box(
                    queries.iter().filter(|near| ours.0.any_near(near, |i| boxes[i].intersects(near))).count(),
                )
            }),
            best(|| _ = black_box(asked.iter().filter(|near| theirs.0.intersect_aabb(near).next().is_some()).count())),
        ];
        let each = |(_, milliseconds): &((), f64)| milliseconds * 1e6 / QUERIES as f64;
        println!(
            "| {} {name} | {:.2} | {:.2} | {side} | {:.2} | {:.0} | {:.0} | {:.0} | {:.0} |",
            boxes.len(),
            ours.1,
            theirs.1,
            met[0] as f64 / QUERIES as f64,
            each(&all[0]),
            each(&all[1]),
            each(&first[0]),
            each(&first[1]),
        );
    }
}

/// What was built, and the milliseconds of the fastest of five times.
fn built<T>(mut work: impl FnMut() -> T) -> (T, f64) {
    let times = (0..5).map(|_| timed(&mut work));
    times.min_by(|a, b| a.1.total_cmp(&b.1)).expect("five times")
}
