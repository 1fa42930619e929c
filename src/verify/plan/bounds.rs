//! What is bounded along a motion: limits, and what is held against sets and facets.

use super::super::facets::{few, named};
use super::super::interval::exceeds;
use super::super::limits;
use super::super::motion::State;
use super::super::proof::{Family, MAX_GRID, Measure, Rated, holds};
use super::super::sets::{Facet, Generators, MAX_TRIPLES, Plane, along};
use super::super::wrench::{Dynamics, Held};
use super::super::{Guarded, Reach, Rejection, Shown};
use super::{Checker, MOST_OUTSIDE, MOST_PAST_LIMIT};
use crate::certificate::{Bound, DynamicModel, FacetClaim, FacetRecord, LimitClaim, PlanClaim, Scope, SetClaim};
use crate::report::caveats::limit_words;

/// Normals of length 1 are told apart when they differ by more than this.
const SAME_NORMAL: f64 = 1e-6;

/// The direction of a facet of a mode, in steps of [`SAME_NORMAL`]: a set has one facet in each.
pub(super) type Direction = (String, [i64; 4]);

fn direction(mode: &str, facet: &Facet) -> Direction {
    (mode.into(), facet.normal.map(|n| (n.middle() / SAME_NORMAL).round() as i64))
}

fn of_set(mode: &str) -> String {
    format!("the set of {mode}")
}

/// What is held against something, as rejections name it.
fn named_for(held: Held, place: String) -> String {
    match held {
        Held::Wrench => place,
        Held::Commands { .. } => format!("the commands at {place}"),
    }
}

