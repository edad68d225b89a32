"""What every other part uses: errors, checks of arguments, numbers in words, motors, methods of applications."""
