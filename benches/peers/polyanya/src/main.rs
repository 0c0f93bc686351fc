//! The shortest paths of a point in maps of the MovingAI kind, beside those of the crate polyanya, whose numbers have 32 bits.
//!
//! `cargo run --release -- MAP...` reads maps and adds generated ones until there are ten. Of every map it prints the times of the
//! preparations, the medians and greatest times of the same queries, ours also with all tangents known, and the largest relative
//! difference of the lengths. It fails if that exceeds 1e-5, or if one finds a path where another finds none.

use glam::Vec2;
use planarium::geometry::{Aabb, Point};
use planarium::optimum::ShortestPaths;
use planarium::random::{Random, Stream};
use planarium::robot::DiscRobot;
use planarium::scenario::{Obstacle, Query, Scenario, World};
use polyanya::{Mesh, Polygon, Vertex};
use std::time::Instant;

const MAPS: usize = 10;
const QUERIES: usize = 300;
const MOST: f64 = 1e-5;

/// Which cells are free, row by row.
struct Map {
    name: String,
    width: usize,
    height: usize,
    free: Vec<bool>,
}

impl Map {
    fn read(path: &str) -> Self {
        let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"));
        let rows: Vec<&str> = text.lines().skip_while(|line| line.trim() != "map").skip(1).collect();
        let width = rows.iter().map(|row| row.len()).max().expect("a map has rows");
        let is_free = |row: &&str, x: usize| row.as_bytes().get(x).is_some_and(|cell| b".GS".contains(cell));
        let free = rows.iter().flat_map(|row| (0..width).map(move |x| is_free(row, x))).collect();
        Self { name: path.rsplit('/').next().unwrap_or(path).to_owned(), width, height: rows.len(), free }
    }

    /// Rooms with doors for an even number, rubble that grows together for an odd one.
    fn generated(number: u64) -> Self {
        let mut random = Random::new(number, Stream::Samples);
        let (width, height) = (128 + 32 * (number as usize % 4), 160);
        let mut map = Self { name: format!("generated {number}"), width, height, free: vec![true; width * height] };
        if number % 2 == 0 {
            for y in 0..height {
                for x in 0..width {
                    map.free[y * width + x] = x % 16 != 0 && y % 16 != 0;
                }
            }
            for _ in 0..width * height / 40 {
                let cell = random.below((width * height) as u64) as usize;
                map.free[cell] = true;
            }
        } else {
            map.free.iter_mut().for_each(|cell| *cell = random.uniform() > 0.42);
            for _ in 0..3 {
                let before = map.free.clone();
                let at = |x: usize, y: usize| x < width && y < height && before[y * width + x];
                for y in 0..height {
                    for x in 0..width {
                        let around = (0..9).filter(|i| at((x + i % 3).wrapping_sub(1), (y + i / 3).wrapping_sub(1)));
                        map.free[y * width + x] = around.count() >= 5;
                    }
                }
            }
        }
        map
    }

    fn is_free(&self, x: usize, y: usize) -> bool {
        x < self.width && y < self.height && self.free[y * self.width + x]
    }

    /// The same for Planarium: rows of blocked cells, and the same rows below them, as rectangles.
    fn scenario(&self) -> Scenario {
        let mut taken = vec![false; self.free.len()];
        let mut obstacles = Vec::new();
        let is_open = |x: usize, y: usize, taken: &[bool]| !self.is_free(x, y) && !taken[y * self.width + x];
        for y in 0..self.height {
            let mut x = 0;
            while x < self.width {
                let end = (x..self.width).find(|&end| !is_open(end, y, &taken)).unwrap_or(self.width);
                if end > x {
                    let is_row = |y: usize| (x..end).all(|x| is_open(x, y, &taken));
                    let below = (y + 1..self.height).find(|&below| !is_row(below)).unwrap_or(self.height);
                    (y..below).for_each(|y| taken[y * self.width + x..y * self.width + end].fill(true));
                    let [low, high] = [[x, y], [end, below]].map(|corner| corner.map(|x| x as f64));
                    let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
                    let corners = corners.map(|[x, y]| Point::new(x, y));
                    obstacles.push(Obstacle::polygon(&corners).expect("a rectangle"));
                }
                x = end.max(x + 1);
            }
        }
        let bounds = Aabb::of(Point::new(0.0, 0.0), Point::new(self.width as f64, self.height as f64));
        let robot = DiscRobot::new(0.0).expect("a point");
        let queries: [Query; 0] = [];
        Scenario::new("map", World::new(Some(bounds), obstacles), robot, queries).expect("a scenario")
    }

