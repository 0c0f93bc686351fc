//! What corners and ends of a stroke have beyond a wall with round joints and ends.

use super::affine::{P3, norm};
use super::{Cap, Path, Piece, Stroke};

/// The part of a mitred corner that reaches beyond a disc: the corner of the path, where the edges of the two strokes
/// begin, and the tip between them.
pub type Tip = [P3; 4];

/// The mitred corners of a path.
pub fn tips(path: &Path, stroke: &Stroke) -> Vec<Tip> {
    let Some(limit) = stroke.miter else { return Vec::new() };
    let mut turns: Vec<(P3, [f64; 2], [f64; 2])> = directions(path);
    if path.closed && !turns.is_empty() {
        turns.push(turns[0]);
    }
    let corner = |pair: &[(P3, [f64; 2], [f64; 2])]| {
        let [(_, _, arriving), (at, leaving, _)] = pair else { return None };
        tip(*at, *arriving, *leaving, stroke.width / 2.0, limit)
    };
    turns.windows(2).filter_map(corner).collect()
}

fn tip(at: P3, [ax, ay]: [f64; 2], [bx, by]: [f64; 2], half: f64, limit: f64) -> Option<Tip> {
    let (cross, dot) = (ax * by - ay * bx, ax * bx + ay * by);
    // The cosine of half the turn; the tip is as much farther than the edge.
    let cosine = ((1.0 + dot) / 2.0).max(0.0).sqrt();
    if cross == 0.0 || cosine == 0.0 || 1.0 / cosine > limit {
        return None;
    }
    let side = -cross.signum();
    let beside = |by: [f64; 2]| [at[0] + side * half * by[0], at[1] + side * half * by[1], at[2]];
    let reach = |a: f64, b: f64| (a + b) / (2.0 * cosine * cosine);
    let (before, after) = ([-ay, ax], [-by, bx]);
    Some([at, beside(before), beside([reach(before[0], after[0]), reach(before[1], after[1])]), beside(after)])
}

/// Where square ends of an open path reach: half the width beyond its ends.
pub fn square_ends(path: &Path, stroke: &Stroke) -> Option<[P3; 2]> {
    if stroke.cap != Cap::Square || path.closed {
        return None;
    }
    let all = directions(path);
    let ((start, [dx, dy], _), (_, _, [ex, ey])) = (all.first()?, all.last()?);
    let (half, end) = (stroke.width / 2.0, path.end());
    Some([[start[0] - half * dx, start[1] - half * dy, start[2]], [end[0] + half * ex, end[1] + half * ey, end[2]]])
}

/// Where each piece that has a length starts, and the directions in which it leaves and arrives.
fn directions(path: &Path) -> Vec<(P3, [f64; 2], [f64; 2])> {
    let mut all = Vec::with_capacity(path.pieces.len() + 1);
    let mut from = path.start;
    let mut add = |points: &mut dyn DoubleEndedIterator<Item = P3>| {
        let points: Vec<P3> = points.collect();
        let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return };
        let leaving = points.iter().find_map(|&p| direction(first, p));
        let arriving = points.iter().rev().find_map(|&p| direction(p, last));
        if let (Some(leaving), Some(arriving)) = (leaving, arriving) {
            all.push((first, leaving, arriving));
        }
    };
    for piece in &path.pieces {
        match piece {
            Piece::Line(to) => add(&mut [from, *to].into_iter()),
            Piece::Curve(curve) => add(&mut curve.0.iter().map(|control| control.0)),
        }
        from = piece.end();
    }
    if path.closed {
        add(&mut [from, path.start].into_iter());
    }
    all
}

fn direction(from: P3, to: P3) -> Option<[f64; 2]> {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let length = norm([x, y]);
    (length > 0.0).then(|| [x / length, y / length])
}
