"""Runs the programs precision_TASK; what they say of errors is shown if they fail."""

import contextlib
import subprocess
import sys
import tempfile


def fail(program, code, errors):
    sys.exit(f"{sys.argv[0]}: {program} ended with code {code}: {errors[-300:]}")


def output(program):
    done = subprocess.run([program], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        fail(program, done.returncode, done.stderr)
    return done.stdout


@contextlib.contextmanager
def beside(program, option):
    """The program with pipes, to be read to its end."""
    pipe = subprocess.PIPE
    with (tempfile.TemporaryFile() as errors,
          subprocess.Popen([program, option], stdin=pipe, stdout=pipe, stderr=errors) as process):
        try:
            yield process
        except (EOFError, BrokenPipeError):
            process.stdout.read()
        if process.wait() != 0:
            errors.seek(0)
            fail(program, process.returncode, errors.read().decode())
