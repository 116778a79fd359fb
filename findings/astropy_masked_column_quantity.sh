#!/bin/sh
# astropy 8.0.2: the quantity of a column with a unit and a masked value.
#
# What we guessed: MaskedColumn.quantity is a masked quantity, or nan where the value is masked; our package took it as that.
# What we saw: it is a plain Quantity without a mask, which holds the number under the mask, and
# there is no warning. The same column in a QTable is a masked quantity.
# What we do: masked values of a column are nan before its quantity is taken, so that their rows are left out (_quantities.py).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check numpy==2.4.6 astropy==8.0.2
cat >masked.py <<'CODE'
import warnings

import astropy
from astropy.table import MaskedColumn, QTable, Table

warnings.simplefilter("error")
print("astropy", astropy.__version__)
table = Table({"A": MaskedColumn([0.46, 0.45, 7.77], unit="mm2", mask=[False, False, True])})
of_column = table["A"].quantity
of_table = QTable(table)["A"]
print(f"Table: {type(of_column).__name__} {of_column}, mask {getattr(of_column, 'mask', None)}")
print(f"QTable: {type(of_table).__name__} {of_table}")
raise SystemExit(not (not hasattr(of_column, "mask") and of_column[2].value == 7.77 and bool(of_table.mask[2])))
CODE
venv/bin/python masked.py
