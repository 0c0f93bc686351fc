//! Obstacles of a drawing: chosen layers, in metres, moved to the origin if they are far from it.
//!
//! Scenarios allow obstacles that overlap, so areas are not united: what is simple stays as it is in the file. Only rings
//! that cross are mended.

use super::mend::mended;
use super::rings::{Region, direction, distinct, meetings, nested};
use super::{Drawing, FillRule, Form, Frame, Layer};
use crate::draft::{Draft, FAR, check_finite, largest, middle};
use crate::error::{Code, FormatError};
use crate::options::Options;
use crate::report::{Dropped, Format, LayerRead, PlaneRead};
use crate::text::at_most;
use planarium::geometry::{Aabb, MIN_MAGNITUDE, Point, Polygon};
use planarium::scenario::{MAX_VERTICES, Obstacle};

/// The largest coordinate of a scenario, in metres.
const LARGEST: f64 = 1e6;

/// The distance of the bounds from all that is drawn, in parts of its longer side.
const MARGIN: f64 = 0.05;

/// What is made of areas.
#[derive(Default)]
struct Areas {
    regions: Vec<Region>,
    /// Rings that keep what they surround no smaller than it was, and those without area.
    walls: Vec<Vec<Point>>,
    /// Half the width of the walls about mended rings.
    moved: f64,
    mended: usize,
    flat: usize,
}

