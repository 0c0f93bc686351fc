//! The numbers of a document: each kind is a type with a range, which is checked when it is read and is part of its schema.

use crate::error::Number;
use serde::{Deserialize, Deserializer, de};

/// Reads a number within the range, without its lower end if it is open.
fn read<'de, D: Deserializer<'de>>(
    source: D,
    what: &str,
    [low, high]: [f64; 2],
    is_open: bool,
) -> Result<f64, D::Error> {
    let value = f64::deserialize(source)?;
    if (low..=high).contains(&value) && !(is_open && value == low) {
        return Ok(value);
    }
    let [low, high, value] = [low, high, value].map(Number);
    let range =
        if is_open { format!("greater than {low} and at most {high}") } else { format!("from {low} to {high}") };
    Err(de::Error::custom(format!("{what} must be {range}, not {value}")))
}

macro_rules! number {
    ($name:ident, $what:literal, $low:literal, $high:literal, $is_open:literal) => {
        #[doc = $what]
        #[derive(Clone, Copy, Default)]
        #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
        pub(crate) struct $name(pub f64);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
                read(source, $what, [$low, $high], $is_open).map($name)
            }
        }

        #[cfg(feature = "schema")]
        impl schemars::JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }

            fn inline_schema() -> bool {
                true
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let low = if $is_open { "exclusiveMinimum" } else { "minimum" };
                schemars::json_schema!({ "type": "number", low: $low, "maximum": $high })
            }
        }
    };
}

number!(Coordinate, "a coordinate", -1e6, 1e6, false);
number!(AngleOrCoordinate, "an angle or a coordinate", -1e6, 1e6, false);
number!(NonNegative, "a radius or a tolerance", 0.0, 1e6, false);
number!(MapCoordinate, "a coordinate of a map", -1e18, 1e18, false);
number!(MapScale, "the scale of a map", 1e-12, 1e12, false);
number!(Margin, "a margin", 0.0, 1e6, false);
number!(Width, "a width", 0.0, 1e6, false);
number!(Positive, "a radius, a length or a weight", 0.0, 1e6, true);
number!(JointLimit, "a joint limit", -100.0, 100.0, false);
number!(JointAngle, "the angle of a joint", -100.0, 100.0, false);
number!(Speed, "a speed", -1e6, 1e6, false);
number!(SteeringAngle, "a steering angle", -1.55, 1.55, false);
number!(Step, "the step of integration", 0.0, 10.0, true);
