#!/bin/sh
# iminuit 2.33.0: the error of a parameter that lies near its limit, chi^2 = (p - 0.3)^2 with p >= 0.
#
# What we guessed: `errors` are the roots of the diagonal of `covariance`, as they are far from limits, and as the covariance's
# documentation says ("the square-root of the diagonal elements ... correspond to a standard deviation").
# What we saw: at p = 0.3 the error is 0.68 and the root of the covariance 1.00; far from the limit they agree. The error is half
# the difference of the two points that a step in the internal variable reaches, so it cannot pass the limit on one side.
# What we do: tools/who_covers takes `errors`, which is what is printed. docs/who_covers.md says which of both is which.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check numpy==2.4.6 iminuit==2.33.0
cat >limit.py <<'CODE'
import iminuit

print("iminuit", iminuit.__version__)
seen = []
for place in (0.3, 30.0):
    fit = iminuit.Minuit(lambda p: (p - place) ** 2, 1.0)
    fit.errordef = 1
    fit.limits = (0, None)
    fit.migrad()
    fit.hesse()
    seen.append(f"minimum {place:g}: valid {fit.valid}, error {fit.errors[0]:.2f}, root of the covariance {fit.covariance[0, 0] ** 0.5:.2f}")
print("\n".join(seen))
wanted = ["minimum 0.3: valid True, error 0.68, root of the covariance 1.00", "minimum 30: valid True, error 1.00, root of the covariance 1.00"]
raise SystemExit(seen != wanted)
CODE
venv/bin/python limit.py
