//! The tree: what was written, with places, before any name or unit is understood.

use crate::source::{FileId, Span, Spanned};

pub type Name = Spanned<String>;

/// One parsed file, items in the order written.
#[derive(Debug, Clone, PartialEq)]
pub struct SpecFile {
    pub file: FileId,
    pub items: Vec<Item>,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// `use "path"`; the span of the path includes its quotes.
    Use(Spanned<String>),
    /// `let name = expr`
    Let(Field),
    /// A top-level assignment such as `gravity = 9.80665 m/s^2`.
    Field(Field),
    Block(Block),
    /// A statement whose error has been reported, and which has no fix. What it was meant to declare is unknown, so
    /// that a declaration may be missing elsewhere without an error.
    Broken(Span),
}

/// `name = value`, with the `///` text before it.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    pub name: Name,
    pub value: FieldValue,
    pub doc: Option<String>,
    pub span: Span,
}

#[derive(Debug, Clone, PartialEq)]
pub enum FieldValue {
    Expr(Expr),
    /// `where rpn >= 100` (in `against`)
    Where {
        field: Name,
        relation: Spanned<Relation>,
        value: Expr,
    },
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
}

/// `keyword name "title" { statements }`: every braced block has this shape. Keywords: `vehicle`, `faults`, `mission`,
/// `plan`, `simulate`, `campaign` at the top level; `rotor`, `rotors` in a vehicle; `limits` in a mission; `require` in
/// a plan; others where a statement below carries one.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    pub keyword: Name,
    pub name: Option<Name>,
    pub title: Option<Spanned<String>>,
    pub body: Vec<Statement>,
    pub doc: Option<String>,
    /// From the keyword to the closing brace.
    pub span: Span,
}

impl Block {
    /// Whether every statement could be parsed.
    pub fn is_whole(&self) -> bool {
        !self.body.iter().any(|statement| matches!(statement, Statement::Broken(_)))
    }
}

#[derive(Debug, Clone, PartialEq)]
pub enum Statement {
    Field(Field),
    /// A nested block: `rotor { }`, `rotors { }`, `limits { }`, `mode M "title" { }`.
    Block(Block),
    /// `every 2 rotors lost as M { .. }`
    Every {
        count: Expr,
        effect: Effect,
        prefix: Name,
        body: Vec<Statement>,
        doc: Option<String>,
        span: Span,
    },
    /// In a mode: `rotors [1, 6] lost`, `rotor 3 reduced to 60 %`, `rotor 2 stuck at 50 %`.
    Fault {
        rotors: Expr,
        effect: Effect,
        span: Span,
    },
    /// In a vehicle's `rotors` block: `rotor at [..] m spin P max_speed 700 rad/s`.
    Rotor(Clauses),
    /// `curve s in 0 .. 4*pi, points = 21 { x = .. }`
    Curve {
        parameter: Name,
        range: Expr,
        options: Vec<Field>,
        body: Vec<Statement>,
        doc: Option<String>,
        span: Span,
    },
    /// `start at [..] m yaw 90 deg`
    Start(Clauses),
    /// `waypoint tower at [..] m yaw 45 deg within 10 cm weight 2 time 30 s straight { speed <= 3 m/s }`
    Waypoint(Clauses),
    /// `start moving` / `end moving`
    Moving {
        end: Spanned<bool>,
        span: Span,
    },
    /// `hold 4 s`
    Hold {
        duration: Expr,
        span: Span,
    },
    /// `waypoints from "survey.csv"`
    WaypointsFrom {
        path: Spanned<String>,
        span: Span,
    },
    /// In `simulate`: `fault M1_6 at 5 s until 9 s`. The name is always there.
    Strike(Clauses),
    /// In `plan`: `require risk <= 1e-6`
    Require {
        name: Name,
        at_most: Expr,
        span: Span,
    },
    /// In `limits`: `speed <= 8 m/s`, `altitude in 1 m .. 30 m`.
    Limit {
        name: Name,
        relation: LimitRelation,
        span: Span,
    },
    /// A statement whose error has been reported, and which has no fix: the block around it may have a field that seems
    /// to be missing.
    Broken(Span),
}

