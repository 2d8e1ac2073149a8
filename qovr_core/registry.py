"""Tables of records: what the program offers a choice of, and how a choice is added from outside."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from operator import attrgetter
from typing import Any, ClassVar, Generic, TypeVar

R = TypeVar("R")


class Registry(Mapping[str, R], Generic[R]):
    """Records by name, in the order in which they were registered.

    Parameters
    ----------
    kind : what a record is called in messages
    key : gives the name of a record

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> shapes = Registry("shape")
    >>> shapes.register(SimpleNamespace(name="disc")).close()
    >>> with shapes.register(SimpleNamespace(name="square")):
    ...     list(shapes)
    ['square']
    >>> list(shapes)
    []
    """

    def __init__(self, kind: str, key: Callable[[R], str] = attrgetter("name")) -> None:
        self._kind, self._key = kind, key
        self._records: dict[str, R] = {}
        self._own: frozenset[str] = frozenset()

    def register(self, record: R) -> ExitStack:
        """Put a record in, at once, and return a context manager whose exit takes it out again.

        Raises
        ------
        ValueError : there is a record of this name already
        """
        name = self._key(record)
        if name in self._records:
            raise ValueError(f"there is a {self._kind} '{name}' already; expected another name")
        self._records[name] = record
        undo = ExitStack()
        undo.callback(self._records.pop, name, None)
        return undo

    def seal(self) -> None:
        """Say that what is registered so far is the program's own."""
        self._own = frozenset(self._records)

    def extras(self) -> tuple[R, ...]:
        """Return the records that came after ``seal``, which another process must be given."""
        return tuple(record for name, record in self._records.items() if name not in self._own)

    def is_own(self, name: str) -> bool:
        """Return whether a record is the program's own, which every process has."""
        return name in self._own

    def __getitem__(self, name: str) -> R:
        return self._records[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._records)

    def __len__(self) -> int:
        return len(self._records)


class Record:
    """Base of a record that is compared, hashed, printed and pickled by its name.

    A record of the program's own is pickled as its name alone; another one as a whole, so that a process that has not
    registered it can use it. A subclass is a frozen dataclass without ``eq`` and ``repr``; ``table`` is its Registry.
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
        return type(other) is type(self) and other.name == self.name if isinstance(other, Record) else NotImplemented

    def __hash__(self) -> int:
        return hash((type(self), self.name))

    def __reduce__(self) -> tuple[Callable[..., Record], tuple[Any, ...]]:
        values = None if self.table.is_own(self.name) else dict(vars(self))
        return _record, (type(self), self.name, values)


def _record(kind: type[Record], name: str, values: dict[str, Any] | None) -> Record:
    """Return a record that was pickled: the registered one where there is one of its name."""
    if values is None or name in kind.table:
        record: Record = kind.table[name]
        return record
    return kind(**values)
