"""The search for causes that explain the residual."""
