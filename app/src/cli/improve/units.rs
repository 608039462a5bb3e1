//! Units of measure of expressions over a run, if the program can read them.

#[cfg(feature = "derive")]
pub use readable::{check, check_sides, in_one_unit, of, sides_in_one_unit};
#[cfg(not(feature = "derive"))]
pub use unread::{check, check_sides, in_one_unit, of, sides_in_one_unit};

#[cfg(feature = "derive")]
mod readable {
    use machinist::improve::{
        Expression, ExpressionError, Function, Inequality, Node, Operator, Reduction,
    };
    use machinist_codegen::spec::dimension::Dimension;
    use machinist_codegen::spec::measure::Measure;
    use machinist_contract::Simulator;

    /// Dimension; `None` for a bare number, which takes the unit of the other operand.
    type Known = Option<Dimension>;

    /// Returns an error for sums of different quantities, and for functions of quantities with a
    /// unit.
    pub fn check(
        expression: &Expression,
        simulator: &dyn Simulator<f64>,
    ) -> Result<(), ExpressionError> {
        dimension(expression, simulator).map(|_| ())
    }

    /// Like [`check`] for both sides, which must also have the same dimension.
    pub fn check_sides(
        inequality: &Inequality,
        simulator: &dyn Simulator<f64>,
    ) -> Result<(), ExpressionError> {
        let left = dimension(&inequality.left, simulator)?;
        let right = dimension(&inequality.right, simulator)?;
        let sides = (&inequality.left, &inequality.right);
        alike((left, right), sides, simulator).map(|_| ())
    }

    /// Converts an expression to consistent units: it keeps the unit of a quantity if it only takes
    /// one number of it, and uses SI units otherwise.
    pub fn in_one_unit(expression: Expression, simulator: &dyn Simulator<f64>) -> Expression {
        let stays = plain(&expression, simulator).is_some();
        if stays { expression } else { in_si(expression, simulator) }
    }

    /// Converts both sides to consistent units, that of the left side if it takes one number of one
    /// quantity.
    pub fn sides_in_one_unit(sides: Inequality, simulator: &dyn Simulator<f64>) -> Inequality {
        let Inequality { left, right, is_at_most } = sides;
        let unit = plain(&left, simulator).and_then(|unit| Measure::parse(&unit).ok());
        let mut right = in_si(right, simulator);
        if let Some(Measure { factor, .. }) = unit
            && !factor.is_one()
        {
            let range = right.range.clone();
            let node = Node::Number(factor.to_f64(), None);
            let by = Box::new(Expression { node, range: range.clone() });
            right = Expression { node: Node::Binary(Operator::Divide, Box::new(right), by), range };
        }
        Inequality { left: in_one_unit(left, simulator), right, is_at_most }
    }

    /// Converts an expression to SI units: quantities shown in other units and numbers with a unit
    /// are converted.
    fn in_si(expression: Expression, simulator: &dyn Simulator<f64>) -> Expression {
        let Expression { node, range } = expression;
        let inner = |a: Box<Expression>| Box::new(in_si(*a, simulator));
        let node = match node {
            Node::Number(value, Some(unit)) => match Measure::parse(&unit) {
                Ok(Measure { unit, factor }) => {
                    Node::Number(value * factor.to_f64(), Some(unit.dimension.as_unit()))
                }
                Err(_) => Node::Number(value, Some(unit)),
            },
            Node::Name(name) => match factor_of(&name, simulator) {
                None => Node::Name(name),
                Some(factor) => {
                    let [name, factor] = [Node::Name(name), Node::Number(factor, None)]
                        .map(|node| Box::new(Expression { node, range: range.clone() }));
                    Node::Binary(Operator::Multiply, name, factor)
                }
            },
            Node::Negative(a) => Node::Negative(inner(a)),
            Node::Binary(operator, a, b) => Node::Binary(operator, inner(a), inner(b)),
            Node::Call(function, a) => Node::Call(function, inner(a)),
            Node::Reduce(reduction, a) => Node::Reduce(reduction, inner(a)),
            node @ Node::Number(..) => node,
        };
        Expression { node, range }
    }

    /// Returns the factor from the unit in which a quantity is shown to its coherent unit, if not
    /// 1.
    fn factor_of(name: &str, simulator: &dyn Simulator<f64>) -> Option<f64> {
        let measure = Measure::parse(unit_of(name, simulator)?).ok()?;
        (!measure.factor.is_one()).then(|| measure.factor.to_f64())
    }

