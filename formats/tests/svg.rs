//! SVG: where shapes are, what is drawn of them, and what is counted.

use crate::files::{dropped, file, free, one, refused};
use planarium::scenario::Obstacle;
use planarium_formats::{Code, Options, World, read};

/// A page of 100 x 100 units, which are metres.
fn page(body: &str) -> String {
    format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>{body}</svg>")
}

/// A page with what the others have not: styles, uses, layers and lengths.
pub const STYLED: &str = "<svg xmlns='http://www.w3.org/2000/svg' width='80mm' height='4cm' viewBox='0 0 160 80' preserveAspectRatio='xMinYMax slice'>
<style>/* a */ .wall, g > #b rect { fill: none; stroke: red; stroke-width: 2px !important } @media print { a { b: c } }</style>
<defs><symbol id='s' viewBox='0 0 10 10'><rect width='50%' height='9' rx='2'/></symbol><g id='g'><use href='#s' x='3'/></g></defs>
<g id='b' inkscape:label='L' transform='rotate(30 5 5) skewX(3)'><rect class='wall' x='9' y='9' width='30' height='20'/></g>
<use href='#g' width='20' height='30' transform='matrix(1 .5 -.5 1 70 20)'/><!-- b --><g style='display: none'><rect/></g>
<path d='m9 60h20v-9c3 3 9 9 20 0s4 4 8 2q9 9 9 0t5 5a9 4 10 0 1 20 3z' style='stroke:#123;stroke-linecap:square' stroke-dasharray='1'/>
<text>&lt;a&#62;</text><svg x='90' y='5' width='9' height='9' viewBox='0 0 3 3'><ellipse cx='1' cy='1' rx='1' ry='.5'/></svg></svg>";

#[track_caller]
fn svg(body: &str) -> World {
    one("a.svg", page(body))
}

#[track_caller]
fn with(body: &str, options: &Options) -> World {
    read(&[file("a.svg", &page(body))], options).unwrap_or_else(|error| panic!("{error}"))
}

/// Whether places are free: `.` is one that is, `#` one that is not. y points down as in the file.
#[track_caller]
fn places(world: &World, wanted: &[(f64, f64, char)]) {
    let height = world.scenario.world().bounds.expect("bounds").max.y;
    for &(x, y, what) in wanted {
        assert_eq!(free(world, [x, height - y]), what == '.', "{x}, {y}: {}", world.scenario.to_json_string());
    }
}

