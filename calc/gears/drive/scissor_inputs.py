# SPDX-License-Identifier: Apache-2.0
"""What is said of a scissor gear: a wheel split across its width, whose halves a spring turns against each other."""

from ...sheet.quantity import inputs, quantity, text


@inputs
class Scissor:
    """The split wheel of a mesh.  One half drives, the sprung one holds the flanks closed."""

    torque: float = quantity(
        "Spring torque of the scissor gear",
        "N·m",
        up_to=1000,
        symbol="T_S0",
        rule_of_thumb=(1, 20),
        help="Between both halves where the mesh has no backlash left.",
        repair="free",
        change=("weaker spring", "stronger spring", "scissor gear"),
    )
    stiffness: float = quantity(
        "Rate of its spring",
        "N·m/°",
        default=0.0,
        within=(0, 1000),
        symbol="c_S",
        rule_of_thumb=(0, 5),
        help="What its torque loses as backlash lets it turn. 0: nothing.",
    )
    face_width: float | None = quantity(
        "Face width of the sprung half",
        "mm",
        default=None,
        up_to=500,
        symbol="b_S",
        rule_of_thumb=(3, 15),
        help="Below that of the mesh. Left out: 0.3 of it.",
        repair="asked",
    )
    to: float | None = quantity(
        "Speed up to which it shall hold",
        "rpm",
        default=None,
        up_to=30000,
        symbol="n_S",
        rule_of_thumb=(800, 3000),
        help="Of the crank, at any load. Left out: 1.5 times idle.",
        repair="asked",
    )
    wheel: str | None = text(
        "Wheel that is split", default=None, help="One of the two of its mesh. Left out: the driven one."
    )
