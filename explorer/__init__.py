"""The explorer: one HTML page in which a scene is dragged and its difference is seen.

`src/` holds the page in readable parts: `exact/` decides, in integers; `control/` changes what
is shown; `view/` draws. This package joins them with the samples and the gallery.
"""
