"""Sends mutants of specs through every command of mavc: none may panic, be killed by a signal, take more than 60 s of
processor time or more than 500 MB.

    cargo test --release --test mutants -- --write /tmp/mutants --count 1000 --seed 1
    python3 tests/mutants/commands.py target/release/mavc /tmp/mutants
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SECONDS, MEGABYTES = 60.0, 500.0

SMALL = ["--set", "plan.samples=24"]
COMMANDS = {
    "check": [["check", "SPEC"]],
    "fmt": [["fmt", "--check", "SPEC"]],
    "analyze": [["analyze", "SPEC"]],
    "emit": [["emit", "ast", "SPEC"], ["emit", "model", "SPEC"], ["emit", "sets", "SPEC"], ["emit", "qp", "SPEC", *SMALL]],
    "plan": [["plan", "SPEC", "-o", "OUT.csv", "--certificate", "OUT.json", "--quiet", *SMALL]],
    "verify": [["verify", "OUT.json", "SPEC", *SMALL]],
    "compare": [["compare", "SPEC", "--quiet", *SMALL]],
    "simulate": [["simulate", "SPEC", "-o", "OUT.log.csv", "--quiet", *SMALL]],
    "campaign": [["campaign", "SPEC", "-o", "OUT.rows.csv", "--times", "2", "--seeds", "1", "--quiet", *SMALL]],
}


def run(args):
    """Exit status, processor time (s) and memory (MB) of one command, and what it said on standard error."""
    with tempfile.TemporaryFile() as said:
        child = subprocess.Popen(args, stdout=subprocess.DEVNULL, stderr=said, stdin=subprocess.DEVNULL)
        deadline = time.monotonic() + 10 * SECONDS
        while True:
            pid, status, usage = os.wait4(child.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > deadline:
                child.kill()
            time.sleep(0.002)
        child.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        return child.returncode, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000, said.read().decode(errors="replace")


def main():
    mavc, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    wanted = sys.argv[3:] or list(COMMANDS)
    mutants = sorted(folder.glob("*.mav"))
    vehicles = Path(__file__).resolve().parents[2] / "specs" / "vehicles"
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        # Where mutants that use a shipped vehicle find it.
        os.symlink(vehicles, Path(scratch) / "vehicles")
        place = Path(scratch) / "missions"
        place.mkdir()
        for name in wanted:
            slowest, largest, codes = (0.0, ""), (0.0, ""), {}
            for mutant in mutants:
                spec = place / "mutant.mav"
                spec.write_bytes(mutant.read_bytes())
                for args in COMMANDS[name]:
                    # The certificate that is verified is a plan's of the same mutant, where it has one.
                    if name == "verify":
                        (place / "out.json").unlink(missing_ok=True)
                        run([str(mavc), *[filled(a, spec, place) for a in COMMANDS["plan"][0]]])
                        if not (place / "out.json").exists():
                            continue
                    code, seconds, megabytes, said = run([str(mavc), *[filled(a, spec, place) for a in args]])
                    codes[code] = codes.get(code, 0) + 1
                    slowest, largest = max(slowest, (seconds, mutant.name)), max(largest, (megabytes, mutant.name))
                    if code < 0 or code > 9 or "panicked" in said or seconds > SECONDS or megabytes > MEGABYTES:
                        failed += 1
                        print(f"FAILED {name} {mutant.name}: exit {code}, {seconds:.1f} s, {megabytes:.0f} MB\n{said[:400]}")
            ended = ", ".join(f"{count} x {code}" for code, count in sorted(codes.items()))
            print(f"{name:9} exit codes {ended}; at most {slowest[0]:.1f} s ({slowest[1]}), {largest[0]:.0f} MB ({largest[1]})", flush=True)
    print(f"{len(mutants)} mutants: {failed} failed")
    sys.exit(failed > 0)


def filled(argument, spec, place):
    return argument.replace("SPEC", str(spec)).replace("OUT", str(place / "out"))


main()
