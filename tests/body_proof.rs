//! The proof law for bodies and cars: no accepted motion of a body touches an obstacle, however thin, nor leaves the bounds; nothing
//! with clearance to spare is refused.

use crate::common::bodies::*;
use crate::common::seeds;
use planarium::collision::{BodyCollision, BodyMotion};
use planarium::geometry::{Aabb, Disc, Polygon};
use planarium::problem::Touched;
use planarium::random::{Random, Stream};
use planarium::scenario::Obstacle;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// The tolerance of a collision made with this fraction, as long as that is far above the slack.
const FRACTION: f64 = 1e-4;

#[wasm_bindgen_test(unsupported = test)]
fn in_any_world_the_fast_proof_accepts_what_distances_prove_and_nothing_that_touches() {
    let mut random = Random::new(1, Stream::Samples);
    let (mut accepted, mut refused, mut beyond, mut clear, mut all) = ([0; 2], [0; 2], 0, 0, 0);
    for number in 0..seeds(250) {
        let (body, world, scale) = random_world(&mut random);
        let collision = BodyCollision::new(&body, &world, FRACTION);
        let (tau, eta) = (FRACTION * 2.0 * scale, 1e-12 * (2.0 * scale + body.reach()));
        for _ in 0..120 {
            let from = random_placement(&mut random, scale);
            assert_eq!(collision.is_free(&from), collision.contacts(&from).is_empty(), "world {number}: {from:?}");
            if !collision.is_free(&from) {
                continue;
            }
            let motion = random_motion(&mut random, from, scale);
            let (fast, slow) = (collision.is_motion_free(&motion), collision.first_hit_by_distances(&motion).is_none());
            // Refused are only what the distances refuse too: motions that come within tau of something.
            assert!(fast || !slow, "world {number}: refused, though distances prove it free: {motion:?}");
            let hit = collision.first_hit(&motion);
            assert_eq!(fast, hit.is_none(), "world {number}: {motion:?}");
            let steps = 1 + random.below(400) as u32;
            let free = hit.map_or(steps, |hit| (hit * f64::from(steps)) as u32);
            assert_eq!(collision.free_steps(&motion, steps), free, "world {number}: {motion:?}");
            let samples = if fast && !slow { 2000 } else { 40 };
            let mut room = f64::INFINITY;
            for i in 0..=samples {
                // All of an accepted motion, and of others what lies before the hit.
                let q = motion.at(hit.unwrap_or(1.0) * f64::from(i) / f64::from(samples));
                let is_touching = !collision.contacts(&q).is_empty();
                assert_eq!(collision.is_free(&q), !is_touching, "world {number}: {q:?}");
                assert!(!is_touching, "world {number}: {motion:?} touches at {q:?}");
                assert!(!touches(&body, &world, &q), "world {number}: {motion:?} touches at {q:?}");
                room = room.min(collision.clearance(&q)).min(collision.depth(&q));
            }
            if let Some(hit) = hit {
                // What is refused is near: an interval no longer than twice the tolerance, and no farther from contact.
                let q = motion.at(hit);
                let room = collision.clearance(&q).min(collision.depth(&q));
                assert!(room <= 2.0 * tau + 2.0 * eta, "world {number}: {motion:?} refused at {q:?}, {room} away");
            } else if !slow {
                // The sliver between both proofs is as wide as the tolerance; samples are 2000 an edge.
                let spacing = 0.01 * scale;
                assert!(room <= tau + spacing, "world {number}: {motion:?} proven by lines alone, {room} away");
                beyond += 1;
            }
            // No contact on the way is missed by the boxes that decide what a changed world leaves as it was.
            let boxes: Vec<Aabb> = world.obstacles.iter().map(Obstacle::aabb).collect();
            for i in 0..=10 {
                for contact in collision.contacts(&motion.at(f64::from(i) / 10.0)) {
                    let Touched::Obstacle(obstacle) = contact.with else { continue };
                    assert!(collision.may_meet(&motion, &boxes[obstacle..=obstacle]), "world {number}: {motion:?}");
                }
            }
            clear += boxes.iter().filter(|one| !collision.may_meet(&motion, std::slice::from_ref(*one))).count();
            all += boxes.len();
            let is_arc = usize::from(matches!(motion, BodyMotion::Arc { .. }));
            accepted[is_arc] += u32::from(fast);
            refused[is_arc] += u32::from(!fast);
        }
    }
    let enough = 3 * seeds(250) as u32;
    assert!(accepted.iter().chain(&refused).all(|&count| count > enough), "{accepted:?} and {refused:?}");
    assert!(beyond * 100 <= accepted[0] + accepted[1], "{beyond} of {accepted:?} only by separating lines");
    assert!(clear * 2 > all, "{clear} of {all} boxes are never met");
}

