"""What experiment files can name."""

from __future__ import annotations

from typing import Optional, Union

from . import _decode
from ._arguments import option
from .program import PathLike, Program
from .results import PluginList


def plugins(kind: Optional[str] = None, *, program: Union[PathLike, Program, None] = None) -> PluginList:
    """Every component that experiment files can name: effects, robots, metrics, searches.

    Parameters
    ----------
    kind : str, optional
        Only of this kind, such as ``effect``. Default: all.
    program : path or Program, optional
        The program (`find_program`).
    """
    runner = program if isinstance(program, Program) else Program(program)
    finished = runner.run(["plugins", "list", "--json", *option("--kind", kind)])
    return _decode.decode(PluginList, _decode.parse(finished.output))
