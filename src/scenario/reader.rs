//! Reads a document from its tree and keeps track of where it is, so that every refusal carries a JSON pointer.

use crate::decimal::Decimal;
use crate::error::{Code, Error, quoted};
use crate::json::{Node, push_field};

/// Where a value stands: a chain from the value up to the root. Text is made of it only where an error needs it.
#[derive(Clone, Copy)]
enum Place<'a> {
    Root,
    Field(&'a Place<'a>, &'a str),
    Item(&'a Place<'a>, usize),
}

impl Place<'_> {
    fn write(&self, pointer: &mut String) {
        match self {
            Place::Root => {}
            Place::Field(parent, name) => {
                parent.write(pointer);
                push_field(pointer, name);
            }
            Place::Item(parent, index) => {
                parent.write(pointer);
                pointer.push_str(&format!("/{index}"));
            }
        }
    }
}

/// A value of a document and where it stands.
#[derive(Clone, Copy)]
pub(crate) struct Reader<'a> {
    node: &'a Node,
    place: Place<'a>,
}

impl<'a> Reader<'a> {
    /// The document as a whole.
    pub fn root(node: &'a Node) -> Self {
        Self { node, place: Place::Root }
    }

    /// The JSON pointer of the value.
    pub fn pointer(&self) -> String {
        let mut pointer = String::new();
        self.place.write(&mut pointer);
        pointer
    }

    /// An error about the value.
    pub fn error(&self, code: Code, sentence: impl Into<String>) -> Error {
        Error::new(code, self.pointer(), sentence)
    }

    /// The value as an object.
    pub fn object(&self) -> Result<Fields<'_>, Error> {
        match self.node {
            Node::Object(fields) => Ok(Fields { place: &self.place, fields }),
            _ => Err(self.wrong_type("an object")),
        }
    }

    /// The value as a list.
    pub fn items(&self) -> Result<impl ExactSizeIterator<Item = Reader<'_>>, Error> {
        match self.node {
            Node::Array(items) => {
                let item = |(i, node)| Reader { node, place: Place::Item(&self.place, i) };
                Ok(items.iter().enumerate().map(item))
            }
            _ => Err(self.wrong_type("an array")),
        }
    }

    /// Whether the value is `null`.
    pub fn is_null(&self) -> bool {
        matches!(self.node, Node::Null)
    }

    /// The value as true or false.
    pub fn boolean(&self) -> Result<bool, Error> {
        match self.node {
            Node::Bool(value) => Ok(*value),
            _ => Err(self.wrong_type("true or false")),
        }
    }

    /// The value as 64 bits in 16 lower-case hexadecimal digits; `code` is that of the refusal.
    pub fn digits(&self, code: Code) -> Result<u64, Error> {
        let text = self.string()?;
        let is_digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
        let digits = (text.len() == 16 && text.bytes().all(is_digit)).then(|| u64::from_str_radix(text, 16).ok());
        digits.flatten().ok_or_else(|| {
            let sentence = format!("this must be 16 lower-case hexadecimal digits, not {}", quoted(text));
            self.error(code, sentence)
        })
    }

    /// The value as a string.
    pub fn string(&self) -> Result<&'a str, Error> {
        match self.node {
            Node::String(value) => Ok(value),
            _ => Err(self.wrong_type("a string")),
        }
    }

    /// The value as a string that is not empty.
    pub fn name(&self) -> Result<&'a str, Error> {
        let name = self.string()?;
        if name.is_empty() {
            return Err(self.error(Code::OutOfRange, "a name must not be empty"));
        }
        Ok(name)
    }

    /// The value as a finite number; -0 reads as 0.
    pub fn number(&self) -> Result<f64, Error> {
        match self.node {
            Node::Number(value) if value.is_finite() => Ok(value + 0.0),
            Node::Number(value) => {
                Err(self.error(Code::NotFinite, format!("this must be a finite number, not {}", Decimal(*value))))
            }
            _ => Err(self.wrong_type("a number")),
        }
    }

    /// The value as a number within [low, high].
    pub fn number_within(&self, what: &str, low: f64, high: f64) -> Result<f64, Error> {
        let value = self.number()?;
        if !(low..=high).contains(&value) {
            let [low, high, value] = [low, high, value].map(Decimal);
            return Err(self.error(Code::OutOfRange, format!("{what} must lie within [{low}, {high}], not {value}")));
        }
        Ok(value)
    }

    /// The value as a whole number from `low` to `high`, which must be below 2^53.
    pub fn integer(&self, what: &str, low: u64, high: u64) -> Result<u64, Error> {
        let value = self.number()?;
        if value.fract() != 0.0 || !(low as f64..=high as f64).contains(&value) {
            let sentence = format!("{what} must be a whole number from {low} to {high}, not {}", Decimal(value));
            return Err(self.error(Code::OutOfRange, sentence));
        }
        Ok(value as u64)
    }

    /// The value as a list of finite numbers.
    pub fn numbers(&self) -> Result<Vec<f64>, Error> {
        self.items()?.map(|item| item.number()).collect()
    }

    /// The value as a list of exactly `N` values.
    pub fn tuple<const N: usize>(&self, what: &str) -> Result<[Reader<'_>; N], Error> {
        let items: Vec<Reader> = self.items()?.collect();
        let found = items.len();
        items.try_into().map_err(|_| self.error(Code::WrongDimension, format!("{what} has {N} entries, not {found}")))
    }

    fn wrong_type(&self, wanted: &str) -> Error {
        let found = match self.node {
            Node::Null => "null".to_owned(),
            Node::Bool(value) => value.to_string(),
            Node::Number(value) => format!("the number {}", Decimal(*value)),
            Node::String(value) => format!("the string {}", quoted(value)),
            Node::Array(items) => format!("an array of {}", items.len()),
            Node::Object(_) => "an object".to_owned(),
        };
        self.error(Code::WrongType, format!("this must be {wanted}, not {found}"))
    }
}

/// The fields of an object.
pub(crate) struct Fields<'a> {
    place: &'a Place<'a>,
    fields: &'a [(String, Node)],
}

impl<'a> Fields<'a> {
    /// Refuses fields that the contract does not know, and those that stand twice.
    pub fn only(&self, known: &[&str]) -> Result<(), Error> {
        for (i, (name, node)) in self.fields.iter().enumerate() {
            let field = Reader { node, place: Place::Field(self.place, name) };
            if !known.contains(&name.as_str()) {
                let sentence = format!("the field {} is not known here; known are {}", quoted(name), known.join(", "));
                return Err(field.error(Code::UnknownField, sentence));
            }
            if self.fields[..i].iter().any(|(before, _)| before == name) {
                let sentence = format!("the field {} stands twice in one object", quoted(name));
                return Err(field.error(Code::DuplicateField, sentence));
            }
        }
        Ok(())
    }

    /// The field of that name, where there is one.
    pub fn optional(&self, name: &'a str) -> Option<Reader<'a>> {
        let (_, node) = self.fields.iter().find(|(field, _)| field == name)?;
        Some(Reader { node, place: Place::Field(self.place, name) })
    }

    /// The field of that name.
    ///
    /// # Errors
    /// `missing-field` with the pointer that the field would have.
    pub fn required(&self, name: &'a str) -> Result<Reader<'a>, Error> {
        self.optional(name).ok_or_else(|| {
            let mut pointer = String::new();
            Place::Field(self.place, name).write(&mut pointer);
            Error::new(Code::MissingField, pointer, format!("the field {} is missing", quoted(name)))
        })
    }
}
