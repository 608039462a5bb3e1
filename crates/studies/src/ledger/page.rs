//! Tables of the rows for the book.

use super::{LedgerRow, Study, digits};

/// Returns a heading and a table for each study, in Markdown.
#[must_use]
pub fn page_table(rows: &[LedgerRow]) -> String {
    let table = |study: Study| {
        let rows = rows.iter().filter(|row| row.study == study).map(line);
        let (name, rows) = (study.name(), rows.collect::<String>());
        format!("### {name}, row by row\n\n{HEAD}{rows}")
    };
    Study::ALL.map(table).join("\n")
}

const HEAD: &str = "| in the study | subject | printed | result as printed | consistent | reading | in Machinist \
                    | checked by |\n\
                    | --- | --- | --- | --- | --- | --- | --- | --- |\n";

fn line(row: &LedgerRow) -> String {
    let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), digits);
    let unit = match row.unit {
        "" | "1" => String::new(),
        unit => format!(" [{unit}]"),
    };
    let cells = [
        row.at.to_owned(),
        format!("{}{unit}", row.figure),
        number(row.printed),
        number(row.as_printed),
        number(row.consistent),
        row.verdict.clone(),
        row.place.to_owned(),
        row.held.describe(),
    ];
    format!("| {} |\n", cells.map(|cell| cell.replace('|', "\\|")).join(" | "))
}
