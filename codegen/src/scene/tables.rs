//! Tables of the expression language: a column of a CSV file over its first column.

use crate::scene::layout::Scope;
use crate::scene::resolve::{Resolved, Resolver};
use crate::scene::spline::{self, Course};
use crate::scene::typed::{Typed, Uses};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::dimension::Angular;
use crate::spec::expression::{Ast, Node};
use crate::spec::{did_you_mean, quoted};
use machinist_algebra::expr::{Expr, Function};
use machinist_model::{Name, Table, TableId};

impl Resolver<'_> {
    /// Resolves a table at an argument of the dimension of its first column.
    pub(super) fn table(
        &mut self,
        (file, column, course): (&Ast, &Ast, Course),
        x: &Ast,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let (Node::Text(path), Node::Text(name)) = (&file.node, &column.node) else {
            let mistake = Mistake::new(
                Code::WrongArguments,
                file.span.to(column.span),
                "a table needs two quoted texts",
                "here",
            );
            return Err(Box::new(mistake.help("write table('file.csv', 'column', x)")));
        };
        let spec = self.spec;
        let found = spec.tables.iter().position(|t| t.spec == file.span.file && t.path == *path);
        let Some(index) = found else {
            return Err(Box::new(Mistake::new(
                Code::InvalidTable,
                file.span,
                "this table was not read",
                "here",
            )));
        };
        let columns = &spec.tables[index].columns;
        let place = columns.iter().skip(1).position(|c| c.name == *name).map(|place| place + 1);
        let Some(place) = place else {
            let message = format!("the table has no column {}", quoted(name));
            let help = did_you_mean(name, columns.iter().skip(1).map(|c| c.name.as_str()));
            return Err(Box::new(
                Mistake::new(Code::UnknownName, column.span, message, "unknown").help(help),
            ));
        };
        let argument = self.resolve(x, scope, allowed)?;
        let abscissa = &columns[0];
        if argument.dimension.is_some_and(|dimension| dimension != abscissa.unit.dimension) {
            let wanted = abscissa.unit.dimension;
            let message =
                format!("the table's first column {} is in {wanted}", quoted(&abscissa.name));
            return Err(Box::new(Mistake::new(
                Code::DimensionMismatch,
                x.span,
                message,
                "of another dimension",
            )));
        }
        let mut typed = Typed::over(&[&argument]);
        typed.dimension = Some(columns[place].unit.dimension);
        typed.angular = Angular::of(columns[place].unit, argument.uses.moves());
        let table = self.table_id((index, place, course), column.span)?;
        typed.expr = Expr::Call(Function::Table { table, order: 0 }, vec![argument.expr]);
        Ok(typed)
    }

    /// Warns of a spline that was not requested by name and that overshoots its data.
    pub(super) fn warn_of_overshoot(&mut self, file: &Ast, column: &Ast) {
        let (Node::Text(path), Node::Text(name)) = (&file.node, &column.node) else { return };
        let spec = self.spec;
        let Some(csv) = spec.tables.iter().find(|t| t.spec == file.span.file && t.path == *path)
        else {
            return;
        };
        let Some(y) = csv.columns.iter().find(|column| column.name == *name) else { return };
        let x = &csv.columns[0].values;
        let Some(coefficients) = spline::natural(x, &y.values) else { return };
        let Some(found) = spline::overshoot(x, &y.values, &coefficients) else { return };
        let short = |value: f64| format!("{}", format!("{value:.3e}").parse().unwrap_or(value));
        let [low, high] = found.range.map(short);
        let message = format!(
            "the natural cubic spline through {} of {} overshoots: it reaches {} between rows {} \
             and {}, where the rows around are {low} to {high}",
            quoted(name),
            quoted(path),
            short(found.reached),
            found.row + 1,
            found.row + 2,
        );
        let help = format!(
            "write table(\"{path}\", \"{name}\", x, \"monotone\"), which stays within its \
             data, or \"linear\"; \"natural\" there keeps this curve without a warning"
        );
        let span = csv.rows[found.row].to(csv.rows[found.row + 1]);
        let warning =
            Mistake::new(Code::InvalidTable, span, message, "between these rows").help(help);
        if !self.warnings.contains(&warning) {
            self.warnings.push(warning);
        }
    }

    /// Returns the table of a column, created at its first use.
    fn table_id(
        &mut self,
        (index, column, course): (usize, usize, Course),
        span: Span,
    ) -> Result<TableId, Box<Mistake>> {
        let known = self.table_columns.iter().position(|known| *known == (index, column, course));
        if let Some(known) = known {
            return Ok(TableId(known as u32));
        }
        let csv = &self.spec.tables[index];
        let (x, y) = (&csv.columns[0], &csv.columns[column]);
        let Some(coefficients) = spline::through(course, &x.values, &y.values) else {
            let message = "this column cannot be interpolated: its numbers are too far apart";
            return Err(Box::new(Mistake::new(Code::InvalidTable, span, message, "here")));
        };
        let stem = csv.path.rsplit('/').next().unwrap_or_default().split('.').next();
        let stem = stem.unwrap_or_default();
        let path = format!("{}:{}", csv.path, y.name);
        let mut ident: String = format!("table_{stem}_{}", y.name);
        ident = ident.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        let taken = |ident: &str| self.tables.iter().any(|table| table.name.ident == ident);
        let mut unique = ident.clone();
        for number in 2.. {
            if !taken(&unique) {
                break;
            }
            unique = format!("{ident}_{number}");
        }
        let latex = format!(r"\mathrm{{{}}}", y.name.replace('_', r"\_"));
        let name = Name { path, ident: unique, latex };
        self.tables.push(Table { name, knots: x.values.clone(), coefficients });
        self.table_columns.push((index, column, course));
        Ok(TableId(self.tables.len() as u32 - 1))
    }
}

/// Returns the kind of curve between the knots of a table.
pub(super) fn course_of(ast: &Ast) -> Result<Course, Box<Mistake>> {
    let known =
        [("natural", Course::Natural), ("linear", Course::Linear), ("monotone", Course::Monotone)];
    let Node::Text(text) = &ast.node else {
        let mistake = Mistake::new(
            Code::WrongArguments,
            ast.span,
            "the interpolation must be quoted",
            "not a text",
        );
        return Err(Box::new(mistake.help("write \"linear\", \"monotone\" or \"natural\"")));
    };
    let found = known.iter().find(|(name, _)| name == text);
    found.map(|(_, course)| *course).ok_or_else(|| {
        let message = format!("unknown interpolation {}", quoted(text));
        let help = did_you_mean(text, known.iter().map(|(name, _)| *name));
        Box::new(Mistake::new(Code::UnknownChoice, ast.span, message, "unknown").help(help))
    })
}
