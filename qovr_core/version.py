"""The version of the program, which files and reports carry."""

VERSION = "0.1.0"
