//! Figures in parameters of autopilots: read where somebody measured or set them, and open where they are defaults.

use crate::cli::{mavc_with, out};
use mavc::import::Imported;
use mavc::import::vehicle::import;
use mavc::{Spec, compile};

fn file(name: &str) -> Imported {
    import(name, &std::fs::read(format!("tests/specs/findings/files/{name}")).unwrap())
}

/// The lines of the parameters of a quadcopter for PX4, with more of them.
fn px4(more: &[(&str, f64)]) -> Imported {
    let mut text = "1\t1\tCA_AIRFRAME\t0\t6\n1\t1\tCA_ROTOR_COUNT\t4\t6\n".to_string();
    for (i, (x, y, km)) in
        [(0.2, 0.2, 0.021), (-0.2, -0.2, 0.021), (0.2, -0.2, -0.021), (-0.2, 0.2, -0.021)].iter().enumerate()
    {
        text += &format!("1\t1\tCA_ROTOR{i}_PX\t{x}\t9\n1\t1\tCA_ROTOR{i}_PY\t{y}\t9\n1\t1\tCA_ROTOR{i}_KM\t{km}\t9\n");
    }
    text.extend(more.iter().map(|(name, value)| format!("1\t1\t{name}\t{value}\t9\n")));
    import("quad.params", text.as_bytes())
}

fn ardupilot(more: &str) -> Imported {
    import("quad.param", format!("FRAME_CLASS,1\nFRAME_TYPE,1\n{more}").as_bytes())
}

/// The spec with these figures in place of each `?`, by the name before it.
fn filled(imported: &Imported, figures: &[(&str, &str)]) -> Spec {
    let text = filled_text(imported, figures);
    compile(&text).into_result().unwrap_or_else(|e| panic!("{e}\n{text}"))
}

fn filled_text(imported: &Imported, figures: &[(&str, &str)]) -> String {
    let text = imported.text.as_deref().unwrap_or_else(|| panic!("{:?}", imported.diagnostics));
    let line = |line: &str| {
        let name = line.trim_start().split(['=', ' ']).find(|word| !matches!(*word, "" | "let")).unwrap_or_default();
        let figure = figures.iter().find(|(of, _)| *of == name).map_or("?", |(_, figure)| figure);
        line.replacen('?', figure, 1) + "\n"
    };
    text.lines().map(line).collect()
}

fn warns(imported: &Imported, words: &str) -> bool {
    imported.diagnostics.iter().any(|d| d.code == "mavc::import::assumed" && d.message.contains(words))
}

const REST: [(&str, &str); 5] = [
    ("arm", "0.3 m"),
    ("inertia", "[0.03, 0.03, 0.05] kg*m^2"),
    ("torque_per_thrust", "16 mm"),
    ("max_speed", "700 rad/s"),
    ("hover_power", "200 W"),
];

/// `CA_ROTORi_CT` 6.5 and `CA_ROTORi_KM` 0.05 of all motors are what PX4 has where nobody wrote anything.
#[test]
fn defaults_are_not_measurements() {
    let imported = file("px4_defaults.params");
    let text = imported.text.clone().unwrap();
    assert!(text.contains("torque_per_thrust = ?") && text.contains("max_speed         = ?"), "{text}");
    assert!(!text.contains("6.5 N") && !text.contains("0.05 m"), "{text}");
    assert!(warns(&imported, "`CT` of every motor is PX4's default, 6.5 N"));
    assert!(warns(&imported, "`KM` of every motor is PX4's default, 0.05 m"));
    // The signs of the torques are somebody's.
    assert_eq!((text.matches("spin P").count(), text.matches("spin N").count()), (3, 3));
    // One motor with another value: these were set.
    let all = |km: &str| {
        std::fs::read_to_string("tests/specs/findings/files/px4_defaults.params").unwrap().replacen(
            "0.050000000745058060",
            km,
            1,
        )
    };
    let measured = import("hexa.params", all("0.040000000745058060").as_bytes()).text.unwrap();
    assert!(
        measured.contains("torque_per_thrust 0.05 m") && measured.contains("torque_per_thrust 0.04 m"),
        "{measured}"
    );
}

