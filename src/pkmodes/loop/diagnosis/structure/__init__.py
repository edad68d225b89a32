"""A structure given by callables for M and K: checks of the matrices, modes, and derivatives of modes."""
