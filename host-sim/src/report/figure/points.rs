//! The points of a figure as a table, so that another program can draw or test them again.

use csv::Writer;

use super::lines::Line;
use super::{Axes, FigureError, Picture};

impl Picture {
    /// The picture with the points that it shows: a row each, with the line's name, both places and the
    /// ends of the band where it has one.
    pub(super) fn with_points<'a>(
        self,
        axes: &Axes,
        lines: impl Iterator<Item = &'a Line>,
    ) -> Result<Self, FigureError> {
        let unsaid = |why: csv::Error| FigureError(why.to_string());
        let mut table = Writer::from_writer(Vec::new());
        let heads = ["line", &axes.x_label, &axes.y_label, "low", "high"];
        table.write_record(heads).map_err(unsaid)?;
        for line in lines {
            for point in &line.points {
                let end = |end: Option<f64>| end.map_or_else(String::new, |it| it.to_string());
                let [x, y] = [point.x, point.y].map(|it| it.to_string());
                let low = end(point.band.map(|it| it.0));
                let high = end(point.band.map(|it| it.1));
                let row = [&line.label, &x, &y, &low, &high];
                table.write_record(row).map_err(unsaid)?;
            }
        }
        let bytes = table
            .into_inner()
            .map_err(|it| FigureError(it.to_string()))?;
        Ok(Self {
            csv: String::from_utf8(bytes).ok(),
            ..self
        })
    }
}
