"""The two surfaces that the paper's pipeline makes of a document."""

from enum import StrEnum


class Layer(StrEnum):
    """The two surfaces of an evaluation: as computed, and after the transformation T.

    >>> Layer("raw"), str(Layer.TRANSFORMED)
    (<Layer.RAW: 'raw'>, 'transformed')
    """

    RAW = "raw"
    TRANSFORMED = "transformed"
