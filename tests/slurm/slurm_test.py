#!/usr/bin/env python3
"""orbs submit with a real Slurm on this machine: an array of two, of which one task is killed.

    slurm_test.py <folder of the programs>

Starts munged, slurmctld and slurmd of its own, with a scratch folder for all that they write; Debian's packages munge,
slurmctld, slurmd and slurm-client have them. Without these it ends with 77, which ctest shows as skipped, and where
CI is set it fails.
"""
import difflib
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "sinfo"]
DEADLINE_SECONDS = 90
SCENE = """{"format": "orbs-scene/1", "name": "s", "camera": {"position": [0,4,1], "look_at": [0,0,0], "width": 12, "height": 8},
 "materials": [{"name": "m", "type": "lambert", "reflectance": [0.5,0.5,0.5]}],
 "meshes": [{"name": "p", "generator": "plane", "half_size": 1, "material": "m"}], "instances": [{"mesh": "p"}],
 "lights": [], "environment": [1,1,1]}"""
NAMES = ["a", "b", "c", "d"]
CLUSTER = "100%job"  # Slurm replaces %j in the names of the files of output


def program(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def until(what, condition):
    """Waits for what another process does; there is nothing to be notified by."""
    end = time.monotonic() + DEADLINE_SECONDS
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"did not happen within {DEADLINE_SECONDS} s: {what}")
        time.sleep(0.1)


class Slurm:
    """A cluster of one node, whose daemons end with the `with` block."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        self.conf = folder / "slurm.conf"

    def start(self, name, *words, environment=None):
        log = open(self.folder / f"{name}.log", "wb")
        self.daemons.append(subprocess.Popen([program(name), *map(str, words)], stdout=log, stderr=log,
                                             env=environment, start_new_session=True))

    def __enter__(self):
        folder = self.folder
        for name in ["munge", "state", "spool"]:
            (folder / name).mkdir(mode=0o755)
        key = folder / "munge/key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        munge_socket = folder / "munge/socket"
        host = socket.gethostname().split(".")[0]
        user = "root" if os.geteuid() == 0 else os.environ["USER"]
        self.conf.write_text(f"""ClusterName=orbs
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={munge_socket}
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
MailProg=/bin/true
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
KillWait=1
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=1000 State=UNKNOWN
PartitionName=main Nodes={host} Default=YES State=UP OverSubscribe=NO
""")
        # From version 24 on slurmd looks for control groups, which a container may not have, though none is asked for.
        if int(re.search(r"\d+", self.ask("slurmd", "-V")).group()) >= 24:
            (folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        os.environ["SLURM_CONF"] = str(self.conf)
        self.start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={munge_socket}",
                   f"--pid-file={folder}/munge/pid", f"--log-file={folder}/munge/log", f"--seed-file={folder}/munge/seed")
        until("munged opens its socket", munge_socket.exists)
        self.start("slurmctld", "-D", "-f", self.conf)
        self.start("slurmd", "-D", "-f", self.conf, "-N", host)
        try:
            until("the node is idle", lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"))
        except AssertionError as failed:
            self.__exit__(failed)  # with the logs
            raise
        return self

    def __exit__(self, kind, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                os.killpg(daemon.pid, signal.SIGKILL)
        if kind is not None:
            for log in self.folder.glob("*.log"):
                print(f"--- {log.name}\n{log.read_text(errors='replace')[-3000:]}")

    def ask(self, name, *words):
        return subprocess.run([program(name), *words], capture_output=True, text=True, check=False).stdout

    def wait_for_all(self):
        until("all jobs end", lambda: self.ask("squeue", "-h").strip() == "")


def write_suite(folder, build):
    """Scene c waits for ever as long as there is a file 'block'."""
    case = folder / "cases/m1_grey"
    case.mkdir(parents=True)
    (folder / "references").mkdir()
    (case / "grey.json").write_text(SCENE)
    scenes = [{"name": name, "file": "grey.json", "spp": 8} for name in NAMES]
    (case / "case.json").write_text(json.dumps({
        "format": "orbs-case/2", "requirement": "M1", "title": "t", "tests": "t", "typical_mistake": "m", "scenes": scenes}))
    (folder / "render.sh").write_text(f"""#!/bin/sh
