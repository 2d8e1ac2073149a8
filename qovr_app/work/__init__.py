"""The one way of doing what takes time: a worker process that reports progress and can be cancelled.

``worker`` is the program's side and knows Qt; ``child`` runs in the other process and does not.
"""
