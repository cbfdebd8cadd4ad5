"""The shared library: found, loaded, and its failures as exceptions."""
from __future__ import annotations

import ctypes.util
import os
import pathlib
from typing import Any, Iterable

import cffi

_FOLDER = pathlib.Path(__file__).resolve().parent


class Error(Exception):
    """Every failure that the library or the tool reports; ``str()`` is one sentence made of all the fields.

    ``code`` is one of "InvalidArgument", "UnknownSetting", "OutOfRange", "NotPrepared", "WrongContext", "BuildFailed",
    "DeviceError", "OutOfMemory", "NoDevice", "FileError" and "InternalError"; it is stable across releases.
    """

    def __init__(self, message: str, code: str, stage: str = "", buffer: str = "", expected: str = "", got: str = ""):
        super().__init__(message)
        self.code = code
        self.stage = stage  #: the stage or function that refused
        self.buffer = buffer  #: the image, setting, argument or file concerned; may be empty
        self.expected = expected  #: with unit
        self.got = got


def invalid(function: str, argument: str, expected: str, got: object) -> Error:
    """An error of this package's own, in the words of the library's."""
    message = f"InvalidArgument in {function}, {argument}: expected {expected}, got {got}"
    return Error(message, "InvalidArgument", function, argument, expected, str(got))


def _read_declarations() -> str:
    try:
        return (_FOLDER / "declarations.h").read_text()
    except FileNotFoundError:
        raise ImportError(
            f"{_FOLDER} is the source of the package: `pip install .`, or build the target quell_python and put "
            "python/ of the build folder into PYTHONPATH") from None


def _library_path() -> str:
    """$QUELL_LIBRARY, else the library beside this file, else the system's."""
    named = os.environ.get("QUELL_LIBRARY")
    if named:
        return named
    beside = sorted(_FOLDER.glob("libquell.*"))
    found = str(beside[0]) if beside else ctypes.util.find_library("quell")
    if not found:
        raise ImportError(f"no libquell.so in {_FOLDER} nor in the system's folders; QUELL_LIBRARY may name one")
    return found


ffi = cffi.FFI()
ffi.cdef(_read_declarations())
lib: Any = ffi.dlopen(_library_path())


def text(pointer: Any) -> str:
    """A text of the library's; NULL counts as empty."""
    return ffi.string(pointer).decode() if pointer != ffi.NULL else ""


def new(struct: str) -> Any:
    """A struct as QUELL_INIT leaves it: zero but for its size."""
    made = ffi.new(struct + "*")
    made.structSize = ffi.sizeof(struct)
    return made


def check(status: int) -> None:
    """Raises Error unless status is that of success."""
    if status == lib.QUELL_SUCCESS:
        return
    error = new("quell_error")
    lib.quellGetLastError(error)
    raise Error(text(error.message) or text(lib.quellStatusName(status)), text(lib.quellStatusName(status)),
                text(error.stage), text(error.buffer), text(error.expected), text(error.got))


def filled(function: Any, struct: str, *arguments: Any) -> Any:
    """The struct that a function fills through its last argument."""
    result = new(struct)
    check(function(*arguments, result))
    return result


def value(function: Any, kind: str, *arguments: Any) -> Any:
    """The number or pointer that a function writes through its last argument."""
    result = ffi.new(kind + "*")
    check(function(*arguments, result))
    return result[0]


def handle(kind: str, thing: Any) -> Any:
    """The OpenCL handle in an object of pyopencl."""
    return ffi.cast(kind, thing.int_ptr)


def enumerator(function: str, argument: str, prefix: str, names: Iterable[str], name: str) -> int:
    """The number that quell.h has for ``name``: of prefix "QUELL_TIMERS_" and name "host" that of QUELL_TIMERS_HOST."""
    if name not in names:
        raise invalid(function, argument, "one of " + ", ".join(names), repr(name))
    return getattr(lib, prefix + name.upper())


#: The library's version, for example "0.1.0".
version = text(lib.quellVersion())