    /// Returns the first quantity of an expression that is shown in a unit with a factor.
    fn shown<'e>(expression: &'e Expression, simulator: &dyn Simulator<f64>) -> Option<&'e str> {
        match &expression.node {
            Node::Number(..) => None,
            Node::Name(name) => factor_of(name, simulator).map(|_| name.as_str()),
            Node::Negative(a) | Node::Call(_, a) | Node::Reduce(_, a) => shown(a, simulator),
            Node::Binary(_, a, b) => shown(a, simulator).or_else(|| shown(b, simulator)),
        }
    }

    /// Returns the unit of an expression; `1` if it has none.
    pub fn of(expression: &Expression, simulator: &dyn Simulator<f64>) -> String {
        if let Node::Negative(a) = &expression.node {
            return of(a, simulator);
        }
        if let Some(unit) = plain(expression, simulator) {
            return unit;
        }
        let found = dimension(expression, simulator).ok().flatten();
        found.map_or_else(|| "1".to_owned(), Dimension::as_unit)
    }

    /// Returns the spec's unit of an expression that only takes one number of one quantity.
    fn plain(expression: &Expression, simulator: &dyn Simulator<f64>) -> Option<String> {
        match &expression.node {
            Node::Name(name) => unit_of(name, simulator).map(str::to_owned),
            Node::Reduce(Reduction::Integral | Reduction::PeakTime, _) => None,
            Node::Negative(a) | Node::Call(Function::Abs, a) | Node::Reduce(_, a) => {
                plain(a, simulator)
            }
            _ => None,
        }
    }

    fn unit_of<'s>(name: &str, simulator: &'s dyn Simulator<f64>) -> Option<&'s str> {
        let shape = simulator.shape();
        let parameters = (0..shape.parameters).map(|index| simulator.parameter(index));
        let outputs = (0..shape.outputs).map(|index| simulator.output(index));
        let states = (0..shape.states()).map(|index| simulator.state(index));
        let mut all = parameters.chain(outputs).chain(states);
        all.find(|quantity| quantity.name == name).map(|quantity| quantity.unit)
    }

    fn seconds() -> Dimension {
        Dimension::TIME
    }

    fn dimension(
        expression: &Expression,
        simulator: &dyn Simulator<f64>,
    ) -> Result<Known, ExpressionError> {
        let range = &expression.range;
        let too_large =
            || ExpressionError::new("its unit has exponents that are too large", range.clone());
        match &expression.node {
            Node::Number(_, None) => Ok(None),
            Node::Number(_, Some(unit)) => match Measure::parse(unit) {
                Ok(Measure { unit, .. }) => Ok(Some(unit.dimension)),
                Err(error) => {
                    let message = format!("`{unit}` is not a unit of measure: {}", error.message);
                    Err(ExpressionError::new(message, range.clone()).with_help(error.help))
                }
            },
            Node::Name(name) if name == "t" && unit_of(name, simulator).is_none() => {
                Ok(Some(seconds()))
            }
            Node::Name(name) => {
                let measure = unit_of(name, simulator).map(Measure::parse);
                Ok(measure.and_then(Result::ok).map(|measure| measure.unit.dimension))
            }
            Node::Negative(a) | Node::Call(Function::Abs, a) => dimension(a, simulator),
            Node::Call(Function::Sqrt, a) => match dimension(a, simulator)? {
                None => Ok(None),
                Some(of) => of.power(1, 2).map(Some).ok_or_else(too_large),
            },
            Node::Call(_, a) => match dimension(a, simulator)? {
                Some(of) if of != Dimension::default() => {
                    let message = format!("the argument must be dimensionless, but is in {of}");
                    Err(ExpressionError::new(message, a.range.clone()))
                }
                _ => Ok(Some(Dimension::default())),
            },
            Node::Reduce(Reduction::PeakTime, a) => {
                dimension(a, simulator)?;
                Ok(Some(seconds()))
            }
            Node::Reduce(Reduction::Integral, a) => match dimension(a, simulator)? {
                None => Ok(Some(seconds())),
                Some(of) => of.times(seconds()).map(Some).ok_or_else(too_large),
            },
            Node::Reduce(_, a) => dimension(a, simulator),
            Node::Binary(operator, a, b) => {
                let (left, right) = (dimension(a, simulator)?, dimension(b, simulator)?);
                let none = Dimension::default();
                match operator {
                    Operator::Add | Operator::Subtract => alike((left, right), (a, b), simulator),
                    Operator::Multiply | Operator::Divide if left.is_none() && right.is_none() => {
                        Ok(None)
                    }
                    Operator::Multiply => {
                        let product = left.unwrap_or(none).times(right.unwrap_or(none));
                        product.map(Some).ok_or_else(too_large)
                    }
                    Operator::Divide => {
                        let quotient = left.unwrap_or(none).over(right.unwrap_or(none));
                        quotient.map(Some).ok_or_else(too_large)
                    }
                    Operator::Power => power(left, right, b)
                        .map_err(|why| ExpressionError::new(why, b.range.clone())),
                }
            }
        }
    }

    fn power(base: Known, exponent: Known, text: &Expression) -> Result<Known, String> {
        if exponent.is_some_and(|of| of != Dimension::default()) {
            return Err("an exponent must be dimensionless".to_owned());
        }
        let none = Dimension::default();
        let Some(base) = base.filter(|base| *base != none) else { return Ok(base) };
        let value = match &text.node {
            Node::Number(value, _) => *value,
            Node::Negative(a) => match &a.node {
                Node::Number(value, _) => -value,
                _ => f64::NAN,
            },
            _ => f64::NAN,
        };
        let halves = 2.0 * value;
        if halves.fract() == 0.0 && halves.abs() <= 20.0 {
            return base
                .power(halves as i32, 2)
                .map(Some)
                .ok_or("the exponent is too large".to_owned());
        }
        Err("the exponent of a quantity with a unit must be a multiple of 1/2".to_owned())
    }

    /// Returns the common dimension of two operands, or an error if they differ.
    fn alike(
        of: (Known, Known),
        (a, b): (&Expression, &Expression),
        simulator: &dyn Simulator<f64>,
    ) -> Result<Known, ExpressionError> {
        if let (Some(a), Some(other)) = of
            && a != other
        {
            let message = format!("this is in {other}, but the other operand is in {a}");
            return Err(ExpressionError::new(message, b.range.clone()));
        }
        // A bare number could be in the unit shown or in SI units.
        for ((known, bare), other) in [((of.0, a), b), ((of.1, b), a)] {
            let is_nothing = matches!(bare.node, Node::Number(value, None) if value == 0.0);
            if known.is_none()
                && !is_nothing
                && let Some(name) = shown(other, simulator)
            {
                let unit = unit_of(name, simulator).unwrap_or_default();
                let message = format!(
                    "this has no unit, but the other operand, `{name}`, is shown in {unit}"
                );
                let help = format!("give it one, as in `5 [{unit}]`");
                return Err(ExpressionError::new(message, bare.range.clone()).with_help(help));
            }
        }
        Ok(of.0.or(of.1))
    }
}

