//! Small multiples: one small chart a subject, all on the same axes, so that no band hides another.

use plotters::style::text_anchor::HPos;

use super::lines::{Line, Mark};
use super::plot::{Plot, Scales};
use super::strokes::Stroke;
use super::text::{Pen, leading, width, wrapped};
use super::{Area, Axes, FigureError, MARGIN, Picture, SMALL, picture};

/// One small chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Its subject, with its band.
    pub subject: Line,
    /// A number that sums it up, beside its name; empty for none.
    pub note: String,
    /// What it is compared with: a thin line without a band.
    pub context: Option<Line>,
}

/// Charts in rows of `columns`; `upright` is a place that is marked in all of them, with its name.
///
/// # Errors
/// [`FigureError`] without a finite point or a column.
///
/// ```
/// use host_sim::report::figure::{Axes, Line, Panel, Point, panels};
/// let line = Line::new("Sarsa(λ)", vec![Point::at(0.0, 1.0), Point::at(1.0, 2.0)]);
/// let panel = Panel { subject: line, note: "2 at last".to_owned(), context: None };
/// let picture = panels(&Axes::new("Recovery", "actions", "captures"), 2, &[panel], None)?;
/// assert!(picture.svg.contains("2 at last"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn panels(
    axes: &Axes,
    columns: usize,
    panels: &[Panel],
    upright: Option<(f64, &str)>,
) -> Result<Picture, FigureError> {
    let panels: Vec<Panel> = panels
        .iter()
        .map(|it| Panel {
            subject: it.subject.finite(),
            note: it.note.clone(),
            context: it.context.as_ref().map(Line::finite),
        })
        .collect();
    let lines = || {
        panels
            .iter()
            .flat_map(|it| [Some(&it.subject), it.context.as_ref()])
    };
    let points = lines().flatten().flat_map(|line| &line.points);
    let scales = Scales::of(axes, points.collect::<Vec<_>>().into_iter())?;
    let columns = columns.min(panels.len());
    if columns == 0 {
        return Err(FigureError("no panels".to_owned()));
    }
    let rows = panels.len().div_ceil(columns) as i32;
    let drawn = picture(axes, |page, area| {
        Pen::new(SMALL).write(page, &axes.y_label, (area.left, area.top))?;
        let named = panels.iter().find_map(|it| it.context.as_ref());
        if let Some(line) = named {
            let x = area.right - width(&line.label, SMALL) - 34;
            let y = area.top + leading(SMALL) / 2 - 2;
            Stroke::context().line(page, &[(x, y), (x + 26, y)])?;
            Pen::new(SMALL).write(page, &line.label, (x + 34, area.top))?;
        }
        let (top, bottom) = (area.top + 26, area.bottom - 24);
        let (wide, tall) = (
            (area.width() - (columns as i32 - 1) * MARGIN) / columns as i32,
            (bottom - top) / rows,
        );
        let names: Vec<Vec<String>> = panels
            .iter()
            .map(|it| wrapped(&it.subject.label, SMALL, wide - 8))
            .collect();
        let most = names.iter().map(Vec::len).max().unwrap_or(1) as i32;
        for (index, panel) in panels.iter().enumerate() {
            let (column, row) = ((index % columns) as i32, (index / columns) as i32);
            let left = area.left + column * (wide + MARGIN);
            let top = top + row * tall;
            Pen::new(SMALL).lines(page, &names[index], (left, top))?;
            let below = (left, top + names[index].len() as i32 * leading(SMALL));
            Pen::new(SMALL).dim().write(page, &panel.note, below)?;
            let head = (most + 1) * leading(SMALL) + 10;
            let around = Area {
                left,
                top: top + head,
                right: left + wide - 8,
                bottom: top + tall - 6,
            };
            let plot = Plot::draw(page, around, scales)?;
            if let Some((x, name)) = upright {
                plot.upright(x, Stroke::reference())?;
                if index == 0 {
                    let (x, y) = plot.place(x, scales.y.high);
                    Pen::new(SMALL).write(page, name, (x + 4, y - 2))?;
                }
            }
            if let Some(line) = &panel.context {
                plot.line(&line.points, Stroke::context())?;
            }
            let stroke = match panel.subject.mark {
                Mark::Solid => Stroke::of(0).bare(),
                Mark::Dashed => Stroke::reference(),
            };
            plot.band(&panel.subject.points, stroke.colour)?;
            plot.line(&panel.subject.points, stroke)?;
        }
        let middle = (area.left + area.right) / 2;
        Pen::new(SMALL)
            .across(HPos::Center)
            .write(page, &axes.x_label, (middle, bottom))
    })?;
    drawn.with_points(axes, lines().flatten())
}
