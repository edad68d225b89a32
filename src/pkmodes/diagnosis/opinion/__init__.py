"""A second opinion: the probabilities of explanations."""
