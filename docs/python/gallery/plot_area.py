"""
Area against shear load
=======================

``plot_area`` draws the points of each run, the fitted model with its 95 % band, and a square where the contact jumps.

The data are *reconstructed*: areas of model c with the lambda that Papangelo & Ciavarella (2019) published for the experiment
of Mergel et al. (2018), plus noise. That model c fits them shows that the program works, and nothing about the contact.
"""

# %%
# Eight runs, and one lambda for all of them.
import mixity

data = mixity.read("../../../data/mergel2018.csv")
fit = mixity.fit(data, "c")["c"]
print(fit.status, fit.params["lambda"])
axes = fit.plot_area()
axes.set_title("reconstructed data")

# %%
# The fit predicts an area at any load, with its band; here at 4 mN and three shear loads.
A, low, high = fit.area(4, [0, 40, 80])
print(A, data.units["area"])
print(low)
print(high)
