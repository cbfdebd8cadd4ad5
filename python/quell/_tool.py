"""Sequences on disk, through the installed tool `quell`, which is not part of the package."""
from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
from typing import Any, Dict, Mapping, Optional, Sequence, Union

from ._library import Error
from ._settings import Settings, as_settings

Path = Union[str, "os.PathLike[str]"]


def _tool() -> str:
    """$QUELL_TOOL, else `quell` in the PATH."""
    found = os.environ.get("QUELL_TOOL") or shutil.which("quell")
    if not found:
        raise Error("FileError in tool: expected the program quell in PATH, or named by QUELL_TOOL, got none; the tool is "
                    "built from Quell's sources or installed as the package quell", "FileError", "tool", "quell")
    return found


def _report(arguments: Sequence[str]) -> Dict[str, Any]:
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        done = subprocess.run([_tool(), *arguments, "--json", str(report)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, check=False)
        if done.returncode != 0:
            message = done.stderr.strip().split("\n")[-1] if done.stderr.strip() else done.stdout.strip()
            message = message[len("quell: "):] if message.startswith("quell: ") else message
            code = message.split(" ", 1)[0]
            raise Error(message, code if code.isalpha() else "InvalidArgument", arguments[0])
        return json.loads(report.read_text())


def denoise_sequence(input: Union[Path, Sequence[Path]], output: Optional[Path] = None,
                     settings: Union[Settings, str, Mapping[str, Any], None] = None,
                     options: Sequence[str] = ()) -> Dict[str, Any]:
    """Denoises frames on disk: one or several OpenEXR files, a folder, or a pattern, as `quell denoise --input` takes them.

    Writes denoised_NNNN.exr and display_NNNN.png into the folder ``output`` and returns the report: times by stage, memory,
    and errors where there are references. ``options`` are further options of the tool, for example ("--frames", "0-9").
    """
    inputs = [input] if isinstance(input, (str, os.PathLike)) else list(input)
    chosen = as_settings(settings)
    arguments = ["denoise", "--method", chosen.method, "--input", *(os.fspath(path) for path in inputs)]
    for name, given in chosen.items():
        as_text = {True: "on", False: "off"}[given] if isinstance(given, bool) else str(given)
        arguments += ["--set", f"{name}={as_text}"]
    if output is not None:
        arguments += ["--output", os.fspath(output)]
    return _report([*arguments, *options])


def compare(reference: Union[Path, Sequence[Path]], images: Sequence[Path], options: Sequence[str] = ()) -> Dict[str, Any]:
    """Error figures of images on disk against a reference, or against two independent halves of one, as `quell compare`
    prints them: RMSE, PSNR, SSIM, FLIP and relMSE by image."""
    references = [reference] if isinstance(reference, (str, os.PathLike)) else list(reference)
    return _report(["compare", "--reference", ",".join(os.fspath(path) for path in references),
                    *(os.fspath(path) for path in images), *options])
