//! Small files of every format, and what tests ask of a world.

use planarium::geometry::{Point, Segment, orientation};
use planarium::scenario::{Obstacle, Scenario};
use planarium_formats::{Code, File, FormatError, Options, World, read};
use std::io::Cursor;

/// The metadata of a map of 0.5 m a cell.
pub const YAML: &str =
    "image: map.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";

/// Four by three pixels: black, grey and white.
pub const PGM: &[u8] = b"P5\n# a comment\n4 3\n255\n\x00\xff\xff\xcd\xff\xff\xff\x00\xff\x00\xff\xff";

pub const MAP: &str = "type octile\nheight 4\nwidth 5\nmap\n.....\n.@T..\n..GSO\nW....\n";
pub const SCEN: &str = "version 1\n0\tsmall.map\t5\t4\t0\t0\t4\t0\t4.0\n7\tsmall.map\t5\t4\t0\t2\t4\t3\t5.41421356\n";
pub const PARKING: &str = "1,1,0,4,4,1.57,2,4,3,6,0,8,0,8,2,6,2,0,6,1,6,0,7\n";
pub const MODERN: &str = "# obstacles\n0.0,0.0,0.2\n-0.3,0.1,0.1\n0.25,-0.25,0.0\n";
pub const OMPL_GRID: &str =
    "discretization(cells): 2 3\nstart(cells): 0 0\nend(cells): 1 2\nenvironment:\n0 1 0\n0 0 0\n";
pub const CIRCLES: &str = "units: meter\n\tx\ty\tr\n1\t2\t3\t1\n2\t6\t3\t0.5\n";
pub const QUERIES: &str = "0\tstart:\t0\t0\n0\tgoal:\t5\t4\n1\tstart:\t1\t1\n1\tgoal:\t9\t2\n";

pub fn file<'a>(name: &'a str, bytes: &'a (impl AsRef<[u8]> + ?Sized)) -> File<'a> {
    File { name, bytes: bytes.as_ref() }
}

/// One file with the default options.
#[track_caller]
pub fn one(name: &str, bytes: impl AsRef<[u8]>) -> World {
    read(&[file(name, &bytes)], &Options::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// How many of something were left out.
pub fn dropped(world: &World, what: &str) -> usize {
    world.report.dropped.iter().filter(|dropped| dropped.what.contains(what)).map(|dropped| dropped.count).sum()
}

/// A Python that has these modules: that of the variable `PLANARIUM_PYTHON`, or `python3`. Without them it says so.
pub fn python(modules: &str) -> Option<String> {
    let python = std::env::var("PLANARIUM_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let found = std::process::Command::new(&python).args(["-c", &format!("import {modules}")]).output();
    if found.is_ok_and(|output| output.status.success()) {
        return Some(python);
    }
    let test = std::thread::current().name().unwrap_or_default().to_owned();
    let line = format!("\nSKIPPED {test}: {python} has not all of {modules}\n");
    let _ = std::io::Write::write_all(&mut std::io::stderr(), line.as_bytes());
    None
}

/// The error of files, with this code.
#[track_caller]
pub fn refused(files: &[File], options: &Options, code: Code) -> FormatError {
    let error = read(files, options).map(|world| world.report).expect_err("it is refused");
    assert_eq!(error.code(), code, "{error}");
    assert!(error.message().len() > 8, "{error}");
    error
}

/// A picture as PNG.
pub fn png(width: u32, height: u32, color: png::ColorType, depth: png::BitDepth, data: &[u8]) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == png::ColorType::Indexed {
        encoder.set_palette(&[0, 0, 0, 255, 255, 255, 255, 255, 255][..]);
        encoder.set_trns(&[255, 255, 0][..]);
    }
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(data).expect("the data");
    writer.finish().expect("the end");
    bytes.into_inner()
}

/// A picture of 8 bits of grey as BMP with a palette, from the bottom up as most are.
pub fn bmp(width: usize, height: usize, pixels: &[u8]) -> Vec<u8> {
    let stride = width.div_ceil(4) * 4;
    let start = 54 + 4 * 256;
    let mut bytes = b"BM".to_vec();
    for number in [start + stride * height, 0, start, 40, width, height, 1 | 8 << 16, 0, 0, 0, 0, 0, 0] {
        bytes.extend((number as u32).to_le_bytes());
    }
    bytes.extend((0..=255).flat_map(|grey| [grey, grey, grey, 0]));
    for row in pixels.chunks_exact(width).rev() {
        bytes.extend(row);
        bytes.resize(bytes.len() + stride - width, 0);
    }
    bytes
}

/// A NumPy array of one byte a number.
pub fn npy(kind: &str, height: usize, width: usize, data: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({height}, {width}), }}");
    let padding = 64 - (11 + header.len()) % 64;
    let header = format!("{header}{}\n", " ".repeat(padding));
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

/// Whether no obstacle of a world has the place, in the coordinates of the scenario.
pub fn free(world: &World, [x, y]: [f64; 2]) -> bool {
    let at = Segment::new(Point::new(x, y), Point::new(x, y));
    world.scenario.world().obstacles.iter().all(|obstacle| obstacle.distance_to_segment(&at) > 0.0)
}

/// Where obstacles are, by strips of x.
pub struct Places<'a> {
    strips: Vec<Vec<&'a Obstacle>>,
    low: f64,
    width: f64,
}

impl<'a> Places<'a> {
    pub fn of(scenario: &'a Scenario) -> Self {
        let bounds = scenario.world().bounds.expect("bounds");
        let count = 256;
        let (low, width) = (bounds.min.x, (bounds.max.x - bounds.min.x) / count as f64);
        let mut strips = vec![Vec::new(); count];
        let strip = |x: f64| (((x - low) / width).max(0.0) as usize).min(count - 1);
        for obstacle in scenario.world().obstacles.iter() {
            let aabb = obstacle.aabb();
            strips[strip(aabb.min.x)..=strip(aabb.max.x)].iter_mut().for_each(|strip| strip.push(obstacle));
        }
        Self { strips, low, width }
    }

    /// Whether no obstacle has the point, exactly.
    pub fn is_free(&self, p: Point) -> bool {
        let strip = (((p.x - self.low) / self.width).max(0.0) as usize).min(self.strips.len() - 1);
        self.strips[strip].iter().all(|obstacle| match obstacle {
            Obstacle::Disc(disc) => (p - disc.center).norm() > disc.radius,
            Obstacle::Polygon(polygon) if polygon.is_convex() => {
                let corners = polygon.vertices();
                let next = corners.iter().cycle().skip(1);
                corners.iter().zip(next).any(|(&a, &b)| orientation(a, b, p) < 0.0)
            }
            _ => obstacle.distance_to_segment(&Segment::new(p, p)) > 0.0,
        })
    }
}

/// Numbers in [0, 1) by a seed (Marsaglia's xorshift with a multiplication).
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn below(&mut self, most: usize) -> usize {
        ((self.bits() >> 32) as usize * most) >> 32
    }
}
