//! From a document to a checked scenario. Every rule of the contract is held here; the first one broken is the error.

mod base;
mod queries;
mod robot;
mod world;

use super::reader::Reader;
use super::{Node, Robot, Scenario};
use crate::error::{Code, Error, quoted};

/// The `format` of a scenario.
pub const FORMAT: &str = "planarium-scenario-1";

/// The most obstacles a scenario may have.
pub const MAX_OBSTACLES: usize = 10_000;

/// The most vertices that the polygons of a scenario may have together, as written.
pub const MAX_VERTICES: usize = 100_000;

pub use crate::robot::LARGEST;

/// What a document may hold.
const FIELDS: &[&str] = &["format", "name", "title", "world", "robot", "queries"];

impl Scenario {
    /// Reads a scenario from JSON text.
    ///
    /// # Errors
    /// The first rule of the contract that is broken: a stable code, a sentence with the offending value, and its JSON
    /// pointer. A field that is missing is pointed at where it would stand. Codes: those of [`Node::parse`],
    /// `unknown-format`, `unknown-field`, `missing-field`, `wrong-type`, `unknown-type`, `not-finite`, `out-of-range`,
    /// `wrong-dimension`, `degenerate-polygon`, `duplicate-name`, `base-in-collision` and `too-large`.
    /// A start or a goal in collision is not refused here but when it is planned for.
    ///
    /// # Complexity
    /// O(n log n) in the length of the text.
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::from_node(&Node::parse(text)?)
    }

    /// Reads a scenario from a tree.
    ///
    /// # Errors
    /// As [`Scenario::parse`].
    pub fn from_node(node: &Node) -> Result<Self, Error> {
        let root = Reader::root(node);
        let fields = root.object()?;
        // First of all, so that another kind of document is called just that.
        let format = fields.required("format")?;
        if format.string()? != FORMAT {
            let sentence = format!("the format is {}; \"{FORMAT}\" is understood", quoted(format.string()?));
            return Err(format.error(Code::UnknownFormat, sentence));
        }
        fields.only(FIELDS)?;
        let name = fields.required("name")?.name()?.to_owned();
        let title = fields.optional("title").map(|title| title.string().map(str::to_owned)).transpose()?;
        let world = world::read(&fields.required("world")?)?;
        let robot = robot::read(&fields.required("robot")?)?;
        if world.bounds.is_none() && !matches!(robot, Robot::Arm(_)) {
            let sentence = "the field \"bounds\" is missing; only an arm can do without";
            return Err(Error::new(Code::MissingField, "/world/bounds", sentence));
        }
        base::check(&world, &robot)?;
        let queries = queries::read(&fields.required("queries")?, &robot)?;
        Ok(Self { name, title, world, robot, queries })
    }
}
