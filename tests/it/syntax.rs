//! Text to tree: every construct, where units and operators bind, what survives an error, and printing back.

use mavc::diagnostic::Checked;
use mavc::source::{FileId, Source, Span};
use mavc::syntax::ast::*;
use proptest::prelude::*;

const WHOLE: &str = include_str!("../specs/syntax/everything.mav");

pub fn parse(text: &str) -> Checked<SpecFile> {
    mavc::syntax::parse(FileId(0), &Source::new("t.mav", text))
}

/// The tree of a text without a mistake.
pub fn tree(text: &str) -> SpecFile {
    let checked = parse(text);
    assert_eq!(checked.diagnostics, vec![], "{text}");
    checked.value.unwrap()
}

/// A tree without its places.
pub fn bare(tree: &SpecFile) -> String {
    let is_place = |line: &str| {
        let line = line.trim().trim_start_matches("span: ");
        line.starts_with("0:") && line.contains("..")
    };
    format!("{tree:#?}").lines().filter(|line| !is_place(line)).collect::<Vec<_>>().join("\n")
}

/// The expression after `x = `, every operation in brackets.
fn shape(expr: &str) -> String {
    let Item::Field(Field { value: FieldValue::Expr(expr), .. }) = &tree(&format!("x = {expr}")).items[0] else {
        panic!("no field")
    };
    shape_of(expr)
}

fn shape_of(expr: &Expr) -> String {
    let all = |list: &[Expr]| list.iter().map(shape_of).collect::<Vec<_>>().join(" ");
    let unit = |unit: &Option<UnitText>| unit.as_ref().map_or(String::new(), |u| format!("<{}>", u.value));
    match &expr.kind {
        ExprKind::Number { text, unit: u, .. } => format!("{text}{}", unit(u)),
        ExprKind::Text(text) => format!("{text:?}"),
        ExprKind::Name(name) => name.clone(),
        ExprKind::Unknown => "?".into(),
        ExprKind::Call { function, arguments } => format!("{}({})", function.value, all(arguments)),
        ExprKind::Negate(inner) => format!("(-{})", shape_of(inner)),
        ExprKind::Binary { operator, left, right } => {
            format!("({} {} {})", shape_of(left), operator.value.symbol(), shape_of(right))
        }
        ExprKind::Paren { inner, unit: u } => format!("p{}{}", shape_of(inner), unit(u)),
        ExprKind::List { elements, unit: u } => format!("[{}]{}", all(elements), unit(u)),
        ExprKind::Interval { value, by } => format!("({} +- {})", shape_of(value), shape_of(by)),
        ExprKind::Range { low, high } => format!("({} .. {})", shape_of(low), shape_of(high)),
    }
}

#[test]
fn every_construct_is_read() {
    insta::assert_snapshot!(tree(WHOLE));
}

#[test]
fn operators_bind_as_in_mathematics() {
    assert_eq!(shape("-2^2"), "(-(2 ^ 2))");
    assert_eq!(shape("2^-2^2"), "(2 ^ (-(2 ^ 2)))");
    assert_eq!(shape("2^3^4"), "(2 ^ (3 ^ 4))");
    assert_eq!(shape("1 - 2 - 3"), "((1 - 2) - 3)");
    assert_eq!(shape("1 + 2*3 / 4"), "(1 + ((2 * 3) / 4))");
    assert_eq!(shape("-a*b"), "((-a) * b)");
    assert_eq!(shape("a - -b"), "(a - (-b))");
    assert_eq!(shape("0 .. 4*pi"), "(0 .. (4 * pi))");
    assert_eq!(shape("0..1+2"), "(0 .. (1 + 2))");
    assert_eq!(shape("1 + 2 kg +- 3 %"), "((1 + 2<kg>) +- 3<%>)");
    assert_eq!(shape("1+-2"), "(1 +- 2)");
    assert_eq!(shape("1 + -2"), "(1 + (-2))");
    assert_eq!(shape("2*a*sin(s/2)"), "((2 * a) * sin((s / 2)))");
}