#[wasm_bindgen_test(unsupported = test)]
fn no_accepted_motion_is_refuted_by_two_thousand_samples() {
    let mut random = Random::new(2, Stream::Samples);
    let mut accepted = 0;
    for number in 0..seeds(60) {
        let (body, world, scale) = random_world(&mut random);
        let collision = BodyCollision::new(&body, &world, FRACTION).finest();
        for _ in 0..60 {
            let from = random_placement(&mut random, scale);
            let motion = random_motion(&mut random, from, scale);
            if collision.is_free(&from) && collision.is_motion_free(&motion) {
                accepted += 1;
                for i in 0..=2000 {
                    let q = motion.at(f64::from(i) / 2000.0);
                    let is_free = collision.is_free(&q) && !touches(&body, &world, &q);
                    assert!(is_free, "world {number}: {motion:?} at {i} of 2000");
                }
            }
        }
    }
    assert!(accepted > 2 * seeds(60), "{accepted}");
}

/// Distances by parry, of triangles: the polygons it holds are convex.
#[cfg(not(target_arch = "wasm32"))]
mod parry {
    use super::*;
    use parry2d_f64::math::{Pose, Vector};
    use parry2d_f64::query;
    use parry2d_f64::shape::{Ball, Shape, Triangle};
    use planarium::geometry::triangles;

    fn triangles_of(polygon: &Polygon) -> Vec<Triangle> {
        let at = |i: u32| {
            let p = polygon.vertices()[i as usize];
            Vector::new(p.x, p.y)
        };
        triangles(polygon).into_iter().map(|[a, b, c]| Triangle::new(at(a), at(b), at(c))).collect()
    }

    #[test]
    fn clearance_and_proof_agree_with_parry() {
        let mut random = Random::new(3, Stream::Samples);
        let (mut apart, mut touching, mut accepted) = (0, 0, 0);
        for number in 0..200 {
            let (body, world, scale) = random_world(&mut random);
            if scale != 1.0 {
                continue;
            }
            let collision = BodyCollision::new(&body, &world, FRACTION);
            let parts = triangles_of(&body);
            let clearance = |q: &[f64; 3]| {
                let at = Pose::new(Vector::new(q[0], q[1]), q[2]);
                let mut least = f64::INFINITY;
                for part in &parts {
                    let mut offer = |to: &dyn Shape, place: &Pose| {
                        least = least.min(query::distance(&at, part, place, to).expect("parry has this pair").distance);
                    };
                    for obstacle in world.obstacles.iter() {
                        match obstacle {
                            Obstacle::Disc(disc) => {
                                let place = Pose::new(Vector::new(disc.center.x, disc.center.y), 0.0);
                                offer(&Ball::new(disc.radius), &place);
                            }
                            Obstacle::Polygon(polygon) => {
                                triangles_of(polygon).iter().for_each(|t| offer(t, &Pose::identity()));
                            }
                            _ => panic!("random obstacles are discs and polygons"),
                        }
                    }
                }
                least
            };
            for _ in 0..10 {
                let q = random_placement(&mut random, scale);
                let (expected, found) = (clearance(&q), collision.clearance(&q).max(0.0));
                let is_same = expected == found || (expected - found).abs() < 1e-6;
                assert!(is_same, "world {number}: {found} is not {expected} at {q:?}");
                apart += u32::from(found > 0.0);
                touching += u32::from(found == 0.0);
                let motion = random_motion(&mut random, q, scale);
                if collision.is_motion_free(&motion) {
                    accepted += 1;
                    for i in 0..=50 {
                        let q = motion.at(f64::from(i) / 50.0);
                        assert!(clearance(&q) > 0.0, "world {number}: {motion:?} at {i} of 50");
                    }
                }
            }
        }
        assert!(apart > 100 && touching > 100 && accepted > 50, "{apart} {touching} {accepted}");
    }
}

