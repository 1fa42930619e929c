//! Messages over standard input and output. Input that is not a message is reported to the editor and skipped; lengths
//! beyond the limit of texts are rejected.

use crate::source::visible;
use crossbeam_channel::{Sender, bounded};
use lsp_server::{Connection, Message, Notification};
use serde_json::json;
use std::io::{self, BufRead, ErrorKind, Read};
use std::thread::{self, JoinHandle};

/// Bytes of one message, and of its header.
const MOST_BYTES: u64 = 64 << 20;
const MOST_HEADER: u64 = 8 << 10;

/// `MessageType.Error` of the protocol.
const ERROR: i32 = 1;

/// The threads that read and write.
pub(super) struct Threads {
    reader: JoinHandle<io::Result<()>>,
    writer: JoinHandle<io::Result<()>>,
}

impl Threads {
    /// Waits for both threads; the connection must be closed.
    ///
    /// # Errors
    /// What came in had no length that can be read, or was torn; standard input or output failed.
    pub fn join(self) -> io::Result<()> {
        let ended = |thread: JoinHandle<io::Result<()>>| match thread.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        };
        ended(self.reader)?;
        ended(self.writer)
    }
}

/// A connection over standard input and output.
pub(super) fn stdio() -> (Connection, Threads) {
    let (sender, outgoing) = bounded::<Message>(0);
    let (incoming, receiver) = bounded::<Message>(0);
    let writer = thread::spawn(move || {
        let mut output = io::stdout().lock();
        outgoing.into_iter().try_for_each(|message| message.write(&mut output))
    });
    let replies = sender.clone();
    let reader = thread::spawn(move || read_all(&mut io::stdin().lock(), &incoming, &replies));
    (Connection { sender, receiver }, Threads { reader, writer })
}

/// Passes messages on until `exit`, the end of the input, or until nobody takes them any more.
fn read_all(input: &mut impl BufRead, incoming: &Sender<Message>, replies: &Sender<Message>) -> io::Result<()> {
    while let Some(read) = read(input)? {
        let taken = match read {
            Ok(message) => {
                let is_exit = matches!(&message, Message::Notification(note) if note.method == "exit");
                let taken = incoming.send(message);
                if is_exit {
                    break;
                }
                taken
            }
            Err(why) => {
                let text = format!("mavc passes over a message that it cannot read: {}", visible::line(&why));
                let params = json!({ "type": ERROR, "message": text });
                replies.send(Notification { method: "window/logMessage".into(), params }.into())
            }
        };
        if taken.is_err() {
            break;
        }
    }
    Ok(())
}

/// The next message, or why there is none in its place; `None` at the end of the input.
///
/// # Errors
/// The start of the next message is unknown: its header has no length, or an impossible one.
fn read(input: &mut impl BufRead) -> io::Result<Option<Result<Message, String>>> {
    let mut header = String::new();
    loop {
        let begun = header.len();
        let read = input.by_ref().take(MOST_HEADER - begun as u64).read_line(&mut header)?;
        let line = &header[begun..];
        match line.strip_suffix('\n') {
            Some(line) if line.trim_end_matches('\r').is_empty() => break,
            Some(_) => {}
            None if read == 0 && begun == 0 => return Ok(None),
            None => return Err(io::Error::new(ErrorKind::InvalidData, "a header of a message has no end")),
        }
    }
    let lengths = header.lines().filter_map(|line| line.split_once(':'));
    let length = lengths
        .filter(|(name, _)| name.trim().eq_ignore_ascii_case("Content-Length"))
        .find_map(|(_, value)| value.trim().parse::<u64>().ok())
        .ok_or_else(|| io::Error::new(ErrorKind::InvalidData, "a message has no `Content-Length`"))?;
    if length > MOST_BYTES {
        let why = format!("a message of {length} bytes is announced, and at most {MOST_BYTES} are read");
        return Err(io::Error::new(ErrorKind::InvalidData, why));
    }
    let mut body = Vec::new();
    if (input.take(length).read_to_end(&mut body)? as u64) < length {
        return Err(io::Error::new(ErrorKind::UnexpectedEof, "the input ends within a message"));
    }
    Ok(Some(serde_json::from_slice(&body).map_err(|error| error.to_string())))
}
