"""Simulators: RotorPy flies the plan, gym-pybullet-drones takes its targets, and MuJoCo's inverse dynamics says which wrench the motion
of `rows` takes."""

import contextlib
import importlib.util
import io
import os
import sys
import warnings

import mujoco
import numpy as np
from exact import columns, rotation
from tables import GRAVITY, MAX, VECTORS, stack


def module(path, name):
    """A written module, imported."""
    spec = importlib.util.spec_from_file_location(name, path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


def rotorpy(plan):
    from rotorpy.controllers.quadrotor_control import SE3Control
    from rotorpy.environments import Environment
    from rotorpy.vehicles.crazyflie_params import quad_params
    from rotorpy.vehicles.multirotor import Multirotor

    trajectory = module(plan.write("planned.py", "--format", "rotorpy"), "planned").PlannedTrajectory()
    times = np.linspace(0, plan.exact.times[-1], 500)[:-1]
    flat = [trajectory.update(t) for t in times]
    for order, key in enumerate(("x", "x_dot", "x_ddot", "x_dddot")):
        yield "rotorpy", key, MAX(np.array([f[key] for f in flat]) - plan.exact.at(times, order)[:, :3]), 1e-9
    for order, key in enumerate(("yaw", "yaw_dot")):
        yield "rotorpy", key, MAX(np.array([f[key] for f in flat]) - plan.exact.at(times, order)[:, 3]), 1e-9
    # RotorPy's own vehicle and controller, which asks for the end of the flight by an infinite time.
    start = plan.exact.at([0], 0)[0]
    zeros = np.zeros(3)
    attitude = np.array([0, 0, np.sin(start[3] / 2), np.cos(start[3] / 2)])
    hover = np.sqrt(quad_params["mass"] * GRAVITY / 4 / quad_params["k_eta"])
    state = {"x": start[:3], "v": zeros, "q": attitude, "w": zeros, "wind": zeros, "rotor_speeds": np.full(4, hover)}
    environment = Environment(Multirotor(quad_params, initial_state=state), SE3Control(quad_params), trajectory, sim_rate=100)
    flown = environment.run(t_final=plan.exact.times[-1], use_mocap=False, terminate=False, verbose=False, plot=False)
    error = np.linalg.norm(flown["state"]["x"] - plan.exact.at(flown["time"], 0)[:, :3], axis=1)
    yield "rotorpy, Environment.run", "flown: position, m", float(np.max(error)), 0.5


def gym_pybullet_drones(plan):
    targets = module(plan.write("targets.py", "--format", "gym-pybullet-drones"), "targets")
    times = np.arange(targets.NUM_WP) / targets.CONTROL_FREQ_HZ
    exact = plan.exact.at(times, 0)
    yield "gym-pybullet-drones, numpy", "TARGET_POS", MAX(targets.TARGET_POS - exact[:, :3]), 1e-9
    yield "gym-pybullet-drones, numpy", "TARGET_VEL", MAX(targets.TARGET_VEL - plan.exact.at(times, 1)[:, :3]), 1e-9
    roll, pitch, yaw = targets.TARGET_RPY.T
    (cr, sr), (cp, sp), (cy, sy) = ((np.cos(a), np.sin(a)) for a in (roll, pitch, yaw))
    third = np.stack([cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr], axis=1)
    yield "gym-pybullet-drones, numpy", "TARGET_RPY", MAX(third - plan.exact.attitude(times, GRAVITY)[:, :, 2]), 1e-9
    yield "gym-pybullet-drones, numpy", "yaw", MAX(yaw - exact[:, 3]), 1e-9
    clone = os.environ.get("GYM_PYBULLET_DRONES")
    if clone:
        sys.path.insert(0, clone)
        # Its environment prints the parameters of its drone.
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings(action="ignore"):
            worst = flown(targets)
        yield "gym-pybullet-drones, CtrlAviary", "flown: position, m", worst, 1.0


def flown(targets):
    """The largest distance from the targets of a Crazyflie in the package's own simulation, as its example pid.py flies."""
    from gym_pybullet_drones.control.DSLPIDControl import DSLPIDControl
    from gym_pybullet_drones.envs.CtrlAviary import CtrlAviary
    from gym_pybullet_drones.utils.enums import DroneModel, Physics

    rate = targets.CONTROL_FREQ_HZ
    env = CtrlAviary(drone_model=DroneModel.CF2X, num_drones=1, initial_xyzs=targets.INIT_XYZS, initial_rpys=targets.INIT_RPYS,
                     physics=Physics.PYB, pyb_freq=5 * rate, ctrl_freq=rate, gui=False)
    control, action, worst = DSLPIDControl(drone_model=DroneModel.CF2X), np.zeros((1, 4)), 0.0
    env.reset()
    for i in range(targets.NUM_WP):
        observed, *_ = env.step(action)
        worst = max(worst, np.linalg.norm(observed[0][:3] - targets.TARGET_POS[i]))
        action[0, :], _, _ = control.computeControlFromState(control_timestep=env.CTRL_TIMESTEP, state=observed[0], **targets.target(i))
    env.close()
    return float(worst)


def mujoco_inverse(plan):
    """Force and torque that the motion takes by MuJoCo: along the body's z axis the written thrust, across it nothing."""
    model = mujoco.MjModel.from_xml_string(plan.run("emit", "mjcf", plan.spec).stdout)
    data = mujoco.MjData(model)
    table = columns(plan.write("rows.csv", "--format", "rows", "--rate", "20Hz"))
    attitudes = rotation(stack(table, ("qw", "qx", "qy", "qz")))
    wrench = []
    for i in range(len(table["t"])):
        data.qpos[:3] = [table[a][i] for a in "xyz"]
        data.qpos[3:] = [table[q][i] for q in ("qw", "qx", "qy", "qz")]
        data.qvel[:3] = [table[a][i] for a in VECTORS["velocity"]]
        data.qvel[3:] = [table[a][i] for a in "pqr"]
        data.qacc[:3] = [table[a][i] for a in VECTORS["acceleration"]]
        data.qacc[3:] = 0
        mujoco.mj_inverse(model, data)
        wrench.append(attitudes[i].T @ data.qfrc_inverse[:3])
    wrench = np.array(wrench)
    yield "rows, mujoco mj_inverse", "force across z, N", MAX(wrench[:, :2]), 1e-6
    yield "rows, mujoco mj_inverse", "thrust, N", MAX(wrench[:, 2] - table["thrust"]), 1e-6
    most = np.sum(model.actuator_ctrlrange[:, 1])
    yield "rows, mujoco mj_inverse", "share of all rotors' most", MAX(table["thrust"] / most - table["thrust_share"]), 1e-9


CHECKS = [rotorpy, gym_pybullet_drones, mujoco_inverse]
