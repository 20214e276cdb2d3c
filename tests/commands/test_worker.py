"""Jobs that are done in the main thread while something listens."""

import subprocess
import sys

LOST = """
import time
from rigidtop.commands.worker import Worker

worker = Worker()

def swallow():
    try:
        while True:
            time.sleep(0.01)
    except KeyboardInterrupt:
        pass

worker.result(swallow)
worker.serve(lambda: time.sleep(0.5))
"""


def test_an_interrupt_that_a_job_loses_ends_the_server_all_the_same():
    done = subprocess.run([sys.executable, "-c", LOST], timeout=20)
    assert done.returncode == 0
