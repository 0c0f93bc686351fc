//! Style sheets: rules whose selectors are names, classes, ids and the like, also within and directly within others.

use super::tree::{Element, Tree};
use crate::error::{Code, FormatError};
use std::collections::HashMap;

/// The most comparisons of an element with a selector in all.
const MAX_TESTS: usize = 100_000_000;

/// A part of a selector: what an element itself has to be.
#[derive(Default)]
struct Simple {
    name: Option<String>,
    id: Option<String>,
    classes: Vec<String>,
    /// Whether the part before is about the parent itself and not about any ancestor.
    is_child: bool,
}

/// A selector with the number of its declarations.
struct Rule {
    parts: Vec<Simple>,
    /// Ids, classes, names.
    weight: [usize; 3],
    block: usize,
}

/// A declaration.
pub struct Declaration {
    pub name: String,
    pub value: String,
    pub is_important: bool,
}

/// The rules of a file.
#[derive(Default)]
pub struct Sheet {
    rules: Vec<Rule>,
    /// The numbers of rules by the id, class or name that the element itself must have.
    by_key: HashMap<String, Vec<usize>>,
    blocks: Vec<Vec<Declaration>>,
    /// Selectors and rules that are not read.
    pub dropped: usize,
    tests: std::cell::Cell<usize>,
}

impl Sheet {
    pub fn read(text: &str) -> Self {
        let mut sheet = Self::default();
        let text = without_comments(text);
        let mut rest = text.as_str();
        while let Some(open) = rest.find(['{', ';', '}']) {
            let head = rest[..open].trim();
            let is_block = rest[open..].starts_with('{');
            rest = &rest[open + 1..];
            if !is_block {
                // Statements such as @import, which fetches nothing here, and what does not belong anywhere.
                sheet.dropped += usize::from(!head.is_empty() && !head.starts_with("@charset"));
                continue;
            }
            let end = end_of_block(rest);
            let body = &rest[..end];
            rest = rest.get(end + 1..).unwrap_or("");
            if head.starts_with('@') {
                sheet.dropped += 1;
                continue;
            }
            let block = sheet.blocks.len();
            sheet.blocks.push(declarations(body));
            for selector in head.split(',') {
                match parts(selector) {
                    Some(parts) => sheet.add(parts, block),
                    None => sheet.dropped += 1,
                }
            }
        }
        sheet
    }

    fn add(&mut self, parts: Vec<Simple>, block: usize) {
        let Some(last) = parts.last() else { return };
        let key = match (&last.id, last.classes.first(), &last.name) {
            (Some(id), _, _) => format!("#{id}"),
            (None, Some(class), _) => format!(".{class}"),
            (None, None, Some(name)) => name.clone(),
            (None, None, None) => "*".to_owned(),
        };
        let sum = |count: fn(&Simple) -> usize| parts.iter().map(count).sum();
        let weight = [
            sum(|part| usize::from(part.id.is_some())),
            sum(|part| part.classes.len()),
            sum(|part| usize::from(part.name.is_some())),
        ];
        self.by_key.entry(key).or_default().push(self.rules.len());
        self.rules.push(Rule { parts, weight, block });
    }

    /// The declarations for an element, the weakest first.
    pub fn of(&self, tree: &Tree, element: &Element) -> Result<Vec<&Declaration>, FormatError> {
        if self.rules.is_empty() {
            return Ok(Vec::new());
        }
        let id = element.get("id").map(|id| format!("#{id}"));
        let classes = classes(element).map(|class| format!(".{class}"));
        let keys = id.into_iter().chain(classes).chain([element.name.to_string(), "*".to_owned()]);
        let mut found: Vec<usize> = Vec::new();
        for i in keys.filter_map(|key| self.by_key.get(&key)).flatten().copied() {
            if self.matches(tree, element, &self.rules[i].parts)? {
                found.push(i);
            }
        }
        found.sort_by_key(|&i| (self.rules[i].weight, i));
        found.dedup();
        Ok(found.into_iter().flat_map(|i| &self.blocks[self.rules[i].block]).collect())
    }

