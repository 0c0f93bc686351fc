//! The safest path: closed forms; the widest disc, the exact shortest path of narrower ones, and distances by other code.

use crate::common::cases;
use crate::common::documents::{BODY, disc, disc_among, parse, rectangle, refuses};
use crate::widest::{ROOM, free_ends, random_world, wall};
use planarium::geometry::{Point, Segment};
use planarium::optimum::{Limit, MetricOptions, Safest, optimum, safest, widest};
use planarium::random::{Random, Stream};
use planarium::scenario::{Obstacle, Scenario};
use wasm_bindgen_test::wasm_bindgen_test;

fn of(obstacles: &[String], ends: [[f64; 2]; 2]) -> Safest {
    safest(disc_among(ROOM, obstacles, 0.0, ends), None).unwrap_or_else(|error| panic!("{error}"))
}

/// How far a point is from a segment.
fn apart(p: Point, s: &Segment) -> f64 {
    let along = s.b - s.a;
    let t = ((p - s.a).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (p - (s.a + along * t)).norm()
}

/// How far two segments that do not cross are from each other.
fn between(s: &Segment, t: &Segment) -> f64 {
    [apart(s.a, t), apart(s.b, t), apart(t.a, s), apart(t.b, s)].into_iter().fold(f64::INFINITY, f64::min)
}

/// The least distance of a path from obstacles and bounds, where it starts in none and crosses no border.
fn least(scenario: &Scenario, path: &[[f64; 2]]) -> f64 {
    let points: Vec<Point> = path.iter().map(|&[x, y]| Point::new(x, y)).collect();
    let bounds = scenario.world().bounds.expect("a room");
    let to_bounds = |p: &Point| (p.coords - bounds.min.coords).min().min((bounds.max.coords - p.coords).min());
    let ways: Vec<Segment> = if points.len() == 1 {
        vec![Segment::new(points[0], points[0])]
    } else {
        points.windows(2).map(|pair| Segment::new(pair[0], pair[1])).collect()
    };
    let of_edges = |edges: &[Segment], radius: f64| {
        let all = ways.iter().flat_map(|way| edges.iter().map(move |edge| between(way, edge)));
        all.fold(f64::INFINITY, f64::min) - radius
    };
    let to = |obstacle: &Obstacle| match obstacle {
        Obstacle::Disc(disc) => of_edges(&[Segment::new(disc.center, disc.center)], disc.radius),
        Obstacle::Polygon(polygon) => of_edges(&polygon.edges().collect::<Vec<_>>(), 0.0),
        Obstacle::Wall(wall) => {
            let edges: Vec<Segment> = wall.points().windows(2).map(|pair| Segment::new(pair[0], pair[1])).collect();
            of_edges(&edges, wall.radius())
        }
        Obstacle::PolygonWithHoles(_) => unreachable!("none is made here"),
    };
    let obstacles = scenario.world().obstacles.iter().map(to);
    obstacles.chain(points.iter().map(to_bounds)).fold(f64::INFINITY, f64::min)
}

#[wasm_bindgen_test(unsupported = test)]
fn it_goes_through_the_middle_of_the_wider_door() {
    // The shortest path takes the narrow door, which is straight ahead.
    let doors =
        [rectangle([4.0, -1.0], [6.0, 4.75]), rectangle([4.0, 5.25], [6.0, 8.0]), rectangle([4.0, 9.5], [6.0, 11.0])];
    let found = of(&doors, [[1.0, 5.0], [9.0, 5.0]]);
    assert_eq!(found.widest.limit, Limit::Gap);
    assert!(found.clearance.is_some_and(|clearance| (clearance - 0.75).abs() < 1e-11), "{found:?}");
    assert!(found.path.iter().all(|&[x, y]| !(4.0..=6.0).contains(&x) || (y - 8.75).abs() < 1e-9));
    // To the circle around a corner, along it, through the door, and the same on the other side.
    let (reach, up) = ((3.0_f64 * 3.0 + 3.0 * 3.0).sqrt(), std::f64::consts::FRAC_PI_4);
    let straight = (reach * reach - 0.75 * 0.75).sqrt();
    let turn = up + (0.75_f64 / reach).asin();
    let length = 2.0 * (straight + 0.75 * turn) + 2.0;
    assert!(found.length.is_some_and(|found| (found - length).abs() < 1e-9), "{found:?} is not {length}");
}

#[wasm_bindgen_test(unsupported = test)]
fn ends_contacts_and_slits_limit() {
    // The room at the start is all that a path can keep; from there it is straight.
    let post = [disc([5.0, 5.0], 1.0)];
    let found = of(&post, [[3.5, 5.0], [1.0, 5.0]]);
    assert_eq!(found.widest.limit, Limit::Start);
    assert!(found.clearance.is_some_and(|clearance| (clearance - 0.5).abs() < 1e-11));
    assert!(found.length.is_some_and(|length| (length - 2.5).abs() < 1e-12));
    // There and back is nowhere.
    let still = of(&post, [[2.0, 5.0]; 2]);
    assert_eq!((still.length, &still.path[..]), (Some(0.0), &[[2.0, 5.0]][..]));
    // On the bounds there is no room, and a path all the same.
    let found = of(&post, [[0.0, 5.0], [10.0, 5.0]]);
    assert_eq!((found.clearance, found.widest.radius), (Some(0.0), Some(0.0)));
    assert!(found.length.is_some_and(|length| length > 10.0));
    // A slit of any width is passed in its middle; one of none is closed.
    let slit =
        |gap: f64| [wall(&[[5.0, 0.0], [5.0, 5.0]], 0.0, false), wall(&[[5.0, 5.0 + gap], [5.0, 10.0]], 0.0, false)];
    for gap in [1.0, 1e-3, 1e-6, 1e-9] {
        let obstacles = slit(gap);
        let ends = [[1.0, 2.0], [9.0, 3.0]];
        let found = of(&obstacles, ends);
        let kept = least(&disc_among(ROOM, &obstacles, 0.0, ends), &found.path);
        assert!((kept - 0.5 * gap).abs() < 1e-11, "{gap}: {kept}");
    }
    let closed = of(&slit(0.0), [[1.0, 2.0], [9.0, 3.0]]);
    assert_eq!((closed.length, closed.clearance, closed.path.len()), (None, None, 0));
    assert_eq!(closed.widest.limit, Limit::Closed);
    refuses(safest(parse(BODY), None), "unsupported", "");
    let inside = disc_among(ROOM, &post, 0.0, [[1.0, 1.0], [5.0, 5.0]]);
    refuses(safest(&inside, None), "goal-in-collision", "/queries/0/goal");
}

#[wasm_bindgen_test(unsupported = test)]
fn it_keeps_the_widest_radius_and_is_as_short_as_that_allows() {
    let mut limits = [0; 4];
    for seed in 0..cases(1500) as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        let obstacles = random_world(&mut random, 3 + seed % 24);
        let Some(ends) = free_ends(&mut random, &obstacles) else { continue };
        let point = disc_among(ROOM, &obstacles, 0.0, ends);
        let found = safest(&point, None).unwrap_or_else(|error| panic!("{error}"));
        limits[found.widest.limit as usize] += 1;
        assert_eq!(Ok(&found.widest), widest(&point, None).as_ref(), "seed {seed}");
        let Some(radius) = found.widest.radius else {
            assert!(found.length.is_none() && found.path.is_empty() && found.clearance.is_none(), "seed {seed}");
            continue;
        };
        let (length, clearance) = found.length.zip(found.clearance).unwrap_or_else(|| panic!("seed {seed}: no path"));
        let (first, last) = (found.path.first(), found.path.last());
        assert_eq!((first, last), (Some(&ends[0]), Some(&ends[1])), "seed {seed}");
        // It keeps what it says, which is the widest radius, and no path keeps more.
        let kept = least(&point, &found.path);
        assert!(kept >= clearance - 1e-13 && clearance <= radius, "seed {seed}: {kept} {clearance}");
        assert!((radius - kept).abs() <= 1e-11, "seed {seed}: {radius} {kept}");
        // Its points measure what it says, but for tangents in place of arcs.
        let measured: f64 = found.path.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum();
        assert!(length - 1e-9 <= measured && measured <= 1.0003 * length + 1e-9, "seed {seed}: {length} {measured}");
        // A point has shorter paths, and so has a disc that is a little narrower, but hardly.
        let shortest = |radius: f64| {
            let found = optimum(disc_among(ROOM, &obstacles, radius, ends), None, MetricOptions::default());
            found.ok().and_then(|found| found.length)
        };
        let free = shortest(0.0).unwrap_or_else(|| panic!("seed {seed}: a point has no path"));
        assert!(length >= free - 1e-9, "seed {seed}: {length} {free}");
        // Arcs grow with the radius at the rate of their angles.
        let narrow = shortest((radius * (1.0 - 1e-9) - 2e-11).max(0.0)).expect("a narrower disc passes");
        assert!((length - narrow).abs() <= 1e-6, "seed {seed}: {length} {narrow}");
    }
    assert!(limits.iter().all(|&times| times > 0), "{limits:?}");
}
