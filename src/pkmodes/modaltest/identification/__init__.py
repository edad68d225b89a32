"""Modal identification: modes from frequency responses, impacts and ambient vibration."""
