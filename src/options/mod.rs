//! Options of planners, generators and other methods: a typed struct and its table in one declaration.
//!
//! `options!` declares a struct whose fields are options. Each field is given by its type, its default, its
//! range, its title and, as its documentation, its meaning. From that follow the struct itself, its defaults, reading
//! values by name ([`Options::read`]) and the table that help texts and controls are made from ([`Options::table`]). A field
//! whose type is another such struct contributes all options of it: a group that several tables share. Reading values
//! does not depend on the texts of a table.
//!
//! # Files
//! - `mod.rs`: tables and the macros; `value.rs`: values given by name; `fields.rs`: how fields are read from them.

mod fields;
mod value;

pub use fields::{Change, Choice, Field, Given, Options, Single, Visitor};
pub use value::{Value, out_of_range, refusal};

/// The range of an option that is a number; other options ignore it.
pub type Range = std::ops::RangeInclusive<f64>;

/// Every number.
pub const ANY: Range = f64::NEG_INFINITY..=f64::INFINITY;

/// Every robot, by its type in documents.
pub const ALL: &[&str] = &["arm", "disc", "rigid_body", "car"];

/// The robot that is moved by controls.
pub const CAR: &[&str] = &["car"];

/// The robots whose motions are straight in their coordinates.
pub const STRAIGHT: &[&str] = &["arm", "disc", "rigid_body"];

/// The values that an option takes.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Kind {
    /// A whole number within the range.
    Integer(Range),
    /// A finite number within the range.
    Number(Range),
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// True or false.
    #[default]
    Switch,
}

/// One row of a table of options.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OptionInfo {
    /// The name, in snake_case, the same everywhere.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// Type and range.
    pub kind: Kind,
    /// The unit; empty for counts and words.
    pub unit: &'static str,
    /// The default; `None` if it depends on the rest.
    pub default: Option<Value>,
    /// The default in words if it depends on the rest.
    pub computed: &'static str,
    /// Its meaning, in one sentence.
    pub meaning: String,
    /// The types of robots that it is for, as in documents; others have no use for it, and may refuse it. Empty if there is no
    /// robot.
    pub robots: &'static [&'static str],
}

/// The description of a method or a generator.
#[derive(Debug, Clone, PartialEq)]
pub struct Info {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The title for people.
    pub title: &'static str,
    /// A summary, in one sentence.
    pub summary: &'static str,
    /// Its options; a generator takes `seed` as well, a whole number from 0 (default) to 2^53 - 1.
    pub options: Vec<OptionInfo>,
}

/// Whether an option or a planner with these robots is for a robot of this type. Those of all robots are for robots of other
/// types too.
pub fn is_for(robots: &[&str], robot: &str) -> bool {
    robots == ALL || robots.contains(&robot)
}

/// The name of an option in JavaScript.
pub(crate) fn in_camel_case(name: &str) -> String {
    let mut letters = name.chars();
    let mut camel = String::new();
    while let Some(letter) = letters.next() {
        match letter {
            '_' => camel.extend(letters.next().map(|letter| letter.to_ascii_uppercase())),
            _ => camel.push(letter),
        }
    }
    camel
}

/// Declares a struct of options. A field is
/// `name: Type = default, in range, "Title", unit "unit", else "a default that depends on the rest", for ROBOTS;`
/// in which all but name and type may be left out: a type `Option<T>` has the default `None`, a group its own. `for ROBOTS`
/// after the name of the struct holds for all fields that name none. A field without a title is read, but in no table.
#[macro_export]
#[doc(hidden)]
macro_rules! options {
    (
        $(#[$attribute:meta])*
        pub struct $Name:ident for $all:expr;
        $(
            $(#[doc = $doc:literal])+
            $field:ident : $Type:ty
            $(= $default:expr)? $(, in $range:expr)? $(, $title:literal)? $(, unit $unit:literal)? $(, else $computed:literal)?
            $(, for $robots:expr)? ;
        )*
    ) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $Name {
            $(
                $(#[doc = $doc])+
                $(#[doc = concat!("\n\nBy default `", stringify!($default), "`.")])?
                $(#[doc = concat!("\n\nBy default ", $computed, ".")])?
                $(#[doc = concat!("\n\nWithin `", stringify!($range), "`.")])?
                pub $field: $Type,
            )*
        }

        impl Default for $Name {
            #[allow(unused_assignments, unused_mut)]
            fn default() -> Self {
                Self { $( $field: $crate::options!(@or (Default::default()) $($default)?), )* }
            }
        }

        impl $crate::options::Field for $Name {
            fn rows(self, _: $crate::options::OptionInfo, _: &$crate::options::Range, table: &mut Vec<$crate::options::OptionInfo>) {
                $(
                    let row = $crate::options::OptionInfo {
                        name: stringify!($field),
                        title: $crate::options!(@or ("") $($title)?),
                        unit: $crate::options!(@or ("") $($unit)?),
                        meaning: [$($doc.trim()),+].join(" "),
                        computed: $crate::options!(@or ("") $($computed)?),
                        robots: $crate::options!(@or ($all) $($robots)?),
                        ..Default::default()
                    };
                    let range = &$crate::options!(@or ($crate::options::ANY) $($range)?);
                    $crate::options::Field::rows(self.$field, row, range, table);
                )*
            }

            fn take(self, _: &'static str, _: &$crate::options::Range, given: &mut $crate::options::Given) -> Self {
                Self { $( $field: {
                    let range = &$crate::options!(@or ($crate::options::ANY) $($range)?);
                    $crate::options::Field::take(self.$field, stringify!($field), range, given)
                }, )* }
            }

            fn visit(self, _: &'static str, _: &'static [&'static str], visitor: &mut $crate::options::Visitor) {
                $(
                    let robots = $crate::options!(@or ($all) $($robots)?);
                    $crate::options::Field::visit(self.$field, stringify!($field), robots, visitor);
                )*
            }

            fn group<G: 'static>(&self) -> Option<&G> {
                let found = (self as &dyn std::any::Any).downcast_ref();
                $( let found = found.or_else(|| $crate::options::Field::group(&self.$field)); )*
                found
            }
        }

        impl $crate::options::Options for $Name {
            const ROBOTS: &'static [&'static str] = $all;
        }
    };
    (@or ($other:expr)) => { $other };
    (@or ($other:expr) $given:expr) => { $given };
}

/// Declares an enum whose variants are the words of a choice, in kebab-case.
#[macro_export]
#[doc(hidden)]
macro_rules! choice {
    ($(#[$attribute:meta])* pub enum $Name:ident { $($body:tt)* }) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr, strum::VariantNames)]
        #[strum(serialize_all = "kebab-case")]
        pub enum $Name { $($body)* }

        impl $crate::options::Choice for $Name {}
    };
}
