//! The shapes of an SVG file, where its transforms put them.

use super::css::Sheet;
use super::lengths::{fit, transform, view_box};
use super::page::Page;
use super::shapes::{attribute, covers, paths, stroke};
use super::style::Style;
use super::tree::{Element, Tree};
use crate::error::{Code, FormatError};
use crate::outline::{Affine, Shape};
use crate::vector::{Drawing, LayerId};
use std::collections::HashSet;
use std::rc::Rc;

/// The most elements that are drawn, those of `use` as often as they are used.
const MAX_DRAWN: usize = 1_000_000;

/// The layer of what is in none.
const NO_LAYER: &str = "page";

/// What is said of hidden elements.
const HIDDEN: &str = "elements that are not displayed, with all in them";

/// What an element is for.
enum Role {
    Drawn,
    /// It draws nothing where it is.
    Definition,
    /// It may show something, which is not read.
    LeftOut(&'static str),
}

fn role(name: &str) -> Role {
    match name {
        "svg" | "g" | "a" | "switch" | "use" | "rect" | "circle" | "ellipse" | "line" | "polyline" | "polygon"
        | "path" => Role::Drawn,
        "" | "defs" | "title" | "desc" | "metadata" | "style" | "linearGradient" | "radialGradient" | "pattern"
        | "clipPath" | "mask" | "marker" | "filter" | "symbol" | "view" | "cursor" => Role::Definition,
        "script" => Role::LeftOut("scripts, which are not run"),
        "image" => Role::LeftOut("images"),
        "text" => Role::LeftOut("texts"),
        "animate" | "animateTransform" | "animateMotion" | "animateColor" | "set" => Role::LeftOut("animations"),
        _ => Role::LeftOut("elements that are no shapes of SVG"),
    }
}

/// What an element takes over from those that it is in.
#[derive(Clone)]
struct Context {
    map: Affine,
    style: Style,
    /// What percentages are of.
    viewport: [f64; 2],
    layer: LayerId,
    has_layer: bool,
    /// Whether something above is not displayed, and no option names what is below.
    is_hidden: bool,
    uses: Option<Rc<Uses>>,
}

/// The elements whose use this is in.
struct Uses {
    target: usize,
    above: Option<Rc<Uses>>,
}

/// Draws the shapes.
pub struct Walker<'a> {
    tree: &'a Tree,
    sheet: &'a Sheet,
    page: &'a Page,
    chosen: Option<&'a [String]>,
    drawing: &'a mut Drawing,
    shapes: Vec<Shape>,
    drawn: usize,
    /// The layers that are not hidden.
    shown: HashSet<usize>,
    /// The element and what is around it.
    stack: Vec<(usize, Rc<Context>)>,
}

impl<'a> Walker<'a> {
    /// Returns the shapes, or an error and its byte.
    pub fn walk(
        tree: &'a Tree,
        sheet: &'a Sheet,
        page: &'a Page,
        chosen: Option<&'a [String]>,
        drawing: &'a mut Drawing,
    ) -> Result<Vec<Shape>, (FormatError, usize)> {
        let layer = drawing.layer(NO_LAYER);
        let context = Context {
            map: page.map,
            style: Style::default(),
            viewport: page.size,
            layer,
            has_layer: false,
            is_hidden: false,
            uses: None,
        };
        let mut walker = Self {
            tree,
            sheet,
            page,
            chosen,
            drawing,
            shapes: Vec::new(),
            drawn: 0,
            shown: HashSet::from([layer.0]),
            stack: Vec::new(),
        };
        walker.stack.push((0, Rc::new(context)));
        while let Some((i, above)) = walker.stack.pop() {
            walker.element(i, &above).map_err(|error| (error, tree.elements[i].byte))?;
        }
        Ok(walker.shapes)
    }

    fn drop(&mut self, what: &str) {
        self.drawing.drop(what, 1);
    }

