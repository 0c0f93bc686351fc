//! The binary form: little-endian, numbers by their bits, a checksum at the end.
//!
//! Magic (8 bytes), version (u32), dimension (u32) and a byte for each coordinate that is a circle, fingerprint (u64), k (u32),
//! checks per edge (u32; 0 if edges are proven, all bits set if only vertices are checked, all but the lowest if straight lines
//! of joints are, all but the second lowest if edges are sampled at the resolution of a problem), radius and tolerance (f64),
//! then scenario, planner and metric as in JSON (u32 length, UTF-8), the counts of vertices and edges (u32), the vertices (f64
//! rows), the edges (u32 pairs), and FNV-1a over all of that (u64). About 8 bytes per coordinate and 8 per edge.

use super::{MAX_DIMENSION, RoadmapDocument, RoadmapMetric, damaged};
use crate::error::Error;
use crate::fingerprint::Fingerprint;
use crate::planner::EdgeCheck;

/// The first bytes of the binary form: a byte that no text has, a name, a line break that a transfer as text would change.
pub const MAGIC: [u8; 8] = *b"\x89PLNMAP\n";

const VERSION: u32 = 2;

/// The checks per edge of a roadmap whose edges are not checked.
const UNCHECKED: u32 = u32::MAX;
/// The checks per edge of a roadmap whose joints are checked along straight lines.
const JOINT_LINES: u32 = u32::MAX - 1;
/// The checks per edge of a roadmap whose edges are sampled at the resolution of a problem.
const AT_RESOLUTION: u32 = u32::MAX - 2;

impl RoadmapDocument {
    /// The document as bytes. O(size).
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = self.payload();
        bytes.extend(hash(&bytes).to_le_bytes());
        bytes
    }

    /// The checksum at the end of either form: 64-bit FNV-1a over the binary form without it.
    pub fn checksum(&self) -> u64 {
        hash(&self.payload())
    }

    fn payload(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(128 + 8 * (self.vertices.len() + self.edges.len()));
        bytes.extend(MAGIC);
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend((self.dimension() as u32).to_le_bytes());
        bytes.extend(self.circles.iter().map(|&is_circle| u8::from(is_circle)));
        bytes.extend(self.fingerprint.to_le_bytes());
        bytes.extend(self.k.to_le_bytes());
        let checks = match self.edge_check {
            EdgeCheck::Proven => 0,
            EdgeCheck::None => UNCHECKED,
            EdgeCheck::JointLines => JOINT_LINES,
            EdgeCheck::Sampled => self.edge_samples.unwrap_or(AT_RESOLUTION),
        };
        bytes.extend(checks.to_le_bytes());
        [self.radius, self.tolerance].into_iter().for_each(|number| bytes.extend(number.to_le_bytes()));
        for text in [&self.scenario, &self.planner, &self.metric.to_json()] {
            bytes.extend((text.len() as u32).to_le_bytes());
            bytes.extend(text.as_bytes());
        }
        for count in [self.vertex_count(), self.edges.len()] {
            bytes.extend((count as u32).to_le_bytes());
        }
        self.vertices.iter().for_each(|number| bytes.extend(number.to_le_bytes()));
        self.edges.iter().flatten().for_each(|vertex| bytes.extend(vertex.to_le_bytes()));
        bytes
    }

    /// Reads the binary form. Allocates no more than a few times what there is to read, whatever the counts in it say.
    ///
    /// # Errors
    /// `invalid-roadmap`: another magic or version, too short, too long, a checksum that differs, or what
    /// [`RoadmapDocument::check`] refuses.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let mut source = Source { rest: bytes };
        if source.array()? != MAGIC {
            return Err(damaged("", "this is not the binary form of a roadmap: its first bytes differ"));
        }
        let version = source.count()?;
        if version != VERSION {
            return Err(damaged("/format", format!("version {version} is not supported, only {VERSION}")));
        }
        let Some((payload, checksum)) = bytes.split_last_chunk() else { return Err(too_short()) };
        if hash(payload) != u64::from_le_bytes(*checksum) {
            return Err(damaged("/checksum", "the checksum differs: the file is damaged or not complete"));
        }
        let dimension = source.count()? as usize;
        if dimension > MAX_DIMENSION {
            return Err(damaged("/dimension", format!("a vertex has 1 to {MAX_DIMENSION} numbers, not {dimension}")));
        }
        let circles = source.take(dimension)?.iter().map(|&byte| byte != 0).collect();
        let fingerprint = u64::from_le_bytes(source.array()?);
        let k = source.count()?;
        let (edge_check, edge_samples) = match source.count()? {
            0 => (EdgeCheck::Proven, None),
            UNCHECKED => (EdgeCheck::None, None),
            JOINT_LINES => (EdgeCheck::JointLines, None),
            AT_RESOLUTION => (EdgeCheck::Sampled, None),
            samples => (EdgeCheck::Sampled, Some(samples)),
        };
        let [radius, tolerance] = [f64::from_le_bytes(source.array()?), f64::from_le_bytes(source.array()?)];
        let [scenario, planner, metric] =
            [source.text("/scenario")?, source.text("/planner")?, source.text("/metric")?];
        let [vertices, edges] = [source.count()?, source.count()?].map(u64::from);
        // The counts are used only if the rest is exactly as long as they say: 64 bits hold their products.
        let [rows, pairs] = [vertices * dimension as u64 * 8, edges * 8];
        if rows + pairs + size_of::<u64>() as u64 != source.rest.len() as u64 {
            let sentence =
                format!("{vertices} vertices and {edges} edges do not match the length of {} bytes", bytes.len());
            return Err(damaged("", sentence));
        }
        let (rows, _) = source.take(rows as usize)?.as_chunks();
        let (pairs, _) = source.take(pairs as usize)?.as_chunks::<8>();
        // -0 is read as 0, as from JSON: both forms of a document have one checksum.
        let vertices = rows.iter().map(|number| f64::from_le_bytes(*number) + 0.0).collect();
        let half = |pair: &[u8; 8], at: usize| u32::from_le_bytes(std::array::from_fn(|i| pair[at + i]));
        let edges = pairs.iter().map(|pair| [half(pair, 0), half(pair, 4)]).collect();
        let document = Self {
            scenario,
            fingerprint,
            circles,
            planner,
            metric: RoadmapMetric::parse(&metric)?,
            k,
            radius,
            edge_check,
            edge_samples,
            tolerance,
            vertices,
            edges,
        };
        document.check()?;
        Ok(document)
    }
}

fn hash(bytes: &[u8]) -> u64 {
    let mut hash = Fingerprint::default();
    hash.bytes(bytes);
    hash.value()
}

fn too_short() -> Error {
    damaged("", "the file ends too early")
}

/// What is left to read.
struct Source<'a> {
    rest: &'a [u8],
}

impl<'a> Source<'a> {
    fn take(&mut self, length: usize) -> Result<&'a [u8], Error> {
        self.rest.split_off(..length).ok_or_else(too_short)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        let (taken, rest) = self.rest.split_first_chunk().ok_or_else(too_short)?;
        self.rest = rest;
        Ok(*taken)
    }

    fn count(&mut self) -> Result<u32, Error> {
        self.array().map(u32::from_le_bytes)
    }

    fn text(&mut self, pointer: &str) -> Result<String, Error> {
        let length = self.count()? as usize;
        let text = std::str::from_utf8(self.take(length)?);
        text.map(str::to_owned).map_err(|_| damaged(pointer, "this must be text in UTF-8"))
    }
}
