//! Completion: what may be written at a place of a spec, with its documentation.

mod context;
mod modes;
mod paths;
mod units;

use super::documentation;
use super::hover::described;
use super::names::NameKind;
use super::workspace::Spec;
use crate::diagnostic::codes;
use crate::language::{Absent, Entry, Group, Takes};
use crate::read::vocabulary::{allowed, clauses, constants, fields, functions, mode_numbers, words};
use crate::source::FileId;
use crate::syntax::Place;
use context::{Before, Context};
use gen_lsp_types::CompletionItemKind as ItemKind;

/// What a spec mostly begins with, in this order.
const ORDER: [&str; 8] = ["vehicle", "faults", "mission", "plan", "simulate", "campaign", "let", "use"];

/// One thing that may be written, in place of the word under the cursor.
#[derive(Debug, Clone, PartialEq)]
pub struct Offer {
    pub label: String,
    pub insert: String,
    /// The text with places for the cursor, for editors that know snippets.
    pub snippet: Option<String>,
    pub kind: ItemKind,
    /// A few words after the label.
    pub detail: Option<String>,
    /// Markdown.
    pub documentation: Option<String>,
    /// Lower ones first.
    pub rank: u8,
}

impl Offer {
    fn new(label: &str, kind: ItemKind, rank: u8) -> Self {
        let (label, insert) = (label.to_string(), label.to_string());
        Offer { label, insert, snippet: None, kind, detail: None, documentation: None, rank }
    }

    fn insert(mut self, text: impl Into<String>) -> Self {
        self.insert = text.into();
        self
    }

    fn detail(mut self, text: impl Into<String>) -> Self {
        self.detail = Some(text.into());
        self
    }

    fn documented(mut self, text: Option<impl Into<String>>) -> Self {
        self.documentation = text.map(Into::into);
        self
    }
}

/// The offers at `offset`, and the bytes that they replace.
pub fn offers(spec: &Spec, file: FileId, offset: usize) -> (Vec<Offer>, std::ops::Range<usize>) {
    let source = spec.source(file);
    if let Some(found) = paths::offers(source, offset) {
        return found;
    }
    let Some(context) = Context::at(&source.text, offset) else { return (Vec::new(), offset..offset) };
    let mut found = Vec::new();
    let list = &mut found;
    match &context.before {
        Before::Nothing => {
            missing_fields(&context, list);
            openers(&context, list);
        }
        Before::Value { field, ended } => {
            let of_block = context.place_of(field);
            if *ended {
                of_dimension(spec, of_block, field, list);
                next_clauses(&context, list);
            } else {
                values(spec, &context, of_block, field, list);
            }
        }
        Before::Words(expected) => {
            list.extend(expected.iter().map(|word| Offer::new(word, ItemKind::Keyword, 0)));
        }
        Before::LimitName(name) => {
            let forms = documentation::field(Place::Limits, name).map_or(&[][..], Entry::forms);
            list.extend(forms.iter().map(|form| Offer::new(form, ItemKind::Operator, 0)));
        }
        Before::Clause => next_clauses(&context, list),
        Before::Mode => modes::offers(spec, &context, list),
        Before::ModeNumber => {
            let number = |name: &&str| {
                let entry = documentation::field(Place::Mode, name).map(described);
                Offer::new(name, ItemKind::Property, 0).documented(entry)
            };
            list.extend(mode_numbers().iter().map(number));
        }
    }
    (found, context.word.clone())
}

/// The fields of the block that it does not have yet.
fn missing_fields(context: &Context, list: &mut Vec<Offer>) {
    let place = context.place;
    for name in fields(place).into_iter().filter(|name| is_open(context, name)) {
        let entry = documentation::field(place, name);
        let sign = if place.has_limits() { "<=" } else { "=" };
        let rank = match place {
            Place::Top => 1 + ORDER.len() as u8,
            _ if is_needed(entry) => 0,
            _ => 1,
        };
        let mut offer = Offer::new(name, ItemKind::Property, rank);
        offer = offer.insert(format!("{name} {sign} ")).documented(entry.map(described));
        if let Some(unit) = entry.and_then(documentation::unit) {
            offer = offer.detail(unit);
        }
        list.push(offer);
    }
}

/// Whether the block has neither the field nor another one in its place.
fn is_open(context: &Context, name: &str) -> bool {
    let mut rivals = Group::of_block(context.place).rivals(name);
    !context.present.contains(name) && !rivals.any(|other| context.present.contains(other))
}

fn is_needed(entry: Option<&Entry>) -> bool {
    let of_ring = |words: &str| words.starts_with("required");
    entry.is_some_and(|entry| match entry.absent {
        Absent::Needed => true,
        Absent::Otherwise(words) => of_ring(words),
        Absent::Value(..) | Absent::Written(..) => false,
    })
}

/// The words that may begin a statement here.
fn openers(context: &Context, list: &mut Vec<Offer>) {
    for word in context.place.openers() {
        let block = Place::of_block(word).filter(|_| context.place != Place::Mode && context.place != Place::Rotors);
        let (text, snippet) = match block {
            Some(inside) if inside.is_named() => (format!("{word} "), Some(format!("{word} ${{1:name}} {{\n\t$0\n}}"))),
            Some(_) => (format!("{word} {{\n}}"), Some(format!("{word} {{\n\t$0\n}}"))),
            None => (format!("{word} "), None),
        };
        // A block has at most one of these.
        const SINGLE: [&str; 10] = [
            "plan",
            "simulate",
            "campaign",
            "rotor",
            "rotors",
            "battery",
            "parts",
            "limits",
            "after_fault_limits",
            "recovery",
        ];
        let single = SINGLE.contains(word);
        if single && block.is_some() && context.present.contains(*word) {
            continue;
        }
        let says = documentation::statement(word);
        let is_needed = context.place == Place::Vehicle && *word == "rotor";
        let rank = match ORDER.iter().position(|first| first == word) {
            Some(place) if context.place == Place::Top => 1 + place as u8,
            _ if is_needed => 0,
            _ => 2,
        };
        let offer = Offer { snippet, ..Offer::new(word, ItemKind::Keyword, rank).insert(text) };
        list.push(offer.documented(says));
    }
}