#[test]
fn pages_have_their_length_on_paper_or_the_scale_that_is_given() {
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
    let cases = [
        ("width='80mm' height='40mm' viewBox='0 0 160 80'", None, [0.08, 0.04], 0.0005),
        ("width='8cm' viewBox='0 0 160 80'", None, [0.08, 0.04], 0.0005),
        ("height='1in' viewBox='0 0 40 20'", None, [0.0508, 0.0254], 0.00127),
        ("width='72pt' height='6pc' viewBox='0 0 40 40'", None, [0.0254, 0.0254], 0.000635),
        ("width='96mm' height='96mm'", None, [0.096, 0.096], 0.0254 / 96.0),
        ("width='800' height='400' viewBox='0 0 80 40'", None, [80.0, 40.0], 1.0),
        ("width='800px' height='400px'", None, [800.0, 400.0], 1.0),
        ("width='100%' height='100%' viewBox='5 5 80 40'", None, [80.0, 40.0], 1.0),
        ("viewBox='-10 -10 80 40'", Some(0.05), [4.0, 2.0], 0.05),
        ("width='80mm' height='40mm' viewBox='0 0 80 40'", Some(1.0), [80.0, 40.0], 1.0),
        // A page that is wider than its drawing, which is in the middle.
        ("width='80mm' height='40mm' viewBox='0 0 40 40'", None, [0.08, 0.04], 0.001),
    ];
    for (page, scale, [width, height], unit) in cases {
        let text = format!("<svg {page}><circle cx='20' cy='15' r='2'/></svg>");
        let world = read(&[file("a.svg", &text)], &Options { scale, ..Options::default() }).expect("a page");
        let bounds = world.scenario.world().bounds.expect("bounds");
        assert!(close(bounds.max.x, width) && close(bounds.max.y, height), "{page}: {bounds:?}");
        let Obstacle::Disc(disc) = &world.scenario.world().obstacles[0] else { panic!("a disc") };
        assert!(close(disc.radius, 2.0 * unit), "{page}: {}", disc.radius);
        let note = &world.report.notes[0];
        assert!(note.contains(" m") && note.contains("a unit of the drawing"), "{note}");
    }
    let aligned = |aspect: &str| {
        let text = format!(
            "<svg width='200mm' height='100mm' viewBox='0 0 100 100' preserveAspectRatio='{aspect}'><circle cx='50' cy='50' r='1'/></svg>"
        );
        let world = one("a.svg", text);
        let center = world.scenario.world().obstacles[0].aabb();
        ((center.min.x + center.max.x) * 500.0, (center.min.y + center.max.y) * 500.0)
    };
    for (aspect, x, y) in [
        ("xMinYMin", 50.0, 50.0),
        ("xMaxYMax meet", 150.0, 50.0),
        ("xMidYMin slice", 100.0, 0.0),
        ("none", 100.0, 50.0),
    ] {
        let (at_x, at_y) = aligned(aspect);
        assert!((at_x - x).abs() < 1e-9 && (at_y - y).abs() < 1e-9, "{aspect}: {at_x}, {at_y}");
    }
}

#[test]
fn every_transform_puts_shapes_where_it_says() {
    // The corner of the square is at 10, 10; its middle at 11, 11.
    let square = "<rect width='2' height='2'/>";
    let cases = [
        ("translate(10 10)", (11.0, 11.0)),
        ("translate(10,10) scale(2)", (12.0, 12.0)),
        ("scale(2 3)translate(10)", (22.0, 3.0)),
        ("rotate(90) translate(10,-20)", (19.0, 11.0)),
        ("rotate(90 20 20) translate(10 10)", (29.0, 11.0)),
        ("matrix(1 0 0 1 10 10)", (11.0, 11.0)),
        ("matrix(0 2 -3 0 50 10)", (47.0, 12.0)),
        ("translate(10 10) skewX(45)", (12.0, 11.0)),
        ("translate(10 10) skewY(45)", (11.0, 12.0)),
    ];
    for (transform, (x, y)) in cases {
        let world = svg(&format!("<g transform='{transform}'>{square}</g>"));
        let aabb = world.scenario.world().obstacles[0].aabb();
        places(&world, &[(x, y, '#')]);
        let middle = ((aabb.min.x + aabb.max.x) / 2.0, 100.0 - (aabb.min.y + aabb.max.y) / 2.0);
        assert!((middle.0 - x).abs() < 1e-9 && (middle.1 - y).abs() < 1e-9, "{transform}: {middle:?}");
        let css = svg(&format!("<rect width='2' height='2' transform='{transform}'/>"));
        assert_eq!(css.scenario.world().obstacles[0].aabb(), aabb, "{transform}");
    }
    let css = svg("<rect width='2' height='2' style='transform: translate(10px, 10px) rotate(90deg)'/>");
    places(&css, &[(9.0, 11.0, '#'), (11.0, 11.0, '.')]);
    for wrong in ["transform='turn(3)'", "style='transform-origin: 5px 5px'", "style='transform: rotate(1turn)'"] {
        let text = page(&format!("<rect width='2' height='2' {wrong}/>"));
        let error = read(&[file("a.svg", &text)], &Options::default()).map(|world| world.report).expect_err(wrong);
        assert!(matches!(error.code(), Code::InvalidFile | Code::UnsupportedFeature), "{error}");
        assert!(error.place().is_some(), "{error}");
    }
}

