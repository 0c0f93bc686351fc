//! `planarium-bindgen INPUT.wasm OUT_DIR NAME`: writes the ES module glue for the web beside the processed module.
//!
//! The command line of wasm-bindgen takes minutes to install; its library does the same work, compiles in well
//! under a minute, and its version is held equal to the crate's by one lock file.

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, out, name] = arguments.as_slice() else {
        eprintln!("usage: planarium-bindgen INPUT.wasm OUT_DIR NAME");
        return ExitCode::from(2);
    };
    let mut bindgen = wasm_bindgen_cli_support::Bindgen::new();
    // After a trap the package makes a fresh instance; the reset function is how.
    bindgen.input_path(input).typescript(true).reset_state_function(true).out_name(name);
    match bindgen.web(true).and_then(|bindgen| bindgen.generate(out)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("planarium-bindgen: {error:#}");
            ExitCode::FAILURE
        }
    }
}
