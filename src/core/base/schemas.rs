//! The JSON schemas in `docs/schema`, written from the types of the records. Only tests are compiled with this module,
//! so no build of a user needs `schemars`. `mavc` includes the same file, because `cfg(test)` holds for one crate only.

use schemars::Schema;
use schemars::generate::SchemaSettings;
use schemars::transform::transform_subschemas;
use serde_json::{Map, Value, json};
use std::path::Path;

/// Compares `docs/schema/NAME.schema.json` with the schema of a record. With `MAVC_UPDATE=1` the file is written anew.
/// Every member must have a description.
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

/// Closes objects, whose omitted members are never null; joins the lines of a doc comment and drops its links; makes
/// one list of an enumeration's words; drops the `format` of numbers, which names a type of Rust.
fn plain(schema: &mut Schema) {
    transform_subschemas(&mut plain, schema);
    let Some(members) = schema.as_object_mut() else { return };
    members.shift_remove("format");
    if members.contains_key("properties") {
        members.insert("additionalProperties".into(), false.into());
        let required = members.get("required").and_then(Value::as_array).cloned().unwrap_or_default();
        let all = members["properties"].as_object_mut().into_iter().flatten();
        all.filter(|(name, _)| !required.contains(&json!(name))).for_each(|(_, member)| never_null(member));
    }
    if let Some(Value::String(text)) = members.get_mut("description") {
        let paragraphs = text.split("\n\n").map(|paragraph| paragraph.replace('\n', " "));
        *text = paragraphs.collect::<Vec<_>>().join("\n\n").replace("[`", "`").replace("`]", "`");
    }
    if let Some(words) = members.get("oneOf").and_then(Value::as_array).and_then(|all| words(all)) {
        let meanings = words.iter().filter_map(|(word, meaning)| Some(format!("{word}: {}", meaning.as_ref()?)));
        let own = members.get("description").and_then(Value::as_str).map(String::from);
        let description = own.into_iter().chain(meanings).collect::<Vec<_>>().join(" ");
        let words: Vec<&str> = words.iter().map(|(word, _)| word.as_str()).collect();
        *members = Map::from_iter([("enum".to_string(), json!(words)), ("description".into(), description.into())]);
    }
}

/// A member that is omitted where there is no value is never null.
fn never_null(member: &mut Value) {
    if let Some(types) = member.get_mut("type").filter(|types| types.is_array()) {
        let value = types.as_array().and_then(|all| all.iter().find(|one| *one != "null")).cloned();
        *types = value.unwrap_or_default();
    }
    let Some(members) = member.as_object_mut() else { return };
    if let Some(Value::Array(alternatives)) = members.shift_remove("anyOf") {
        let value = alternatives.into_iter().find(|one| *one != json!({"type": "null"}));
        members.extend(value.and_then(|value| value.as_object().cloned()).into_iter().flatten());
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
            let inner = members.get("properties").and_then(Value::as_object);
            // The only member of a variant has the variant's description.
            let untagged = |inner: &Map<String, Value>| inner.values().filter(|v| v.get("const").is_none()).count();
            let is_variant = members.contains_key("description") && inner.is_some_and(|inner| untagged(inner) == 1);
            for (name, value) in inner.into_iter().flatten().filter(|_| !is_variant) {
                let is_told = ["description", "$ref", "const"].iter().any(|key| value.get(key).is_some());
                found.extend((!is_told).then(|| format!("{at}/{name}")));
            }
            found.extend(members.iter().flat_map(|(name, value)| undescribed(value, &format!("{at}/{name}"))));
        }
        Value::Array(all) => found.extend(all.iter().flat_map(|value| undescribed(value, at))),
        _ => {}
    }
    found
}