#[test]
fn shapes_are_where_they_are_drawn() {
    let world = svg("<rect x='10' y='20' width='30' height='10' rx='5'/><circle cx='70' cy='20' r='10'/>\
         <ellipse cx='70' cy='60' rx='20' ry='5'/><polygon points='10,60 30,60 20,80'/>\
         <polyline points='40 90 60 90 50 80' fill='none' stroke='black' stroke-width='2'/>\
         <line x1='80' y1='90' x2='95' y2='90' stroke='black' stroke-width='4'/>");
    places(
        &world,
        &[
            (25.0, 25.0, '#'),
            (10.5, 25.0, '#'),
            (10.5, 20.5, '.'),
            (39.5, 29.5, '.'),
            (70.0, 29.9, '#'),
            (78.0, 28.0, '.'),
            (89.0, 60.0, '#'),
            (89.0, 64.0, '.'),
            (20.0, 70.0, '#'),
            (11.0, 75.0, '.'),
            (50.0, 90.9, '#'),
            (50.0, 91.1, '.'),
            (50.0, 86.0, '.'),
            (42.0, 88.0, '.'),
            (94.0, 91.9, '#'),
            (94.0, 92.1, '.'),
        ],
    );
    assert_eq!(world.report.obstacles.discs, 1);
    let none = "<rect width='0' height='5'/><circle r='-1'/><polygon points=''/><path d=''/>";
    let world = svg(&format!("{none}<rect x='1' y='1' width='1' height='1'/>"));
    assert_eq!(dropped(&world, "without extent"), 4);
}

#[test]
fn relative_and_absolute_path_commands_are_the_same() {
    let pairs = [
        ("M10 10L30 10L30 30Z", "m10 10l20 0 0 20z"),
        ("M10 10H30V30H10Z", "m10,10h20v20h-20z"),
        ("M10 10C10 20 30 20 30 10S50 0 50 10V40H10Z", "m10 10c0 10 20 10 20 0s20-10 20 0v30h-40z"),
        ("M10 10Q20 20 30 10T50 10V40H10Z", "m10 10q10 10 20 0t20 0v30h-40z"),
        ("M10 10A10 5 0 0 1 30 10V40H10Z", "m10 10a10 5 0 0120 0v30h-20z"),
        ("M10 10L20 10L20 20ZL15 30L30 30Z", "m10 10h10v10zl5 20h15z"),
    ];
    for (absolute, relative) in pairs {
        let [a, b] = [absolute, relative].map(|d| svg(&format!("<path d='{d}'/>")));
        let corners = |world: &World| world.report.obstacles;
        assert_eq!(corners(&a), corners(&b), "{absolute}");
        for i in 0..2500 {
            let (x, y) = (f64::from(i % 50) + 0.503, f64::from(i / 50) + 0.497);
            assert_eq!(free(&a, [x, 100.0 - y]), free(&b, [x, 100.0 - y]), "{absolute} at {x}, {y}");
        }
    }
    for wrong in ["L1 1", "M1 1 L", "M1 1 Q1 1", "M1 1 A1 1 0 2 0 3 3", "M1 nan", "M1 1e999"] {
        let text = page(&format!("\n<path d='{wrong}'/>"));
        let error = refused(&[file("a.svg", &text)], &Options::default(), Code::InvalidFile);
        assert_eq!(error.to_string().split(':').next(), Some("a.svg, line 2"), "{error}");
    }
}

/// Points of a curve, by its formula.
type Formula = fn(f64) -> (f64, f64);