/// The share of full thrust in hover gives full thrust for every mass: m g over n times the share.
#[test]
fn thrust_follows_from_the_mass_and_the_thrust_of_hover() {
    let imported = file("px4_defaults.params");
    assert!(warns(&imported, "full thrust is computed from the mass"));
    for mass in [2.9, 1.7] {
        let figure = format!("{mass} kg");
        let spec = filled(&imported, &[&REST[..], &[("mass", figure.as_str())]].concat());
        let vehicle = &spec.model().vehicle;
        assert_eq!(vehicle.mass, mass);
        let due = mass * 9.80665 / (6.0 * 0.25);
        assert!(vehicle.rotors.iter().all(|rotor| (rotor.max_thrust() / due - 1.0).abs() < 1e-12), "{due}");
    }
    let learned = ardupilot("MOT_THST_HOVER,0.21\nMOT_HOVER_LEARN,2\n");
    assert!(warns(&learned, "full thrust is computed from the mass"));
    assert_eq!(learned.dropped, ["MOT_HOVER_LEARN"]);
    let spec = filled(&learned, &[&REST[..], &[("mass", "1.5 kg")]].concat());
    let due = 1.5 * 9.80665 / (4.0 * f64::from(0.21_f32));
    // The spec has the share as the autopilot's single precision shows it, 0.21.
    assert!((spec.model().vehicle.rotors[0].max_thrust() / due - 1.0).abs() < 1e-6);
    // Defaults of PX4 and ArduPilot, and a thrust that is known.
    for (imported, name) in
        [(px4(&[("MPC_THR_HOVER", 0.5)]), "MPC_THR_HOVER"), (ardupilot("MOT_THST_HOVER,0.35\n"), "MOT_THST_HOVER")]
    {
        assert!(imported.text.unwrap().contains("max_thrust        = ?") && imported.dropped == [name]);
    }
    let known = px4(&[
        ("MPC_THR_HOVER", 0.3),
        ("CA_ROTOR0_CT", 9.0),
        ("CA_ROTOR1_CT", 9.0),
        ("CA_ROTOR2_CT", 9.0),
        ("CA_ROTOR3_CT", 9.0),
    ]);
    assert!(known.text.unwrap().contains("max_thrust        = 9 N"));
}

/// Verdict and place of hover of every mode, as `mavc analyze` prints them.
fn verdicts(text: &str) -> Vec<String> {
    let ran = mavc_with(&["analyze", "-v", "-"], &format!("{text}faults {{ every 1 rotor lost as M }}\n"));
    let shown = out(&ran);
    // Other tables follow, with a row for each mode too.
    let rows = shown.lines().filter(|line| line.starts_with('M') || line.starts_with("healthy")).take(7);
    rows.map(|row| row.split_whitespace().skip(1).take_while(|word| word.parse::<f64>().is_err()).collect::<String>())
        .collect()
}

/// A hexacopter of 2.9 kg, whose motors give 1850 gf and 17.5 mm: with PX4's defaults every loss would count as
/// unstable.
#[test]
fn verdicts_do_not_follow_from_defaults() {
    let imported = file("px4_defaults.params");
    let own = [("mass", "2.9 kg"), ("inertia", "[0.085, 0.085, 0.16] kg*m^2"), ("torque_per_thrust", "17.5 mm")];
    let figures = [&own[..], &[("max_speed", "6100 rpm"), ("hover_power", "330 W")]].concat();
    let text = filled_text(&imported, &figures);
    let from = text.find("max_thrust").unwrap();
    let thrust = text[from..].lines().next().unwrap();
    let with = |line: &str| verdicts(&text.replace(thrust, line));
    let (read, measured) = (verdicts(&text), with("max_thrust = 1850 gf"));
    assert_eq!((read.len(), &read), (7, &measured), "{read:?}");
    let default = verdicts(&text.replace(thrust, "max_thrust = 6.5 N").replace("17.5 mm", "0.05 m"));
    assert!(default[1..].iter().all(|row| row.starts_with("lostunstable")), "{default:?}");
    assert!(read[1..].iter().all(|row| row.contains("heldcontrollable")), "{read:?}");
}

/// The vehicle model of PX4, unless all of it is the default.
#[test]
fn masses_and_inertias_are_read() {
    let imported = file("modelled.hil");
    assert_eq!(imported.dropped, Vec::<String>::new());
    let spec = filled(&imported, &[&REST[..], &[("max_thrust", "8 N")]].concat());
    let vehicle = &spec.model().vehicle;
    // The numbers as single precision shows them.
    assert_eq!((vehicle.mass, vehicle.inertia), (1.5, [0.03, 0.03, 0.05]));
    let model = |mass: f64, [x, y, z]: [f64; 3]| {
        px4(&[("VM_MASS", mass), ("VM_INERTIA_XX", x), ("VM_INERTIA_YY", y), ("VM_INERTIA_ZZ", z)]).text.unwrap()
    };
    let default = model(1.0, [0.01; 3]);
    assert!(default.contains("mass    = ?") && default.contains("inertia = ?"), "{default}");
    // A kilogram beside inertias that somebody measured.
    let kilogram = model(1.0, [0.011, 0.01, 0.02]);
    assert!(kilogram.contains("mass    = 1 kg") && kilogram.contains("[0.011, 0.01, 0.02] kg*m^2"), "{kilogram}");
}

