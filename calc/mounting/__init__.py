# SPDX-License-Identifier: Apache-2.0
"""The engine on its mounts: what the driver, the frame and the engine itself feel, without and with the shaft."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from .inputs import MountingInputs as MountingInputs
    from .result import MountingResult as MountingResult

offer(globals())
