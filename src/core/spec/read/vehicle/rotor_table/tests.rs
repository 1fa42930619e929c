use super::*;
use crate::source::{Source, SourceMap};

/// The points of a table, or the messages of its errors.
fn read(bytes: &[u8]) -> Result<RotorTable, Vec<String>> {
    let mut sources = SourceMap::default();
    let source = Source::from_bytes("t.csv", bytes).map_err(|_| vec!["not text".to_string()])?;
    let bytes = source.text.clone().into_bytes();
    let file = sources.add(source);
    let table = Table { name: "t.csv".into(), bytes, file };
    let mut cx = Context::new(&sources, false, &[]);
    let found = points(&mut cx, &table);
    let diagnostics = std::mem::take(&mut cx.diagnostics);
    assert_eq!(found.is_none(), !diagnostics.is_empty(), "{diagnostics:?}");
    for diagnostic in &diagnostics {
        let _ = sources.snippet(diagnostic.span);
        assert!(diagnostic.code == CODE && diagnostic.help.is_some(), "{diagnostic:?}");
    }
    let read = |points| RotorTable { name: "t.csv".into(), points };
    found.map(read).ok_or_else(|| diagnostics.into_iter().map(|d| d.message).collect())
}

fn table(text: &str) -> RotorTable {
    read(text.as_bytes()).unwrap_or_else(|errors| panic!("{text}\n{errors:?}"))
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} is not {b}");
}

const SMALL: &str = "Throttle (%),Thrust (g),Torque (mN*m),RPM,Current (A),Voltage (V),Efficiency (g/W)\n\
                     50,200,34,4000,2,16,6.25\n75%,400,66,5500,5.5,15.8,4.6\n100,800,130,8000,15,15,3.6\n";

#[test]
fn the_numbers_of_a_table_by_hand() {
    let table = table(SMALL);
    close(table.max_thrust(), 0.8 * 9.80665);
    close(table.max_speed().unwrap(), 8000.0 * std::f64::consts::TAU / 60.0);
    // sum(Q T)/sum(T^2)
    let newtons = [0.2, 0.4, 0.8].map(|kg| kg * 9.80665);
    let torques = [0.034, 0.066, 0.13];
    let products: f64 = newtons.iter().zip(torques).map(|(t, q)| t * q).sum();
    let squares: f64 = newtons.iter().map(|t| t * t).sum();
    close(table.torque_per_thrust().unwrap(), products / squares);
    // Current times voltage, half-way between the first two rows.
    close(table.power(0.3 * 9.80665).unwrap(), 0.5 * (32.0 + 86.9));
    close(table.power(newtons[2]).unwrap(), 225.0);
    assert_eq!([table.power(1.0), table.power(8.0)], [None, None]);
    assert!(table.has_power());
}

#[test]
fn separators_spellings_and_gaps_change_nothing() {
    let thousands = SMALL.replace(",8000,", ",\"8,000\",");
    let semicolons = SMALL.replace(',', ";").replace(";8000;", ";8 000;");
    let blank = format!("# a comment\r\n\r\n{}\r\n,,,,,,\r\n", SMALL.replace('\n', "\r\n"));
    let marked = format!("\u{feff}{SMALL}");
    let names = SMALL.replace("Thrust (g)", "thrust_gf").replace("RPM", "Speed (r/min)").replace("mN*m", "mN·m");
    for other in [thousands, semicolons, blank, marked, names] {
        assert_eq!(table(&other), table(SMALL), "{other}");
    }
    // Power as written goes before current times voltage.
    let power = SMALL.replace("Efficiency (g/W)", "Power (W)");
    close(table(&power).power(0.8 * 9.80665).unwrap(), 3.6);
}

#[test]
fn units_may_be_below_the_names() {
    let rows = SMALL.split_once('\n').unwrap().1;
    for header in [
        "Throttle,Thrust,Torque,RPM,Current,Voltage,Efficiency\n%,g,mN*m,1/min,A,V,g/W\n",
        "Throttle,Thrust,Torque,Speed,Current,Voltage,Efficiency\n(%),(g),(mN·m),(RPM),(A),(V),(g/W)\n",
        "Throttle,Thrust,Torque,RPM,Current,Voltage,Efficiency\n,[g],[mNm],-,[A],[V],\n",
        "Throttle,Thrust (g),Torque,RPM,Current (A),Voltage,Efficiency\n,G,mN*m,,A,V,\n",
    ] {
        assert_eq!(table(&format!("{header}{rows}")), table(SMALL), "{header}");
    }
    let semicolons = "Thrust;RPM;Torque\n\n# units\nkgf;r/min;N*m\n0.4;3 000;0.02\n";
    let one = table(semicolons);
    close(one.max_thrust(), 0.4 * 9.80665);
    close(one.torque_per_thrust().unwrap(), 0.02 / (0.4 * 9.80665));
}

