#!/bin/sh
# odrpack 0.7.0: a straight line, 30 points with errors in both axes, and an upper bound on the slope that the data want to pass.
#
# What we guessed: where `success` is true and the slope lies at its bound, the intercept is that of the fit with the slope
# fixed there, to the tolerance; for the sum of squares is least there.
# What we saw: the slope is at the bound, `success` is true, "Sum of squares convergence.", and the intercept is off by about
# two of the standard errors that the stated errors imply. `sum_square` is nearly twice that of the fit with the slope fixed.
# What we do: a parameter at its bound is held there, and the verdict tests the gradient of the others (src/solver). In
# tools/who_covers such answers count as failures that are not said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check numpy==2.4.6 odrpack==0.7.0
cat >bound.py <<'CODE'
import importlib.metadata

import numpy as np
import odrpack

random = np.random.RandomState(1)
error, bound = 0.05, 1.5
true_x = np.linspace(0, 1, 30)


def line(x, beta):
    return beta[0] + beta[1] * x


print("odrpack", importlib.metadata.version("odrpack"))
converged = wrong = 0
for _ in range(20):
    x = true_x + error * random.standard_normal(30)
    y = 1 + 2 * true_x + error * random.standard_normal(30)
    weights = {"weight_x": 1 / error**2, "weight_y": 1 / error**2}
    bounded = odrpack.odr_fit(line, x, y, [1.0, 1.0], bounds=([-10, -10], [10, bound]), **weights)
    held = odrpack.odr_fit(line, x, y, [1.0, bound], fix_beta=[False, True], **weights)
    if not bounded.success or bounded.beta[1] != bound:
        continue
    converged += 1
    stated = error * np.hypot(1, bound) / np.sqrt(30)  # of the intercept, with this slope
    off = (bounded.beta[0] - held.beta[0]) / stated
    wrong += abs(off) > 1
    print(f"{bounded.stopreason} intercept {bounded.beta[0]:.4f}, sum of squares {bounded.sum_square:.1f}; slope held: "
          f"{held.beta[0]:.4f}, {held.sum_square:.1f}; {off:+.1f} standard errors apart")
print(f"{wrong} of {converged} that converged at the bound are off by more than a standard error")
raise SystemExit(not (converged >= 5 and wrong >= converged / 2))
CODE
venv/bin/python bound.py
