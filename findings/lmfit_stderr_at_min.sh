#!/bin/sh
# lmfit 1.3.4: the standard error of a slope with min=0, where the data want it below 0.
#
# What we guessed: `stderr` is the curvature's, 0.08, as scipy's curve_fit gives it at its bound, or None with errorbars False;
# for lmfit scales the covariance back from its internal variable to the parameter.
# What we saw: the slope is 0, `success` and `errorbars` are true, and the standard error is that in most data sets, less than half
# of it in others, and a thousandth in a few. The covariance comes from the last Jacobian of the internal variable, and is scaled
# by the derivative of the transformation at the end. That goes to 0 at the min, so a step after the last Jacobian changes the
# error by as much as it changes the distance from the min.
# What we do: at a bound no standard error is given but a one-sided interval, and the status is at_bound.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check numpy==2.4.6 scipy==1.17.1 lmfit==1.3.4
cat >stderr.py <<'CODE'
import lmfit
import numpy as np
from scipy.optimize import curve_fit

print("lmfit", lmfit.__version__)
x = np.linspace(0, 1, 20)
ratios = []
for seed in range(100):
    y = 1 + 0.1 * np.random.RandomState(seed).standard_normal(20)
    parameters = lmfit.Parameters()
    parameters.add("intercept", 1)
    parameters.add("slope", 0.5, min=0)
    fit = lmfit.minimize(lambda values: y - values["intercept"] - values["slope"] * x, parameters)
    slope = fit.params["slope"]
    if np.polyfit(x, y, 1)[0] > 0 or not (fit.success and fit.errorbars):
        continue
    covariance = curve_fit(lambda x, a, b: a + b * x, x, y, [1, 0.5], bounds=([-10, 0], [10, 10]))[1]
    ratios.append(slope.stderr / np.sqrt(covariance[1, 1]))
    if ratios[-1] < 0.1:
        print(f"slope {slope.value:.1e} +/- {slope.stderr:.1e}; curve_fit: +/- {np.sqrt(covariance[1, 1]):.3f}")
ratios = np.array(ratios)
print(f"{len(ratios)} data sets at the min; the error over the curvature's: median {np.median(ratios):.2f}, least {ratios.min():.1e}, "
      f"below a half in {np.sum(ratios < 0.5)}")
raise SystemExit(not (len(ratios) >= 20 and ratios.min() < 0.01 and np.median(ratios) > 0.5))
CODE
venv/bin/python stderr.py