impl Statement {
    /// From its first word to its last, `///` comments not included.
    pub fn span(&self) -> Span {
        match self {
            Statement::Field(field) => field.span,
            Statement::Block(block) => block.span,
            Statement::Rotor(clauses)
            | Statement::Start(clauses)
            | Statement::Waypoint(clauses)
            | Statement::Strike(clauses) => clauses.span,
            Statement::Every { span, .. }
            | Statement::Fault { span, .. }
            | Statement::Curve { span, .. }
            | Statement::Moving { span, .. }
            | Statement::Hold { span, .. }
            | Statement::WaypointsFrom { span, .. }
            | Statement::Require { span, .. }
            | Statement::Limit { span, .. }
            | Statement::Broken(span) => *span,
        }
    }

    /// The statements between its braces, if it has any.
    pub fn body(&self) -> &[Statement] {
        match self {
            Statement::Block(Block { body, .. })
            | Statement::Every { body, .. }
            | Statement::Curve { body, .. }
            | Statement::Start(Clauses { body, .. })
            | Statement::Waypoint(Clauses { body, .. }) => body,
            _ => &[],
        }
    }
}

/// A statement that consists of a name, mostly optional, and clauses in any order.
#[derive(Debug, Clone, PartialEq)]
pub struct Clauses {
    pub name: Option<Name>,
    pub clauses: Vec<Clause>,
    /// The limits in the braces of a waypoint.
    pub body: Vec<Statement>,
    pub doc: Option<String>,
    pub span: Span,
}

impl Clauses {
    /// The statement without the braces at its end.
    pub fn head(&self) -> Span {
        self.clauses.last().map_or(self.span, |last| Span { end: last.span().end, ..self.span })
    }
}

/// `at [0, 0, 2] m`, `yaw 90 deg`, `until 9 s`, `spin P` (where the value is the name `P`), `straight` (without a
/// value).
#[derive(Debug, Clone, PartialEq)]
pub struct Clause {
    pub word: Name,
    /// The words between name and value: `from` in `arrive from [0, 0, 1]`, `along path` in `yaw along path`.
    pub how: Option<Name>,
    pub value: Option<Expr>,
}

impl Clause {
    /// From its first word to the end of its value.
    pub fn span(&self) -> Span {
        let last = self.value.as_ref().map(|value| value.span).or(self.how.as_ref().map(|how| how.span));
        last.map_or(self.word.span, |last| self.word.span.to(last))
    }
}

#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    Lost(Span),
    /// `reduced to 60 %`
    Reduced(Expr),
    /// `stuck at 50 %`
    Stuck(Expr),
}

#[derive(Debug, Clone, PartialEq)]
pub enum LimitRelation {
    AtMost(Expr),
    AtLeast(Expr),
    In(Expr),
}

#[derive(Debug, Clone, PartialEq)]
pub struct Expr {
    pub kind: ExprKind,
    pub span: Span,
}

/// A unit as written, one run without spaces: `kg*m^2`, `1/h`, `%`. Not understood here.
pub type UnitText = Spanned<String>;

#[derive(Debug, Clone, PartialEq)]
pub enum ExprKind {
    /// A finite number and the unit that follows it. The text is kept for printing back.
    Number {
        value: f64,
        text: String,
        unit: Option<UnitText>,
    },
    Text(String),
    Name(String),
    /// `?`: a figure that is to be filled in.
    Unknown,
    /// `f(a, b)`
    Call {
        function: Name,
        arguments: Vec<Expr>,
    },
    Negate(Box<Expr>),
    Binary {
        operator: Spanned<Operator>,
        left: Box<Expr>,
        right: Box<Expr>,
    },
    /// `(a + b) m`: the unit applies to the expression inside. A call with a unit, `cos(s) m`, is one of these too.
    Paren {
        inner: Box<Expr>,
        unit: Option<UnitText>,
    },
    /// `[a, b, c] m`
    List {
        elements: Vec<Expr>,
        unit: Option<UnitText>,
    },
    /// `1.8 kg +- 3 %`, `1.8 kg +- 50 g`
    Interval {
        value: Box<Expr>,
        by: Box<Expr>,
    },
    /// `a .. b`
    Range {
        low: Box<Expr>,
        high: Box<Expr>,
    },
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}
