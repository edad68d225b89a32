"""Robot files changed and compared: edits that keep comments and order."""
