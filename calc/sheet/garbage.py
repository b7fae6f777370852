# SPDX-License-Identifier: Apache-2.0
"""How often Python looks for garbage while many small objects are made that stay."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager

SELDOM = (200_000, 20, 100)  # new objects between two looks, of which a solve leaves next to none


@contextmanager
def seldom_collected() -> Iterator[None]:
    """Looking as often as Python does takes a tenth of a solve."""
    usual = gc.get_threshold()
    if usual >= SELDOM:  # so it is already
        yield
        return
    gc.set_threshold(*SELDOM)
    try:
        yield
    finally:
        gc.set_threshold(*usual)
