//! Plain lines of progress, for logs: the first after ten seconds, then one every ten seconds, or less and less often
//! while nothing changes.

use crate::cli::files;
use crate::text_table::hanging;
use std::sync::LazyLock;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// The time between two lines, and before the first.
const EVERY: Duration = Duration::from_secs(10);

/// When the first display started: a command may plan several times, and counts from its start.
static STARTED: LazyLock<Instant> = LazyLock::new(Instant::now);

/// A thread that prints the latest message, so that a line appears even during one long step.
pub struct Lines {
    sender: Sender<String>,
    printer: JoinHandle<()>,
}

impl Lines {
    pub fn new() -> Self {
        LazyLock::force(&STARTED);
        let (sender, messages) = channel();
        let printer = std::thread::spawn(move || {
            follow(&messages, EVERY, EVERY, |_, message| files::eprint(&line(STARTED.elapsed(), message)));
        });
        Lines { sender, printer }
    }

    pub fn update(&self, message: String) {
        // This fails only if the printer has died; then there is nothing to show.
        let _ = self.sender.send(message);
    }

    pub fn done(self) {
        drop(self.sender);
        let _ = self.printer.join();
    }
}

/// Prints the latest message and the time since the start: first after `first`, then once in each `every`, until the
/// channel is closed. A message that stays the same is repeated after twice as long each time.
fn follow(messages: &Receiver<String>, first: Duration, every: Duration, mut print: impl FnMut(Duration, &str)) {
    let begin = Instant::now();
    let (mut due, mut last) = (first, String::new());
    // What was printed last, and when; and how long the same may stay unsaid.
    let (mut printed, mut pause): (Option<(String, Duration)>, Duration) = (None, every);
    loop {
        match messages.recv_timeout(due.saturating_sub(begin.elapsed())) {
            Ok(message) => last = message,
            Err(RecvTimeoutError::Timeout) => {
                let elapsed = begin.elapsed();
                due = elapsed + every;
                match printed.as_ref().filter(|(said, _)| *said == last) {
                    Some((_, at)) if elapsed < *at + pause => continue,
                    Some(_) => pause *= 2,
                    None => pause = every,
                }
                print(elapsed, &last);
                printed = Some((last.clone(), elapsed));
            }
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}

/// `mavc: 20 s so far; RSP: trying 12.35 s`
fn line(elapsed: Duration, message: &str) -> String {
    let message = if message.is_empty() { "working" } else { message };
    hanging(&format!("mavc: {} s so far; {message}", elapsed.as_secs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: Duration = Duration::from_secs(1_000_000);

    fn sent(messages: &[&str]) -> (Sender<String>, Receiver<String>) {
        let (sender, receiver) = channel();
        messages.iter().for_each(|m| sender.send(m.to_string()).unwrap());
        (sender, receiver)
    }

    #[test]
    fn a_run_that_ends_before_the_first_line_is_due_prints_nothing() {
        let (sender, receiver) = sent(&["RIP: trying 9.00 s", "RSP: trying 9.00 s"]);
        drop(sender);
        follow(&receiver, LONG, Duration::ZERO, |_, message| panic!("{message}"));
    }

    #[test]
    fn the_latest_message_is_printed_once_in_an_interval() {
        let (sender, receiver) = sent(&["RIP: trying 9.00 s", "RSP: trying 9.00 s"]);
        let mut sender = Some(sender);
        let mut printed = Vec::new();
        follow(&receiver, Duration::ZERO, LONG, |_, message| {
            // One more message, and the end, long before the next line is due.
            if let Some(sender) = sender.take() {
                sender.send("RSP: trying 8.00 s".into()).unwrap();
            }
            printed.push(message.to_string());
        });
        assert_eq!(printed, ["RSP: trying 9.00 s"]);
    }

    #[test]
    fn what_stays_the_same_is_said_less_and_less_often() {
        let (sender, receiver) = sent(&["RIP: trying 9.00 s"]);
        let (mut sender, mut said) = (Some(sender), Vec::new());
        follow(&receiver, Duration::ZERO, Duration::from_millis(4), |elapsed, _| {
            said.push(elapsed);
            if said.len() == 5 {
                sender.take();
            }
        });
        assert_eq!(said.len(), 5);
        let pause = said[4] - said[0];
        assert!(pause >= Duration::from_millis(4 + 8 + 16 + 32), "{said:?}");
    }

    #[test]
    fn lines_say_how_long_it_has_taken() {
        let said = line(Duration::from_millis(20_400), "RSP: trying 12.35 s");
        assert_eq!(said, "mavc: 20 s so far; RSP: trying 12.35 s\n");
        assert_eq!(line(Duration::from_secs(10), ""), "mavc: 10 s so far; working\n");
    }
}