#[test]
fn units_are_one_run_after_numbers_and_brackets() {
    assert_eq!(shape("1.8 kg"), "1.8<kg>");
    assert_eq!(shape("8m/s + 1"), "(8<m/s> + 1)");
    assert_eq!(shape("1e-5 1/h"), "1e-5<1/h>");
    assert_eq!(shape("8.5e-6 N*s^2/rad^2"), "8.5e-6<N*s^2/rad^2>");
    assert_eq!(shape("2 m^-1"), "2<m^-1>");
    assert_eq!(shape("60 % + 5%"), "(60<%> + 5<%>)");
    assert_eq!(shape("[0, 1] kg*m^2"), "[0 1]<kg*m^2>");
    assert_eq!(shape("(a + b) m"), "p(a + b)<m>");
    assert_eq!(shape("cos(s) m"), "pcos(s)<m>");
    // Tighter than any operator.
    assert_eq!(shape("-2 m^2"), "(-2<m^2>)");
    assert_eq!(shape("2^3 m"), "(2 ^ 3<m>)");
    assert_eq!(shape("4 m ^2"), "(4<m> ^ 2)");
    // The run ends at a blank and before a function.
    assert_eq!(shape("4 m * a"), "(4<m> * a)");
    assert_eq!(shape("4 m*sin(s)"), "(4<m> * sin(s))");
    assert_eq!(shape("4 m*a"), "4<m*a>");
    assert_eq!(shape("5 min + min(a, 5 min)"), "(5<min> + min(a 5<min>))");
    assert_eq!(shape("1/h"), "(1 / h)");
    // Elsewhere a name is a name.
    assert_eq!(shape("s/2"), "(s / 2)");
}

#[test]
fn words_of_the_statement_are_no_units() {
    let text =
        "mission m {\n waypoint at [0, 0, 2] yaw 90 deg weight 2 time 30 s\n curve s in 0 .. 1 in, points = 2 {\n }\n}";
    assert!(parse(text).has_errors(), "`in` is not a unit");
    let Item::Block(block) = &parse(text).value.unwrap().items[0] else { panic!("no block") };
    let Statement::Waypoint(Clauses { name: None, clauses, .. }) = &block.body[0] else { panic!("no waypoint") };
    let words: Vec<_> = clauses.iter().map(|c| (c.word.value.as_str(), shape_of(c.value.as_ref().unwrap()))).collect();
    let wanted = [("at", "[0 0 2]"), ("yaw", "90<deg>"), ("weight", "2"), ("time", "30<s>")];
    assert_eq!(words, wanted.map(|(word, value)| (word, value.to_string())));
}

