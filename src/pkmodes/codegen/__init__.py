"""Code generation as the command line uses it: deriving, writing and checking generated models."""
