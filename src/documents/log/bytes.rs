//! Bytes of a log from a file or a pipe, of which a few are in memory at a time.

use crate::cancel;
use std::io::{self, Read};

/// How many bytes are read at once; a message is at most 64 KiB long.
const CHUNK: usize = 1 << 18;

/// A source of bytes that can be looked at before they are used.
pub struct Input<'r> {
    source: &'r mut dyn Read,
    buffer: Vec<u8>,
    start: usize,
    is_at_end: bool,
    /// How many bytes were used.
    pub position: u64,
}

impl<'r> Input<'r> {
    pub fn new(source: &'r mut dyn Read) -> Self {
        Input { source, buffer: Vec::new(), start: 0, is_at_end: false, position: 0 }
    }

    /// The next `count` bytes without using them; fewer at the end.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn peek(&mut self, count: usize) -> io::Result<&[u8]> {
        while self.buffer.len() - self.start < count && !self.is_at_end {
            cancel::checkpoint();
            self.buffer.drain(..self.start);
            self.start = 0;
            let had = self.buffer.len();
            self.buffer.resize(had + CHUNK, 0);
            let got = loop {
                match self.source.read(&mut self.buffer[had..]) {
                    Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
                    other => break other?,
                }
            };
            self.buffer.truncate(had + got);
            self.is_at_end = got == 0;
        }
        let end = self.buffer.len().min(self.start + count);
        Ok(&self.buffer[self.start..end])
    }

    /// Uses bytes that were looked at.
    pub fn skip(&mut self, count: usize) {
        self.start = (self.start + count).min(self.buffer.len());
        self.position += count as u64;
    }
}
