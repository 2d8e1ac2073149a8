"""What a recovery file holds, read without the program."""

import json
from math import prod

import numpy as np


def kept_in(file):
    """Return a recovery file's first line, and of each document in it the arrays by their names."""
    line, content = file.read_bytes().split(b"\n", 1)
    head, documents = json.loads(line), []
    for entry in head["documents"]:
        arrays = {}
        for name, shape in entry["shapes"].items():
            length = 8 * prod(shape)
            arrays[name] = np.frombuffer(content[:length], "<f8").reshape(shape)
            content = content[length:]
        documents.append(arrays)
    assert not content
    return head, documents
