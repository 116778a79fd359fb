#!/usr/bin/python3
"""What is left when programs are killed, disks fill up, two write at once, and inputs change while they are read.

    tests/faults/faults.py PROGRAM [--kills=N] [--pairs=N] [--changes=N] [--disks=N] [--seed=S]

Each part prints a line; a fault prints what was found and ends with 1. tools/faults runs the long form, and CI a short one.
"""

import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = str(ROOT / "data/mergel2018.csv")
LOG = str(ROOT / "data/shear_log.csv")
CANNOT_WRITE, BAD_INPUT = 4, 3


class Fault(Exception):
    pass


def contents(folder):
    """{name: hash} of all files, without hidden and temporary files."""
    return {
        str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
        for file in sorted(folder.rglob("*"))
        if file.is_file() and not file.name.startswith(".mixity-") and ".mixity-tmp" not in file.name
    }


def leftovers(folder):
    return [file.name for file in folder.rglob("*") if ".mixity-tmp" in file.name or ".mixity-unfinished" in file.name]


def run(command, **more):
    return subprocess.run(command, capture_output=True, text=True, timeout=300, **more)


def commands(program, out):
    """Pairs of commands that write the same files with different contents."""
    fit = [program, "fit", DATA, "--models=c", f"--out={out}/results", f"--save={out}/saved/fit.toml"]
    report = [program, "report", DATA, "--models=c", f"--out={out}"]
    runs = [program, "runs", LOG, f"--out={out}", f"--save={out}/saved/log.toml"]
    return [
        (fit + ["--confidence=0.9"], fit + ["--confidence=0.8"]),
        (report + ["--confidence=0.9"], report + ["--confidence=0.8"]),
        (runs, runs + ["--load_offset=0.1 mN"]),
    ]


def without_former(found):
    """A TOML that changes is kept as NAME.old: those are beside the files of the run."""
    return {name: content for name, content in found.items() if ".toml.old" not in name}


def states(program, folder, pair):
    """Contents after the first command, and after the second, each in a folder of the same name."""
    found = []
    for command in pair:
        shutil.rmtree(folder, ignore_errors=True)
        started = time.monotonic()
        ended = run(command)
        if ended.returncode not in (0, 1):
            raise Fault(f"{command} ended {ended.returncode}: {ended.stderr}")
        found.append(without_former(contents(folder)))
    return *found, time.monotonic() - started


