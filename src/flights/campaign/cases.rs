//! Numbering of cases: planner, mode, instant of the fault, seed; the seed varies fastest.

/// Most flights of a campaign.
pub const MAX_FLIGHTS: usize = 100_000_000;

/// The dimensions of a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cases {
    pub planners: usize,
    pub modes: usize,
    pub times: usize,
    pub seeds: usize,
}

/// One flight of a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Case {
    pub number: usize,
    /// Index of the plan flown.
    pub planner: usize,
    /// `None` for a flight without a fault.
    pub strike: Option<StrikeAt>,
    /// Index of the seed.
    pub seed: usize,
}

/// Indices of the mode and of the instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StrikeAt {
    pub mode: usize,
    pub time: usize,
}

impl Cases {
    /// Number of cases: for each seed, every plan is flown once without a fault and once for each mode and instant.
    pub fn count(&self) -> usize {
        self.planners * self.blocks() * self.seeds
    }

    /// Number of blocks of seeds for each planner; the first is the healthy one.
    fn blocks(&self) -> usize {
        1 + self.modes * self.times
    }

    /// The case with a number below [`Cases::count`].
    pub fn case(&self, number: usize) -> Case {
        let (block, seed) = (number / self.seeds, number % self.seeds);
        let (planner, block) = (block / self.blocks(), block % self.blocks());
        let strike = block.checked_sub(1).map(|b| StrikeAt { mode: b / self.times, time: b % self.times });
        Case { number, planner, strike, seed }
    }

    /// The cases of a shard, in order.
    pub fn of(&self, shard: Shard) -> impl Iterator<Item = Case> + use<> {
        let cases = *self;
        (shard.index..self.count()).step_by(shard.of).map(move |number| cases.case(number))
    }
}

/// The cases whose number has the remainder `index` when divided by `of`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// 0-based; below `of`.
    pub index: usize,
    pub of: usize,
}

impl Shard {
    pub const WHOLE: Shard = Shard { index: 0, of: 1 };

    /// Number of cases of a campaign of `count` cases that are in this shard.
    pub fn count(&self, count: usize) -> usize {
        count.saturating_sub(self.index).div_ceil(self.of)
    }
}

/// The midpoint of the `index`-th of `times` equal parts of the mission time, s.
pub fn fault_time(mission_time: f64, times: usize, index: usize) -> f64 {
    mission_time * (2 * index + 1) as f64 / (2 * times) as f64
}

/// The seed of a flight's noise. It depends only on the index of the seed: all planners, modes and instants have the
/// same noise and gusts, so that they can be compared in pairs. One step of SplitMix64 (Steele, Lea, Flood 2014).
pub fn noise_seed(campaign_seed: u64, seed: usize) -> u64 {
    let mix = |z: u64| {
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    // The campaign's seed is mixed first: otherwise campaigns with consecutive seeds would share flights' seeds.
    mix(mix(campaign_seed.wrapping_add(GOLDEN)).wrapping_add((seed as u64).wrapping_mul(GOLDEN)))
}