// ---- What bodies do ----

/// A body in a box of side 4 among obstacles.
fn in_box(body: &Polygon, obstacles: Vec<Obstacle>) -> BodyCollision {
    BodyCollision::new(body, &world([0.0, 0.0], [4.0, 4.0], obstacles), FRACTION)
}

#[wasm_bindgen_test(unsupported = test)]
fn a_body_may_slide_along_the_bounds_and_not_along_an_obstacle() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let low = Obstacle::Polygon(rectangle([1.5, 0.0], [2.5, 0.5]));
    let collision = BodyCollision::new(&body, &world([0.0, 0.0], [4.0, 2.0], vec![low]), FRACTION);
    assert!(collision.is_free(&[0.2, 0.1, 0.0]), "in the corner of the bounds");
    assert!(collision.is_free(&[0.1, 0.2, FRAC_PI_2]), "in the corner, turned");
    assert!(!collision.is_free(&[0.19999, 0.1, 0.0]), "beyond the bounds");
    assert_eq!(collision.contacts(&[0.1, 0.1, 0.0])[0].with, Touched::Bounds);
    for (what, motion, is_free) in [
        ("sliding along the lower bound", straight([0.2, 0.1, 0.0], [1.29, 0.1, 0.0]), true),
        ("sliding along the upper bound", straight([0.2, 1.9, 0.0], [3.8, 1.9, 0.0]), true),
        ("driving along the upper bound", arc([0.2, 1.9, 0.0], 1.0, 0.0, 3.6), true),
        ("and backward", arc([3.8, 1.9, 0.0], -2.0, 0.0, 1.8), true),
        ("along the left bound", straight([0.1, 0.2, FRAC_PI_2], [0.1, 1.8, FRAC_PI_2]), true),
        ("out of the bounds at the end", straight([0.2, 1.9, 0.0], [3.9, 1.9, 0.0]), false),
        ("up to contact with an obstacle", straight([0.2, 0.1, 0.0], [1.3, 0.1, 0.0]), false),
        ("sliding along an obstacle", straight([1.8, 0.6, 0.0], [2.2, 0.6, 0.0]), false),
        ("sliding just above it", straight([0.2, 0.601, 0.0], [3.8, 0.601, 0.0]), true),
        ("away from the corner", straight([0.2, 0.1, 0.0], [0.5, 1.0, 0.0]), true),
    ] {
        assert_eq!(collision.is_motion_free(&motion), is_free, "{what}");
    }
    assert_eq!(collision.contacts(&[2.0, 0.6, 0.0]), collision.contacts(&[2.0, 0.4, 0.0]), "contact is collision");
    let hit = collision.first_hit(&straight([0.2, 1.0, 0.0], [7.8, 1.0, 0.0])).expect("it leaves the bounds");
    assert!(hit <= 3.6 / 7.6 && hit > 3.6 / 7.6 - 1e-3, "{hit}");
}

