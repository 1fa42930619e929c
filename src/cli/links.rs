//! Links from codes to their pages, in terminals that show them.

use super::spec::colored;
use std::io::IsTerminal;
use std::path::Path;

/// Says where the documentation is, as an address of its folder; empty for no links.
const VARIABLE: &str = "MAVC_DOCS_URL";

/// The address of the documentation's folder, if codes that are printed on `stream` shall lead there: what [`VARIABLE`]
/// says, or else the checkout that this mavc was built from, if it is still on this machine and the reader sits at it. Never
/// where the stream is no terminal, whatever the environment asks for.
pub fn docs(stream: &impl IsTerminal) -> Option<String> {
    // Without colour escapes are taken out, links among them.
    if !colored(stream) || !supports_hyperlinks::supports_hyperlinks() {
        return None;
    }
    match std::env::var(VARIABLE) {
        Ok(address) => Some(address.trim_end_matches('/').to_string()).filter(|address| !address.is_empty()),
        Err(_) if std::env::var_os("SSH_CONNECTION").is_some() => None,
        Err(_) => checkout(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/docs"))),
    }
}

fn checkout(docs: &Path) -> Option<String> {
    let path = docs.join("diagnostics").is_dir().then(|| docs.to_str())??;
    let plain = |b: u8| b.is_ascii_alphanumeric() || b"/-._~".contains(&b);
    let encoded: String =
        path.bytes().map(|b| if plain(b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect();
    // Paths that begin with a drive's letter have to be told from a host.
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
