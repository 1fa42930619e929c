//! `mavc safety --check`: whether the files of a folder follow from the spec, the report and the certificate.

use super::super::{CommandError, FINE, REJECTED, files};
use super::Read;
use crate::certificate::MAX_BYTES;
use crate::safety::inputs::{Inputs, SUMS, TABLES, listed, version};
use crate::safety::{CERTIFICATE, REPORT, sha256};
use crate::text_table::fitted;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Component, Path};

/// The files that state the hashes of the report and of the certificate.
const STATING: [&str; 4] = ["quantities.json", "argument.json", "faulttree.xml", "index.html"];

/// Prints what is wrong; the exit code.
pub fn rejected(why: &str) -> u8 {
    files::eprint(&format!("mavc: {why}\n"));
    REJECTED
}

/// Reads what the files of a folder are written from. `None` after it has printed which file is missing, or has another
/// hash than those that the folder states.
pub fn read(folder: &Path) -> Option<Read> {
    let stating: Vec<Vec<u8>> = STATING.iter().filter_map(|name| bytes(folder, name).ok()).collect();
    let quantities: Option<Value> = bytes(folder, STATING[0]).ok().and_then(|text| serde_json::from_slice(&text).ok());
    let stated = |member: &str| quantities.as_ref().and_then(|all| all[member].as_str());
    // Where one file states it, another one was edited: it will not follow.
    let is_stated = |hash: &str| {
        let holds = |text: &Vec<u8>| text.windows(hash.len()).any(|part| part == hash.as_bytes());
        stating.is_empty() || stating.iter().any(holds)
    };
    let of_input = |name: &str| match bytes(folder, name) {
        Ok(there) if is_stated(&sha256(&there)) => Some(there),
        Ok(_) => changed(name),
        Err(why) => said(name, &why),
    };
    let [report, certificate] = [of_input(REPORT), of_input(CERTIFICATE)];
    let has_tables = match &quantities {
        Some(_) => stated("branches_sha256").is_some(),
        None => folder.join(SUMS).exists(),
    };
    let tables = match has_tables {
        true => of_input(SUMS).and_then(|sums| tables(folder, &sums)),
        false => Some(Vec::new()),
    };
    let written_by = stated("written_by").map_or_else(version, str::to_string);
    let spec_files = quantities.as_ref().and_then(spec_files).unwrap_or_default();
    Some(Read { report: report?, certificate: certificate?, tables: tables?, written_by, spec_files })
}

/// The names and hashes of the spec's texts that a folder states; `None` where a name leads out of it.
fn spec_files(quantities: &Value) -> Option<Vec<(String, String)>> {
    let text = |text: &Value| {
        let (name, hash) = (text["file"].as_str()?, text["sha256"].as_str()?);
        let is_inside = Path::new(name).components().all(|part| matches!(part, Component::Normal(_)));
        is_inside.then(|| (name.to_string(), hash.to_string()))
    };
    quantities["spec"].as_array()?.iter().map(text).collect()
}

/// The tables of ways out that a list of hashes names.
fn tables(folder: &Path, sums: &[u8]) -> Option<Vec<(String, Vec<u8>)>> {
    let Some(listed) = std::str::from_utf8(sums).ok().and_then(listed) else {
        return said(SUMS, "it is not a list of hashes and names");
    };
    let table = |(hash, file): (&str, &str)| {
        let name = format!("{TABLES}/{file}");
        match bytes(folder, &name) {
            Ok(there) if sha256(&there) == hash => Some((file.to_string(), there)),
            Ok(_) => changed(&name),
            Err(why) => said(&name, &why),
        }
    };
    // All of them, so that each one that changed is reported.
    let all: Vec<_> = listed.into_iter().map(table).collect();
    all.into_iter().collect()
}

fn bytes(folder: &Path, name: &str) -> Result<Vec<u8>, CommandError> {
    files::read_spec(&folder.join(name).display().to_string(), MAX_BYTES)
}

fn changed<T>(name: &str) -> Option<T> {
    said(name, "changed since the folder was written")
}

fn said<T>(name: &str, why: &str) -> Option<T> {
    rejected(&format!("{name}: {why}"));
    None
}

/// The files in the folder of an assessment that are not its `own`; not those whose names begin with a dot, which file
/// managers leave. A folder without a file of its own is named and not read, however large it is.
pub fn strangers<'n>(folder: &Path, own: impl Iterator<Item = &'n str>) -> Vec<String> {
    let own: BTreeSet<&str> = own.collect();
    let mut next = vec![String::new()];
    let mut found = Vec::new();
    while let Some(within) = next.pop() {
        let entries = std::fs::read_dir(folder.join(&within)).into_iter().flatten().flatten();
        for entry in entries.filter(|entry| !entry.file_name().as_encoded_bytes().starts_with(b".")) {
            let separator = if within.is_empty() { "" } else { "/" };
            let inner = format!("{within}{separator}{}", entry.file_name().display());
            let has_own = || own.iter().any(|name| name.strip_prefix(&inner).is_some_and(|rest| rest.starts_with('/')));
            match entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                true if has_own() => next.push(inner),
                true => found.push(inner),
                false if own.contains(inner.as_str()) => (),
                false => found.push(inner),
            }
        }
    }
    found.sort();
    found
}

/// `branches/a.csv and 3 more`
pub fn listed_briefly(strangers: &[String]) -> Option<String> {
    match strangers {
        [] => None,
        [one] => Some(one.clone()),
        [first, rest @ ..] => Some(format!("{first} and {} more", rest.len())),
    }
}

/// Compares the files of a folder with those that follow from the spec and from `inputs`.
pub fn compare(folder: &Path, derived: &[(String, Vec<u8>)], inputs: &Inputs) -> Result<u8, CommandError> {
    let tables: Vec<String> = inputs.tables.iter().map(|(name, _)| format!("{TABLES}/{name}")).collect();
    let read = [Some(REPORT), Some(CERTIFICATE), (!tables.is_empty()).then_some(SUMS)];
    let own = derived.iter().map(|(name, _)| name).chain(&tables).map(String::as_str).chain(read.into_iter().flatten());
    let mut differ = 0;
    if let Some(names) = listed_briefly(&strangers(folder, own)) {
        differ += 1;
        rejected(&format!("{names}: not of this assessment: move it out of the folder"));
    }
    for (name, due) in derived {
        let why = match bytes(folder, name) {
            Ok(there) if there == *due => continue,
            Ok(_) => "does not follow from the spec, the report and the certificate: write the folder again".into(),
            Err(why) => why,
        };
        differ += 1;
        rejected(&format!("{name}: {why}"));
    }
    let own = version();
    if differ > 0 {
        if inputs.written_by != own {
            let by = inputs.written_by;
            files::eprint(&format!(
                "mavc: the folder was written by mavc {by}; this is mavc {own}, which may differ\n"
            ));
        }
        return Ok(REJECTED);
    }
    let tables = match inputs.tables.len() {
        0 => String::new(),
        count => format!("{count} files in {TABLES} are as they were written\n"),
    };
    files::print(&fitted(&format!(
        "{} files follow from the spec, {REPORT} and {CERTIFICATE}\n{tables}{REPORT} itself is not proved: run `mavc \
         safety` again without `--report` to repeat the search\n",
        derived.len()
    )))?;
    Ok(FINE)
}