case "$2" in */c/*) while [ -e "{folder}/block" ]; do touch "{folder}/blocked"; sleep 0.1; done;; esac
exec "{build}/orbs-fake-renderer" --mode good --output "$1" --scene "$2" --width 12 --height 8 --grey 0.5 --spp 8 --seed "$3"
""")
    (folder / "render.sh").chmod(0o755)
    (folder / "configuration.json").write_text(json.dumps({
        "format": "orbs-configuration/1", "stands_alone": True, "defaults": {"suite": "t"}, "limits": {"wall_seconds": 60},
        "slurm": {"partition": "main", "time": "5"},
        "suites": [{"name": "t", "cases": "cases", "references": "references"}],
        "renderers": [{"name": "good", "executable": "{root}/render.sh", "declares": "G5/M8",
                       "command": ["{executable}", "{output}", "{scene}", "{seed}"]}]}))
    for name in NAMES:
        subprocess.run([f"{build}/orbs-fake-renderer", "--mode", "good", "--output", folder / f"references/{name}.exr",
                        "--scene", case / "grey.json", "--width", "12", "--height", "8", "--grey", "0.5", "--spp", "8",
                        "--seed", "1"], check=True, cwd=folder)


def without_times(folder):
    text = (folder / "results.json").read_text().replace(str(folder), "FOLDER")
    text = re.sub(r'"command_line": \[[^\]]*\]', "", text)
    return re.sub(r'\n *"(started|load|wall_seconds|cpu_seconds|peak_rss_bytes)": [^\n]*', "", text)


def test(folder, build):
    def orbs(*words):
        return subprocess.run([f"{build}/orbs", *words], cwd=folder, capture_output=True, text=True, check=False)

    write_suite(folder, build)
    local = orbs("run", "--threads", "1", "-o", "local")
    assert local.returncode == 0, local.stdout + local.stderr
    (folder / "block").touch()
    configuration = folder / "configuration.json"
    with Slurm(folder) as slurm:
        # What Slurm refuses is mended in the configuration and resumed.
        right = configuration.read_text()
        configuration.write_text(right.replace('"partition": "main"', '"partition": "nowhere"'))
        refused = orbs("submit", "--slurm", "--threads", "1", "--shards", "2", "-o", "refused")
        assert refused.returncode == 2 and "--resume" in refused.stderr, refused.stdout + refused.stderr
        configuration.write_text(right)
        mended = orbs("submit", "--slurm", "--resume", "refused", "--dry-run")
        assert "--partition=main" in mended.stdout and "--array=1-2" in mended.stdout, mended.stdout + mended.stderr
        submitted = orbs("submit", "--slurm", "--threads", "1", "--shards", "2", "-o", CLUSTER)
        assert submitted.returncode == 0, submitted.stdout + submitted.stderr
        array = re.search(r"array (\d+) of 2 shards", submitted.stdout).group(1)
        until("the second task renders scene c", (folder / "blocked").exists)
        # The array of which a task renders is not submitted again.
        waiting = orbs("submit", "--slurm", "--resume", CLUSTER + "/")
        assert "not submitted again" in waiting.stdout, waiting.stdout + waiting.stderr
        until("the other task ends", lambda: "RUNNING" not in slurm.ask("squeue", "-h", "-j", f"{array}_2", "-o", "%T"))
        slurm.ask("scancel", f"{array}_1")
        slurm.wait_for_all()
        merge = (folder / CLUSTER / "merge.log").read_text()
        assert "the runs lack" in merge and "good c: not rendered" in merge, merge
        assert not (folder / CLUSTER / "merged").exists()
        (folder / "block").unlink()
        again = orbs("submit", "--slurm", "--resume", CLUSTER)
        assert "of 1 shards" in again.stdout, again.stdout + again.stderr
        slurm.wait_for_all()
        merge = (folder / CLUSTER / "merge.log").read_text()
        assert (folder / CLUSTER / "merged/results.json").exists(), merge
        assert "are complete" in orbs("submit", "--slurm", "--resume", CLUSTER).stdout
    merged, local = without_times(folder / CLUSTER / "merged"), without_times(folder / "local")
    assert merged == local, "\n".join(difflib.unified_diff(local.splitlines(), merged.splitlines(), "local", "merged", n=1))
    for image in (folder / "local").rglob("*.exr"):
        other = folder / CLUSTER / "merged" / image.relative_to(folder / "local")
        assert image.read_bytes() == other.read_bytes(), image


def main():
    os.umask(0o022)  # Slurm reads of other users what it writes
    build = pathlib.Path(sys.argv[1]).resolve()
    os.environ.setdefault("TMPDIR", "/tmp")  # which Slurm sets in its tasks, and renderers are given
    missing = [name for name in PROGRAMS if program(name) is None]
    if missing:
        print(f"SLURM IS NOT HERE: {', '.join(missing)} missing, so nothing of orbs submit was tested.\n"
              "  apt-get install munge slurmctld slurmd slurm-client")
        sys.exit(1 if os.environ.get("CI") else 77)
    with tempfile.TemporaryDirectory(prefix="orbs-slurm-") as folder:
        test(pathlib.Path(folder).resolve(), build)


main()
