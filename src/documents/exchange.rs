//! Vehicles, plans and flights in the formats of other tools. What each format keeps, and what was measured when its
//! own reader read it, is in `docs/exchange.md`.

pub mod bytes;
pub mod cdr;
pub mod flight;
pub mod frames;
pub mod mcap;
pub mod mission;
pub mod trajectory;
pub mod vehicle;

/// A plan in the format of another tool.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    pub bytes: Vec<u8>,
    /// What the format lost, in one line, if it is more than rounding.
    pub remark: Option<String>,
}

impl From<String> for Written {
    fn from(text: String) -> Self {
        Written { bytes: text.into_bytes(), remark: None }
    }
}
