"""What surrounds a run and fails it: a full disk, no descriptors, no memory, a slow reader, signals.

Each is a function of (command, folder, environment) that returns exit code, standard output and messages.
"""
import ctypes
import fcntl
import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import threading
import time

HANG = "a hang"
ENDS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL)


def plainly(command, folder, env, **more):
    try:
        done = subprocess.run(command, cwd=folder, env=env, stdin=subprocess.DEVNULL, capture_output=True, timeout=120,
                              check=False, **more)
        return done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        return HANG, b"", b""


def limited(what, amount):
    """RLIMIT_NOFILE: no more descriptors; RLIMIT_AS: no more memory."""
    return lambda *run: plainly(*run, preexec_fn=lambda: resource.setrlimit(what, (amount, amount)))


def signalled(numbers, moment):
    """Signals, one after another, once so many seconds are over."""
    def run(command, folder, env):
        with subprocess.Popen(command, cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            for number in numbers:
                time.sleep(moment)
                process.send_signal(number)
            try:
                out, err = process.communicate(timeout=60)
                return process.returncode, out, err
            except subprocess.TimeoutExpired:
                process.kill()
                return HANG, b"", b""
    return run


def slowly_read(command, folder, env):
    """Standard output is a pipe of a page, of which a few bytes are read at a time."""
    with tempfile.TemporaryFile() as messages, subprocess.Popen(
            command, cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=messages,
            bufsize=0) as process:
        late = threading.Timer(120, process.kill)
        late.start()
        fcntl.fcntl(process.stdout, 1031, 4096)  # F_SETPIPE_SZ
        time.sleep(0.1)
        out = b""
        while piece := process.stdout.read(64):
            out += piece
            time.sleep(0.001)
        process.wait()
        hung = not late.is_alive()
        late.cancel()
        messages.seek(0)
        return HANG if hung else process.returncode, out, messages.read()


def gone_on_with(command, folder, env):
    """What a fault ended is begun once more, without: then all is there, and no journal."""
    ended = plainly(command, folder, env)
    if ended[0] != 0:
        again = plainly(command, folder, {k: v for k, v in env.items() if k not in ("LASIUS_FAULT", "LD_PRELOAD")})
        if again[0] != 0 or list(pathlib.Path(folder).glob("*.journal")):
            return f"no going on: {again[0]}", *ended[1:]
        return 0, again[1], ended[2]
    return ended


class Disk:
    """A tmpfs in a mount namespace of this process, for all runs. @throws OSError where that is not allowed."""

    def __init__(self):
        if ctypes.CDLL(None, use_errno=True).unshare(0x20000) != 0:  # CLONE_NEWNS
            raise OSError(ctypes.get_errno(), "no mount namespace")
        self.place = tempfile.mkdtemp(prefix="lasius-disk-")
        for mount in (["--make-rprivate", "/"], ["-t", "tmpfs", "-o", "size=64m", "none", self.place]):
            if subprocess.run(["mount", *mount], check=False).returncode != 0:
                self.close()
                raise OSError(0, "mount " + " ".join(mount) + " failed")

    def sized(self, pages):
        """With so many pages left."""
        def run(*asked):
            about = os.statvfs(self.place)
            self.resize((about.f_blocks - about.f_bfree + pages) * about.f_frsize)
            try:
                return plainly(*asked)
            finally:
                self.resize(64 << 20)
        return run

    def resize(self, size):
        subprocess.run(["mount", "-o", f"remount,size={size}", self.place], check=True)

    def close(self):
        subprocess.run(["umount", self.place], check=False, stderr=subprocess.DEVNULL)
        os.rmdir(self.place)


def limits(draw, made, disk):
    """Of a command that makes these files: names, functions, and exit codes of an end that need not leave what a whole
    run does."""
    for number in range(3, 24):
        yield f"{number} descriptors", limited(resource.RLIMIT_NOFILE, number), ()
    for size in range(8, 8 * 33, 8):  # the loader may crash without memory, and what draws
        yield f"{size} MB", limited(resource.RLIMIT_AS, size << 20), (-signal.SIGSEGV, -signal.SIGABRT)
    yield "a slow reader", slowly_read, ()
    if disk and made:
        pages = sum(len(data) // 4096 + 2 for data in made.values())
        for left in sorted({0, 1, 2, *draw.sample(range(pages + 1), min(8, pages + 1))}):
            yield f"{left} pages of disk", disk.sized(left), ()


def signals(draw, moments, seconds):
    """As limits(), of a command that takes so many seconds. Before it watches for it a signal ends it as any program."""
    for _ in range(moments):
        for number in ENDS:
            yield number.name, signalled([number], draw.uniform(0, 1.2 * seconds)), (130, -number)
        # SIGTSTP is not for a process group without a parent in its session: the kernel throws it away.
        yield "STOP and CONT", signalled([signal.SIGSTOP, signal.SIGCONT], draw.uniform(0, seconds)), ()


def drawn(name):
    return name.endswith((".svg", ".png", ".gif", ".html"))


def without_pictures(words):
    pairs = list(zip(words, words[1:] + [""]))
    return [word for (word, after), before in zip(pairs, [""] + words)
            if not (word == "-o" and drawn(after)) and not (before == "-o" and drawn(word))]
