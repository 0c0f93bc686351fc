//! The shapes of a DXF file, with those of its blocks where they are inserted.

use super::pairs::{Entity, Pairs};
use super::shapes::{Corner, Drawn, Kind, drawn, extruded, polyline};
use super::tables::{LayerState, Tables};
use crate::error::{Code, FormatError, quoted};
use crate::options::Options;
use crate::outline::{Affine, Cap, Shape, Stroke};
use crate::vector::{Drawing, FillRule, LayerId};
use std::collections::HashSet;

/// The most groups that are read, those of blocks as often as they are inserted.
const MAX_GROUPS: usize = 20_000_000;

/// How deep blocks may be in blocks.
const MAX_DEPTH: usize = 32;

/// How far a corner of a wide polyline may reach, in halves of its width.
const MITER: f64 = 10.0;

/// Kinds that draw something else than lines and areas, or are not read; for the report.
const OTHERS: [&str; 30] = [
    "3DSOLID",
    "ACAD_PROXY_ENTITY",
    "ACAD_TABLE",
    "ARC_DIMENSION",
    "ATTDEF",
    "ATTRIB",
    "BODY",
    "DIMENSION",
    "IMAGE",
    "LEADER",
    "LIGHT",
    "MESH",
    "MLINE",
    "MTEXT",
    "MULTILEADER",
    "OLE2FRAME",
    "OLEFRAME",
    "POINT",
    "RAY",
    "REGION",
    "SHAPE",
    "SPLINE",
    "SURFACE",
    "TEXT",
    "TOLERANCE",
    "UNDERLAY",
    "VIEWPORT",
    "WIPEOUT",
    "XLINE",
    "HELIX",
];

/// What an entity takes over from the blocks that it is in.
#[derive(Clone)]
struct Context {
    map: Affine,
    /// The layer of the insertion, for what is on layer 0 in a block.
    layer: Option<LayerId>,
    blocks: Vec<usize>,
}

pub struct Walker<'a, 'b> {
    tables: &'b Tables<'a>,
    drawing: &'b mut Drawing,
    shapes: Vec<Shape>,
    /// The layers whose closed lines are filled; "*" is every one.
    fill: HashSet<&'b str>,
    thickness: f64,
    groups: usize,
}

impl<'a, 'b> Walker<'a, 'b> {
    pub fn walk(
        tables: &'b Tables<'a>,
        scale: f64,
        options: &'b Options,
        drawing: &'b mut Drawing,
    ) -> Result<Vec<Shape>, FormatError> {
        let mut walker = Self {
            tables,
            drawing,
            shapes: Vec::new(),
            fill: options.fill.iter().map(String::as_str).collect(),
            thickness: options.wall_thickness.unwrap_or(0.0),
            groups: 0,
        };
        let map = Affine::scale([scale; 3]);
        if let Some(entities) = tables.entities {
            walker.entities(entities, b"ENDSEC", &Context { map, layer: None, blocks: Vec::new() })?;
        }
        Ok(walker.shapes)
    }

    /// Reads entities up to one of this kind.
    fn entities(&mut self, mut pairs: Pairs<'a>, end: &[u8], context: &Context) -> Result<(), FormatError> {
        loop {
            let entity = self.next(&mut pairs)?;
            if entity.kind == end || entity.kind == b"ENDSEC" {
                return Ok(());
            }
            let mut corners = Vec::new();
            if entity.kind == b"POLYLINE" {
                corners = self.vertices(&mut pairs)?;
            }
            if entity.integer(67, 0)? == 1 && context.blocks.is_empty() {
                self.drawing.drop("entities of paper space", 1);
                continue;
            }
            if entity.integer(60, 0)? == 1 {
                self.drawing.drop("invisible entities", 1);
                continue;
            }
            match entity.kind {
                b"INSERT" => self.insert(&entity, context)?,
                b"POLYLINE" => {
                    let flags = entity.integer(70, 0)?;
                    if flags & (16 | 64) != 0 {
                        self.drawing.drop("POLYLINE meshes", 1);
                        continue;
                    }
                    let corners = widths_of(&entity, corners)?;
                    let map = if flags & 8 == 8 { Affine::IDENTITY } else { extruded(&entity)? };
                    let closed = flags & 1 == 1;
                    self.add(&entity, polyline(&corners, closed, map), closed, context);
                }
                b"VERTEX" | b"SEQEND" | b"ATTRIB" => {}
                _ => match drawn(&entity)? {
                    Some(drawn) => {
                        let closed = is_closed(&entity, &drawn)?;
                        self.add(&entity, drawn, closed, context);
                    }
                    None => self.drop(&entity),
                },
            }
        }
    }

