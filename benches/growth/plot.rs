//! The curves as a picture: a panel for each quantity, both axes logarithmic, the exponent of each curve beside its name, and a line
//! that grows like x log x.

use super::time::Curve;
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

/// The size of a panel in pixels; there are two in a row.
const PANEL: (u32, u32) = (500, 350);

/// In pixels: around a panel, below an axis, and of a line of a legend.
const MARGIN: u32 = 14;
const X_LABELS: u32 = 44;
const LINE: usize = 19;

/// Light, so that the picture looks the same on light and on dark pages.
const BACKGROUND: RGBColor = RGBColor(246, 248, 250);
const INK: RGBColor = RGBColor(31, 35, 40);
const GUIDE: RGBColor = RGBColor(110, 119, 129);
const GRID: RGBColor = RGBColor(208, 215, 222);

/// Colours that remain distinct to colour-blind readers (Okabe and Ito 2008, "Color universal design").
const COLOURS: [RGBColor; 3] = [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 140, 104)];

/// Draws the curves; those of a quantity must follow one another.
///
/// # Errors
/// If the file cannot be written.
pub fn draw(curves: &[Curve], file: &Path) -> Result<(), Box<dyn Error>> {
    let panels: Vec<&[Curve]> = curves.chunk_by(|a, b| a.quantity == b.quantity).collect();
    let rows = panels.len().div_ceil(2);
    let area = SVGBackend::new(file, (2 * PANEL.0, rows as u32 * PANEL.1)).into_drawing_area();
    area.fill(&BACKGROUND)?;
    for (place, curves) in area.split_evenly((rows, 2)).iter().zip(panels) {
        panel(place, curves)?;
    }
    area.present()?;
    Ok(())
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

fn panel(area: &Area, curves: &[Curve]) -> Result<(), Box<dyn Error>> {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let (left, right) = extent(points().map(|point| point.x as f64));
    let (bottom, top) = extent(points().map(|point| point.seconds));
    let bottom = 10_f64.powf(bottom.log10().floor());
    // The legend has a line for each curve and one more; the curves stay below it.
    let legend = (LINE * (curves.len() + 2)) as f64 / (PANEL.1 - MARGIN - X_LABELS) as f64;
    let highest = bottom * (top / bottom).powf(1.0 / (1.0 - legend));
    let text = |size: u32| ("sans-serif", size).into_font().color(&INK);
    let is_wide = right / left > 100.0;
    let x_marks: Vec<f64> =
        if is_wide { powers(left, right) } else { curves[0].points.iter().map(|point| point.x as f64).collect() };
    let mut chart = ChartBuilder::on(area)
        .margin(MARGIN)
        .margin_right(36)
        .x_label_area_size(X_LABELS)
        .y_label_area_size(78)
        .build_cartesian_2d(
            (left..right).log_scale().with_key_points(x_marks),
            (bottom..highest).log_scale().with_key_points(powers(bottom, highest)),
        )?;
    chart
        .configure_mesh()
        .x_desc(curves[0].quantity.as_str())
        .y_desc("time")
        .x_label_formatter(&|&x| if is_wide { power(x) } else { x.to_string() })
        .y_label_formatter(&|&seconds| duration(seconds))
        .axis_style(INK)
        .bold_line_style(GRID)
        .light_line_style(GRID)
        .label_style(text(15))
        .axis_desc_style(text(17))
        .draw()?;
    for (curve, colour) in curves.iter().zip(COLOURS) {
        let line = || curve.points.iter().map(|point| (point.x as f64, point.seconds));
        chart
            .draw_series(LineSeries::new(line(), colour.stroke_width(2)).point_size(3))?
            .label(format!("{}: slope {:.2}", curve.name, curve.exponent()))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(3)));
    }
    let start = &curves[0].points[0];
    let log_linear = |x: f64| start.seconds * x * x.ln() / (start.x as f64 * (start.x as f64).ln());
    let guide = (0..=100).map(|i| left * (right / left).powf(i as f64 / 100.0)).map(|x| (x, log_linear(x)));
    chart
        .draw_series(LineSeries::new(guide.filter(|&(_, y)| y <= top), GUIDE))?
        .label("like x log x")
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], GUIDE));
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(BACKGROUND)
        .label_font(text(15))
        .draw()?;
    Ok(())
}

/// The least and the greatest of some positive values.
fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, 0.0), |(least, most), value| (value.min(least), value.max(most)))
}

/// The powers of ten in a range.
fn powers(from: f64, to: f64) -> Vec<f64> {
    let [first, last] = [from.log10().ceil(), (to.log10() + 1e-9).floor()].map(|exponent| exponent as i32);
    (first..=last).map(|exponent| 10_f64.powi(exponent)).collect()
}

/// A power of ten from 1 on, with a thin space between thousands.
fn power(x: f64) -> String {
    match x {
        x if x >= 1e6 => format!("{} million", x / 1e6),
        x if x >= 1e4 => format!("{}\u{2009}000", x / 1e3),
        x => x.to_string(),
    }
}

/// Seconds with a unit and up to three digits.
pub fn duration(seconds: f64) -> String {
    let (factor, unit) = [(1.0, "s"), (1e3, "ms"), (1e6, "µs"), (1e9, "ns")]
        .into_iter()
        .find(|(factor, _)| seconds * factor >= 0.9995)
        .unwrap_or((1e9, "ns"));
    let value = seconds * factor;
    let digits = 2 - (value.log10() + 1e-9).floor().clamp(0.0, 2.0) as usize;
    let text = format!("{value:.digits$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    format!("{text} {unit}")
}
