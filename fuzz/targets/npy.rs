#![no_main]

#[path = "../npy.rs"]
mod npy;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| npy::npy(bytes));
