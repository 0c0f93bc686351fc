//! How time and memory grow with the samples, the neighbours, the links and the obstacles of a k-PRM.
//!
//! `cargo bench --bench growth` prints a table for each, with the best-fitting exponent e: time grows like x^e. `-- --quick`
//! measures small cases only; `-- time` and `-- memory` one part. A run pinned to one core is quieter.

mod memory;
mod time;

use memory::Counting;

/// Counts allocated bytes.
#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_given = |word: &str| arguments.iter().any(|argument| argument == word);
    let is_quick = is_given("--quick");
    if !is_given("memory") {
        time::print(is_quick);
    }
    if !is_given("time") {
        memory::print(is_quick);
    }
}
