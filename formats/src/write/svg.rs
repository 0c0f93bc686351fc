//! A path as a drawing: the obstacles, the way of the robot and the robot along it. A unit is a metre, and y is up: everything is
//! in one group that turns it over.

use super::PathRows;
use planarium::geometry::{Aabb, Point, Polygon};
use planarium::robot::Part;
use planarium::scenario::{Obstacle, Robot, Scenario};
use std::fmt::Write;

/// The most places at which the robot is drawn, the first and the last row among them.
const MOST_ROBOTS: usize = 100;

/// Between rows of an arm, its tip moves along a curve: this many chords of it are drawn.
const CHORDS: usize = 16;

/// The distance of the edge from all that is drawn, in parts of the longer side.
const MARGIN: f64 = 0.02;

/// The width of thin lines, in parts of the longer side.
const THIN: f64 = 0.002;

/// The drawing.
pub fn write(scenario: &Scenario, rows: &PathRows) -> String {
    let (robot, world) = (scenario.robot(), scenario.world());
    let path = way(robot, &rows.configurations);
    let parts: Vec<Vec<Part>> =
        shown(rows.configurations.len()).map(|i| robot.footprint(&rows.configurations[i])).collect();
    let mut view = world.bounds;
    let boxes = world.obstacles.iter().map(Obstacle::aabb).chain(parts.iter().flatten().map(extent));
    for own in boxes.chain(Aabb::around(path.iter().copied())) {
        view = Some(view.map_or(own, |view| view.union(&own)));
    }
    let view = view.unwrap_or(Aabb::of(Point::origin(), Point::origin()));
    // A point is drawn in a square of side 1.
    let side = if view.longer_side() > 0.0 { view.longer_side() } else { 1.0 };
    let Aabb { min, max } = view.grown(MARGIN * side);
    let thin = THIN * side;
    let title =
        [scenario.title(), &rows.query].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ");
    let mut svg = format!(
        "<!-- A path of Planarium -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n<title>{}</title>\n",
        min.x,
        -max.y,
        max.x - min.x,
        max.y - min.y,
        escaped(&title)
    );
    svg += "<g transform=\"scale(1 -1)\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    if let Some(Aabb { min, max }) = world.bounds {
        let [width, height] = [max.x - min.x, max.y - min.y];
        line(
            &mut svg,
            format_args!(
                "<rect id=\"bounds\" x=\"{}\" y=\"{}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"#555555\" \
                 stroke-width=\"{thin}\"/>",
                min.x, min.y
            ),
        );
    }
    svg += "<g id=\"obstacles\" fill=\"#8a8f98\" fill-rule=\"evenodd\">\n";
    world.obstacles.iter().for_each(|shape| obstacle(&mut svg, shape, thin));
    line(&mut svg, format_args!("</g>\n<g id=\"robot\" fill=\"none\" stroke=\"#2f6fb0\" stroke-width=\"{thin}\">"));
    for part in parts.iter().flatten() {
        robot_part(&mut svg, part, thin);
    }
    let points: Vec<String> = path.iter().map(|p| format!("{},{}", p.x, p.y)).collect();
    line(
        &mut svg,
        format_args!(
            "</g>\n<polyline id=\"path\" points=\"{}\" fill=\"none\" stroke=\"#c2410c\" stroke-width=\"{}\"/>",
            points.join(" "),
            2.0 * thin
        ),
    );
    svg + "</g>\n</svg>\n"
}

/// Writing to a string does not fail.
fn line(svg: &mut String, text: std::fmt::Arguments) {
    let _ = writeln!(svg, "{text}");
}

/// The rows at which the robot is drawn: all, or so many at equal distances.
fn shown(count: usize) -> impl Iterator<Item = usize> {
    let robots = count.min(MOST_ROBOTS);
    (0..robots).map(move |k| if robots > 1 { k * (count - 1) / (robots - 1) } else { 0 })
}

/// The way of the origin of a body, of the middle of a disc or of the tip of an arm.
fn way(robot: &Robot, rows: &[Vec<f64>]) -> Vec<Point> {
    let Robot::Arm(arm) = robot else { return rows.iter().map(|q| Point::new(q[0], q[1])).collect() };
    let mut points: Vec<Point> = rows.first().map(|q| arm.end_effector(q)).into_iter().collect();
    for (from, to) in rows.iter().zip(rows.iter().skip(1)) {
        points.extend((1..=CHORDS).map(|k| {
            let t = k as f64 / CHORDS as f64;
            let q: Vec<f64> = from.iter().zip(to).map(|(a, b)| a + t * (b - a)).collect();
            arm.end_effector(&q)
        }));
    }
    points
}

fn extent(part: &Part) -> Aabb {
    match part {
        Part::Capsule { a, b, radius } => Aabb::of(*a, *b).grown(*radius),
        Part::Disc { center, radius } => Aabb::of(*center, *center).grown(*radius),
        Part::Polygon { vertices } => {
            Aabb::around(vertices.iter().copied()).unwrap_or(Aabb::of(Point::origin(), Point::origin()))
        }
    }
}

/// The outline of points.
fn ring(points: &[Point], closed: bool) -> String {
    let mut d = String::new();
    for (i, p) in points.iter().enumerate() {
        let _ = write!(d, "{}{} {}", if i == 0 { 'M' } else { 'L' }, p.x, p.y);
    }
    if closed { d + "Z" } else { d }
}

fn obstacle(svg: &mut String, obstacle: &Obstacle, thin: f64) {
    let area = |rings: &mut dyn Iterator<Item = &Polygon>| -> String {
        rings.map(|polygon| ring(polygon.vertices(), true)).collect()
    };
    match obstacle {
        Obstacle::Disc(disc) => {
            line(svg, format_args!("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>", disc.center.x, disc.center.y, disc.radius))
        }
        Obstacle::Polygon(polygon) => {
            line(svg, format_args!("<path d=\"{}\"/>", area(&mut std::iter::once(polygon))));
        }
        Obstacle::PolygonWithHoles(polygon) => line(svg, format_args!("<path d=\"{}\"/>", area(&mut polygon.rings()))),
        Obstacle::Wall(wall) => {
            // A line without a width is drawn as a thin one.
            let width = if wall.width() > 0.0 { wall.width() } else { thin };
            let d = ring(wall.points(), wall.is_closed());
            line(svg, format_args!("<path d=\"{d}\" fill=\"none\" stroke=\"#8a8f98\" stroke-width=\"{width}\"/>"));
        }
    }
}

fn robot_part(svg: &mut String, part: &Part, thin: f64) {
    match part {
        Part::Disc { center, radius } => {
            // A point is drawn as a dot.
            let radius = radius.max(thin);
            line(svg, format_args!("<circle cx=\"{}\" cy=\"{}\" r=\"{radius}\"/>", center.x, center.y));
        }
        Part::Polygon { vertices } => line(svg, format_args!("<path d=\"{}\"/>", ring(vertices, true))),
        Part::Capsule { a, b, radius } => {
            let width = (2.0 * radius).max(thin);
            let d = ring(&[*a, *b], false);
            line(svg, format_args!("<path d=\"{d}\" stroke-width=\"{width}\" stroke-opacity=\"0.3\"/>"));
        }
    }
}

/// Text of XML. Characters that XML does not have are left out.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for character in text.chars() {
        match character {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '\t' | '\n' | '\r' => escaped.push(' '),
            character if character.is_control() || matches!(character, '\u{fffe}' | '\u{ffff}') => {}
            character => escaped.push(character),
        }
    }
    escaped
}
