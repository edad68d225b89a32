"""What every other part uses: errors, checks of arguments, what the motors do, the version."""
