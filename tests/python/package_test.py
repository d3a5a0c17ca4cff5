"""What the package promises of itself: types, documented names, arguments as the program takes them."""

from __future__ import annotations

import dataclasses
import inspect
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any, Optional

import lacuna
from lacuna import _decode, results
from lacuna._arguments import file_argument, option, repeated, toml_value
from support import SOURCE


class DocumentationTest(unittest.TestCase):
    def public_classes(self) -> list[type]:
        names = [(lacuna, name) for name in lacuna.__all__] + [(results, name) for name in results.__all__]
        found = [getattr(module, name) for module, name in names]
        return [one for one in found if inspect.isclass(one)]

    def test_every_field_is_described(self) -> None:
        checked = 0
        for kind in self.public_classes():
            if not dataclasses.is_dataclass(kind):
                continue
            described = {name for one in kind.__mro__ if dataclasses.is_dataclass(one) for name in _described(one.__doc__ or "")}
            for one in dataclasses.fields(kind):
                self.assertIn(one.name, described, f"{kind.__name__}.{one.name} is not described")
                checked += 1
        self.assertGreater(checked, 150)

    def test_every_public_method_is_described_with_its_parameters(self) -> None:
        for kind in self.public_classes():
            for name, member in vars(kind).items():
                function = member.__func__ if isinstance(member, classmethod) else member
                if name.startswith("_") or not inspect.isfunction(function):
                    continue
                with self.subTest(f"{kind.__name__}.{name}"):
                    text = inspect.getdoc(getattr(kind, name)) or ""
                    self.assertTrue(text, "has no description")
                    if "Parameters" in text:
                        wanted = set(inspect.signature(function).parameters) - {"self", "cls"}
                        self.assertLessEqual(wanted, _described(text))

    def test_what_is_exported_is_there(self) -> None:
        for module in (lacuna, results):
            for name in module.__all__:
                self.assertTrue(hasattr(module, name), name)


class TypesTest(unittest.TestCase):
    def setUp(self) -> None:
        if shutil.which("mypy") is None:
            self.skipTest("mypy is not installed (Debian: mypy)")

    def mypy(self, *files: str) -> str:
        """What mypy says against files, named from the root of the source."""
        with tempfile.TemporaryDirectory() as cache:
            command = ["mypy", "--strict", "--config-file", "python/pyproject.toml", "--cache-dir", cache, *files]
            environment = {**os.environ, "MYPYPATH": "python:tests/python"}
            done = subprocess.run(command, cwd=SOURCE, env=environment, capture_output=True, text=True)
        return "" if done.returncode == 0 else done.stdout + done.stderr

    def test_the_package_is_typed_for_the_oldest_python_and_its_tests_use_it_so(self) -> None:
        self.assertEqual(self.mypy("python/lacuna"), "")
        tests = [str(file.relative_to(SOURCE)) for file in (SOURCE / "tests" / "python").glob("*.py")]
        self.assertEqual(self.mypy("--python-version", "3.11", *tests), "")
        self.assertTrue((SOURCE / "python" / "lacuna" / "py.typed").exists())


class VersionTest(unittest.TestCase):
    def test_is_that_of_the_program_and_of_the_project_file(self) -> None:
        self.assertEqual(lacuna.Program().version(), lacuna.__version__)
        project = (SOURCE / "python" / "pyproject.toml").read_text()
        self.assertIn(f'\nversion = "{lacuna.__version__}"\n', project)


class ArgumentsTest(unittest.TestCase):
    def test_values_become_toml(self) -> None:
        cases: list[tuple[object, str]] = [
            (True, "true"),
            (4, "4"),
            (0.0005, "0.0005"),
            (1e-9, "1e-09"),
            (math.inf, "inf"),
            ('say "2 ms"', '"say \\"2 ms\\""'),
            ("Öl\n", '"Öl\\n"'),
            (Path("a/b"), '"a/b"'),
            ([0.0, "1 kg"], '[0.0, "1 kg"]'),
            ({"body.*.mass": [1, 2]}, '{"body.*.mass" = [1, 2]}'),
        ]
        for value, text in cases:
            self.assertEqual(toml_value(value), text)
        with self.assertRaisesRegex(TypeError, "has no form in TOML"):
            toml_value(object())

    def test_options_are_left_out_where_they_have_no_value(self) -> None:
        self.assertEqual(option("--out", None) + option("--as-is", False) + option("--as-is", True), ["--as-is"])
        self.assertEqual(option("--duration", 0.5) + option("--out", Path("p")), ["--duration", "0.5", "--out", "p"])
        self.assertEqual(repeated("--where", "joint.hinge"), ["--where", "joint.hinge"])
        self.assertEqual(repeated("--fixed", ["a", "b"]), ["--fixed", "a", "--fixed", "b"])
        self.assertEqual([file_argument("rig.toml"), file_argument("-rig.toml")], ["rig.toml", "./-rig.toml"])


