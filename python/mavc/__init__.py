"""mavc: a compiler of multirotor missions that must survive rotor faults.

`compile` makes a `Spec` from a text or a file, `Vehicle` and `Mission` make one from values. A spec analyses, plans, simulates
and flies campaigns; `sweep` maps many specs. docs/python.md has a tour.
"""

from . import _mavc
from .builder import FaultMode, KeepOff, LandingSite, Mission, Rotor, Vehicle, Volume, Waypoint, build
from .errors import (
    BuildError,
    Cancelled,
    Diagnostic,
    Diagnostics,
    Fix,
    InternalError,
    Label,
    Place,
    Problem,
    Rejected,
    SpecError,
    SpecWarning,
)
from .exports import Exported
from .imports import Imported, import_mission, import_vehicle
from .layouts import rings
from .logs import Diagnosis, Figure, Identified, diagnose, identify
from .results import Analysis, Campaign, Log, Mode, Plan, Simulation, Trajectory
from .runs import Cancel, Progress
from .spec import Spec, Verification, compile, format, new
from .sweeps import Sweep, sweep
from .table import Rows, Table

__version__ = _mavc.VERSION
__all__ = [
    "Analysis",
    "BuildError",
    "Campaign",
    "Cancel",
    "Cancelled",
    "Diagnosis",
    "Diagnostic",
    "Diagnostics",
    "Exported",
    "FaultMode",
    "Figure",
    "Fix",
    "Identified",
    "Imported",
    "InternalError",
    "KeepOff",
    "Label",
    "LandingSite",
    "Log",
    "Mission",
    "Mode",
    "Place",
    "Plan",
    "Problem",
    "Progress",
    "Rejected",
    "Rotor",
    "Rows",
    "Simulation",
    "Spec",
    "SpecError",
    "SpecWarning",
    "Sweep",
    "Table",
    "Trajectory",
    "Vehicle",
    "Verification",
    "Volume",
    "Waypoint",
    "build",
    "compile",
    "diagnose",
    "format",
    "identify",
    "import_mission",
    "import_vehicle",
    "new",
    "rings",
    "sweep",
]
