//! Basic shapes and path data as paths.

use super::lengths::wrong;
use crate::error::FormatError;
use crate::outline::{Affine, Curve, P3, Path, Piece, arc};
use std::f64::consts::TAU;
use svgtypes::{NumberListParser, PathParser, PathSegment};

fn at([x, y]: [f64; 2]) -> P3 {
    [x, y, 0.0]
}

/// An ellipse, and circles.
pub fn ellipse(center: [f64; 2], [rx, ry]: [f64; 2]) -> Path {
    let curves = arc(at(center), [rx, 0.0, 0.0], [0.0, ry, 0.0], 0.0, TAU);
    let start = at([center[0] + rx, center[1]]);
    Path { start, pieces: curves.into_iter().map(Piece::Curve).collect(), closed: true }
}

/// A rectangle with rounded corners, or without.
pub fn rectangle([x, y]: [f64; 2], [w, h]: [f64; 2], [rx, ry]: [f64; 2]) -> Path {
    if rx == 0.0 || ry == 0.0 {
        let corners = [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
        let pieces = corners[1..].iter().map(|&corner| Piece::Line(at(corner))).collect();
        return Path { start: at(corners[0]), pieces, closed: true };
    }
    let mut path = Path::new(at([x + rx, y]));
    let quarter = std::f64::consts::FRAC_PI_2;
    let corners = [
        ([x + w - rx, y], [x + w - rx, y + ry], -quarter),
        ([x + w, y + h - ry], [x + w - rx, y + h - ry], 0.0),
        ([x + rx, y + h], [x + rx, y + h - ry], quarter),
        ([x, y + ry], [x + rx, y + ry], 2.0 * quarter),
    ];
    for (to, center, from) in corners {
        path.pieces.push(Piece::Line(at(to)));
        let curves = arc(at(center), [rx, 0.0, 0.0], [0.0, ry, 0.0], from, quarter);
        path.pieces.extend(curves.into_iter().map(Piece::Curve));
    }
    path.closed = true;
    path
}

/// The corners of a polyline or a polygon. A coordinate without its partner is an error.
pub fn points(value: &str, closed: bool) -> Result<Option<Path>, FormatError> {
    let numbers: Vec<f64> =
        NumberListParser::from(value).collect::<Result<_, _>>().map_err(|error| wrong("points", value, error))?;
    if !numbers.len().is_multiple_of(2) {
        return Err(wrong("points", value, "the last x has no y"));
    }
    Ok(Path::along(numbers.chunks_exact(2).map(|pair| at([pair[0], pair[1]])), closed))
}

/// The paths of path data.
pub fn data(value: &str) -> Result<Vec<Path>, FormatError> {
    let mut pen = Pen::default();
    for segment in PathParser::from(value) {
        pen.draw(segment.map_err(|error| wrong("the path data", value, error))?);
    }
    pen.paths.retain(|path| !path.pieces.is_empty() || path.closed);
    Ok(pen.paths)
}

/// Where a path is drawn.
#[derive(Default)]
struct Pen {
    paths: Vec<Path>,
    here: [f64; 2],
    start: [f64; 2],
    /// The last control point, and whether its curve was a cubic one.
    control: Option<([f64; 2], bool)>,
}

impl Pen {
    /// The path that goes on: after a closed one, another begins where it began.
    fn path(&mut self) -> &mut Path {
        if self.paths.last().is_none_or(|path| path.closed) {
            self.paths.push(Path::new(at(self.start)));
        }
        let last = self.paths.len() - 1;
        &mut self.paths[last]
    }

    fn line(&mut self, to: [f64; 2]) {
        self.path().pieces.push(Piece::Line(at(to)));
        self.here = to;
        self.control = None;
    }

    fn curve(&mut self, controls: &[[f64; 2]], is_cubic: bool) {
        let all: Vec<P3> = [self.here].iter().chain(controls).map(|&p| at(p)).collect();
        self.path().pieces.push(Piece::Curve(Curve::bezier(&all)));
        if let [.., control, end] = controls {
            self.control = Some((*control, is_cubic));
            self.here = *end;
        }
    }

    /// The mirror image of the last control point if the last curve was of the same kind.
    fn mirrored(&self, is_cubic: bool) -> [f64; 2] {
        match self.control {
            Some(([x, y], kind)) if kind == is_cubic => [2.0 * self.here[0] - x, 2.0 * self.here[1] - y],
            _ => self.here,
        }
    }

    fn draw(&mut self, segment: PathSegment) {
        let here = self.here;
        let to = |abs: bool, x: f64, y: f64| if abs { [x, y] } else { [here[0] + x, here[1] + y] };
        match segment {
            PathSegment::MoveTo { abs, x, y } => {
                self.here = to(abs, x, y);
                self.start = self.here;
                self.control = None;
                self.paths.push(Path::new(at(self.here)));
            }
            PathSegment::LineTo { abs, x, y } => self.line(to(abs, x, y)),
            PathSegment::HorizontalLineTo { abs, x } => self.line([to(abs, x, 0.0)[0], here[1]]),
            PathSegment::VerticalLineTo { abs, y } => self.line([here[0], to(abs, 0.0, y)[1]]),
            PathSegment::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                self.curve(&[to(abs, x1, y1), to(abs, x2, y2), to(abs, x, y)], true);
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                self.curve(&[self.mirrored(true), to(abs, x2, y2), to(abs, x, y)], true);
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => self.curve(&[to(abs, x1, y1), to(abs, x, y)], false),
            PathSegment::SmoothQuadratic { abs, x, y } => {
                self.curve(&[self.mirrored(false), to(abs, x, y)], false);
            }
            PathSegment::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } => {
                let end = to(abs, x, y);
                self.arc([rx, ry], x_axis_rotation, [large_arc, sweep], end);
            }
            PathSegment::ClosePath { .. } => {
                if let Some(path) = self.paths.last_mut() {
                    path.closed = true;
                }
                self.here = self.start;
                self.control = None;
            }
        }
    }

    /// An arc by its ends (SVG 2, appendix B.2.4).
    fn arc(&mut self, radii: [f64; 2], degrees: f64, [large, sweep]: [bool; 2], end: [f64; 2]) {
        let [mut rx, mut ry] = radii.map(f64::abs);
        if rx == 0.0 || ry == 0.0 || end == self.here {
            if end != self.here {
                self.line(end);
            }
            return;
        }
        let turn = Affine::rotation(degrees);
        let [cos, sin] = [turn.columns[0][0], turn.columns[0][1]];
        let half = [(self.here[0] - end[0]) / 2.0, (self.here[1] - end[1]) / 2.0];
        let [px, py] = [cos * half[0] + sin * half[1], cos * half[1] - sin * half[0]];
        let too_far = (px / rx) * (px / rx) + (py / ry) * (py / ry);
        if too_far > 1.0 {
            let grow = too_far.sqrt();
            rx *= grow;
            ry *= grow;
        }
        // On the unit circle: the ends are opposite each other about p, and the center is beside it.
        let [ux, uy] = [px / rx, py / ry];
        let square = ux * ux + uy * uy;
        let sign = if large == sweep { -1.0 } else { 1.0 };
        let beside = sign * ((1.0 - square) / square).max(0.0).sqrt();
        let [cx, cy] = [beside * uy, -beside * ux];
        let angle = |x: f64, y: f64| libm::atan2(y, x);
        let from = angle(ux - cx, uy - cy);
        let mut by = angle(-ux - cx, -uy - cy) - from;
        if sweep && by < 0.0 {
            by += TAU;
        } else if !sweep && by > 0.0 {
            by -= TAU;
        }
        let middle = [(self.here[0] + end[0]) / 2.0, (self.here[1] + end[1]) / 2.0];
        let [u, v] = [turn.turn([rx, 0.0, 0.0]), turn.turn([0.0, ry, 0.0])];
        let center: P3 = std::array::from_fn(|i| if i < 2 { middle[i] + cx * u[i] + cy * v[i] } else { 0.0 });
        let mut curves = arc(center, u, v, from, by);
        // The ends are those of the file.
        let last = curves.len() - 1;
        curves[0].0[0].0 = at(self.here);
        curves[last].0[2].0 = at(end);
        self.path().pieces.extend(curves.into_iter().map(Piece::Curve));
        self.here = end;
        self.control = None;
    }
}