#[test]
fn polygons_contain_the_curves_and_are_no_larger_than_the_tolerance() {
    let quarter = |t: f64| (20.0 + 15.0 * (t * 6.3).cos(), 20.0 + 9.0 * (t * 6.3).sin());
    let cubic = |t: f64| {
        let s = 1.0 - t;
        let at =
            |a: f64, b: f64, c: f64, d: f64| s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
        (at(10.0, 40.0, 0.0, 30.0), at(10.0, 15.0, 35.0, 40.0))
    };
    // Parts of circles: the center is known by the ends.
    let arc = |t: f64| {
        let angle = std::f64::consts::PI * (1.0 + 1.5 * t);
        (50.0 + 10.0 * angle.cos(), 50.0 + 10.0 * angle.sin())
    };
    let cases: [(&str, Formula); 4] = [
        ("<ellipse cx='20' cy='20' rx='15' ry='9'/>", quarter),
        ("<path d='M10 10C40 15 0 35 30 40H60V10Z'/>", cubic),
        ("<path d='M10 10C40 15 0 35 30 40H3V10Z'/>", cubic),
        ("<path d='M40 50A10 10 0 1 1 50 60L50 50Z'/>", arc),
    ];
    for (shape, curve) in cases {
        for tolerance in [1.0, 0.1, 1e-3] {
            let world = with(shape, &Options { tolerance: Some(tolerance), ..Options::default() });
            assert_eq!(world.scenario.world().obstacles.len(), 1, "{shape} is one polygon");
            assert!(world.report.grown <= tolerance && world.report.grown > 0.0, "{}", world.report.grown);
            for i in 0..=1000 {
                let (x, y) = curve(f64::from(i) / 1000.0);
                // A point of the border is an obstacle; numbers of the test are rounded.
                let near = |by: f64| {
                    (0..16).any(|k| {
                        let angle = f64::from(k) * std::f64::consts::PI / 8.0;
                        !free(&world, [x + by * angle.cos(), 100.0 - y + by * angle.sin()])
                    })
                };
                assert!(near(1e-9), "{shape} with {tolerance} at {x}, {y}");
                let all = (0..16).all(|k| {
                    let angle = f64::from(k) * std::f64::consts::PI / 8.0;
                    let by = 1.5 * tolerance + 1e-9;
                    !free(&world, [x + by * angle.cos(), 100.0 - y + by * angle.sin()])
                });
                assert!(!all, "{shape} with {tolerance} at {x}, {y} is too large");
            }
        }
    }
}

#[test]
fn holes_of_curves_are_no_larger_than_they_are() {
    let ring = "M80 50A30 30 0 1 1 20 50A30 30 0 1 1 80 50Z M65 50A15 15 0 1 0 35 50A15 15 0 1 0 65 50Z";
    for (rule, d) in [("nonzero", ring.to_owned()), ("evenodd", ring.replace("1 0 ", "1 1 "))] {
        let shape = format!("<path fill-rule='{rule}' d='{d}'/>");
        let world = with(&shape, &Options { tolerance: Some(0.5), ..Options::default() });
        assert_eq!((world.report.obstacles.polygons, world.report.obstacles.holes), (1, 1), "{rule}");
        for i in 0..3600 {
            let angle = f64::from(i) * std::f64::consts::PI / 1800.0;
            let at = |radius: f64| free(&world, [50.0 + radius * angle.cos(), 50.0 + radius * angle.sin()]);
            assert!(!at(15.0 + 1e-9) && !at(30.0 - 1e-9), "{rule}, {angle}");
            assert!(at(14.4) && at(30.6), "{rule}, {angle}");
        }
    }
    // The same rings, turned alike, are one disc by the rule nonzero.
    let filled = svg(&format!("<path d='{}'/>", ring.replace("1 0 ", "1 1 ")));
    places(&filled, &[(50.0, 50.0, '#'), (64.9, 50.0, '#')]);
    // Curves that cross near their ends, where the chords do not.
    let tip = with(
        "<path d='M10 10C40 15 0 35 30 40S50 10 60 20L40 5Z'/>",
        &Options { tolerance: Some(1.0), ..Options::default() },
    );
    places(&tip, &[(58.819, 18.992, '#')]);
    // Curves whose chords have no area, and a curve from a point to itself.
    let slight = "<path d='M10 10Q50 14 90 10Q50 6 10 10Z'/><path d='M50 50C52 52 48 52 50 50Z'/>";
    let thin = with(slight, &Options { tolerance: Some(9.0), ..Options::default() });
    places(&thin, &[(50.0, 8.01, '#'), (50.0, 11.99, '#'), (50.0, 51.4, '#')]);
    // Curves that cross themselves.
    let eight =
        svg("<path d='M20 20C100 60 -30 60 60 20Z'/><path d='M20 60C100 100 -60 100 60 60Z' fill-rule='evenodd'/>");
    assert!(eight.report.obstacles.polygons >= 2);
    places(&eight, &[(39.0, 40.0, '#'), (39.0, 80.0, '#'), (70.0, 50.0, '.')]);
}

