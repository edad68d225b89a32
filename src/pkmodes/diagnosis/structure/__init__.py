"""A structure given by callables for M and K: what they return, its modes, and their derivatives."""