#[wasm_bindgen_test(unsupported = test)]
fn what_holds_the_other_wholly_touches_it() {
    let (large, small) = (rectangle([-1.0, -1.0], [1.0, 1.0]), rectangle([-0.05, -0.05], [0.05, 0.05]));
    for inner in [
        Obstacle::Polygon(rectangle([2.0, 2.0], [2.1, 2.1])),
        Obstacle::Disc(Disc { center: p(2.0, 2.0), radius: 0.1 }),
    ] {
        let collision = in_box(&large, vec![inner]);
        assert!(!collision.is_free(&[2.0, 2.0, 0.7]), "a body that holds an obstacle");
        assert_eq!(collision.clearance(&[2.0, 2.0, 0.7]).max(0.0), 0.0);
        assert!(!collision.is_motion_free(&straight([2.0, 2.0, 0.7], [2.1, 2.0, 0.7])));
        assert!(!collision.is_motion_free(&arc([2.0, 2.0, 0.7], 0.0, 1.0, 1.0)), "turning around it");
        assert_eq!(collision.first_hit(&straight([2.0, 2.0, 0.7], [2.1, 2.0, 0.7])), Some(0.0));
    }
    for outer in [
        Obstacle::Polygon(rectangle([1.0, 1.0], [3.0, 3.0])),
        Obstacle::Disc(Disc { center: p(2.0, 2.0), radius: 1.0 }),
    ] {
        let collision = in_box(&small, vec![outer]);
        assert!(!collision.is_free(&[2.0, 2.0, 0.7]), "a body in an obstacle");
        assert!(!collision.is_motion_free(&straight([2.0, 2.0, 0.7], [2.1, 2.0, 0.7])));
        assert!(!collision.is_motion_free(&straight([0.5, 0.5, 0.0], [3.5, 3.5, 0.0])), "through it");
        assert!(collision.is_motion_free(&straight([0.5, 0.5, 0.0], [0.5, 3.5, 3.0])), "past it");
    }
    // In the opening of a U, and in that of a ring with a slit: not in contact.
    let u = Polygon::new(&drawn(p(2.0, 2.0), 0.0, &u_shape(1.0, 0.2))).expect("a U");
    let collision = in_box(&small, vec![Obstacle::Polygon(u.clone())]);
    assert!(collision.is_free(&[2.0, 2.0, 0.3]));
    assert!(collision.is_motion_free(&straight([2.0, 2.0, 0.3], [2.0, 3.5, 0.3])));
    assert!(!collision.is_motion_free(&straight([2.0, 2.0, 0.3], [0.5, 2.0, 0.3])));
    // The U as the body, a disc in its opening as the obstacle.
    let shape = Polygon::new(&drawn(p(0.0, 0.0), 0.0, &u_shape(1.0, 0.2))).expect("a U");
    let disc = Obstacle::Disc(Disc { center: p(2.0, 2.0), radius: 0.5 });
    let collision = in_box(&shape, vec![disc]);
    assert!(collision.is_free(&[2.0, 2.0, 0.0]));
    assert!(collision.is_motion_free(&straight([2.0, 2.0, 0.0], [2.0, 1.0, 0.0])), "out of the opening");
    assert!(collision.is_motion_free(&arc([2.0, 2.0, 0.0], 0.0, 1.0, 50.0)), "turning around the disc");
    assert!(!collision.is_motion_free(&straight([2.0, 2.0, 0.0], [2.0, 2.9, 0.0])));
}

