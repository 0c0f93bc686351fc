//! Polygons against polygons, and their triangles and convex pieces: against exact arithmetic, areas and parry.

use crate::common::bodies::{border, p, polygon, random_star};
use crate::geometry::{exact_intersects, random, whole};
use parry2d_f64::math::Pose;
use parry2d_f64::query;
use planarium::geometry::{
    Point, Polygon, arc_pose, convex_pieces, distance_point_polygon, distance_polygon_polygon,
    intersects_polygon_polygon, orientation, triangles,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Twice the area of the corners in order.
fn doubled_area(corners: &[Point]) -> f64 {
    (0..corners.len())
        .map(|i| {
            let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
            a.x * b.y - b.x * a.y
        })
        .sum()
}

/// A comb, a spiral of right angles, a square with many corners on its sides, a needle.
fn special() -> Vec<Polygon> {
    let mut comb = vec![p(0.0, 0.0), p(20.0, 0.0)];
    for tooth in (0..10).rev() {
        let x = 2.0 * f64::from(tooth);
        comb.extend([p(x + 2.0, 3.0), p(x + 1.0, 1.0), p(x, 3.0)]);
    }
    comb.dedup();
    let spiral = [
        0.0, 0.0, 9.0, 0.0, 9.0, 9.0, 1.0, 9.0, 1.0, 3.0, 6.0, 3.0, 6.0, 6.0, 4.0, 6.0, 4.0, 5.0, 5.0, 5.0, 5.0, 4.0,
        2.0, 4.0, 2.0, 8.0, 8.0, 8.0, 8.0, 1.0, 0.0, 1.0,
    ];
    let mut square: Vec<Point> = (0..8).map(|i| p(f64::from(i), 0.0)).collect();
    square.extend((0..=8).map(|i| p(8.0, f64::from(i))));
    square.extend([p(4.0, 4.0), p(0.0, 8.0)]);
    square.extend((1..8).rev().map(|i| p(0.0, f64::from(i))));
    let needle = [[0.0, 0.0], [4.0, 1e-9], [8.0, 0.0], [4.0, 2e-9]];
    let [comb, square] = [comb, square].map(|corners| Polygon::new(&corners).expect("a simple polygon"));
    vec![comb, polygon(spiral.as_chunks().0), square, polygon(&needle)]
}

/// Ear clipping with every corner tried again against every vertex: O(n^3), and evidently right.
fn triangles_by_all_vertices(v: &[Point]) -> Vec<[u32; 3]> {
    let mut left: Vec<u32> = (0..v.len() as u32).collect();
    let (mut found, mut at) = (Vec::new(), 0);
    while left.len() > 3 {
        let n = left.len();
        let corner = |i: usize| [left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
        let is_ear = |&i: &usize| {
            let [a, b, c] = corner(i).map(|v_| v[v_ as usize]);
            let holds = |q: Point| [(a, b), (b, c), (c, a)].iter().all(|&(a, b)| orientation(a, b, q) >= 0.0);
            orientation(a, b, c) > 0.0 && left.iter().all(|k| corner(i).contains(k) || !holds(v[*k as usize]))
        };
        let ear = (0..n).map(|i| (at + i) % n).find(is_ear).expect("a simple polygon has ears");
        found.push(corner(ear));
        left.remove(ear);
        at = ear + 1;
    }
    found.push([left[0], left[1], left[2]]);
    found
}

#[wasm_bindgen_test(unsupported = test)]
fn triangles_are_those_of_a_search_through_all_vertices_and_cover_the_polygon() {
    let mut random = random(6);
    let mut polygons = special();
    polygons.extend((0..6000).map(|i| if i % 2 == 0 { whole(&mut random) } else { random_star(&mut random, 2.0) }));
    for polygon in &polygons {
        let v = polygon.vertices();
        let cut = triangles(polygon);
        assert_eq!(cut, triangles_by_all_vertices(v), "{polygon:?}");
        let corners = |t: &[u32; 3]| t.map(|i| v[i as usize]);
        assert!(cut.iter().map(corners).all(|[a, b, c]| orientation(a, b, c) > 0.0), "a flat triangle of {polygon:?}");
        let area: f64 = cut.iter().map(|t| doubled_area(&corners(t))).sum();
        let whole = doubled_area(v);
        assert!((area - whole).abs() <= 1e-13 * whole.abs() + 1e-20, "{area} of {whole}: {polygon:?}");
    }
}

/// Simple polygons of so many vertices whose ears are hard to find: a zigzag band, a comb of long slanted teeth, a spiral, a
/// gear, a staircase with collinear runs.
fn large(n: u32) -> Vec<(&'static str, Vec<Point>)> {
    let half = n / 2;
    let zigzag = |i: u32, low: f64| p(f64::from(i), low + f64::from(i % 2) * 5.0);
    let mut band: Vec<Point> = (0..half).map(|i| zigzag(i, 0.0)).collect();
    band.extend((0..half).rev().map(|i| zigzag(i, 1.0)));
    let mut comb: Vec<Point> =
        (0..n - 2).map(|i| if i % 2 == 0 { p(f64::from(i), 0.0) } else { p(f64::from(i) + 1e5, 1e5) }).collect();
    comb.extend([p(f64::from(n), -1.0), p(-1.0, -1.0)]);
    let spiral = |i: u32, gap: f64| {
        let angle = 0.01 * f64::from(i);
        let (sin, cos) = libm::sincos(angle);
        p((1.0 + angle + gap) * cos, (1.0 + angle + gap) * sin)
    };
    let mut coil: Vec<Point> = (0..half).map(|i| spiral(i, 0.0)).collect();
    coil.extend((0..half).rev().map(|i| spiral(i, 2.0)));
    let gear = (0..n)
        .map(|i| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(i) / f64::from(n));
            p((1.0 + f64::from(i % 2)) * cos, (1.0 + f64::from(i % 2)) * sin)
        })
        .collect();
    let mut stairs: Vec<Point> =
        (0..half).map(|i| p(f64::from(i / 4 * 2 + i % 4 / 2), f64::from(i / 4 * 2 + i % 4))).collect();
    stairs.extend([p(-1.0, f64::from(half)), p(-1.0, 0.0)]);
    stairs.reverse();
    vec![("band", band), ("comb", comb), ("coil", coil), ("gear", gear), ("stairs", stairs)]
}

