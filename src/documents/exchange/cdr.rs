//! Messages of ROS 2 in the encoding CDR: little-endian, each number aligned to its own size after the four bytes of
//! the head.

use super::bytes::Bytes;

/// One message.
pub struct Message(Bytes);

impl Message {
    pub fn new() -> Self {
        // Plain CDR, little-endian, no options.
        Message(Bytes(vec![0, 1, 0, 0]))
    }

    fn align(&mut self, size: usize) {
        while !(self.0.0.len() - 4).is_multiple_of(size) {
            self.0.u8(0);
        }
    }

    pub fn u32(&mut self, value: u32) -> &mut Self {
        self.align(4);
        self.0.u32(value);
        self
    }

    pub fn f64s(&mut self, values: &[f64]) -> &mut Self {
        self.align(8);
        values.iter().for_each(|value| {
            self.0.f64(*value);
        });
        self
    }

    /// A text with its length, which counts the zero at the end.
    pub fn text(&mut self, text: &str) -> &mut Self {
        self.u32(text.len() as u32 + 1);
        self.0.raw(text.as_bytes()).u8(0);
        self
    }

    /// `builtin_interfaces/Time` and `Duration` for a time that is not negative (s).
    pub fn time(&mut self, time: f64) -> &mut Self {
        let nanoseconds = (time * 1e9).round() as u64;
        self.u32((nanoseconds / 1_000_000_000) as u32).u32((nanoseconds % 1_000_000_000) as u32)
    }

    pub fn finish(self) -> Vec<u8> {
        self.0.0
    }
}

impl Default for Message {
    fn default() -> Self {
        Message::new()
    }
}
