//! Bodies and cars at the limits of what is accepted: corners in one line, turning circles as wide as the world or a grain of
//! dust, results that lie. On native, Node and Chrome alike.

#[path = "common/bodies.rs"]
mod bodies;
mod common;

use bodies::*;
use common::seeds;
use planarium::collision::BodyCollision;
use planarium::geometry::{Disc, Polygon};
use planarium::random::{Random, Stream};
use planarium::scenario::Obstacle;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn corners_in_one_line_or_all_but_change_nothing() {
    let mut random = Random::new(6, Stream::Samples);
    let mut accepted = 0;
    for number in 0..seeds(30) {
        let around = [p(-1.0, -0.5), p(1.0, -0.5), p(1.0, 0.5), p(-1.0, 0.5)];
        let turn = if number % 2 == 0 { 0.0 } else { 6.0 * random.uniform() };
        let (sin, cos) = libm::sincos(turn);
        let corners: Vec<_> = (0..16)
            .map(|i| {
                let (a, b) = (around[i / 4], around[(i / 4 + 1) % 4]);
                let at = a + (b - a) * (0.25 * (i % 4) as f64);
                p(at.x * cos - at.y * sin, at.x * sin + at.y * cos)
            })
            .collect();
        let hull: Vec<_> = corners.iter().copied().step_by(4).collect();
        let (Ok(body), Ok(plain)) = (Polygon::new(&corners), Polygon::new(&hull)) else { continue };
        let disc = |_| {
            let center = p(10.0 * random.uniform(), 10.0 * random.uniform());
            Obstacle::Disc(Disc { center, radius: 0.05 + 0.3 * random.uniform() })
        };
        let discs = (0..4).map(disc).collect();
        let world = world([0.0, 0.0], [10.0, 10.0], discs);
        let [collision, same] = [&body, &plain].map(|body| BodyCollision::new(body, &world, 1e-2));
        for _ in 0..400 {
            let from = [10.0 * random.uniform(), 10.0 * random.uniform(), 6.0 * random.uniform()];
            let motion = random_motion(&mut random, from, 1.0);
            if collision.is_motion_free(&motion) {
                accepted += 1;
                let is_touching = |i| !same.contacts(&motion.at(f64::from(i) / 400.0)).is_empty();
                assert!(!(0..=400).any(is_touching), "world {number}: {motion:?}");
            }
        }
    }
    assert!(accepted > 20 * seeds(30), "{accepted}");
}
