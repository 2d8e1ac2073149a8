"""Files of the program, damaged at random, and read: ``fuzzing.py FOLDER SECONDS SEED``.

Every one has to end as a document or as one short line, soon, and in little memory. What does not stays in the folder.
"""

import json
import logging
import random
import re
import resource
import signal
import sys
import time
import zipfile
from itertools import product
from pathlib import Path

from qovr_core import FileError, configure
from qovr_core.files import FORMATS, read_source
from qovr_core.files.progress import silent
from qovr_core.files.workbook_read import read_published_numbers
from support.documents import random_document
from support.nets import closed_net, random_net_document
from support.zips import pack, parts_of

MEGABYTES = 400
"""What a small file may take at most, the program's own memory aside."""

LONGEST_SECONDS = 10
LONGEST_TEXT = 300

ODD_VALUES = (
    None,
    True,
    -1,
    0,
    1e308,
    float("nan"),
    "",
    "\ud800\0\n",
    "x" * 5000,
    [],
    {},
    [[[]]],
    {"\u202e\n": 1},
    10**4000,
)
ODD_BYTES = (
    b"",
    b"\0",
    b"\xff" * 8,
    b"-1",
    b"1e999",
    b"99999999999999999999",
    b"<",
    b'"',
    b"&#0;",
    b"&x;",
    b"ZZ1",
    b"\n",
)
XML_PIECES = re.compile(rb"<[^<>]*>|[^<>]+")


def damaged_bytes(rng, content):
    content = bytearray(content)
    for _ in range(rng.choice((1, 1, 2, 5, 30))):
        if not content:
            break
        place, length = rng.randrange(len(content)), rng.choice((1, 2, 4, 8, 100))
        match rng.randrange(6):
            case 0:
                content[place] ^= 1 << rng.randrange(8)
            case 1:
                content[place] = rng.randrange(256)
            case 2:
                content[place : place + length] = rng.choice(ODD_BYTES)
            case 3:
                content[place:place] = content[place : place + length] * rng.choice((1, 10))
            case 4:
                del content[place : None if rng.random() < 0.2 else place + length]
            case 5:
                other = rng.randrange(len(content))
                content[place : place + length] = content[other : other + length]
    return bytes(content)


def damaged_xml(rng, content):
    """Change, double, drop or swap whole tags and texts."""
    pieces = XML_PIECES.findall(content)
    for _ in range(rng.choice((1, 1, 2, 5))):
        k, other = rng.randrange(len(pieces)), rng.randrange(len(pieces))
        match rng.randrange(5):
            case 0:
                pieces[k] = re.sub(rb"[0-9.]+", lambda _: rng.choice(ODD_BYTES), pieces[k], count=1)
            case 1:
                pieces[k] = pieces[k] * rng.choice((2, 3, 500))
            case 2:
                pieces[k] = b""
            case 3:
                pieces[k], pieces[other] = pieces[other], pieces[k]
            case 4:
                pieces[k] = re.sub(rb'"[^"]*"', b'"' + rng.choice(ODD_BYTES) + b'"', pieces[k], count=1)
    return b"".join(pieces)


def damaged_zip(rng, path):
    parts = parts_of(path)
    name = rng.choice(list(parts))
    match rng.randrange(5):
        case 0:
            del parts[name]
        case 1:
            parts[name] = parts[rng.choice(list(parts))]
        case 2:
            parts[name] = damaged_bytes(rng, parts[name])
        case _:
            damage = damaged_xml if name.endswith((".xml", ".rels")) else damaged_bytes
            parts[name] = damage(rng, parts[name])
    pack(path, parts, rng.choice((zipfile.ZIP_DEFLATED, zipfile.ZIP_STORED)))


def damaged_json(rng, content):
    """Put something else in the place of some entry."""
    data = json.loads(content)
    node = data
    while True:
        keys = list(node) if isinstance(node, dict) else list(range(len(node)))
        key = rng.choice(keys)
        if isinstance(node[key], (dict, list)) and node[key] and rng.random() < 0.8:
            node = node[key]
            continue
        match rng.randrange(3):
            case 0:
                node[key] = rng.choice(ODD_VALUES)
            case 1:
                del node[key]
            case 2 if isinstance(node, dict):
                node[str(rng.choice(ODD_VALUES[:-1]))] = rng.choice(ODD_VALUES)
            case _:
                node.append(rng.choice(ODD_VALUES))
        return json.dumps(data).encode()


def damage(rng, path, whole):
    """Write a damaged copy of a whole file."""
    path.write_bytes(whole)
    if path.suffix in (".xlsx", ".npz") and rng.random() < 0.7:
        damaged_zip(rng, path)
    elif path.suffix == ".qovr" and rng.random() < 0.6:
        path.write_bytes(damaged_json(rng, whole))
    else:
        path.write_bytes(damaged_bytes(rng, whole))


def outcome(read, path):
    """Return the text of a refusal, empty where something was read; anything else is raised."""
    try:
        read(path)
    except FileError as error:
        text = str(error)
        assert text.startswith(f"{path}: "), text
        assert text.isprintable(), text
        assert len(text) <= LONGEST_TEXT, text
        return text
    return ""


def main():
    folder, seconds, seed = Path(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
    logging.disable()  # what a reader has to say of a file that it reads all the same
    wholes = {suffix: [] for suffix, entry in FORMATS.items() if entry.reader is not None}
    nets = random_net_document(seed, (2, 2), smooth=0.5, samples=(4, 4)), closed_net(seed, (1, 2), ("u",))
    for suffix, document in product(wholes, (random_document(seed, samples=(4, 3)), *nets)):
        if suffix == ".xlsx" and document.windows != (1, 1):
            continue
        path = folder / f"whole-{len(wholes[suffix])}{suffix}"
        FORMATS[suffix].write(configure(document), path, silent)
        wholes[suffix].append(path.read_bytes())
        assert outcome(lambda path: read_source(str(path)), path) == ""
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + MEGABYTES * 10**6,) * 2)
    counts, deadline, number = dict.fromkeys(wholes, 0), time.monotonic() + seconds, 0
    while time.monotonic() < deadline:
        number += 1
        rng = random.Random(f"{seed} {number}")
        suffix = rng.choice(list(wholes))
        path = folder / f"damaged{suffix}"
        damage(rng, path, rng.choice(wholes[suffix]))
        signal.alarm(LONGEST_SECONDS)
        outcome(lambda path: read_source(str(path)), path)
        if suffix == ".xlsx":
            outcome(read_published_numbers, path)
        signal.alarm(0)
        path.unlink()
        counts[suffix] += 1
    print(json.dumps(counts))


if __name__ == "__main__":
    main()
