"""From poses to modes: validity, kinematics, the eigenproblem and its results."""
