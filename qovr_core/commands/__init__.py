"""The headless commands, one module each: ``add_command`` brings it to the parser."""
