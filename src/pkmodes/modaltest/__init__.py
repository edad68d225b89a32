"""From measured signals to modes: files of signals, identification, campaigns."""
