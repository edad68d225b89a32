"""Suites of cases from the virtual rig, and what the diagnosis makes of them: error rates, tables, requirements."""
