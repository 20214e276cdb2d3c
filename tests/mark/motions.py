"""Motions in floats by formulas of their own, against which marks are judged.

Vectors have space components, rates are differences in time: nothing here comes from the engine.
"""

import math
import random
from itertools import pairwise

import numpy as np
import sympy

from rigidtop.proof.equation import Cross, Dot, Group, Partial, Rate, Transposed, Underbrace
from rigidtop.theory import symbols as s

STEP = 1e-4


def rz(angle):
    c, n = math.cos(angle), math.sin(angle)
    return np.array([[c, -n, 0], [n, c, 0], [0, 0, 1.0]])


def ry(angle):
    c, n = math.cos(angle), math.sin(angle)
    return np.array([[c, 0, n], [0, 1.0, 0], [-n, 0, c]])


class Top:
    """A top at time t near 0; `steady` at constant θ."""

    def __init__(self, rng, steady=False):
        self.l1, self.l3 = rng.uniform(1, 2), rng.uniform(0.5, 1.5)
        self.M, self.g, self.R = (rng.uniform(0.5, 2) for _ in range(3))
        self.angles = np.array([rng.uniform(0.3, 1.2), rng.uniform(0, 6), rng.uniform(0, 6)])
        self.rates = np.array([rng.uniform(-2, 2) for _ in range(3)])
        if steady:
            c = math.cos(self.angles[0])
            Omega = rng.choice([-1, 1]) * rng.uniform(0.3, 2)
            spin = (self.l1 * c * Omega**2 + self.M * self.g * self.R) / (self.l3 * Omega)
            self.rates = np.array([0, Omega, spin - Omega * c])
        th, (td, pd, sd) = self.angles[0], self.rates
        c, n = math.cos(th), math.sin(th)
        w3 = sd + pd * c
        tdd = (self.l1 * pd**2 * c - self.l3 * w3 * pd + self.M * self.g * self.R) * n / self.l1
        pdd = (self.l3 * w3 * td - 2 * self.l1 * pd * td * c) / (self.l1 * n)
        self.accelerations = np.array([tdd, pdd, -pdd * c + pd * td * n])

    def values(self, t=0.0):
        th, ph, ps = self.angles + self.rates * t + self.accelerations * t**2 / 2
        td, pd, sd = self.rates + self.accelerations * t
        c, n = math.cos(th), math.sin(th)
        primed = rz(ph) @ ry(th)
        body = primed @ rz(ps)
        along = np.array([-pd * n, td, sd + pd * c])
        moments = np.array([self.l1, self.l1, self.l3])
        L = primed @ (moments * along)
        V = self.M * self.g * self.R * c
        T = (moments * along**2).sum() / 2
        z = np.array([0, 0, 1.0])
        return {
            "lambda1": self.l1, "lambda2": self.l1, "lambda3": self.l3,
            "M": self.M, "g": self.g, "R": self.R,
            "theta": th, "phi": ph, "psi": ps, "thetadot": td, "phidot": pd, "psidot": sd,
            "thetaddot": self.accelerations[0], "phiddot": self.accelerations[1],
            "psiddot": self.accelerations[2],
            "omega1p": along[0], "omega2p": along[1], "omega3": along[2], "Omega": pd,
            "L3": self.l3 * along[2], "L_z": L[2], "p_psi": self.l3 * along[2],
            "p_phi": self.l1 * pd * n**2 + self.l3 * along[2] * c, "p_theta": self.l1 * td,
            "omega1": (body.T @ primed @ along)[0], "omega2": (body.T @ primed @ along)[1],
            "T": T, "V": V, "E": T + V, "Lagrangian": T - V,
            "e1p": primed[:, 0], "e2p": primed[:, 1], "e3": primed[:, 2],
            "xhat": np.array([1.0, 0, 0]), "yhat": np.array([0, 1.0, 0]), "zhat": z,
            "omega_vec": primed @ along, "L_vec": L,
            "dL_dphi": 0.0, "dL_dpsi": 0.0,
            "dL_dtheta": self.l1 * pd**2 * n * c - self.l3 * along[2] * pd * n
            + self.M * self.g * self.R * n,
            "dL_dthetadot": self.l1 * td,
            "dL_dphidot": self.l1 * pd * n**2 + self.l3 * along[2] * c,
            "dL_dpsidot": self.l3 * along[2],
            "p_thetadot": self.l1 * self.accelerations[0], "p_phidot": 0.0, "p_psidot": 0.0,
        }  # fmt: skip


class Free:
    """A symmetric body without torque."""

    def __init__(self, rng):
        self.l = np.array([rng.uniform(1, 2), rng.uniform(1, 2), rng.uniform(0.8, 1.8)])
        self.l[1] = self.l[0]
        self.w = np.array([rng.uniform(-2, 2) for _ in range(3)])

    def flow(self, w):
        a, b, c = self.l
        return np.array(
            [(b - c) * w[1] * w[2] / a, (c - a) * w[2] * w[0] / b, (a - b) * w[0] * w[1] / c]
        )

    def values(self, t=0.0):
        frequency = (self.l[0] - self.l[2]) * self.w[2] / self.l[0]
        w = self.w + self.flow(self.w) * t
        wd = self.flow(w)
        wdd = (self.flow(w + STEP * wd) - self.flow(w - STEP * wd)) / (2 * STEP)
        L = self.l * w
        made = {f"lambda{k + 1}": self.l[k] for k in range(3)}
        made |= {f"omega{k + 1}": w[k] for k in range(3)}
        made |= {f"omega{k + 1}dot": wd[k] for k in range(3)}
        made |= {f"omega{k + 1}ddot": wdd[k] for k in range(2)}
        made |= {f"L{k + 1}": L[k] for k in range(3)}
        return made | {
            "Omega_b": frequency, "t": t, "omega_vec": w, "L_vec": L, "T": w @ L / 2,
        }  # fmt: skip