#[test]
fn curves_are_coarser_where_a_scenario_would_have_too_many_vertices() {
    // Each has 128 corners or more with the default tolerance.
    let count = planarium::scenario::MAX_VERTICES / 100;
    let many: String = (0..count)
        .map(|i| format!("<ellipse cx='{}' cy='{}' rx='1' ry='1.1'/>", 3 * (i % 333) + 2, 3 * (i / 333) + 2))
        .collect();
    let text = format!("<svg viewBox='0 0 1000 1000'>{many}</svg>");
    let world = one("a.svg", &text);
    assert_eq!(world.report.obstacles.polygons, count);
    assert!(world.report.grown > planarium_formats::TOLERANCE && world.report.grown < 1.0);
    let options = Options { tolerance: Some(1e-4), ..Options::default() };
    refused(&[file("a.svg", &text)], &options, Code::WorldTooLarge);
}

#[test]
fn walkable_areas_are_no_larger_than_they_are() {
    let options = Options { walkable: Some(true), tolerance: Some(0.5), ..Options::default() };
    for shape in ["<circle cx='50' cy='50' r='30'/>", "<ellipse cx='50' cy='50' rx='30' ry='30.001'/>"] {
        let world = with(shape, &options);
        for i in 0..720 {
            let angle = f64::from(i) * std::f64::consts::PI / 360.0;
            let at = |radius: f64| free(&world, [50.0 + radius * angle.cos(), 50.0 + radius * angle.sin()]);
            assert!(!at(30.002) && at(28.9), "{shape}, {angle}");
        }
    }
}

#[test]
fn lines_are_walls_of_their_width() {
    let line =
        |style: &str| svg(&format!("<path d='M20 20H60V60' fill='none' stroke='red' stroke-width='4' {style}/>"));
    // The corner of a mitre, 1.999 beyond the middle of the line on both axes.
    let corner = (61.999, 18.001);
    places(&line(""), &[(40.0, 18.1, '#'), (40.0, 17.9, '.'), (corner.0, corner.1, '#'), (62.1, 17.9, '.')]);
    places(&line("stroke-linejoin='round'"), &[(corner.0, corner.1, '.'), (61.4, 18.6, '#')]);
    places(&line("stroke-miterlimit='1.2'"), &[(corner.0, corner.1, '.')]);
    places(&line("style='stroke-linecap: square'"), &[(18.01, 18.01, '#'), (61.99, 61.99, '#')]);
    places(&line(""), &[(18.1, 20.0, '#'), (17.9, 20.0, '.')]);
    assert_eq!(line("").report.obstacles.walls, 1);
    // The larger factor of a transform.
    let stretched = svg("<line x1='2' y1='20' x2='8' y2='20' stroke='red' stroke-width='2' transform='scale(5 1)'/>");
    places(&stretched, &[(25.0, 24.9, '#'), (25.0, 25.1, '.')]);
    let kept = svg(
        "<line x1='2' y1='2' x2='8' y2='2' stroke='red' stroke-width='2' vector-effect='non-scaling-stroke' transform='scale(10)'/>",
    );
    places(&kept, &[(50.0, 20.9, '#'), (50.0, 21.1, '.')]);
    // A filled shape with a stroke is both; a ring leaves its inside free.
    let both = svg("<circle cx='50' cy='50' r='10' stroke='red' stroke-width='4'/>");
    assert_eq!(both.report.obstacles.discs, 1);
    places(&both, &[(50.0, 50.0, '#'), (61.9, 50.0, '#'), (62.1, 50.0, '.')]);
    let ring = svg("<circle cx='50' cy='50' r='10' fill='none' stroke='red' stroke-width='4'/>");
    places(&ring, &[(50.0, 50.0, '.'), (58.1, 50.0, '#'), (61.9, 50.0, '#'), (57.9, 50.0, '.')]);
    let frame = svg("<rect x='20' y='20' width='40' height='30' fill='none' stroke='red' stroke-width='10%'/>");
    places(&frame, &[(15.1, 15.1, '#'), (24.9, 35.0, '#'), (30.0, 35.0, '.'), (64.9, 54.9, '#')]);
    let dot = svg("<path d='M50 50h0' stroke='red' stroke-width='6' stroke-linecap='round'/>");
    places(&dot, &[(52.9, 50.0, '#'), (53.1, 50.0, '.')]);
    let dashed = svg("<line x1='2' y1='20' x2='80' y2='20' stroke='red' stroke-dasharray='5 50'/>");
    assert_eq!((dropped(&dashed, "dashes"), dashed.report.obstacles.walls), (1, 1));
}

