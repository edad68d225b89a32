"""What a result says, drawn and written: figures, views in three dimensions, reports."""