    /// The same for polyanya: a square for every free cell. Merged ones are faster, but then some paths are not found.
    fn mesh(&self) -> Mesh {
        let mut number = vec![u32::MAX; self.free.len()];
        let mut polygons = Vec::new();
        let corner = |x: usize, y: usize| (y * (self.width + 1) + x) as u32;
        for y in 0..self.height {
            for x in (0..self.width).filter(|&x| self.is_free(x, y)) {
                number[y * self.width + x] = polygons.len() as u32;
                let around = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
                polygons.push(Polygon::new(around.to_vec(), false));
            }
        }
        let at =
            |x: usize, y: usize| if x < self.width && y < self.height { number[y * self.width + x] } else { u32::MAX };
        let mut vertices = Vec::new();
        for y in 0..=self.height {
            for x in 0..=self.width {
                let (left, below) = (x.wrapping_sub(1), y.wrapping_sub(1));
                let mut around = vec![at(x, y), at(left, y), at(left, below), at(x, below)];
                // Neighbours outside the mesh are one.
                around.dedup_by(|next, last| *next == u32::MAX && *last == u32::MAX);
                if around.len() > 1 && around[0] == u32::MAX && around[around.len() - 1] == u32::MAX {
                    around.pop();
                }
                vertices.push(Vertex::new(Vec2::new(x as f32, y as f32), around));
            }
        }
        let mut mesh = Mesh::new(vertices, polygons).expect("a mesh");
        mesh.bake();
        mesh
    }
}

fn main() {
    let mut maps: Vec<Map> = std::env::args().skip(1).map(|path| Map::read(&path)).collect();
    (0..MAPS.saturating_sub(maps.len()) as u64).for_each(|number| maps.push(Map::generated(number)));
    let mut is_equal = true;
    for map in &maps {
        let begun = Instant::now();
        let paths = ShortestPaths::new(&map.scenario()).expect("a disc");
        let own = begun.elapsed();
        let begun = Instant::now();
        let many = ShortestPaths::new(&map.scenario()).expect("a disc").for_many_queries();
        let all = begun.elapsed();
        let begun = Instant::now();
        let mesh = map.mesh();
        let other = begun.elapsed();
        let free: Vec<usize> = (0..map.free.len()).filter(|&cell| map.free[cell]).collect();
        let mut random = Random::new(1, Stream::Samples);
        let mut times = [Vec::new(), Vec::new(), Vec::new()];
        let (mut worst, mut none) = (0.0_f64, 0);
        for _ in 0..QUERIES {
            let ends = [0, 1].map(|_| {
                let cell = free[random.below(free.len() as u64) as usize];
                [cell % map.width, cell / map.width].map(|x| x as f64 + 0.5)
            });
            let begun = Instant::now();
            let found = paths.query(ends[0], ends[1]).expect("free ends").map(|found| found.length);
            times[0].push(begun.elapsed());
            let begun = Instant::now();
            let [from, to] = ends.map(|[x, y]| Vec2::new(x as f32, y as f32));
            let expected = mesh.path(from, to).map(|path| f64::from(path.length));
            times[1].push(begun.elapsed());
            let begun = Instant::now();
            let known = many.query(ends[0], ends[1]).expect("free ends").map(|found| found.length);
            times[2].push(begun.elapsed());
            none += usize::from(expected.is_none());
            for found in [found, known] {
                match (found, expected) {
                    (None, None) => (),
                    (Some(found), Some(expected)) if expected > 0.0 => {
                        worst = worst.max((found / expected - 1.0).abs())
                    }
                    (Some(found), Some(_)) => worst = worst.max(found),
                    _ => {
                        println!("  {ends:?}: {found:?}, polyanya {expected:?}");
                        is_equal = false;
                    }
                }
            }
        }
        is_equal &= worst <= MOST;
        times.iter_mut().for_each(|times| times.sort());
        let [fast, slow] = [QUERIES / 2, QUERIES - 1].map(|i| [0, 1, 2].map(|side| 1e3 * times[side][i].as_secs_f64()));
        println!(
            "{}: {} x {}, {} without a path, lengths differ by {worst:.1e}; preparation {:.1} ms, \
             for many queries {:.1} ms, polyanya {:.1} ms; query {:.3} ms (at most {:.2}), of many {:.3} ms ({:.2}), \
             polyanya {:.3} ms ({:.2})",
            map.name,
            map.width,
            map.height,
            none,
            1e3 * own.as_secs_f64(),
            1e3 * all.as_secs_f64(),
            1e3 * other.as_secs_f64(),
            fast[0],
            slow[0],
            fast[2],
            slow[2],
            fast[1],
            slow[1]
        );
    }
    assert!(is_equal, "lengths differ");
}
