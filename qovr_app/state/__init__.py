"""The state of an editor and everything that makes the next one: plain Python, which loads no Qt."""
