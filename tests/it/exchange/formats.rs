//! The text and bytes of each format, read back by the simplest means.

use super::{Planned, TURN, close, pick, planned, table, turn};
use mavc::exchange::frames::{Frame, wrapped};
use mavc::exchange::trajectory::{Choices, FORMATS, Format, bag_metadata, write};
use mavc::motion::{NodeState, Trajectory, X, Y, YAW, Z};
use mavc::report::trajectory_csv;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

fn order(state: &NodeState, order: usize) -> [f64; 3] {
    [X, Y, Z].map(|axis| state[axis][order])
}

#[test]
fn csv_is_the_table_in_either_frame() {
    let planned = turn();
    let plain = trajectory_csv::table(&planned.trajectory, planned.model(), Some(20.0)).unwrap();
    let at = |frame| {
        let choices = Choices { frame, rate: Some(20.0), ..Choices::default() };
        String::from_utf8(planned.write(&choices).bytes).unwrap()
    };
    assert!(at(None) == plain && at(Some(Frame::EnuFlu)) == plain);
    let turned = at(Some(Frame::NedFrd));
    let ((names, enu), (same, ned)) = (table(&plain), table(&turned));
    assert!(names == same && enu.len() == ned.len() && enu.len() == 121);
    for (enu, ned) in enu.iter().zip(&ned) {
        for letter in ["", "v", "a", "j", "s"] {
            let axes = ["x", "y", "z"].map(|axis| format!("{letter}{axis}"));
            let wanted = axes.each_ref().map(String::as_str);
            assert_eq!(Frame::NedFrd.world(pick(&names, enu, wanted)), pick(&names, ned, wanted));
        }
        let torque = ["tau_x", "tau_y", "tau_z"];
        assert_eq!(Frame::NedFrd.body(pick(&names, enu, torque)), pick(&names, ned, torque));
        let [roll, pitch, yaw, rate] = pick(&names, enu, ["roll", "pitch", "yaw", "yaw_rate"]);
        let angles = [roll, -pitch, std::f64::consts::FRAC_PI_2 - yaw, -rate];
        assert_eq!(pick(&names, ned, ["roll", "pitch", "yaw", "yaw_rate"]), angles);
        assert_eq!(
            pick(&names, enu, ["t", "thrust", "omega_1", "waypoint"]),
            pick(&names, ned, ["t", "thrust", "omega_1", "waypoint"])
        );
    }
}

#[test]
fn rows_obey_the_equations_of_motion() {
    rows_obey(turn());
}

/// A drag for each axis of the body, and the linear model, whose jerk jumps.
#[test]
fn rows_obey_them_in_other_air_and_models() {
    rows_obey(&planned(&TURN.replace("drag    = 0.1 N*s/m", "drag = [0.2, 0.05, 0.1] N*s/m")));
    let linear = TURN.replace("    air { wind = [1, -2, 0] m/s }\n", "").replace("    drag    = 0.1 N*s/m\n", "");
    rows_obey(&planned(&linear.replace("planner = rip;", "planner = rip; model = hover;")));
}

/// Thrust and drag give the acceleration, and the rates turn the attitude.
fn rows_obey(planned: &Planned) {
    let choices = Choices { format: Format::Rows, rate: Some(1000.0), ..Choices::default() };
    let text = String::from_utf8(planned.write(&choices).bytes).unwrap();
    let (names, rows) = table(&text);
    let [q, p] = [["qw", "qx", "qy", "qz"], ["p", "q", "r", "yawspeed"]];
    let attitude = |row: &[f64]| {
        let [w, x, y, z] = pick(&names, row, q);
        UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
    };
    let most: f64 = 4.0 * 3.1;
    for k in (1..rows.len() - 1).step_by(97) {
        let row = &rows[k];
        let state = planned.trajectory.at(row[0]);
        close(&pick(&names, row, ["vx", "vy", "vz"]), &order(&state, 1), 1e-12, "velocity");
        close(&pick(&names, row, ["jx", "jy", "jz"]), &order(&state, 3), 1e-12, "jerk");
        // m (a + g e_z) + R D R^T (v - wind) = T b_3
        let air = Vector3::from(order(&state, 1)) - Vector3::from(planned.model().environment().wind);
        let drag =
            attitude(row) * (attitude(row).inverse() * air).component_mul(&Vector3::from(planned.model().vehicle.drag));
        let force = (Vector3::from(order(&state, 2)) + Vector3::z() * 9.81) * 0.5 + drag;
        let [thrust, share] = pick(&names, row, ["thrust", "thrust_share"]);
        close((attitude(row) * Vector3::z() * thrust).as_slice(), force.as_slice(), 1e-9, "thrust");
        close(&[share], &[thrust / most], 1e-9, "share");
        // The nose is in the vertical plane of the yaw.
        let nose = attitude(row) * Vector3::x();
        close(&[wrapped(nose.y.atan2(nose.x) - state[YAW][0])], &[0.0], 1e-9, "yaw");
        // Central differences; at nodes the yaw's third derivative jumps, which is of second order.
        let [before, after] = [&rows[k - 1], &rows[k + 1]].map(|row| attitude(row));
        let step = after[0] - before[0];
        assert!(step.is_finite());
        let turned = (before.inverse() * after).scaled_axis() / (rows[k + 1][0] - rows[k - 1][0]);
        close(&pick(&names, row, p)[..3], turned.as_slice(), 2e-5, "rates");
        assert_eq!(pick(&names, row, p)[3], state[YAW][1]);
    }
    let marks: Vec<f64> = rows.iter().map(|row| row[names.len() - 1]).filter(|mark| !mark.is_nan()).collect();
    assert_eq!(marks, [1.0, 2.0, 3.0]);
    assert!(text.lines().nth(2).unwrap().ends_with(','), "an empty cell");
}

