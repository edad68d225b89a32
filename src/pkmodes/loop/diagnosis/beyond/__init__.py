"""Beyond the catalogue: whether one thing at one place, such as a mass on one body, explains the rest."""
