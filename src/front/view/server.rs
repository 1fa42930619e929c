//! The server of the page: HTTP for browsers of this computer, one thread for each connection, within bounds.

use super::board::Board;
use super::request::{Refused, Request, Wanted, head, judge};
use crate::report::page;
use std::collections::VecDeque;
use std::io::{Read, Result, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Connections at most: a new one ends the oldest. A browser keeps one for each window.
const MOST: usize = 32;
/// The time that sending a part may take.
const SENDING: Duration = Duration::from_secs(10);
/// Bytes read after a request that is refused.
const MOST_DRAINED: u64 = 1 << 20;
/// The least time between two reports of changes.
const PAUSE: Duration = Duration::from_millis(100);
/// After this time without a change a line shows whether the browser is still there.
const QUIET: Duration = Duration::from_secs(15);

/// The open connections, oldest first.
#[derive(Default)]
struct Open(Mutex<(u64, VecDeque<(u64, TcpStream)>)>);

impl Open {
    /// Adds a connection, and ends the oldest of too many. Returns its number.
    fn add(&self, stream: TcpStream) -> u64 {
        let mut open = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if open.1.len() >= MOST
            && let Some((_, oldest)) = open.1.pop_front()
        {
            let _ = oldest.shutdown(Shutdown::Both);
        }
        open.0 += 1;
        let number = open.0;
        open.1.push_back((number, stream));
        number
    }

    fn remove(&self, number: u64) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).1.retain(|(other, _)| *other != number);
    }
}

/// Serves until the process ends.
pub fn serve(listener: &TcpListener, port: u16, board: &Arc<Board>) {
    let open = Arc::new(Open::default());
    for stream in listener.incoming() {
        // A connection that ended at once, or too many open files: others may follow.
        let Ok((stream, kept)) = stream.and_then(|stream| Ok((stream.try_clone()?, stream))) else {
            std::thread::sleep(PAUSE);
            continue;
        };
        let number = open.add(kept);
        let (board, within) = (board.clone(), open.clone());
        let answered = std::thread::Builder::new().name("browser".into()).spawn(move || {
            // A browser that has gone away is not an error.
            let _ = answer(stream, port, &board);
            within.remove(number);
        });
        if answered.is_err() {
            open.remove(number);
        }
    }
}

/// Answers one request and ends the connection.
fn answer(mut stream: TcpStream, port: u16, board: &Board) -> Result<()> {
    stream.set_write_timeout(Some(SENDING))?;
    let timed = stream.try_clone()?;
    let read = head(&mut stream, |left| drop(timed.set_read_timeout(Some(*left))));
    match read.and_then(|head| head.map(|head| judge(&head, port)).transpose()) {
        Ok(None) => Ok(()),
        Ok(Some(Request { wanted: Wanted::Page, is_head })) => {
            let page = board.page();
            let fields = format!(
                "Content-Type: text/html; charset=utf-8\r\nContent-Security-Policy: {}; frame-ancestors 'none'\r\n",
                page::live::policy()
            );
            send(&mut stream, (200, "OK"), &fields, if is_head { None } else { Some(&page) }, page.len())
        }
        Ok(Some(Request { wanted: Wanted::Events, is_head })) => {
            stream.write_all(start((200, "OK"), "Content-Type: text/event-stream\r\n").as_bytes())?;
            if is_head { Ok(()) } else { events(&mut stream, board) }
        }
        Err(refused) => {
            let fields = if refused.0 == 405 { "Allow: GET, HEAD\r\n" } else { "" };
            let fields = format!("Content-Type: text/plain; charset=utf-8\r\n{fields}");
            let text = format!("{} {}\n", refused.0, refused.1);
            send(&mut stream, refused, &fields, Some(&text), text.len())?;
            stream.shutdown(Shutdown::Write)?;
            drain(&mut stream)
        }
    }
}

/// Reads what a refused client still sends, within bounds: unread bytes would reset the connection before it has seen
/// the answer.
fn drain(stream: &mut TcpStream) -> Result<()> {
    stream.set_read_timeout(Some(PAUSE))?;
    std::io::copy(&mut stream.take(MOST_DRAINED), &mut std::io::sink()).map(drop)
}

/// The head of an answer, with fields of its own.
fn start((code, words): Refused, fields: &str) -> String {
    format!(
        "HTTP/1.1 {code} {words}\r\n{fields}Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n\
         Referrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\nConnection: close\r\n\r\n"
    )
}

fn send(stream: &mut TcpStream, status: Refused, fields: &str, body: Option<&str>, length: usize) -> Result<()> {
    stream.write_all(start(status, &format!("{fields}Content-Length: {length}\r\n")).as_bytes())?;
    stream.write_all(body.unwrap_or_default().as_bytes())?;
    stream.flush()
}

/// Tells of each change, as server-sent events.
fn events(stream: &mut TcpStream, board: &Board) -> Result<()> {
    let mut seen = None;
    loop {
        match board.after(seen, QUIET) {
            Some((change, status)) => {
                seen = Some(change);
                // JSON has no line break.
                let data = serde_json::to_string(&status).map_err(std::io::Error::other)?;
                stream.write_all(format!("data: {data}\n\n").as_bytes())?;
            }
            None => stream.write_all(b":\n\n")?,
        }
        stream.flush()?;
        std::thread::sleep(PAUSE);
    }
}