    fn next(&mut self, pairs: &mut Pairs<'a>) -> Result<Entity<'a>, FormatError> {
        let entity = pairs.entity()?;
        self.groups += 1 + entity.pairs.len();
        if self.groups > MAX_GROUPS {
            let sentence =
                format!("more than {MAX_GROUPS} groups are drawn, with those of blocks as often as they are inserted");
            return Err(entity.wrong(Code::WorldTooLarge, sentence));
        }
        Ok(entity)
    }

    fn drop(&mut self, entity: &Entity<'_>) {
        let kind = OTHERS.iter().find(|other| other.as_bytes() == entity.kind);
        let what = match kind {
            Some(&"SPLINE") => "SPLINE entities without control points".to_owned(),
            Some(kind) => format!("{kind} entities"),
            None => "entities of other kinds".to_owned(),
        };
        self.drawing.drop(&what, 1);
    }

    /// The vertices after a polyline.
    fn vertices(&mut self, pairs: &mut Pairs<'a>) -> Result<Vec<(Corner, Entity<'a>)>, FormatError> {
        let mut corners = Vec::new();
        loop {
            let mut ahead = *pairs;
            let entity = self.next(&mut ahead)?;
            match entity.kind {
                b"VERTEX" => {
                    // Control points of a smoothed polyline are not on it.
                    if entity.integer(70, 0)? & 16 == 0 {
                        let corner = Corner { at: entity.point(10)?, bulge: entity.number(42, 0.0)?, widths: [0.0; 2] };
                        corners.push((corner, entity));
                    }
                }
                b"SEQEND" => {
                    *pairs = ahead;
                    return Ok(corners);
                }
                _ => return Ok(corners),
            }
            *pairs = ahead;
        }
    }

    fn layer(&mut self, entity: &Entity<'_>, context: &Context) -> LayerId {
        let LayerState { name, is_off, is_frozen } = self.tables.layer(entity);
        if let (Some(layer), "0") = (context.layer, name.as_str()) {
            return layer;
        }
        let id = self.drawing.layer(&name);
        let layer = self.drawing.layer_mut(id);
        layer.shown = !(is_off || is_frozen);
        if name.eq_ignore_ascii_case("defpoints") {
            layer.omitted = Some("points of dimensions, which are not plotted");
        }
        id
    }

    fn insert(&mut self, entity: &Entity<'a>, context: &Context) -> Result<(), FormatError> {
        let name = entity.get(2).map(|pair| super::pairs::name(pair.value)).unwrap_or_default();
        let Some(block) = self.tables.blocks.get(&name.to_uppercase()).copied() else {
            self.drawing.drop("insertions of blocks that are not there", 1);
            return Ok(());
        };
        if block.is_external {
            self.drawing.drop("insertions of other files, which are not fetched", 1);
            return Ok(());
        }
        if context.blocks.contains(&block.number) {
            let sentence = format!("the block {} is inserted in itself", quoted(name.as_bytes()));
            return Err(entity.wrong(Code::InvalidFile, sentence));
        }
        if context.blocks.len() == MAX_DEPTH {
            let sentence = format!("blocks are nested deeper than {MAX_DEPTH}");
            return Err(entity.wrong(Code::WorldTooLarge, sentence));
        }
        let layer = self.layer(entity, context);
        if self.tables.layer(entity).is_frozen {
            self.drawing.drop("insertions on frozen layers", 1);
            return Ok(());
        }
        let scale = [entity.number(41, 1.0)?, entity.number(42, 1.0)?, entity.number(43, 1.0)?];
        let place = context.map * extruded(entity)? * Affine::translation(entity.point(10)?);
        let turn = Affine::rotation(entity.number(50, 0.0)?);
        let body = Affine::scale(scale) * Affine::translation(block.base.map(|x| -x));
        let steps = [entity.number(44, 0.0)?, entity.number(45, 0.0)?];
        let columns = entity.integer(70, 1)?.max(1);
        let rows = entity.integer(71, 1)?.max(1);
        let mut blocks = context.blocks.clone();
        blocks.push(block.number);
        let mut inner = Context { map: Affine::IDENTITY, layer: Some(layer), blocks };
        for row in 0..rows {
            for column in 0..columns {
                let offset = [column as f64 * steps[0], row as f64 * steps[1], 0.0];
                inner.map = place * turn * Affine::translation(offset) * body;
                self.entities(block.entities, b"ENDBLK", &inner)?;
            }
        }
        Ok(())
    }

    fn add(&mut self, entity: &Entity<'_>, all: Vec<Drawn>, closed: bool, context: &Context) {
        let layer = self.layer(entity, context);
        let name = &self.drawing.layer_mut(layer).name;
        let fills = self.fill.contains("*") || self.fill.contains(name.as_str());
        for drawn in all {
            if drawn.paths.iter().all(|path| path.pieces.is_empty()) {
                self.drawing.drop("entities without extent", 1);
                continue;
            }
            let fill = match drawn.kind {
                Kind::Area(fill) => Some(fill),
                Kind::Line => (fills && closed).then_some(FillRule::NonZero),
            };
            let is_line = drawn.kind == Kind::Line && (fill.is_none() || drawn.width > 0.0);
            let stroke = is_line.then_some(Stroke {
                width: drawn.width,
                least: if fill.is_none() { self.thickness } else { 0.0 },
                cap: Cap::ButtOrRound,
                miter: (drawn.width > 0.0).then_some(MITER),
            });
            let Drawn { paths, circle, map, .. } = drawn;
            self.shapes.push(Shape { layer, paths, circle, map: context.map * map, fill, stroke });
        }
    }
}

/// Whether an entity is a closed line in all.
fn is_closed(entity: &Entity<'_>, drawn: &[Drawn]) -> Result<bool, FormatError> {
    if entity.kind == b"LWPOLYLINE" {
        return Ok(entity.integer(70, 0)? & 1 == 1);
    }
    Ok(drawn.iter().flat_map(|drawn| &drawn.paths).all(|path| path.closed))
}

/// The widths of the edges of a polyline, which has those of vertices that say nothing.
fn widths_of(entity: &Entity<'_>, corners: Vec<(Corner, Entity<'_>)>) -> Result<Vec<Corner>, FormatError> {
    let default = [entity.number(40, 0.0)?, entity.number(41, 0.0)?];
    let with_widths = |(corner, vertex): (Corner, Entity<'_>)| {
        Ok(Corner { widths: [vertex.number(40, default[0])?, vertex.number(41, default[1])?], ..corner })
    };
    corners.into_iter().map(with_widths).collect()
}
