"""Edits of a net's structure: its joints, its windows, which way it runs, and nets of other surfaces."""
