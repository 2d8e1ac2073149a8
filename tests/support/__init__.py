"""What several tests share: oracles that know nothing of the program, random documents, the command line."""
