//! What may be written next.

mod context;
mod units;

use super::documentation;
use super::hover::described;
use super::names::Kind;
use super::workspace::Spec;
use crate::model::vocabulary::{clauses, constants, fields, functions, mode_numbers, words};
use crate::source::FileId;
use crate::syntax::Place;
use context::{Before, Context};
use gen_lsp_types::CompletionItemKind as ItemKind;

/// Modes offered by name.
const MOST_MODES: usize = 500;

/// One thing that may be written, in place of the word under the cursor.
#[derive(Debug, Clone, PartialEq)]
pub struct Offer {
    pub label: String,
    pub insert: String,
    pub kind: ItemKind,
    /// A few words behind the label.
    pub detail: Option<String>,
    /// Markdown.
    pub documentation: Option<String>,
    /// Lower ones first.
    pub rank: u8,
}

impl Offer {
    fn new(label: &str, kind: ItemKind, rank: u8) -> Self {
        let (label, insert) = (label.to_string(), label.to_string());
        Offer { label, insert, kind, detail: None, documentation: None, rank }
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
    let Some(context) = Context::at(&spec.source(file).text, offset) else { return (Vec::new(), offset..offset) };
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
            let forms = documentation::field(Place::Limits, name).map_or(&[][..], |entry| &entry.forms);
            list.extend(forms.iter().map(|form| Offer::new(form, ItemKind::Operator, 0)));
        }
        Before::Clause => next_clauses(&context, list),
        Before::Mode => modes(spec, list),
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
    for name in fields(place).into_iter().filter(|name| !context.present.contains(*name)) {
        let entry = documentation::field(place, name);
        let sign = if place == Place::Limits { "<=" } else { "=" };
        let mut offer = Offer::new(name, ItemKind::Property, if is_needed(entry) { 0 } else { 1 });
        offer = offer.insert(format!("{name} {sign} ")).documented(entry.map(described));
        if let Some(unit) = entry.and_then(|entry| entry.unit.as_deref()) {
            offer = offer.detail(unit);
        }
        list.push(offer);
    }
}

fn is_needed(entry: Option<&documentation::Entry>) -> bool {
    entry.is_some_and(|entry| entry.text.starts_with("needed"))
}

/// The words that may begin a statement here.
fn openers(context: &Context, list: &mut Vec<Offer>) {
    for word in context.place.openers() {
        let block = Place::of_block(word).filter(|_| context.place != Place::Mode && context.place != Place::Rotors);
        let text = match block {
            Some(inside) if inside.is_named() => format!("{word} "),
            Some(_) => format!("{word} {{\n}}"),
            None => format!("{word} "),
        };
        // Of these a block has one.
        let single = ["plan", "simulate", "campaign", "rotor", "rotors", "limits"].contains(word);
        if single && block.is_some() && context.present.contains(*word) {
            continue;
        }
        let offer = Offer::new(word, ItemKind::Keyword, 2).insert(text);
        list.push(offer.documented(documentation::statement(word)));
    }
}

/// What may stand where an operand is due.
fn values(spec: &Spec, context: &Context, place: Place, field: &str, list: &mut Vec<Offer>) {
    let names = |kind: Kind| spec.names().of_kind(kind);
    list.extend(words(place, field).iter().map(|word| Offer::new(word, ItemKind::EnumMember, 0)));
    match (place, field) {
        (Place::Plan, "against") => {
            if !context.in_brackets {
                list.push(Offer::new("where", ItemKind::Keyword, 0).insert("where "));
            }
            modes(spec, list);
            return;
        }
        (Place::Plan, "vehicle") => {
            list.extend(names(Kind::Vehicle).map(|d| Offer::new(&d.name, ItemKind::Class, 0)));
            return;
        }
        (Place::Plan, "mission") => {
            list.extend(names(Kind::Mission).map(|d| Offer::new(&d.name, ItemKind::Module, 0)));
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
    if let Some(parameter) = &context.parameter {
        list.push(Offer::new(parameter, ItemKind::Variable, 0).detail("the curve's parameter"));
    }
    for definition in names(Kind::Let) {
        let written = spec.snippet(definition.statement).lines().next().unwrap_or("");
        let offer = Offer::new(&definition.name, ItemKind::Variable, 1).detail(written);
        list.push(offer.documented(definition.doc.clone()));
    }
    for name in functions() {
        let text = documentation::function(name).map(|entry| entry.text.clone());
        list.push(Offer::new(name, ItemKind::Function, 3).insert(format!("{name}(")).documented(text));
    }
    for name in constants() {
        let text = documentation::function(name).map(|entry| entry.text.clone());
        list.push(Offer::new(name, ItemKind::Constant, 3).documented(text));
    }
}

/// Units of the dimension that a field takes; all common ones where it is not known.
fn of_dimension(spec: &Spec, place: Place, field: &str, list: &mut Vec<Offer>) {
    let due = documentation::field(place, field).and_then(|entry| entry.unit.as_deref());
    for (rank, (unit, detail)) in units::of(due, spec.understanding.gravity).into_iter().enumerate() {
        list.push(Offer::new(&unit, ItemKind::Unit, rank.min(200) as u8).detail(detail));
    }
    if due.is_none() && matches!((place, field), (Place::Plan, "reserve") | (Place::Mode | Place::Faults, _)) {
        list.insert(0, Offer::new("%", ItemKind::Unit, 0).detail("a share"));
    }
}

fn next_clauses(context: &Context, list: &mut Vec<Offer>) {
    for word in &context.next {
        list.push(Offer::new(word, ItemKind::Keyword, 4).insert(format!("{word} ")));
    }
    let Some(opener) = &context.opener else { return };
    for word in clauses(context.place, opener).iter().filter(|word| !context.clauses.contains(**word)) {
        let entry = documentation::field(context.place, word).map(described);
        list.push(Offer::new(word, ItemKind::Property, 4).insert(format!("{word} ")).documented(entry));
    }
}

fn modes(spec: &Spec, list: &mut Vec<Offer>) {
    let modes = spec.understanding.modes.iter();
    for mode in modes.take(MOST_MODES) {
        let offer = Offer::new(&mode.name, ItemKind::Event, 1).documented(mode.doc.clone());
        list.push(match &mode.title {
            Some(title) => offer.detail(title),
            None => offer,
        });
    }
    // Modes that could not be made out, for an error of theirs or of the vehicle, have a name all the same.
    let known = |name: &str| spec.understanding.modes.iter().any(|mode| mode.name == name);
    let rest = spec.names().of_kind(Kind::Mode).filter(|d| !known(&d.name));
    list.extend(rest.map(|d| Offer::new(&d.name, ItemKind::Event, 1)));
}
