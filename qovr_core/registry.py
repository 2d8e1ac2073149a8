"""Tables of what there are several kinds of - formulations, fields, formats, claims - with one record for each kind."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from operator import attrgetter
from typing import Any, ClassVar, Generic, TypeVar

R = TypeVar("R")


class Registry(Mapping[str, R]):
    """Records by name, in the order in which they are offered.

    The module that owns the table registers the program's own records and then seals it; whatever is registered later
    comes from outside.

    Parameters
    ----------
    kind : what a record is, for messages
    key : gives the name under which a record is found

    Examples
    --------
    >>> units = Registry("unit", key=str)
    >>> units.seal()
    >>> with units.register("mm"):
    ...     units["mm"], units.extras()
    ('mm', ('mm',))
    >>> list(units)
    []
    """

    def __init__(self, kind: str, key: Callable[[R], str] = attrgetter("name")) -> None:
        self._kind, self._key = kind, key
        self._records: dict[str, R] = {}
        self._own: frozenset[str] = frozenset()

    def __getitem__(self, name: str) -> R:
        return self._records[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._records)

    def __len__(self) -> int:
        return len(self._records)

    def register(self, record: R) -> Registration[R]:
        """Put a record in, after all others.

        Returns
        -------
        a context manager; leaving it takes the record out again

        Raises
        ------
        ValueError : there is one of the same name
        """
        name = self._key(record)
        if name in self._records:
            raise ValueError(f"there is a {self._kind} {name!r} already; expected another name")
        self._records[name] = record
        return Registration(self, record)

    def remove(self, record: R) -> None:
        """Take a record out; nothing happens where it is not in."""
        if self._records.get(self._key(record)) is record:
            del self._records[self._key(record)]

    def seal(self) -> None:
        """Take what is in as the program's own."""
        self._own = frozenset(self._records)

    def extras(self) -> tuple[R, ...]:
        """Return the records that came from outside, for a process that has to be given them."""
        return tuple(record for name, record in self._records.items() if name not in self._own)

    def is_own(self, record: R) -> bool:
        """Return whether a record is one of the program's own."""
        name = self._key(record)
        return name in self._own and self._records.get(name) is record


class Registration(Generic[R]):
    """A record that is in its table until the end of a ``with`` block; without one it stays."""

    def __init__(self, table: Registry[R], record: R) -> None:
        self._table, self._record = table, record

    def __enter__(self) -> R:
        return self._record

    def __exit__(self, *_: object) -> None:
        self._table.remove(self._record)


class Record:
    """Base of the records that stand for their name: compared, hashed, written and pickled by it.

    A subclass is a frozen dataclass with ``eq=False`` and a first field ``name``, and names its ``table``. A record of
    the program's own is pickled as its name; one from outside as its fields, so that it can go where it is not yet
    known.
    """

    name: str
    table: ClassVar[Registry[Any]]

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.name!r})"

    def __format__(self, spec: str) -> str:
        return format(self.name, spec)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and other.name == self.name

    def __hash__(self) -> int:
        return hash(self.name)

    def __reduce__(self) -> tuple[Any, ...]:
        if self.table.is_own(self):
            return _own_record, (type(self), self.name)
        assert is_dataclass(self)
        return type(self), tuple(getattr(self, field.name) for field in fields(self))


def _own_record(kind: type[Record], name: str) -> Any:
    return kind.table[name]
