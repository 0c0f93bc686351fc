//! Plane geometry: simple polygons, containment and intersection against exact integer arithmetic, distances against parry.

use crate::common::bodies::{border, p, polygon, random_star};
use parry2d_f64::math::{Pose, Vector};
use parry2d_f64::query;
use parry2d_f64::shape;
use planarium::geometry::{
    Aabb, Disc, Point, Polygon, PolygonFault, Segment, distance_point_segment, distance_segment_polygon,
    distance_segment_segment, intersects_segment_polygon, intersects_segment_segment, orientation,
};
use planarium::random::{Random, Stream};
use wasm_bindgen_test::wasm_bindgen_test;

fn points(coordinates: &[[f64; 2]]) -> Vec<Point> {
    coordinates.iter().map(|&[x, y]| p(x, y)).collect()
}

pub fn random(seed: u64) -> Random {
    Random::new(seed, Stream::Samples)
}

/// An L: the unit square's lower half and the left half of its upper half.
const L: [[f64; 2]; 6] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];

// ---- What a polygon is ----

#[wasm_bindgen_test(unsupported = test)]
fn a_polygon_is_counter_clockwise_whatever_the_direction_of_its_corners() {
    let reversed: Vec<[f64; 2]> = L.iter().rev().copied().collect();
    for corners in [L.to_vec(), reversed] {
        let l = polygon(&corners);
        let doubled_area: f64 = l.edges().map(|e| e.a.x * e.b.y - e.b.x * e.a.y).sum();
        assert_eq!(doubled_area, 6.0);
        assert_eq!(l.vertices().len(), 6);
        assert!(!l.is_convex());
        assert_eq!(*l.aabb(), Aabb { min: p(0.0, 0.0), max: p(2.0, 2.0) });
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_polygon_may_be_closed_repeat_a_corner_and_have_corners_on_straight_edges() {
    let plain = polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]), plain);
    assert_eq!(polygon(&[[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-0.0, 0.0], [0.0, 0.0]]), plain);
    let square = polygon(&[[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.5]]);
    assert!(square.is_convex() && square.vertices().len() == 6);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_does_not_bound_a_simple_polygon_is_refused() {
    use PolygonFault::{SelfCrossing, TooFewVertices, ZeroArea};
    const CROSSING: PolygonFault = SelfCrossing(0, 4);
    let cases: [(&str, &[[f64; 2]], PolygonFault); 12] = [
        ("nothing", &[], TooFewVertices),
        ("two corners", &[[0.0, 0.0], [1.0, 0.0]], TooFewVertices),
        ("two distinct corners", &[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 0.0]], TooFewVertices),
        ("one corner", &[[1.0, 1.0], [1.0, 1.0], [1.0, 1.0]], TooFewVertices),
        ("three corners on a line", &[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]], ZeroArea),
        ("there and back", &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0]], ZeroArea),
        ("a bow tie", &[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]], SelfCrossing(0, 2)),
        ("a spike", &[[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [2.0, 0.0], [0.0, 1.0]], SelfCrossing(1, 2)),
        ("a corner on another edge", &[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]], SelfCrossing(0, 3)),
        ("two equal corners", &[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [2.0, 2.0], [1.0, 1.0], [0.0, 2.0]], CROSSING),
        ("edges that overlap", &[[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [2.0, 0.0], [1.0, 0.0], [0.0, 2.0]], CROSSING),
        // Named by the vertices as they were given.
        ("a crossing", &[[0.0, 0.0], [0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]], CROSSING),
    ];
    for (what, corners, fault) in cases {
        assert_eq!(Polygon::new(&points(corners)), Err(fault), "{what}");
    }
}

/// Simple polygons of small whole coordinates, with many corners on straight edges: areas are exact.
pub fn whole(random: &mut Random) -> Polygon {
    loop {
        let (n, side) = (3 + random.below(9), 3 + random.below(6));
        let corners: Vec<Point> = (0..n).map(|_| p(random.below(side) as f64, random.below(side) as f64)).collect();
        if let Ok(polygon) = Polygon::new(&corners) {
            return polygon;
        }
    }
}

/// The orientation of three points with whole coordinates up to 2^53, without rounding.
fn exact_orientation(a: Point, b: Point, c: Point) -> i128 {
    let [ax, ay, bx, by, cx, cy] = [a.x, a.y, b.x, b.y, c.x, c.y].map(|v| v as i128);
    ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).signum()
}