class Picture:
    """3.5.2."""

    def __init__(self, rng):
        self.numbers = {x: rng.uniform(0.5, 2) for x in ("M", "g", "R", "lambda3", "omega3")}
        self.theta, self.phi = rng.uniform(0.3, 1.2), rng.uniform(0, 6)

    def values(self, t=0.0):
        n = self.numbers
        rate = n["M"] * n["g"] * n["R"] / (n["lambda3"] * n["omega3"])
        phi = self.phi + rate * t
        sine = math.sin(self.theta)
        e3 = np.array([sine * math.cos(phi), sine * math.sin(phi), math.cos(self.theta)])
        z = np.array([0, 0, 1.0])
        torque = np.cross(n["R"] * e3, -n["M"] * n["g"] * z)
        return {
            **n, "theta": self.theta, "phi": phi, "phidot": rate, "Omega": rate,
            "e3": e3, "zhat": z, "e3dot": rate * np.cross(z, e3), "Omega_vec": rate * z,
            "xhat": np.array([1.0, 0, 0]), "yhat": np.array([0, 1.0, 0]),
            "R_CM": n["R"] * e3, "g_vec": -n["g"] * z, "N_vec": torque, "L_vecdot": torque,
            "L_vec": n["lambda3"] * n["omega3"] * e3,
        }  # fmt: skip


class Components:
    """3.2.1."""

    def __init__(self, rng):
        self.O = rz(rng.uniform(0, 6)) @ ry(rng.uniform(0.3, 2)) @ rz(rng.uniform(0, 6))
        self.r = np.array([rng.uniform(-2, 2) for _ in range(3)])

    def values(self, t=0.0):
        return {"O_matrix": self.O, "unit": np.eye(3), "r_vecp": self.r, "r_vec": self.O @ self.r}


def motions(start, goal, count=8):
    """Motions that the facts between two equations allow."""
    rng = random.Random(11)
    make = {
        "3.46": Components,
        "3.52": Picture,
        "3.37": Free,
        "3.57": lambda rng: Top(rng, steady=True),
    }.get(goal, Top)
    return [make(rng) for _ in range(count)]


def number(node, motion, t=0.0, own=None):
    """A typed tree at a time."""
    values = {**motion.values(t), **(own or {})}

    def at(node):
        if isinstance(node, sympy.MatrixBase):
            entries = [at(e) for e in node]
            return np.array(entries) if 1 in node.shape else np.array(entries).reshape(node.shape)
        if isinstance(node, sympy.Symbol):
            return values[node.name]
        if isinstance(node, (Group, Underbrace)):
            return at(node.args[0])
        if isinstance(node, Cross):
            return np.cross(at(node.args[0]), at(node.args[1]))
        if isinstance(node, Dot):
            return at(node.args[0]) @ at(node.args[1])
        if isinstance(node, Transposed):
            return at(node.args[0]).T
        if isinstance(node, Partial):
            return values[f"dL_d{node.args[1].name}"]
        if isinstance(node, Rate):
            return rate(node.args[0], motion)
        if isinstance(node, sympy.Add):
            return sum((at(e) for e in node.args[1:]), start=at(node.args[0]))
        if isinstance(node, sympy.Mul):
            made = at(node.args[0])
            for factor in node.args[1:]:
                other = at(factor)
                both = np.ndim(made) == 2 and np.ndim(other) >= 1
                made = made @ other if both else made * other
            return made
        if isinstance(node, sympy.Pow):
            base, exponent = at(node.base), float(node.exp)
            if np.ndim(base) == 2:
                return np.linalg.matrix_power(base, int(exponent))
            return base**exponent
        if isinstance(node, (sympy.sin, sympy.cos)):
            return (math.sin if isinstance(node, sympy.sin) else math.cos)(at(node.args[0]))
        return float(node)

    return at(node)


def rate(node, motion):
    """d/dt of a typed tree, by differences."""
    later, earlier = number(node, motion, STEP), number(node, motion, -STEP)
    return (later - earlier) / (2 * STEP)


def is_wrong(equation, start, goal):
    """Whether an equation fails by more than rounding for some motion."""
    for motion in motions(start, goal):
        values = []
        for side in equation.sides:
            if side == s.const:
                if (
                    np.abs(rate(equation.sides[equation.sides.index(side) - 1], motion)).max()
                    > 1e-4
                ):
                    return True
                continue
            values.append(number(side, motion))
        for left, right in pairwise(values):
            if np.shape(left) != np.shape(right) and 0 not in (np.ndim(left), np.ndim(right)):
                return True
            size = 1 + np.abs(left).max() + np.abs(right).max()
            if np.abs(left - right).max() > 1e-5 * size:
                return True
    return False