#[test]
fn px4_has_float32_in_north_east_down() {
    let planned = turn();
    let text = planned.text(Format::Px4);
    let (names, rows) = table(&text);
    assert_eq!((names[0], names[1], names[14], rows.len()), ("timestamp", "position[0]", "yawspeed", 301));
    for (k, row) in rows.iter().enumerate() {
        assert_eq!(row[0], 20_000.0 * k as f64);
        let state = planned.trajectory.at(k as f64 / 50.0);
        let vectors = [0, 1, 2, 3].map(|i| Frame::NedFrd.world(order(&state, i))).concat();
        let heading = [wrapped(std::f64::consts::FRAC_PI_2 - state[YAW][0]), -state[YAW][1]];
        for (cell, exact) in row[1..].iter().zip(vectors.iter().chain(&heading)) {
            assert_eq!(*cell as f32, *exact as f32);
        }
    }
    // The same text as of float32, not of double.
    let cells = text.lines().skip(1).flat_map(|line| line.split(',').skip(1));
    assert!(cells.into_iter().all(|cell| cell.len() <= 16 && cell.parse::<f32>().is_ok()));
}

/// The numbers of a list in a script: what is between the brackets or parentheses of each line.
fn numbers(text: &str, start: &str) -> Vec<Vec<f64>> {
    let after = text.split_once(start).unwrap_or_else(|| panic!("{start}")).1;
    let lines = after.lines().skip(1).take_while(|line| *line != "]");
    let separators = |c: char| "[](), ".contains(c);
    lines
        .map(|line| line.split(separators).filter(|cell| !cell.is_empty()).map(|c| c.parse().unwrap()).collect())
        .collect()
}

#[test]
fn scripts_carry_the_plan() {
    let planned = turn();
    for format in [Format::Px4Offboard, Format::ArdupilotGuided] {
        let text = planned.text(format);
        let rows = numbers(&text, "SETPOINTS = [");
        assert_eq!((rows.len(), rows[0].len()), (301, 12));
        let state = planned.trajectory.at(rows[123][0]);
        let exact = [0, 1, 2].map(|i| Frame::NedFrd.world(order(&state, i))).concat();
        close(&rows[123][1..10], &exact, 1e-6, format.name());
    }
    let pieces = numbers(&planned.text(Format::Rotorpy), "PIECES = [");
    assert_eq!((pieces.len(), pieces[0].len()), (planned.trajectory.intervals(), 24));
    let gym = planned.text(Format::GymPybulletDrones);
    let rows = numbers(&gym, "ROWS = [");
    assert!(rows.len() == 289 && gym.contains("CONTROL_FREQ_HZ = 48\n"));
    let state = planned.trajectory.at(100.0 / 48.0);
    close(&rows[100][..3], &order(&state, 0), 1e-12, "position");
    close(&rows[100][5..9], &[&[state[YAW][0]][..], &order(&state, 1)].concat(), 1e-12, "yaw and velocity");
    for format in [Format::Px4Offboard, Format::ArdupilotGuided, Format::Rotorpy, Format::GymPybulletDrones] {
        let text = planned.text(format);
        assert!(!text.contains("# the plan") && !text.contains("A PLAN"), "{}", format.name());
        assert!(text.contains("turn with quad, 6 s. Written by mavc "), "{}", format.name());
    }
}

