"""The decorator ``dataclass``, as in the standard library, for classes that are made fast.

The standard library writes and compiles the methods of each class anew in every
process, half a millisecond a class. A proof of the whole paper takes as long as
two hundred of them, so here all classes share methods that were compiled once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import Any, NamedTuple, TypeVar, dataclass_transform, overload

T = TypeVar("T")

MISSING: Any = object()


class Field(NamedTuple):
    """An attribute of a data class: how it is made, shown and compared."""

    name: str = ""
    default: Any = MISSING
    default_factory: Callable[[], Any] | None = None
    repr: bool = True
    compare: bool = True


def field(
    *,
    default: Any = MISSING,
    default_factory: Callable[[], Any] | None = None,
    repr: bool = True,
    compare: bool = True,
) -> Any:
    """What stands behind an attribute whose default is made anew, or that is not compared."""
    return Field("", default, default_factory, repr, compare)


class FrozenError(AttributeError):
    """An attribute of a frozen data class was set."""


@overload
def dataclass(cls: type[T], /) -> type[T]: ...
@overload
def dataclass(*, frozen: bool = ..., eq: bool = ...) -> Callable[[type[T]], type[T]]: ...


@dataclass_transform(field_specifiers=(field,))
def dataclass(cls: Any = None, /, *, frozen: bool = False, eq: bool = True) -> Any:
    """Give a class the methods of a data class over its annotated attributes.

    >>> @dataclass(frozen=True)
    ... class Point:
    ...     x: int
    ...     y: int = 0
    >>> Point(1), Point(1) == Point(x=1, y=0), hash(Point(2)) == hash(Point(2))
    (Point(x=1, y=0), True, True)
    >>> Point()
    Traceback (most recent call last):
    TypeError: Point() misses “x”
    """
    return _made(cls, frozen, eq) if cls is not None else lambda it: _made(it, frozen, eq)


def fields(thing: Any) -> tuple[Field, ...]:
    """The attributes of a data class or of one of its instances, the inherited ones first."""
    found: tuple[Field, ...] = thing.__fields__
    return found


def replace(thing: T, **changes: Any) -> T:
    """A copy with some attributes changed."""
    kept = {entry.name: getattr(thing, entry.name) for entry in fields(thing)}
    return type(thing)(**{**kept, **changes})


def asdict(thing: Any) -> Any:
    """A data class as a dictionary, its parts as well."""
    if hasattr(type(thing), "__fields__"):
        return {entry.name: asdict(getattr(thing, entry.name)) for entry in fields(thing)}
    if isinstance(thing, list | tuple):
        return type(thing)(map(asdict, thing))
    if isinstance(thing, dict):
        return {key: asdict(value) for key, value in thing.items()}
    return thing


def _made(cls: Any, frozen: bool, eq: bool) -> Any:
    known = {entry.name: entry for entry in getattr(cls, "__fields__", ())}
    for name in cls.__annotations__:
        given = cls.__dict__.get(name, MISSING)
        known[name] = given._replace(name=name) if isinstance(given, Field) else Field(name, given)
        if isinstance(given, Field):
            delattr(cls, name)
    cls.__fields__ = tuple(known.values())
    type.__setattr__(cls, "__match_args__", tuple(known))  # type checkers allow no plain assignment
    cls.__init__ = _initializer(cls, tuple(known))
    if "__repr__" not in cls.__dict__:
        cls.__repr__ = _repr
    if eq and "__eq__" not in cls.__dict__:
        compared = [entry.name for entry in known.values() if entry.compare]
        cls.__key__ = attrgetter(*compared) if compared else type
        cls.__eq__ = _eq
        cls.__hash__ = _hash if frozen else None
    if frozen:
        cls.__setattr__ = cls.__delattr__ = _refuse
    return cls


def _initializer(cls: type, names: tuple[str, ...]) -> Callable[..., None]:
    count = len(names)
    finish = getattr(cls, "__post_init__", None)

    def initialize(self: Any, *values: Any, **named: Any) -> None:
        if named or len(values) != count:
            values = _completed(cls, values, named)
        self.__dict__.update(zip(names, values, strict=True))
        if finish is not None:
            finish(self)

    return initialize


def _completed(cls: type, values: tuple[Any, ...], named: Mapping[str, Any]) -> tuple[Any, ...]:
    """The values of all attributes, from those given by place, by name, and the defaults."""
    entries = fields(cls)
    if len(values) > len(entries):
        raise TypeError(f"{cls.__name__}() takes {len(entries)} values, not {len(values)}")
    completed = list(values)
    rest = dict(named)
    for entry in entries[len(values) :]:
        if entry.name in rest:
            completed.append(rest.pop(entry.name))
        elif entry.default_factory is not None:
            completed.append(entry.default_factory())
        elif entry.default is not MISSING:
            completed.append(entry.default)
        else:
            raise TypeError(f"{cls.__name__}() misses “{entry.name}”")
    if rest:
        raise TypeError(f"{cls.__name__}() has no use for “{next(iter(rest))}”")
    return tuple(completed)


def _repr(self: Any) -> str:
    shown = (f"{e.name}={getattr(self, e.name)!r}" for e in fields(self) if e.repr)
    return f"{type(self).__qualname__}({', '.join(shown)})"


def _eq(self: Any, other: Any) -> Any:
    if other.__class__ is not self.__class__:
        return NotImplemented
    key = self.__class__.__key__
    return key(self) == key(other)


def _hash(self: Any) -> int:
    return hash(self.__class__.__key__(self))


def _refuse(self: Any, name: str, *value: Any) -> None:
    raise FrozenError(f"“{name}” of {type(self).__name__} can't be changed")
