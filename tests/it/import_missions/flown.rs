//! What the spec of a mission says is what PX4 and ArduCopter fly, by their sources ([`mavc::import::mission`]).

use super::{found, read, spec};
use mavc::Compiler;
use mavc::Severity::Error;
use mavc::model::{Heading, Mission};

fn file(name: &str) -> String {
    std::fs::read_to_string(format!("tests/specs/findings/files/{name}")).unwrap()
}

fn mission(name: &str, text: &str) -> Mission {
    let text = format!("{}{}", spec(name, text), super::HEXA);
    Compiler::new().text("m.mav", text.as_bytes()).into_result().unwrap().mission().unwrap().clone()
}

fn heights(mission: &Mission) -> Vec<f64> {
    mission.waypoints.iter().map(|w| (100.0 * w.position[2]).round() / 100.0).collect()
}

/// A line of `QGC WPL 110` at 47.4, 8.54 or near it.
fn line(number: usize, frame: u8, command: u16, params: [f64; 4], place: [f64; 3]) -> String {
    let words: Vec<String> = params.iter().chain(&place).map(f64::to_string).collect();
    format!("{number}\t0\t{frame}\t{command}\t{}\t1\n", words.join("\t"))
}

const HOME: &str = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.4\t8.54\t500\t1\n";

/// ArduCopter, `loc_from_cmd`: an altitude of 0 is the present one, in whatever frame; PX4 flies to 0.
#[test]
fn an_altitude_of_zero_is_the_present_one_for_ardupilot_alone() {
    assert_eq!(heights(&mission("a.txt", &file("loiter_here.txt"))), [0.0, 20.0, 30.0, 30.0, 10.0, 0.0]);
    for (frame, command) in [(3, 16), (0, 16), (3, 82), (0, 19)] {
        let text = HOME.to_string()
            + &line(1, 3, 22, [0.0; 4], [0.0, 0.0, 25.0])
            + &line(2, frame, command, [0.0; 4], [47.401, 8.54, 0.0])
            + &line(3, 3, 16, [0.0; 4], [47.401, 8.541, 15.0]);
        let flown = mission("a.txt", &text);
        assert_eq!(heights(&flown)[..2], [0.0, 25.0]);
        // The Earth curves down by a millimetre in 111 m.
        assert!((flown.waypoints[2].position[2] - 25.0).abs() < 0.01, "{frame} {command}: {:?}", flown.waypoints[2]);
        assert!((flown.waypoints[3].position[2] - 15.0).abs() < 0.01);
    }
    let px4 = file("slow_landing.plan").replacen("46.0002,\n     7.0,\n     20", "46.0002,\n     7.0,\n     0", 1);
    let ardupilot = px4.replace("\"firmwareType\": 12", "\"firmwareType\": 3");
    assert_eq!([&px4, &ardupilot].map(|text| heights(&mission("a.plan", text))[2]), [0.0, 20.0]);
}

/// Both autopilots descend until they touch the ground.
#[test]
fn a_landing_ends_on_the_ground_whatever_its_altitude() {
    let text = file("land_altitude.txt");
    let flown = mission("a.txt", &text);
    assert_eq!(heights(&flown), [0.0, 20.0, 20.0, 20.0, 10.0, 0.0]);
    let remarks = found(&text);
    assert_eq!((remarks.len(), remarks[0].0), (1, "mavc::import::assumed"));
    assert!(remarks[0].2.contains("20 m above home"), "{remarks:?}");
    let lower = text.replace("8.5405\t20\t", "8.5405\t-7\t");
    assert_eq!(heights(&mission("a.txt", &lower)).last(), Some(&-7.0));
    assert!(found(&lower)[0].2.contains("7 m below the planned home"), "{:?}", found(&lower));
    let level = text.replace("8.5405\t20\t", "8.5405\t0\t");
    assert_eq!((heights(&mission("a.txt", &level)), found(&level).len()), (heights(&flown), 0));
    // A landing where the vehicle is.
    let here = text.replace("47.4003\t8.5405\t20\t", "0\t0\t0\t");
    assert_eq!(heights(&mission("a.txt", &here)), [0.0, 20.0, 20.0, 10.0, 0.0]);
}

