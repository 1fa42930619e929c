//! The number of threads. Results do not depend on it. More than a few threads for each core only cost time and memory,
//! so the number is capped whatever the user requests.

use std::num::NonZero;

/// The most threads for each core.
const EACH_CORE: usize = 4;

/// The environment variables that rayon reads; the second is the old name.
const VARIABLES: [&str; 2] = ["RAYON_NUM_THREADS", "RAYON_RS_NUM_CPUS"];

fn most() -> usize {
    EACH_CORE * std::thread::available_parallelism().map_or(1, NonZero::get)
}

/// Sets the number of threads to that of `--threads`, or else of the environment, up to the cap. Without either, rayon
/// uses as many as there are cores. Must be called before the first parallel work.
pub fn limit(asked: Option<u64>) {
    let environment = VARIABLES.iter().find_map(|name| std::env::var(name).ok()?.parse().ok()).filter(|n: &u64| *n > 0);
    let Some(threads) = capped(asked, environment, most()) else { return };
    // This fails only if a global pool exists; a command starts none before.
    let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
}

/// `None` if rayon may choose.
fn capped(asked: Option<u64>, environment: Option<u64>, most: usize) -> Option<usize> {
    let cap = |n: u64| usize::try_from(n).unwrap_or(usize::MAX).min(most);
    asked.map(cap).or_else(|| environment.filter(|n| *n > most as u64).map(cap))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_capped_wherever_they_come_from() {
        assert_eq!(capped(None, None, 8), None);
        assert_eq!(capped(None, Some(8), 8), None, "rayon reads the environment itself");
        assert_eq!(capped(None, Some(100_000), 8), Some(8));
        assert_eq!(capped(Some(3), Some(100_000), 8), Some(3));
        assert_eq!(capped(Some(u64::MAX), None, 8), Some(8));
    }
}
