#!/bin/sh
# iminuit 2.33.0: MINOS, where the interval would pass the limit of its parameter; chi^2 = (p - 0.3)^2 with p >= 0.
#
# What we guessed: a side that never reaches chi^2 = 1 is not valid, and `is_valid` is false, as where it runs out of calls.
# What we saw: the lower side ends at the limit, where chi^2 is 0.09, and `lower_valid` and `is_valid` are true. Only
# `at_lower_limit` tells; `valid` alone takes an interval that the limit has cut for one that MINOS found.
# What we do: each end of an interval of mixity says whether it was found, lies at the bound or is open (`low_status`).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check numpy==2.4.6 iminuit==2.33.0
cat >minos.py <<'CODE'
import iminuit

print("iminuit", iminuit.__version__)


def chi2(p):
    return (p - 0.3) ** 2


fit = iminuit.Minuit(chi2, 1.0)
fit.errordef = 1
fit.limits = (0, None)
fit.migrad()
fit.minos()
found = fit.merrors[0]
low = fit.values[0] + found.lower
seen = (f"low {low:.2f}, where chi^2 has grown by {chi2(low) - fit.fval:.2f}; is_valid {found.is_valid}, "
        f"lower_valid {found.lower_valid}, at_lower_limit {found.at_lower_limit}")
print(seen)
raise SystemExit(seen != "low 0.00, where chi^2 has grown by 0.09; is_valid True, lower_valid True, at_lower_limit True")
CODE
venv/bin/python minos.py
