# SPDX-License-Identifier: BSD-3-Clause
"""Runs the filters while other Python threads go on, and turns their errors into exceptions."""

import ctypes
import os
import re
from typing import Callable, List, Optional

__all__ = ["MeshingError", "Progress", "update"]

#: Called with the share that is done, 0 to 1, and the phase in words. True as result: stop.
Progress = Callable[[float, str], Optional[bool]]

_ProgressFunction = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, ctypes.c_char_p)
_WarningFunction = ctypes.CFUNCTYPE(None, ctypes.c_char_p)
_LONGEST_MESSAGE = 100000

# CDLL releases the global interpreter lock around each call, and callbacks take it again.
_library = ctypes.CDLL(os.path.join(os.path.dirname(__file__), "UpdateAlgorithm.so"))
_update = _library.FeatureHexUpdateAlgorithm
_update.argtypes = [ctypes.c_void_p, _ProgressFunction, _WarningFunction, ctypes.c_char_p,
                    ctypes.c_size_t]
_update.restype = ctypes.c_int
_name_of = _library.FeatureHexStatusCodeName
_name_of.argtypes = [ctypes.c_int]
_name_of.restype = ctypes.c_char_p


class MeshingError(RuntimeError):
    """There is no result; the text says what is wrong, where, how much and what to do.

    code: "OpenBoundary", "TimeLimit" and so on, the names that the command line prints.
    """

    def __init__(self, code: str, message: str) -> None:
        super().__init__(message)
        self.code = code


def update(algorithm, progress: Optional[Progress] = None) -> List[str]:
    """Updates a filter, reader or writer of VTK; the warnings it gave, in words.

    In contrast to algorithm.Update() other threads of Python run meanwhile, Ctrl-C stops it
    (KeyboardInterrupt), and nothing is printed. It must have no observers written in Python: VTK
    9.1 calls them without the interpreter lock.

    Raises MeshingError; its code is "Aborted" when progress asked to stop.
    """
    warnings: List[str] = []
    raised: List[BaseException] = []

    def hear_progress(share: float, phase: bytes) -> int:
        try:
            return 1 if progress and progress(share, phase.decode(errors="replace")) else 0
        except BaseException as error:  # also KeyboardInterrupt: none may pass through C++
            raised.append(error)
            return 1

    def hear_warning(message: bytes) -> None:
        warnings.append(" ".join(message.decode(errors="replace").split()))

    address = int(re.match("_([0-9a-f]+)_p_", algorithm.__this__).group(1), 16)
    message = ctypes.create_string_buffer(_LONGEST_MESSAGE)
    code = _update(address, _ProgressFunction(hear_progress), _WarningFunction(hear_warning),
                   message, len(message))
    if raised:
        raise raised[0]
    if code != 0:
        text = " ".join(message.value.decode(errors="replace").split())
        raise MeshingError(_name_of(code).decode(), text or "Stopped.")
    return warnings
