//! The machine-readable outputs against their schemas in docs/schema, which are written from the types of the records
//! (`src/core/base/schemas.rs`).

use boon::{Compiler, SchemaIndex, Schemas};
use serde_json::{Value, json};
use std::io::Write;
use std::process::{Command, Stdio};

/// Runs `mavc` in the repository's root and gives what it prints.
fn printed(args: &[&str], input: &str) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_mavc"))
        .args(args)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    // A command that never reads its input closes the pipe: no matter.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap()
}

fn json_of(args: &[&str], input: &str) -> Value {
    let text = printed(args, input);
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{args:?}: {e}\n{text}"))
}

/// The report of a `plan` or `compare` run.
fn report_of(command: &str, arguments: &[&str], input: &str) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.json");
    let mut args = vec![command, "-", "--quiet", "--report", path.to_str().unwrap()];
    args.extend(arguments);
    printed(&args, input);
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// A schema of docs/schema, itself checked against draft 2020-12.
pub struct Schema {
    all: Schemas,
    this: SchemaIndex,
}

pub fn schema(name: &str) -> Schema {
    let path = format!("{}/docs/schema/{name}.schema.json", env!("CARGO_MANIFEST_DIR"));
    let schema: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema", "{name}");
    let (mut all, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.add_resource(&path, schema).unwrap();
    let this = compiler.compile(&path, &mut all).unwrap_or_else(|e| panic!("{name} is no schema: {e:#}"));
    Schema { all, this }
}

impl Schema {
    pub fn is_valid(&self, record: &Value) -> bool {
        self.all.validate(record, self.this).is_ok()
    }

    /// Fails with all that the schema has against the record.
    pub fn assert_valid(&self, record: &Value) {
        if let Err(errors) = self.all.validate(record, self.this) {
            panic!("{errors:#}");
        }
    }
}

/// Every member of every object is needed, and none may be added.
pub fn assert_strict(schema: &Schema, record: &Value, optional: &[&str]) {
    for pointer in objects(record, String::new()) {
        let members: Vec<String> = record.pointer(&pointer).unwrap().as_object().unwrap().keys().cloned().collect();
        let mut more = record.clone();
        more.pointer_mut(&pointer).unwrap()["surplus"] = json!(1);
        assert!(!schema.is_valid(&more), "{pointer} may have any member");
        for member in members.iter().filter(|m| !optional.contains(&m.as_str())) {
            let mut less = record.clone();
            less.pointer_mut(&pointer).unwrap().as_object_mut().unwrap().remove(member);
            assert!(!schema.is_valid(&less), "{pointer} may lack {member}");
        }
    }
}

/// Pointers to the objects in a value, the first of each array only.
fn objects(value: &Value, at: String) -> Vec<String> {
    match value {
        Value::Object(members) => {
            let inner = members.iter().flat_map(|(k, v)| objects(v, format!("{at}/{k}")));
            std::iter::once(at.clone()).chain(inner).collect()
        }
        Value::Array(items) => items.first().map(|v| objects(v, format!("{at}/0"))).unwrap_or_default(),
        _ => Vec::new(),
    }
}

const QUAD: &str = r#"
vehicle quad {
    layout  = "PNPN"
    arm     = 0.211 m
    mass    = 1.32 kg
    inertia = [0.0128, 0.0128, 0.0239] kg*m^2
    rotor { thrust_coefficient = 9.9865e-6 N*s^2/rad^2; drag_coefficient = 1.5978e-7 N*m*s^2/rad^2; max_speed = 840 rad/s }
}
"#;

/// A quadcopter that hops against a weak rotor.
fn hop(against: &str) -> String {
    format!(
        "{QUAD}
faults {{
    every 1 rotor lost as M
    mode weak {{ rotor 1 reduced to 90 % }}
}}
mission hop {{
    start at [0, 0, 1] m
    waypoint at [1, 0, 1.5] m
}}
plan {{
    model = hover; planner = rsp
    against = [{against}]
    time    = 4 s
    samples = 20
}}
"
    )
}

#[test]
fn analyses_are_as_their_schema_says() {
    let schema = schema("analyze");
    for spec in
        ["vehicles/quad_pnpn", "vehicles/hexa_ppnnpn", "vehicles/coaxial_x8", "paper/case2", "missions/inspection"]
    {
        let record = json_of(&["analyze", &format!("specs/{spec}.mav"), "--format", "json"], "");
        schema.assert_valid(&record);
    }
    // Flat sets, a stuck rotor, and verdicts that flip.
    let spec = format!("{QUAD}faults {{\n    every 1 rotor lost as M\n    mode held {{ rotor 2 stuck at 40 % }}\n}}\n");
    let record = json_of(&["analyze", "-", "--format", "json", "--sweep", "mass=1..2.8kg"], &spec);
    schema.assert_valid(&record);
    assert_eq!(record["modes"][1]["facets"], Value::Null);
    assert_eq!(record["modes"][5]["stuck"][1], json!(0.4));
    assert!(!record["flips"].as_array().unwrap().is_empty());
    assert_strict(&schema, &record, &["flips"]);
    let spec = format!("{QUAD}faults {{ mode M {{ rotor 1 lost }} }}\n")
        .replace("rotor {", "yaw_drag = 2.75e-3 N*m*s/rad; rotor {");
    let record = json_of(&["analyze", "-", "--format", "json", "--capture"], &spec);
    schema.assert_valid(&record);
    assert_eq!(record["captures"].as_array().unwrap().len(), 24);
    assert_strict(&schema, &record, &["captures"]);
}

#[test]
fn reports_are_as_their_schema_says() {
    let schema = schema("report");
    let solved = report_of("compare", &[], &hop("weak"));
    schema.assert_valid(&solved);
    assert!(solved["planners"].as_array().unwrap().iter().all(|p| p["verdict"] == "found"));
    assert_strict(&schema, &solved, &[]);

    // A mode that cannot hover with a reserve, and a time too short.
    let too_short = report_of("plan", &["--set", "plan.time=0.2s"], &hop("weak"));
    schema.assert_valid(&too_short);
    assert_eq!(too_short["planners"][0]["verdict"], "proved infeasible");
    assert_eq!(too_short["conflict"]["verdict"], "proved infeasible");
    let fixes = too_short["conflict"]["fixes"].as_array().unwrap();
    assert!(fixes.iter().any(|f| f["kind"] == "time" && f["value"].as_f64() > Some(0.2)), "{too_short:#}");
    assert_strict(&schema, &too_short, &[]);
}

#[test]
fn flights_are_as_their_schema_says() {
    let schema = schema("simulate");
    let flown = |block: &str| {
        let spec = hop("weak").replace("mode weak", "mode three { rotors [1, 2, 3] lost }\n    mode weak") + block;
        let record = json_of(&["simulate", "-", "--quiet", "--report", "-"], &spec);
        schema.assert_valid(&record);
        record
    };
    let healthy = flown("");
    assert_eq!(healthy["outcome"], json!({"status": "flown"}));
    assert_strict(&schema, &healthy, &[]);
    let struck = flown("simulate { detection = never; seed = 3; fault weak at 1 s until 2 s; fault three at 3 s }\n");
    assert_eq!(struck["outcome"]["status"], "lost");
    assert_eq!(struck["faults"].as_array().unwrap().len(), 2);
    assert_strict(&schema, &struck, &["worst_miss"]);
    let landed = flown("simulate { detection = 20 ms; after_fault = land; ground = 0.1 m; fault weak at 2 s }\n");
    assert_eq!(landed["outcome"]["status"], "landed", "{landed:#}");
    assert_eq!(landed["detection_delay_s"], 0.02);
    assert_strict(&schema, &landed, &[]);
}

#[test]
fn problems_are_as_their_schema_says() {
    let schema = schema("check");
    let spec = hop("M9").replace("1.32 kg", "1.32 s").replace("at [1, 0, 1.5] m", "at [1, 0, 1.5]");
    let lines = printed(&["check", "-", "--format", "json"], &spec);
    let records: Vec<Value> = lines.lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    assert!(records.len() >= 3, "{lines}");
    for record in &records {
        schema.assert_valid(record);
    }
    let labelled = records.iter().find(|r| !r["labels"].as_array().unwrap().is_empty());
    assert_strict(&schema, labelled.expect("some problem has a label"), &[]);
}

/// The last line of a check without errors has the outcomes of `mavc analyze`, under the same names.
#[test]
fn outcomes_are_as_their_schema_says() {
    let spec = hop("weak");
    let lines = printed(&["check", "-", "--format", "json"], &spec);
    let (diagnostics, last) = lines.trim_end().rsplit_once('\n').expect("warnings and a last line");
    for line in diagnostics.lines() {
        schema("check").assert_valid(&serde_json::from_str(line).unwrap());
    }
    let checked: Value = serde_json::from_str(last).unwrap();
    assert_strict(&schema("outcomes"), &checked, &[]);
    let analyzed: Value = serde_json::from_str(&printed(&["analyze", "-", "--format", "json"], &spec)).unwrap();
    assert_eq!([&checked["headline"], &checked["vehicle"]], [&analyzed["headline"], &analyzed["vehicle"]]);
    let of = |record: &Value| -> Vec<(Value, Value)> {
        record["modes"].as_array().unwrap().iter().map(|mode| (mode["name"].clone(), mode["outcome"].clone())).collect()
    };
    assert!(of(&checked).len() > 2);
    assert_eq!(of(&checked), of(&analyzed));
}

#[test]
fn certificates_are_as_their_schema_says() {
    let schema = schema("certificate");
    let certificate_of = |spec: &str, time: &str| -> Value {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cert.json");
        printed(&["plan", "-", "--quiet", "--certificate", path.to_str().unwrap(), "--set", time], spec);
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
    };
    let limits = "limits { speed <= 3 m/s; tilt <= 30 deg; altitude in 0 m .. 2 m; jerk <= 30 m/s^3 }\n}\nplan {";
    let spec = hop("weak").replace("}\nplan {", limits);
    for (time, claim) in [("plan.time=4s", "plan"), ("plan.time=1.08s", "infeasible"), ("plan.time=0.5s", "too_early")]
    {
        let certificate = certificate_of(&spec, time);
        schema.assert_valid(&certificate);
        assert!(certificate["claim"][claim].is_object(), "{certificate:#}");
        assert_strict(&schema, &certificate, &["selected_by", "least_time_s"]);
    }
    // Turning yaw: bounds between nodes that differ from those at the nodes.
    let turning = spec.replace("at [1, 0, 1.5] m", "at [1, 0, 1.5] m yaw 90 deg");
    schema.assert_valid(&certificate_of(&turning, "plan.time=6s"));
}

#[test]
fn models_are_valid_and_exact() {
    let schema = schema("model");
    let flown = "simulate { detection = 50 ms; after_fault = land; fault weak at 1 s until 2 s }\n";
    let yaw_drag = ["--set", "vehicle.yaw_drag=2.75e-3N*m*s/rad"];
    let record =
        json_of(&[&["emit", "model", "-", "--format", "json"], &yaw_drag[..]].concat(), &(hop("weak") + flown));
    schema.assert_valid(&record);
    assert_strict(&schema, &record, &["yaw_drag"]);
    let rotor = &record["vehicle"]["rotors"][0];
    assert_eq!(rotor["thrust_coefficient_n_s2_per_rad2"], json!(9.9865e-6));
    assert_eq!((&rotor["spin"], &rotor["time_constant_s"]), (&json!("P"), &json!(0.02)));
    assert_eq!(record["vehicle"]["yaw_drag"]["linear_n_m_s_per_rad"], json!(2.75e-3));
    assert_eq!(
        (&record["simulate"]["detection_s"], &record["simulate"]["after_fault"]),
        (&json!(0.05), &json!("land"))
    );
    assert_eq!(record["simulate"]["faults"], json!([{"mode": "weak", "at_s": 1.0, "until_s": 2.0}]));
    let weak = record["modes"].as_array().unwrap().iter().find(|mode| mode["name"] == "weak").unwrap();
    assert_eq!(weak["capacity"], json!([0.9, 1.0, 1.0, 1.0]));
    // Motors have the autopilot's numbers where the spec gives them, and no member where not.
    assert!(rotor.get("motor").is_none());
    let numbered = "vehicle v { mass = 1 kg; inertia = [0.01, 0.01, 0.02] kg*m^2
        rotor { max_thrust = 7 N; torque_per_thrust = 16 mm; max_speed = 830 rad/s }
        rotors {
            rotor at [0.1, -0.1, 0] m  spin P  motor 3
            rotor at [-0.1, 0.1, 0] m  spin P  motor 1
            rotor at [0.1, 0.1, 0] m  spin N  motor 4
            rotor at [-0.1, -0.1, 0] m  spin N  motor 2
        } }\n";
    let record = json_of(&["emit", "model", "-", "--format", "json"], numbered);
    schema.assert_valid(&record);
    let rotors = record["vehicle"]["rotors"].as_array().unwrap();
    assert_eq!(
        rotors.iter().map(|rotor| &rotor["motor"]).collect::<Vec<_>>(),
        [&json!(3), &json!(1), &json!(4), &json!(2)]
    );
    // A coefficient that follows from a thrust has all its digits.
    let spec = "vehicle v { layout = \"PNPN\"; arm = 0.2 m; mass = 1 kg; inertia = [0.01, 0.01, 0.02] kg*m^2
        rotor { max_thrust = 7 N; torque_per_thrust = 16 mm; max_speed = 830 rad/s } }\n";
    let record = json_of(&["emit", "model", "-", "--format", "json"], spec);
    schema.assert_valid(&record);
    assert_eq!(record["vehicle"]["rotors"][3]["thrust_coefficient_n_s2_per_rad2"], json!(7.0 / (830.0 * 830.0)));
}

#[test]
fn exported_programs_are_as_their_schema_says() {
    let schema = schema("qp");
    let record = json_of(&["emit", "qp", "-", "--format", "json"], &hop("weak"));
    schema.assert_valid(&record);
    assert_strict(&schema, &record, &[]);
    let size = |m: &str, of: &str| record[m][of].as_u64().unwrap() as usize;
    let length = |m: &str| record[m].as_array().unwrap().len();
    assert_eq!((size("A", "rows"), size("A", "cols")), (length("b"), length("q")));
    assert_eq!((size("P", "rows"), length("row_origin")), (length("q"), length("b")));
    let rows: u64 = record["cones"].as_array().unwrap().iter().map(|c| c["rows"].as_u64().unwrap()).sum();
    assert_eq!(rows as usize, length("b"));
}
