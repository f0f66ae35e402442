# SPDX-License-Identifier: BSD-3-Clause
"""Meshes all surfaces of a folder: python -m featurehex batch FOLDER OUT [options].

Each model is meshed by a process of its own, so that none stops the others, with limits of time and
memory. A batch that was interrupted, however, goes on when it is started again. Several processes
may work on the same OUT, for instance the ranks of

    mpirun -np 4 pvbatch --sym -m featurehex batch FOLDER OUT [options]

They share the models through locks in OUT/.batch and need no other connection. Options that aren't
listed here are those of "featurehex mesh", the same for all models.

OUT receives meshes/NAME.vtu, reports/NAME.json, pictures/NAME.png, batch.tsv and index.html.
"""

import argparse
import ctypes
import os
import re
import signal
import subprocess
import sys
import threading
import time
from typing import Any, Dict, List, Optional, Sequence, Set, Tuple

from . import batch_page, programs
from .batch_model import Interrupted, Model, Report, Settings, locked

__all__ = ["main"]

EXTENSIONS = (".stl", ".obj", ".ply", ".off", ".vtp", ".vtk")
SUCCESS, FAILED, BAD_ARGUMENTS, UNWRITABLE, ABORTED = 0, 1, 2, 8, 7
#: Seconds between two looks at models that others have, and between two versions of the page.
_WAIT = 0.5
_PAGE_SECONDS = 30


def main(arguments: Sequence[str]) -> int:
    """Runs the batch; 0: all models have a valid mesh, 1: some have none, 2: bad arguments, 7:
    interrupted, 8: OUT can't be written."""
    try:
        models, jobs = _prepare(arguments)
        batch = _Batch(models)
        batch.run(jobs)
    except _BadArguments as error:
        return _complain("InvalidOption: %s" % error, BAD_ARGUMENTS)
    except OSError as error:
        return _complain("UnwritableFile: %s" % error, UNWRITABLE)
    if batch.settings.stop.is_set():
        return _complain("Aborted: %d of %d models are finished; the same command goes on with the "
                         "others." % (len(batch.done), len(models)), ABORTED)
    good = sum(report["status"]["code"] == "Ok" for report in batch.reports().values())
    _say("%d of %d models have a valid mesh: %s" % (
        good, len(models), os.path.join(batch.settings.output, "index.html")))
    return SUCCESS if good == len(models) else FAILED


class _BadArguments(Exception):
    """The arguments can't be used as they are."""


class _Batch:
    """All models and what this process has seen of them."""

    def __init__(self, models: List[Model]) -> None:
        self.models = models
        self.settings = models[0].settings
        self.done: Set[str] = set()
        self._unwritten: Dict[str, Report] = {}
        self._mutex = threading.Lock()
        self._last_page = time.monotonic()

    def run(self, jobs: int) -> None:
        """Returns when all models are finished, whoever finished them, or when told to stop."""
        old = {number: signal.signal(number, lambda *_: self.settings.stop.set())
               for number in (signal.SIGINT, signal.SIGTERM)}
        try:
            workers = [threading.Thread(target=self._work) for _ in range(jobs)]
            for worker in workers:
                worker.start()
            for worker in workers:
                while worker.is_alive():
                    # Python sees signals only between two of these.
                    worker.join(0.2)
        finally:
            for number, handler in old.items():
                # None: not of Python, and out of its reach.
                if handler is not None:
                    signal.signal(number, handler)
        self._write_summary()

    def reports(self) -> Dict[str, Report]:
        """Of the finished models, in their order."""
        found: Dict[str, Report] = {}
        for model in self.models:
            report = self._unwritten.get(model.name) or model.report()
            if report is not None:
                found[model.name] = report
        return found

    def _work(self) -> None:
        while not self.settings.stop.is_set():
            left = [model for model in self.models if model.name not in self.done]
            if not left:
                return
            if not any([self._take(model) for model in left]):
                # Others have them. Wait: should one of those die, its models are free again.
                self.settings.stop.wait(_WAIT)

    def _take(self, model: Model) -> bool:
        """Finishes the model unless somebody else has it."""
        if self.settings.stop.is_set() or model.name in self.done:
            return True
        try:
            with model.lock() as lock:
                if lock is None:
                    return False
                if not model.finished():
                    self._announce(model, model.make(lock))
                if self.settings.pictures and not model.drawn():
                    error = model.draw()
                    if error:
                        _say("%s: no picture: %s" % (model.name, error))
        except Interrupted:
            return True
        except Exception as error:  # pylint: disable=broad-except
            # Whatever it is, the other models go on.
            failure = {"status": {"code": "Unexpected", "message": "%s: %s" % (
                type(error).__name__, error)}, "figures": {}}
            self._unwritten[model.name] = failure
            self._announce(model, failure)
        with self._mutex:
            self.done.add(model.name)
        if time.monotonic() - self._last_page > _PAGE_SECONDS:
            self._write_summary()
        return True

    def _announce(self, model: Model, report: Report) -> None:
        row = batch_page.row_of(model.name, report)
        words = ("%d hexes, scaled Jacobian >= %.3f, %.1f s" % (
            row["hexes"], row["msj"], row["seconds"])
            if row["status"] == "Ok" else "%s: %s" % (row["status"], row["error"]))
        with self._mutex:
            _say("[%d/%d] %s: %s" % (len(self.done) + 1, len(self.models), model.name, words))

    def _write_summary(self) -> None:
        with locked(os.path.join(self.settings.output, ".batch", "page.lock"), wait=True):
            self._last_page = time.monotonic()
            reports = self.reports()
            batch_page.write_table(os.path.join(self.settings.output, "batch.tsv"), reports)
            batch_page.write_page(self.settings, [model.name for model in self.models], reports)


