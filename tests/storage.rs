//! Saved roadmaps: written and read bit for bit, queried again with the same results, refused if they are damaged, belong to
//! another scenario, or are not free.

use crate::common::documents::{arm, disc, refuses, scenario};
use crate::common::requests;
use crate::common::{
    arm_and_wall, arm_of, assert_valid, begin_with, disc_and_wall, finish, fitting, of_run, options, parse, seeds,
    sliced, thick_arm_and_wall, worlds,
};
use planarium::Error;
use planarium::error::Code;
use planarium::planner::EdgeCheck;
use planarium::run::storage::{MAGIC, RoadmapDocument, RoadmapMetric, fingerprint};
use planarium::run::{Run, Status};
use planarium::scenario::{Robot, Scenario};
use quick_xml::events::Event;
use std::collections::BTreeSet;
use wasm_bindgen_test::wasm_bindgen_test;

/// Every kind of roadmap, small.
const ROADMAPS: &[(&str, &str)] = &[
    ("prm", "samples=120 k=8"),
    ("prm", "samples=120 k=6 insertion=one-by-one discard=true"),
    ("prm", "samples=120 radius=1.2 metric=naive"),
    ("prm", "samples=60 k=5 metric=euclidean edge_check=sampled edge_samples=7"),
    ("prm-star", "samples=80"),
    ("visibility-prm", "failures=40 tolerance=0.01"),
];

fn saved(scenario: &Scenario, planner: &str, seed: u64, settings: &str) -> RoadmapDocument {
    let run = finish(begin_with(scenario, planner, seed, &fitting(scenario, settings)));
    run.roadmap().expect("this planner builds one")
}

fn resume(scenario: &Scenario, document: &RoadmapDocument) -> Result<Box<dyn Run>, Error> {
    requests::resume(scenario, &options(&document.planner, 0, ""), document)
}

/// The code of an error.
#[track_caller]
fn code<T>(result: Result<T, Error>) -> &'static str {
    let error = result.err().expect("this is to be refused");
    assert!(error.message().len() > 8, "{error}");
    error.code().as_str()
}

