"""What several applications need besides the core: numbers in words, files, progress, the MAC, covariances."""