impl Drawing {
    /// The draft of what is drawn; the frame leads from the coordinates of the file to metres.
    ///
    /// # Errors
    /// `invalid-option`: an unknown layer. `invalid-file`: nothing is drawn. `invalid-number`, `world-too-large`
    ///
    /// # Complexity
    /// O(n log n) for n points of areas that are simple polygons with holes; see `rings.rs` for others.
    pub fn into_draft(
        mut self,
        format: Format,
        file: &str,
        frame: Frame,
        options: &Options,
    ) -> Result<Draft, FormatError> {
        let mut draft = Draft::new(format, file);
        draft.report.notes.append(&mut self.notes);
        let chosen = self.choose_layers(options, &mut draft)?;
        let mut shapes = std::mem::take(&mut self.shapes);
        if shapes.is_empty() {
            return Err(FormatError::new(Code::InvalidFile, "the file has no shape that could be an obstacle"));
        }
        if shapes.iter().any(|(layer, _)| chosen[layer.0]) {
            shapes.retain(|(layer, _)| chosen[layer.0]);
        }
        let mut forms = Vec::with_capacity(shapes.len());
        for (layer, form) in &shapes {
            let form = self.in_metres(form, frame, options);
            draft.bounds = match forms.is_empty() {
                true => extent(&form),
                false => draft.bounds.union(&extent(&form)),
            };
            forms.push((*layer, form));
        }
        self.set_bounds(&mut draft, frame)?;
        let count: usize = forms.iter().map(|(_, form)| form.points().count()).sum();
        if count > MAX_VERTICES {
            let sentence = format!("the shapes have {count} points; a scenario has at most {MAX_VERTICES} vertices");
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
        forms.retain(|(layer, _)| chosen[layer.0]);
        let forms: Vec<Form> = forms.into_iter().map(|(_, form)| moved(form, draft.moved)).collect();
        self.add_obstacles(forms, &mut draft, options)?;
        draft.report.grown = draft.report.grown.max(frame.length(self.flattened));
        if self.flattened > 0.0 {
            draft.report.notes.push(format!(
                "curves became polygons that are larger by at most {} m",
                at_most(frame.length(self.flattened))
            ));
        }
        draft.report.dropped.extend(Dropped::counted(self.dropped));
        if frame != Frame::of_scale(1.0) {
            let [origin, scale] = [[frame.origin.x, frame.origin.y], frame.scale];
            draft.report.plane = Some(PlaneRead { origin, scale, error: None });
        }
        Ok(draft)
    }

    /// Which layers are read.
    fn choose_layers(&self, options: &Options, draft: &mut Draft) -> Result<Vec<bool>, FormatError> {
        let mut chosen: Vec<bool> = self.layers.iter().map(|layer| layer.shown && layer.omitted.is_none()).collect();
        if let Some(names) = &options.layers {
            chosen.fill(false);
            for name in names {
                let Some(&i) = self.by_name.get(name) else {
                    return Err(FormatError::none_of("layer", name, self.layers.iter().map(|layer| &*layer.name)));
                };
                chosen[i] = true;
            }
        }
        let why = |layer: &Layer| match layer.omitted {
            Some(reason) if options.layers.is_none() => reason,
            None if options.layers.is_none() => "hidden",
            _ => "not chosen",
        };
        for (layer, &read) in self.layers.iter().zip(&chosen) {
            let omitted = (!read).then(|| why(layer).to_owned());
            draft.report.layers.push(LayerRead { name: layer.name.clone(), shapes: layer.count, omitted });
        }
        let left_out: usize =
            self.layers.iter().zip(&chosen).filter(|(_, read)| !**read).map(|(layer, _)| layer.count).sum();
        draft.report.dropped.extend(Dropped::counted([("shapes of layers that are not read", left_out)]));
        if left_out > 0 && !self.layers.iter().zip(&chosen).any(|(layer, &read)| read && layer.count > 0) {
            draft.report.notes.push("all layers are left out: choose some with the option layers".to_owned());
        }
        Ok(chosen)
    }

    /// A shape in metres; a line without points that differ, and a place, are discs.
    fn in_metres(&self, form: &Form, frame: Frame, options: &Options) -> Form {
        let thickness = options.wall_thickness.unwrap_or(self.wall_thickness);
        let all = |points: &[Point]| points.iter().map(|&p| frame.to_metres(p)).collect();
        match form {
            Form::Area { rings, rule } => {
                Form::Area { rings: rings.iter().map(|ring| all(ring)).collect(), rule: *rule }
            }
            Form::Line { points, closed, width } => {
                let width = width.map_or(thickness, |width| frame.length(width));
                let points: Vec<Point> = all(points);
                match points.first() {
                    Some(&center) if points.iter().all(|&p| p == center) => Form::Disc { center, radius: width / 2.0 },
                    _ => Form::Line { points, closed: *closed, width: Some(width) },
                }
            }
            &Form::Disc { center, radius } => {
                Form::Disc { center: frame.to_metres(center), radius: frame.length(radius) }
            }
            &Form::Spot(place) => Form::Disc { center: frame.to_metres(place), radius: thickness / 2.0 },
        }
    }

    /// The bounds, and how far everything is moved.
    fn set_bounds(&self, draft: &mut Draft, frame: Frame) -> Result<(), FormatError> {
        check_finite(draft.bounds)?;
        let Aabb { min, max } = draft.bounds;
        self.check_size(draft)?;
        if let Some(page) = self.page {
            let corners = [page.min, page.max].map(|p| frame.to_metres(p));
            draft.bounds = draft.bounds.union(&Aabb::around(corners).unwrap_or(draft.bounds));
            draft.report.notes.push("the bounds are the page, and wider where something is drawn beside it".to_owned());
        } else {
            let longer = (max.x - min.x).max(max.y - min.y);
            let margin = if longer > 0.0 { MARGIN * longer } else { 1.0 };
            draft.bounds = draft.bounds.grown(margin);
            draft
                .report
                .notes
                .push(format!("the file has no bounds: they are {} m at most from all that is drawn", at_most(margin)));
        }
        if let Some(ends) = Aabb::around(self.ends.iter().copied()) {
            draft.bounds = draft.bounds.union(&ends);
        }
        let Aabb { min, max } = draft.bounds;
        if largest([min, max]) > FAR {
            draft.moved = middle(min, max);
            let shift = |p: Point| Point::new(p.x - draft.moved.x, p.y - draft.moved.y);
            draft.bounds = Aabb::of(shift(min), shift(max));
        }
        self.check_size(draft)
    }

    /// Refuses what a scenario has no room for.
    fn check_size(&self, draft: &Draft) -> Result<(), FormatError> {
        let Aabb { min, max } = draft.bounds;
        let [width, height] = [max.x - min.x, max.y - min.y];
        if width <= LARGEST && height <= LARGEST {
            return Ok(());
        }
        let sentence = format!(
            "the drawing is {width} x {height} m large; at most {LARGEST} m are allowed, so a scale may be needed"
        );
        Err(FormatError::new(Code::WorldTooLarge, sentence))
    }

    fn add_obstacles(&self, forms: Vec<Form>, draft: &mut Draft, options: &Options) -> Result<(), FormatError> {
        let is_one_with_holes = match &forms[..] {
            [Form::Area { rings, .. }] => rings.iter().filter(|ring| distinct(ring).is_some()).count() > 1,
            _ => false,
        };
        let walkable = options.walkable.unwrap_or(self.may_be_walkable && is_one_with_holes);
        let mut areas = Areas::default();
        let mut free = Vec::new();
        for form in forms {
            match form {
                Form::Area { rings, rule } if walkable => {
                    areas.add(&rings, rule, None)?;
                    for Region { outline, holes } in areas.regions.drain(..) {
                        free.push(directed(outline, 1));
                        free.extend(holes.into_iter().map(|hole| directed(hole, -1)));
                    }
                }
                Form::Area { rings, rule } => areas.add(&rings, rule, None)?,
                Form::Line { points, closed, width } => {
                    draft.add_wall(&points, width.unwrap_or_default(), closed)?;
                }
                Form::Disc { center, radius } => draft.discs.push((center, radius)),
                Form::Spot(place) => draft.discs.push((place, 0.0)),
            }
        }
        if walkable {
            areas.walls.clear();
            let before = areas.moved;
            areas.add(&free, FillRule::NonZero, Some(draft.bounds))?;
            // What was mended is no larger than it was: its borders are walls.
            areas.walls.clear();
            if areas.moved > 0.0 {
                areas.moved += before;
                let rings =
                    areas.regions.iter().flat_map(|region| std::iter::once(&region.outline).chain(&region.holes));
                areas.walls = rings.cloned().collect();
            }
            let how = if options.walkable.is_none() { ": it is one polygon with holes" } else { "" };
            draft
                .report
                .notes
                .push(format!("areas are where the robot may be, and the rest of the bounds is an obstacle{how}"));
        }
        for Region { outline, holes } in &areas.regions {
            let obstacle = Obstacle::polygon_with_holes(outline, holes)
                .map_err(|error| FormatError::new(Code::InvalidFile, error.message()))?;
            draft.made.push(obstacle);
        }
        for ring in &areas.walls {
            draft.add_wall(ring, 2.0 * areas.moved, true)?;
        }
        draft.report.grown = draft.report.grown.max(2.0 * areas.moved);
        if areas.mended > 0 {
            draft.report.notes.push(format!(
                "{} areas whose rings cross or touch were mended by their fill rule, and grown by at most {} m",
                areas.mended,
                at_most(2.0 * areas.moved)
            ));
        }
        if areas.flat > 0 {
            let what = if walkable { "left out" } else { "kept as walls without width" };
            draft.report.notes.push(format!("{} rings without area are {what}", areas.flat));
        }
        Ok(())
    }
}

impl Areas {
    /// Adds what rings fill, or what they leave of a frame.
    fn add(&mut self, rings: &[Vec<Point>], rule: FillRule, frame: Option<Aabb>) -> Result<(), FormatError> {
        let mut whole = Vec::with_capacity(rings.len());
        for ring in rings {
            match distinct(ring) {
                Some(ring) => whole.push(ring),
                None if ring.is_empty() => {}
                None => {
                    self.flat += 1;
                    self.walls.push(ring.clone());
                }
            }
        }
        if whole.is_empty() && frame.is_none() {
            return Ok(());
        }
        if frame.is_none() && is_simple(&whole, rule) {
            let mut rings = whole.into_iter();
            let outline = rings.next().unwrap_or_default();
            self.regions.push(Region { outline, holes: rings.collect() });
            return Ok(());
        }
        let exact = if meetings(&whole)? == 0 { nested(&whole, rule, frame) } else { None };
        match exact {
            Some(regions) => self.regions.extend(regions),
            None => {
                let (regions, moved) = mended(&whole, rule, frame);
                self.regions.extend(regions);
                self.moved = self.moved.max(moved);
                self.mended += 1;
                self.walls.extend(whole);
            }
        }
        Ok(())
    }
}

/// Whether the first ring is an outline and the others are its holes.
fn is_simple(rings: &[Vec<Point>], rule: FillRule) -> bool {
    let Some((outline, holes)) = rings.split_first() else { return false };
    if holes.is_empty() {
        return Polygon::new(outline).is_ok();
    }
    let turns = |hole: &Vec<Point>| rule == FillRule::EvenOdd || direction(hole) != direction(outline);
    holes.iter().all(turns) && Obstacle::polygon_with_holes(outline, holes).is_ok()
}

/// A simple ring in a direction: 1 for counter-clockwise.
fn directed(mut ring: Vec<Point>, way: i64) -> Vec<Point> {
    if direction(&ring) != way {
        ring.reverse();
    }
    ring
}

/// The box of a shape in metres.
fn extent(form: &Form) -> Aabb {
    let around = Aabb::around(form.points()).expect("a shape of a drawing has points");
    match form {
        Form::Line { width: Some(width), .. } => around.grown(width / 2.0),
        _ => around,
    }
}

/// A shape moved, without coordinates that are too small for exact predicates.
fn moved(form: Form, offset: Point) -> Form {
    let shift = |x: f64, by: f64| if (x - by).abs() < MIN_MAGNITUDE { 0.0 } else { x - by };
    let point = |p: Point| Point::new(shift(p.x, offset.x), shift(p.y, offset.y));
    let all = |points: Vec<Point>| points.into_iter().map(point).collect();
    match form {
        Form::Area { rings, rule } => Form::Area { rings: rings.into_iter().map(all).collect(), rule },
        Form::Line { points, closed, width } => Form::Line { points: all(points), closed, width },
        Form::Disc { center, radius } => Form::Disc { center: point(center), radius },
        Form::Spot(place) => Form::Spot(point(place)),
    }
}
