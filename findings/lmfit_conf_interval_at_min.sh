#!/bin/sh
# lmfit 1.3.4: conf_interval of a slope with min=0 whose interval reaches 0.
#
# What we guessed: the lower end is 0, the parameter's min, with a warning; for no value below it is possible.
# What we saw: the end is -inf, with a warning that the bound was reached. An interval (-inf, 0.25) of a parameter that cannot
# be negative has any coverage and no width, and what computes with it gets infinities.
# What we do: such an end lies at the bound, and `low_status` says so. tools/who_covers takes -inf as it is.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check numpy==2.4.6 scipy==1.17.1 lmfit==1.3.4
cat >interval.py <<'CODE'
import warnings

import lmfit
import numpy as np

print("lmfit", lmfit.__version__)
x = np.linspace(0, 1, 20)
y = 1 + 0.1 * x + 0.1 * np.random.RandomState(1).standard_normal(20)
parameters = lmfit.Parameters()
parameters.add("intercept", 1)
parameters.add("slope", 0.5, min=0)
minimizer = lmfit.Minimizer(lambda values: y - values["intercept"] - values["slope"] * x, parameters)
fit = minimizer.leastsq()
with warnings.catch_warnings(record=True) as said:
    warnings.simplefilter("always")
    ends = lmfit.conf_interval(minimizer, fit, p_names=["slope"], sigmas=[0.95])["slope"]
low, high = ends[0][1], ends[-1][1]
print(f"slope {fit.params['slope'].value:.4f}, 95 % interval {low} .. {high:.4f}; {said[0].message if said else 'no warning'}")
raise SystemExit(not (low == -np.inf and 0 < high < 1))
CODE
venv/bin/python interval.py
