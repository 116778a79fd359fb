"""
Axes of an elliptic contact
===========================

Mode II acts at the front and the rear of a sheared contact, mode III at its sides, so that it becomes an ellipse.
:func:`mixity.axes` computes both semi-axes: a along the shear, b across it. lambda_II and lambda_III are the couplings of the
two modes. Nothing here is measured: the curves are those of the model.
"""

# %%
# Both axes, up to the last equilibrium, for three couplings of mode III.
import matplotlib.pyplot as plt
import numpy as np

import mixity

contact = (9.42e-3, 2.133e6, 27e-3)  # radius [m], modulus [Pa], toughness [J/m^2]
T = np.linspace(0, 60e-3, 1000)  # N
axes = plt.subplots(constrained_layout=True)[1]
for lambda_III, line in ((0.0, "-"), (0.02, "--"), (0.1, ":")):
    a, b = mixity.axes("c-ellipse", (0.02, lambda_III, 0.5), 4e-3, T, contact=contact)
    axes.plot(1e3 * T, 1e3 * a, line, color="#0072b2", label=f"a, lambda_III = {lambda_III}")
    axes.plot(1e3 * T, 1e3 * b, line, color="#d55e00", label=f"b, lambda_III = {lambda_III}")
axes.set_xlabel("T [mN]")
axes.set_ylabel("semi-axis [mm]")
axes.set_title("model c-ellipse, lambda_II = 0.02, P = 4 mN")
axes.legend(frameon=False, loc="upper left", bbox_to_anchor=(1, 1))

# %%
# A fit with ``shape="ellipse"`` finds both couplings from axes. These are *simulated* with lambda_II = 0.02 and
# lambda_III = 0.005.
constants = {"radius": "9.42 mm", "modulus": "2.133 MPa", "toughness": "27 mJ/m^2"}
plan = mixity.Plan("c-ellipse", (0.02, 0.005, 0.5), [1.5e-3, 4e-3], **constants)
fit = mixity.fit(plan.simulate(), "c", shape="ellipse")["c-ellipse"]
print(fit.status, fit.params["lambda_II"], fit.params["lambda_III"], sep="\n")
