//! Maps of areas, lines and points: lengths that are known, and those of scenarios; what is refused.

use planarium::geometry::{Aabb, Point};
use planarium::optimum::{MetricOptions, optimum};
use planarium::random::{Random, Stream};
use planarium::robot::DiscRobot;
use planarium::scenario::{Obstacle, Query, Scenario, World};
use planarium_shortest::{Found, Kind, Map, Part, Settings, Subject};
use std::f64::consts::PI;

const PLANAR: Settings = Settings { distance: 0.0, bounds: None, planar: true, many_queries: false };

fn part(kind: Kind, positions: &[[f64; 2]]) -> Part<'_> {
    Part { kind, positions }
}

fn map(parts: &[Part<'_>], settings: &Settings) -> Map {
    Map::new(parts, settings).unwrap_or_else(|fault| panic!("{fault}"))
}

fn found(map: &Map, start: [f64; 2], goal: [f64; 2]) -> Found {
    map.query(start, goal).unwrap_or_else(|fault| panic!("{fault}")).expect("a path")
}

fn close(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a} {b}");
}

fn square(low: [f64; 2], high: [f64; 2]) -> [[f64; 2]; 4] {
    [low, [high[0], low[1]], high, [low[0], high[1]]]
}

fn refused(parts: &[Part<'_>], settings: &Settings) -> (&'static str, Subject) {
    let fault = Map::new(parts, settings).err().expect("a fault");
    assert!(!fault.message().is_empty());
    (fault.code().as_str(), fault.subject())
}

#[test]
fn lengths_around_points_lines_and_areas() {
    let round = |parts: &[Part<'_>], distance| {
        found(&map(parts, &Settings { distance, ..PLANAR }), [-5.0, 0.0], [5.0, 0.0]).length
    };
    // Two tangents to a circle of radius 3 around the origin, and the arc between.
    let tangents = 2.0 * 4.0 + 3.0 * (PI - 2.0 * (3.0_f64 / 5.0).acos());
    close(round(&[part(Kind::Points, &[[0.0; 2]])], 3.0), tangents, 1e-12);
    close(round(&[part(Kind::Points, &[[0.0; 2]])], 0.0), 10.0, 1e-12);
    close(round(&[part(Kind::Line, &[[0.0, -4.0], [0.0, 12.0]])], 0.0), 2.0 * 41.0_f64.sqrt(), 1e-12);
    let block = square([-2.0, -4.0], [2.0, 100.0]);
    close(round(&[part(Kind::Outline, &block)], 0.0), 4.0 + 2.0 * 5.0, 1e-12);
    // Nothing is in the way, and nothing at all.
    close(round(&[part(Kind::Line, &[[0.0, 1.0], [0.0, 2.0]])], 0.5), 10.0, 1e-12);
    close(round(&[], 1.0), 10.0, 0.0);
}

#[test]
fn the_inside_of_a_hole_is_free_and_closed() {
    let (outline, hole) = (square([0.0; 2], [10.0; 2]), square([2.0; 2], [8.0; 2]));
    let parts = [part(Kind::Outline, &outline), part(Kind::Hole, &hole), part(Kind::Points, &[[5.0; 2]])];
    let map = map(&parts, &Settings { distance: 0.5, ..PLANAR });
    close(found(&map, [3.0, 3.0], [3.0, 7.0]).length, 4.0, 1e-12);
    assert_eq!(map.query([3.0, 3.0], [12.0, 3.0]), Ok(None));
    for (start, goal, code, subject) in [
        ([1.0; 2], [12.0; 2], "start-in-collision", Subject::Start),
        ([12.0; 2], [5.3; 2], "goal-in-collision", Subject::Goal),
        ([12.0; 2], [f64::NAN, 0.0], "not-finite", Subject::Goal),
        ([1e9; 2], [12.0; 2], "out-of-range", Subject::Start),
    ] {
        let fault = map.query(start, goal).expect_err("a fault");
        assert_eq!((fault.code().as_str(), fault.subject()), (code, subject));
    }
}

#[test]
fn bounds_limit_paths_and_without_them_areas_do_not() {
    let wall = [[0.0, -1.0], [0.0, 1.0]];
    let parts = [part(Kind::Line, &wall)];
    let bounds = Some([[-5.0, -1.0], [5.0, 1.0]]);
    let closed = map(&parts, &Settings { bounds, ..PLANAR });
    assert_eq!(closed.query([-4.0, 0.0], [4.0, 0.0]), Ok(None));
    assert_eq!(closed.query([-4.0, 0.0], [6.0, 0.0]).expect_err("a fault").subject(), Subject::Goal);
    let open = map(&parts, &PLANAR);
    let near = found(&open, [-1.0, 0.0], [1.0, 0.0]);
    close(near.length, 2.0 * 2.0_f64.sqrt(), 1e-12);
    for far in [10.0, 1e3, 1e7, 20.0, 1e3] {
        close(found(&open, [-far, 0.0], [far, 0.0]).length, 2.0 * (far * far + 1.0).sqrt(), 1e-12);
    }
    assert_eq!(found(&open, [-1.0, 0.0], [1.0, 0.0]), near);
}

#[test]
fn lengths_are_those_of_scenarios() {
    for seed in 0..40 {
        let mut random = Random::new(seed, Stream::Scenario);
        let mut number = |low: f64, high: f64| low + (high - low) * random.uniform();
        let distance = if seed % 3 == 0 { 0.0 } else { number(0.05, 0.3) };
        let rings: Vec<_> = (0..12)
            .map(|_| {
                let [x, y, w, h] = [number(0.0, 9.0), number(0.0, 9.0), number(0.2, 2.0), number(0.2, 2.0)];
                square([x, y], [x + w, y + h])
            })
            .collect();
        let bounds = [[-2.0; 2], [13.0; 2]];
        let corners = |ring: &[[f64; 2]; 4]| ring.map(Point::from);
        let obstacles = rings.iter().map(|ring| Obstacle::polygon(&corners(ring)).expect("a polygon"));
        let world = World::new(Some(Aabb::of(bounds[0].into(), bounds[1].into())), obstacles);
        let ends = [[-1.0, -1.0], [12.0, 12.0]];
        let query = Query::new("across", ends[0], ends[1]);
        let robot = DiscRobot::new(distance).expect("a radius");
        let scenario = Scenario::new("blocks", world, robot, [query]).expect("a scenario");
        let expected = optimum(&scenario, None, MetricOptions::default()).expect("an optimum").length;
        let parts: Vec<_> = rings.iter().map(|ring| part(Kind::Outline, ring)).collect();
        for bounds in [Some(bounds), None] {
            for many_queries in [false, true] {
                let map = map(&parts, &Settings { distance, bounds, many_queries, ..PLANAR });
                assert_eq!(map.tangents().is_some(), many_queries);
                close(found(&map, ends[0], ends[1]).length, expected.expect("a path"), 1e-10);
            }
        }
    }
}

#[test]
fn degrees_are_measured_on_the_ellipsoid() {
    let nothing = map(&[], &Settings::default());
    // From Flinders Peak to Buninyong, of Geoscience Australia: 54 972.271 m along the geodesic.
    let [flinders, buninyong] = [[144.424_867_89, -37.951_033_42], [143.926_495_53, -37.652_821_14]];
    let way = found(&nothing, flinders, buninyong);
    close(way.length, 54_972.271, 3e-6);
    assert!(way.distortion > 1e-3 && way.distortion < 3e-3, "{}", way.distortion);
    // A meridian from 50 to 52 degrees; the length is that by Simpson's rule with 2000 steps.
    close(found(&nothing, [10.0, 50.0], [10.0, 52.0]).length, 222_496.508, 1e-8);
    let fault = nothing.query([0.0, 0.0], [0.0, 60.0]).expect_err("a fault");
    assert_eq!((fault.code().as_str(), fault.subject()), ("out-of-range", Subject::Start));
}

#[test]
fn what_is_no_map_is_refused() {
    let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
    let (outline, hole, outside) =
        (square([0.0; 2], [10.0; 2]), square([2.0; 2], [8.0; 2]), square([20.0; 2], [21.0; 2]));
    let outlined = |kind, ring| [part(Kind::Outline, &outline), part(Kind::Hole, &hole), part(kind, ring)];
    let degenerate = |part| ("degenerate-polygon", Subject::Part(part));
    assert_eq!(refused(&[part(Kind::Points, &[[0.0; 2]]), part(Kind::Outline, &bow)], &PLANAR), degenerate(1));
    assert_eq!(refused(&[part(Kind::Outline, &[])], &PLANAR), degenerate(0));
    assert_eq!(refused(&outlined(Kind::Hole, &outside), &PLANAR), degenerate(2));
    assert_eq!(refused(&outlined(Kind::Outline, &[[0.0; 2]; 5]), &PLANAR), degenerate(2));
    assert_eq!(refused(&[part(Kind::Line, &[[1.0; 2]; 2])], &PLANAR), ("degenerate-wall", Subject::Part(0)));
    assert_eq!(refused(&[part(Kind::Hole, &outline)], &PLANAR), ("unsupported", Subject::Part(0)));
    assert_eq!(refused(&[part(Kind::Points, &[[f64::NAN, 0.0]])], &PLANAR), ("not-finite", Subject::Part(0)));
    let degrees = Settings::default();
    assert_eq!(refused(&[part(Kind::Points, &[[181.0, 0.0]])], &degrees), ("out-of-range", Subject::Part(0)));
    assert_eq!(refused(&[part(Kind::Points, &[[0.0, 20.0], [0.0, 70.0]])], &degrees), ("out-of-range", Subject::Map));
    for distance in [-1.0, 1e7] {
        assert_eq!(refused(&[], &Settings { distance, ..PLANAR }), ("out-of-range", Subject::Distance));
    }
    assert_eq!(refused(&[], &Settings { bounds: Some([[0.0; 2], [1.0, 0.0]]), ..PLANAR }).1, Subject::Bounds);
    let many = vec![[0.0; 2]; planarium_shortest::MAX_POSITIONS + 1];
    assert_eq!(refused(&[part(Kind::Points, &many)], &PLANAR), ("too-large", Subject::Map));
}