#[test]
fn styles_come_from_attributes_sheets_and_style_attributes() {
    let sheet =
        "<style>/* { */ rect { fill: none } .wall, #odd { fill: red } g > rect.thin { stroke: red; stroke-width: 2 }
        .a.b rect { fill: blue } @media print { rect { fill: red } } rect:hover { fill: red } rect[x] { fill: red }
        #last { fill: none !important }</style>";
    let rect = |at: i32, more: &str| format!("<rect x='{at}' y='10' width='4' height='4' {more}/>");
    let world = svg(&format!(
        "{sheet}{}{}{}{}<g>{}</g><g class='b a'>{}</g>{}{}<g class='hidden' fill='none'>{}</g>",
        rect(0, "fill='red'"),
        rect(10, "class='wall'"),
        rect(20, "id='odd'"),
        rect(30, "style='fill:green'"),
        rect(40, "class='thin'"),
        rect(50, ""),
        rect(60, "id='last' style='fill: red'"),
        rect(70, "class='wall' fill-opacity='0'"),
        rect(80, "style='fill: inherit; stroke: none'")
    ));
    let y = 12.0;
    places(
        &world,
        &[
            (2.0, y, '.'),
            (12.0, y, '#'),
            (22.0, y, '#'),
            (32.0, y, '#'),
            (42.0, y, '.'),
            (44.5, y, '#'),
            (52.0, y, '#'),
            (62.0, y, '.'),
            (72.0, y, '.'),
            (82.0, y, '.'),
        ],
    );
    assert_eq!(dropped(&world, "rules of style sheets"), 3);
    assert_eq!(dropped(&world, "without fill and stroke"), 4);
    for nothing in ["none", "transparent", "rgba(1,2,3,0)", "rgb(1 2 3 / 0%)", "#12340", "#1230", "#11223300"] {
        let world = svg(&format!("<rect width='9' height='9' fill='{nothing}'/><rect x='50' width='1' height='1'/>"));
        assert_eq!(free(&world, [5.0, 95.0]), nothing != "#12340", "{nothing}");
    }
}