#[wasm_bindgen_test(unsupported = test)]
fn both_forms_come_back_bit_for_bit() {
    for world in worlds() {
        for &(planner, settings) in ROADMAPS {
            let document = saved(&world, planner, 3, settings);
            let (text, bytes) = (document.to_json(), document.to_bytes());
            for form in [text.as_bytes(), &bytes[..]] {
                let found = RoadmapDocument::read(form).unwrap_or_else(|error| panic!("{error}"));
                assert_eq!(found, document);
                assert!(found.vertices.iter().zip(&document.vertices).all(|(x, y)| x.to_bits() == y.to_bits()));
                assert_eq!((found.to_json(), found.to_bytes()), (text.clone(), bytes.clone()));
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_document_states_how_the_roadmap_was_built() {
    let world = arm_and_wall(0.1);
    let run = finish(begin_with(&world, "prm", 1, "samples=50 radius=1.5 k=9 metric=naive"));
    let document = run.roadmap().expect("a roadmap");
    assert_eq!((document.scenario.as_str(), document.planner.as_str()), ("arm-and-wall", "prm"));
    assert_eq!((document.metric, document.k, document.radius), (RoadmapMetric::Naive, 9, 1.5));
    assert_eq!((document.circles.as_slice(), document.edge_samples), (&[false, false][..], None));
    assert_eq!((document.fingerprint, document.tolerance), (fingerprint(&world), 1e-4));
    assert_eq!((document.vertices.clone(), document.edges.concat()), (run.vertex_rows(0), run.edge_rows(0)));
    let star = saved(&world, "prm-star", 1, "samples=50 edge_check=sampled edge_samples=5");
    assert_eq!((star.metric, star.circles.as_slice()), (RoadmapMetric::Sum, &[true, true][..]));
    assert_eq!((star.k as usize, star.edge_samples), (planarium::planner::prm_star_k(52, 2), Some(5)));
    let disc = saved(&disc_and_wall(0.2, 0.3), "visibility-prm", 1, "failures=30");
    assert_eq!((disc.metric, disc.circles, disc.radius), (RoadmapMetric::Euclidean, vec![false; 2], f64::INFINITY));
    for planner in ["rrt", "rrt-connect"] {
        assert!(finish(begin_with(&world, planner, 1, "")).roadmap().is_none(), "a tree is no roadmap");
    }
}

/// A free configuration that is no vertex of any roadmap here.
fn free(world: &Scenario, number: usize) -> Vec<f64> {
    let inspector = planarium::run::inspect::Inspector::new(world);
    let at = |k: usize| (0..inspector.dimension()).map(|i| (0.37 * k as f64 + 0.61 * i as f64 + 0.2) % 3.0).collect();
    let is_within = |q: &Vec<f64>| match world.robot() {
        Robot::Arm(arm) => arm
            .joint_types()
            .iter()
            .zip(q)
            .all(|(joint, at)| joint.range().is_none_or(|[low, high]| (low..=high).contains(at))),
        _ => true,
    };
    let is_free = |q: &Vec<f64>| is_within(q) && inspector.check(q).expect("a configuration").is_empty();
    (1..).map(at).filter(is_free).nth(number).expect("much is free")
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_query_finds_the_same_path_and_so_does_every_further_query() {
    for world in worlds() {
        for &(planner, settings) in ROADMAPS {
            for seed in 0..seeds(12).min(3) {
                let mut before = finish(begin_with(&world, planner, seed, &fitting(&world, settings)));
                let document = before.roadmap().expect("a roadmap");
                let after = resume(&world, &document).unwrap_or_else(|error| panic!("{planner} {settings}: {error}"));
                let mut after = finish(after);
                assert_eq!(after.status(), before.status(), "{planner} {settings} seed {seed}");
                assert_eq!((after.path(), after.length().to_bits()), (before.path(), before.length().to_bits()));
                assert_eq!(after.roadmap(), Some(document), "saved again it is the same");
                let [from, to] = [free(&world, 1), free(&world, 2)];
                let [one, other] = [&mut before, &mut after].map(|run| {
                    let answer = run.query(&from, &to, true).expect("both are free");
                    (answer.path, answer.length.to_bits(), answer.status, answer.edge_check)
                });
                assert_eq!(one, other);
                // What a query added is saved too.
                assert_eq!(before.roadmap(), after.roadmap());
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn another_query_of_the_same_world_is_connected_and_proven() {
    let elsewhere = |q: &str| {
        let text = arm_and_wall(0.1).to_json_string().replace("[-0.6,-0.2]", q).replace("\"q\"", "\"other\"");
        parse(&text.replace("arm-and-wall", "renamed"))
    };
    let world = arm_and_wall(0.1);
    for seed in 0..seeds(10) {
        let document = saved(&world, "prm", seed, "samples=200 k=8");
        // The start of the document and a new goal; both new; a new start and the goal of the document.
        for (q, both) in [("[-1.4,0.3]", false), ("[-1.4,0.3]", true)] {
            let other = elsewhere(q);
            let other = if both { parse(&other.to_json_string().replace("[0.6,0.2]", "[0.9,-0.1]")) } else { other };
            assert_eq!(fingerprint(&other), fingerprint(&world), "name and queries do not matter");
            let run = finish(resume(&other, &document).unwrap_or_else(|error| panic!("{error}")));
            let vertices = document.vertex_count() + if both { 2 } else { 1 };
            assert_eq!((run.vertex_count(), run.status()), (vertices, Status::Solved), "seed {seed}");
            let query = &other.queries()[0];
            let ends = [&query.start[..], query.configuration().expect("a goal")];
            assert_eq!([run.path()[0].as_slice(), run.path().last().expect("a goal")], ends);
            assert_eq!(run.vertex_rows(0)[..4], ends.concat());
            assert_valid(&other, &*run);
            let edges = run.roadmap().expect("a roadmap").edges;
            let distinct: BTreeSet<[u32; 2]> = edges.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
            assert_eq!(distinct.len(), edges.len(), "no edge twice");
            assert!(edges.len() > document.edges.len());
        }
        let back = Scenario::parse(&world.to_json_string().replace("[0.6,0.2]", "[-1.4,0.3]")).expect("a scenario");
        let run = finish(resume(&back, &document).expect("the goal is kept"));
        assert_eq!((run.vertex_count(), run.status()), (document.vertex_count() + 1, Status::Solved));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_resumed_run_is_sliced_like_any_other_and_has_its_own_search() {
    let world = arm_of(3, true, 0.02);
    let document = saved(&world, "prm", 2, "samples=150 k=8");
    let settings = "search=dijkstra cost=hops shortcut=30 reduce=true max_iterations=5000 metric=sum k=8";
    let begin = || requests::resume(&world, &options("prm", 4, settings), &document).expect("all of it may be given");
    let whole = sliced("resumed", begin, of_run);
    assert_eq!(whole.limits().max_iterations, Some(5000));
    let plain = finish(resume(&world, &document).expect("it is resumed"));
    assert!(whole.length() < plain.length(), "{} after {}: shortcuts shorten", whole.length(), plain.length());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_roadmap_of_another_world_or_robot_is_refused() {
    let world = arm_and_wall(0.1);
    let document = saved(&world, "prm", 1, "samples=40 k=6");
    let text = world.to_json_string();
    let others = [
        arm_and_wall(0.1f64.next_up()),
        thick_arm_and_wall(0.1),
        arm_of(2, false, 0.0),
        disc_and_wall(0.0, 0.1),
        parse(&text.replace("[1,0.8]", "[1,0.81]")),
    ];
    for other in others {
        refuses(resume(&other, &document), "other-scenario", "/fingerprint");
        // Whatever else is wrong.
        refuses(requests::resume(&other, &options("prm", 0, "samples=3"), &document), "other-scenario", "/fingerprint");
    }
    // The same world written otherwise is the same world.
    assert!(resume(&parse(&text.replace("0.8", "8e-1")), &document).is_ok());
}

/// A small document, for tests that go through each of its bytes.
fn small() -> (Scenario, RoadmapDocument) {
    let world = arm_and_wall(0.1);
    let document = saved(&world, "prm", 1, "samples=6 k=3");
    assert!(document.edges.len() > 4);
    (world, document)
}

#[wasm_bindgen_test(unsupported = test)]
fn a_damaged_file_is_refused() {
    let (_, document) = small();
    let (bytes, text) = (document.to_bytes(), document.to_json().into_bytes());
    let code_of = |bytes: &[u8]| code(RoadmapDocument::read(bytes));
    for at in 0..bytes.len() {
        for flip in [1, 0x10, 0x80, 0xff] {
            let mut damaged = bytes.clone();
            damaged[at] ^= flip;
            assert_eq!(code_of(&damaged), "invalid-roadmap", "byte {at}");
        }
        assert_eq!(code_of(&bytes[..at]), "invalid-roadmap", "{at} bytes");
    }
    for at in 0..text.len() {
        for replacement in [text[at] ^ 1, b'0', b' '] {
            let mut damaged = text.clone();
            damaged[at] = replacement;
            // What reads as the same document (a space between two fields) is the same; nothing else is read.
            match RoadmapDocument::read(&damaged) {
                Ok(found) => assert_eq!(found, document, "byte {at}"),
                Err(error) => assert!(!error.message().is_empty()),
            }
        }
        code_of(&text[..at]);
    }
    assert_eq!(code_of(&[&bytes[..], &[0]].concat()), "invalid-roadmap");
    assert_eq!(code_of(document.to_graphml().as_bytes()), "invalid-roadmap");
    assert_eq!(code(RoadmapDocument::from_bytes(&text)), "invalid-roadmap");
}

/// The bytes with another word at an offset, and a checksum that fits.
fn forged(bytes: &[u8], at: usize, word: u32) -> Vec<u8> {
    let mut payload = bytes[..bytes.len() - 8].to_vec();
    payload[at..at + 4].copy_from_slice(&word.to_le_bytes());
    let mut hash = planarium::fingerprint::Fingerprint::default();
    hash.bytes(&payload);
    payload.extend(hash.value().to_le_bytes());
    payload
}

#[wasm_bindgen_test(unsupported = test)]
fn a_header_that_lies_with_a_fitting_checksum_is_refused_and_nothing_is_allocated_for_it() {
    let (_, document) = small();
    let bytes = document.to_bytes();
    assert_eq!(bytes[..8], MAGIC);
    let rows = 8 * document.vertices.len() + 8 * document.edges.len() + 8;
    let counts = bytes.len() - rows - 8;
    let name = MAGIC.len() + 4 + 4 + 2 + 8 + 4 + 4 + 8 + 8;
    assert_eq!(forged(&bytes, counts, document.vertex_count() as u32), bytes, "the offset of the counts");
    assert_eq!(forged(&bytes, name, document.scenario.len() as u32), bytes, "and that of the length of the name");
    for at in [12, name, counts, counts + 4] {
        for lie in [0, 1, 3, 9, 1000, u32::MAX / 2, u32::MAX] {
            let lying = forged(&bytes, at, lie);
            if lying != bytes {
                assert_eq!(code(RoadmapDocument::from_bytes(&lying)), "invalid-roadmap", "{lie} at {at}");
            }
        }
    }
    refuses(RoadmapDocument::from_bytes(&forged(&bytes, 8, 1)), "invalid-roadmap", "/format");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_document_that_contradicts_itself_is_refused_in_every_form() {
    let (world, document) = small();
    let count = document.vertex_count() as u32;
    // A change, the pointer to what is wrong then, and whether every form is refused or only the document that a program makes.
    type Change<'a> = (&'a dyn Fn(&mut RoadmapDocument), &'a str, bool);
    let changes: &[Change] = &[
        (&|d| d.edges[1][0] = count, "/edges/1/0", true),
        (&|d| d.edges[2] = [0, u32::MAX], "/edges/2/1", true),
        (&|d| d.k = 0, "/k", true),
        (&|d| d.k = u32::MAX, "/k", true),
        (&|d| d.radius = -1.0, "/radius", true),
        (&|d| d.tolerance = 0.0, "/tolerance", true),
        (&|d| d.tolerance = 7.0, "/tolerance", false),
        (&|d| d.planner = "rrt".to_owned(), "/planner", false),
        (&|d| d.metric = RoadmapMetric::Dubins { radius: 0.0 }, "/metric", false),
        (&|d| d.metric = RoadmapMetric::Placement { translation: f64::NAN, rotation: 1.0 }, "/metric", false),
        (&|d| d.circles[1] = false, "/circles/1", false),
    ];
    for &(change, pointer, in_every_form) in changes {
        let mut changed = document.clone();
        change(&mut changed);
        refuses(resume(&world, &changed), "invalid-roadmap", pointer);
        for form in [changed.to_bytes(), changed.to_json().into_bytes()].iter().filter(|_| in_every_form) {
            refuses(RoadmapDocument::read(form), "invalid-roadmap", pointer);
        }
    }
    let mut infinite = document.clone();
    infinite.vertices[3] = f64::NAN;
    refuses(RoadmapDocument::read(&infinite.to_bytes()), "invalid-roadmap", "/vertices/1/1");
    infinite.circles.push(true);
    assert_eq!(code(resume(&world, &infinite)), "invalid-roadmap");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_order_of_fields_and_the_space_between_them_do_not_matter() {
    let (_, document) = small();
    let text = document.to_json();
    let tree = planarium::json::parse(&text).expect("an object");
    let turned = tree.to_string().replace(",\"", " ,\n \"");
    assert!(turned.starts_with("{\"checksum\""), "the order of the alphabet");
    assert_eq!(RoadmapDocument::read(format!("\n {turned}").as_bytes()), Ok(document));
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_free_is_refused_though_its_checksum_fits() {
    for world in [arm_and_wall(1e-6), disc_and_wall(0.3, 1e-6), thick_arm_and_wall(1e-3)] {
        let inspector = planarium::run::inspect::Inspector::new(&world);
        let document = saved(&world, "prm", 5, "samples=60 k=6");
        let row = |i: u32| document.rows().nth(i as usize).expect("a vertex");
        let mut forged = 0;
        for other in 2..document.vertex_count() as u32 {
            if inspector.first_hit(row(0), row(other)).expect("in range").is_none() {
                continue;
            }
            let mut lie = document.clone();
            lie.edges.push([0, other]);
            let read = RoadmapDocument::read(&lie.to_bytes()).expect("nothing is damaged");
            refuses(resume(&world, &read), "invalid-roadmap", &format!("/edges/{}", document.edges.len()));
            forged += 1;
        }
        assert!(forged > 3, "{forged} edges cross the wall");
    }
    let (world, document) = small();
    // Through the wall; off the circle; a zero that is not canonical.
    for bad in [[-0.05, 0.0], [0.0, 7.0], [-0.0, 1.0], [0.0, -std::f64::consts::PI]] {
        let mut lie = document.clone();
        lie.edges.clear();
        lie.vertices[6..8].copy_from_slice(&bad);
        refuses(resume(&world, &lie), "invalid-roadmap", "/vertices/3");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn edges_proven_beside_a_tight_start_are_proven_again_beside_any_other() {
    // The wall's end lies 1e-7 from the tip of the start, so that the tolerance is finer than another query would ask for.
    let tight = scenario("", &disc([1.2000001, 0.0], 0.2), &arm(&[1.0], 0.0), r#""start": [0], "goal": [2]"#);
    let settings = "samples=300 k=12 tolerance=0.1";
    let document = saved(&tight, "prm", 1, settings);
    let start_edges = document.edges.iter().filter(|edge| edge.contains(&0)).count();
    assert!(start_edges > 0, "the start can be left");
    let far = parse(&tight.to_json_string().replace("[0]", "[-2]"));
    let coarse = saved(&far, "prm", 1, settings);
    assert!(coarse.edges.len() < document.edges.len(), "a coarser tolerance refuses some of them");
    let run = finish(resume(&far, &document).expect("all of it is free"));
    assert!(run.edge_count() >= document.edges.len());
}

#[wasm_bindgen_test(unsupported = test)]
fn sampled_edges_are_sampled_again_and_stay_named() {
    let thin = arm_and_wall(0.01);
    let settings = "samples=150 k=8 edge_check=sampled edge_samples=4";
    let document = saved(&thin, "prm", 2, settings);
    // Values that are given again must be those of the document.
    let run = requests::resume(&thin, &options("prm", 0, "edge_check=sampled edge_samples=4 metric=sum"), &document);
    assert_eq!(finish(run.expect("its samples are free")).result().edge_check.as_deref(), Some("sampled"));
    // Passed off as proven it is refused: some edge jumps through the wall.
    let lie = RoadmapDocument { edge_check: EdgeCheck::Proven, edge_samples: None, ..document.clone() };
    let error = resume(&thin, &lie).err().expect("this is to be refused");
    assert!(error.code() == Code::InvalidRoadmap && error.pointer().starts_with("/edges/"), "{error}");
    let finer = RoadmapDocument { edge_samples: Some(1000), ..document };
    assert_eq!(code(resume(&thin, &finer)), "invalid-roadmap");
}

#[wasm_bindgen_test(unsupported = test)]
fn any_numbers_of_neighbours_and_vertices_can_be_resumed() {
    let world = arm_and_wall(0.1);
    let document = saved(&world, "prm", 1, "samples=40 k=6");
    let most = RoadmapDocument { k: 20_000_000, ..document.clone() };
    assert_eq!(finish(resume(&world, &most).expect("k beyond all vertices")).vertex_count(), 42);
    let empty = RoadmapDocument { vertices: Vec::new(), edges: Vec::new(), ..document };
    let run = finish(resume(&world, &empty).expect("no vertex at all"));
    assert_eq!((run.vertex_count(), run.status()), (2, Status::Exhausted));
    assert_eq!(RoadmapDocument::read(&empty.to_bytes()), Ok(empty.clone()));
    assert_eq!(RoadmapDocument::read(empty.to_json().as_bytes()), Ok(empty));
    // Half built it can be saved too; then nothing is connected yet but what the query needs.
    let mut half = begin_with(&world, "prm", 1, "samples=40 k=6");
    half.step(30);
    let half = half.roadmap().expect("as far as it is built");
    assert!(half.edges.is_empty() && half.vertex_count() > 2);
    assert_eq!(finish(resume(&world, &half).expect("it is resumed")).vertex_count(), half.vertex_count());
}

#[wasm_bindgen_test(unsupported = test)]
fn graphml_is_well_formed_and_contains_coordinates_and_lengths() {
    let document = RoadmapDocument {
        scenario: "<&\"'> \u{1}\u{fffe}\r ]]> \u{e9}\u{1f916}".to_owned(),
        vertices: vec![3.0, 0.1, -3.0, 1e-7],
        edges: vec![[1, 0]],
        ..small().1
    };
    // The shorter direction in the first joint.
    let weight = (std::f64::consts::TAU - 6.0) + (0.1 - 1e-7);
    let expected = [
        r#"<?xml version="1.0" encoding="UTF-8"?>"#,
        r#"<graphml xmlns="http://graphml.graphdrawing.org/xmlns">"#,
        r#"<key id="scenario" for="graph" attr.name="scenario" attr.type="string"/>"#,
        r#"<key id="planner" for="graph" attr.name="planner" attr.type="string"/>"#,
        r#"<key id="metric" for="graph" attr.name="metric" attr.type="string"/>"#,
        r#"<key id="q0" for="node" attr.name="q0" attr.type="double"/>"#,
        r#"<key id="q1" for="node" attr.name="q1" attr.type="double"/>"#,
        r#"<key id="weight" for="edge" attr.name="weight" attr.type="double"/>"#,
        r#"<graph id="roadmap" edgedefault="undirected">"#,
        "<data key=\"scenario\">&lt;&amp;\"'&gt; \u{fffd}\u{fffd}&#13; ]]&gt; \u{e9}\u{1f916}</data>",
        r#"<data key="planner">prm</data>"#,
        r#"<data key="metric">sum</data>"#,
        r#"<node id="n0"><data key="q0">3.0</data><data key="q1">0.1</data></node>"#,
        r#"<node id="n1"><data key="q0">-3.0</data><data key="q1">1e-7</data></node>"#,
        &format!(r#"<edge id="e0" source="n1" target="n0"><data key="weight">{weight:?}</data></edge>"#),
        "</graph>",
        "</graphml>\n",
    ];
    let xml = document.to_graphml();
    assert_eq!(xml, expected.join("\n"));
    let mut reader = quick_xml::Reader::from_str(&xml);
    while reader.read_event().expect("well-formed") != Event::Eof {}
}

#[wasm_bindgen_test(unsupported = test)]
fn lengths_of_edges_are_those_of_the_path() {
    for (world, settings) in [
        (arm_and_wall(0.1), "samples=150 k=8 metric=sum"),
        (arm_and_wall(0.1), "samples=150 k=8 metric=euclidean"),
        (arm_and_wall(0.1), "direct=false samples=150 k=8 metric=naive"),
        (disc_and_wall(0.2, 0.3), "samples=250 k=8"),
    ] {
        let run = finish(begin_with(&world, "prm", 2, settings));
        let (document, path) = (run.roadmap().expect("a roadmap"), run.path());
        assert_eq!(run.status(), Status::Solved);
        let vertex = |q: &Vec<f64>| document.rows().position(|row| row == q).expect("short steps need no split") as u32;
        let lengths = path.windows(2).map(|pair| document.length([vertex(&pair[0]), vertex(&pair[1])]));
        let sum = lengths.fold(0.0, |a, b| a + b);
        assert_eq!(sum.to_bits(), run.length().to_bits(), "{settings}");
    }
}
