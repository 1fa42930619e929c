//! The motor tables of ArduPilot's frames, by `FRAME_CLASS` and `FRAME_TYPE`: where each motor is and how its propeller
//! turns, in the order of the motors' numbers. Source: ArduPilot's documentation, "Connect ESCs and Motors", and
//! `AP_Motors_test.json` of its library test, against which `benches/readers/vehicles.py` checks every row.

/// A frame.
pub struct Frame {
    pub class: u32,
    pub kind: u32,
    pub name: &'static str,
    pub motors: Motors,
}

/// Where the motors are. `P` turns counter-clockwise seen from above, `N` clockwise.
pub enum Motors {
    /// On a circle: angles in degrees clockwise from the nose, each with its spin.
    Ring(&'static str),
    /// Forward and to the left, in shares of one length, each with its spin.
    Places(&'static str),
    /// Why a spec cannot say it.
    No(&'static str),
}

use Motors::{No, Places, Ring};

const fn frame(class: u32, kind: u32, name: &'static str, motors: Motors) -> Frame {
    Frame { class, kind, name, motors }
}

const TAIL: Motors = No("its tail motors are tilted, and a spec has upright axes only");
const NO_YAW: Motors = No("its propellers do not hold the yaw, which vanes do");
const Y6: Motors = Ring("60P -60N -60P 180N 60N 180P");
const OCTAQUAD_X: Motors = Ring("45P -45N -135P 135N -45P 45N 135P -135N");
const DECA_X: Motors = Ring("18P 54N 90P 126N 162P -162N -126P -90N -54P -18N");

/// Every frame of the table.
pub const FRAMES: &[Frame] = &[
    frame(1, 0, "quad +", Ring("90P -90P 0N 180N")),
    frame(1, 1, "quad X", Ring("45P -135P -45N 135N")),
    frame(1, 2, "quad V", Ring("45P -135P -45N 135N")),
    frame(1, 3, "quad H", Ring("45N -135N -45P 135P")),
    frame(1, 4, "quad V-tail", TAIL),
    frame(1, 5, "quad A-tail", TAIL),
    frame(1, 6, "quad + reversed", Ring("90N -90N 0P 180P")),
    frame(1, 12, "quad X, Betaflight's order", Ring("135N 45P -135P -45N")),
    frame(1, 13, "quad X, DJI's order", Ring("45P -45N -135P 135N")),
    frame(1, 14, "quad X, clockwise order", Ring("45P 135N -135P -45N")),
    frame(1, 16, "quad + without yaw by torque", NO_YAW),
    frame(1, 17, "quad X without yaw by torque", NO_YAW),
    frame(1, 18, "quad X, Betaflight's order reversed", Ring("135P 45N -135N -45P")),
    frame(1, 19, "quad Y4", Places("1,-1P -1,0N -1,0P 1,1N")),
    frame(2, 0, "hexa +", Ring("0N 180P -120N 60P -60P 120N")),
    frame(2, 1, "hexa X", Ring("90N -90P -30N 150P 30P -150N")),
    frame(2, 3, "hexa H", Places("0,-1N 0,1P 1,1N -1,-1P 1,-1P -1,1N")),
    frame(2, 13, "hexa X, DJI's order", Ring("30P -30N -90P -150N 150P 90N")),
    frame(2, 14, "hexa X, clockwise order", Ring("30P 90N 150P -150N -90P -30N")),
    frame(3, 0, "octa +", Ring("0N 180N 45P 135P -45P -135P -90N 90N")),
    frame(3, 1, "octa X", Ring("22.5N -157.5N 67.5P 157.5P -22.5P -112.5P -67.5N 112.5N")),
    frame(3, 2, "octa V", Places("0.34,0.83N -0.32,-0.67N -0.32,0.67P -1,-0.5P 1,1P 0.34,-0.83P 1,-1N -1,0.5N")),
    frame(3, 3, "octa H", Places("1,-1N -1,1N 0.333,-1P -1,-1P 1,1P -0.333,1P 0.333,1N -0.333,-1N")),
    frame(3, 13, "octa X, DJI's order", Ring("22.5P -22.5N -67.5P -112.5N -157.5P 157.5N 112.5P 67.5N")),
    frame(3, 14, "octa X, clockwise order", Ring("22.5P 67.5N 112.5P 157.5N -157.5P -112.5N -67.5P -22.5N")),
    frame(3, 15, "octa I", Places("-1,0.333N 1,-0.333N -1,1P 1,0.333P -1,-0.333P 1,-1P -1,-1N 1,1N")),
    frame(4, 0, "octa quad +", Ring("0P -90N 180P 90N -90P 0N 90P 180N")),
    frame(4, 1, "octa quad X", OCTAQUAD_X),
    frame(4, 2, "octa quad V", OCTAQUAD_X),
    frame(4, 3, "octa quad H", Ring("45N -45P -135N 135P -45N 45P 135N -135P")),
    frame(4, 12, "octa quad X, Betaflight's order", Ring("135N 45P -135P -45N 135P 45N -135N -45P")),
    frame(4, 14, "octa quad X, clockwise order", Ring("45P 45N 135N 135P -135P -135N -45N -45P")),
    frame(4, 18, "octa quad X, Betaflight's order reversed", Ring("135P 45N -135N -45P 135N 45P -135P -45N")),
    frame(4, 20, "octa quad X, co-rotating", Ring("45P -45N -135P 135N -45N 45P 135N -135P")),
    frame(4, 21, "octa quad X, co-rotating, clockwise order", Ring("45P 45P 135N 135N -135P -135P -45N -45N")),
    frame(5, 0, "Y6", Y6),
    frame(5, 1, "Y6", Y6),
    frame(5, 10, "Y6B", Ring("60N 60P 180N 180P -60N -60P")),
    frame(5, 11, "Y6F", Ring("180P 60P -60P 180N 60N -60N")),
    frame(12, 0, "dodeca hexa +", Ring("0P 0N 60N 60P 120P 120N 180N 180P -120P -120N -60N -60P")),
    frame(12, 1, "dodeca hexa X", Ring("30P 30N 90N 90P 150P 150N -150N -150P -90P -90N -30N -30P")),
    frame(14, 0, "deca +", Ring("0P 36N 72P 108N 144P 180N -144P -108N -72P -36N")),
    frame(14, 1, "deca X", DECA_X),
    frame(14, 14, "deca X", DECA_X),
];

/// Classes that are not a multirotor of a spec, and what they are.
pub const OTHER_CLASSES: [(u32, &str); 11] = [
    (0, "not set: the frame was never chosen"),
    (6, "a helicopter"),
    (7, "a tricopter, whose tail tilts"),
    (8, "a single copter"),
    (9, "a coaxial copter"),
    (10, "a bicopter"),
    (11, "a helicopter"),
    (13, "a helicopter"),
    (15, "a matrix that a script on the autopilot defines"),
    (16, "a vehicle of six degrees of freedom, whose matrix a script on the autopilot defines"),
    (17, "a matrix that a script on the autopilot changes in flight"),
];
