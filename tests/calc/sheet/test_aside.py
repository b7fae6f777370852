"""Work done by a copy of the process gives what it gives here, also where no copy can be made or the copy is lost."""

import os
import sys
import threading

import pytest

from calc.sheet.aside import aside

CAN = sys.platform == "linux" and len(os.sched_getaffinity(0)) > 1


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_another_process_has_done_it() -> None:
    assert aside(os.getpid)() != os.getpid()


def test_beside_other_threads_it_is_done_here() -> None:
    end = threading.Event()
    other = threading.Thread(target=end.wait)
    other.start()
    try:
        assert aside(os.getpid)() == os.getpid()
    finally:
        end.set()
        other.join()


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_what_fails_there_fails_here(capfd: pytest.CaptureFixture[str]) -> None:
    def fails() -> int:
        raise KeyError(os.getpid())

    waiting = aside(fails)
    with pytest.raises(KeyError) as error:
        waiting()
    assert error.value.args == (os.getpid(),) and capfd.readouterr() == ("", "")


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_what_a_copy_can_not_send_is_made_here() -> None:
    made = aside(lambda: lambda: 3)()
    assert made() == 3