fn exact_on(a: Point, b: Point, c: Point) -> bool {
    exact_orientation(a, b, c) == 0 && Aabb::of(a, b).contains(c)
}

pub fn exact_intersects(s: &Segment, t: &Segment) -> bool {
    let straddles = |s: &Segment, t: &Segment| exact_orientation(s.a, s.b, t.a) * exact_orientation(s.a, s.b, t.b) < 0;
    (straddles(s, t) && straddles(t, s))
        || exact_on(s.a, s.b, t.a)
        || exact_on(s.a, s.b, t.b)
        || exact_on(t.a, t.b, s.a)
        || exact_on(t.a, t.b, s.b)
}

/// Whether the corners bound a simple polygon, by every pair of edges.
fn is_simple_by_pairs(v: &[Point]) -> bool {
    let n = v.len();
    let edge = |i: usize| Segment::new(v[i % n], v[(i + 1) % n]);
    (0..n).all(|i| {
        let (before, at, after) = (v[(i + n - 1) % n], v[i], v[(i + 1) % n]);
        let folds = exact_on(before, at, after) || exact_on(at, after, before);
        let crosses = |j: usize| exact_intersects(&edge(i), &edge(j));
        !folds && (i + 2..n).filter(|&j| (j + 1) % n != i).all(|j| !crosses(j))
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn the_sweep_finds_a_crossing_if_a_test_of_every_pair_does_and_the_pair_that_it_names_does_meet() {
    let mut random = random(1);
    let (mut simple, mut named) = (0, 0);
    for _ in 0..40_000 {
        let (n, side) = (3 + random.below(7) as usize, 2 + random.below(6));
        let corners: Vec<Point> = (0..n).map(|_| p(random.below(side) as f64, random.below(side) as f64)).collect();
        let mut distinct = corners.clone();
        distinct.dedup();
        if distinct.first() == distinct.last() {
            distinct.pop();
        }
        let (found, expected) = (Polygon::new(&corners), distinct.len() > 2 && is_simple_by_pairs(&distinct));
        assert_eq!(found.is_ok(), expected, "{corners:?}");
        simple += u32::from(expected);
        if let Ok(polygon) = &found {
            let (v, n) = (polygon.vertices(), polygon.vertices().len());
            let turns_left = |i: usize| exact_orientation(v[i], v[(i + 1) % n], v[(i + 2) % n]) >= 0;
            assert_eq!(polygon.is_convex(), (0..n).all(turns_left), "{corners:?}");
        }
        if let Err(PolygonFault::SelfCrossing(i, j)) = found {
            let edge = |i: usize| {
                let next = (1..n).map(|k| corners[(i + k) % n]).find(|&next| next != corners[i]);
                Segment::new(corners[i], next.expect("corners differ"))
            };
            assert!(i < j && exact_intersects(&edge(i), &edge(j)), "{i} {j} of {corners:?}");
            named += 1;
        }
    }
    assert!((1000..20_000).contains(&simple) && named > 3000, "{simple} simple, {named} named");
}

/// A zigzag whose edges all run from one side to the other: `2 n` + 2 corners.
fn zigzag(n: usize) -> Vec<[f64; 2]> {
    let mut corners: Vec<[f64; 2]> =
        (0..2 * n).map(|i| [if i % 2 == 0 { 0.0 } else { 1000.0 }, i as f64 / 8.0]).collect();
    corners.extend([[-1.0, 2.0 * n as f64], [-1.0, 0.0]]);
    corners
}

#[wasm_bindgen_test(unsupported = test)]
fn many_long_edges_side_by_side_do_not_stall() {
    let upright = zigzag(20_000);
    let sideways: Vec<[f64; 2]> = upright.iter().map(|&[x, y]| [y, x]).collect();
    let diagonal: Vec<[f64; 2]> = upright.iter().map(|&[x, y]| [x + y, x - y]).collect();
    for mut corners in [upright, sideways, diagonal] {
        assert_eq!(polygon(&corners).vertices().len(), 40_002);
        corners.swap(20_000, 20_010);
        assert!(matches!(Polygon::new(&points(&corners)), Err(PolygonFault::SelfCrossing(..))));
    }
}

// ---- Containment and intersection ----

#[wasm_bindgen_test(unsupported = test)]
fn a_polygon_contains_its_inside_and_its_border() {
    let l = polygon(&L);
    for inside in [[0.5, 0.5], [1.5, 0.5], [0.5, 1.5], [1.0, 1.0], [1.0, 1.5], [1.5, 1.0], [0.0, 0.0], [2.0, 0.5]] {
        assert!(l.contains(p(inside[0], inside[1])), "{inside:?}");
    }
    let just = f64::EPSILON;
    for outside in [[1.5, 1.5], [1.0 + just, 1.0 + just], [2.0 + 2.0 * just, 0.5], [-1.0, 1.0], [3.0, 1.0], [1.5, 2.0]]
    {
        assert!(!l.contains(p(outside[0], outside[1])), "{outside:?}");
    }
}

/// Whether the polygon contains the point, by its winding number in whole numbers.
fn exact_contains(polygon: &Polygon, at: Point) -> bool {
    let mut winding = 0;
    for edge in polygon.edges() {
        if exact_on(edge.a, edge.b, at) {
            return true;
        }
        let side = exact_orientation(edge.a, edge.b, at);
        if edge.a.y <= at.y && edge.b.y > at.y && side > 0 {
            winding += 1;
        }
        if edge.a.y > at.y && edge.b.y <= at.y && side < 0 {
            winding -= 1;
        }
    }
    winding != 0
}

#[wasm_bindgen_test(unsupported = test)]
fn containment_and_intersection_are_exact_on_whole_coordinates() {
    let mut random = random(3);
    let (mut contained, mut met) = (0, 0);
    for _ in 0..500 {
        let polygon = whole(&mut random);
        for x in 0..10 {
            for y in 0..10 {
                let at = p(f64::from(x), f64::from(y));
                assert_eq!(polygon.contains(at), exact_contains(&polygon, at), "{at} in {polygon:?}");
                contained += u32::from(polygon.contains(at));
                let to = p(random.below(10) as f64, random.below(10) as f64);
                let s = Segment::new(at, to);
                let expected = exact_contains(&polygon, at) || polygon.edges().any(|e| exact_intersects(&s, &e));
                assert_eq!(intersects_segment_polygon(&s, &polygon), expected, "{s:?} and {polygon:?}");
                assert_eq!(distance_segment_polygon(&s, &polygon) == 0.0, expected, "{s:?} and {polygon:?}");
                met += u32::from(expected);
            }
        }
    }
    assert!(contained > 3000 && met > 10_000 && met < 40_000, "{contained} contained, {met} met");
}

#[wasm_bindgen_test(unsupported = test)]
fn intersection_is_exact_where_segments_are_almost_on_one_line() {
    // Points within a few units of a long line, in whole numbers up to 2^52: products need 106 bits.
    let mut random = random(4);
    let mut met = [0, 0];
    for _ in 0..20_000 {
        let (dx, dy) = (1 + random.below(1 << 20), 1 + random.below(1 << 20));
        let mut near = || {
            let t = random.below(1 << 32);
            let mut off = || random.below(3) as f64 - 1.0;
            p((t * dx) as f64 + off(), (t * dy) as f64 + off())
        };
        let (s, t) = (Segment::new(near(), near()), Segment::new(near(), near()));
        assert_eq!(orientation(s.a, s.b, t.a).total_cmp(&0.0) as i128, exact_orientation(s.a, s.b, t.a), "{s:?} {t:?}");
        assert_eq!(intersects_segment_segment(&s, &t), exact_intersects(&s, &t), "{s:?} {t:?}");
        met[usize::from(exact_intersects(&s, &t))] += 1;
    }
    assert!(met[0] > 1000 && met[1] > 1000, "{met:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn segments_without_length_are_points() {
    let (s, at) = (Segment::new(p(0.0, 0.0), p(3.0, 1.0)), |x, y| Segment::new(p(x, y), p(x, y)));
    assert!(intersects_segment_segment(&s, &at(1.5, 0.5)));
    assert!(!intersects_segment_segment(&s, &at(1.5, 0.5 + f64::EPSILON)));
    assert!(!intersects_segment_segment(&s, &at(6.0, 2.0)));
    assert!(intersects_segment_segment(&at(1.0, 2.0), &at(1.0, 2.0)));
    assert!(!intersects_segment_segment(&at(1.0, 2.0), &at(1.0, 2.5)));
    assert_eq!(distance_segment_segment(&at(0.0, 0.0), &at(3.0, 4.0)), 5.0);
    assert_eq!(distance_point_segment(p(3.0, 4.0), &at(0.0, 0.0)), 5.0);
}

// ---- Distances ----

fn vector(p: Point) -> Vector {
    Vector::new(p.x, p.y)
}

fn to_parry(s: &Segment) -> shape::Segment {
    shape::Segment::new(vector(s.a), vector(s.b))
}

fn near(random: &mut Random, side: f64) -> Point {
    p(side * (random.uniform() - 0.5), side * (random.uniform() - 0.5))
}

#[wasm_bindgen_test(unsupported = test)]
fn distances_between_segments_agree_with_parry() {
    let mut random = random(5);
    let mut crossing = 0;
    for _ in 0..20_000 {
        let s = Segment::new(near(&mut random, 4.0), near(&mut random, 4.0));
        let t = Segment::new(near(&mut random, 4.0), near(&mut random, 4.0));
        let expected = query::details::distance_segment_segment(&Pose::identity(), &to_parry(&s), &to_parry(&t));
        let found = distance_segment_segment(&s, &t);
        assert!((found - expected).abs() < 1e-12, "{found} is not {expected}: {s:?} {t:?}");
        assert_eq!(found, distance_segment_segment(&t, &s));
        assert_eq!(found == 0.0, intersects_segment_segment(&s, &t), "{s:?} {t:?}");
        crossing += u32::from(found == 0.0);
    }
    assert!(crossing > 1000);
}

#[wasm_bindgen_test(unsupported = test)]
fn distances_to_polygons_agree_with_parry() {
    use parry2d_f64::query::PointQuery;
    let mut random = random(6);
    let (mut touching, mut concave) = (0, 0);
    for _ in 0..3000 {
        let polygon = random_star(&mut random, 2.0);
        concave += u32::from(!polygon.is_convex());
        let border = border(&polygon);
        let s = Segment::new(near(&mut random, 4.0), near(&mut random, 4.0));
        let place = Pose::identity();
        let to_border = query::distance(&place, &to_parry(&s), &place, &border).expect("parry has this pair").distance;
        let found = distance_segment_polygon(&s, &polygon);
        let expected = if polygon.contains(s.a) { 0.0 } else { to_border };
        assert!((found - expected).abs() < 1e-9, "{found} is not {expected}: {s:?} {polygon:?}");
        assert_eq!(found == 0.0, intersects_segment_polygon(&s, &polygon));
        touching += u32::from(found == 0.0);
        let point = Segment::new(s.a, s.a);
        let to_point = border.distance_to_local_point(vector(s.a), false);
        let expected = if polygon.contains(s.a) { 0.0 } else { to_point };
        assert!((distance_segment_polygon(&point, &polygon) - expected).abs() < 1e-12);
    }
    assert!(touching > 300 && touching < 2700 && concave > 2000, "{touching} touching, {concave} concave");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_distance_is_off_by_rounding_only_even_far_from_the_origin() {
    // A right-angled 3-4-5 set-up, moved to the edge of what a scenario may hold.
    let mut random = random(7);
    for _ in 0..1000 {
        let at = p(1e6 * (2.0 * random.uniform() - 1.0), 1e6 * (2.0 * random.uniform() - 1.0));
        let s = Segment::new(at, p(at.x + 4.0, at.y + 3.0));
        let found = distance_point_segment(p(at.x + 2.0 - 3.0, at.y + 1.5 + 4.0), &s);
        assert!((found - 5.0).abs() < 1e-9, "{found}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn boxes_hold_their_shapes() {
    let disc = Disc { center: p(1.0, 2.0), radius: 0.5 };
    let aabb = disc.aabb();
    assert_eq!(aabb, Aabb { min: p(0.5, 1.5), max: p(1.5, 2.5) });
    assert!(aabb.contains(p(1.5, 2.5)) && !aabb.contains(p(1.5, 2.6)));
    assert_eq!((aabb.depth(p(1.0, 2.0)), aabb.depth(p(0.25, 2.0))), (0.5, -0.25));
    assert!(aabb.intersects(&Aabb::of(p(1.5, 2.5), p(9.0, 9.0))));
    assert!(!aabb.intersects(&Aabb::of(p(1.6, 2.5), p(9.0, 9.0))));
    assert_eq!(Aabb::around([]), None);
    assert_eq!(Aabb::around([p(1.0, 5.0), p(3.0, 2.0)]).map(|b| b.longer_side()), Some(3.0));
}
