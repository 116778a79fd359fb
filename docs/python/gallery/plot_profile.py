"""
Profile of a parameter
======================

``plot_profile`` shows how the cost of the fit rises when a parameter is held at other values.

The data are *reconstructed* from the fit of model b that Papangelo & Ciavarella (2019) published for the experiment of Waters &
Guduru (2010), plus noise.
"""

# %%
# The 95 % interval ends where the curve crosses the dashed line. A curve that is no parabola gives an interval that is not
# symmetric.
import mixity

data = mixity.read("../../../data/waters_guduru2010.csv")
fit = mixity.fit(data, "b")["b"]
print(fit.params["lambda"].interval)
axes = fit.plot_profile("lambda")
axes.set_title("reconstructed data")
