//! The JSON schemas in `docs/schema`, written from the types of the records. Only tests are compiled with this module, so
//! that no build of a user knows `schemars`; `mavc` includes the same file, because a crate under test sees only itself.

use schemars::Schema;
use schemars::generate::SchemaSettings;
use schemars::transform::transform_subschemas;
use serde_json::{Map, Value, json};
use std::path::Path;

/// Compares `docs/schema/NAME.schema.json` with the schema of a record, `generate`d under this title. With `MAVC_UPDATE=1`
/// it is written anew. Every member must have a description.
pub fn check<T: schemars::JsonSchema>(name: &str, title: &str) {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    let mut schema = settings.with_transform(plain).into_generator().into_root_schema_for::<T>();
    schema.insert("title".into(), title.into());
    let bare = undescribed(schema.as_value(), "");
    assert!(bare.is_empty(), "{name}: doc comments are missing for {bare:?}");

    let text = serde_json::to_string_pretty(&schema).unwrap() + "\n";
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = package.ancestors().map(|folder| folder.join("docs/schema")).find(|folder| folder.is_dir()).unwrap();
    let path = folder.join(format!("{name}.schema.json"));
    if std::env::var_os("MAVC_UPDATE").is_some() {
        std::fs::write(path, text).unwrap();
    } else {
        let is_current = std::fs::read_to_string(&path).is_ok_and(|there| there == text);
        assert!(is_current, "docs/schema/{name}.schema.json is stale: MAVC_UPDATE=1 cargo test --lib schema");
    }
}

/// Closes objects, joins the lines of a doc comment, makes a list of an enumeration's words, and drops the `format` of
/// numbers, which names a type of Rust.
fn plain(schema: &mut Schema) {
    transform_subschemas(&mut plain, schema);
    let Some(members) = schema.as_object_mut() else { return };
    members.shift_remove("format");
    if members.contains_key("properties") {
        members.insert("additionalProperties".into(), false.into());
    }
    if let Some(Value::String(text)) = members.get_mut("description") {
        *text = text.split("\n\n").map(|paragraph| paragraph.replace('\n', " ")).collect::<Vec<_>>().join("\n\n");
    }
    if let Some(words) = members.get("oneOf").and_then(Value::as_array).and_then(|all| words(all)) {
        let meanings = words.iter().filter_map(|(word, meaning)| Some(format!("{word}: {}", meaning.as_ref()?)));
        let own = members.get("description").and_then(Value::as_str).map(String::from);
        let description = own.into_iter().chain(meanings).collect::<Vec<_>>().join(" ");
        let words: Vec<&str> = words.iter().map(|(word, _)| word.as_str()).collect();
        *members = Map::from_iter([("enum".to_string(), json!(words)), ("description".into(), description.into())]);
    }
}

/// The words of an enumeration, each with its meaning; `None` if the alternatives are not all words.
fn words(alternatives: &[Value]) -> Option<Vec<(String, Option<String>)>> {
    let text = |value: Option<&Value>| value.and_then(Value::as_str).map(String::from);
    let mut all = Vec::new();
    for alternative in alternatives {
        let meaning = text(alternative.get("description"));
        match alternative.get("enum").and_then(Value::as_array) {
            Some(words) => all.extend(words.iter().map(|word| (text(Some(word)).unwrap_or_default(), None))),
            None => all.push((text(alternative.get("const"))?, meaning)),
        }
    }
    Some(all)
}

/// Pointers to members without a description: neither of their own nor of the type that they refer to.
fn undescribed(schema: &Value, at: &str) -> Vec<String> {
    let mut found = Vec::new();
    match schema {
        Value::Object(members) => {
            for (name, value) in members.get("properties").and_then(Value::as_object).into_iter().flatten() {
                let is_told = ["description", "$ref", "const"].iter().any(|key| value.get(key).is_some());
                // The only member of a variant has the variant's description.
                let is_variant = members.contains_key("description") && at.ends_with("oneOf");
                found.extend((!is_told && !is_variant).then(|| format!("{at}/{name}")));
            }
            found.extend(members.iter().flat_map(|(name, value)| undescribed(value, &format!("{at}/{name}"))));
        }
        Value::Array(all) => found.extend(all.iter().flat_map(|value| undescribed(value, at))),
        _ => {}
    }
    found
}
