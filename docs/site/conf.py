"""The documents as one static site, by Sphinx: scripts/site.sh puts the repository's files where
this reads them, lets the program write its pages, and runs it."""

import os
import re
from pathlib import Path

SOURCE, MADE = Path(os.environ["PRS_SITE_SOURCE"]), Path(os.environ["PRS_SITE_MADE"])

project = "prs"
version = release = re.search(r'kVersion = "([^"]+)"', (SOURCE / "prs/version.h").read_text())[1]

extensions = ["myst_nb", "autoapi.extension", "sphinx.ext.napoleon", "breathe", "sphinx_copybutton"]
root_doc = "index"
# Documents alone. Other files of the repository that they link to are downloads.
include_patterns = [
    "index.md",
    "live.md",
    "CHANGELOG.md",
    "SECURITY.md",
    "docs/**.md",
    "lessons/*.md",
    "cpp/*.md",
    "benchmark/**.md",
    "validation/*/SOURCE.md",
    "python/README.md",
    "python/*/README.md",
    "python/notebooks/*.ipynb",
    "autoapi/**.rst",
]
exclude_patterns = ["docs/site/**"]

myst_heading_anchors = 4
nb_execution_mode = "off"
nb_merge_streams = True

breathe_projects = {"prs": str(MADE / "doxygen/xml")}
breathe_default_project = "prs"

autoapi_dirs = [str(SOURCE / "python/rollerscrew")]
autoapi_options = ["members", "show-module-summary", "imported-members"]
autoapi_add_toctree_entry = False
autoapi_python_class_content = "both"
# Imports of the compiled engine and cycles of types; namespaces, which are opened again; names of
# the package, which stand in their modules too.
suppress_warnings = ["autoapi.python_import_resolution", "duplicate_declaration.cpp", "ref.python"]
default_role = "code"

html_theme = "furo"
html_title = f"prs {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_extra_path = [str(MADE / "pages")]
html_copy_source = False
html_show_sphinx = html_show_copyright = False


def as_written(app, what, name, obj, skip, options):
    """Bars of docstrings are those of formulas."""
    if "|" in obj.docstring and "\\|" not in obj.docstring:
        obj.docstring = obj.docstring.replace("|", "\\|")


def setup(app):
    app.connect("autoapi-skip-member", as_written)
