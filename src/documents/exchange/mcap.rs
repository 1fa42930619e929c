//! MCAP, the container of logs that Foxglove, PlotJuggler and ROS 2 read: records of one byte of kind, a length and a
//! content. Messages are in chunks without compression, which an index at the end finds by time.
//! <https://mcap.dev/spec>

use super::bytes::Bytes;

const MAGIC: &[u8] = b"\x89MCAP0\r\n";

/// Kinds of records.
mod kind {
    pub const HEADER: u8 = 0x01;
    pub const FOOTER: u8 = 0x02;
    pub const SCHEMA: u8 = 0x03;
    pub const CHANNEL: u8 = 0x04;
    pub const MESSAGE: u8 = 0x05;
    pub const CHUNK: u8 = 0x06;
    pub const MESSAGE_INDEX: u8 = 0x07;
    pub const CHUNK_INDEX: u8 = 0x08;
    pub const STATISTICS: u8 = 0x0b;
    pub const DATA_END: u8 = 0x0f;
}

/// A chunk is closed once it has so many bytes.
const CHUNK: usize = 1 << 20;

/// The schema of a channel's messages.
#[derive(Clone, Copy)]
pub struct Schema<'s> {
    pub name: &'s str,
    pub encoding: &'s str,
    pub text: &'s str,
}

/// Writes one file. Times are in nanoseconds.
pub struct Writer {
    out: Bytes,
    /// Schemas and channels, repeated in the summary.
    known: Bytes,
    /// Messages of each channel.
    counts: Vec<u64>,
    schemas: u16,
    chunk: Chunk,
    index: Bytes,
    chunks: u32,
    span: Option<[u64; 2]>,
}

/// The chunk that messages are added to.
#[derive(Default)]
struct Chunk {
    records: Bytes,
    /// For each channel, time and place of its messages in `records`.
    places: Vec<Vec<[u64; 2]>>,
    span: Option<[u64; 2]>,
}

impl Writer {
    /// An empty file of a profile, such as `ros2`.
    pub fn new(profile: &str) -> Self {
        let mut out = Bytes(MAGIC.to_vec());
        let mut header = Bytes::default();
        header.with_length(profile.as_bytes()).with_length(concat!("mavc ", env!("CARGO_PKG_VERSION")).as_bytes());
        record(&mut out, kind::HEADER, &header);
        Writer {
            out,
            known: Bytes::default(),
            counts: Vec::new(),
            schemas: 0,
            chunk: Chunk::default(),
            index: Bytes::default(),
            chunks: 0,
            span: None,
        }
    }

    /// Adds a channel with a schema of its own; its number.
    pub fn channel(
        &mut self,
        topic: &str,
        message: &str,
        Schema { name, encoding, text }: Schema,
        metadata: &[(&str, &str)],
    ) -> usize {
        self.schemas += 1;
        let mut content = Bytes::default();
        content
            .u16(self.schemas)
            .with_length(name.as_bytes())
            .with_length(encoding.as_bytes())
            .with_length(text.as_bytes());
        let mut records = Bytes::default();
        record(&mut records, kind::SCHEMA, &content);
        let mut pairs = Bytes::default();
        for (key, value) in metadata {
            pairs.with_length(key.as_bytes()).with_length(value.as_bytes());
        }
        let id = self.counts.len();
        let mut content = Bytes::default();
        content.u16(id as u16).u16(self.schemas).with_length(topic.as_bytes()).with_length(message.as_bytes());
        record(&mut records, kind::CHANNEL, content.with_length(&pairs.0));
        self.out.raw(&records.0);
        self.known.raw(&records.0);
        self.counts.push(0);
        id
    }

