"""Other readings of the data: a table of what a file may have wrong, each with its words and what to do."""
