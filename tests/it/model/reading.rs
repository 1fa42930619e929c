//! File sets: `use`, tables, limits.

use super::QUAD;
use mavc::diagnostic::Diagnostic;
use mavc::input::MAX_TABLE_BYTES;
use mavc::read::{FileSet, elaborate, load};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

/// Loads the first of `files`; the others are there to be read.
fn load_all(files: &[(&str, &[u8])]) -> (FileSet, Vec<Diagnostic>) {
    let map: BTreeMap<&str, &[u8]> = files.iter().copied().collect();
    let read = |path: &Path| {
        let name = path.to_str().unwrap();
        map.get(name).map(|bytes| bytes.to_vec()).ok_or(io::Error::from(io::ErrorKind::NotFound))
    };
    load(files[0].0, files[0].1, &read)
}

fn codes(diagnostics: &[Diagnostic]) -> Vec<&'static str> {
    diagnostics.iter().map(|d| d.code).collect()
}

#[test]
fn files_count_from_the_file_that_names_them_and_come_once() {
    let root = b"use \"../vehicles/quad.mav\"\nuse \"../a/b/deep.mav\"\nuse \"./../vehicles/quad.mav\"\n";
    let deep = b"use \"../../vehicles/quad.mav\"\nlet unused = 1\n";
    let (set, diagnostics) =
        load_all(&[("specs/root.mav", root), ("vehicles/quad.mav", QUAD.as_bytes()), ("a/b/deep.mav", deep)]);
    assert_eq!(diagnostics, vec![]);
    let names: Vec<&str> = set.sources.iter().map(|(_, s)| s.name.as_str()).collect();
    assert_eq!(names, ["specs/root.mav", "vehicles/quad.mav", "a/b/deep.mav"]);
    assert_eq!(set.files.len(), 3);
    let checked = elaborate(&set, &[]);
    assert!(checked.value.is_some());
    assert_eq!(codes(&checked.diagnostics), ["mavc::name::unused"]);
}

#[test]
fn circles_and_long_chains_end() {
    let (_, diagnostics) = load_all(&[("a.mav", b"use \"a.mav\"\n")]);
    assert_eq!(codes(&diagnostics), ["mavc::file::cycle"]);
    let (_, diagnostics) =
        load_all(&[("a.mav", b"use \"b.mav\"\n"), ("b.mav", b"use \"c.mav\"\n"), ("c.mav", b"use \"b.mav\"\n")]);
    assert_eq!(codes(&diagnostics), ["mavc::file::cycle"]);
    let chain = |path: &Path| {
        let number: u32 = path.file_stem().unwrap().to_str().unwrap()[1..].parse().unwrap();
        Ok(format!("use \"f{}.mav\"\n", number + 1).into_bytes())
    };
    let (set, diagnostics) = load("f0.mav", b"use \"f1.mav\"\n", &chain);
    assert_eq!(codes(&diagnostics), ["mavc::file::too_many"]);
    assert_eq!(set.files.len(), 256);
}

/// Names that stand for each other as deep as they may, each in a long sum, on the stack of a small thread.
#[test]
fn deep_expressions_need_no_large_stack() {
    let more = " + 1".repeat(190);
    let chain = |names: usize| -> String {
        let line = |i: usize| format!("let a{i} = a{}{more}\n", i + 1);
        (0..names).map(line).collect::<String>() + &format!("let a{names} = 1\n")
    };
    let codes_of = |names: usize| {
        let text = chain(names) + QUAD;
        let on_small_stack = std::thread::Builder::new().stack_size(512 << 10).spawn(move || {
            let (set, diagnostics) = load_all(&[("root.mav", text.as_bytes())]);
            assert_eq!(diagnostics, vec![]);
            let checked = elaborate(&set, &[]);
            checked.diagnostics.iter().map(|d| d.code).collect::<Vec<_>>()
        });
        on_small_stack.unwrap().join().unwrap()
    };
    assert_eq!(codes_of(3), ["mavc::name::unused"]);
    assert!(codes_of(4).contains(&"mavc::unit::too_much"));
}

