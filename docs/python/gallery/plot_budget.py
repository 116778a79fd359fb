"""
Where the error comes from
==========================

``plot_budget`` draws the shares of a parameter's variance: the scatter of the points, and the uncertainty of each constant of
the experiment. The largest share is what a better experiment has to reduce.

The data are *reconstructed* from a published fit of model c. The errors of the constants are assumptions for this example.
"""

# %%
# A single run says little about the constants, so that their errors are most of the error of lambda.
import mixity

constants = {"modulus": "2.133 +/- 0.02 MPa", "toughness": "27 +/- 0.5 mJ/m^2", "load_offset": "0 +/- 0.05 mN"}
data = mixity.read("../../../data/mergel2018.csv", **constants)
run = data.run_of_point == 0
one = mixity.Dataset(
    P=data.P[run], T=data.T[run], A=data.A[run], units={"P": "mN", "T": "mN", "A": "mm^2"}, radius="9.42 mm", **constants
)
fit = mixity.fit(one, "c")["c"]
print(fit.params["lambda"])
axes = fit.plot_budget()

# %%
# All eight runs together narrow the constants, too: lambda is more certain, and scatter has the largest share.
fit = mixity.fit(data, "c")["c"]
print(fit.params["lambda"])
axes = fit.plot_budget()