#[test]
fn what_is_used_is_drawn_where_it_is_used() {
    let world = svg(
        "<defs><rect id='box' width='4' height='4'/><g id='two'><use href='#box'/><use xlink:href='#box' x='6'/></g>\
         <symbol id='sign' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol></defs>\
         <use href='#two' x='10' y='10'/><use href='#two' transform='translate(10 30) scale(2)'/>\
         <use href='#sign' x='50' y='50' width='20' height='20'/><svg x='80' y='80' width='10' height='10' viewBox='0 0 1 1'><rect width='1' height='0.5'/></svg>",
    );
    places(
        &world,
        &[
            (2.0, 2.0, '.'),
            (12.0, 12.0, '#'),
            (15.0, 12.0, '.'),
            (18.0, 12.0, '#'),
            (17.0, 37.0, '#'),
            (29.0, 37.0, '#'),
            (69.0, 69.0, '#'),
            (71.0, 71.0, '.'),
            (89.0, 84.0, '#'),
            (89.0, 86.0, '.'),
        ],
    );
    let around = svg(
        "<g id='a'><rect width='4' height='4'/><use href='#a' x='10'/></g><use href='#gone'/><use href='other.svg#a'/>",
    );
    assert_eq!(dropped(&around, "what they are in"), 1);
    assert_eq!(dropped(&around, "not there") + dropped(&around, "not fetched"), 2);
    let switch = svg(
        "<switch><foreignObject requiredExtensions='x'/><g><rect width='4' height='4'/></g><rect x='50' width='4' height='4'/></switch>",
    );
    places(&switch, &[(2.0, 2.0, '#'), (52.0, 2.0, '.')]);
}

#[test]
fn what_is_left_out_is_counted() {
    let world = svg(
        "<rect width='4' height='4'/><text>wall</text><image href='https://example.org/a.png' width='9' height='9'/>\
         <script>alert(1)</script><rect x='50' width='4' height='4' display='none'/><g visibility='hidden'><rect x='60' width='4' height='4'/></g>\
         <g style='opacity:0'><rect x='70' width='4' height='4'/></g><rect x='80' width='4' height='4' clip-path='url(#c)' mask='url(#m)'/>\
         <rect x='90' width='4' height='4'><animate/></rect><foo/><metadata><rect width='90' height='90'/></metadata>",
    );
    for (what, count) in [
        ("texts", 1),
        ("images", 1),
        ("scripts", 1),
        ("not displayed", 3),
        ("clip paths", 1),
        ("masks", 1),
        ("no shapes of SVG", 1),
    ] {
        assert_eq!(dropped(&world, what), count, "{what}: {:?}", world.report.dropped);
    }
    places(&world, &[(2.0, 2.0, '#'), (52.0, 2.0, '.'), (62.0, 2.0, '.'), (72.0, 2.0, '.'), (82.0, 2.0, '#')]);
    assert_eq!(world.report.obstacles.polygons, 3);
    // The sheet of paper is no obstacle.
    let paper = svg("<rect width='100%' height='100%' fill='white'/><rect x='9' y='9' width='4' height='4'/>");
    assert_eq!((dropped(&paper, "backgrounds"), paper.report.obstacles.polygons), (1, 1));
    refused(&[file("a.svg", &page("<text>x</text>"))], &Options::default(), Code::InvalidFile);
}

#[test]
fn layers_are_chosen_by_label_or_id() {
    let body = "<rect width='4' height='4'/><g inkscape:groupmode='layer' inkscape:label='Walls' id='layer1'>\
         <rect x='10' width='4' height='4'/><g id='inner'><rect x='20' width='4' height='4' id='one'/></g></g>\
         <g id='doors'><rect x='30' width='4' height='4'/></g><g inkscape:label='Off' style='display:none'><rect x='40' width='4' height='4'/></g>";
    let names = |world: &World| -> Vec<(String, usize)> {
        world.report.layers.iter().map(|layer| (layer.name.clone(), layer.shapes)).collect()
    };
    let all = svg(body);
    let wanted = [("page", 1), ("Walls", 2), ("doors", 1), ("Off", 0)].map(|(name, count)| (name.to_owned(), count));
    assert_eq!(names(&all), wanted);
    assert_eq!(all.report.layers[3].omitted.as_deref(), Some("hidden"));
    for (layers, wanted) in [
        (&["Walls"][..], ".##..."),
        (&["layer1"], ".##..."),
        (&["inner"], "..#..."),
        (&["one", "doors"], "..##.."),
        (&["page"], "#....."),
        (&["Off"], "....#."),
        (&["page", "Walls", "Off"], "###.#."),
    ] {
        let options =
            Options { layers: Some(layers.iter().map(|name| (*name).to_owned()).collect()), ..Options::default() };
        let world = with(body, &options);
        let found: String =
            (0..6).map(|i| if free(&world, [10.0 * f64::from(i) + 2.0, 98.0]) { '.' } else { '#' }).collect();
        assert_eq!(found, wanted, "{layers:?}");
    }
    let options = Options { layers: Some(vec!["roof".to_owned()]), ..Options::default() };
    let error = refused(&[file("a.svg", &page(body))], &options, Code::InvalidOption);
    assert!(error.message().contains("roof") && error.message().contains("Walls"), "{error}");
}

