"""Emission: from derived functions to NumPy, C99, LaTeX, and the manifest that keeps them honest.

`program` orders and shortens the expressions, once for all languages; `numpy_code`, `c_code` and `latex`
print and lay them out through templates that contain no mathematics; `product` puts the files together.
"""
