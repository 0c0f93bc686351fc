//! Cells become the fewest rectangles, which have exactly those cells.

use crate::files::{Random, one};
use planarium::scenario::Obstacle;
use std::fmt::Write;

/// A grid as text.
fn text(bits: &[bool], width: usize) -> String {
    let mut text = String::new();
    for row in bits.chunks_exact(width) {
        row.iter().for_each(|&bit| text.push(if bit { '1' } else { '0' }));
        text.push('\n');
    }
    text
}

/// The fewest rectangles into which the cells can be divided, by trying all: the first free cell is the top left corner
/// of some rectangle.
fn fewest(bits: u32, width: usize, height: usize, known: &mut std::collections::HashMap<u32, usize>) -> usize {
    if bits == 0 {
        return 0;
    }
    if let Some(&count) = known.get(&bits) {
        return count;
    }
    let first = bits.trailing_zeros() as usize;
    let (top, left) = (first / width, first % width);
    let mut best = usize::MAX;
    for bottom in top..height {
        for right in left..width {
            let mask = (top..=bottom).flat_map(|y| (left..=right).map(move |x| 1 << (y * width + x))).sum::<u32>();
            if bits & mask == mask {
                best = best.min(1 + fewest(bits & !mask, width, height, known));
            }
        }
    }
    known.insert(bits, best);
    best
}

#[test]
fn random_grids_become_the_fewest_rectangles_that_do_not_overlap() {
    let mut random = Random(7);
    for round in 0..400 {
        let (width, height) = (2 + random.below(4), 2 + random.below(4));
        let share = [0.5, 0.7, 0.85][round % 3];
        let bits: Vec<bool> = (0..width * height).map(|_| random.unit() < share).collect();
        let world = one("grid.txt", text(&bits, width));
        let mut covered = vec![0; bits.len()];
        for obstacle in world.scenario.world().obstacles.iter() {
            let aabb = obstacle.aabb();
            for y in aabb.min.y as usize..aabb.max.y as usize {
                for x in aabb.min.x as usize..aabb.max.x as usize {
                    covered[(height - 1 - y) * width + x] += 1;
                }
            }
        }
        let wanted: Vec<i32> = bits.iter().map(|&bit| i32::from(bit)).collect();
        assert_eq!(covered, wanted, "{}", text(&bits, width));
        let mask = bits.iter().enumerate().map(|(i, &bit)| u32::from(bit) << i).sum();
        let grid = world.report.grid.expect("a grid");
        assert!(grid.fewest);
        assert_eq!(grid.rectangles, fewest(mask, width, height, &mut Default::default()), "{}", text(&bits, width));
    }
}

#[test]
fn chords_that_cross_are_chosen_well() {
    // A plus with thick arms: two chords in each direction cross, and either pair makes three rectangles.
    let plus = "00100\n00100\n11111\n00100\n00100\n";
    assert_eq!(one("plus.txt", plus).report.obstacles.polygons, 3);
    // A comb whose teeth have chords along columns only.
    let mut comb = String::from("111111111\n");
    (0..3).for_each(|_| writeln!(comb, "101010101").expect("text"));
    assert_eq!(one("comb.txt", comb).report.obstacles.polygons, 6);
    // Rows and columns have to be mixed: a ring, and a bar with two cells.
    let window = "11111\n10101\n11111\n10101\n11111\n";
    assert_eq!(
        one("window.txt", window).report.grid.map(|grid| (grid.rectangles, grid.enclosed)),
        Some((7, 4)),
        "nine along rows"
    );
}

#[test]
fn a_large_grid_takes_time_in_proportion() {
    // Two million cells with half a million obstacles of one cell each: they are refused by their rows.
    let (width, height) = (2000, 1000);
    let bits: Vec<bool> = (0..width * height).map(|i| i / width % 2 == 0 && i % width % 2 == 0).collect();
    let started = std::time::Instant::now();
    let text = text(&bits, width);
    let file = crate::files::file("lines.txt", &text);
    let error = crate::files::refused(&[file], &Default::default(), planarium_formats::Code::WorldTooLarge);
    assert!(error.message().contains("more than 300000 rectangles"), "{error}");
    println!("{width} x {height} cells: {:?}", started.elapsed());
}

#[test]
fn islands_are_dropped_on_request_and_counted() {
    let grid = "10001\n01000\n00000\n11000\n11001\n";
    let read = |least| {
        let options = planarium_formats::Options { min_island: least, ..Default::default() };
        planarium_formats::read(&[crate::files::file("a.txt", grid)], &options).expect("a grid")
    };
    // Cells that touch at a corner are one island.
    assert_eq!(read(0).report.grid.map(|grid| (grid.islands, grid.merged_cells)), Some((4, 8)));
    let dropped = read(2).report;
    assert_eq!(dropped.grid.map(|grid| (grid.islands, grid.merged_cells)), Some((2, 6)));
    assert_eq!((dropped.dropped[0].count, dropped.dropped[0].cells), (2, Some(2)));
    assert_eq!(read(3).report.grid.map(|grid| grid.islands), Some(1));
    assert!(read(0).report.dropped.is_empty());
}

#[test]
fn simplification_only_grows_and_keeps_its_bound() {
    let mut random = Random(3);
    let width = 40;
    let bits: Vec<bool> = (0..width * width).map(|_| random.unit() < 0.05).collect();
    let text = text(&bits, width);
    let read = |bound| {
        let options = planarium_formats::Options { simplify: bound, scale: Some(0.1), ..Default::default() };
        planarium_formats::read(&[crate::files::file("a.txt", &text)], &options).expect("a grid")
    };
    let exact = read(0.0);
    assert_eq!(exact.report.grown, 0.0);
    assert_eq!(read(0.14).report.obstacles, exact.report.obstacles, "a bound below a cell's diagonal changes nothing");
    let grown = read(0.3);
    assert!(grown.report.grown <= 0.3 && grown.report.grown > 0.2, "{}", grown.report.grown);
    assert!(grown.report.obstacles.polygons < exact.report.obstacles.polygons);
    for obstacle in exact.scenario.world().obstacles.iter() {
        let Obstacle::Polygon(polygon) = obstacle else { panic!("a rectangle") };
        let inside = grown.scenario.world().obstacles.iter().any(|other| other.distance_to_polygon(polygon) <= 0.0);
        assert!(inside);
    }
    for obstacle in grown.scenario.world().obstacles.iter() {
        for &corner in [obstacle.aabb().min, obstacle.aabb().max].iter() {
            let segment = planarium::geometry::Segment::new(corner, corner);
            let near = exact.scenario.world().obstacles.iter().map(|other| other.distance_to_segment(&segment));
            assert!(near.fold(f64::INFINITY, f64::min) <= 0.3 + 1e-9);
        }
    }
}