    fn matches(&self, tree: &Tree, element: &Element, parts: &[Simple]) -> Result<bool, FormatError> {
        self.tests.set(self.tests.get() + 1 + parts.len());
        if self.tests.get() > MAX_TESTS {
            let sentence = "the style sheet has too many rules for so many elements";
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
        let Some((last, before)) = parts.split_last() else { return Ok(true) };
        if !last.is(element) {
            return Ok(false);
        }
        let mut above = element.parent.map(|i| &tree.elements[i]);
        if before.is_empty() {
            return Ok(true);
        }
        while let Some(ancestor) = above {
            if self.matches(tree, ancestor, before)? {
                return Ok(true);
            }
            if last.is_child {
                return Ok(false);
            }
            above = ancestor.parent.map(|i| &tree.elements[i]);
        }
        Ok(false)
    }
}

impl Simple {
    fn is(&self, element: &Element) -> bool {
        self.name.as_deref().is_none_or(|name| name == &*element.name)
            && self.id.as_deref().is_none_or(|id| element.get("id") == Some(id))
            && self.classes.iter().all(|class| classes(element).any(|other| other == class))
    }
}

fn classes(element: &Element) -> impl Iterator<Item = &str> {
    element.get("class").unwrap_or("").split_ascii_whitespace()
}

/// The parts of a selector; `None` if it has other than names, classes, ids, descendants and children.
fn parts(selector: &str) -> Option<Vec<Simple>> {
    let spaced = selector.replace('>', " > ");
    let mut parts = Vec::new();
    let mut is_child = false;
    for word in spaced.split_ascii_whitespace() {
        if word == ">" {
            if is_child || parts.is_empty() {
                return None;
            }
            is_child = true;
            continue;
        }
        let mut part = Simple { is_child, ..Simple::default() };
        is_child = false;
        let mut rest = word;
        while !rest.is_empty() {
            let (sign, name) = match rest.strip_prefix(['#', '.']) {
                Some(name) => (&rest[..1], name),
                None => ("", rest),
            };
            let end = name.find(['#', '.']).unwrap_or(name.len());
            let (name, after) = name.split_at(end);
            let is_name = !name.is_empty()
                && name.chars().all(|letter| letter.is_alphanumeric() || letter == '-' || letter == '_');
            rest = after;
            match sign {
                _ if name == "*" && sign.is_empty() => {}
                _ if !is_name => return None,
                "#" if part.id.is_none() => part.id = Some(name.to_owned()),
                "." => part.classes.push(name.to_owned()),
                "" => part.name = Some(name.to_owned()),
                _ => return None,
            }
        }
        parts.push(part);
    }
    (!parts.is_empty() && !is_child).then_some(parts)
}

/// The declarations of a block or of a style attribute.
pub fn declarations(text: &str) -> Vec<Declaration> {
    let text = without_comments(text);
    let declaration = |text: &str| {
        let (name, value) = text.split_once(':')?;
        let value = value.trim();
        let important = value.rfind('!').filter(|&at| value[at + 1..].trim().eq_ignore_ascii_case("important"));
        Some(Declaration {
            name: name.trim().to_ascii_lowercase(),
            value: important.map_or(value, |at| value[..at].trim()).to_owned(),
            is_important: important.is_some(),
        })
    };
    text.split(';').filter_map(declaration).collect()
}

fn without_comments(text: &str) -> String {
    let mut kept = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find("/*") {
        kept.push_str(&rest[..start]);
        kept.push(' ');
        rest = rest[start + 2..].find("*/").map_or("", |end| &rest[start + 2 + end + 2..]);
    }
    kept + rest
}

/// Where a block ends whose opening brace is gone, with the blocks in it.
fn end_of_block(text: &str) -> usize {
    let mut depth = 0;
    for (i, byte) in text.bytes().enumerate() {
        match byte {
            b'{' => depth += 1,
            b'}' if depth == 0 => return i,
            b'}' => depth -= 1,
            _ => {}
        }
    }
    text.len()
}
