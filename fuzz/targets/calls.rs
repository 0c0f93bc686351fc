#![no_main]

#[path = "../calls.rs"]
mod calls;
#[path = "../readers.rs"]
#[allow(dead_code)]
mod readers;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| calls::calls(bytes));
