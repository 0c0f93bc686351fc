//! The sections of a file: its units, layers, blocks and entities.

use super::pairs::{Entity, Pairs, name};
use crate::error::{Code, FormatError};
use std::collections::HashMap;

/// A layer of the table.
#[derive(Debug, Clone, Default)]
pub struct LayerState {
    /// Its name, as the table has it.
    pub name: String,
    pub is_off: bool,
    pub is_frozen: bool,
}

/// A block: where its entities begin, and its base point.
#[derive(Debug, Clone, Copy)]
pub struct Block<'a> {
    pub entities: Pairs<'a>,
    pub base: [f64; 3],
    /// The number of the block, in the order of the file.
    pub number: usize,
    pub is_external: bool,
}

/// What a file has.
#[derive(Default)]
pub struct Tables<'a> {
    /// The number of `$INSUNITS`, 0 if there is none.
    pub units: i64,
    /// By name in capitals, as names do not tell small letters from capitals.
    layers: HashMap<String, LayerState>,
    /// By name in capitals, too.
    pub blocks: HashMap<String, Block<'a>>,
    pub entities: Option<Pairs<'a>>,
}

impl<'a> Tables<'a> {
    pub fn read(bytes: &'a [u8]) -> Result<Self, FormatError> {
        let mut pairs = Pairs::of(bytes);
        let mut tables = Self::default();
        loop {
            let entity = pairs.entity()?;
            match entity.kind {
                b"EOF" => return Ok(tables),
                b"SECTION" => {}
                _ => {
                    let sentence = "a section is expected";
                    return Err(entity.wrong(Code::InvalidFile, sentence));
                }
            }
            let section = entity.get(2).map_or(&[][..], |pair| pair.value);
            match section {
                b"HEADER" => {
                    let header = entity;
                    let is_units = |pair: &super::pairs::Pair<'_>| pair.is(9, "$INSUNITS");
                    if let Some(at) = header.pairs.iter().position(is_units) {
                        let value = header.pairs[at + 1..].iter().find(|pair| pair.code == 70);
                        tables.units = value.map_or(Ok(0), |pair| pair.integer())?;
                    }
                }
                b"ENTITIES" => tables.entities = Some(pairs),
                _ => {}
            }
            tables.section(&mut pairs, section)?;
        }
    }

    /// The layer of an entity; one that the table does not have is shown.
    pub fn layer(&self, entity: &Entity<'_>) -> LayerState {
        let name = entity.layer();
        let known = self.layers.get(&name.to_uppercase()).cloned();
        known.unwrap_or(LayerState { name, is_off: false, is_frozen: false })
    }

    /// Reads a section to its end.
    fn section(&mut self, pairs: &mut Pairs<'a>, section: &[u8]) -> Result<(), FormatError> {
        let mut count = 0;
        loop {
            let entity = pairs.entity()?;
            match (section, entity.kind) {
                (_, b"ENDSEC") => return Ok(()),
                (_, b"EOF" | b"SECTION") => {
                    return Err(entity.wrong(Code::Truncated, "the section before has no ENDSEC"));
                }
                (b"TABLES", b"LAYER") => {
                    let Some(layer) = entity.get(2) else { continue };
                    let is_off = entity.integer(62, 7)? < 0;
                    let is_frozen = entity.integer(70, 0)? & 1 == 1;
                    let name = name(layer.value);
                    self.layers.insert(name.to_uppercase(), LayerState { name, is_off, is_frozen });
                }
                (b"BLOCKS", b"BLOCK") => {
                    let Some(block) = entity.get(2) else { continue };
                    let is_external = entity.integer(70, 0)? & (4 | 8) != 0;
                    let block_name = name(block.value).to_uppercase();
                    let block = Block { entities: *pairs, base: entity.point(10)?, number: count, is_external };
                    self.blocks.insert(block_name, block);
                    count += 1;
                }
                _ => {}
            }
        }
    }
}
