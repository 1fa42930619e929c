"""A PLAN

Targets at the control rate for gym-pybullet-drones: World x east, y north, z up; SI units.

    import plan
    env = CtrlAviary(initial_xyzs=plan.INIT_XYZS, initial_rpys=plan.INIT_RPYS, ctrl_freq=plan.CONTROL_FREQ_HZ, ...)
    for i in range(plan.NUM_WP):
        obs, *_ = env.step(action)
        action[0, :], _, _ = ctrl.computeControlFromState(
            control_timestep=env.CTRL_TIMESTEP, state=obs[0], **plan.target(i))

The environment needs a whole number of physics steps in a control step: pyb_freq is a multiple of CONTROL_FREQ_HZ.
"""
import numpy as np

# x, y, z (m); roll, pitch, yaw of a vehicle that follows the plan exactly (rad); velocity (m/s); yaw rate (rad/s).
CONTROL_FREQ_HZ, ROWS = 48, []  # the plan

_ROWS = np.array(ROWS).reshape(-1, 10)
NUM_WP = len(_ROWS)
TARGET_POS, TARGET_RPY, TARGET_VEL = _ROWS[:, 0:3], _ROWS[:, 3:6], _ROWS[:, 6:9]
# The start of the plan for one drone.
INIT_XYZS, INIT_RPYS = TARGET_POS[:1].copy(), TARGET_RPY[:1].copy()


def target(i):
    """The targets of control step i, which stay those of the end after it. The controller chooses roll and pitch itself."""
    i = min(i, NUM_WP - 1)
    return {
        "target_pos": TARGET_POS[i],
        "target_rpy": np.array([0.0, 0.0, TARGET_RPY[i, 2]]),
        "target_vel": TARGET_VEL[i],
    }
