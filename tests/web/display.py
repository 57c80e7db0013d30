"""A display that nobody sees."""
import contextlib
import os
import subprocess


@contextlib.contextmanager
def display():
    """Its name, as DISPLAY wants it."""
    number, write = os.pipe()
    with os.fdopen(number) as said:
        server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1600x1200x24", "-nolisten", "tcp"],
            pass_fds=[write],
            stderr=subprocess.DEVNULL,
        )
        try:
            os.close(write)
            yield ":" + said.readline().strip()
        finally:
            end(server)


def end(process):
    process.terminate()
    try:
        process.wait(20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
