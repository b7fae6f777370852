# SPDX-License-Identifier: Apache-2.0
"""A design in a folder of its own, as for the other tests of the session."""

from ..assistant.conftest import design, light, memory, session

__all__ = ["design", "light", "memory", "session"]
