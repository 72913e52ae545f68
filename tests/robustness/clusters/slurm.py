"""A Slurm cluster of one node on loopback: munge, slurmctld and slurmd in a folder of their own."""

import os
import pathlib
import signal
import socket
import tempfile
import time

from process import Process, run, succeed

START_S = 60
CONFIGURATION = """\
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldPort={controller_port}
SlurmdPort={node_port}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
KillWait=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class Cluster:
    """While it lasts, `environment` makes Slurm's commands talk to it."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="hyrax-slurm-")
        self._daemons = []
        self.environment = {**os.environ, "SLURM_CONF": f"{self._folder.name}/slurm.conf"}

    def __enter__(self):
        folder = pathlib.Path(self._folder.name)
        host = socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (folder / name).mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        # Ports that nobody listens on.
        with socket.create_server(("127.0.0.1", 0)) as one, socket.create_server(("127.0.0.1", 0)) as other:
            controller_port, node_port = (each.getsockname()[1] for each in (one, other))
        (folder / "slurm.conf").write_text(CONFIGURATION.format(
            folder=folder, host=host, controller_port=controller_port, node_port=node_port, cpus=os.cpu_count()))
        self._start(folder, "munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket",
                    f"--pid-file={folder}/munged.pid", f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed")
        self._start(folder, "slurmctld", "-D")
        self._start(folder, "slurmd", "-D")
        deadline = time.monotonic() + START_S
        while "idle" not in run("sinfo", "--noheader", "--format=%t", env=self.environment).out:
            if time.monotonic() > deadline:
                logs = "\n".join(path.read_text(errors="replace") for path in sorted(folder.glob("*.output")))
                self.__exit__()
                raise AssertionError(f"the Slurm cluster did not start in {START_S} s:\n{logs}")
            time.sleep(0.2)
        return self

    def __exit__(self, *_):
        run("scancel", "--signal=KILL", "--full", "--user=root", env=self.environment)
        for daemon in reversed(self._daemons):
            daemon.send(signal.SIGTERM)
            daemon.wait(30)
        self._folder.cleanup()

    def _start(self, folder, *command):
        with open(folder / f"{command[0]}.output", "w", encoding="utf-8") as output:
            self._daemons.append(Process(*command, env=self.environment, stdout=output, stderr=output))

    def command(self, *words, **options):
        """One of Slurm's commands, which must succeed; its output."""
        return succeed(*words, env=self.environment, **options).out.strip()

    def states(self, job):
        """{task: state} of an array, as long as Slurm has not forgotten it."""
        text = self.command("squeue", "--noheader", "--array", "--states=all", "--format=%K %T", f"--jobs={job}")
        return {int(task): state for task, state in (line.split() for line in text.splitlines())}