def kill_at_random(program, kills, chance, work):
    completed = 0
    folder = work / "out"
    for pair in commands(program, folder):
        old, new, duration = states(program, folder, pair)
        for _ in range(kills // 3):
            shutil.rmtree(folder)
            run(pair[0])
            process = subprocess.Popen(pair[1], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(chance.uniform(0, 1.1 * duration))
            process.send_signal(signal.SIGKILL)
            process.wait()
            found = without_former(contents(folder))
            for name, content in found.items():
                if content not in (old.get(name), new.get(name)):
                    raise Fault(f"after a kill {name} is neither the old file nor the new one")
            missing = set(old) & set(new) - set(found)
            if missing:
                raise Fault(f"after a kill {missing} is gone")
            # Some files are still those of the first run: whoever reads one completes the second.
            completed += found not in (old, new)
            run([program, "check", str(folder / chance.choice(list(old)))])
            if without_former(contents(folder)) not in (old, new):
                raise Fault("after a kill a reader finds files of two runs")
            ended = run(pair[1])
            if ended.returncode not in (0, 1):
                raise Fault(f"the run after a kill ended {ended.returncode}: {ended.stderr}")
            found = without_former(contents(folder))
            if leftovers(folder) or found != new:
                other = [name for name in {*found, *new} if found.get(name) != new.get(name)]
                raise Fault(f"the run after a kill left {leftovers(folder)}, and {other} are not what it makes")
    print(f"kills: {3 * (kills // 3)}, every file whole, a reader finds those of one run, the next run is "
          f"complete and without leftovers; {completed} killed between two renames and completed by the reader")


def write_in_pairs(program, pairs, work, prefix=()):
    folder = work / "pairs"
    refused = 0
    for pair in commands(program, folder):
        states_of = states(program, folder, pair)
        for _ in range(max(1, pairs // 3)):
            shutil.rmtree(folder, ignore_errors=True)
            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                ended = list(pool.map(lambda command: run([*prefix, *command]), pair))
            for one in ended:
                if one.returncode not in (0, 1, CANNOT_WRITE):
                    raise Fault(f"one of two writers ended {one.returncode}: {one.stderr}")
                refused += one.returncode == CANNOT_WRITE
            found = without_former(contents(folder))
            if found not in states_of[:2] or leftovers(folder):
                raise Fault(f"two writers left files of both, or {leftovers(folder)}")
    return refused


def change_inputs(program, changes, chance, work):
    """A file that is cut, grows or is replaced while it is read: refused, or read as it was at one moment."""
    lines = pathlib.Path(DATA).read_text().splitlines()
    rows = [line for line in lines[1:] if line]
    whole = "\n".join([lines[0]] + rows * (200000 // len(rows))) + "\n"
    part = whole[: len(whole) // 2].rsplit("\n", 1)[0] + "\n"
    more = "\n".join(rows) + "\n"
    data = work / "data.csv"
    shutil.copy(pathlib.Path(DATA).with_suffix(".toml"), data.with_suffix(".toml"))
    command = [program, "check", str(data)]
    expected = set()
    for text in (whole, part, whole + more):
        data.write_text(text)
        started = time.monotonic()
        expected.add(run(command).stdout)
        duration = time.monotonic() - started
    refused = 0
    for i in range(changes):
        data.write_text(whole)
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(chance.uniform(0, duration))
        if i % 3 == 0:
            os.truncate(data, len(part))
        elif i % 3 == 1:
            with data.open("ab", buffering=0) as file:
                file.write(more.encode())
        else:
            (work / "new.csv").write_text(part)
            os.replace(work / "new.csv", data)
        out, complaint = process.communicate(timeout=300)
        if process.returncode == BAD_INPUT and "was changed while it was read" in complaint:
            refused += 1
        elif process.returncode == BAD_INPUT or out not in expected:
            raise Fault(f"a file that changed while it was read gave exit {process.returncode}: {complaint}")
    print(f"inputs changed while they were read: {changes}, {refused} refused, the others read as they were at one moment")


def namespaces(*words):
    """A command in namespaces of its own; null where this machine has none for this user."""
    command = ["unshare", "--user", "--map-root-user", *words]
    try:
        return command if run([*command, "true"]).returncode == 0 else None
    except FileNotFoundError:
        return None


def fill_disks(program, disks, chance, work):
    prefix = namespaces("--mount")
    if not prefix:
        print("full disks: SKIPPED, as this user has no namespaces here")
        return
    folder = work / "disk"
    folder.mkdir()
    for _ in range(disks):
        for pair in commands(program, folder / "out"):
            size = chance.randrange(8, 400)
            script = (
                f"mount -t tmpfs -o size={size}k tmpfs {folder} || exit 77; "
                f"{' '.join(map(quoted, pair[0]))}; one=$?; cd {folder}; "
                "sums() { find . -type f ! -name .mixity-files -exec sha256sum {} + 2>/dev/null | sort; }; "
                f"before=$(sums); {' '.join(map(quoted, pair[1]))}; two=$?; after=$(sums); "
                f'[ $two = {CANNOT_WRITE} ] && [ "$before" != "$after" ] && exit 78; echo $one $two'
            )
            ended = run([*prefix, "sh", "-c", script])
            if ended.returncode == 77:
                print("full disks: SKIPPED, as this user cannot mount one")
                return
            if ended.returncode == 78:
                raise Fault(f"on a disk of {size} kB a run that ended {CANNOT_WRITE} changed files")
            codes = ended.stdout.split()[-2:]
            if not set(codes) <= {"0", "1", str(CANNOT_WRITE)}:
                raise Fault(f"on a disk of {size} kB runs ended {codes}: {ended.stderr}")
    print(f"full disks: {3 * disks}, each run wrote all of its files or changed none")


def quoted(word):
    return "'" + word.replace("'", "'\\''") + "'"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=6)
    parser.add_argument("--pairs", type=int, default=3)
    parser.add_argument("--changes", type=int, default=6)
    parser.add_argument("--disks", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    program, chance = os.path.abspath(options.program), random.Random(options.seed)
    with tempfile.TemporaryDirectory(prefix="mixity-faults-") as folder:
        work = pathlib.Path(folder)
        try:
            kill_at_random(program, options.kills, chance, work)
            refused = write_in_pairs(program, options.pairs, work)
            print(f"two writers: {options.pairs} pairs, files of one of them each time, {refused} refused")
            if prefix := namespaces("--pid", "--fork"):
                write_in_pairs(program, options.pairs, work, prefix)
                print(f"two writers with one process number: {options.pairs} pairs, files of one of them each time")
            else:
                print("two writers with one process number: SKIPPED, as this user has no namespaces here")
            fill_disks(program, options.disks, chance, work)
            change_inputs(program, options.changes, chance, work)
        except Fault as fault:
            print(f"FAULT: {fault}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