/// The vehicle of PX4's simulator in hardware.
#[test]
fn simulated_vehicles_are_read() {
    let all = [
        ("SIH_MASS", 1.2),
        ("SIH_IXX", 0.02),
        ("SIH_IYY", 0.022),
        ("SIH_IZZ", 0.04),
        ("SIH_T_MAX", 6.0),
        ("SIH_Q_MAX", 0.12),
    ];
    let km: Vec<(String, f64)> =
        (0..4).map(|i| (format!("CA_ROTOR{i}_KM"), if i < 2 { 0.05 } else { -0.05 })).collect();
    let km: Vec<(&str, f64)> = km.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    let imported = px4(&[&all[..], &km].concat());
    assert_eq!(imported.dropped, Vec::<String>::new());
    let spec = filled(&imported, &REST);
    let vehicle = &spec.model().vehicle;
    assert_eq!((vehicle.mass, vehicle.inertia), (1.2, [0.02, 0.022, 0.04]));
    let rotor = &vehicle.rotors[0];
    assert!((rotor.max_thrust() - 6.0).abs() < 1e-12, "{}", rotor.max_thrust());
    assert!((rotor.drag_coefficient / rotor.thrust_coefficient - 0.02).abs() < 1e-9);
    // A vehicle of its own has the simulator's defaults in the same file.
    let defaults = [("SIH_MASS", 1.0), ("SIH_IXX", 0.025), ("SIH_T_MAX", 5.0)];
    let imported = px4(&defaults);
    assert_eq!(imported.dropped, ["SIH_IXX", "SIH_MASS", "SIH_T_MAX"]);
    assert!(imported.text.unwrap().contains("mass    = ?"));
}

#[test]
fn batteries_are_read() {
    let spec = filled(&file("px4_defaults.params"), &[&REST[..], &[("mass", "2.9 kg")]].concat());
    let battery = spec.model().vehicle.battery.as_ref().unwrap();
    assert!((battery.capacity - 36000.0).abs() < 1e-6 && (battery.voltage - 6.0 * 3.7).abs() < 1e-6, "{battery:?}");
    let known = ardupilot("BATT_CAPACITY,5200\nMOT_BAT_VOLT_MAX,16.8\n").text.unwrap();
    assert!(known.contains("capacity    = 5200 mA*h") && known.contains("voltage     = 14.8 V"), "{known}");
    assert!(ardupilot("BATT_CAPACITY,5200\nMOT_BAT_VOLT_MAX,16.8\n").dropped.is_empty());
    assert_eq!(ardupilot("MOT_BAT_VOLT_MAX,16.8\n").dropped, ["MOT_BAT_VOLT_MAX"]);
    let open = ardupilot("BATT_CAPACITY,5200\n").text.unwrap();
    assert!(open.contains("voltage     = ?"), "{open}");
    for text in [
        ardupilot("BATT_CAPACITY,3300\n").text.unwrap(),
        px4(&[("BAT1_CAPACITY", -1.0), ("BAT1_N_CELLS", 4.0)]).text.unwrap(),
    ] {
        assert!(!text.contains("battery"), "{text}");
    }
}

/// Other vehicles of ArduPilot have some of the same parameters, and each gets its reason.
#[test]
fn parameters_of_other_vehicles_are_named() {
    for (text, words) in [
        ("FRAME_CLASS,16\n", "six degrees of freedom"),
        ("FRAME_CLASS,17\n", "a script on the autopilot changes in flight"),
        ("Q_FRAME_CLASS,1\nQ_ENABLE,1\n", "a quadplane, a VTOL aircraft"),
        ("FRAME,1\nMOT_SPIN_ARMED,70\n", "ArduCopter before 3.5"),
        ("FRAME_CLASS,1\nATC_STR_RAT_P,0.2\n", "a rover or boat"),
        ("FRAME_CLASS,1\nCRUISE_THROTTLE,40\n", "a rover or boat"),
        ("FRAME_CLASS,3\nATC_BAL_P,1.8\n", "a rover or boat"),
        ("FRAME_CONFIG,2\n", "a submarine"),
        ("FRAME,1\nH_RSC_MODE,1\n", "a helicopter"),
        ("FRAME_CLASS,6\nH_RSC_MODE,1\n", "`FRAME_CLASS` 6 is a helicopter"),
        ("TECS_CLMB_MAX,5\nRLL2SRV_TCONST,0.5\n", "a plane"),
    ] {
        let imported = import("a.param", text.as_bytes());
        let error = imported.diagnostics.last().unwrap();
        assert!(imported.text.is_none() && error.message.contains(words) && error.help.is_some(), "{text}: {error:?}");
    }
}

