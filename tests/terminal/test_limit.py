"""What takes too long is stopped, wherever it is."""

import threading
import time

import pytest

from rigidtop.terminal.limit import TooLong, within


def spin(seconds):
    end = time.process_time() + seconds
    while time.process_time() < end:
        try:
            sum(range(1000))
        except Exception:
            pytest.fail("no `except` of a library takes it for its own")


def test_what_takes_too_long_is_stopped():
    begun = time.process_time()
    with pytest.raises(TooLong), within(0.1):
        spin(20)
    assert time.process_time() - begun < 2
    with within(0.2):
        spin(0.01)
    spin(0.3)  # the limit is over with its body


def test_elsewhere_than_in_the_main_thread_there_is_no_limit():
    done = []

    def work():
        with within(0.01):
            spin(0.1)
        done.append(True)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert done
