//! Drawings: areas, lines and discs on layers, in the coordinates of a file.
//!
//! Readers of vector formats fill a [`Drawing`]; obstacles are made of it in one way for all of them. What a reader
//! leaves out it counts with [`Drawing::drop`].

mod convert;
mod mend;
mod rings;

pub use rings::direction;

use planarium::geometry::{Aabb, Point};
use std::collections::{BTreeMap, HashMap};

/// Which places are inside rings that cross themselves or each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FillRule {
    /// Those that the rings wind about.
    NonZero,
    /// Those from which a ray meets the rings an odd number of times.
    EvenOdd,
}

impl FillRule {
    /// Whether places are inside that the rings wind about this often.
    pub fn fills(self, winding: i64) -> bool {
        match self {
            Self::NonZero => winding != 0,
            Self::EvenOdd => winding % 2 != 0,
        }
    }
}

/// A shape. Lengths are in units of the file.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// What is inside of rings; the last point of a ring is joined to its first, whether or not they are the same.
    Area { rings: Vec<Vec<Point>>, rule: FillRule },
    /// All points within half the width of a polyline; without a width that of the options counts, in metres.
    Line { points: Vec<Point>, closed: bool, width: Option<f64> },
    /// A disc.
    Disc { center: Point, radius: f64 },
    /// A place: a disc whose diameter is the wall thickness of the options.
    Spot(Point),
}

impl Form {
    /// All its points; of discs the corners of the box.
    pub fn points(&self) -> Box<dyn Iterator<Item = Point> + '_> {
        match self {
            Self::Area { rings, .. } => Box::new(rings.iter().flatten().copied()),
            Self::Line { points, .. } => Box::new(points.iter().copied()),
            Self::Spot(point) => Box::new(std::iter::once(*point)),
            &Self::Disc { center, radius } => {
                Box::new([-radius, radius].into_iter().map(move |r| Point::new(center.x + r, center.y + r)))
            }
        }
    }
}

/// The way from the coordinates of a file to metres: (x - origin) times scale, for each axis. Where y points down, its
/// scale is negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    pub origin: Point,
    pub scale: [f64; 2],
}

impl Frame {
    /// So many metres per unit, y up.
    pub fn of_scale(scale: f64) -> Self {
        Self { origin: Point::origin(), scale: [scale; 2] }
    }

    /// A point of the file, in metres.
    pub fn to_metres(self, p: Point) -> Point {
        Point::new((p.x - self.origin.x) * self.scale[0], (p.y - self.origin.y) * self.scale[1])
    }

    /// A length of the file in metres, the larger one where the axes differ.
    pub fn length(self, length: f64) -> f64 {
        length * self.scale[0].abs().max(self.scale[1].abs())
    }
}

/// The number of a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LayerId(pub usize);

/// A layer of a drawing.
#[derive(Debug, Clone)]
pub struct Layer {
    pub name: String,
    /// Whether the file shows it; what is hidden is left out, unless the options name the layer.
    pub shown: bool,
    /// Whether it is left out for another reason, such as doors; the options can name it as well.
    pub omitted: Option<&'static str>,
    /// How many shapes it has.
    pub count: usize,
}

/// What a file draws.
#[derive(Debug, Clone, Default)]
pub struct Drawing {
    shapes: Vec<(LayerId, Form)>,
    layers: Vec<Layer>,
    by_name: HashMap<String, usize>,
    dropped: BTreeMap<String, usize>,
    /// The area that the file declares as its page, in its coordinates; else the bounds are the box of all shapes.
    pub page: Option<Aabb>,
    /// The thickness of lines that have no width, in metres, unless the options say it.
    pub wall_thickness: f64,
    /// The farthest that curves were grown when they became polygons, in units of the file.
    pub flattened: f64,
    /// What the report says first.
    pub notes: Vec<String>,
    /// Places in metres that belong within the bounds.
    pub ends: Vec<Point>,
    /// Whether a file that is one polygon with holes is taken for where the robot may be.
    pub may_be_walkable: bool,
}

impl Drawing {
    /// Nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// The layer of a name: a new one, which is shown, or that which has the name already.
    pub fn layer(&mut self, name: &str) -> LayerId {
        if let Some(&i) = self.by_name.get(name) {
            return LayerId(i);
        }
        let i = self.layers.len();
        self.by_name.insert(name.to_owned(), i);
        self.layers.push(Layer { name: name.to_owned(), shown: true, omitted: None, count: 0 });
        LayerId(i)
    }

    /// A layer, to say that it is hidden or omitted.
    pub fn layer_mut(&mut self, id: LayerId) -> &mut Layer {
        &mut self.layers[id.0]
    }

    /// All layers.
    pub fn layers_mut(&mut self) -> impl Iterator<Item = &mut Layer> {
        self.layers.iter_mut()
    }

    /// Adds a shape; one without points is counted as left out.
    pub fn push(&mut self, layer: LayerId, form: Form) {
        if form.points().next().is_none() {
            self.drop("empty geometries", 1);
            return;
        }
        self.layers[layer.0].count += 1;
        self.shapes.push((layer, form));
    }

    /// Counts what is left out, in words of the plural.
    pub fn drop(&mut self, what: &str, count: usize) {
        if count > 0 {
            *self.dropped.entry(what.to_owned()).or_default() += count;
        }
    }

    /// The box of all points, in coordinates of the file; `None` if nothing is drawn.
    pub fn extent(&self) -> Option<Aabb> {
        Aabb::around(self.shapes.iter().flat_map(|(_, form)| form.points()))
    }
}
