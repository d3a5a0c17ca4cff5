"""Where the program is looked for, and how a command of it ends."""

from __future__ import annotations

import os
import pickle
import signal
import stat
import subprocess
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

import lacuna
from support import InFolder, WithRig

BUILT = os.environ.get("LACUNA", "")


class FindProgramTest(InFolder):
    def without_program(self, **variables: str) -> mock._patch_dict:
        return mock.patch.dict(os.environ, {"PATH": str(self.folder), "LACUNA": "", **variables})

    def make_program(self, name: str, text: str = "#!/bin/sh\nexit 0\n") -> Path:
        file = self.folder / name
        file.write_text(text)
        file.chmod(file.stat().st_mode | stat.S_IXUSR)
        return file

    def test_the_argument_goes_before_the_variable_and_that_before_the_path(self) -> None:
        self.make_program("lacuna")
        other, third = self.make_program("other"), self.make_program("third")
        with self.without_program(LACUNA=str(other)):
            self.assertEqual(lacuna.find_program(third), str(third))
            self.assertEqual(lacuna.find_program(), str(other))
        with self.without_program():
            self.assertEqual(lacuna.find_program(), str(self.folder / "lacuna"))

    def test_says_where_it_looked_and_what_to_do(self) -> None:
        (self.folder / "build").mkdir()
        Path("plain").write_text("no program")
        cases = {
            "build": "is a folder; let the argument program name the program in it, build/lacuna",
            "nowhere/lacuna": "there is no such program",
            "./plain": "cannot be run; check its permissions",
        }
        for name, message in cases.items():
            with self.subTest(name), self.assertRaisesRegex(lacuna.ProgramNotFoundError, message):
                lacuna.find_program(name)
        with self.without_program(), self.assertRaises(lacuna.ProgramNotFoundError) as caught:
            lacuna.Experiment("first-steps.toml")
        self.assertIn("not on the PATH; set the environment variable LACUNA", str(caught.exception))
        self.assertIsInstance(caught.exception, FileNotFoundError)
        with self.without_program(LACUNA="gone"), self.assertRaisesRegex(
            lacuna.ProgramNotFoundError, "gone: there is no such program; the environment variable LACUNA must name"
        ):
            lacuna.find_program()

    def test_says_so_where_a_program_cannot_be_started(self) -> None:
        broken = self.make_program("broken", "#!/no/such/interpreter\n")
        with self.assertRaises(lacuna.ProgramNotFoundError):
            lacuna.Program(broken).version()
        with self.assertRaisesRegex(lacuna.BadInputError, "nowhere: there is no such folder"):
            lacuna.Program().run(["--version"], folder="nowhere")


