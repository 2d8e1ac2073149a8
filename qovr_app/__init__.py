"""The editor of QOVR Studio. Importing this package loads no Qt."""
