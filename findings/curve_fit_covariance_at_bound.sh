#!/bin/sh
# SciPy 1.17.1: curve_fit's covariance of a straight line whose slope is pressed against its bound.
#
# What we guessed: the slope's error is 0, infinite or missing, and the intercept's is that of the fit with the slope held there,
# 0.022; for the slope cannot move.
# What we saw: the covariance is the one without bounds, with an error of the slope of 0.074 and of the intercept of 0.043, twice
# that of the fit with the slope held, and no warning. Experiments repeated with a true slope of 0 scatter less: the interval is
# too wide, not wrong.
# What we do: at a bound no standard error is given but a one-sided interval, and those of the others hold the parameter there.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check numpy==2.4.6 scipy==1.17.1
cat >bound.py <<'CODE'
import warnings

import numpy as np
import scipy
from scipy.optimize import curve_fit

warnings.simplefilter("error")
print("scipy", scipy.__version__)
x, error = np.linspace(0, 1, 20), 0.1
design = np.vstack([np.ones(20), x]).T
without = error * np.sqrt(np.diag(np.linalg.inv(design.T @ design)))
at_bound, same, intercepts, slopes = 0, True, [], []
for seed in range(200):
    y = 1 + error * np.random.RandomState(seed).standard_normal(20)
    found, covariance = curve_fit(lambda x, a, b: a + b * x, x, y, [1, 0.5], np.full(20, error), absolute_sigma=True,
                                  bounds=([-10, 0], [10, 10]))
    intercepts.append(found[0])
    slopes.append(found[1])
    if np.polyfit(x, y, 1)[0] < 0:
        at_bound += 1
        same &= found[1] < 1e-4 and np.allclose(np.sqrt(np.diag(covariance)), without, rtol=1e-3)
print(f"{at_bound} of 200 data sets at the bound: errors {without[0]:.3f} and {without[1]:.3f}, as without bounds, in all of them: "
      f"{same}; with the slope held {error / np.sqrt(20):.3f}; scatter of all 200 {np.std(intercepts):.3f} and {np.std(slopes):.3f}")
raise SystemExit(not (at_bound > 50 and same and np.std(slopes) < 0.8 * without[1]))
CODE
venv/bin/python bound.py
