# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Sphinx's settings for the site. Sources are what tools/doc_site.py has put together in build/site-src; pages need
no network: no CDN, no fonts, no MathJax (formulas are text), no other site's index."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

project = "Epode"
author = "The Epode authors"
copyright = "2026, The Epode authors"
extensions = ["myst_parser", "breathe"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
root_doc = "index"
highlight_language = "c"
nitpicky = False

myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 4
myst_links_external_new_tab = False

breathe_projects = {"epode": str(ROOT / "build" / "site-xml" / "xml")}
breathe_default_project = "epode"
breathe_show_include = False

html_theme = "furo"
html_title = "Epode"
html_static_path = ["_static"]
html_extra_path = [str(ROOT / "build" / "site-extra")]
html_css_files = ["site.css", "live.css"]
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f5f8b", "color-brand-content": "#1f5f8b"},
    "dark_css_variables": {"color-brand-primary": "#7ab8e0", "color-brand-content": "#7ab8e0"},
}
pygments_style = "xcode"  # every colour of it can be read on the theme's grey: 4.5 to 1 and more
pygments_dark_style = "monokai"


def mend_page(app, pagename, templatename, context, doctree):  # pylint: disable=unused-argument
    """What screen readers and keyboards miss in the theme's pages: the level of the menu's headings, and a way into code and tables that scroll."""
    menu = context.get("furo_navigation_tree")
    if menu:
        context["furo_navigation_tree"] = menu.replace('role="heading">', 'role="heading" aria-level="2">')
    if context.get("body"):
        body = context["body"].replace("<pre>", '<pre tabindex="0">')
        context["body"] = body.replace('<div class="table-wrapper', '<div tabindex="0" class="table-wrapper')


def setup(app):
    app.connect("html-page-context", mend_page, priority=900)  # after the theme's own
