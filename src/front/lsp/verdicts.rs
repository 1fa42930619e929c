//! The verdicts of the fault sets, computed on a thread of their own.
//!
//! The thread analyses modes, one after the other. It keeps its results as long as the vehicle stays the same, and
//! stops with a spec as soon as a newer one is requested.

use crate::admissible::AdmissibleSet;
use crate::admissible::diagnose::diagnose_by;
use crate::admissible::verdict::{ModeAnalysis, analyze};
use crate::diagnostic::{Diagnostic, sort};
use crate::flight::equilibrium::outcome;
use crate::flight::indistinguishable;
use crate::model::{Environment, Model, RotorState, Vehicle};
use crate::source::Span;
use crossbeam_channel::{Receiver, Sender, unbounded};
use std::collections::{HashMap, VecDeque};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Vehicles whose analyses are kept: specs that are open side by side.
const SHELVES: usize = 4;
/// Analyses kept of one vehicle.
const MOST_KEPT: usize = 20_000;

/// What the thread has found.
#[derive(Debug)]
pub enum Found {
    /// The verdicts of a spec, for the round that requested them.
    Answers { round: u64, root: String, diagnostics: Vec<Diagnostic> },
    /// The modes of requests, in their order.
    Verdicts { ticket: u64, analyses: Vec<ModeAnalysis> },
}

enum Asked {
    Answers { round: u64, root: String, model: Arc<Model> },
    Verdicts { ticket: u64, model: Arc<Model>, modes: Vec<usize>, dropped: Arc<AtomicBool> },
}

/// The thread and the way to it.
pub struct Verdicts {
    asked: Sender<Asked>,
    pub found: Receiver<Found>,
    round: Arc<AtomicU64>,
}

impl Verdicts {
    pub fn start() -> Self {
        let (asked, questions) = unbounded();
        let (answers, found) = unbounded();
        let round = Arc::new(AtomicU64::new(0));
        let mut thread = Analyst { questions, answers, round: round.clone(), shelves: VecDeque::new() };
        // It ends with the channel of questions.
        std::thread::spawn(move || thread.work());
        Verdicts { asked, found, round }
    }

    /// Begins a round; requests of earlier rounds are dropped.
    pub fn next_round(&self) -> u64 {
        self.round.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Requests the verdicts of a spec.
    pub fn ask(&self, round: u64, root: &str, model: &Arc<Model>) {
        // Without the thread there is no answer; everything else works.
        let _ = self.asked.send(Asked::Answers { round, root: root.to_string(), model: model.clone() });
    }

    /// Asks about modes, by their index. Setting the flag that is returned withdraws the question; without one there
    /// will be no answer.
    pub fn ask_modes(&self, ticket: u64, model: &Arc<Model>, modes: Vec<usize>) -> Option<Arc<AtomicBool>> {
        let dropped = Arc::new(AtomicBool::new(false));
        let asked = Asked::Verdicts { ticket, model: model.clone(), modes, dropped: dropped.clone() };
        self.asked.send(asked).is_ok().then_some(dropped)
    }
}

/// Capacities and stuck shares of a mode, to the last bit; nothing for the healthy vehicle.
type Key = Vec<(u64, Option<u64>)>;

/// A vehicle and what is known of its modes.
struct Shelf {
    environment: Environment,
    vehicle: Vehicle,
    known: HashMap<Key, ModeAnalysis>,
}

struct Analyst {
    questions: Receiver<Asked>,
    answers: Sender<Found>,
    round: Arc<AtomicU64>,
    /// The last one used first.
    shelves: VecDeque<Shelf>,
}

impl Analyst {
    fn work(&mut self) {
        let mut waiting = VecDeque::new();
        loop {
            let next = match waiting.pop_front() {
                Some(asked) => asked,
                None => match self.questions.recv() {
                    Ok(asked) => asked,
                    Err(_) => return,
                },
            };
            match next {
                Asked::Verdicts { ticket, model, modes, dropped } => self.verdicts(ticket, &model, &modes, &dropped),
                Asked::Answers { round, root, model } => self.diagnose(round, root, &model, &mut waiting),
            }
        }
    }

    fn verdicts(&mut self, ticket: u64, model: &Model, modes: &[usize], dropped: &AtomicBool) {
        let mut analyses = Vec::new();
        for &mode in modes {
            if dropped.load(Ordering::Relaxed) {
                return;
            }
            let mut analysis = self.analysis(model, Some(mode));
            // The settings of flights are not part of what is kept.
            analysis.outcome = outcome(model, mode, analysis.outcome);
            analyses.push(analysis);
        }
        let _ = self.answers.send(Found::Verdicts { ticket, analyses });
    }

    /// Answers about a spec, unless a newer round begins meanwhile. Requests for single modes come first.
    fn diagnose(&mut self, round: u64, root: String, model: &Model, waiting: &mut VecDeque<Asked>) {
        let answers = diagnose_by(model, |mode| {
            while let Ok(asked) = self.questions.try_recv() {
                match asked {
                    Asked::Verdicts { ticket, model, modes, dropped } => {
                        self.verdicts(ticket, &model, &modes, &dropped);
                    }
                    later => waiting.push_back(later),
                }
            }
            (self.round.load(Ordering::Relaxed) == round).then(|| self.analysis(model, mode))
        });
        let Some(mut diagnostics) = answers else { return };
        diagnostics.extend(indistinguishable::diagnose(model));
        sort(&mut diagnostics);
        let _ = self.answers.send(Found::Answers { round, root, diagnostics });
    }

    fn analysis(&mut self, model: &Model, mode: Option<usize>) -> ModeAnalysis {
        let key = key(model, mode);
        let shelf = self.shelf(model);
        if let Some(known) = shelf.known.get(&key) {
            let name = mode.map_or(known.name.as_str(), |mode| &model.modes[mode].name);
            return ModeAnalysis { name: name.to_string(), ..known.clone() };
        }
        let set = mode.map_or_else(|| AdmissibleSet::healthy(model), |mode| AdmissibleSet::of_mode(model, mode));
        // The airspeed also depends on the plan's reserve and the mission's limits; no answer needs it.
        let analysis = ModeAnalysis { airspeed: None, ..analyze(model, &set) };
        if shelf.known.len() >= MOST_KEPT {
            shelf.known.clear();
        }
        shelf.known.insert(key, analysis.clone());
        analysis
    }

    /// The shelf of the model's vehicle, wherever it is in the text.
    fn shelf(&mut self, model: &Model) -> &mut Shelf {
        let nowhere = Span::default();
        let vehicle = Vehicle {
            name: String::new(),
            doc: None,
            span: nowhere,
            mass_span: nowhere,
            drag_span: None,
            ..model.vehicle.clone()
        };
        let environment = model.environment();
        let is_same = |shelf: &Shelf| shelf.environment == environment && shelf.vehicle == vehicle;
        match self.shelves.iter().position(is_same) {
            Some(at) => self.shelves.swap(0, at),
            None => {
                self.shelves.truncate(SHELVES - 1);
                self.shelves.push_front(Shelf { environment, vehicle, known: HashMap::new() });
            }
        }
        &mut self.shelves[0]
    }
}

fn key(model: &Model, mode: Option<usize>) -> Key {
    let Some(mode) = mode.map(|mode| &model.modes[mode]) else { return Vec::new() };
    let bits = |rotor: &RotorState| (rotor.capacity().to_bits(), rotor.stuck_at().map(f64::to_bits));
    mode.rotors.iter().map(bits).collect()
}
