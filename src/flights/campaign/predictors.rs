//! What can be said before a flight about whether the vehicle is lost, compared with the flights (`docs/campaigns.md`,
//! "Predicted against flown").

use super::design::{Design, Standing};
use super::statistics::{Contingency, Strength, brier};
use super::tally::Tally;
use crate::admissible::edge::HoverPlace;
use crate::admissible::verdict::HoverVerdict;
use crate::admissible::without_yaw::YawFree;
use crate::motion::{X, Y, Z};

/// What predicts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Predictor {
    /// The plan: lost if the fault strikes before the plan's last violation of the mode's set.
    LastViolation,
    /// The paper's verdict of the mode: lost if it is unstable, or stabilizable and yaw is not given up.
    Verdict,
    /// What is left with yaw given up: lost if hover is on the edge or outside of it; if yaw is kept, the same of the
    /// set of full wrenches.
    Core,
    /// The height of capture, of modes in which yaw is given up: lost if the vehicle is lower over the ground than that
    /// when the fault strikes, if it is farther below the reference than `lost_beyond`, or if level flight was not
    /// regained.
    Capture,
}

/// A class of flights that a predictor does not distinguish.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Class {
    word: &'static str,
    /// Whether its flights are predicted lost.
    lost: bool,
}

impl Predictor {
    pub const ALL: [Predictor; 4] = [Predictor::LastViolation, Predictor::Verdict, Predictor::Core, Predictor::Capture];

    /// Its name in tables.
    pub fn words(self) -> &'static str {
        match self {
            Predictor::LastViolation => "last violation",
            Predictor::Verdict => "verdict",
            Predictor::Core => "core",
            Predictor::Capture => "capture",
        }
    }

    /// The class of the flights of a plan in which a mode strikes at an instant; `None` if the predictor does not
    /// apply.
    fn class(self, design: &Design, plan: usize, mode: usize, time: usize) -> Option<Class> {
        let standing = &design.modes[mode];
        match self {
            Predictor::LastViolation => {
                let last = design.plans[plan].outside[mode].last;
                let lost = last.is_some_and(|last| design.fault_time(time) < last);
                Some(Class { word: if lost { "before it" } else { "after it, or none" }, lost })
            }
            Predictor::Verdict => Some(of_verdict(standing)),
            Predictor::Core => Some(of_core(standing)),
            Predictor::Capture => of_capture(design, plan, mode, time),
        }
    }
}

fn of_verdict(standing: &Standing) -> Class {
    let (word, lost) = match (standing.verdict, standing.gives_up_yaw) {
        (HoverVerdict::Controllable, _) => ("controllable", false),
        (HoverVerdict::Stabilizable, true) => ("stabilizable", false),
        (HoverVerdict::Stabilizable, false) => ("stabilizable, yaw kept", true),
        (HoverVerdict::Unstable, _) => ("unstable", true),
    };
    Class { word, lost }
}

fn of_core(standing: &Standing) -> Class {
    if standing.gives_up_yaw {
        let lost = matches!(standing.yaw_free, YawFree::OnEdge | YawFree::None);
        return Class { word: standing.yaw_free.word(), lost };
    }
    let word = match standing.hover_all_axes {
        HoverPlace::Inside => "inside, yaw kept",
        HoverPlace::OnEdge => "on the edge, yaw kept",
        HoverPlace::Outside => "outside, yaw kept",
    };
    Class { word, lost: !standing.is_inside() }
}

/// By the capture at the speed that is nearest to the planned horizontal speed at the fault.
fn of_capture(design: &Design, plan: usize, mode: usize, time: usize) -> Option<Class> {
    let state = design.plans[plan].trajectory.at(design.fault_time(time));
    let speed = state[X][1].hypot(state[Y][1]);
    let off = |capture: &&crate::flight::capture::CaptureHeight| (capture.speed_m_per_s - speed).abs();
    let capture = design.modes[mode].capture.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
    let simulation = &design.model.simulation;
    let height = state[Z][0] - simulation.ground;
    let (word, lost) = match capture.height_m.filter(|_| 2 * capture.regained > capture.flights) {
        None => ("not regained", true),
        Some(needed) if height < needed => ("too low", true),
        Some(needed) if needed > simulation.lost_beyond => ("beyond lost_beyond", true),
        Some(_) => ("high enough", false),
    };
    Some(Class { word, lost })
}