#[test]
fn hostile_files_are_refused_in_no_time() {
    let started = std::time::Instant::now();
    let laughs = "<!DOCTYPE svg [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;'>]>";
    let cases: [(String, Code); 11] = [
        (format!("{laughs}{}", page("&b;<rect width='1' height='1'/>")), Code::UnsupportedFeature),
        (format!("{laughs}{}", page("<rect width='&a;' height='1'/>")), Code::UnsupportedFeature),
        (page(&format!("{}{}", "<g>".repeat(100_000), "</g>".repeat(100_000))), Code::WorldTooLarge),
        (page("<rect width='1' height='1'>"), Code::InvalidFile),
        ("<svg viewBox='0 0 9 9'><rect width='1'".to_owned(), Code::Truncated),
        ("<svg viewBox='0 0 9 9'><g><rect width='1' height='1'/>".to_owned(), Code::Truncated),
        (page("<rect width='nan' height='1'/>"), Code::InvalidFile),
        (page("<rect width='1' height='1' transform='scale(1e200) scale(1e200)'/>"), Code::InvalidNumber),
        (page("<circle r='1e200' stroke='red'/>"), Code::InvalidNumber),
        ("<svg viewBox='0 0 0 9'><rect width='1' height='1'/></svg>".to_owned(), Code::InvalidFile),
        (
            page("<rect width='1' height='1'/>").replace("100 100'", "100 100' transform='scale(2)'"),
            Code::UnsupportedFeature,
        ),
    ];
    for (text, code) in &cases {
        refused(&[file("a.svg", text)], &Options::default(), *code);
    }
    // Each use draws the one before ten times.
    let mut doubled = "<defs><g id='u0'><rect width='1' height='1'/></g>".to_owned();
    for i in 1..30 {
        doubled += &format!("<g id='u{i}'>{}</g>", format!("<use href='#u{}'/>", i - 1).repeat(10));
    }
    refused(
        &[file("a.svg", &page(&format!("{doubled}</defs><use href='#u29'/>")))],
        &Options::default(),
        Code::WorldTooLarge,
    );
    let rules: String = (0..5000).map(|i| format!("g g g g g .a{i} rect{{fill:red}}")).collect();
    let nested = format!(
        "<style>{rules}</style>{}{}",
        "<g class='a1'>".repeat(200),
        "<rect width='1' height='1'/>".repeat(2000)
    );
    let _ = read(&[file("a.svg", &page(&format!("{nested}{}", "</g>".repeat(200))))], &Options::default());
    let fine = page("<path d='M0 0C1e5 1e5 0 1e5 90 90'/>")
        .replace("<path", &"<path d='M0 0C1e5 1e5 0 1e5 90 90'/>".repeat(2000))
        + "";
    let options = Options { tolerance: Some(1e-9), ..Options::default() };
    let error = read(&[file("a.svg", &fine)], &options).map(|world| world.report).expect_err("too fine");
    assert!(matches!(error.code(), Code::WorldTooLarge | Code::InvalidFile), "{error}");
    assert!(started.elapsed() < std::time::Duration::from_secs(60), "{:?}", started.elapsed());
}
