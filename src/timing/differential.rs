//! A disc that drives along its heading and turns on the spot: straight edges forward, and between two of them a turn the short
//! way. Its configuration is (x, y, heading).

use super::curve::{Curve, norm};
use super::route::{Route, RoutePiece, turned};

/// How far the way may be from the heading, in radians: the rounding of a document.
const SLIP: f64 = 1e-8;

/// The corners of a disc's path as it drives them. It begins with the heading of the first edge, 0 if there is none; headings are
/// continuous. O(pieces).
pub(super) fn driven(Route { mut start, pieces: edges }: Route) -> Route {
    let mut pieces = Vec::with_capacity(2 * edges.len());
    let mut before = None;
    for RoutePiece { curve, ends, is_stop } in edges {
        let Curve::Straight { mut from, mut rate } = curve else { continue };
        let way = libm::atan2(rate[1], rate[0]);
        let last = before.unwrap_or(way);
        let heading = turned(way, last);
        if is_stop && before.is_some() {
            let turn = heading - last;
            let curve = Curve::Straight { from: vec![from[0], from[1], last], rate: vec![0.0, 0.0, turn] };
            pieces.push(RoutePiece { curve, ends: [turn.abs(); 2], is_stop });
        }
        before = Some(heading);
        from.push(heading);
        rate.push(0.0);
        pieces.push(RoutePiece { curve: Curve::Straight { from, rate }, ends, is_stop });
    }
    start.push(pieces.first().map_or(0.0, |piece| piece.curve.jet(0.0)[0][2]));
    Route { start, pieces }
}

/// Whether the robot drives forward along its heading, or turns on the spot.
pub(super) fn is_driven(curve: &Curve) -> bool {
    let Curve::Straight { from, rate } = curve else { return false };
    let (&[.., heading], &[x, y, turn]) = (&from[..], &rate[..]) else { return false };
    if x == 0.0 && y == 0.0 {
        return turn != 0.0;
    }
    let (sin, cos) = libm::sincos(heading);
    let (along, across) = (x * cos + y * sin, y * cos - x * sin);
    turn == 0.0 && along > 0.0 && across.abs() <= SLIP * norm(&[x, y])
}