#[test]
fn a_table_gives_only_what_it_has() {
    let bare = table("Thrust (N)\n0\n5\n");
    assert_eq!((bare.max_thrust(), bare.max_speed(), bare.torque_per_thrust()), (5.0, None, None));
    assert!(!bare.has_power() && bare.estimated_torque_per_thrust().is_none());
    let gaps = table("Thrust (N),Torque (N*m),RPM\n1,,3000\n2,0.04,\n4,,6000\n");
    close(gaps.torque_per_thrust().unwrap(), 0.02);
    // A speed at full thrust alone is the full speed.
    assert_eq!(table("Thrust (N),RPM\n1,3000\n2,\n").max_speed(), None);
    // 100 W at 500 rad/s and 10 N are 20 mm with an efficiency of 1.
    let electrical = table("Thrust (N),speed_rad/s,Power (W)\n5,300,40\n10,500,100\n");
    let (middle, spread) = electrical.estimated_torque_per_thrust().unwrap();
    close(middle * spread.low, 0.02 * 0.45);
    close(middle * spread.high, 0.02 * 0.882);
}

#[test]
fn every_bad_table_is_reported() {
    let many = format!("Thrust (N)\n{}", (0..=MAX_ROWS).map(|k| format!("{k}\n")).collect::<String>());
    for (text, message) in [
        ("", "`t.csv` is empty"),
        ("\n# nothing\n", "`t.csv` is empty"),
        ("Thrust (g)\n", "no row with a thrust above zero"),
        ("Thrust (g)\n0\n", "no row with a thrust above zero"),
        ("RPM,Torque (N*m)\n1,2\n", "no column of the thrust"),
        ("50,200,4000\n60,300,5000\n", "must name its columns"),
        ("Thrust (g)\tRPM\n1\t2\n", "separated by commas or semicolons"),
        ("Thrust\n1\n", "the thrust needs a unit"),
        ("Thrust,RPM\nfurlong,RPM\n1,3000\n", "`furlong` is not a unit of the thrust"),
        ("Thrust,Torque\ng,\n1,2\n", "the column of the torque needs a unit"),
        ("Thrust (N),RPM\ng,RPM\n1,3000\n", "the thrust has two units"),
        ("Thrust,RPM\nforce,many\n1,3000\n", "the thrust needs a unit"),
        ("Thrust (N),RPM\nA,B\n1,3000\n", "`A` in column `thrust` is not a number"),
        ("Thrust,RPM\ng,RPM\n", "no row with a thrust above zero"),
        ("Thrust,RPM\ng,RPM\ng,RPM\n1,3000\n", "`g` in column `thrust` is not a number"),
        ("Thrust (furlong)\n1\n", "`furlong` is not a unit of the thrust"),
        ("Thrust (W)\n1\n", "`W` is not a unit of the thrust"),
        ("Thrust (g),Torque (g)\n1,2\n", "`g` is not a unit of the torque"),
        ("Thrust (g),Thrust (N)\n1,2\n", "two columns give the thrust"),
        ("Thrust (g),RPM\n1\n", "1 cell, but the header has 2"),
        ("Thrust (g)\n-1\n", "`thrust` cannot be negative"),
        ("Thrust (g),Power (W)\n1,-2\n", "`power` cannot be negative"),
        ("Thrust (g)\n2\n1\n", "`thrust` must increase"),
        ("Thrust (g)\n2\n2\n", "`thrust` must increase"),
        ("Thrust (g),RPM\n1,3000\n2,2000\n", "`speed` must increase"),
        ("Throttle,Thrust (g)\n50,1\n40,2\n", "`throttle` must increase"),
        ("Thrust (g),RPM\n1,3000\n2,\n3,2000\n", "`speed` must increase"),
        ("Thrust (g),RPM\n1,1e300\n", "`speed` is too large"),
        ("Thrust (g)\nNaN\n", "is not a number"),
        ("Thrust (g)\ninf\n", "is not a number"),
        ("Thrust (g);RPM\n12,5;3000\n", "has a decimal comma"),
        ("Thrust (g);RPM\n12;3,000\n", "may be a decimal number or one in thousands"),
        ("Thrust (g),RPM\n,3000\n", "`thrust` is empty"),
        (many.as_str(), "at most 1000 rows"),
    ] {
        let errors = read(text.as_bytes()).expect_err(text);
        assert!(errors.len() == 1 && errors[0].contains(message), "{text}: {errors:?}");
    }
    // Only the first errors of a table that has nothing right.
    let wrong = format!("Thrust (g)\n{}", "x\n".repeat(500));
    assert_eq!(read(wrong.as_bytes()).unwrap_err().len(), MAX_ERRORS);
}
