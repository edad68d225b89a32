"""What every other part uses: errors, checks of arguments, what the motors do, methods of applications, version."""
