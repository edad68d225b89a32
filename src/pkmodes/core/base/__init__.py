"""What every other part uses: errors, optional libraries, writing of files, the version."""
