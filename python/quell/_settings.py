"""Methods and the values of their settings."""
from __future__ import annotations

import dataclasses
import functools
import numbers
from typing import Any, Dict, Iterator, Mapping, MutableMapping, Tuple, Union

from ._library import check, ffi, filled, lib, text, value

Value = Union[bool, int, float, str]


@dataclasses.dataclass(frozen=True)
class SettingInfo:
    """What a setting means and which values it takes."""

    name: str
    kind: str  #: "real", "integer", "boolean", "choice" or "text"
    default: Value
    minimum: float
    maximum: float
    unit: str  #: empty: a plain number
    description: str
    source: str  #: paper and section, or how the default was found
    choices: Tuple[str, ...] = ()


@dataclasses.dataclass(frozen=True)
class InputNeed:
    """Whether a method reads an image."""

    use: str  #: "unused", "optional" or "required"
    without: str  #: what counts without it


def methods() -> Dict[str, str]:
    """The names of all methods with one line on each, the default one first."""
    infos = [filled(lib.quellGetMethod, "quell_method_info", i) for i in range(value(lib.quellCountMethods, "size_t"))]
    return {text(info.name): text(info.summary) for info in infos}


def _kind_names() -> Dict[int, str]:
    return {getattr(lib, "QUELL_SETTING_" + name.upper()): name
            for name in ("real", "integer", "boolean", "choice", "text")}


def _setting_info(method: str, index: int) -> SettingInfo:
    info = filled(lib.quellGetSettingInfo, "quell_setting_info", method.encode(), index)
    kind = _kind_names()[info.kind]
    choices = tuple(text(value(lib.quellGetSettingChoice, "const char*", method.encode(), index, choice))
                    for choice in range(info.choiceCount))
    default: Value = info.defaultValue
    if kind == "choice":
        default = choices[int(info.defaultValue)]
    elif kind == "text":
        default = text(info.defaultText)
    elif kind != "real":
        default = {"boolean": bool, "integer": int}[kind](info.defaultValue)
    return SettingInfo(text(info.name), kind, default, info.minimum, info.maximum, text(info.unit),
                       text(info.description), text(info.source), choices)


@functools.lru_cache(maxsize=None)
def describe(method: str = "quell") -> Tuple[SettingInfo, ...]:
    """The settings of a method. Raises Error("UnknownSetting") for an unknown one."""
    created = Settings(method)  # which refuses unknown methods by name
    for i in range(value(lib.quellCountMethods, "size_t")):
        info = filled(lib.quellGetMethod, "quell_method_info", i)
        if text(info.name) == created.method:
            return tuple(_setting_info(created.method, index) for index in range(info.settingCount))
    return ()


class Settings(MutableMapping[str, Value]):
    """A method and the values of its settings, which start at the defaults.

    ``Settings("svgf", taa=False, luminanceSigma=2.5, toneMap="aces")``; also by item: ``settings["taa"] = False``. Values
    are checked by the library: Error("UnknownSetting") and Error("OutOfRange") name what was expected. Settings are never
    deleted.
    """

    def __init__(self, method: str = "quell", **values: Value):
        self._handle = ffi.gc(value(lib.quellCreateSettings, "quell_settings*", method.encode()),
                              lib.quellDestroySettings)
        self.update(values)

    @property
    def method(self) -> str:
        return text(value(lib.quellGetSettingsMethod, "const char*", self._handle))

    def __setitem__(self, name: str, given: Value) -> None:
        if isinstance(given, str):
            check(lib.quellSetSetting(self._handle, name.encode(), given.encode()))
        elif isinstance(given, (numbers.Real, bool)) or hasattr(given, "__float__"):
            check(lib.quellSetSettingNumber(self._handle, name.encode(), float(given)))
        else:
            check(lib.quellSetSetting(self._handle, name.encode(), str(given).encode()))

    def __getitem__(self, name: str) -> Value:
        as_text = text(value(lib.quellGetSetting, "const char*", self._handle, name.encode()))
        kind = next(info.kind for info in describe(self.method) if info.name == name)
        if kind in ("choice", "text"):
            return as_text
        number = value(lib.quellGetSettingNumber, "double", self._handle, name.encode())
        return {"boolean": bool, "integer": int, "real": float}[kind](number)

    def __delitem__(self, name: str) -> None:
        raise TypeError("settings are set, not deleted")

    def __iter__(self) -> Iterator[str]:
        return (info.name for info in describe(self.method))

    def __len__(self) -> int:
        return len(describe(self.method))

    def __repr__(self) -> str:
        changed = {info.name: self[info.name] for info in describe(self.method) if self[info.name] != info.default}
        return f"Settings({', '.join([repr(self.method)] + [f'{name}={given!r}' for name, given in changed.items()])})"

    def use_preset(self, preset: str) -> None:
        """"default" sets everything; "paper" what the method's paper says where the default is something else."""
        check(lib.quellUsePreset(self._handle, preset.encode()))

    def input_needs(self) -> Dict[str, InputNeed]:
        """Which images the method reads with these settings; needs no device."""
        uses = {lib.QUELL_UNUSED: "unused", lib.QUELL_OPTIONAL: "optional", lib.QUELL_REQUIRED: "required"}
        needs = {}
        for index in range(value(lib.quellCountInputNeeds, "size_t", self._handle)):
            need = filled(lib.quellGetInputNeed, "quell_input_need", self._handle, index)
            needs[text(need.image)] = InputNeed(uses[need.use], text(need.without))
        return needs


def as_settings(given: Any) -> Settings:
    """Settings as they are; a mapping as those of the default method; None: the defaults; a name: that method's."""
    if isinstance(given, Settings):
        return given
    if isinstance(given, str):
        return Settings(given)
    if isinstance(given, Mapping):
        return Settings(**given)
    return Settings()
