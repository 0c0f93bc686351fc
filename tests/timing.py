"""Writes tests/timing.json: paths with the durations that toppra and ruckig find for them; with a number, that many
times as many paths. pip install toppra ruckig"""
import json, math, sys
from importlib.metadata import version
import numpy as np, toppra, toppra.algorithm, toppra.constraint
from ruckig import InputParameter, Result, Ruckig, Synchronization, Trajectory

toppra.setup_logging("ERROR")
rng = np.random.default_rng(3)
GRID = 400  # intervals of a piece

class Blended(toppra.interpolator.AbstractGeometricPath):
    """Edges and parabolas, by the length along edges: a blend that begins d before its corner is 2 d long."""
    def __init__(self, path, shares):
        self.pieces, self.at, s = [], [0.0], 0.0
        steps = np.diff(path, axis=0)
        for i, step in enumerate(steps):
            begin = shares[i - 1][1] if i else 0.0
            end = 1.0 - (shares[i][0] if i < len(shares) else 0.0)
            length, part = np.linalg.norm(step), end - begin
            if part > 1e-9:
                self.add(path[i] + begin * step, part * step, 0 * step, part * length)
            if i < len(shares):
                u, v = -shares[i][0] * step, shares[i][1] * steps[i + 1]
                self.add(path[i + 1] + u, -2 * u, u + v, 2 * shares[i][0] * length)
    def add(self, start, rate, bend, length):
        self.pieces.append((start, rate, bend, length)); self.at.append(self.at[-1] + length)
    @property
    def dof(self): return len(self.pieces[0][0])
    @property
    def path_interval(self): return np.array([0.0, self.at[-1]])
    @property
    def waypoints(self): return None
    def __call__(self, s, order=0):
        if np.ndim(s): return np.array([self(x, order) for x in s])
        i = min(max(np.searchsorted(self.at, s, side="right") - 1, 0), len(self.pieces) - 1)
        start, rate, bend, length = self.pieces[i]
        u = (s - self.at[i]) / length
        return [start + u * rate + u * u * bend, (rate + 2 * u * bend) / length, 2 * bend / length**2][order]

def timed(path, shares, speed, acceleration):
    geometric = Blended(path, shares)
    grid = np.concatenate([[0.0]] + [np.linspace(a, b, GRID + 1)[1:] for a, b in zip(geometric.at, geometric.at[1:])])
    limits = [np.column_stack([-x, x]) for x in (speed, acceleration)]
    scheme = toppra.constraint.DiscretizationType.Interpolation
    constraints = [toppra.constraint.JointVelocityConstraint(limits[0]),
                   toppra.constraint.JointAccelerationConstraint(limits[1], discretization_scheme=scheme)]
    _, rates, _ = toppra.algorithm.TOPPRA(constraints, geometric, gridpoints=grid, solver_wrapper="seidel").compute_parameterization(0, 0)
    return float(np.sum(2 * np.diff(grid) / (rates[1:] + rates[:-1])))

def moved(a, b, speed, acceleration):
    n = len(a); otg, wanted, found = Ruckig(n), InputParameter(n), Trajectory(n)
    wanted.current_position, wanted.target_position = list(a), list(b)
    wanted.max_velocity, wanted.max_acceleration, wanted.max_jerk = list(speed), list(acceleration), [math.inf] * n
    wanted.synchronization = Synchronization.Phase  # the straight line between both
    assert otg.calculate(wanted, found) in (Result.Working, Result.Finished)
    for share in (0.3, 0.7):
        at = np.array(found.at_time(share * found.duration)[0]) - a
        if np.linalg.norm(at - (at @ (b - a)) / ((b - a) @ (b - a)) * (b - a)) > 1e-9:
            return None  # Synchronised in time alone, it leaves the line: another problem.
    return found.duration

def limits(n): return [np.round(np.exp(rng.uniform(-1.5, 1.5, n)), 3) for _ in range(2)]
def listed(x): return [float(v) for v in x]

out = {"toppra": version("toppra"), "ruckig": version("ruckig"), "blended": [], "straight": []}
times = int(sys.argv[1]) if len(sys.argv) > 1 else 1
for n in [2, 2, 2, 3, 3, 3, 4, 5, 6, 6, 8, 8] * times:
    path = np.round(rng.uniform(-1.4, 1.4, (int(rng.integers(3, 8)), n)), 3)
    lengths = np.linalg.norm(np.diff(path, axis=0), axis=1)
    most = rng.uniform(0.05, 0.5)
    shares = [[most * min(a, b) / a, most * min(a, b) / b] for a, b in zip(lengths, lengths[1:])]
    speed, acceleration = limits(n)
    out["blended"].append({"path": [listed(q) for q in path], "blends": [listed(s) for s in shares], "speed": listed(speed),
                           "acceleration": listed(acceleration), "duration": timed(path, shares, speed, acceleration)})
for n in [1, 2, 3, 3, 4, 6, 7, 8] * times:
    duration = None
    while duration is None:
        a, b = np.round(rng.uniform(-1.5, 1.5, (2, n)), 3)
        speed, acceleration = limits(n)
        duration = moved(a, b, speed, acceleration)
    out["straight"].append({"path": [listed(a), listed(b)], "speed": listed(speed), "acceleration": listed(acceleration),
                            "duration": duration})
with open("tests/timing.json", "w") as file:
    lines = [f'"{key}": ' + (json.dumps(value) if isinstance(value, str) else
             "[\n" + ",\n".join(json.dumps(case) for case in value) + "\n]") for key, value in out.items()]
    file.write("{\n" + ",\n".join(lines) + "\n}\n")