/// Speeds of the parameters' defaults: the last 10 m at the speed of a landing.
#[test]
fn vertical_speeds_are_those_of_the_autopilot() {
    let px4 = file("slow_landing.plan");
    let ardupilot = px4.replace("\"firmwareType\": 12", "\"firmwareType\": 3");
    for (text, level, climb, take_off, land) in [(&px4, 5.0, 3.0, 1.5, 0.7), (&ardupilot, 10.0, 2.5, 2.5, 0.5)] {
        let flown = mission("a.plan", text);
        assert_eq!(heights(&flown), [0.0, 20.0, 20.0, 20.0, 10.0, 0.0]);
        // The least of the limits on each leg, by the leg's waypoint.
        let least = |word: &str, leg: usize| {
            let on = |limit: &&mavc::model::Limit| {
                let name = limit.name().to_string();
                let (kind, place) = name.split_once(" on the leg to waypoint ").unwrap_or((&name, ""));
                kind == word && (place.is_empty() || place == leg.to_string())
            };
            flown.limits.iter().filter(on).filter_map(|limit| limit.upper).fold(f64::INFINITY, f64::min)
        };
        assert_eq!([2, 3].map(|leg| least("climb", leg)), [take_off, climb]);
        assert_eq!([3, 5, 6].map(|leg| least("descent", leg)), [1.5, 1.5, land]);
        assert_eq!(least("horizontal speed", 3), level);
    }
    let text = spec("a.plan", &px4);
    for name in ["PX4's default MPC_Z_V_AUTO_UP", "PX4's default MPC_Z_V_AUTO_DN"] {
        assert!(text.contains(name), "{name}\n{text}");
    }
    // With it QGroundControl estimates the duration; the autopilot does not get it.
    let faster = px4.replace("\"hoverSpeed\": 5", "\"hoverSpeed\": 7");
    assert!(spec("a.plan", &faster).contains("speed_horizontal <= 5 m/s    // PX4's default MPC_XY_CRUISE"));
    assert!(spec("a.txt", &file("loiter_here.txt")).contains("speed_horizontal <= 10 m/s   // ArduPilot's default"));
}

/// PX4, `RtlDirect::on_activation`, and ArduCopter, `rtl_start`: a return has the default speed, whatever was
/// set before.
/// Both return to a rally point that is nearer than home.
#[test]
fn a_return_is_at_the_default_speed_and_may_go_to_a_rally_point() {
    let text = HOME.to_string()
        + &line(1, 3, 22, [0.0; 4], [0.0, 0.0, 25.0])
        + &line(2, 3, 178, [1.0, 17.0, -1.0, 0.0], [0.0; 3])
        + &line(3, 3, 16, [0.0; 4], [47.402, 8.54, 25.0])
        + &line(4, 3, 20, [0.0; 4], [0.0; 3]);
    let lines: Vec<String> = spec("a.txt", &text).lines().map(String::from).collect();
    let has = |item: &str, speed: &str| lines.iter().any(|line| line.contains(item) && line.contains(speed));
    assert!(has("item 2", "speed_horizontal <= 17 m/s"), "{lines:#?}");
    assert!(
        ["to above the landing", "land at home"].iter().all(|leg| has(leg, "speed_horizontal <= 10 m/s")),
        "{lines:#?}"
    );
    assert!(found(&text).iter().all(|(.., message)| !message.contains("rally")));
    let rally = text.clone() + &line(5, 3, 5100, [0.0; 4], [47.402, 8.5401, 20.0]);
    let said = found(&rally);
    assert!(said.iter().any(|(.., message)| message.contains("ArduPilot returns to a rally point")), "{said:?}");
}

/// ArduCopter, `takeoff_start`: never below the present height. PX4, `handleTakeoff` and `handleLanding`: no heading.
#[test]
fn take_offs_in_the_air_and_headings_of_take_offs_and_landings() {
    let text = HOME.to_string()
        + &line(1, 3, 22, [0.0; 4], [0.0, 0.0, 25.0])
        + &line(2, 3, 22, [0.0; 4], [0.0, 0.0, 20.0])
        + &line(3, 3, 22, [0.0; 4], [0.0, 0.0, 30.0])
        + &line(4, 3, 16, [0.0; 4], [47.401, 8.54, 30.0]);
    assert_eq!(heights(&mission("a.txt", &text)), [0.0, 25.0, 30.0, 30.0]);
    assert!(found(&text)[0].2.contains("item 2") && found(&text)[0].2.contains("does not descend"));
    let plan = file("slow_landing.plan");
    let turned = plan.replacen("null,", "90,", 9);
    assert_ne!(plan, turned);
    let yaws = spec("a.plan", &turned);
    let with = |word: &str| yaws.lines().filter(|line| line.contains(word)).any(|line| line.contains("yaw 0 deg"));
    assert!(!with("take-off") && !with("land"), "{yaws}");
}

