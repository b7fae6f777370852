# SPDX-License-Identifier: Apache-2.0
"""What guides through the steps: what is to be decided in each, what a good answer looks like, and what to try when a check fails."""

from dataclasses import dataclass

from calc.library.journal_rules import SLOPE, USUAL_CLEARANCE, USUAL_LENGTH
from calc.sheet.text import Amount, Text


@dataclass(frozen=True)
class Guide:
    decide: Text
    good: Text
    trying: Text


GUIDES: dict[str, Guide] = {
    "engine": Guide(
        Text("Which engine: layout, crank, masses of piston and rod, rated speed. Everything else follows from it."),
        Text("Masses as weighed, the rod's centre of gravity too."),
        Text("Weigh instead of estimating. The firing order can be chosen from a table, the one that leaves least first."),
    ),
    "imbalance": Guide(
        Text("How much of the reciprocating mass the crank's own counterweights carry, and so what is left for a counter-shaft."),
        Text("Little left, by little mass: the row marked ◀ is what this engine calls for."),
        Text(
            "Second order is out of reach of one shaft: lighter pistons, a longer rod, two shafts at twice the speed, "
            "or good engine mounts."
        ),
    ),
    "countershaft": Guide(
        Text("The shaft that takes the rest: its masses, their radius, angle and place, where it is supported, and what it is made of."),
        Text(
            "Nothing left of what it is to take, journals at less than {slope}, the first critical speed far above the running speed.",
            slope=Amount(SLOPE * 1e3, "mrad"),
        ),
        Text(
            "Sectors further apart or further out save mass; a thicker core straightens the shaft. The lightest can be chosen from a table."
        ),
    ),
    "bearings": Guide(
        Text("Length and clearance of the two bearings, oil and its supply, and on what the journals run."),
        Text(
            "Length: {length}; clearance: {clearance}; a film that holds warm and at twice the load, and clearance left when cold.",
            length=USUAL_LENGTH,
            clearance=USUAL_CLEARANCE,
        ),
        Text(
            "A tighter fit first, then more length, then smoother surfaces; a thicker oil where the engine allows it. "
            "A table has bearings that pass."
        ),
    ),
    "gears": Guide(
        Text("Teeth, profile shifts, centre distances and allowances of the train that drives the shaft."),
        Text(
            "Backlash that stays above zero at every tolerance, cold and warm; contact ratio well above 1, no undercut, sliding "
            "shared evenly."
        ),
        Text(
            "Jamming: more span allowance. Undercut, pointed tips, uneven sliding: other profile shifts, from a table. "
            "Strength: face width."
        ),
    ),
    "friction": Guide(
        Text("Roughness of the flanks, oil and its temperature: what the whole train costs the crank."),
        Text("Some hundred watts at rated speed. Under so light a load rolling and the bearings lose more than the teeth rub away."),
        Text("A thinner or warmer oil costs less in the meshes and thins the films of the bearings: watch step 4 while you change it."),
    ),
    "mounting": Guide(
        Text("Mass, inertia and mounts of the engine, the frame below them, and where it is felt at which speeds."),
        Text("All modes between the road's frequency and idle, roll and bounce pure. The shaft takes order 1; the firing torque stays."),
        Text("Softer mounts, other ratios, an inclination: the search for mounts finds those that decouple the modes."),
    ),
}
