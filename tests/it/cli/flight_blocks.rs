//! Mistakes in `simulate` and `campaign`: errors for commands that fly, warnings for those that do not.

use super::*;

/// Blocks with a mistake of meaning, and its code.
const MISTAKES: [(&str, &str); 7] = [
    ("simulate { attitude_gain = 0 1/s^2 }", "mavc::simulate::not_positive"),
    ("simulate { fault nothing at 1 s }", "mavc::name::unknown"),
    ("simulate { rate = 60 Hz; control_rate = 60 Hz; estimator_rate = 60 Hz }", "mavc::simulate::coarse_step"),
    ("simulate { lost_yaw = 1 m }", "mavc::unit::mismatch"),
    ("simulate { }\nsimulate { }", "mavc::name::duplicate"),
    ("campaign { seeds = 0 }", "mavc::campaign::count"),
    ("simulate { sede = 1 }\ncampaign { planners = rap }", "mavc::campaign::choice"),
];

fn errors(text: &str) -> usize {
    text.lines().filter(|line| line.contains(": error")).count()
}

#[test]
#[ignore = "long"]
fn what_flies_nothing_warns_of_mistakes_in_how_it_is_flown() {
    let dir = folder();
    let (spec, traj) = (dir.path().join("hop.mav"), dir.path().join("traj.csv"));
    std::fs::write(&spec, HOP).unwrap();
    assert_eq!(code(&mavc(&["plan", "-v", text(&spec), "-o", text(&traj)])), 0);
    let due = std::fs::read(&traj).unwrap();
    for (block, mistake) in MISTAKES {
        std::fs::write(&spec, format!("{HOP}\n{block}\n")).unwrap();
        for command in ["plan", "compare", "analyze"] {
            let ran = mavc(&[command, text(&spec)]);
            assert_eq!(code(&ran), 0, "{command} {block}\n{}", err(&ran));
            assert!(err(&ran).contains(mistake), "{command} {block}\n{}", err(&ran));
            assert!(
                err(&ran).contains('\u{26a0}') && !err(&ran).contains('\u{d7}'),
                "{command} {block}\n{}",
                err(&ran)
            );
        }
        // The plan is the one of the spec without the block, and its certificate holds.
        let proof = dir.path().join("cert.json");
        let ran = mavc(&["plan", "-v", text(&spec), "-o", text(&traj), "--certificate", text(&proof), "--quiet"]);
        assert_eq!((code(&ran), err(&ran).as_str()), (0, ""), "{block}");
        assert_eq!(std::fs::read(&traj).unwrap(), due, "{block}");
        assert_eq!(code(&mavc(&["verify", text(&proof), text(&spec)])), 0, "{block}");
        for command in ["check", "simulate", "campaign"] {
            let ran = mavc(&[command, text(&spec)]);
            assert_eq!(code(&ran), 1, "{command} {block}");
            assert!((out(&ran) + &err(&ran)).contains(mistake), "{command} {block}\n{}", err(&ran));
        }
        let short = mavc(&["check", text(&spec), "--format", "short"]);
        assert!(errors(&out(&short)) >= 1, "{}", out(&short));
    }
}

#[test]
fn text_that_cannot_be_read_is_an_error_for_every_command() {
    let dir = folder();
    let spec = dir.path().join("hop.mav");
    for block in ["simulate { fault at }", "campaign { seeds == 3 }", "simulate { rate = 1 kHz"] {
        std::fs::write(&spec, format!("{HOP}\n{block}\n")).unwrap();
        for command in ["plan", "compare", "check", "simulate", "campaign"] {
            assert_eq!(code(&mavc(&[command, text(&spec)])), 1, "{command} {block}");
        }
    }
    // So is a mistake anywhere else.
    std::fs::write(&spec, format!("{HOP}\nlet unit = 3 +\nsimulate {{ seed = -1 }}\n")).unwrap();
    assert_eq!(code(&mavc(&["plan", "-v", text(&spec)])), 1);
}

/// What a block with mistakes would have used is not called unused.
#[test]
fn what_only_such_a_block_uses_is_not_called_unused() {
    let dir = folder();
    let spec = dir.path().join("hop.mav");
    let more = "let breeze = 3 m/s\nsimulate { seed = -1 }\nsimulate { wind = [breeze, 0 m/s, 0 m/s]; drag = 1 N*s/m }";
    std::fs::write(&spec, format!("{HOP}\n{more}\n")).unwrap();
    let ran = mavc(&["plan", "-v", text(&spec)]);
    assert_eq!(code(&ran), 0, "{}", err(&ran));
    assert!(!err(&ran).contains("unused"), "{}", err(&ran));
}