def _prepare(arguments: Sequence[str]) -> Tuple[List[Model], int]:
    """The models and how many at once. Raises _BadArguments, OSError."""
    options, passed_on = _parse(arguments)
    if not os.path.isdir(options.folder):
        raise _BadArguments("%s is no folder." % options.folder)
    surfaces = _surfaces(options.folder, options.out)
    if not surfaces:
        raise _BadArguments("There are no surfaces (%s) in %s." % (
            ", ".join(EXTENSIONS), options.folder))
    os.makedirs(os.path.join(options.out, ".batch"), exist_ok=True)
    try:
        program = programs.featurehex()
    except FileNotFoundError as error:
        raise _BadArguments(str(error)) from error
    neighbours = int(os.environ.get("OMPI_COMM_WORLD_LOCAL_SIZE", "1"))
    threads = options.threads or max(1, len(os.sched_getaffinity(0)) // options.jobs // neighbours)
    settings = Settings(
        output=options.out, program=program, version=_version(program), options=passed_on,
        threads=threads, time_limit=options.time_limit,
        memory_limit=int(options.memory_limit * 1e6), retry_failed=options.retry_failed,
        pictures=options.pictures)
    _try_options(settings)
    models = [Model(name, os.path.join(options.folder, path),
                    _features(options.features, path), settings)
              for name, path in surfaces]
    return models, options.jobs


def _parse(arguments: Sequence[str]) -> Tuple[argparse.Namespace, List[str]]:
    parser = _Parser(
        prog="python -m featurehex batch", description=__doc__, allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="Exit code 0: all models have a valid mesh, 1: some have none, 2: bad arguments, "
        "7: interrupted,\n8: OUT can't be written.")
    parser.add_argument("folder", metavar="FOLDER", help="with surfaces, also in folders of it")
    parser.add_argument("out", metavar="OUT", help="folder for the results")
    parser.add_argument("--jobs", metavar="N", type=_positive, default=1,
                        help="models at the same time (default 1)")
    parser.add_argument("--threads", metavar="N", type=_positive, default=0,
                        help="of each model (default: its share of the cores)")
    parser.add_argument("--time-limit", metavar="S", type=_limit, default=600.0,
                        help="seconds for each model; 0: none (default 600)")
    parser.add_argument("--memory-limit", metavar="MB", type=_limit, default=0.0,
                        help="that each model may use; 0: none (default)")
    parser.add_argument("--features", metavar="DIR",
                        help="sharp features of NAME are DIR/NAME.fgraph, where there is one")
    parser.add_argument("--retry-failed", action="store_true",
                        help="try once more what has failed before")
    parser.add_argument("--no-pictures", dest="pictures", action="store_false",
                        help="the page has no pictures (they need xvfb-run or a display)")
    options, passed_on = parser.parse_known_args(list(arguments))
    for option in passed_on:
        if re.match("(-o|--output|--report)(=|$)", option):
            raise _BadArguments("%s is chosen by the batch itself." % option)
    return options, passed_on


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> Any:
        raise _BadArguments(message + ". --help explains.")


def _positive(text: str) -> int:
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("%s is not at least 1" % text)
    return value


def _limit(text: str) -> float:
    value = float(text)
    if not 0 <= value < float("inf"):
        raise argparse.ArgumentTypeError("%s is not at least 0" % text)
    return value


def _surfaces(folder: str, out: str) -> List[Tuple[str, str]]:
    """(name, path in the folder) of each; names are unique and those of the results."""
    paths = []
    for place, folders, files in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and
                            os.path.realpath(os.path.join(place, name)) != os.path.realpath(out))
        paths += [os.path.relpath(os.path.join(place, name), folder) for name in files
                  if name.lower().endswith(EXTENSIONS) and not name.startswith(".")]
    stems = [os.path.splitext(path)[0] for path in paths]
    return sorted((path if stems.count(stem) > 1 else stem, path)
                  for stem, path in zip(stems, paths))


def _features(folder: Optional[str], path: str) -> Optional[str]:
    stem = os.path.splitext(path)[0]
    for name in (stem, os.path.basename(stem)) if folder else ():
        features = os.path.join(folder or "", name + ".fgraph")
        if os.path.exists(features):
            return features
    return None


def _version(program: str) -> str:
    return subprocess.run([program, "--version"], env=programs.environment(), text=True,
                          stdout=subprocess.PIPE, check=False).stdout.strip()


def _try_options(settings: Settings) -> None:
    """A mistake in the options is one for all models. Raises _BadArguments."""
    nothing = os.path.join(settings.output, ".batch", "nothing")
    done = subprocess.run(
        [settings.program, "mesh", nothing + ".stl", "-o", nothing + ".%d.vtu" % os.getpid(),
         *settings.options], env=programs.environment(), text=True, errors="replace",
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
    if done.returncode == BAD_ARGUMENTS:
        raise _BadArguments(done.stderr.strip().replace("featurehex: InvalidOption: ", ""))


def _say(text: str) -> None:
    print(text, flush=True)
    # pvpython writes through C++, which keeps the lines until the end unless it is a terminal.
    ctypes.CDLL(None).fflush(None)


def _complain(text: str, code: int) -> int:
    print("featurehex: " + text, file=sys.stderr, flush=True)
    return code
