"""Runs the parts of an experiment as tasks of Dask, and joins their rows.

    pip install "dask[distributed]"
    python dask_sweep.py experiment.json runs.csv --parts 16
    python dask_sweep.py experiment.json runs.csv --parts 200 --scheduler tcp://HOST:8786

Without a scheduler, Dask starts one on this machine. With one, its workers need the program planarium, and the folders of the
experiment and of the rows under the same paths. Started again, it goes on with the parts that are not finished. The rows are those of
`planarium sweep experiment.json --out runs.csv`, bit for bit.
"""

import argparse
import os
import shutil
import subprocess
from pathlib import Path

from dask.distributed import Client, as_completed


def run_part(program, experiment, rows, part, parts):
    """Runs one part on one thread; the part's number."""
    command = [program, "sweep", experiment, "--out", rows, "--shard", f"{part}/{parts}", "--threads", "1"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return part


def main():
    parser = argparse.ArgumentParser(description="Runs an experiment on Dask.")
    parser.add_argument("experiment", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--parts", type=int, default=16, help="how many tasks [16]")
    parser.add_argument("--scheduler", help="the address of Dask's scheduler [one on this machine]")
    parser.add_argument("--planarium", default="planarium", help="the program [planarium]")
    arguments = parser.parse_args()

    out, parts = arguments.out.resolve(), arguments.parts
    for file, columns in ((out, b"experiment,trial,"), (out.with_name(out.stem + ".times.csv"), b"trial,build_seconds,")):
        if file.exists() and file.stat().st_size > 0 and not file.read_bytes().startswith(columns):
            parser.error(f"{file} contains something else than rows; it is left as it is")
    files = [str(out.with_name(f"{out.stem}.part-{part}-of-{parts}.csv")) for part in range(1, parts + 1)]
    local = {} if arguments.scheduler else {"threads_per_worker": 1}
    with Client(arguments.scheduler, **local) as client:
        tasks = [
            client.submit(run_part, arguments.planarium, str(arguments.experiment.resolve()), rows, part, parts, pure=False)
            for part, rows in enumerate(files, 1)
        ]
        for finished, task in enumerate(as_completed(tasks), 1):
            print(f"part {task.result()} is done, {finished} of {parts}", flush=True)

    for ending in ("", ".times"):
        target = out.with_name(out.stem + ending + ".csv")
        joined = target.with_name(f".{target.name}.partial")
        with open(joined, "wb") as file:
            for rows in files:
                with open(rows.removesuffix(".csv") + ending + ".csv", "rb") as part:
                    shutil.copyfileobj(part, file)
        os.replace(joined, target)


if __name__ == "__main__":
    main()