#[test]
fn bytes_that_are_not_text_and_files_too_large_are_reported() {
    let (set, diagnostics) = load_all(&[("a.mav", b"let a = 1\n\xff\xfe")]);
    assert_eq!(codes(&diagnostics), ["mavc::file::encoding"]);
    assert_eq!((diagnostics[0].span.start, set.sources.snippet(diagnostics[0].span)), (10, "\u{fffd}"));
    assert!(set.incomplete && elaborate(&set, &[]).value.is_none());
    // The same for a table, with the place that names it; a byte order mark is no part of either.
    let root = b"mission m { waypoints from \"t.csv\" }\n";
    let (set, diagnostics) = load_all(&[("a.mav", root), ("t.csv", b"x_m,y_m,z_m\n1,2,\xff\n")]);
    assert_eq!(codes(&diagnostics), ["mavc::file::encoding"]);
    assert_eq!(set.sources.get(diagnostics[0].span.file).name, "t.csv");
    assert_eq!(set.sources.snippet(diagnostics[0].labels[0].span), "\"t.csv\"");
    let (set, diagnostics) = load_all(&[("a.mav", b"\xef\xbb\xbflet a = 1\n")]);
    assert_eq!((diagnostics.len(), set.sources.get(mavc::source::FileId(0)).text.as_str()), (0, "let a = 1\n"));
    let (set, diagnostics) = load_all(&[("a.mav", &vec![b'x'; 10 << 20])]);
    assert_eq!(codes(&diagnostics), ["mavc::file::too_large"]);
    assert!(elaborate(&set, &[]).value.is_none());
    let (_, diagnostics) = load_all(&[("a.mav", &vec![0xff; 10 << 20])]);
    assert_eq!(codes(&diagnostics), ["mavc::file::too_large"]);
    let table = vec![b'1'; MAX_TABLE_BYTES + 1];
    let (_, diagnostics) = load_all(&[("a.mav", b"mission m { waypoints from \"t.csv\" }\n"), ("t.csv", &table)]);
    assert_eq!(codes(&diagnostics), ["mavc::file::too_large"]);
}

#[test]
fn files_that_cannot_be_read_say_why() {
    for (kind, why) in [
        (io::ErrorKind::NotFound, "file `v.mav` not found"),
        (io::ErrorKind::IsADirectory, "`v.mav` is a folder, not a file"),
        (io::ErrorKind::PermissionDenied, "cannot read `v.mav`: permission denied"),
    ] {
        let (_, diagnostics) = load("a.mav", b"use \"v.mav\"\n", &|_| Err(io::Error::from(kind)));
        assert_eq!(codes(&diagnostics), ["mavc::file::missing"]);
        assert_eq!(diagnostics[0].message, why);
    }
}