/// One warning for items after the end, and one for each command without an effect on the flight.
#[test]
fn what_repeats_is_said_once() {
    let servo = |number| line(number, 3, 183, [3.0, 1500.0, 0.0, 0.0], [0.0; 3]);
    let text = HOME.to_string()
        + &line(1, 3, 22, [0.0; 4], [0.0, 0.0, 25.0])
        + &(2..5).map(servo).collect::<String>()
        + &line(5, 3, 16, [0.0; 4], [47.401, 8.54, 25.0])
        + &line(6, 3, 17, [0.0; 4], [47.401, 8.54, 25.0])
        + &(7..12).map(servo).collect::<String>();
    let said: Vec<String> = found(&text).into_iter().map(|(.., message)| message).collect();
    assert_eq!(said.len(), 2, "{said:?}");
    assert!(said[0].starts_with("item 2: command 183 (DO_SET_SERVO)"), "{said:?}");
    assert!(said[0].ends_with("here and in 2 more items"), "{said:?}");
    assert_eq!(said[1], "item 7 to item 11 come after item 6, which ends the mission");
    // A first line that is not a home.
    let homeless = text.replacen("0\t1\t0\t16", "1\t1\t3\t16", 1);
    assert!(found(&homeless)[0].2.starts_with("the first line is taken for the planned home"));
}

/// A table without a header: degrees are not metres.
#[test]
fn a_table_of_degrees_is_refused() {
    let refused = |text: &str| read("a.csv", text).diagnostics.iter().any(|d| d.severity == Error);
    assert!(refused("47.397742,8.545594,10\n47.398742,8.545594,10\n47.398742,8.546594,10\n"));
    assert!(!refused("47.397,8.545,10\n47.397,8.545,12\n"), "straight up");
    assert!(!refused("0.0012345,0.0012345,1\n0.1234567,0.1234567,1\n"), "a small flight");
    assert!(!refused("10.123456,8.123456,10\n14.123456,8.123456,10\n"), "a flight");
}

/// The command turns on the way to the next place, and holds for that place alone.
#[test]
fn a_region_of_interest_and_turns_become_yaws() {
    let flown = mission("a.txt", &file("region_and_turn.txt"));
    let headings: Vec<Heading> = flown.waypoints.iter().map(|w| w.heading).collect();
    assert_eq!(headings[1], Heading::Free, "the take-off");
    assert_eq!(headings[3..5], [Heading::Given, Heading::Free]);
    assert!(flown.waypoints[3].yaw.abs() < 1e-12, "east");
    let text = spec("a.txt", &file("region_and_turn.txt"));
    // The place of the region, 47.4005 and 8.5405 deg, from home at 47.4 and 8.54 deg.
    let due = super::places::local([47.4, 8.54, 500.0], [47.4005, 8.5405, 500.0]);
    let towards = text.split("yaw towards [").nth(1).unwrap().split(']').next().unwrap();
    let at: Vec<f64> = towards.split(',').map(|x| x.trim().parse().unwrap()).collect();
    assert!((at[0] - due[0]).abs() < 1e-3 && (at[1] - due[1]).abs() < 1e-3, "{at:?} {due:?}");
    // A turn by an angle from a known heading, to the left; then from none.
    let turn =
        |heading: f64, direction: f64, relative: f64| line(2, 0, 115, [heading, 0.0, direction, relative], [0.0; 3]);
    let with = |turns: [String; 2]| {
        let [first, second] = turns;
        let far = |latitude: f64| line(3, 3, 16, [0.0, 0.0, 0.0, 45.0], [latitude, 8.54, 20.0]);
        HOME.to_string() + &line(1, 3, 22, [0.0; 4], [0.0, 0.0, 20.0]) + &first + &far(47.401) + &second + &far(47.402)
    };
    let yaws = |text: &str| {
        let flown = mission("a.txt", text);
        [2, 3].map(|k| {
            (flown.waypoints[k].heading == Heading::Given).then(|| flown.waypoints[k].yaw.to_degrees().round())
        })
    };
    assert_eq!(yaws(&with([turn(30.0, 0.0, 0.0), turn(20.0, -1.0, 1.0)])), [Some(60.0), Some(80.0)]);
    assert_eq!(yaws(&with([turn(30.0, 0.0, 0.0), turn(20.0, 1.0, 1.0)])), [Some(60.0), Some(40.0)]);
    let lost = with([turn(30.0, 1.0, 1.0), String::new()]);
    assert_eq!(yaws(&lost), [None, None]);
    assert!(found(&lost).iter().any(|f| f.2.contains("a turn by an angle is left out")), "{:?}", found(&lost));
    // Parameter 4 says nothing to ArduCopter.
    assert_eq!(found(&lost).iter().filter(|f| f.2.contains("parameter 4 is left out")).count(), 2);
    // Without a place the region ends.
    let ended = file("region_and_turn.txt")
        .replace("4\t0\t0\t115\t90\t20\t1\t0\t0\t0\t0\t1", &line(4, 0, 197, [0.0; 4], [0.0; 3]));
    let towards = |text: &str| spec("a.txt", text).matches("yaw towards").count();
    assert_eq!((towards(&ended), spec("a.txt", &ended).matches("yaw free").count()), (1, 2));
}

