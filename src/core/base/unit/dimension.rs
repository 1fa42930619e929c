//! Products of powers of the base dimensions.

use std::fmt;

/// A base dimension, in the order in which factors are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    Mass,
    Length,
    Time,
    Angle,
    Current,
}

impl Base {
    pub const ALL: [Base; 5] = [Base::Mass, Base::Length, Base::Time, Base::Angle, Base::Current];

    /// The SI unit of the base dimension.
    pub fn symbol(self) -> &'static str {
        match self {
            Base::Mass => "kg",
            Base::Length => "m",
            Base::Time => "s",
            Base::Angle => "rad",
            Base::Current => "A",
        }
    }
}

/// A rational exponent in lowest terms; numerator and denominator are at most [`Exponent::LIMIT`] in magnitude.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Exponent {
    numerator: i64,
    denominator: i64,
}

impl Exponent {
    pub const ZERO: Exponent = Exponent { numerator: 0, denominator: 1 };
    pub const ONE: Exponent = Exponent { numerator: 1, denominator: 1 };
    /// The largest numerator and denominator.
    pub const LIMIT: i64 = 1000;

    /// `numerator / denominator`; `None` beyond the limit or for a zero denominator.
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        if denominator == 1 {
            return (numerator.abs() <= Self::LIMIT).then_some(Exponent { numerator, denominator });
        }
        if denominator == 0 {
            return None;
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs()) as i64 * denominator.signum();
        let (numerator, denominator) = (numerator / divisor, denominator / divisor);
        let fits = numerator.abs() <= Self::LIMIT && denominator <= Self::LIMIT;
        fits.then_some(Exponent { numerator, denominator })
    }

    /// `x` as an exponent, if it is a fraction with a denominator of at most 12.
    pub fn from_f64(x: f64) -> Option<Self> {
        (1..=12i64).find_map(|d| {
            let n = (x * d as f64).round();
            (n.abs() <= Self::LIMIT as f64 && n / d as f64 == x).then(|| Exponent::new(n as i64, d))?
        })
    }

    pub fn is_zero(self) -> bool {
        self.numerator == 0
    }

    pub fn is_negative(self) -> bool {
        self.numerator < 0
    }

    /// Whether this exponent is smaller in magnitude than `other`.
    pub fn is_nearer_zero(self, other: Self) -> bool {
        (self.numerator * other.denominator).abs() < (other.numerator * self.denominator).abs()
    }

    fn plus(self, other: Self) -> Option<Self> {
        Self::new(
            self.numerator * other.denominator + other.numerator * self.denominator,
            self.denominator * other.denominator,
        )
    }

    fn times(self, other: Self) -> Option<Self> {
        Self::new(self.numerator * other.numerator, self.denominator * other.denominator)
    }

    fn negated(self) -> Self {
        Exponent { numerator: -self.numerator, ..self }
    }
}

impl fmt::Display for Exponent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            1 => write!(f, "{}", self.numerator),
            d => write!(f, "({}/{d})", self.numerator),
        }
    }
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a.max(1) } else { gcd(b, a % b) }
}

/// A product of powers of the base dimensions; a plain number has only zero exponents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dimension([Exponent; 5]);

impl Dimension {
    pub const PLAIN: Dimension = Dimension([Exponent::ZERO; 5]);
    pub const MASS: Dimension = Dimension::base(Base::Mass);
    pub const LENGTH: Dimension = Dimension::base(Base::Length);
    pub const TIME: Dimension = Dimension::base(Base::Time);
    pub const ANGLE: Dimension = Dimension::base(Base::Angle);
    pub const CURRENT: Dimension = Dimension::base(Base::Current);

    const fn base(base: Base) -> Self {
        let mut exponents = [Exponent::ZERO; 5];
        exponents[base as usize] = Exponent::ONE;
        Dimension(exponents)
    }

    pub fn exponent(self, base: Base) -> Exponent {
        self.0[base as usize]
    }

    /// The factor that belongs to one base dimension.
    pub fn only(self, base: Base) -> Self {
        let mut factor = Dimension::PLAIN;
        factor.0[base as usize] = self.exponent(base);
        factor
    }

    pub fn is_plain(self) -> bool {
        self == Dimension::PLAIN
    }

