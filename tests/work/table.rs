//! The table of work on a page, and its comparison.

use machinist::Method;
use machinist::method::Work;

/// Marks on the lines before and after the table in a page.
const MARKS: [&str; 2] = ["<!-- table of work -->", "<!-- end of it -->"];
const HEAD: &str = "| scene | method | steps | rejected | rates | Jacobians | factorizations | \
                    Newton iterations | events |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
/// Counters, as in the head of the table.
const COUNTERS: [&str; 7] =
    ["steps", "rejected", "rates", "Jacobians", "factorizations", "Newton iterations", "events"];

/// Relative tolerance of a counter.
const PART: f64 = 0.05;
/// Absolute tolerance of a counter.
const FEW: f64 = 2.0;

/// Work of one run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    pub scene: String,
    pub method: String,
    counts: [u64; COUNTERS.len()],
}

impl Row {
    pub fn new(scene: &str, method: Method, work: Work) -> Self {
        let Work {
            steps,
            rejected,
            rate_evaluations,
            jacobian_evaluations,
            factorizations,
            newton_iterations,
            switches,
        } = work;
        let counts = [
            steps,
            rejected,
            rate_evaluations,
            jacobian_evaluations,
            factorizations,
            newton_iterations,
            switches,
        ];
        Self { scene: scene.to_owned(), method: method.name().to_owned(), counts }
    }

    /// Parses a line such as `| saw_gin | auto | 147 | ...`.
    fn read(line: &str) -> Self {
        let cells = line.trim_matches('|').split('|').map(str::trim).collect::<Vec<_>>();
        let [scene, method, counts @ ..] = cells.as_slice() else { panic!("no row: {line}") };
        let count = |cell: &&str| cell.parse().unwrap_or_else(|_| panic!("no number: {line}"));
        let counts: Vec<u64> = counts.iter().map(count).collect();
        let counts = counts.try_into().unwrap_or_else(|_| panic!("too few or too many: {line}"));
        Self { scene: (*scene).to_owned(), method: (*method).to_owned(), counts }
    }

    fn line(&self) -> String {
        let counts = self.counts.map(|count| count.to_string()).join(" | ");
        format!("| {} | {} | {counts} |\n", self.scene, self.method)
    }

    /// Returns the counters that are worse or better than before.
    fn differences(&self, told: &Self) -> Vec<String> {
        let of = |((what, was), is): ((&str, u64), u64)| {
            let more = is as f64 - was as f64;
            if more.abs() <= FEW || more.abs() <= was as f64 * PART {
                return None;
            }
            let verdict = if more > 0.0 { "worse" } else { "better, which the table should tell" };
            let percent = match was {
                0 => "from none".to_owned(),
                was => format!("{:+.1} %", more / was as f64 * 100.0),
            };
            let Self { scene, method, .. } = self;
            Some(format!("{scene} by {method}: {what} was {was}, is {is} ({percent}): {verdict}"))
        };
        COUNTERS.into_iter().zip(told.counts).zip(self.counts).filter_map(of).collect()
    }
}

/// Rows in their order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    pub rows: Vec<Row>,
}

impl Table {
    /// Reads the table of a page.
    pub fn read(page: &str) -> Self {
        let [_, table, _] = parts(page);
        let lines = table.strip_prefix(HEAD).expect("the head of the table").lines();
        Self { rows: lines.map(Row::read).collect() }
    }

    /// Returns the page with this table.
    pub fn put_into(&self, page: &str) -> String {
        let [before, _, after] = parts(page);
        let lines: String = self.rows.iter().map(Row::line).collect();
        format!("{before}{HEAD}{lines}{after}")
    }

    /// Returns the differences to a table beyond the tolerance, missing scenes, and superfluous
    /// ones.
    pub fn differences(&self, told: &Self) -> Vec<String> {
        let find = |rows: &[Row], row: &Row| {
            let is_it = |other: &&Row| (&other.scene, &other.method) == (&row.scene, &row.method);
            rows.iter().find(is_it).cloned()
        };
        let of_row = |row: &Row| match find(&told.rows, row) {
            Some(told) => row.differences(&told),
            None => vec![format!("{} by {}: not in the table", row.scene, row.method)],
        };
        let mut found: Vec<String> = self.rows.iter().flat_map(of_row).collect();
        let gone = told.rows.iter().filter(|row| find(&self.rows, row).is_none());
        found.extend(gone.map(|row| format!("{} by {}: there is none", row.scene, row.method)));
        found
    }
}

/// Returns the text before the table, the table, and the text after it.
fn parts(page: &str) -> [&str; 3] {
    let [start, end] = MARKS.map(|mark| page.find(mark).unwrap_or_else(|| panic!("no {mark}")));
    let start = start + MARKS[0].len() + "\n\n".len();
    let end = end - "\n".len();
    [&page[..start], &page[start..end], &page[end..]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn work(steps: u64, rates: u64) -> Work {
        Work { steps, rate_evaluations: rates, ..Work::default() }
    }

    fn table(rows: &[(&str, u64, u64)]) -> Table {
        let row = |(scene, steps, rates): &(&str, u64, u64)| {
            Row::new(scene, Method::Auto, work(*steps, *rates))
        };
        Table { rows: rows.iter().map(row).collect() }
    }

    #[test]
    fn a_scene_that_takes_more_is_named_with_what_it_took() {
        let told = table(&[("a", 100, 1000), ("b", 3, 0)]);
        let more = table(&[("a", 105, 1051), ("b", 6, 3)]);
        assert_eq!(
            more.differences(&told),
            [
                "a by auto: rates was 1000, is 1051 (+5.1 %): worse",
                "b by auto: steps was 3, is 6 (+100.0 %): worse",
                "b by auto: rates was 0, is 3 (from none): worse",
            ]
        );
    }

    #[test]
    fn one_that_takes_less_is_to_be_told_and_little_is_nothing() {
        let told = table(&[("a", 100, 1000), ("b", 3, 0)]);
        assert_eq!(table(&[("a", 105, 950), ("b", 5, 2)]).differences(&told), [""; 0]);
        assert_eq!(
            table(&[("a", 100, 900), ("b", 3, 0)]).differences(&told),
            ["a by auto: rates was 1000, is 900 (-10.0 %): better, which the table should tell"]
        );
    }

    #[test]
    fn scenes_that_one_has_alone_are_named() {
        assert_eq!(
            table(&[("a", 1, 1), ("c", 1, 1)]).differences(&table(&[("a", 1, 1), ("b", 1, 1)])),
            ["c by auto: not in the table", "b by auto: there is none"]
        );
    }

    #[test]
    fn what_is_written_into_a_page_is_read_from_it() {
        let page = format!("# Work\n\n{}\n\n{HEAD}\n{}\n\nmore\n", MARKS[0], MARKS[1]);
        let rows = table(&[("a", 1, 20), ("parts/b", 3, 4)]);
        let written = rows.put_into(&page);
        assert!(written.starts_with("# Work\n") && written.ends_with("\nmore\n"));
        assert_eq!(Table::read(&written), rows);
        assert_eq!(table(&[]).put_into(&written), page);
    }
}
