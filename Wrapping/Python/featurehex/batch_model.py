# SPDX-License-Identifier: BSD-3-Clause
"""One model of a batch: a process of its own with limits, a report, a picture."""

import contextlib
import fcntl
import glob
import hashlib
import json
import os
import resource
import signal
import subprocess
import threading
import time
from dataclasses import dataclass, field
from typing import Any, Dict, Iterator, List, Optional, Tuple

from . import programs

__all__ = ["Interrupted", "Model", "Settings"]

Report = Dict[str, Any]

#: Seconds after the time limit, which the process itself keeps, until it is killed.
GRACE = 30.0
POLL = 0.05
_PICTURE_SECONDS = 300


class Interrupted(Exception):
    """The batch is told to stop."""


@dataclass
class Settings:
    """What all models of a batch have in common."""

    output: str  #: folder
    program: str  #: path of featurehex
    version: str
    options: List[str]  #: of featurehex mesh
    threads: int = 0
    time_limit: float = 0.0  #: seconds, 0: none
    memory_limit: int = 0  #: bytes resident, 0: none
    retry_failed: bool = False  #: what failed before this batch started
    started: float = field(default_factory=time.time)
    pictures: bool = True
    stop: threading.Event = field(default_factory=threading.Event)


@dataclass
class Model:
    """A surface of the folder and where everything about it goes."""

    name: str  #: path in the folder without extension; the names of its files
    surface: str
    features: Optional[str]  #: .fgraph
    settings: Settings
    _key: str = ""

    def path(self, folder: str, extension: str) -> str:
        return os.path.join(self.settings.output, folder, self.name + extension)

    @property
    def mesh(self) -> str:
        return self.path("meshes", ".vtu")

    @property
    def picture(self) -> str:
        return self.path("pictures", ".png")

    def report(self) -> Optional[Report]:
        """What is known of the model, None while it isn't finished."""
        try:
            with open(self.path("reports", ".json"), encoding="utf-8") as file:
                report = json.load(file)
            return report if report["batch"]["key"] == self._make_key() else None
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def finished(self) -> bool:
        """Whether nothing is left to do but the picture."""
        report = self.report()
        if report is None:
            return False
        code, made = report["status"]["code"], report["batch"]
        if code == "Ok":
            return os.path.exists(self.mesh)
        if self.settings.retry_failed and made["time"] < self.settings.started:
            return False
        # Other limits: another try.
        return not (code == "TimeLimit" and made["time-limit"] != self.settings.time_limit
                    or code == "OutOfMemory" and made["memory-limit"] != self.settings.memory_limit)

    @contextlib.contextmanager
    def lock(self) -> Iterator[Optional[int]]:
        """Nobody else has the model meanwhile; None: somebody else has it.

        A lock ends with its last process: no crash leaves one behind.
        """
        with locked(self.path(".batch", ".lock")) as descriptor:
            yield descriptor

    def make(self, lock: int) -> Report:
        """Meshes the model. Raises Interrupted."""
        raw = self.path(".batch", ".json")
        files = [self.path("reports", ".json"), raw, self.mesh, self.picture]
        for path in files:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with contextlib.suppress(FileNotFoundError):
                os.remove(path)
        start = time.monotonic()
        code, killed, peak, errors = self._run(self._command(raw), lock)
        # Of a process that was killed, now or in an earlier batch.
        for path in files:
            for leftover in glob.glob(glob.escape(path) + ".part-*"):
                os.remove(leftover)
        try:
            with open(raw, encoding="utf-8") as file:
                report = json.load(file)
            os.remove(raw)
        except (OSError, ValueError):
            report = {"command": "mesh", "input": {"file": self.surface}, "figures": {}}
        if code != 0 or report.get("status", {}).get("code") != "Ok":
            report["status"] = self._failure(report.get("status", {}), code, killed, errors)
        # A process that was forked has the peak of its parent to begin with.
        own = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        if report.get("peak-memory-bytes", 0) <= own:
            report["peak-memory-bytes"] = peak
        report["batch"] = {
            "key": self._make_key(), "time": time.time(), "exit-code": code,
            "seconds": time.monotonic() - start, "time-limit": self.settings.time_limit,
            "memory-limit": self.settings.memory_limit}
        write(self.path("reports", ".json"), json.dumps(report, indent=2) + "\n")
        return report

    def drawn(self) -> bool:
        """Whether there is a picture, or no use in another try."""
        if os.path.exists(self.picture):
            return True
        try:
            path = self.path(".batch", ".undrawn")
            if self.settings.retry_failed and os.path.getmtime(path) < self.settings.started:
                return False
            with open(path, encoding="ascii") as file:
                return file.read() == self._make_key()
        except OSError:
            return False

    def draw(self) -> str:
        """Makes the picture: the mesh cut open, of a failed model the surface. The error, or ""."""
        have_mesh = os.path.exists(self.mesh)
        source = self.mesh if have_mesh else self.surface
        temporary = self.path(".batch", ".png")
        command = [*programs.drawing_python(), os.path.join(programs.PACKAGE, "picture.py"), source,
                   temporary, "--size", "320x320", "--no-legend", "--axis", "auto"]
        if not have_mesh and self.features and source.lower().endswith(".obj"):
            command += ["--features", self.features]
        # One at a time: xvfb-run looks for a free display.
        with locked(os.path.join(self.settings.output, ".batch", "picture.lock"), wait=True):
            message = _draw(command)
        if not message and os.path.exists(temporary):
            os.replace(temporary, self.picture)
            return ""
        write(self.path(".batch", ".undrawn"), self._make_key())
        return message or "the program that draws left none"

    def _make_key(self) -> str:
        """Changes with all that the result depends on."""
        if not self._key:
            digest = hashlib.sha256(repr((self.settings.version, self.settings.options)).encode())
            for path in (self.surface, self.features):
                with contextlib.suppress(OSError):
                    if path:
                        with open(path, "rb") as file:
                            digest.update(file.read())
                digest.update(b"|")
            self._key = digest.hexdigest()
        return self._key

    def _command(self, report: str) -> List[str]:
        command = [self.settings.program, "mesh", self.surface, "-o", self.mesh, "--report", report,
                   "--time-limit", "%.17g" % self.settings.time_limit,
                   "--threads", str(self.settings.threads), *self.settings.options]
        if self.features:
            command += ["--features", self.features]
        return command

    def _run(self, command: List[str], lock: int) -> Tuple[int, str, int, List[str]]:
        """(exit code, killed for what, peak memory in bytes, lines of standard error)"""
        settings = self.settings
        start = time.monotonic()
        peak = 0
        with open(self.path(".batch", ".err"), "w+b") as errors:
            # A session of its own: Ctrl-C is for the batch, which passes it on. It keeps the lock,
            # should the batch be killed.
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors,
                env=programs.environment(), start_new_session=True, pass_fds=[lock])
            killed = ""
            while process.poll() is None:
                # Watched from outside: libraries crash where the system refuses them memory.
                peak = max(peak, _peak_memory(process.pid))
                if settings.memory_limit and peak > settings.memory_limit:
                    killed = "OutOfMemory"
                elif settings.time_limit and time.monotonic() - start > settings.time_limit + GRACE:
                    killed = "TimeLimit"
                if killed:
                    process.kill()
                    process.wait()
                elif settings.stop.wait(POLL):
                    _end(process)
                    raise Interrupted
            errors.seek(0)
            lines = errors.read().decode(errors="replace").strip().splitlines()
        os.remove(self.path(".batch", ".err"))
        return process.returncode, killed, peak, lines

    def _failure(self, status: Report, code: int, killed: str, errors: List[str]) -> Report:
        """The status of a model without a mesh, in words."""
        last = errors[-1] if errors else ""
        if killed == "OutOfMemory":
            status = {"code": killed, "message": "Memory limit of %d MB reached. Raise it, or the "
                      "edge length." % (self.settings.memory_limit // 10**6)}
        elif killed:
            status = {"code": killed, "message": "Killed: it went on for %g s after its time limit "
                      "of %g s." % (GRACE, self.settings.time_limit)}
        elif not status and code == -signal.SIGKILL:
            status = {"code": "Killed", "message": "Killed from outside, perhaps by the system "
                      "when memory ran out: set a memory limit, or start fewer models at once."}
        elif not status and code < 0:
            status = {"code": "Crash", "message": "Ended by %s. %s" % (_signal_name(-code), last)}
        elif not status:
            # "featurehex: OpenBoundary: ..."
            words = last.split(": ", 2)
            status = {"code": words[1] if len(words) == 3 else "Unexpected",
                      "message": words[-1] or "Ended with exit code %d, without a word." % code}
        return {**status, "exit-code": code}


@contextlib.contextmanager
def locked(path: str, wait: bool = False) -> Iterator[Optional[int]]:
    """The descriptor of a file that is locked meanwhile; None: somebody else has the lock."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
        except BlockingIOError:
            yield None
        else:
            yield descriptor
    finally:
        os.close(descriptor)


def write(path: str, text: str) -> None:
    """Complete or not at all."""
    temporary = "%s.%d.%d.part" % (path, os.getpid(), threading.get_ident())
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(temporary, path)


def _draw(command: List[str]) -> str:
    """The error, or ""."""
    try:
        with subprocess.Popen(
                command, env=programs.environment(), text=True, errors="replace",
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                start_new_session=True) as process:
            try:
                output, _ = process.communicate(timeout=_PICTURE_SECONDS)
            except subprocess.TimeoutExpired:
                # With the display that xvfb-run has started.
                os.killpg(process.pid, signal.SIGKILL)
                return "no end within %d s" % _PICTURE_SECONDS
    except OSError as error:
        return str(error)
    lines = output.strip().splitlines()
    return "" if process.returncode == 0 else lines[-1] if lines else (
        "exit code %d" % process.returncode)


def _end(process: "subprocess.Popen[bytes]") -> None:
    """Ctrl-C for the process: it stops soon and leaves nothing behind."""
    process.terminate()
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _peak_memory(pid: int) -> int:
    """Largest resident size so far, bytes."""
    with contextlib.suppress(OSError, ValueError, IndexError):
        with open("/proc/%d/status" % pid, encoding="ascii", errors="replace") as file:
            for line in file:
                if line.startswith("VmHWM:"):
                    return 1024 * int(line.split()[1])
    return 0


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return "signal %d" % number
