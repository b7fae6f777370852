# SPDX-License-Identifier: Apache-2.0
"""What the ways of balancing an engine on its mounts, and its motions, are called."""

from ..sheet.text import Text

VARIANT_WORDS = {
    "bare": Text("nothing balanced"),
    "half": Text("half on the crank"),
    "shaft": Text("with the shaft"),
    "scatter": Text("with the shaft as it scatters"),
    "tooth": Text("with the shaft one tooth late"),
}
DOF_WORDS = {
    "bounce": Text("bounce"),
    "lateral": Text("lateral"),
    "fore_aft": Text("fore and aft"),
    "yaw": Text("yaw"),
    "pitch": Text("pitch"),
    "roll": Text("roll"),
}
