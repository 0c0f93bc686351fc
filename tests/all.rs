//! Every test of the library in one program, which is linked once natively and once for WebAssembly, in Node and in Chrome, where
//! each law holds alike. `PLANARIUM_DEEP=1` tests more seeds natively; `PLANARIUM_BLESS=1` writes committed files anew.

mod common;

mod aorrtc;
#[cfg(not(target_arch = "wasm32"))]
mod arrows;
mod as_reported;
mod blend;
mod body_proof;
mod budget;
mod cargo;
mod catalogue;
mod certificate;
mod control;
mod custom;
mod delivery;
mod differential;
mod direct;
mod directed;
mod driving;
mod ends;
mod experiment;
mod fleet;
mod fleet_places;
#[cfg(not(target_arch = "wasm32"))]
mod fuzz;
mod generate;
mod geometry;
mod golden;
mod holes;
mod ik;
mod jagged;
mod json;
mod judge;
mod keep_away;
mod lazy;
mod lengths;
mod limits;
mod navigation;
mod nearest;
mod neighbours;
mod optimal;
mod optimum;
mod own_space;
mod pieces;
mod planners;
mod prismatic;
mod proof;
mod refusals;
mod roadmap;
mod route_graph;
mod safest;
mod sampling;
mod scenario;
#[cfg(all(feature = "schema", not(target_arch = "wasm32")))]
mod schema;
mod search;
mod slices;
mod space;
mod sst;
mod statistics;
mod steering;
mod storage;
mod targets;
mod termination;
#[cfg(all(not(target_arch = "wasm32"), feature = "parallel"))]
mod threads;
mod timing;
mod trajectories;
mod verify;
mod verify_body;
mod viewers;
mod walls;
mod widest;
mod worlds;