    /// The product; `None` if an exponent exceeds the limit.
    pub fn times(self, other: Self) -> Option<Self> {
        self.zip(|k| self.0[k].plus(other.0[k]))
    }

    /// The quotient; `None` if an exponent exceeds the limit.
    pub fn over(self, other: Self) -> Option<Self> {
        self.zip(|k| self.0[k].plus(other.0[k].negated()))
    }

    /// The power; `None` if an exponent exceeds the limit.
    pub fn power(self, exponent: Exponent) -> Option<Self> {
        self.zip(|k| self.0[k].times(exponent))
    }

    /// This dimension without angle, as in SI units.
    pub fn without_angle(mut self) -> Self {
        self.0[Base::Angle as usize] = Exponent::ZERO;
        self
    }

    fn zip(self, f: impl Fn(usize) -> Option<Exponent>) -> Option<Self> {
        Some(Dimension([f(0)?, f(1)?, f(2)?, f(3)?, f(4)?]))
    }

    /// The usual name and unit of the dimension, if there is one.
    pub fn named(self) -> Option<(&'static str, &'static str)> {
        NAMED.iter().find(|(_, _, e)| Dimension::integers(*e) == self).map(|(name, unit, _)| (*name, *unit))
    }

    /// `a length (m)`, `a plain number`, or the unit in base units if there is no usual name.
    pub fn describe(self) -> String {
        match self.named() {
            Some((name, unit)) => format!("{name} ({unit})"),
            None if self.is_plain() => "a plain number".into(),
            None => self.to_string(),
        }
    }

    fn integers(exponents: [i8; 5]) -> Self {
        Dimension(exponents.map(|e| Exponent { numerator: i64::from(e), denominator: 1 }))
    }
}

/// Named dimensions: name, usual unit, exponents of mass, length, time, angle and current.
const NAMED: &[(&str, &str, [i8; 5])] = &[
    ("a mass", "kg", [1, 0, 0, 0, 0]),
    ("a length", "m", [0, 1, 0, 0, 0]),
    ("a time", "s", [0, 0, 1, 0, 0]),
    ("an angle", "rad", [0, 0, 0, 1, 0]),
    ("a speed", "m/s", [0, 1, -1, 0, 0]),
    ("an acceleration", "m/s^2", [0, 1, -2, 0, 0]),
    ("a jerk", "m/s^3", [0, 1, -3, 0, 0]),
    ("a turning rate", "rad/s", [0, 0, -1, 1, 0]),
    ("an angular acceleration", "rad/s^2", [0, 0, -2, 1, 0]),
    ("a rate", "1/s", [0, 0, -1, 0, 0]),
    ("a force", "N", [1, 1, -2, 0, 0]),
    ("a torque", "N*m", [1, 2, -2, 0, 0]),
    ("a power", "W", [1, 2, -3, 0, 0]),
    ("a moment of inertia", "kg*m^2", [1, 2, 0, 0, 0]),
    ("a thrust coefficient", "N*s^2/rad^2", [1, 1, 0, -2, 0]),
    ("a drag coefficient", "N*m*s^2/rad^2", [1, 2, 0, -2, 0]),
    ("an area", "m^2", [0, 2, 0, 0, 0]),
    ("a current", "A", [0, 0, 0, 0, 1]),
    ("a charge", "A*h", [0, 0, 1, 0, 1]),
    ("a voltage", "V", [1, 2, -3, 0, -1]),
];

impl fmt::Display for Dimension {
    /// The dimension as a unit in base units: `kg*m^2/s^2`, `1/s`, `1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |negative: bool| {
            let factors = Base::ALL.iter().filter_map(|&base| {
                let e = self.exponent(base);
                let shown = if e.is_negative() { e.negated() } else { e };
                (!e.is_zero() && e.is_negative() == negative).then(|| power(base, shown))
            });
            factors.collect::<Vec<_>>()
        };
        let (above, below) = (part(false), part(true));
        let above = if above.is_empty() { "1".to_string() } else { above.join("*") };
        f.write_str(&above)?;
        below.iter().try_for_each(|factor| write!(f, "/{factor}"))
    }
}

/// `m`, `m^2`, `m^-1`.
pub(super) fn power(base: Base, exponent: Exponent) -> String {
    if exponent == Exponent::ONE { base.symbol().into() } else { format!("{}^{exponent}", base.symbol()) }
}
