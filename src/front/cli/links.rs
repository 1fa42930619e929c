//! Links from diagnostic codes to their pages, in terminals that show links.

use std::io::IsTerminal;
use std::path::Path;

/// The environment variable with the address of the documentation's folder; empty for no links.
const VARIABLE: &str = "MAVC_DOCS_URL";

/// The address of the documentation's folder, if codes printed on `stream` shall link there: the value of [`VARIABLE`],
/// or else the checkout that this mavc was built from, if it is still on this machine and the reader is at it. `None`
/// if the stream is not a terminal, whatever the environment says.
pub fn docs(stream: &impl IsTerminal) -> Option<String> {
    // Without colour all escapes are removed, and links are escapes.
    if !colored(stream) || !supports_hyperlinks::supports_hyperlinks() {
        return None;
    }
    match std::env::var(VARIABLE) {
        Ok(address) => Some(address.trim_end_matches('/').to_string()).filter(|address| !address.is_empty()),
        Err(_) if std::env::var_os("SSH_CONNECTION").is_some() => None,
        Err(_) => checkout(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/docs"))),
    }
}

/// Colour where the stream is a terminal and NO_COLOR is not set.
pub fn colored(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}

fn checkout(docs: &Path) -> Option<String> {
    let path = docs.join("diagnostics").is_dir().then(|| docs.to_str())??;
    let plain = |b: u8| b.is_ascii_alphanumeric() || b"/-._~".contains(&b);
    let encoded: String =
        path.bytes().map(|b| if plain(b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect();
    // A drive letter must not be read as a host.
    Some(format!("file://{}{encoded}", if path.starts_with('/') { "" } else { "/" }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checkout_is_a_file_address() {
        let dir = tempfile::tempdir().unwrap();
        let docs = dir.path().join("a b/docs");
        assert_eq!(checkout(&docs), None);
        std::fs::create_dir_all(docs.join("diagnostics")).unwrap();
        let address = checkout(&docs).unwrap();
        assert!(address.starts_with("file:///") && address.ends_with("/a%20b/docs"), "{address}");
    }
}
