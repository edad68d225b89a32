"""The posterior probabilities of all explanations: a second opinion in addition to the verdict."""
