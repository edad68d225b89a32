"""A machine in use: responses, input shapers, maps of the workspace, datasets."""