/// Pieces of RotorPy are the trajectory itself: value and slope by Taylor's formula.
#[test]
fn pieces_are_the_trajectory() {
    let planned = turn();
    let pieces = numbers(&planned.text(Format::Rotorpy), "PIECES = [");
    for (piece, times) in pieces.iter().zip(planned.trajectory.times.windows(2)) {
        let s = 0.4 * (times[1] - times[0]);
        let state = planned.trajectory.at(times[0] + s);
        for (axis, c) in piece.chunks(6).enumerate() {
            let value: f64 = (0..6).map(|i| c[i] * s.powi(i as i32)).sum();
            let slope: f64 = (1..6).map(|i| i as f64 * c[i] * s.powi(i as i32 - 1)).sum();
            close(&[value, slope], &state[axis][..2], 1e-8, "RotorPy");
        }
    }
}

#[test]
fn a_bag_is_one_message_in_mcap() {
    let planned = turn();
    let bytes = planned.written(Format::Rosbag2).bytes;
    let magic = b"\x89MCAP0\r\n";
    assert!(bytes.starts_with(magic) && bytes.ends_with(magic));
    let mut kinds = Vec::new();
    let mut at = 8;
    while at + 8 < bytes.len() {
        let length = u64::from_le_bytes(bytes[at + 1..at + 9].try_into().unwrap()) as usize;
        kinds.push((bytes[at], at + 9, length));
        at += 9 + length;
    }
    assert_eq!(at + 8, bytes.len(), "records end at the magic");
    // Header, schema, channel, chunk, its index, end of data, schema, channel, chunk index, statistics, footer.
    assert_eq!(kinds.iter().map(|(kind, ..)| *kind).collect::<Vec<_>>(), [1, 3, 4, 6, 7, 15, 3, 4, 8, 11, 2]);
    let float = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    // In the chunk, after times, size, check and an empty compression: one message, with 22 bytes before its data.
    let data = kinds[3].1 + 8 + 8 + 8 + 4 + 4 + 8 + 9 + 22;
    assert_eq!(bytes[data..data + 4], [0, 1, 0, 0]);
    // Head: stamp, "world", one joint "vehicle", then the points; 601 of them at 100 Hz.
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let body = data + 4;
    assert_eq!((word(body + 8), &bytes[body + 12..body + 18]), (6, &b"world\0"[..]));
    assert_eq!((word(body + 20), word(body + 24), &bytes[body + 28..body + 36]), (1, 8, &b"vehicle\0"[..]));
    assert_eq!((word(body + 36), word(body + 40)), (601, 1));
    let first = planned.trajectory.at(0.0);
    assert_eq!([float(body + 48), float(body + 56), float(body + 64)], order(&first, 0));
    let metadata = bag_metadata("bag_x_0.mcap");
    assert!(metadata.contains("storage_identifier: mcap") && metadata.contains("    - bag_x_0.mcap\n"));
}

/// A parabola: no thrust, so no attitude.
#[test]
fn an_attitude_that_is_not_defined_is_refused_with_its_time() {
    let planned = turn();
    let mut model = planned.model().clone();
    model.vehicle.drag = [0.0; 3];
    let mut start = NodeState::default();
    (start[X][1], start[Z][1], start[Z][2]) = (1.0, 2.0, -9.81);
    let mut end = start;
    (end[X][0], end[Z][0], end[Z][1]) = (1.0, 2.0 - 9.81 / 2.0, 2.0 - 9.81);
    let trajectory = Trajectory {
        times: vec![0.0, 1.0],
        nodes: vec![start, end],
        waypoint_nodes: vec![0, 1],
        model: planned.trajectory.model,
    };
    // Lines between places on the Earth have no attitude, and the mission has no place.
    let of_places = [Format::QgcPlan, Format::Wpl, Format::Kml, Format::GeoJson];
    for (format, name) in FORMATS.into_iter().filter(|(format, _)| !of_places.contains(format)) {
        let written = write(&trajectory, &model, &Choices { format, ..Choices::default() });
        let needs_attitude = !matches!(format, Format::Csv | Format::Crazyflie | Format::Rotorpy);
        assert_eq!(written.is_err(), needs_attitude, "{name}");
        if let Err(why) = written {
            assert!(why.starts_with("the attitude is not defined at 0 s"), "{why}");
        }
    }
}

#[test]
fn every_format_is_in_the_document() {
    let text = std::fs::read_to_string("docs/exchange.md").unwrap();
    // Some names are links to the page of their tool.
    let has_row = |name: &str| text.contains(&format!("| `{name}` |")) || text.contains(&format!("| [`{name}`]("));
    for (_, name) in FORMATS {
        assert!(has_row(name), "{name}");
    }
    for (_, name) in mavc::exchange::flight::FORMATS {
        assert!(has_row(name), "{name}");
    }
}
