"""
Toughness against the phase angle
=================================

``plot_toughness`` draws G_c/G_Ic against psi: the points, the model, and the band of its first parameter's interval.

The data are *measured*: delamination of AS4/PEEK at five ratios of the modes, from Reeder & Crews as tabulated by Camanho &
Davila (2002), transcribed at second hand. The law is that of Benzeggagh and Kenane.
"""

# %%
# The data state no errors: the band comes from their scatter about the law.
import mixity

data = mixity.read("../../../data/as4_peek_mmb.csv")
fit = mixity.fit(data, "bk")["bk"]
print(fit.status, fit.params["r"], fit.params["eta"])
axes = fit.plot_toughness()
axes.set_title("measured: AS4/PEEK")
