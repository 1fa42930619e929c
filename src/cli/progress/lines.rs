//! Plain lines of progress, for logs: none in the first seconds, then few.

use crate::cli::files;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Between two lines, and before the first.
const EVERY: Duration = Duration::from_secs(10);

/// A thread that prints what was told last, so that a line comes even while one long step tells nothing new.
pub struct Lines {
    told: Sender<String>,
    printer: JoinHandle<()>,
}

impl Lines {
    pub fn new() -> Self {
        let (told, heard) = channel();
        let printer = std::thread::spawn(move || {
            follow(&heard, EVERY, EVERY, |elapsed, message| files::tell(&line(elapsed, message)));
        });
        Lines { told, printer }
    }

    pub fn tell(&self, message: String) {
        // Nobody listens only where the printer has died; then there is nothing to show.
        let _ = self.told.send(message);
    }

    pub fn done(self) {
        drop(self.told);
        let _ = self.printer.join();
    }
}

/// Prints the last message heard, with the time since the beginning: not before `first`, and then once in each `every`, until
/// nobody can tell more.
fn follow(heard: &Receiver<String>, first: Duration, every: Duration, mut print: impl FnMut(Duration, &str)) {
    let begin = Instant::now();
    let (mut due, mut last) = (first, String::new());
    loop {
        match heard.recv_timeout(due.saturating_sub(begin.elapsed())) {
            Ok(message) => last = message,
            Err(RecvTimeoutError::Timeout) => {
                let elapsed = begin.elapsed();
                print(elapsed, &last);
                due = elapsed + every;
            }
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}

/// `mavc: 20 s so far; RSP: is 12.35 s enough?`
fn line(elapsed: Duration, message: &str) -> String {
    let message = if message.is_empty() { "working" } else { message };
    format!("mavc: {} s so far; {message}\n", elapsed.as_secs())
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: Duration = Duration::from_secs(1_000_000);

    fn heard(messages: &[&str]) -> (Sender<String>, Receiver<String>) {
        let (told, heard) = channel();
        messages.iter().for_each(|m| told.send(m.to_string()).unwrap());
        (told, heard)
    }

    #[test]
    fn what_ends_before_the_first_line_is_due_prints_nothing() {
        let (told, heard) = heard(&["RIP: is 9.00 s enough?", "RSP: is 9.00 s enough?"]);
        drop(told);
        follow(&heard, LONG, Duration::ZERO, |_, message| panic!("{message}"));
    }

    #[test]
    fn what_was_told_last_is_printed_once_in_an_interval() {
        let (told, heard) = heard(&["RIP: is 9.00 s enough?", "RSP: is 9.00 s enough?"]);
        let mut told = Some(told);
        let mut printed = Vec::new();
        follow(&heard, Duration::ZERO, LONG, |_, message| {
            // More is told, and then no more, long before the next line is due.
            if let Some(told) = told.take() {
                told.send("RSP: is 8.00 s enough?".into()).unwrap();
            }
            printed.push(message.to_string());
        });
        assert_eq!(printed, ["RSP: is 9.00 s enough?"]);
    }

    #[test]
    fn lines_say_how_long_it_has_taken() {
        let said = line(Duration::from_millis(20_400), "RSP: is 12.35 s enough?");
        assert_eq!(said, "mavc: 20 s so far; RSP: is 12.35 s enough?\n");
        assert_eq!(line(Duration::from_secs(10), ""), "mavc: 10 s so far; working\n");
    }
}