impl Checker<'_> {
    /// One limit, and how far it is shown.
    pub fn limit(&mut self, index: usize, claim: &LimitClaim) -> Result<Reach, Rejection> {
        let limit = &self.mission.limits[index];
        let family = limits::family(limit, self.model.gravity);
        let what = format!("limit {} ({})", index + 1, claim.limit);
        let named = limit_words(limit.kind).0 == claim.limit;
        if !named || limit.lower != claim.lower || limit.upper != claim.upper {
            let why = "the certificate names another limit than the spec";
            return Err(Rejection { span: Some(limit.span), ..Rejection::new(what, why) });
        }
        self.bounds(&family, &claim.bounds, MOST_PAST_LIMIT * limit.size(), |_| String::new()).map_err(|r| Rejection {
            claim: what,
            span: Some(limit.span),
            ..r
        })
    }

    /// All that is claimed of sets.
    pub(super) fn sets(&mut self, claims: &[SetClaim], shown: &mut Vec<Shown>) -> Result<(), Rejection> {
        for SetClaim { mode, bounds, commands } in claims {
            let planes = self.planes(mode)?;
            for (held, bounds) in self.told(bounds, commands, &of_set(mode))? {
                let reach = self.inside(mode, &planes, held, bounds)?;
                shown.push(Shown::new(format!("{} inside the set of {mode}", self.words(held)), reach));
            }
        }
        Ok(())
    }

    /// One set, and how far it is shown for what is held against it.
    pub fn set(&mut self, mode: &str, held: Held, bounds: &[Bound]) -> Result<Reach, Rejection> {
        let planes = self.planes(mode)?;
        self.inside(mode, &planes, held, bounds)
    }

    /// The planes of a mode's set, as many as a certificate may need.
    fn planes(&mut self, mode: &str) -> Result<Vec<Plane>, Rejection> {
        let span = self.span_of(mode);
        let wrong = |why: String| Rejection { span, ..Rejection::new(of_set(mode), why) };
        let generators = Generators::of(self.model, mode)?;
        self.triples += generators.triples();
        if self.triples > MAX_TRIPLES {
            return Err(wrong("the certificate is about more sets than are checked at once".into()));
        }
        generators.planes().map_err(wrong)
    }

    fn inside(&mut self, mode: &str, planes: &[Plane], held: Held, bounds: &[Bound]) -> Result<Reach, Rejection> {
        let named = |member: usize| {
            planes.get(member).map_or(String::new(), |p| format!(", at the plane of rotors {:?}", p.rotors))
        };
        let family = wrench_family(&self.dynamics.clone(), held, planes);
        let (claim, span) = (named_for(held, of_set(mode)), self.span_of(mode));
        self.bounds(&family, bounds, MOST_OUTSIDE, named).map_err(|r| Rejection { claim, span, ..r })
    }

    /// All that is claimed of facets.
    pub(super) fn facets(&mut self, claims: &[FacetClaim], shown: &mut Vec<Shown>) -> Result<(), Rejection> {
        few(claims)?;
        for (index, FacetClaim { facet, bounds, commands }) in claims.iter().enumerate() {
            let (place, found) = self.found(index, facet)?;
            for (held, bounds) in self.told(bounds, commands, &place)? {
                let reach = self.within(facet, &found, &place, held, bounds)?;
                let by = match (self.dynamics.model, held) {
                    (DynamicModel::Exact, Held::Wrench) => String::new(),
                    _ => format!(" by the {}", self.words(held)),
                };
                Shown::count(shown, &format!("facets of {} kept{by}", facet.mode), reach);
            }
            self.directions.insert(direction(&facet.mode, &found));
        }
        Ok(())
    }

    /// One facet, and how far it is shown for what is held against it.
    pub fn facet(
        &mut self,
        index: usize,
        facet: &FacetRecord,
        held: Held,
        bounds: &[Bound],
    ) -> Result<Reach, Rejection> {
        let (place, found) = self.found(index, facet)?;
        self.within(facet, &found, &place, held, bounds)
    }

    /// The facet that is named, and what rejections call it.
    fn found(&self, index: usize, record: &FacetRecord) -> Result<(String, Facet), Rejection> {
        let place = format!("facet {} ({}, rotors {:?})", index + 1, record.mode, record.rotors);
        match named(self.model, record) {
            Ok(facet) => Ok((place, facet)),
            Err(r) => Err(Rejection { claim: place, span: self.span_of(&record.mode), ..r }),
        }
    }

    fn within(
        &mut self,
        record: &FacetRecord,
        facet: &Facet,
        place: &str,
        held: Held,
        bounds: &[Bound],
    ) -> Result<Reach, Rejection> {
        let family = wrench_family(&self.dynamics.clone(), held, std::slice::from_ref(&facet.plane));
        let (claim, span) = (named_for(held, place.into()), self.span_of(&record.mode));
        self.bounds(&family, bounds, MOST_OUTSIDE, |_| String::new()).map_err(|r| Rejection { claim, span, ..r })
    }

    /// What has to be told of a set or a facet, each with its bounds: the wrench, and where rotors lag what they are
    /// commanded, which without bounds is refused like a wrench without.
    fn told<'c>(
        &self,
        wrench: &'c [Bound],
        commands: &'c [Bound],
        place: &str,
    ) -> Result<Vec<(Held, &'c [Bound])>, Rejection> {
        match self.commands {
            Some(held) => Ok(vec![(Held::Wrench, wrench), (held, commands)]),
            None if commands.is_empty() => Ok(vec![(Held::Wrench, wrench)]),
            None => Err(Rejection::new(place, "it bounds commands, and the spec's rotors follow theirs at once")),
        }
    }

    /// What is held against sets. What is shown of the linear model's wrench is not shown of the vehicle's.
    fn words(&self, held: Held) -> &'static str {
        match (self.dynamics.model, held) {
            (DynamicModel::Hover, Held::Wrench) => "linear model's wrench",
            (DynamicModel::Hover, Held::Commands { .. }) => "linear model's commands",
            (DynamicModel::Exact, Held::Wrench) => "wrench",
            (DynamicModel::Exact, Held::Commands { .. }) => "commands",
        }
    }

    /// What a certificate that was decided claims of each mode that the plan is against.
    pub fn guarded(&self, claim: &PlanClaim) -> Vec<Guarded> {
        let modes = self.model.plan.against.iter().filter_map(|&i| self.model.modes.get(i)).map(|mode| &mode.name);
        let of_mode = |name: &String| Guarded {
            mode: name.clone(),
            whole: claim.sets.iter().any(|set| set.mode == *name),
            facets: self.directions.iter().filter(|(mode, _)| mode == name).count(),
        };
        modes.map(of_mode).collect()
    }

    /// Every bound stands, and one of them is close enough to mean something.
    fn bounds(
        &mut self,
        family: &Family,
        bounds: &[Bound],
        most: f64,
        named: impl Fn(usize) -> String,
    ) -> Result<Reach, Rejection> {
        let measure = family.measure;
        let tightest = bounds.iter().map(|b| b.excess).fold(f64::INFINITY, f64::min);
        if exceeds(tightest, most) {
            let why = match tightest.is_finite() {
                true => format!(
                    "the claim lets it be {}, and more than {} is not kept",
                    measure.kept_or_passed(tightest),
                    measure.of(most)
                ),
                false => "no bound is claimed".into(),
            };
            return Err(Rejection::new("", why));
        }
        for bound in bounds {
            if matches!(bound.scope, Scope::Grid(points) if points > MAX_GRID) {
                return Err(Rejection::new("", format!("a grid has at most {MAX_GRID} points a piece")));
            }
            holds(family, &self.motion, bound, &mut self.budget)
                .map_err(|f| Rejection::of_bound(bound, &f, measure, named(f.member)))?;
        }
        let close = bounds.iter().filter(|b| b.excess <= most).map(|b| b.scope);
        let scope = close.max_by_key(rank).unwrap_or(Scope::Nodes);
        let beyond = bounds.iter().filter(|b| rank(&b.scope) > rank(&scope)).copied();
        let beyond = beyond.max_by_key(|b| rank(&b.scope)).map(|bound| (bound, measure));
        Ok(Reach { scope: Some(scope), beyond })
    }
}

/// Scopes from the weakest up.
fn rank(scope: &Scope) -> usize {
    match scope {
        Scope::Nodes => 0,
        Scope::Grid(points) => *points,
        Scope::EveryInstant => usize::MAX,
    }
}

/// The excess over each plane of what is held against it.
pub fn wrench_family<'a: 'b, 'b>(dynamics: &Dynamics<'a>, held: Held, planes: &'b [Plane]) -> Family<'b> {
    let linear = dynamics.model == DynamicModel::Hover && dynamics.one_yaw.is_some();
    let dynamics = dynamics.clone();
    let evaluate = move |state: &State, wanted: &[usize]| -> Vec<Rated> {
        let found = dynamics.held(held, state);
        let planes = wanted.iter().filter_map(|&m| planes.get(m));
        planes.map(|p| Rated { value: p.excess(&found.value), rate: along(&p.normal, &found.rate) }).collect()
    };
    // The rate of the wrench has the slopes of the inputs, which change at nodes.
    let jumps = held != Held::Wrench;
    Family { members: planes.len(), evaluate: Box::new(evaluate), linear, jumps, measure: Measure::WIDTH }
}
