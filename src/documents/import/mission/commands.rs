//! What is known of MAVLink's commands that a spec has no word for. Sources: `MAV_CMD` of common.xml and, from 42000,
//! ardupilotmega.xml of MAVLink.

/// What the flight loses where a command is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    /// Another flight: the command moves, stops or redirects the vehicle.
    Flight,
    /// The vehicle flies the same way.
    None,
    /// It depends on the autopilot, its parameters or its scripts.
    Unsure,
}

/// The effect of a command with its first parameter. Of `MAV_CMD_NAV_*` below the marker 95 all change the flight.
pub fn effect(command: u32, first: Option<f64>) -> Effect {
    let is_in = |list: &[(u32, &str)]| list.iter().any(|(number, _)| *number == command);
    match command {
        PARACHUTE if first == Some(RELEASE) => Effect::Flight,
        0..=94 | 5000..=5004 | 31000..=31004 => Effect::Flight,
        _ if is_in(FLIGHT) => Effect::Flight,
        _ if is_in(OTHERS) => Effect::None,
        _ => Effect::Unsure,
    }
}

/// `MAV_CMD_DO_PARACHUTE`, and its first parameter that releases it.
const PARACHUTE: u32 = 208;
const RELEASE: f64 = 2.0;

/// Corners and circles of fences, and the point to which a fence returns.
pub fn is_fence(command: f64) -> bool {
    (5000.0..=5004.0).contains(&command)
}

/// `MAV_CMD_NAV_RALLY_POINT`
pub fn is_rally_point(command: f64) -> bool {
    command == 5100.0
}

/// The name of a command, without `MAV_CMD_`.
pub fn name(command: u32) -> Option<&'static str> {
    let mut all = BELOW_95.iter().chain(FLIGHT).chain(OTHERS).chain(UNSURE);
    all.find(|(number, _)| *number == command).map(|(_, name)| *name)
}

/// Names of commands below the marker 95 that missions have often.
const BELOW_95: &[(u32, &str)] = &[
    (18, "NAV_LOITER_TURNS"),
    (23, "NAV_LAND_LOCAL"),
    (24, "NAV_TAKEOFF_LOCAL"),
    (25, "NAV_FOLLOW"),
    (30, "NAV_CONTINUE_AND_CHANGE_ALT"),
    (31, "NAV_LOITER_TO_ALT"),
    (80, "NAV_ROI"),
    (81, "NAV_PATHPLANNING"),
    (83, "NAV_ALTITUDE_WAIT"),
    (84, "NAV_VTOL_TAKEOFF"),
    (85, "NAV_VTOL_LAND"),
    (92, "NAV_GUIDED_ENABLE"),
    (94, "NAV_PAYLOAD_PLACE"),
];

/// Commands beyond 94 that change the flight.
const FLIGHT: &[(u32, &str)] = &[
    (113, "CONDITION_CHANGE_ALT"),
    (176, "DO_SET_MODE"),
    (177, "DO_JUMP"),
    (179, "DO_SET_HOME"),
    (185, "DO_FLIGHTTERMINATION"),
    (186, "DO_CHANGE_ALTITUDE"),
    (191, "DO_GO_AROUND"),
    (192, "DO_REPOSITION"),
    (193, "DO_PAUSE_CONTINUE"),
    (213, "NAV_SET_YAW_SPEED"),
    (224, "DO_SET_MISSION_CURRENT"),
    (252, "OVERRIDE_GOTO"),
    (300, "MISSION_START"),
    (400, "COMPONENT_ARM_DISARM"),
    (601, "DO_JUMP_TAG"),
    (3000, "DO_VTOL_TRANSITION"),
    (3001, "ARM_AUTHORIZATION_REQUEST"),
    (4501, "CONDITION_GATE"),
    (5000, "NAV_FENCE_RETURN_POINT"),
    (5001, "NAV_FENCE_POLYGON_VERTEX_INCLUSION"),
    (5002, "NAV_FENCE_POLYGON_VERTEX_EXCLUSION"),
    (5003, "NAV_FENCE_CIRCLE_INCLUSION"),
    (5004, "NAV_FENCE_CIRCLE_EXCLUSION"),
    (42702, "NAV_SCRIPT_TIME"),
    (42703, "NAV_ATTITUDE_TIME"),
    (43000, "GUIDED_CHANGE_SPEED"),
    (43001, "GUIDED_CHANGE_ALTITUDE"),
    (43002, "GUIDED_CHANGE_HEADING"),
];

/// Commands without an effect on where the vehicle flies. Conditions delay only commands of this list.
const OTHERS: &[(u32, &str)] = &[
    (112, "CONDITION_DELAY"),
    (114, "CONDITION_DISTANCE"),
    (115, "CONDITION_YAW"),
    (181, "DO_SET_RELAY"),
    (182, "DO_REPEAT_RELAY"),
    (183, "DO_SET_SERVO"),
    (184, "DO_REPEAT_SERVO"),
    (187, "DO_SET_ACTUATOR"),
    (188, "DO_RETURN_PATH_START"),
    (189, "DO_LAND_START"),
    (195, "DO_SET_ROI_LOCATION"),
    (196, "DO_SET_ROI_WPNEXT_OFFSET"),
    (197, "DO_SET_ROI_NONE"),
    (198, "DO_SET_ROI_SYSID"),
    (200, "DO_CONTROL_VIDEO"),
    (201, "DO_SET_ROI"),
    (202, "DO_DIGICAM_CONFIGURE"),
    (203, "DO_DIGICAM_CONTROL"),
    (204, "DO_MOUNT_CONFIGURE"),
    (205, "DO_MOUNT_CONTROL"),
    (206, "DO_SET_CAM_TRIGG_DIST"),
    (PARACHUTE, "DO_PARACHUTE"),
    (211, "DO_GRIPPER"),
    (214, "DO_SET_CAM_TRIGG_INTERVAL"),
    (216, "DO_SPRAYER"),
    (220, "DO_MOUNT_CONTROL_QUAT"),
    (530, "SET_CAMERA_MODE"),
    (531, "SET_CAMERA_ZOOM"),
    (532, "SET_CAMERA_FOCUS"),
    (534, "SET_CAMERA_SOURCE"),
    (600, "JUMP_TAG"),
    (1000, "DO_GIMBAL_MANAGER_PITCHYAW"),
    (1001, "DO_GIMBAL_MANAGER_CONFIGURE"),
    (2000, "IMAGE_START_CAPTURE"),
    (2001, "IMAGE_STOP_CAPTURE"),
    (2003, "DO_TRIGGER_CONTROL"),
    (2500, "VIDEO_START_CAPTURE"),
    (2501, "VIDEO_STOP_CAPTURE"),
    (5100, "NAV_RALLY_POINT"),
    (42600, "DO_WINCH"),
];

/// Names of commands that may do anything: auxiliary functions of ArduPilot change modes, scripts fly.
const UNSURE: &[(u32, &str)] = &[
    (180, "DO_SET_PARAMETER"),
    (207, "DO_FENCE_ENABLE"),
    (210, "DO_INVERTED_FLIGHT"),
    (212, "DO_AUTOTUNE_ENABLE"),
    (215, "DO_SET_RESUME_REPEAT_DIST"),
    (217, "DO_SEND_SCRIPT_MESSAGE"),
    (218, "DO_AUX_FUNCTION"),
    (222, "DO_GUIDED_LIMITS"),
    (223, "DO_ENGINE_CONTROL"),
];