#[wasm_bindgen_test(unsupported = test)]
fn turning_in_place_is_refused_where_a_corner_hits_something_thin() {
    // Corners describe a circle of radius 0.5 about (2, 2).
    let body = rectangle([-0.4, -0.3], [0.4, 0.3]);
    for thickness in [1e-1, 1e-3, 1e-6] {
        for (gap, is_free) in [(1e-2, true), (1e-3, true), (-1e-3, false), (-1e-2, false)] {
            let wall = rectangle([2.5 + gap, 1.99], [2.5 + gap + thickness, 2.01]);
            let collision = in_box(&body, vec![Obstacle::Polygon(wall)]);
            let at = [2.0, 2.0, 0.0];
            assert!(collision.is_free(&at));
            for motion in [
                straight(at, [2.0, 2.0, 3.0]),
                straight(at, [2.0, 2.0, -3.0]),
                arc(at, 0.0, 1.0, 3.0),
                arc(at, 0.0, -0.5, 6.0),
                arc(at, 0.0, 10.0, 100.0),
            ] {
                let what = format!("{gap} from a wall {thickness} thick: {motion:?}");
                assert_eq!(collision.is_motion_free(&motion), is_free, "{what}");
                assert_eq!(collision.first_hit_by_distances(&motion).is_none(), is_free, "{what}");
                if let Some(hit) = collision.first_hit(&motion) {
                    let q = motion.at(hit);
                    assert!(collision.is_free(&q) && collision.clearance(&q) < 1e-3, "{hit} of {motion:?}");
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_motion_through_a_thin_wall_is_refused_and_past_it_is_not() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    for thickness in [0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let wall = rectangle([2.0 - 0.5 * thickness, 1.0], [2.0 + 0.5 * thickness, 3.0]);
        let collision = in_box(&body, vec![Obstacle::Polygon(wall)]);
        assert!(!collision.is_motion_free(&straight([1.0, 2.0, 0.0], [3.0, 2.0, 1.0])));
        assert!(!collision.is_motion_free(&arc([1.0, 2.0, 0.3], 1.0, -0.3, 2.0)));
        assert!(collision.is_motion_free(&straight([1.0, 3.5, 0.0], [3.0, 3.5, 1.0])));
        // Round the wall's end: half a circle of radius 1 about (2, 3) from one side to the other.
        assert!(collision.is_motion_free(&arc([1.0, 2.5, FRAC_PI_2], 1.0, -1.0, PI)));
        let hit = collision.first_hit(&straight([1.0, 2.0, 0.0], [3.0, 2.0, 0.0])).expect("it hits the wall");
        let contact = (1.0 - 0.5 * thickness - 0.2) / 2.0;
        assert!(hit <= contact && hit > contact - 1e-3, "{hit} is not {contact}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_narrow_gap_is_passed_where_the_body_fits() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let bounded = |obstacles| BodyCollision::new(&body, &world([0.0, 0.0], [4.0, 3.0], obstacles), FRACTION);
    for room in [1e-2, 1e-4, 1e-6, 1e-8] {
        let (below, above) = (rectangle([1.5, 0.0], [2.5, 1.0]), rectangle([1.5, 1.2 + 2.0 * room], [2.5, 3.0]));
        let collision = bounded([below, above].map(Obstacle::Polygon).to_vec());
        let (from, to) = ([1.0, 1.1 + room, 0.0], [3.0, 1.1 + room, 0.0]);
        // Nothing turns, so that separating lines hold for the whole interval, however near.
        for motion in [straight(from, to), arc(from, 0.5, 0.0, 4.0)] {
            assert!(collision.is_motion_free(&motion), "{room} to either side");
            assert!(bounded(vec![]).is_motion_free(&motion));
        }
        assert!(!collision.is_motion_free(&straight(from, [to[0], to[1], 1.0])), "turning in the gap");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tight_start_can_be_left_with_a_fitted_tolerance() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    for room in [1e-3, 1e-5, 1e-7, 1e-9] {
        let wall = Obstacle::Polygon(rectangle([0.0, 0.5], [4.0, 1.0 - room]));
        let world = world([0.0, 0.0], [4.0, 4.0], vec![wall]);
        let (start, goal) = ([2.0, 1.1, 0.0], [2.0, 3.0, 3.0]);
        let collision = BodyCollision::new(&body, &world, FRACTION).fitted(&start, &goal);
        assert!((collision.clearance(&start) - room).abs() < 1e-15);
        assert!(collision.is_motion_free(&straight(start, goal)), "{room} above a wall");
        assert!(collision.is_motion_free(&straight(goal, start)), "{room} above a wall");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn long_motions_among_many_obstacles_are_halved_first_with_the_same_verdict() {
    let mut random = Random::new(8, Stream::Samples);
    let (mut accepted, mut refused) = ([0; 2], [0; 2]);
    for number in 0..seeds(10) {
        let place = |i: usize| (1.0 + 2.0 * (i % 12) as f64, 1.0 + 2.0 * (i / 12) as f64);
        let mut stone = |i: usize| {
            let ((x, y), size) = (place(i), 0.1 + 0.3 * random.uniform());
            let center = p(x + 0.4 * random.uniform(), y + 0.4 * random.uniform());
            match i % 3 {
                0 => Obstacle::Disc(Disc { center, radius: size }),
                1 => Polygon::new(&round(center, size, 6, size)).expect("a polygon").into(),
                _ => Polygon::new(&star(center, size, 5, size)).expect("a star").into(),
            }
        };
        let world = world([0.0; 2], [24.0; 2], (0..144).map(&mut stone).collect());
        // Up to four and up to seven times.
        let side = if number % 2 == 0 { 0.15 } else { 0.015 };
        let body = rectangle([-side, -side / 3.0], [side, side / 3.0]);
        let collision = BodyCollision::new(&body, &world, FRACTION);
        for i in 0..400 {
            let from = [24.0 * random.uniform(), 24.0 * random.uniform(), TAU * random.uniform()];
            let (length, turn) = (24.0 * random.uniform().powi(2), TAU * random.uniform());
            let (sin, cos) = libm::sincos(if i % 4 < 2 { turn } else { FRAC_PI_2 * f64::from(i % 4) });
            let is_arc = i % 2;
            let motion = match is_arc {
                0 => straight(from, [from[0] + length * cos, from[1] + length * sin, from[2] + sin]),
                _ => arc(from, length, sin, 1.0),
            };
            let (fast, slow) = (collision.is_motion_free(&motion), collision.first_hit_by_distances(&motion).is_none());
            // The first hit is sought without halving first.
            assert_eq!(fast, collision.first_hit(&motion).is_none(), "{motion:?}");
            assert!(fast || !slow, "refused, though distances prove it free: {motion:?}");
            let touches = |i: i32| !collision.contacts(&motion.at(f64::from(i) / 200.0)).is_empty();
            assert!(!fast || !(0..=200).any(touches), "{motion:?} touches");
            if length > 5.0 {
                [&mut refused, &mut accepted][usize::from(fast)][is_arc as usize] += 1;
            }
        }
    }
    let counts = [accepted, refused].concat();
    assert!(counts.iter().all(|&count| count > seeds(10) / 10 * 20), "{counts:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_motion_that_leads_nowhere_is_its_placement() {
    let mut random = Random::new(4, Stream::Samples);
    let mut counts = [0, 0];
    for _ in 0..seeds(50) {
        let (body, world, scale) = random_world(&mut random);
        let collision = BodyCollision::new(&body, &world, FRACTION);
        for _ in 0..50 {
            let q = random_placement(&mut random, scale);
            for motion in [straight(q, q), arc(q, 0.0, 0.0, 1.0), arc(q, 1.0, 1.0, 0.0)] {
                let is_free = collision.is_free(&q);
                assert_eq!(collision.is_motion_free(&motion), is_free, "{motion:?}");
                assert_eq!(collision.first_hit(&motion), (!is_free).then_some(0.0), "{motion:?}");
                assert_eq!(collision.first_hit_by_distances(&motion).is_none(), is_free, "{motion:?}");
                counts[usize::from(is_free)] += 1;
            }
        }
    }
    assert!(counts.iter().all(|&count| count > 50 * seeds(50) / 50), "{counts:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn an_arc_of_many_turns_is_proven_by_its_first() {
    // A circle of radius 1 about (2, 2), driven by a body that reaches 0.2 to either side, round a disc and past a wall.
    let body = rectangle([-0.1, -0.2], [0.1, 0.2]);
    let inner = Obstacle::Disc(Disc { center: p(2.0, 2.0), radius: 0.79 });
    let outer = Obstacle::Polygon(rectangle([3.21, 1.0], [3.3, 3.0]));
    let free = BodyCollision::new(&body, &world([0.5, 0.5], [4.0, 3.5], vec![inner.clone(), outer.clone()]), FRACTION);
    for turns in [0.5, 1.0, 1.5, 10.0, 1591.0, 1e6] {
        for (speed, turn_rate) in [(1.0, 1.0), (-1.0, -1.0), (50.0, 50.0)] {
            let from = [3.0, 2.0, FRAC_PI_2];
            assert!(free.is_motion_free(&arc(from, speed, turn_rate, turns * TAU / turn_rate.abs())), "{turns} turns");
        }
    }
    // An obstacle at three quarters of a turn.
    let there = Obstacle::Polygon(rectangle([1.99, 0.8], [2.01, 0.85]));
    let blocked = BodyCollision::new(&body, &world([0.5, 0.5], [4.0, 3.5], vec![inner, outer, there]), FRACTION);
    for turns in [0.7, 1.0, 10.0, 1591.0] {
        let motion = arc([3.0, 2.0, FRAC_PI_2], 1.0, 1.0, turns * TAU);
        assert_eq!(blocked.is_motion_free(&motion), turns < 0.72, "{turns} turns");
        if let Some(hit) = blocked.first_hit(&motion) {
            assert!(hit * turns < 0.75 && hit * turns > 0.71, "{hit} of {turns} turns");
            assert!(blocked.is_free(&motion.at(hit)) && blocked.clearance(&motion.at(hit)) < 1e-3);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn nothing_beyond_reach_is_examined() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let obstacle = |i: u32| {
        let center = p(f64::from(i % 40) / 10.0, f64::from(i / 40) / 10.0);
        Obstacle::Disc(Disc { center, radius: 0.01 })
    };
    let is_far = |o: &Obstacle| {
        let middle = o.aabb();
        (middle.min.x - 2.0).abs().max((middle.min.y - 2.0).abs()) > 1.3
    };
    let obstacles = (0..1600).map(obstacle).filter(is_far).collect();
    let collision = in_box(&body, obstacles);
    assert!(collision.is_motion_free(&arc([2.0, 2.0, 0.0], 0.0, 3.0, 100.0)), "turning in place");
    assert!(collision.is_motion_free(&arc([3.0, 2.0, FRAC_PI_2], 1.0, 1.0, 100.0)), "round a circle");
    assert!(collision.is_motion_free(&straight([1.2, 1.2, 0.0], [2.8, 2.8, 3.0])));
    assert_eq!(collision.clearance_evaluations(), 0);
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_motions_are_refused_and_long_ones_are_cut_at_the_bounds() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let collision = in_box(&body, vec![]);
    let at = [2.0, 2.0, 0.0];
    let mut refused = vec![
        straight(at, [2.0, 2.0, 8.0]),              // More than a turn on a straight path.
        straight([2.0, 2.0, 2e4], [2.0, 2.0, 2e4]), // An angle too large to be accurate.
    ];
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for i in 0..3 {
            let mut off = at;
            off[i] = bad;
            assert_eq!(collision.first_hit(&straight(off, at)), Some(0.0));
            let delta = [off[0] - 2.0, off[1] - 2.0, off[2]];
            refused.extend([BodyMotion::Straight { from: at, delta }, arc(off, 1.0, 0.1, 1.0)]);
        }
        refused.extend([arc(at, bad, 0.1, 1.0), arc(at, 0.1, bad, 1.0), arc(at, 0.1, 0.1, bad)]);
    }
    assert!(refused.iter().all(|motion| !collision.is_motion_free(motion)));
    // As far as the bounds, whatever lies behind.
    assert_eq!(collision.first_hit(&straight(at, [1e200, 2.0, 0.0])), Some(0.0), "longer than its square can be");
    for length in [10.0, 100.0, 1e9, 1e100] {
        let hit = collision.first_hit(&straight(at, [2.0 + length, 2.0, 0.0])).expect("it leaves") * length;
        assert!(hit <= 1.8 && hit > 1.79, "{hit}");
        let hit = collision.first_hit(&arc(at, length, 1e-9 * length, 1.0)).expect("it leaves") * length;
        assert!(hit <= 1.8 && hit > 1.79, "{hit}");
    }
}