class EndTest(InFolder):
    """Ends of a program, by one that ends as it is told."""

    def program(self, script: str) -> lacuna.Program:
        file = self.folder / "fake"
        file.write_text("#!/bin/sh\n" + script)
        file.chmod(0o755)
        return lacuna.Program(file)

    def test_problems_come_with_their_places(self) -> None:
        line = (
            '{"problem":{"file":"rig.toml","line":7,"column":3,"key":"engine.step",'
            '"message":"engine.step: must be above 0; write 0.001"}}'
        )
        program = self.program(f"echo '{line}' >&2; echo 'a note' >&2; exit 2\n")
        with self.assertRaises(lacuna.BadInputError) as caught:
            program.run(["check"])
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column, error.exit_code), ("rig.toml", 7, 3, 2))
        self.assertEqual(error.problems[0].key, "engine.step")
        self.assertEqual(error.problems[0].what, "engine.step: must be above 0")
        self.assertEqual(error.remedy, "write 0.001")
        self.assertEqual(str(error), "rig.toml:7:3: engine.step: must be above 0; write 0.001")
        self.assertEqual(error.notes, ("a note",))
        self.assertEqual(error.command, (program.path, "check"))
        self.assertIsInstance(error, ValueError)
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((type(again), str(again), again.problems), (type(error), str(error), error.problems))

    def test_each_exit_code_has_its_exception(self) -> None:
        cases: dict[str, tuple[type[lacuna.LacunaError], str]] = {
            """echo '{"failure":"the disk is full"}' >&2; exit 1""": (lacuna.CommandFailedError, "the disk is full"),
            """echo '{"failure":"stopped by --time-limit 1 s"}' >&2; exit 75""": (lacuna.StoppedError, "--time-limit 1 s"),
            "echo 'effect x ended the program' >&2; exit 1": (lacuna.CommandFailedError, "effect x ended the program"),
            "kill -9 $$": (lacuna.CommandFailedError, "was ended by SIGKILL"),
            "exit 3": (lacuna.CommandFailedError, "exit code 3 and said nothing"),
        }
        for script, (kind, message) in cases.items():
            with self.subTest(script), self.assertRaisesRegex(kind, message):
                self.program(script).run([])

    def test_a_stopped_command_has_a_result_only_where_it_printed_one(self) -> None:
        stopped = """echo '{"failure":"stopped by --time-limit 1 s"}' >&2; exit 75\n"""
        finished = self.program("echo result;" + stopped).run([], also_accept=[75])
        self.assertEqual((finished.output, finished.exit_code), (b"result\n", 75))
        self.assertEqual(finished.failure, "stopped by --time-limit 1 s")
        with self.assertRaises(lacuna.StoppedError):
            self.program(stopped).run([], also_accept=[75])

    def test_large_output_and_many_messages_do_not_block_each_other(self) -> None:
        program = self.program("seq 1 200000; seq 1 200000 >&2; seq 1 200000\n")
        finished = program.run([])
        self.assertEqual(len(finished.output.splitlines()), 400_000)
        self.assertEqual(len(finished.notes), 200_000)

    def test_a_line_that_looks_like_json_and_is_none_is_a_note(self) -> None:
        self.assertEqual(self.program("echo '{broken' >&2\n").run([]).notes, ("{broken",))

    def test_an_answer_of_another_version_is_refused(self) -> None:
        Path("rig.toml").write_text("")
        for answer, message in {"no json": "is no JSON", '{"experiment":"x"}': "lacks Check.database"}.items():
            program = self.program(f"echo '{answer}'\n")
            with self.subTest(answer), self.assertRaisesRegex(lacuna.AnswerError, message):
                lacuna.Experiment("rig.toml", program=program).check()

    def test_an_interrupt_is_passed_on_once_and_waited_for(self) -> None:
        script = "trap 'echo asked >> asked; sleep 0.3; echo done >> asked; exit 75' INT\n"
        program = self.program(script + "echo $$ > running; while :; do sleep 0.05; done\n")
        self.interrupt_when(Path("running"))
        with self.assertRaises(KeyboardInterrupt):
            program.run([])
        self.assertEqual(Path("asked").read_text(), "asked\ndone\n")
        self.assert_gone(int(Path("running").read_text()))

    def test_a_second_interrupt_is_passed_on_too(self) -> None:
        program = self.program("trap 'echo asked >> asked' INT\necho $$ > running; while :; do sleep 0.05; done\n")
        self.interrupt_when(Path("running"), times=3)
        with self.assertRaises(KeyboardInterrupt):
            program.run([])
        self.assertEqual(Path("asked").read_text(), "asked\nasked\n")  # what does not end is killed then
        self.assert_gone(int(Path("running").read_text()))

    def test_an_exception_of_the_callback_ends_the_program(self) -> None:
        line = '{"progress":{"phase":"fits","fraction":0.5,"seconds_left":null}}'
        program = self.program(f"echo $$ > running; echo '{line}' >&2\nwhile :; do sleep 0.05; done\n")

        def fail(progress: lacuna.Progress) -> None:
            raise ZeroDivisionError(str(progress))

        with self.assertRaisesRegex(ZeroDivisionError, "fits · 50 %"):
            program.run([], progress=fail)
        self.assert_gone(int(Path("running").read_text()))

    def interrupt_when(self, file: Path, times: int = 1) -> None:
        def interrupt() -> None:
            while not (file.exists() and file.read_text()):
                time.sleep(0.01)
            for _ in range(times):
                os.kill(os.getpid(), signal.SIGINT)
                time.sleep(0.5)

        thread = threading.Thread(target=interrupt)
        thread.start()
        self.addCleanup(thread.join)

    def assert_gone(self, process: int) -> None:
        with self.assertRaises(ProcessLookupError):
            os.kill(process, 0)


class RealEndTest(WithRig):
    def test_an_interrupted_diagnosis_leaves_a_database_in_order(self) -> None:
        reports: list[lacuna.Progress] = []

        def interrupt_once(progress: lacuna.Progress) -> None:
            reports.append(progress)
            if len(reports) == 3:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            self.rig.diagnose(progress=interrupt_once)
        self.assertGreaterEqual(len(reports), 3)
        self.assertTrue(all(0 <= one.fraction <= 1 and one.phase for one in reports))
        self.assertEqual(self.rig.sql("SELECT count(*) AS rows FROM diagnoses")[0], {"rows": 0})
        subprocess.run([BUILT, "verify", "first-steps.db"], check=True, capture_output=True)

    def test_a_time_limit_gives_what_is_known_by_then(self) -> None:
        diagnosis = self.rig.diagnose(time_limit=0.3)
        self.assertIsNotNone(diagnosis.stopped)
        self.assertIsNone(diagnosis.answer)
        with self.assertRaisesRegex(lacuna.StoppedError, "--time-limit 1e-06"):
            self.rig.compare(time_limit=1e-6)


if __name__ == "__main__":
    unittest.main()