#[test]
fn keywords_are_whole_words() {
    let file = tree("letter = 1\nuser = 2\nlet lettuce = 3\nholding = 4\nplan = 5\n");
    let names: Vec<_> = file
        .items
        .iter()
        .map(|item| match item {
            Item::Let(field) => format!("let {}", field.name.value),
            Item::Field(field) => field.name.value.clone(),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(names, ["letter", "user", "let lettuce", "holding", "plan"]);
}

#[test]
fn newlines_inside_brackets_do_not_count() {
    let joined = tree("a = [1, 2, (3 + 4)] m\nb = 1\n");
    let split = tree("a = [\n  1,   // one\n  2,\n\n  (3 +\n 4)\n] m\nb = 1\n");
    assert_eq!(bare(&joined), bare(&split));
}

#[test]
fn line_ends_and_a_byte_order_mark_change_nothing() {
    let crlf = WHOLE.replace('\n', "\r\n");
    assert_eq!(bare(&tree(WHOLE)), bare(&tree(&crlf)));
    assert_eq!(bare(&tree(WHOLE)), bare(&tree(&format!("\u{feff}{WHOLE}"))));
    assert_eq!(bare(&tree("a = 1; b = 2")), bare(&tree("a = 1\nb = 2\n")));
}

#[test]
fn blocks_may_stand_on_one_line() {
    let long = tree("faults {\n mode A \"t\" {\n rotor 1 lost\n severity = 5\n }\n}\n");
    let short = tree("faults { mode A \"t\" { rotor 1 lost; severity = 5 } }");
    assert_eq!(bare(&long), bare(&short));
}

#[test]
fn docs_belong_to_the_next_statement() {
    let file = tree(
        "/// One.\n/// Two.\n//// no doc\nlet a = 1 // not this\nlet b = 2\n/// Block.\nplan {\n/// Field.\ntime = 1 s }\n",
    );
    let docs: Vec<_> = file
        .items
        .iter()
        .map(|item| match item {
            Item::Let(field) => field.doc.as_deref(),
            Item::Block(block) => {
                let Statement::Field(field) = &block.body[0] else { panic!("no field") };
                assert_eq!(field.doc.as_deref(), Some("Field."));
                block.doc.as_deref()
            }
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(docs, [Some("One.\nTwo."), None, Some("Block.")]);
}

#[test]
fn docs_are_kept_with_what_can_be_described() {
    let text = "/// 1\nuse \"a.mav\"\n/// 2\nlet a = 1\n/// 3\nvehicle v {\n/// 4\nmass = 1 kg\n/// 5\nrotors {\n/// 6\nrotor at [0, 0, 0] m spin P\n}\n}\n/// 7\nfaults {\n/// 8\nmode A {\n/// 9\nrotor 1 lost\n}\n/// 10\nevery 1 rotor lost as M\n}\n/// 11\nmission m {\n/// 12\nstart moving\n/// 13\nstart at [0, 0, 2] m\n/// 14\nwaypoint at [1, 0, 2] m\n/// 15\nhold 1 s\n/// 16\nwaypoints from \"a.csv\"\n/// 17\ncurve s in 0 .. 1, points = 2 {\n/// 18\nx = 1 m\n}\n/// 19\nlimits {\n/// 20\nspeed <= 1 m/s\n}\n/// 21\nend moving\n}\n/// 22\nsimulate {\n/// 23\nfault A at 1 s\n}\n";
    let printed = tree(text).to_string();
    let kept: Vec<u32> = printed.lines().filter_map(|l| l.trim().strip_prefix("/// ")?.parse().ok()).collect();
    // Not: use, a rotor's fault, start moving, hold, waypoints from, a limit, end moving.
    assert_eq!(kept, [2, 3, 4, 5, 6, 7, 8, 10, 11, 13, 14, 17, 18, 19, 22, 23]);
}

#[test]
fn lists_may_end_with_a_comma_and_nothing_else_may() {
    assert_eq!(shape("[1, 2,] m"), "[1 2]<m>");
    for text in ["x = max(1, 2,)", "x = [,]", "x = [1,,2]", "mission m { curve s in 0 .. 1, points = 2, { x = 1 m } }"]
    {
        assert!(parse(text).has_errors(), "{text}");
    }
}

#[test]
fn texts_have_no_escapes() {
    assert_eq!(shape(r#""a\nb\""#), format!("{:?}", r"a\nb\"));
    assert!(parse(r#"x = "a \" b""#).has_errors());
}

#[test]
fn a_block_left_open_ends_where_the_next_top_level_block_begins() {
    let text =
        "faults {\n mode A {\n rotor 1 lost\nmission m {\n limits {\n speed <= 1 m/s\nplan { time = 1 s }\nlet a = 1\n";
    let checked = parse(text);
    assert_eq!(checked.diagnostics.len(), 2, "{:#?}", checked.diagnostics);
    let items = checked.value.unwrap().items;
    let blocks: Vec<_> =
        items.iter().map(|i| if let Item::Block(b) = i { b.keyword.value.as_str() } else { "" }).collect();
    assert_eq!(blocks, ["faults", "mission", "plan", ""]);
}

#[test]
fn braces_that_match_may_stand_anywhere() {
    for text in [
        "faults {\n    every 1 rotor lost as M\n    }\n",
        "faults {\n    every 1 rotor lost as M }\n",
        "faults {\n    mode a { rotor 1 lost\n    }\n    every 2 rotors lost as D }\nplan { }\n",
    ] {
        tree(text);
    }
}

#[test]
fn places_are_those_of_the_text() {
    let text = "// α\nlet a = [1, // β\n 22] m  // end\n";
    let source = Source::new("t", text);
    let Item::Let(field) = &tree(text).items[0] else { panic!("no let") };
    let at = |span: Span| &text[span.start as usize..span.end as usize];
    assert_eq!(at(field.name.span), "a");
    let FieldValue::Expr(Expr { kind: ExprKind::List { elements, unit }, span }) = &field.value else {
        panic!("no list")
    };
    assert_eq!(at(elements[1].span), "22");
    assert_eq!(source.place(elements[1].span.start as usize).line, 3);
    assert_eq!(at(unit.as_ref().unwrap().span), "m");
    assert!(at(*span).starts_with("[1") && at(*span).ends_with("] m"));
    assert!(at(field.span).starts_with("let a") && at(field.span).ends_with("] m"));
}

#[test]
fn good_statements_survive_broken_ones() {
    let text = "let a = 1\nlet b = = 2\nvehicle v {\n mass = 1 kg\n arm 2 m\n inertia = [1, 2\n rotor { max_speed = 1 rad/s }\n}\nmision m {\n hold 4 s\n}\nlet c = 3\n";
    let checked = parse(text);
    let lines: Vec<_> =
        checked.diagnostics.iter().map(|d| Source::new("t", text).place(d.span.start as usize).line).collect();
    assert_eq!(lines, [2, 5, 6, 9]);
    let file = checked.value.unwrap();
    assert_eq!(file.items.len(), 5);
    // Read as its fix would have it.
    assert!(matches!(&file.items[1], Item::Let(_)));
    let Item::Block(vehicle) = &file.items[2] else { panic!("no vehicle") };
    assert_eq!(vehicle.body.len(), 4);
    assert!(vehicle.body.iter().all(|s| !matches!(s, Statement::Broken(_))));
    // A misspelt keyword is taken for the one meant, so that its statements are understood.
    let Item::Block(mission) = &file.items[3] else { panic!("no mission") };
    assert_eq!(mission.keyword.value, "mission");
    assert!(matches!(mission.body[0], Statement::Hold { .. }));
}

#[test]
fn a_statement_that_is_read_as_its_fix_would_have_it_keeps_its_places() {
    let text =
        "plan {\n against = M1, M2\n}\nlet a = .5 m\nuse \"a.mav\nmission m { waypoint at [1, 2, 3 m yaw 90 deg }\n";
    let checked = parse(text);
    assert_eq!(checked.diagnostics.len(), 4, "{:#?}", checked.diagnostics);
    let at = |span: Span| &text[span.start as usize..span.end as usize];
    let items = checked.value.unwrap().items;
    let Item::Block(plan) = &items[0] else { panic!("no plan") };
    let Statement::Field(Field { value: FieldValue::Expr(against), .. }) = &plan.body[0] else { panic!("no field") };
    let ExprKind::List { elements, .. } = &against.kind else { panic!("no list") };
    assert_eq!(elements.iter().map(|e| at(e.span)).collect::<Vec<_>>(), ["M1", "M2"]);
    let Item::Let(Field { value: FieldValue::Expr(half), .. }) = &items[1] else { panic!("no let") };
    assert_eq!((at(half.span), shape_of(half)), (".5 m", "0.5<m>".to_string()));
    let Item::Use(path) = &items[2] else { panic!("no use") };
    assert_eq!((path.value.as_str(), at(path.span)), ("a.mav", "\"a.mav"));
    let Item::Block(mission) = &items[3] else { panic!("no mission") };
    let Statement::Waypoint(Clauses { clauses, .. }) = &mission.body[0] else { panic!("no waypoint") };
    assert_eq!(
        clauses.iter().map(|c| at(c.value.as_ref().unwrap().span)).collect::<Vec<_>>(),
        ["[1, 2, 3 m", "90 deg"]
    );
}

#[test]
fn printing_is_a_fixed_point() {
    let printed = tree(WHOLE).to_string();
    assert_eq!(bare(&tree(&printed)), bare(&tree(WHOLE)));
    assert_eq!(tree(&printed).to_string(), printed);
}

/// Texts of expressions: every operand, operator and spacing.
fn expression() -> impl Strategy<Value = String> {
    let unit = prop::sample::select(vec!["", "m", " m", " kg*m^2", " 1/h", " %", " m^-1"]);
    let number = (prop::sample::select(vec!["0", "1.5", "2e-3", "874", "1E6"]), unit.clone())
        .prop_map(|(number, unit)| format!("{number}{unit}"));
    let name = prop::sample::select(vec!["a", "pi", "M1_6", "start", "min", "\"text\""]).prop_map(str::to_string);
    prop_oneof![number, name].prop_recursive(4, 40, 4, move |inner| {
        let operator = prop::sample::select(vec![" + ", " - ", "*", "/", " * ", "^", " ^ ", " +- ", "+-", " .. "]);
        let unit = unit.clone().prop_map(|u| if u == "m" { " m" } else { u });
        prop_oneof![
            (inner.clone(), operator, inner.clone()).prop_map(|(a, o, b)| format!("{a}{o}{b}")),
            inner.clone().prop_map(|a| format!("-{a}")),
            (inner.clone(), unit.clone()).prop_map(|(a, u)| format!("({a}){u}")),
            (prop::collection::vec(inner.clone(), 0..4), unit.clone())
                .prop_map(|(l, u)| format!("[{}]{u}", l.join(",\n"))),
            (prop::collection::vec(inner, 0..3), unit).prop_map(|(l, u)| format!("sin({}){u}", l.join(", "))),
        ]
    })
}

/// One statement of a mission, of faults or of a vehicle, with the block it stands in.
pub fn block() -> impl Strategy<Value = String> {
    let doc = prop::sample::select(vec!["", "/// Text.\n", "///\n/// Two\n"]);
    (doc, expression(), expression(), 0..11usize).prop_map(|(doc, a, b, kind)| match kind {
        0 => format!("{doc}let x = {a}\n"),
        1 => format!("{doc}plan {{ against = where rpn >= {a}\n time = {b} }}\n"),
        2 => format!("mission m {{\n{doc}curve s in {a}, points = {b} {{ x = {a} }}\n}}\n"),
        3 => format!("mission m {{\n{doc}waypoint p at {a} yaw {b}; hold {a}\n}}\n"),
        4 => format!("mission m {{ limits {{ speed <= {a}; z in {b} }} }}\n"),
        5 => format!("faults {{\n{doc}every {a} rotors reduced to {b} as M {{ rate = {a} }}\n}}\n"),
        6 => format!("faults {{ mode A \"t\" {{ rotor {a} stuck at {b}; rotors {b} lost }} }}\n"),
        7 => format!("vehicle v {{ rotors {{ rotor at {a} spin P max_speed {b} }} }}\n"),
        8 => format!("simulate {{\n{doc}fault M at {a} until {b}; wind = {a}\n}}\ncampaign {{ seeds = {b} }}\n"),
        9 => format!("use \"x.mav\"; {} = 4\n", "g"),
        _ => format!("mission m {{ start moving; end moving; waypoints from \"a.csv\"; start at {a} }}\n"),
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_parses_to_the_same_tree(blocks in prop::collection::vec(block(), 1..4)) {
        let text = blocks.concat();
        let checked = parse(&text);
        // A range inside a range is the one thing that these texts can get wrong.
        prop_assume!(!checked.has_errors());
        let first = checked.value.unwrap();
        let printed = first.to_string();
        prop_assert_eq!(bare(&tree(&printed)), bare(&first), "{}", printed);
        prop_assert_eq!(tree(&printed).to_string(), printed);
    }
}