/// Airframes of PX4 say what they are by `CA_AIRFRAME`, their class, or the defaults that they run: a plane of one
/// motor is not a multirotor with too few.
#[test]
fn airframes_of_px4_that_are_no_multirotors_are_named() {
    let motor = "param set-default CA_ROTOR_COUNT 1\nparam set-default CA_ROTOR0_PX 0.3\n";
    for (text, words) in [
        (format!("# @class Plane\n{motor}"), "of the kind `Plane`"),
        (format!(". ${{R}}etc/init.d/rc.fw_defaults\n{motor}"), "of the kind `Plane`"),
        (format!(". ${{R}}etc/init.d/rc.vtol_defaults\n{motor}"), "of the kind `VTOL`"),
        (format!(". ${{R}}etc/init.d/rc.mc_defaults\n{motor}"), "a spec has 4 to 32 rotors, and the file 1"),
        (format!("param set-default CA_AIRFRAME 7\n{motor}"), "six degrees of freedom"),
        (format!("param set-default CA_AIRFRAME 14\n{motor}"), "a spacecraft"),
    ] {
        let imported = import("4999_a", text.as_bytes());
        assert_eq!(imported.diagnostics.len(), 1, "{text}");
        assert!(imported.diagnostics[0].message.contains(words), "{text}: {:?}", imported.diagnostics[0]);
    }
}

/// Files of defaults, as ArduPilot reads them: hexadecimal values, flags after a value, other files that they include.
#[test]
fn files_of_defaults_are_read_as_ardupilot_does() {
    let text = "FRAME_CLASS 0x2 @READONLY\nFRAME_TYPE 1\nSIM_CAN_SRV_MSK 0x0F\n";
    let hexa = import("a.parm", text.as_bytes());
    assert!(hexa.diagnostics.is_empty() && hexa.text.unwrap().contains("motor 6"));
    for wrong in ["0x", "0xg", "0x1ffffffff"] {
        let imported = import("a.parm", format!("FRAME_CLASS {wrong}\n").as_bytes());
        assert_eq!(imported.diagnostics[0].code, "mavc::import::syntax", "{wrong}");
    }
    let known = import("a.parm", b"@include ../quad.parm\nFRAME_CLASS 1\nFRAME_TYPE 1\n");
    assert!(known.text.is_some() && warns(&known, "`../quad.parm` is not read"));
    let unknown = import("a.parm", b"@include ../quad.parm\nBATT_MONITOR 4\n");
    assert!(unknown.diagnostics[0].message.contains("but it includes `../quad.parm`"), "{unknown:?}");
    for imported in [
        import("a.parm", b"BATT_MONITOR=8\nCAN_P1_DRIVER=1\n"),
        mavc::import::mission::import("a.parm", b"BATT_MONITOR=8\nCAN_P1_DRIVER=1\n", None),
    ] {
        let message = &imported.diagnostics[0].message;
        assert!(!message.contains("spec of mavc already"), "{message}");
    }
}

/// Scripts of pymavlink print the columns of QGroundControl with blanks between them.
#[test]
fn saved_parameters_with_blanks_are_those_with_tabs() {
    let tabs: String = (0..4)
        .map(|i| {
            let (x, y) = ([0.2, -0.2, 0.2, -0.2][i], [0.2, -0.2, -0.2, 0.2][i]);
            let km = if i < 2 { 0.05 } else { -0.05 };
            let line = |key: &str, value: f64| format!("1\t1\tCA_ROTOR{i}_{key}\t{value}\t9\n");
            line("PX", x) + &line("PY", y) + &line("KM", km)
        })
        .collect();
    let tabs = format!("# Vehicle-Id Component-Id Name Value Type\n1\t1\tCA_ROTOR_COUNT\t4\t6\n{tabs}");
    let blanks = tabs.replace("\t", "   ");
    let texts = [&tabs, &blanks].map(|text| import("a.params", text.as_bytes()).text.unwrap());
    assert_eq!(texts[0], texts[1]);
    let cut = import("a.params", b"1 1 CA_ROTOR_COUNT 4\n");
    assert!(cut.diagnostics[0].message.contains("is not complete"), "{cut:?}");
}
