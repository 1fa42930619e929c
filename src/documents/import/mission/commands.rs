//! What is known of MAVLink's commands that a spec has no word for (`MAV_CMD`, common.xml).

/// Whether leaving a command out would change the flight: `MAV_CMD_NAV_*` below the marker 95 without the region of
/// interest 80, fences and rally points, jumps, modes, a new home, and those that stop or redirect a mission.
pub fn is_flight(command: u32) -> bool {
    command <= 94 && command != 80
        || matches!(command, 176 | 177 | 179 | 185 | 192 | 193 | 213 | 252 | 300 | 3000 | 3001 | 4501 | 5000..=5004)
}

/// The name of a command, without `MAV_CMD_`.
pub fn name(command: u32) -> Option<&'static str> {
    NAMES.iter().find(|(number, _)| *number == command).map(|(_, name)| *name)
}

/// Names of commands that missions have often (common.xml of MAVLink).
const NAMES: &[(u32, &str)] = &[
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
    (112, "CONDITION_DELAY"),
    (114, "CONDITION_DISTANCE"),
    (115, "CONDITION_YAW"),
    (176, "DO_SET_MODE"),
    (177, "DO_JUMP"),
    (179, "DO_SET_HOME"),
    (181, "DO_SET_RELAY"),
    (183, "DO_SET_SERVO"),
    (189, "DO_LAND_START"),
    (192, "DO_REPOSITION"),
    (193, "DO_PAUSE_CONTINUE"),
    (195, "DO_SET_ROI_LOCATION"),
    (197, "DO_SET_ROI_NONE"),
    (201, "DO_SET_ROI"),
    (203, "DO_DIGICAM_CONTROL"),
    (205, "DO_MOUNT_CONTROL"),
    (206, "DO_SET_CAM_TRIGG_DIST"),
    (211, "DO_GRIPPER"),
    (213, "NAV_SET_YAW_SPEED"),
    (530, "SET_CAMERA_MODE"),
    (531, "SET_CAMERA_ZOOM"),
    (1000, "DO_GIMBAL_MANAGER_PITCHYAW"),
    (2000, "IMAGE_START_CAPTURE"),
    (2001, "IMAGE_STOP_CAPTURE"),
    (2500, "VIDEO_START_CAPTURE"),
    (2501, "VIDEO_STOP_CAPTURE"),
    (3000, "DO_VTOL_TRANSITION"),
];
