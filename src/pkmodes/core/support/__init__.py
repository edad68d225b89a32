"""What several applications need besides the core: files, progress, the MAC, covariances of values."""
