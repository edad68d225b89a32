"""Writing, changing and comparing robot files: edits keep comments and order."""
