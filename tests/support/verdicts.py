"""What may stand under a verdict on a claim."""

HERE = {
    ("true", True): "as claimed",
    ("true if", True): "as claimed",
    ("true if", False): "not as claimed",
    ("false", True): "not refuted",
    ("false", False): "refuted",
}
"""How a document stands to a verdict; no other pair can be, so that no line contradicts the one above it."""
