"""Zip archives changed part by part, as damaged and hostile ones are."""

import zipfile


def parts_of(path):
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def pack(path, parts, method=zipfile.ZIP_DEFLATED):
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return path


def with_parts(path, source, **changes):
    """Write an archive again with parts changed, each by a function of its content."""
    parts = parts_of(source)
    for name, change in changes.items():
        (full,) = [part for part in parts if part.endswith(f"/{name}.xml") or part == f"{name}.npy"]
        parts[full] = change(parts[full])
    return pack(path, parts)
