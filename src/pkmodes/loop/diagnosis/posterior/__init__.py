"""The posterior probabilities of all explanations: a second opinion beside the verdict."""
