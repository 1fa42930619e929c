//! Requests of browsers: the head of an HTTP request, read within bounds, and what it asks for.

use std::io::{ErrorKind, Read};
use std::time::{Duration, Instant};

/// The longest head of a request, bytes. Browsers send less than 1 kB.
const LONGEST: usize = 8 * 1024;
/// The time that a head may take.
pub const PATIENCE: Duration = Duration::from_secs(5);

/// What a request asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    Page,
    Events,
}

/// A request that is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Request {
    pub wanted: Wanted,
    /// Whether only the head of the answer is sent.
    pub is_head: bool,
}

/// A status of HTTP, for a request that is refused.
pub type Refused = (u16, &'static str);

const MALFORMED: Refused = (400, "Bad Request");
const FORBIDDEN: Refused = (403, "Forbidden");
const NOT_FOUND: Refused = (404, "Not Found");
const NOT_ALLOWED: Refused = (405, "Method Not Allowed");
const TOO_SLOW: Refused = (408, "Request Timeout");
const TOO_LONG: Refused = (431, "Request Header Fields Too Large");

/// Reads the head of a request; `wait` limits the time that the next read may take. `None` if the connection ends.
///
/// # Errors
/// It is too long, or takes too long.
pub fn head(stream: &mut impl Read, wait: impl Fn(&Duration)) -> Result<Option<Vec<u8>>, Refused> {
    let end = Instant::now() + PATIENCE;
    let (mut head, mut part) = (Vec::new(), [0; 1024]);
    loop {
        let left = end.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(TOO_SLOW);
        }
        wait(&left);
        match stream.read(&mut part) {
            Ok(0) => return Ok(None),
            Ok(count) => head.extend_from_slice(&part[..count]),
            Err(e) if e.kind() == ErrorKind::Interrupted => {}
            Err(e) if matches!(e.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => return Err(TOO_SLOW),
            Err(_) => return Ok(None),
        }
        if let Some(at) = head.windows(4).position(|four| four == b"\r\n\r\n").filter(|at| *at <= LONGEST) {
            head.truncate(at);
            return Ok(Some(head));
        }
        if head.len() > LONGEST {
            return Err(TOO_LONG);
        }
    }
}

/// Judges the head of a request to a server at this port of 127.0.0.1.
///
/// The host must be this one: a page from elsewhere whose name leads here (DNS rebinding) names its own. No part of the
/// address reaches the file system.
///
/// # Errors
/// What is asked for is not there, or asked for in another way than browsers show a page.
pub fn judge(head: &[u8], port: u16) -> Result<Request, Refused> {
    let text = std::str::from_utf8(head).map_err(|_| MALFORMED)?;
    let mut lines = text.split("\r\n");
    let words: Vec<&str> = lines.next().unwrap_or_default().split(' ').collect();
    let &[method, target, "HTTP/1.1" | "HTTP/1.0"] = words.as_slice() else { return Err(MALFORMED) };
    let fields: Option<Vec<(&str, &str)>> = lines.map(|line| line.split_once(':')).collect();
    let fields = fields.ok_or(MALFORMED)?;
    let values = |wanted: &str| -> Vec<&str> {
        fields.iter().filter(|(name, _)| name.eq_ignore_ascii_case(wanted)).map(|(_, value)| value.trim()).collect()
    };
    let own = |host: &str| {
        let (name, number) = host.split_once(':').unwrap_or((host, "80"));
        ["127.0.0.1", "localhost"].contains(&name) && number == port.to_string()
    };
    match values("host")[..] {
        [host] if own(host) => {}
        [_] => return Err(FORBIDDEN),
        _ => return Err(MALFORMED),
    }
    if !values("origin").iter().all(|origin| origin.strip_prefix("http://").is_some_and(own)) {
        return Err(FORBIDDEN);
    }
    let is_head = match method {
        "GET" => false,
        "HEAD" => true,
        _ => return Err(NOT_ALLOWED),
    };
    match target {
        "/" => Ok(Request { wanted: Wanted::Page, is_head }),
        "/events" => Ok(Request { wanted: Wanted::Events, is_head }),
        _ => Err(NOT_FOUND),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(first: &str, fields: &[&str]) -> Result<Request, u16> {
        judge([&[first], fields].concat().join("\r\n").as_bytes(), 4711).map_err(|(code, _)| code)
    }

    const HOST: &str = "Host: 127.0.0.1:4711";

    #[test]
    fn a_browser_of_this_computer_gets_the_page_and_its_events_and_nothing_else() {
        let page = Request { wanted: Wanted::Page, is_head: false };
        assert_eq!(judged("GET / HTTP/1.1", &[HOST]), Ok(page));
        assert_eq!(judged("GET / HTTP/1.1", &["HOST:localhost:4711", "Origin: http://127.0.0.1:4711"]), Ok(page));
        assert_eq!(judged("HEAD / HTTP/1.0", &[HOST]), Ok(Request { is_head: true, ..page }));
        assert_eq!(judged("GET /events HTTP/1.1", &[HOST]), Ok(Request { wanted: Wanted::Events, ..page }));
        for target in ["/?", "/x", "//", "/../etc/passwd", "/events/", "/%2e", "http://127.0.0.1:4711/", "*"] {
            assert_eq!(judged(&format!("GET {target} HTTP/1.1"), &[HOST]), Err(404), "{target}");
        }
        for method in ["POST", "PUT", "OPTIONS", "CONNECT", "get", "TRACE"] {
            assert_eq!(judged(&format!("{method} / HTTP/1.1"), &[HOST]), Err(405), "{method}");
        }
    }

    #[test]
    fn other_hosts_and_origins_are_refused() {
        let hosts =
            ["evil.example", "127.0.0.1", "127.0.0.1:80", "localhost.:4711", "127.0.0.1:04711", "[::1]:4711", ""];
        for host in hosts {
            assert_eq!(judged("GET / HTTP/1.1", &[&format!("Host: {host}")]), Err(403), "{host}");
        }
        assert_eq!(judged("GET / HTTP/1.1", &[HOST, "Origin: http://evil.example"]), Err(403));
        assert_eq!(judged("GET / HTTP/1.1", &[HOST, "Origin: null"]), Err(403));
        assert_eq!(judged("GET / HTTP/1.1", &[]), Err(400));
        assert_eq!(judged("GET / HTTP/1.1", &[HOST, HOST]), Err(400));
        assert_eq!(
            judge(b"GET / HTTP/1.1\r\nHost: 127.0.0.1", 80).map_err(|(code, _)| code).map(|r| r.is_head),
            Ok(false)
        );
    }

    #[test]
    fn what_is_no_request_is_malformed() {
        for first in ["", "GET /", "GET / HTTP/2", "GET  / HTTP/1.1", "GET / HTTP/1.1 x", "\u{0}"] {
            assert_eq!(judged(first, &[HOST]), Err(400), "{first:?}");
        }
        assert_eq!(judged("GET / HTTP/1.1", &[HOST, "no colon"]), Err(400));
        assert_eq!(judge(b"GET / HTTP/1.1\r\nHost: \xff", 1), Err(MALFORMED));
    }

    /// Gives one byte at a time.
    struct Slow<'a>(&'a [u8]);

    impl Read for Slow<'_> {
        fn read(&mut self, part: &mut [u8]) -> std::io::Result<usize> {
            let Some((first, rest)) = self.0.split_first() else { return Ok(0) };
            (part[0], self.0) = (*first, rest);
            Ok(1)
        }
    }

    #[test]
    fn heads_are_read_whole_and_within_bounds() {
        let read = |bytes: &[u8]| head(&mut Slow(bytes), |_| {});
        assert_eq!(read(b"GET / HTTP/1.1\r\nA: b\r\n\r\nbody"), Ok(Some(b"GET / HTTP/1.1\r\nA: b".to_vec())));
        assert_eq!(read(b"GET / HTTP/1.1\r\n"), Ok(None));
        let long = [b"GET / HTTP/1.1\r\nA: ".as_slice(), &[b'x'; 2 * LONGEST]].concat();
        assert_eq!(read(&long), Err(TOO_LONG));
    }
}