#[wasm_bindgen_test(unsupported = test)]
fn large_polygons_are_cut_up_in_little_time() {
    for (name, corners) in large(20_000) {
        let polygon = Polygon::new(&corners).unwrap_or_else(|fault| panic!("{name}: {fault:?}"));
        let whole = doubled_area(polygon.vertices());
        let pieces = convex_pieces(&polygon);
        let area: f64 = pieces.iter().map(|piece| doubled_area(piece.vertices())).sum();
        assert!((area - whole).abs() <= 1e-9 * whole.abs(), "{name}: {area} of {whole}");
        // The points of a gear, and its middle.
        let most = pieces.iter().map(|piece| piece.vertices().len()).max();
        assert!(name != "gear" || (pieces.len(), most) == (10_001, Some(10_000)), "{} and {most:?}", pieces.len());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn convex_pieces_are_convex_and_cover_the_polygon() {
    let mut random = random(2);
    let mut polygons = special();
    polygons.extend((0..2000).map(|i| if i % 2 == 0 { whole(&mut random) } else { random_star(&mut random, 2.0) }));
    let (mut concave, mut merged) = (0, 0);
    for polygon in &polygons {
        let pieces = convex_pieces(polygon);
        let mut area = 0.0;
        for piece in &pieces {
            assert!(piece.is_convex() && piece.vertices().iter().all(|v| polygon.vertices().contains(v)), "{piece:?}");
            let again = Polygon::new(piece.vertices()).expect("a piece is a simple polygon");
            assert!(again.is_convex() && again == *piece, "{piece:?} of {polygon:?}");
            area += doubled_area(piece.vertices());
        }
        let whole = doubled_area(polygon.vertices());
        assert!((area - whole).abs() <= 1e-13 * whole.abs() + 1e-20, "{area} of {whole}: {polygon:?}");
        assert_eq!(polygon.is_convex(), pieces.len() == 1, "{polygon:?}");
        concave += u32::from(!polygon.is_convex());
        merged += u32::from(!polygon.is_convex() && pieces.len() < polygon.vertices().len() - 2);
        // With corners off straight edges there are as many reflex corners plus one at most.
        let v = polygon.vertices();
        let n = v.len();
        let reflex = (0..n).filter(|&i| orientation(v[i], v[(i + 1) % n], v[(i + 2) % n]) < 0.0).count();
        assert!(pieces.len() <= 2 * reflex + 1, "{} pieces for {reflex} reflex corners: {polygon:?}", pieces.len());
        let aabb = polygon.aabb();
        for _ in 0..30 {
            let at = p(
                aabb.min.x + (aabb.max.x - aabb.min.x) * random.uniform(),
                aabb.min.y + (aabb.max.y - aabb.min.y) * random.uniform(),
            );
            let held = pieces.iter().filter(|piece| piece.contains(at)).count();
            assert_eq!(held > 0, polygon.contains(at), "{at} in {polygon:?}");
            // Whole coordinates hit borders; others do not.
            assert!(held <= 1 || polygon.vertices().iter().all(|v| v.x == libm::floor(v.x)), "{at} in {polygon:?}");
        }
    }
    assert!(concave > 1000 && merged > 500, "{concave} concave, {merged} merged");
}

#[wasm_bindgen_test(unsupported = test)]
fn distances_between_polygons_agree_with_parry_and_with_those_of_their_pieces() {
    let mut random = random(3);
    let (mut touching, mut held) = (0, 0);
    for _ in 0..3000 {
        // Of very different sizes, so that one often holds the other.
        let sizes = [(); 2].map(|()| [0.3, 1.0, 3.0][random.below(3) as usize]);
        let [a, b] = sizes.map(|side| random_star(&mut random, side));
        let place = Pose::identity();
        let between = query::distance(&place, &border(&a), &place, &border(&b)).expect("parry has this pair").distance;
        let holds = a.contains(b.vertices()[0]) || b.contains(a.vertices()[0]);
        let found = distance_polygon_polygon(&a, &b);
        let expected = if holds { 0.0 } else { between };
        assert!((found - expected).abs() < 1e-12, "{found} is not {expected}: {a:?} {b:?}");
        assert_eq!(found, distance_polygon_polygon(&b, &a));
        assert_eq!(found == 0.0, intersects_polygon_polygon(&a, &b), "{a:?} {b:?}");
        let (pieces_of_a, pieces_of_b) = (convex_pieces(&a), convex_pieces(&b));
        let pairs = pieces_of_a.iter().flat_map(|a| pieces_of_b.iter().map(move |b| (a, b)));
        let by_pieces = pairs.map(|(a, b)| distance_polygon_polygon(a, b)).fold(f64::INFINITY, f64::min);
        assert!((found - by_pieces).abs() < 1e-12, "{found} is not {by_pieces}: {a:?} {b:?}");
        let point = b.vertices()[0];
        let to_point = distance_point_polygon(point, &a);
        assert!(to_point >= found && (to_point == 0.0) == a.contains(point));
        touching += u32::from(found == 0.0);
        held += u32::from(holds && between > 0.0);
    }
    assert!(touching > 300 && touching < 2700 && held > 20, "{touching} touching, {held} holding the other");
}

#[wasm_bindgen_test(unsupported = test)]
fn intersection_of_polygons_is_exact_on_whole_coordinates() {
    let mut random = random(4);
    let mut met = [0, 0];
    for _ in 0..5000 {
        let a = whole(&mut random);
        let by = p(random.below(12) as f64 - 6.0, random.below(12) as f64 - 6.0);
        let moved: Vec<Point> = whole(&mut random).vertices().iter().map(|v| p(v.x + by.x, v.y + by.y)).collect();
        let b = Polygon::new(&moved).expect("still simple");
        // If they meet, then in a vertex of one, or where two edges cross.
        let corner_held = a.vertices().iter().any(|&v| b.contains(v)) || b.vertices().iter().any(|&v| a.contains(v));
        let expected = corner_held || a.edges().any(|s| b.edges().any(|t| exact_intersects(&s, &t)));
        assert_eq!(intersects_polygon_polygon(&a, &b), expected, "{a:?} {b:?}");
        assert_eq!(distance_polygon_polygon(&a, &b) == 0.0, expected, "{a:?} {b:?}");
        met[usize::from(expected)] += 1;
    }
    assert!(met[0] > 500 && met[1] > 500, "{met:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_pose_along_an_arc_is_the_sum_of_many_small_steps() {
    let mut random = random(5);
    for turn_rate in [0.0, 1e-12, 1e-5, 0.3, -2.0, 40.0] {
        let mut draw = |size: f64| size * (2.0 * random.uniform() - 1.0);
        let from = [draw(5.0), draw(5.0), draw(4.0)];
        let (speed, time) = (draw(2.0), 1.7);
        let steps = 200_000;
        let [mut x, mut y, _] = from;
        for i in 0..steps {
            // The middle of each step: off by the square of its size.
            let at = time * (f64::from(i) + 0.5) / f64::from(steps);
            let (sin, cos) = libm::sincos(from[2] + turn_rate * at);
            x += speed * cos * time / f64::from(steps);
            y += speed * sin * time / f64::from(steps);
        }
        let found = arc_pose(from, speed, turn_rate, time);
        assert!((found[0] - x).abs() < 1e-8 && (found[1] - y).abs() < 1e-8, "{turn_rate}: {found:?} is not {x}, {y}");
        assert_eq!(found[2], from[2] + turn_rate * time);
        // Forth and back.
        let back = arc_pose(found, speed, turn_rate, -time);
        assert!((0..3).all(|i| (back[i] - from[i]).abs() < 1e-12 * (1.0 + turn_rate.abs())), "{back:?} {from:?}");
    }
    // Whole turns lead back; a quarter turn of radius 2 leads to the side.
    let round = arc_pose([1.0, 2.0, 0.5], 3.0, 1.5, 2.0 * std::f64::consts::TAU / 1.5);
    assert!((round[0] - 1.0).abs() < 1e-14 && (round[1] - 2.0).abs() < 1e-14);
    let quarter = arc_pose([0.0, 0.0, 0.0], 2.0, 1.0, std::f64::consts::FRAC_PI_2);
    assert!((quarter[0] - 2.0).abs() < 1e-15 && (quarter[1] - 2.0).abs() < 1e-15);
    assert_eq!(arc_pose([1.0, 2.0, 3.0], 0.0, 0.0, 5.0), [1.0, 2.0, 3.0]);
}