@dataclasses.dataclass(frozen=True)
class _Part:
    size: float


@dataclasses.dataclass(frozen=True)
class _Sample:
    name: str
    value: float = dataclasses.field(metadata=_decode.named("value_si"))
    count: Optional[int]
    pair: tuple[float, float]
    parts: tuple[_Part, ...] = ()


class DecodeTest(unittest.TestCase):
    WHOLE: dict[str, Any] = {"name": "a", "value_si": 1, "count": None, "pair": [None, 2.0]}

    def test_members_become_fields_and_null_is_not_a_number(self) -> None:
        sample = _decode.decode(_Sample, {**self.WHOLE, "parts": [{"size": 3}], "new": 1})
        self.assertEqual((sample.name, sample.value, sample.count, sample.parts), ("a", 1.0, None, (_Part(3.0),)))
        self.assertTrue(math.isnan(sample.pair[0]))
        with self.assertRaises(dataclasses.FrozenInstanceError):
            sample.name = "b"  # type: ignore[misc]

    def test_other_shapes_are_refused_with_their_place(self) -> None:
        cases: dict[str, dict[str, Any]] = {
            "lacks _Sample.name": {key: value for key, value in self.WHOLE.items() if key != "name"},
            r"at value_si 'x', not a number": {**self.WHOLE, "value_si": "x"},
            "at count 1.5, not int": {**self.WHOLE, "count": 1.5},
            "at name True, not str": {**self.WHOLE, "name": True},
            "not a list of 2": {**self.WHOLE, "pair": [1.0]},
            r"lacks parts\[1\].size": {**self.WHOLE, "parts": [{"size": 1}, {}]},
            "at parts 3, not a list": {**self.WHOLE, "parts": 3},
        }
        for message, document in cases.items():
            with self.subTest(message), self.assertRaisesRegex(lacuna.AnswerError, message):
                _decode.decode(_Sample, document)


class InstallTest(unittest.TestCase):
    def test_an_installed_package_needs_nothing_else(self) -> None:
        build = os.environ.get("LACUNA_BUILD")
        if not build:
            self.fail("the environment variable LACUNA_BUILD must name the build folder")
        with tempfile.TemporaryDirectory() as prefix:
            command = ["cmake", "--install", build, "--prefix", prefix, "--component", "python"]
            subprocess.run(command, check=True, capture_output=True)
            folder = Path(prefix) / "lib" / "python3" / "dist-packages"
            self.assertTrue((folder / "lacuna" / "py.typed").exists())
            environment = {**os.environ, "PYTHONPATH": str(folder)}
            script = "import lacuna; print(lacuna.__file__, len(lacuna.plugins('effect').components) > 5)"
            command = [sys.executable, "-c", script]
            done = subprocess.run(command, check=True, capture_output=True, text=True, cwd=prefix, env=environment)
        self.assertEqual(done.stdout.split(), [str(folder / "lacuna" / "__init__.py"), "True"])

    def test_a_wheel_is_built_without_a_network_and_works(self) -> None:
        python = "/usr/bin/python3"  # Debian's, which has its setuptools
        with tempfile.TemporaryDirectory() as scratch:
            sources, wheels, site = (str(Path(scratch) / name) for name in ("python", "wheels", "site"))
            shutil.copytree(SOURCE / "python", sources)  # setuptools leaves files beside what it builds
            offline = [python, "-m", "pip", "--disable-pip-version-check", "--isolated"]
            alone = ["--no-index", "--no-deps", "--quiet"]
            built = [*offline, "wheel", *alone, "--no-build-isolation", "--wheel-dir", wheels, sources]
            subprocess.run(built, check=True, capture_output=True)
            (wheel,) = Path(wheels).iterdir()
            self.assertEqual(wheel.name, f"lacuna-{lacuna.__version__}-py3-none-any.whl")
            subprocess.run([*offline, "install", *alone, "--target", site, str(wheel)], check=True, capture_output=True)
            script = "import lacuna, lacuna.results as r; print(lacuna.__file__, lacuna.Program().version(), r.Check.__name__)"
            environment = {**os.environ, "PYTHONPATH": site}
            done = subprocess.run(
                [python, "-c", script], check=True, capture_output=True, text=True, cwd=scratch, env=environment
            )
            self.assertTrue((Path(site) / "lacuna" / "py.typed").exists())
        self.assertEqual(done.stdout.split(), [f"{site}/lacuna/__init__.py", lacuna.__version__, "Check"])


def _described(text: str) -> set[str]:
    """Names at the beginning of ``name, other : type`` lines of a docstring."""
    names: set[str] = set()
    for line in text.splitlines():
        found = re.match(r"\s*([\w*, ]+) : ", line)
        if found:
            names.update(one.strip("* ") for one in found.group(1).split(","))
    return names


if __name__ == "__main__":
    unittest.main()
