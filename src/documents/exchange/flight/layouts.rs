//! Layouts of PlotJuggler and Foxglove that show a log as it is written here.

use serde_json::{Map, Value, json};
use std::fmt::Write;

/// Colours of curves, in their order.
const COLOURS: [&str; 8] = ["#1f77b4", "#d62728", "#1ac938", "#ff7f0e", "#f14cc1", "#9467bd", "#17becf", "#bcbd22"];

/// The plots: a title, with the topic and the field of each curve in ULog and the path of each in MCAP.
fn plots(rotors: usize) -> Vec<(&'static str, Vec<String>, Vec<String>)> {
    let of = |topic: &str, fields: &[&str]| fields.iter().map(|field| format!("{topic}/{field}")).collect();
    let paths = |paths: &[&str]| paths.iter().map(|path| format!("/flight.{path}")).collect();
    let rotor = |name: &str| (1..=rotors).map(|k| format!("mavc_rotors/{name}_{k}")).collect();
    let each = |name: &str| (0..rotors).map(|k| format!("/flight.rotors[{k}].{name}")).collect();
    vec![
        (
            "position",
            of("vehicle_local_position", &["x", "y", "z"]),
            paths(&["position.x", "position.y", "position.z", "reference.x", "reference.y", "reference.z"]),
        ),
        ("errors", of("mavc_errors", &["position", "heading", "tilt"]), paths(&["error", "heading_error", "tilt"])),
        ("thrust", of("mavc_wrench", &["thrust", "thrust_cmd"]), paths(&["wrench.thrust", "demanded.thrust"])),
        (
            "torques",
            of("mavc_wrench", &["tau_x", "tau_y", "tau_z"]),
            paths(&["wrench.tau_x", "wrench.tau_y", "wrench.tau_z"]),
        ),
        ("rotor speeds", rotor("omega"), each("omega")),
        ("capacities", rotor("theta"), each("theta")),
    ]
}

/// A tab with one plot below the other for each pair.
pub(super) fn plotjuggler(rotors: usize) -> String {
    let mut out = String::from(
        "<?xml version='1.0' encoding='UTF-8'?>\n<root>\n <tabbed_widget parent=\"main_window\" name=\"Main \
         Window\">\n",
    );
    for pair in plots(rotors).chunks(2) {
        let title: Vec<&str> = pair.iter().map(|(title, ..)| *title).collect();
        let _ = writeln!(out, "  <Tab tab_name=\"{}\" containers=\"1\">\n   <Container>", title.join(", "));
        out.push_str("    <DockSplitter orientation=\"-\" sizes=\"0.5;0.5\" count=\"2\">\n");
        for (title, curves, _) in pair {
            let _ = writeln!(
                out,
                "     <DockArea name=\"{title}\">\n      <plot mode=\"TimeSeries\" style=\"Lines\" flip_x=\"false\" \
                 flip_y=\"false\">"
            );
            for (curve, colour) in curves.iter().zip(COLOURS.iter().cycle()) {
                let _ = writeln!(out, "       <curve name=\"{curve}\" color=\"{colour}\"/>");
            }
            out.push_str("      </plot>\n     </DockArea>\n");
        }
        out.push_str("    </DockSplitter>\n   </Container>\n  </Tab>\n");
    }
    out.push_str(
        "  <currentTabIndex index=\"0\"/>\n </tabbed_widget>\n <use_relative_time_offset enabled=\"1\"/>\n</root>\n",
    );
    out
}

/// The scene on the left, the plots on the right.
pub(super) fn foxglove(rotors: usize) -> String {
    let mut panels = Map::new();
    let scene = json!({
        "followTf": "world",
        "followMode": "follow-none",
        "topics": {"/path": {"visible": true, "type": "line"}},
        "transforms": {"frame:vehicle": {"visible": true}, "frame:reference": {"visible": true}},
        "layers": {"grid": {"layerId": "foxglove.Grid", "visible": true, "frameId": "world"}},
    });
    panels.insert("3D!scene".into(), scene);
    let mut right = Value::Null;
    for (k, (title, _, paths)) in plots(rotors).into_iter().enumerate().rev() {
        let name = format!("Plot!{}", title.replace(' ', "_"));
        let curves: Vec<Value> = paths
            .iter()
            .map(|path| json!({"value": path, "enabled": true, "timestampMethod": "receiveTime", "label": path}))
            .collect();
        panels.insert(
            name.clone(),
            json!({"title": title, "paths": curves, "xAxisVal": "timestamp", "showLegend": true, "isSynced": true}),
        );
        right = match right {
            Value::Null => json!(name),
            below => {
                let share = 100.0 / (6 - k) as f64;
                json!({"direction": "column", "first": name, "second": below, "splitPercentage": share})
            }
        };
    }
    let layout = json!({
        "configById": panels,
        "globalVariables": {},
        "userNodes": {},
        "playbackConfig": {"speed": 1},
        "layout": {"direction": "row", "first": "3D!scene", "second": right, "splitPercentage": 55},
    });
    serde_json::to_string_pretty(&layout).unwrap_or_default() + "\n"
}
