"""The laboratory: the paper's method laid open, its claims decided, and the surface set beside others.

Nothing of it is needed to evaluate or export a surface; every module is imported where it is used.
"""