/// What may be written where an operand is expected.
fn values(spec: &Spec, context: &Context, place: Place, field: &str, list: &mut Vec<Offer>) {
    let names = |kind: NameKind| spec.names().of_kind(kind);
    let is_against = (place, field) == (Place::Plan, "against");
    // `all` is not an element of a list.
    let words_here = words(place, field).iter().filter(|word| !context.listed.contains(**word));
    let words_here = words_here.filter(|_| !is_against || !context.in_brackets && context.range_from.is_none());
    // The words of `allow` are codes, which have pages.
    let page = |word: &str| allowed(word).filter(|_| field == "allow").and_then(codes::lookup);
    list.extend(
        words_here.map(|word| Offer::new(word, ItemKind::EnumMember, 0).documented(page(word).map(|p| p.title))),
    );
    match (place, field) {
        (Place::Plan, "against") => {
            if let Some(first) = &context.range_from {
                modes::range(spec, first, list);
                return;
            }
            if !context.in_brackets {
                list.push(Offer::new("where", ItemKind::Keyword, 0).insert("where "));
            }
            modes::families(spec, context, list);
            modes::offers(spec, context, list);
            return;
        }
        (Place::Plan, "vehicle") => {
            list.extend(names(NameKind::Vehicle).map(|d| Offer::new(&d.name, ItemKind::Class, 0)));
            return;
        }
        (Place::Recovery, "order") | (Place::Mode | Place::Every, "recovery") => {
            let sites = names(NameKind::LandingSite).filter(|d| !context.listed.contains(&d.name));
            list.extend(sites.map(|d| Offer::new(&d.name, ItemKind::Constant, 1).documented(d.doc.clone())));
            return;
        }
        (Place::Plan, "mission") => {
            list.extend(names(NameKind::Mission).map(|d| Offer::new(&d.name, ItemKind::Module, 0)));
            return;
        }
        _ if !words(place, field).is_empty() && !matches!(field, "time" | "detection") => return,
        (Place::Vehicle, "layout") => {
            let rings = ["\"PNPN\"", "\"PNPNPN\"", "\"PPNNPN\"", "\"PNPNPNPN\"", "\"PPNNPPNN\""];
            list.extend(rings.iter().map(|ring| Offer::new(ring, ItemKind::Value, 0)));
            return;
        }
        _ => {}
    }
    if (place, field) == (Place::Mission, "yaw") {
        if context.after == "towards" {
            list.extend(names(NameKind::Waypoint).map(|d| Offer::new(&d.name, ItemKind::Constant, 0)));
        } else {
            list.extend(
                ["towards ", "along path ", "free "]
                    .map(|words| Offer::new(words.trim_end(), ItemKind::Keyword, 0).insert(words)),
            );
        }
    }
    if let Some(parameter) = &context.parameter {
        list.push(Offer::new(parameter, ItemKind::Variable, 0).detail("the curve's parameter"));
    }
    for definition in names(NameKind::Let) {
        let written = spec.snippet(definition.statement).lines().next().unwrap_or("");
        let offer = Offer::new(&definition.name, ItemKind::Variable, 1).detail(written);
        list.push(offer.documented(definition.doc.clone()));
    }
    for name in functions() {
        let text = documentation::function(name).map(String::from);
        list.push(Offer::new(name, ItemKind::Function, 3).insert(format!("{name}(")).documented(text));
    }
    for name in constants() {
        let text = documentation::function(name).map(String::from);
        list.push(Offer::new(name, ItemKind::Constant, 3).documented(text));
    }
}

/// Units of the dimension that a field takes; all common units where the field is unknown.
fn of_dimension(spec: &Spec, place: Place, field: &str, list: &mut Vec<Offer>) {
    let entry = documentation::field(place, field);
    let due = match (place, field) {
        // What a curve's parameter runs through: an angle, or a plain number.
        (Place::Mission, "") => Some("rad"),
        _ => entry.and_then(documentation::unit),
    };
    let is_share = entry.is_some_and(|entry| entry.takes == Takes::Share);
    if is_share || matches!((place, field), (Place::Mode | Place::Faults, "")) {
        list.push(Offer::new("%", ItemKind::Unit, 0).detail("a share"));
        return;
    }
    // A plain number.
    if due.is_none() && (entry.is_some() || (place, field) == (Place::Plan, "")) {
        return;
    }
    for (rank, (unit, detail)) in units::of(due, spec.understanding.gravity).into_iter().enumerate() {
        list.push(Offer::new(&unit, ItemKind::Unit, rank.min(200) as u8).detail(detail));
    }
}

fn next_clauses(context: &Context, list: &mut Vec<Offer>) {
    for word in &context.next {
        list.push(Offer::new(word, ItemKind::Keyword, 4).insert(format!("{word} ")));
    }
    let Some(opener) = &context.opener else { return };
    let group = Group::of_statement(context.place, opener);
    let is_taken = |word: &str| context.clauses.contains(word);
    for word in clauses(context.place, opener).iter().filter(|w| !is_taken(w) && !group.rivals(w).any(is_taken)) {
        let entry = documentation::field(context.place, word).map(described);
        let text = if *word == "arrive" { "arrive from ".to_string() } else { format!("{word} ") };
        list.push(Offer::new(word, ItemKind::Property, 4).insert(text).documented(entry));
    }
}
