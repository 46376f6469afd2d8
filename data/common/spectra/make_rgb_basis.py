#!/usr/bin/env python3
"""Writes rgb_basis.csv: python3 make_rgb_basis.py. Needs NumPy; the build does not run it, the table is committed.

Three reflectances rho_r, rho_g, rho_b, piecewise linear at 5 nm, such that r rho_r + g rho_g + b rho_b under D65
has the linear Rec.709 colour (r, g, b) for every r, g, b: the idea of Mallett and Yuksel 2019, "Spectral Primary
Decomposition for Rendering with sRGB Reflectance". They are what minimises the sum of the squared second differences
of the three (smooth spectra are what most things have) subject to

    integral of rho_j D65 cmf = XYZ of primary j,     rho_r + rho_g + rho_b = 1,     0 <= rho_j.

With rho_b = 1 - rho_r - rho_g this is a convex quadratic program in 190 unknowns with 6 equations and 285
inequalities, solved here by an interior-point method (Mehrotra's predictor and corrector; Nocedal and Wright 2006,
algorithm 16.4).
"""
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
GRID_NM = np.arange(360.0, 831.0, 5.0)
# ITU-R BT.709: chromaticities of the primaries.
PRIMARIES_XY = np.array([[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]])
DIGITS = 10


def read_table(name):
    lines = [line for line in (FOLDER / name).read_text().splitlines() if not line.startswith("#")]
    columns = lines[0].split(",")
    rows = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
    return {name: rows[:, i] for i, name in enumerate(columns)}


def hat_weights():
    """weights[c, i] = integral of cmf_c(l) D65(l) hat_i(l), the hats of GRID_NM. Everything is linear between whole
    nanometres, so that Gauss's rule with two points per nanometre is exact."""
    cmf, lamp = read_table("cie_1931_2deg.csv"), read_table("illuminants.csv")
    left = np.arange(360.0, 830.0)
    weights = np.zeros((3, len(GRID_NM)))
    for offset in (0.5 - np.sqrt(1 / 12), 0.5 + np.sqrt(1 / 12)):
        at = left + offset
        d65 = np.interp(at, lamp["wavelength_nm"], lamp["D65"])
        hats = np.array([np.interp(at, GRID_NM, row) for row in np.eye(len(GRID_NM))])
        for c, name in enumerate(("xbar", "ybar", "zbar")):
            weights[c] += hats @ (0.5 * d65 * np.interp(at, cmf["wavelength_nm"], cmf[name]))
    return weights


def primaries_xyz(white):
    """Columns: XYZ of the primaries, whose sum is `white`."""
    x, y = PRIMARIES_XY.T
    directions = np.array([x / y, np.ones(3), (1 - x - y) / y])
    return directions * np.linalg.solve(directions, white)


def longest_step(values, change):
    shrinking = change < 0
    return min(1.0, np.min(-values[shrinking] / change[shrinking], initial=1.0))


def solve_quadratic_program(h, equations, right_side, g, bound):
    """x that minimises x'Hx / 2 subject to equations x = right_side and g x <= bound."""
    count, equation_count = h.shape[0], len(right_side)
    x, multipliers = np.full(count, 1 / 3), np.zeros(equation_count)
    slack, dual = np.full(len(bound), 1 / 3), np.full(len(bound), 1e-3)
    for _ in range(100):
        residual_dual = h @ x + equations.T @ multipliers + g.T @ dual
        residual_equations = equations @ x - right_side
        residual_slack = g @ x + slack - bound
        gap = slack @ dual / len(bound)
        if max(abs(residual_dual).max(), abs(residual_equations).max(), abs(residual_slack).max(), gap) < 1e-13:
            break
        matrix = np.zeros((count + equation_count, count + equation_count))
        matrix[:count, :count] = h + g.T @ ((dual / slack)[:, None] * g)
        matrix[:count, count:], matrix[count:, :count] = equations.T, equations

        def step(centred):
            complement = dual * slack + centred
            right = -residual_dual - g.T @ ((dual * residual_slack - complement) / slack)
            solution = np.linalg.solve(matrix, np.concatenate([right, -residual_equations]))
            dx = solution[:count]
            d_slack = -residual_slack - g @ dx
            return dx, solution[count:], d_slack, -(complement + dual * d_slack) / slack

        _, _, d_slack, d_dual = step(0.0)
        reach = min(longest_step(slack, d_slack), longest_step(dual, d_dual))
        predicted = (slack + reach * d_slack) @ (dual + reach * d_dual) / len(bound)
        dx, d_multipliers, d_slack, d_dual = step(d_slack * d_dual - (predicted / gap) ** 3 * gap)
        reach = 0.995 * min(longest_step(slack, d_slack), longest_step(dual, d_dual))
        x, multipliers = x + reach * dx, multipliers + reach * d_multipliers
        slack, dual = slack + reach * d_slack, dual + reach * d_dual
    return x


def make_basis():
    weights = hat_weights()
    white = weights.sum(axis=1)
    weights, white = weights / white[1], white / white[1]
    primaries = primaries_xyz(white)
    count = len(GRID_NM)
    bend = np.diff(np.eye(count), n=2, axis=0)
    h = np.kron([[2.0, 1.0], [1.0, 2.0]], bend.T @ bend)  # rho_r, rho_g and 1 - rho_r - rho_g, each bent once
    equations = np.kron(np.eye(2), weights)
    identity = np.eye(count)
    g = np.vstack([np.kron([[-1.0, 0.0], [0.0, -1.0]], identity), np.hstack([identity, identity])])
    bound = np.concatenate([np.zeros(2 * count), np.ones(count)])
    x = solve_quadratic_program(h, equations, primaries[:, :2].T.ravel(), g, bound)
    red, green = np.round(np.clip(x.reshape(2, count), 0, 1), DIGITS)
    basis = np.array([red, green, np.round(1 - red - green, DIGITS)])
    to_rgb = np.linalg.inv(primaries)
    return basis, to_rgb @ weights @ basis.T - np.eye(3)


def main():
    basis, error = make_basis()
    lines = ["# Reflectances of the linear Rec.709 primaries under D65: sum to 1, each in [0, 1], linear between rows",
             "# units: wavelength_nm in nm; reflectance factor 0..1",
             "# origin: this project, make_rgb_basis.py, from cie_1931_2deg.csv and illuminants.csv",
             "# use: linear interpolation between rows, end values held",
             "wavelength_nm,red,green,blue"]
    for nm, values in zip(GRID_NM, basis.T):
        lines.append(f"{nm:.0f}," + ",".join(f"{value:.{DIGITS}f}".rstrip("0").rstrip(".") for value in values))
    (FOLDER / "rgb_basis.csv").write_text("\n".join(lines) + "\n")
    print(f"largest error of the nine integrals: {abs(error).max():.1e}; smallest value {basis.min()}, "
          f"largest second difference {abs(np.diff(basis, n=2)).max():.4f}")


if __name__ == "__main__":
    main()
