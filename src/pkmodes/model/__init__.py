"""The evaluator of one robot, and loading a robot file."""
