# SPDX-License-Identifier: Apache-2.0
"""The words of the choices in a design file, as people read them; what is not here stands for itself: a name, a grade, a standard."""

from .text import Text

WORDS: dict[str, str] = {
    # engine, crank and shaft
    "inline": Text("inline"), "vee": Text("vee"), "boxer": Text("boxer"), "exact": Text("exact"), "two_term": Text("two terms"),
    "equal": Text("equal"), "per_pin": Text("per pin"), "least_squares": Text("least squares"), "given": Text("given"),
    "size": Text("sized"), "yes": Text("yes"), "no": Text("no"), "vdi": "VDI", "source": Text("as the source"),
    # oil and bearings
    "mineral": Text("mineral"), "ester": Text("ester"), "forced": Text("forced"), "forced_cooled": Text("forced, oil cooled"),
    "grease": Text("grease"), "ring": Text("ring"), "ring_moving_air": Text("ring, in moving air"),
    "ring_fast_air": Text("ring, in fast air"), "hole": Text("hole"), "shaft": Text("through the shaft"), "groove": Text("groove"),
    "axial_groove": Text("axial groove"), "pocket": Text("pocket"), "walther": "Walther", "d341": "ASTM D341",
    # materials and gears
    "steel": Text("steel"), "aluminium": Text("aluminium"), "grey iron": Text("grey iron"), "ductile iron": Text("ductile iron"),
    "other": Text("other"), "spray": Text("spray"), "dip": Text("dip"), "submerged": Text("submerged"), "left": Text("left-hand"),
    "right": Text("right-hand"), "none": Text("none"), "finotti": "Finotti 2013", "position": Text("position"), "fit": Text("fit"),
    "radial": Text("radial"), "runout": Text("run-out"),
    # friction
    "linear": Text("linear"), "smooth": Text("smooth"), "barus": "Barus", "roelands": "Roelands", "thesis": Text("the thesis"),
    "castro-seabra": "Castro & Seabra", "doleschel": "Doleschel", "olver-spikes": "Olver & Spikes", "zhu-hu": "Zhu & Hu",
    "linke": "Linke", "simrit": "Simrit", "palmgren": "Palmgren", "skf": "SKF", "judged": Text("as judged"),
    "estimated": Text("estimated"), "oil": Text("oil"), "bath": Text("oil bath"), "mist": Text("oil mist"), "jet": Text("oil jet"),
    "deep-groove-ball": Text("deep-groove ball"), "angular-contact-ball": Text("angular-contact ball"),
    "self-aligning-ball": Text("self-aligning ball"), "cylindrical-roller": Text("cylindrical roller"),
    "needle-roller": Text("needle roller"), "spherical-roller": Text("spherical roller"), "tapered-roller": Text("tapered roller"),
    # mounting
    "tensor": Text("tensor"), "integral": Text("integral"), "clockwise": Text("clockwise"), "anticlockwise": Text("anticlockwise"),
    "construction-machine": Text("construction machine"), "tractor": Text("tractor"), "road": Text("road"),
    "stationary": Text("stationary"), "generating-set": Text("generating set"), "marine": Text("marine"), "inside": Text("inside the body"),
    "off_body": Text("off the body"), "fractional": Text("fractional"), "engine": Text("engine"), "chassis": Text("chassis"),
    "seat": Text("driver's seat"), "hand": Text("at the hands"), "machine": Text("machine"),
    # the search for whole drives
    "material": Text("material"), "surface": Text("surface"), "supply": Text("supply"),
}  # fmt: skip


def word(choice: str) -> str:
    """A choice as people read it; a Text where it differs between languages."""
    return WORDS.get(choice, choice)
