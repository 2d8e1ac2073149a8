"""What is seen, as a file."""
