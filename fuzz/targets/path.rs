#![no_main]

#[path = "../worlds.rs"]
#[allow(dead_code)]
mod worlds;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| worlds::path(bytes));