#[cfg(not(feature = "derive"))]
mod unread {
    use machinist::improve::{Expression, ExpressionError, Inequality, Node};
    use machinist_contract::Simulator;

    /// Returns an error for numbers with units of measure. Units are read by the generator, and
    /// taking `5 [mm]` for 5 would be silently wrong.
    pub fn check(expression: &Expression, _: &dyn Simulator<f64>) -> Result<(), ExpressionError> {
        without_units(expression)
    }

    /// Like [`check`] for both sides.
    pub fn check_sides(
        inequality: &Inequality,
        _: &dyn Simulator<f64>,
    ) -> Result<(), ExpressionError> {
        without_units(&inequality.left)?;
        without_units(&inequality.right)
    }

    pub fn of(_: &Expression, _: &dyn Simulator<f64>) -> String {
        "1".to_owned()
    }

    pub fn in_one_unit(expression: Expression, _: &dyn Simulator<f64>) -> Expression {
        expression
    }

    pub fn sides_in_one_unit(sides: Inequality, _: &dyn Simulator<f64>) -> Inequality {
        sides
    }

    fn without_units(expression: &Expression) -> Result<(), ExpressionError> {
        match &expression.node {
            Node::Number(_, Some(unit)) => Err(ExpressionError {
                message: format!("this build of the program cannot read the unit `{unit}`"),
                help: "write the number in SI units without its unit, or build the program with \
                       its feature `derive`"
                    .to_owned(),
                range: expression.range.clone(),
            }),
            Node::Number(..) | Node::Name(_) => Ok(()),
            Node::Negative(a) | Node::Call(_, a) | Node::Reduce(_, a) => without_units(a),
            Node::Binary(_, a, b) => without_units(a).and_then(|()| without_units(b)),
        }
    }
}
