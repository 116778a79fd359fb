"""
Residuals
=========

``plot_residuals`` draws model minus data in standard errors: against T, or against psi if the data have no loads.

The data are *measured*: 112 field tests of weak layers of snow in three series, eight of which stand twice in the source.
"""

# %%
# Each series has a toughness of its own. The fit is suspect, since the tests scatter more than their errors say.
import mixity

data = mixity.read("../../../data/snow_weak_layers_manual.csv")
fit = mixity.fit(data, "c", free="toughness", per="curve")["c"]
print(fit.status, fit.message, sep=": ")
axes = fit.plot_residuals()
axes.set_title("measured: weak layers of snow")
