//! How time and memory grow: time with the samples, neighbours, links and obstacles of a k-PRM, and with the vertices of trees and
//! the states of an index; memory with the vertices of a roadmap.
//!
//! `cargo bench --bench growth` prints the exponent e of each curve: time grows like x^e. `-- --write` also updates these in
//! docs/benchmarks.md, writes all points to docs/growth.json and draws docs/growth.svg; `-- plot` draws that again. `-- --quick`
//! measures small cases only; `-- time` and `-- memory` one part. A run pinned to one core is quieter.

#[path = "../counting.rs"]
mod counting;
mod memory;
mod plot;
mod time;

use counting::Counting;
use std::fs;
use std::path::Path;
use time::Curve;

/// Counts allocated bytes.
#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_given = |word: &str| arguments.iter().any(|argument| argument == word);
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let [figures, plot, page] = ["growth.json", "growth.svg", "benchmarks.md"].map(|name| docs.join(name));
    if is_given("plot") {
        return plot::draw(&serde_json::from_str::<Vec<Curve>>(&fs::read_to_string(figures)?)?, &plot);
    }
    if !is_given("memory") {
        let curves = time::curves(is_given("--quick"));
        let table = table(&curves);
        println!("{table}");
        if is_given("--write") {
            fs::write(figures, serde_json::to_string(&curves)? + "\n")?;
            plot::draw(&curves, &plot)?;
            fs::write(&page, between_marks(&fs::read_to_string(&page)?, &table)?)?;
        }
    }
    if !is_given("time") {
        memory::print(is_given("--quick"));
    }
    Ok(())
}

/// The first and last point of each curve, and its exponent, in Markdown.
fn table(curves: &[Curve]) -> String {
    let mut rows = "| what grows | time of | from | to | motions | exponent |\n|---|---|---|---|---|---|\n".to_owned();
    for curve in curves {
        let [first, last] = [curve.points.first(), curve.points.last()].map(|point| point.expect("a curve has points"));
        let [from, to] = [first, last].map(|point| format!("{}: {}", point.x, plot::duration(point.seconds)));
        let motions = match (first.motions, last.motions) {
            (Some(first), Some(last)) => format!("{first} to {last}"),
            _ => String::new(),
        };
        rows +=
            &format!("| {} | {} | {from} | {to} | {motions} | {:.2} |\n", curve.quantity, curve.name, curve.exponent());
    }
    rows
}

/// The text with the table between its marks.
fn between_marks(text: &str, table: &str) -> Result<String, &'static str> {
    let [start, end] = ["<!-- growth -->\n", "<!-- /growth -->"];
    let (before, rest) = text.split_once(start).ok_or("docs/benchmarks.md has no mark <!-- growth -->")?;
    let (_, after) = rest.split_once(end).ok_or("docs/benchmarks.md has no mark <!-- /growth -->")?;
    Ok(format!("{before}{start}{table}{end}{after}"))
}