#[test]
fn tables_become_waypoints() {
    let root = format!("{QUAD}mission m {{\n start at [1, 1, 2] m\n waypoints from \"t.csv\"\n}}\n");
    let table =
        "x_m, y_m, z_ft, yaw_deg, within_cm, weight, time_s, name\n# out\n0,0,10,0,,,,home\n4,0,10,90,10,2,30,\n";
    let (set, diagnostics) = load_all(&[("s/a.mav", root.as_bytes()), ("s/t.csv", table.as_bytes())]);
    assert_eq!(diagnostics, vec![]);
    assert_eq!((set.tables.len(), set.tables[0].name.as_str()), (1, "s/t.csv"));
    let checked = elaborate(&set, &[]);
    assert_eq!(checked.diagnostics, vec![]);
    let waypoints = checked.value.unwrap().mission.unwrap().waypoints;
    assert_eq!(waypoints.len(), 3);
    assert_eq!(waypoints[1].name.as_deref(), Some("home"));
    assert_eq!(waypoints[1].position, [0.0, 0.0, 3.048]);
    assert_eq!(waypoints[1].within, 0.05);
    assert_eq!((waypoints[2].within, waypoints[2].weight, waypoints[2].time), (0.1, 2.0, Some(30.0)));
    assert!((waypoints[2].yaw - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    assert_eq!(set.sources.snippet(waypoints[2].span), "4,0,10,90,10,2,30,");
}

#[test]
fn mistakes_in_tables_are_reported_by_row() {
    let root = format!("{QUAD}mission m {{ waypoints from \"t.csv\" }}\n");
    for (table, count) in [
        ("", 1),
        ("a,b\n1,2\n", 1),
        ("x_m,y_m\n1,2\n", 1),
        ("x_m;y_m;z_m\n1;2;3\n", 1),
        ("X_m,y_m,z_m\n1,2,3\n", 1),
        ("1,2,3\n4,5,6\n", 1),
        ("x_m,x_m,y_m,z_m\n1,1,1,1\n", 1),
        ("x_s,y_m,z_m\n1,1,1\n", 1),
        ("x_m,y_m,z_m,weight_kg\n1,1,1,1\n", 1),
        ("x_m,y_m,z_m,within_m\n1,1,1,0\n2,2,2,-1\n3,3,nan,1\n,1,1,1\n", 4),
        ("x_m,y_m,z_m,weight\n1,1,1,-1\n1,1\n", 2),
    ] {
        let (set, _) = load_all(&[("a.mav", root.as_bytes()), ("t.csv", table.as_bytes())]);
        let checked = elaborate(&set, &[]);
        assert_eq!(checked.diagnostics.len(), count, "{table}: {:#?}", checked.diagnostics);
        assert!(checked.value.is_none());
    }
    let many = format!("x_m,y_m,z_m\n{}", "bad,0,0\n".repeat(1000));
    let (set, _) = load_all(&[("a.mav", root.as_bytes()), ("t.csv", many.as_bytes())]);
    assert_eq!(elaborate(&set, &[]).diagnostics.len(), 20);
}

#[test]
fn hostile_sizes_stay_bounded() {
    // Work is counted: a long expression at ten thousand points ends with an error, soon.
    let long = "+ s*1 m ".repeat(100);
    let body = format!("x = 0 m {long}; y = 0 m; z = 5 m");
    let curves = format!(" curve s in 0 .. 1, points = 10000 {{ {body} }}\n").repeat(40);
    let (_, found) = super::check(&format!("{QUAD}mission m {{\n{curves}}}\n"));
    assert!(
        codes(&found).contains(&"mavc::unit::too_much") || codes(&found).contains(&"mavc::mission::too_many_waypoints")
    );
    let unknown: String = (0..5000).map(|k| format!("let a{k} = b{k} + [c, \n d]\n")).collect();
    let found = super::codes(&format!("{QUAD}{unknown}"));
    assert_eq!((found.len(), found[500]), (501, "mavc::name::too_many"));
    let listed = "Z, ".repeat(50_000);
    let text = format!("{QUAD}faults {{ every 1 rotor lost as M }}\nplan {{ against = [{listed}] }}\n");
    assert_eq!(super::codes(&text).len(), 501);
    let doubling: String = (0..60).map(|k| format!("let a{} = a{k} + a{k}\n", k + 1)).collect();
    let (model, _) = super::check(&format!("let a0 = 1\n{doubling}{QUAD}"));
    assert!(model.is_some());
    assert_eq!(super::codes(&format!("{QUAD}let a = 1e308 * 10\n")), ["mavc::unit::not_finite"]);
    assert_eq!(super::codes(&format!("{QUAD}let a = (1 m)^999 * (1 m)^999\n")), ["mavc::unit::exponent"]);
    let hold = " hold 1e308 s\n".repeat(3);
    let text = format!("{QUAD}mission m {{\n start at [0, 0, 2] m\n{hold} waypoint at [9, 0, 2] m\n}}\n");
    assert_eq!(super::codes(&text), ["mavc::unit::not_finite"; 2]);
}
