"""Sphinx's settings for the pages of the Python package, which tools/docs makes."""

import logging
import pathlib

import mixity
from sphinx.util.logging import getLogger

HERE = pathlib.Path(__file__).resolve().parent

project = "mixity"
release = mixity.__version__
extensions = ["sphinx.ext.autodoc", "numpydoc", "sphinx_gallery.gen_gallery", "myst_nb"]
html_theme = "furo"
html_title = f"mixity {release}"
html_copy_source = False
html_show_copyright = False

autodoc_typehints = "none"  # numpydoc's sections say types, shapes and units
autodoc_member_order = "bysource"
numpydoc_show_class_members = False  # api.rst lists them by :members:
# Not asked for: styles of sentences, an example and a "see also" for each, and a type where "as for area" says it.
numpydoc_validation_checks = {
    "all", "ES01", "EX01", "GL01", "GL02", "GL03", "PR03", "PR04", "PR09", "RT02", "SA01", "SS05",
}  # fmt: skip
# Made by fit and runs alone, so that their arguments are nobody's.
numpydoc_validation_exclude = {r"\.Fit$", r"\.Fits$", r"\.Parameter$", r"\.Runs$", r"\.InputError$"}

sphinx_gallery_conf = {
    "examples_dirs": str(HERE / "gallery"),  # run there: the data are at ../../../data, as in the notebooks
    "gallery_dirs": "gallery",
    "abort_on_example_error": True,
    "capture_repr": (),
    "download_all_examples": False,
    "show_signature": False,
    "write_computation_times": False,
    "reference_url": {"mixity": None},
    "doc_module": ("mixity",),
    "within_subsection_order": "FileNameSortKey",
}
exclude_patterns = ["gallery/*.ipynb"]  # myst_nb would run the gallery again
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300

# What fits and kernels log is no warning of Sphinx.
logging.getLogger("mixity").setLevel(logging.ERROR)
logging.getLogger("traitlets").setLevel(logging.WARNING)


def check_complete(app, env):
    """A public name without an entry in api.rst is a warning, and so an error."""
    there = env.get_domain("py").objects
    wanted = [f"mixity.{name}" for name in mixity.__all__]
    for name in (*wanted, "mixity.lmfit.model", "mixity.scipy.residuals", "mixity.plots.area"):
        if name not in there:
            getLogger(__name__).warning("%s is public and has no entry in api.rst", name)


def setup(app):
    app.connect("env-check-consistency", check_complete)
