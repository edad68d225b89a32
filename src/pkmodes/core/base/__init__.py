"""What every other part uses: errors, checks of arguments, numbers as people read them, what the motors do, methods of applications, version."""