    /// Adds a message to a channel.
    pub fn message(&mut self, channel: usize, time: u64, data: &[u8]) {
        let mut content = Bytes::default();
        content.u16(channel as u16).u32(self.counts[channel] as u32).u64(time).u64(time).raw(data);
        self.counts[channel] += 1;
        self.chunk.places.resize(self.counts.len(), Vec::new());
        self.chunk.places[channel].push([time, self.chunk.records.0.len() as u64]);
        record(&mut self.chunk.records, kind::MESSAGE, &content);
        for span in [&mut self.chunk.span, &mut self.span] {
            let [from, to] = span.unwrap_or([time, time]);
            *span = Some([from.min(time), to.max(time)]);
        }
        if self.chunk.records.0.len() >= CHUNK {
            self.close_chunk();
        }
    }

    fn close_chunk(&mut self) {
        let Chunk { records, places, span } = std::mem::take(&mut self.chunk);
        let Some([from, to]) = span else { return };
        let size = records.0.len() as u64;
        let begin = self.out.0.len() as u64;
        let mut content = Bytes::default();
        content.u64(from).u64(to).u64(size).u32(crc32(&records.0)).with_length(b"").u64(size).raw(&records.0);
        record(&mut self.out, kind::CHUNK, &content);
        let end = self.out.0.len() as u64;
        let mut offsets = Bytes::default();
        for (channel, places) in places.iter().enumerate().filter(|(_, places)| !places.is_empty()) {
            offsets.u16(channel as u16).u64(self.out.0.len() as u64);
            let mut pairs = Bytes::default();
            places.iter().flatten().for_each(|number| {
                pairs.u64(*number);
            });
            let mut content = Bytes::default();
            record(&mut self.out, kind::MESSAGE_INDEX, content.u16(channel as u16).with_length(&pairs.0));
        }
        let mut content = Bytes::default();
        content.u64(from).u64(to).u64(begin).u64(end - begin).with_length(&offsets.0);
        content.u64(self.out.0.len() as u64 - end).with_length(b"").u64(size).u64(size);
        record(&mut self.index, kind::CHUNK_INDEX, &content);
        self.chunks += 1;
    }

    /// The whole file.
    pub fn finish(mut self) -> Vec<u8> {
        self.close_chunk();
        let mut end = Bytes::default();
        record(&mut self.out, kind::DATA_END, end.u32(0));
        let summary = self.out.0.len();
        self.out.raw(&self.known.0).raw(&self.index.0);
        let [from, to] = self.span.unwrap_or_default();
        let mut counts = Bytes::default();
        for (channel, count) in self.counts.iter().enumerate() {
            counts.u16(channel as u16).u64(*count);
        }
        let mut content = Bytes::default();
        content.u64(self.counts.iter().sum()).u16(self.schemas).u32(self.counts.len() as u32);
        content.u32(0).u32(0).u32(self.chunks).u64(from).u64(to).with_length(&counts.0);
        record(&mut self.out, kind::STATISTICS, &content);
        // The check of the summary covers the footer up to itself.
        self.out.u8(kind::FOOTER).u64(20).u64(summary as u64).u64(0);
        let check = crc32(&self.out.0[summary..]);
        self.out.u32(check).raw(MAGIC);
        self.out.0
    }
}

fn record(out: &mut Bytes, kind: u8, content: &Bytes) {
    out.u8(kind).u64(content.0.len() as u64).raw(&content.0);
}

/// The cyclic redundancy check of ISO 3309, reflected, as zlib has it.
fn crc32(bytes: &[u8]) -> u32 {
    let mut table = [0u32; 256];
    for (k, entry) in table.iter_mut().enumerate() {
        *entry = (0..8).fold(k as u32, |c, _| if c & 1 == 1 { 0xedb8_8320 ^ (c >> 1) } else { c >> 1 });
    }
    !bytes.iter().fold(!0, |c, byte| table[((c ^ u32::from(*byte)) & 0xff) as usize] ^ (c >> 8))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_check_is_that_of_the_catalogue() {
        assert_eq!(super::crc32(b"123456789"), 0xcbf4_3926);
        assert_eq!(super::crc32(b""), 0);
    }
}