/// ArduCopter takes no speed of zero or below, and PX4 its default for -2.
#[test]
fn speeds_that_say_nothing_change_nothing() {
    let text = HOME.to_string()
        + &line(1, 3, 22, [0.0; 4], [0.0, 0.0, 20.0])
        + &line(2, 0, 178, [1.0, 0.0, 0.0, 0.0], [0.0; 3])
        + &line(3, 0, 178, [1.0, 4.0, 0.0, 0.0], [0.0; 3])
        + &line(4, 0, 178, [1.0, -2.0, 0.0, 0.0], [0.0; 3])
        + &line(5, 3, 16, [0.0; 4], [47.401, 8.54, 20.0]);
    assert!(spec("a.txt", &text).contains("straight { speed_horizontal <= 4 m/s }"), "{}", spec("a.txt", &text));
}

/// `use` would read no other file.
#[test]
fn a_vehicle_must_be_a_spec() {
    let imported = mavc::import::mission::import("a.csv", file("pause.csv").as_bytes(), Some("v.params"));
    let error = imported.diagnostics.last().unwrap();
    assert!(imported.text.is_none() && error.help.as_ref().unwrap().contains("mavc import vehicle"), "{error:?}");
}

#[test]
fn a_first_line_that_takes_off_is_no_home() {
    let text = file("take_off_first.txt");
    let imported = read("a.txt", &text);
    let spec = imported.text.unwrap();
    assert!(spec.contains("origin_altitude  = ?"), "{spec}");
    let filled = spec.replace("origin_altitude  = ?", "origin_altitude  = 412 m");
    let compiled = Compiler::new().text("m.mav", format!("{filled}{}", super::HEXA).as_bytes()).into_result().unwrap();
    let flown = compiled.mission().unwrap();
    assert_eq!(heights(flown), [0.0, 25.0, 25.0, 25.0, 25.0, 10.0, 0.0]);
    assert_eq!(flown.waypoints[0].position, [0.0; 3]);
    assert!(found(&text)[0].2.contains("the first item is a take-off"));
    // Without a home no height is above sea.
    let above_sea = text.replace("2\t0\t3\t16", "2\t0\t0\t16");
    assert_eq!((found(&above_sea)[0].1, found(&above_sea)[0].0), (Error, "mavc::import::unsupported"));
}

#[test]
fn a_home_that_nobody_set_says_what_to_do() {
    let plan = file("slow_landing.plan").replace("46.0,\n   7.0,\n   600", "0,\n   0,\n   0");
    for text in [file("home_zero.txt"), plan] {
        let imported = read("a.plan", &text);
        let error = imported.diagnostics.last().unwrap();
        assert!(error.message.contains("the planned home is at 0, 0"), "{error:?}");
        assert!(error.help.as_ref().unwrap().starts_with("set the home in the ground station"), "{error:?}");
    }
}

#[test]
fn rows_at_one_place_are_a_pause() {
    let flown = mission("a.csv", &file("pause.csv"));
    assert_eq!(flown.waypoints.iter().map(|w| w.hold).collect::<Vec<_>>(), [0.0, 3.0, 0.0]);
    assert_eq!(flown.waypoints.iter().map(|w| w.time).collect::<Vec<_>>(), [None, Some(3.0), Some(9.0)]);
    // Three rows, and one that turns.
    let long = mission("a.csv", "t,x,y,z\n0,0,0,2\n3,4,0,2\n6,4,0,2\n7.5,4,0,2\n12,8,0,2\n");
    assert_eq!(long.waypoints[1].hold, 4.5);
    let turning = mission("a.csv", "t,x,y,z,heading\n0,0,0,2,0\n3,4,0,2,0\n6,4,0,2,90\n12,8,0,2,90\n");
    assert_eq!(turning.waypoints.len(), 4);
}

#[test]
fn every_item_that_no_spec_says_is_named_at_once() {
    let text = file("three_unsupported.plan");
    let errors: Vec<String> = found(&text).into_iter().filter(|f| f.1 == Error).map(|f| f.2).collect();
    let begin = ["item 4: a spec has no word for command 18", "item 5: a spec has no word for command 177"];
    assert_eq!(errors.len(), 3, "{errors:?}");
    assert!(errors.iter().zip(begin).all(|(error, begin)| error.starts_with(begin)), "{errors:?}");
    assert!(errors[2].starts_with("item 9: a spec has no word for command 3000"));
    assert!(read("a.plan", &text).text.is_none());
}
