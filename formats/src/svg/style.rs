//! How an element is drawn: by its attributes, its style sheet and its style attribute, and by what it inherits.

use super::css::{Sheet, declarations};
use super::tree::{Element, Tree};
use crate::error::{Code, FormatError, quoted};
use crate::outline::Cap;
use crate::vector::FillRule;

/// The properties that count. Opacities are true if something is seen.
#[derive(Debug, Clone)]
pub struct Style {
    pub fill: bool,
    pub fill_opacity: bool,
    pub fill_rule: FillRule,
    pub stroke: bool,
    pub stroke_opacity: bool,
    /// A length as it is written.
    pub stroke_width: String,
    pub cap: Cap,
    pub is_mitred: bool,
    pub miter_limit: f64,
    pub is_dashed: bool,
    pub has_markers: bool,
    pub visible: bool,
    // What is not inherited:
    pub display: bool,
    pub opacity: bool,
    pub keeps_width: bool,
    pub clip: bool,
    pub mask: bool,
    pub filter: bool,
    /// A transform of CSS, which comes instead of the attribute.
    pub transform: Option<String>,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            fill: true,
            fill_opacity: true,
            fill_rule: FillRule::NonZero,
            stroke: false,
            stroke_opacity: true,
            stroke_width: "1".to_owned(),
            cap: Cap::ButtOrRound,
            is_mitred: true,
            miter_limit: 4.0,
            is_dashed: false,
            has_markers: false,
            visible: true,
            display: true,
            opacity: true,
            keeps_width: false,
            clip: false,
            mask: false,
            filter: false,
            transform: None,
        }
    }
}

impl Style {
    /// The style of an element whose parent has this one.
    pub fn of(&self, tree: &Tree, element: &Element, sheet: &Sheet) -> Result<Self, FormatError> {
        let initial = Self::default();
        let mut style = Self {
            display: initial.display,
            opacity: initial.opacity,
            keeps_width: initial.keeps_width,
            clip: initial.clip,
            mask: initial.mask,
            filter: initial.filter,
            transform: initial.transform,
            ..self.clone()
        };
        for (name, value) in element.attributes().filter(|(name, _)| *name != "transform") {
            style.set(name, value, self)?;
        }
        let sheet = sheet.of(tree, element)?;
        let own = declarations(element.get("style").unwrap_or(""));
        for important in [false, true] {
            for declaration in sheet.iter().copied().chain(&own).filter(|one| one.is_important == important) {
                style.set(&declaration.name, &declaration.value, self)?;
            }
        }
        Ok(style)
    }

    /// Sets a property. Values that mean nothing change nothing, as in browsers.
    fn set(&mut self, name: &str, value: &str, parent: &Self) -> Result<(), FormatError> {
        let value = value.trim();
        if value == "inherit" {
            self.inherit(name, parent);
            return Ok(());
        }
        match name {
            "fill" => self.fill = is_seen(value),
            "stroke" => self.stroke = is_seen(value),
            "fill-opacity" => self.fill_opacity = is_opaque(value),
            "stroke-opacity" => self.stroke_opacity = is_opaque(value),
            "opacity" => self.opacity = is_opaque(value),
            "fill-rule" => match value {
                "evenodd" => self.fill_rule = FillRule::EvenOdd,
                "nonzero" => self.fill_rule = FillRule::NonZero,
                _ => {}
            },
            "stroke-width" => value.clone_into(&mut self.stroke_width),
            "stroke-linecap" => match value {
                "square" => self.cap = Cap::Square,
                "butt" | "round" => self.cap = Cap::ButtOrRound,
                _ => {}
            },
            "stroke-linejoin" => match value {
                "round" | "bevel" => self.is_mitred = false,
                "miter" | "miter-clip" | "arcs" => self.is_mitred = true,
                _ => {}
            },
            "stroke-miterlimit" => {
                if let Ok(limit) = value.parse::<f64>()
                    && limit >= 1.0
                {
                    self.miter_limit = limit;
                }
            }
            "stroke-dasharray" => self.is_dashed = value != "none",
            "marker" | "marker-start" | "marker-mid" | "marker-end" => self.has_markers = value != "none",
            "visibility" => self.visible = !matches!(value, "hidden" | "collapse"),
            "display" => self.display = value != "none",
            "vector-effect" => self.keeps_width = value == "non-scaling-stroke",
            "clip-path" => self.clip = value != "none",
            "mask" => self.mask = value != "none",
            "filter" => self.filter = value != "none",
            "transform" if value == "none" => self.transform = None,
            // Lengths and angles have units in CSS, where pixels and degrees are those of the attribute.
            "transform" => self.transform = Some(value.replace("px", "").replace("deg", "")),
            "transform-origin" | "transform-box" | "translate" | "rotate" | "scale" | "offset-path" | "zoom"
                if !matches!(value, "none" | "0 0" | "0px 0px" | "view-box") =>
            {
                let sentence = format!("the property {name} ({}) is not read", quoted(value.as_bytes()));
                return Err(FormatError::new(Code::UnsupportedFeature, sentence));
            }
            _ => {}
        }
        Ok(())
    }

    fn inherit(&mut self, name: &str, parent: &Self) {
        match name {
            "fill" => self.fill = parent.fill,
            "stroke" => self.stroke = parent.stroke,
            "fill-opacity" => self.fill_opacity = parent.fill_opacity,
            "stroke-opacity" => self.stroke_opacity = parent.stroke_opacity,
            "opacity" => self.opacity = parent.opacity,
            "fill-rule" => self.fill_rule = parent.fill_rule,
            "stroke-width" => self.stroke_width.clone_from(&parent.stroke_width),
            "stroke-linecap" => self.cap = parent.cap,
            "stroke-linejoin" => self.is_mitred = parent.is_mitred,
            "stroke-miterlimit" => self.miter_limit = parent.miter_limit,
            "visibility" => self.visible = parent.visible,
            "display" => self.display = parent.display,
            "vector-effect" => self.keeps_width = parent.keeps_width,
            _ => {}
        }
    }
}

/// Whether a paint leaves anything to see.
fn is_seen(paint: &str) -> bool {
    let paint = paint.to_ascii_lowercase();
    if paint == "none" || paint == "transparent" {
        return false;
    }
    if let Some(digits) = paint.strip_prefix('#') {
        return !((digits.len() == 4 && digits.ends_with('0')) || (digits.len() == 8 && digits.ends_with("00")));
    }
    let inside = paint.split_once('(').map(|(name, rest)| (name, rest.trim_end_matches(')')));
    let Some(("rgb" | "rgba" | "hsl" | "hsla", numbers)) = inside else { return true };
    let has_alpha = numbers.contains('/') || numbers.split(',').count() == 4;
    !has_alpha || is_opaque(numbers.rsplit(['/', ',']).next().unwrap_or(""))
}

/// Whether an opacity is not 0.
fn is_opaque(value: &str) -> bool {
    !value.trim().trim_end_matches('%').parse::<f64>().is_ok_and(|opacity| opacity <= 0.0)
}