    fn element(&mut self, i: usize, above: &Rc<Context>) -> Result<(), FormatError> {
        let element = &self.tree.elements[i];
        match role(&element.name) {
            Role::Definition => return Ok(()),
            Role::LeftOut(what) => {
                self.drop(what);
                return Ok(());
            }
            Role::Drawn => {}
        }
        self.drawn += 1;
        if self.drawn > MAX_DRAWN {
            let sentence = format!("more than {MAX_DRAWN} elements are drawn, with those that are used again");
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
        let style = above.style.of(self.tree, element, self.sheet)?;
        let mut context = Context { style, ..(**above).clone() };
        if !(context.style.display && context.style.opacity) {
            context.is_hidden = true;
        }
        self.choose_layer(element, &mut context);
        if context.is_hidden && self.chosen.is_none() {
            self.drop(HIDDEN);
            return Ok(());
        }
        let own = match &context.style.transform {
            Some(value) => transform(value)?,
            None => element.get("transform").map_or(Ok(Affine::IDENTITY), transform)?,
        };
        context.map = context.map * own;
        for (is_there, what) in [
            (context.style.clip, "clip paths: what they clip is whole"),
            (context.style.mask, "masks: what they mask is whole"),
            (context.style.filter, "filters"),
        ] {
            self.drawing.drop(what, usize::from(is_there));
        }
        match &*element.name {
            "use" => self.reuse(element, context),
            "svg" => {
                let context = if i == 0 { context } else { self.viewport(element, None, context)? };
                self.children(element, context);
                Ok(())
            }
            "g" | "a" => {
                self.children(element, context);
                Ok(())
            }
            "switch" => {
                let is_taken = |&&child: &&usize| {
                    let child = &self.tree.elements[child];
                    let is_ours = child
                        .get("systemLanguage")
                        .is_none_or(|languages| languages.split(',').any(|language| language.trim().starts_with("en")));
                    child.get("requiredExtensions").is_none() && is_ours && &*child.name != "foreignObject"
                };
                if let Some(&child) = element.children.iter().find(is_taken) {
                    self.stack.push((child, Rc::new(context)));
                }
                Ok(())
            }
            _ => self.shape(element, context),
        }
    }

    /// The layer is the innermost group that Inkscape calls a layer or that has a label, else the outermost group with
    /// an id. What the options name is a layer, whatever it is.
    fn choose_layer(&mut self, element: &Element, context: &mut Context) {
        let [label, id] = [element.get("label"), element.get("id")];
        let named = self
            .chosen
            .and_then(|chosen| [label, id].into_iter().flatten().find(|name| chosen.iter().any(|other| other == name)));
        if let Some(name) = named {
            context.layer = self.drawing.layer(name);
            (context.has_layer, context.is_hidden) = (true, false);
            return;
        }
        let current = &self.drawing.layer_mut(context.layer).name;
        let is_chosen = context.has_layer && self.chosen.is_some_and(|chosen| chosen.contains(current));
        if is_chosen || &*element.name != "g" {
            return;
        }
        if let Some(name) = label.or(id.filter(|_| !context.has_layer)) {
            context.layer = self.drawing.layer(name);
            context.has_layer = true;
            // A layer is hidden if all groups of its name are.
            if !context.is_hidden {
                self.shown.insert(context.layer.0);
            }
            self.drawing.layer_mut(context.layer).shown = self.shown.contains(&context.layer.0);
        }
    }

    /// The last child is drawn last.
    fn children(&mut self, element: &Element, context: Context) {
        let context = Rc::new(context);
        self.stack.extend(element.children.iter().rev().map(|&child| (child, Rc::clone(&context))));
    }

    fn reuse(&mut self, element: &Element, mut context: Context) -> Result<(), FormatError> {
        let Some(id) = element.get("href").map(str::trim) else { return Ok(()) };
        let Some(id) = id.strip_prefix('#') else {
            self.drop("uses of other files, which are not fetched");
            return Ok(());
        };
        let Some(&target) = self.tree.ids.get(id) else {
            self.drop("uses of what is not there");
            return Ok(());
        };
        let mut above = context.uses.as_ref();
        while let Some(uses) = above {
            if uses.target == target {
                self.drop("uses of what they are in");
                return Ok(());
            }
            above = uses.above.as_ref();
        }
        context.uses = Some(Rc::new(Uses { target, above: context.uses.take() }));
        let place = ["x", "y"].map(|name| attribute(element, name, context.viewport, usize::from(name == "y")));
        let [x, y] = [place[0].clone()?, place[1].clone()?].map(Option::unwrap_or_default);
        context.map = context.map * Affine::translation([x, y, 0.0]);
        let used = &self.tree.elements[target];
        if &*used.name == "symbol" || (&*used.name == "svg" && target != 0) {
            context.style = context.style.of(self.tree, used, self.sheet)?;
            let context = self.viewport(used, Some(element), context)?;
            self.children(used, context);
        } else {
            self.stack.push((target, Rc::new(context)));
        }
        Ok(())
    }

    /// The inside of a nested svg or a symbol; the element that uses it may give its size.
    fn viewport(
        &self,
        element: &Element,
        user: Option<&Element>,
        mut context: Context,
    ) -> Result<Context, FormatError> {
        let size = |name: &str, axis: usize| -> Result<f64, FormatError> {
            for source in user.into_iter().chain([element]) {
                if let Some(value) = attribute(source, name, context.viewport, axis)? {
                    return Ok(value);
                }
            }
            Ok(context.viewport[axis])
        };
        let [w, h] = [size("width", 0)?, size("height", 1)?];
        let x = attribute(element, "x", context.viewport, 0)?.unwrap_or(0.0);
        let y = attribute(element, "y", context.viewport, 1)?.unwrap_or(0.0);
        let mut map = Affine::translation([x, y, 0.0]);
        context.viewport = [w, h];
        if let Some(view) = view_box(element.get("viewBox"))? {
            map = map * fit(view, w, h, element.get("preserveAspectRatio"))?;
            context.viewport = [view.w, view.h];
        }
        context.map = context.map * map;
        Ok(context)
    }

    fn shape(&mut self, element: &Element, context: Context) -> Result<(), FormatError> {
        let style = &context.style;
        let fill = (style.fill && style.fill_opacity && &*element.name != "line").then_some(style.fill_rule);
        let stroke = if style.stroke && style.stroke_opacity {
            stroke(style, context.viewport, &context.map, self.page.pixel)?
        } else {
            None
        };
        if fill.is_none() && stroke.is_none() {
            self.drop("shapes without fill and stroke");
            return Ok(());
        }
        if context.is_hidden || !style.visible {
            self.drop(HIDDEN);
            return Ok(());
        }
        let (paths, circle) = paths(element, context.viewport)?;
        if paths.is_empty() {
            self.drop("shapes without extent");
            return Ok(());
        }
        self.drawing.drop("markers", usize::from(style.has_markers));
        self.drawing.drop("dashes: lines are whole", usize::from(style.is_dashed && stroke.is_some()));
        let shape = Shape { layer: context.layer, paths, circle, map: context.map, fill, stroke };
        if self.shapes.is_empty() && self.page.area.is_some_and(|page| covers(&shape, page)) {
            self.drop("backgrounds that cover the page");
            return Ok(());
        }
        self.shapes.push(shape);
        Ok(())
    }
}