/// The flights of one class.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ClassCount {
    /// The class, in words.
    pub class: &'static str,
    /// Whether its flights are predicted lost.
    pub predicted_lost: bool,
    /// Its flights still flying when the fault struck.
    #[cfg_attr(test, schemars(range(min = 1)))]
    pub struck: usize,
    /// Those of them that were lost.
    pub lost: usize,
    /// By mode: struck, lost.
    #[serde(skip)]
    by_mode: Vec<(usize, usize)>,
}

/// A predictor against the flights of all distinct plans. Only flights still flying when the fault struck.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Forecast {
    /// What predicts; docs/campaigns.md states when each predicts a loss.
    pub predictor: Predictor,
    #[serde(flatten)]
    pub counts: Contingency,
    /// Phi coefficient; null if predictions or outcomes are all the same.
    pub phi: Option<f64>,
    /// The strength of this coefficient.
    pub strength: Strength,
    /// Brier score of the prediction as 0 or 1: the share that it gets wrong.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub brier: Option<f64>,
    /// Brier score of predicting the share lost in the same class with the other modes, (lost + 1)/(struck + 2).
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub brier_by_class: Option<f64>,
    /// Brier score of predicting the share lost with the other modes, whatever the class: the score to beat.
    #[cfg_attr(test, schemars(range(min = 0, max = 1)))]
    pub brier_base: Option<f64>,
    /// The classes of flights that it distinguishes.
    pub classes: Vec<ClassCount>,
}

impl Forecast {
    /// Every predictor that applies to some flight of the tally.
    pub fn all(design: &Design, tally: &Tally) -> Vec<Forecast> {
        let all = Predictor::ALL.map(|predictor| Forecast::new(predictor, design, tally));
        all.into_iter().filter(|forecast| forecast.counts.total() > 0).collect()
    }

    fn new(predictor: Predictor, design: &Design, tally: &Tally) -> Self {
        let modes = design.cases.modes;
        let mut counts = Contingency::default();
        let mut classes: Vec<ClassCount> = Vec::new();
        for p in (0..design.plans.len()).filter(|&p| !design.is_repeated(p)) {
            for m in 0..modes {
                for (k, cell) in tally.cells(p, m).iter().enumerate().filter(|(_, cell)| cell.struck > 0) {
                    let Some(Class { word, lost }) = predictor.class(design, p, m, k) else { continue };
                    counts.add(lost, cell.lost, cell.struck);
                    let known = classes.iter().position(|c| c.class == word).unwrap_or_else(|| {
                        let by_mode = vec![(0, 0); modes];
                        classes.push(ClassCount { class: word, predicted_lost: lost, struck: 0, lost: 0, by_mode });
                        classes.len() - 1
                    });
                    classes[known].add(m, cell.struck, cell.lost);
                }
            }
        }
        let sharp: Vec<(f64, usize, usize)> =
            classes.iter().map(|c| (f64::from(u8::from(c.predicted_lost)), c.lost, c.struck)).collect();
        let whole = ClassCount::joined(&classes, modes);
        Forecast {
            predictor,
            counts,
            phi: counts.phi(),
            strength: Strength::of(counts.phi()),
            brier: brier(&sharp),
            brier_by_class: brier(&classes.iter().flat_map(ClassCount::held_out).collect::<Vec<_>>()),
            brier_base: brier(&whole.held_out().collect::<Vec<_>>()),
            classes,
        }
    }
}

impl ClassCount {
    fn add(&mut self, mode: usize, struck: usize, lost: usize) {
        self.struck += struck;
        self.lost += lost;
        self.by_mode[mode].0 += struck;
        self.by_mode[mode].1 += lost;
    }

    /// All flights as one class.
    fn joined(classes: &[ClassCount], modes: usize) -> ClassCount {
        let mut whole =
            ClassCount { class: "all", predicted_lost: false, struck: 0, lost: 0, by_mode: vec![(0, 0); modes] };
        for class in classes {
            class.by_mode.iter().enumerate().for_each(|(m, (struck, lost))| whole.add(m, *struck, *lost));
        }
        whole
    }

    /// For each mode of the class: the probability of loss from the flights of the other modes, (lost + 1)/(struck +
    /// 2), Laplace's rule of succession; and how many of the mode's flights were lost, of how many.
    fn held_out(&self) -> impl Iterator<Item = (f64, usize, usize)> + '_ {
        self.by_mode.iter().filter(|(struck, _)| *struck > 0).map(|&(struck, lost)| {
            let probability = (self.lost - lost + 1) as f64 / (self.struck - struck + 2) as f64;
            (probability, lost, struck)
        })
    }
}
