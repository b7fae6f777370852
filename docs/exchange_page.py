# SPDX-License-Identifier: Apache-2.0
"""What leaves a design for other programs and the shop, as a page: the kinds of files from their table."""

from assistant.exports.kinds import KINDS, FileKind

HEAD = """# In and out

A design does not end in this program. Its shaft goes to CAD, its wheels to a gear program, its forces to a finite-element or multi-body model, its
unbalance to the balancing machine. What the bench measures comes back.

```text
contralbero export FILE -o PATH
```

The ending of the path says which kind of file is written. Where several kinds have one ending, an option says which. In the session `E`
lists them all, each that can not be written with what is missing.

## The kinds of files

Made by `python docs/generate.py` from the table that the command line and the session read.

| option | endings | what stands in the file | needs |
|---|---|---|---|
{kinds}

An extra is installed by name: `pip install 'contralbero[dxf]'`. Without extras nothing heavier than the program itself is installed or loaded.
The same design and the same version of the program give the same bytes: a file has no clock, no path, no random name. Where a format wants a date,
it is that of the design's revision, else that of its preparation, else 1 January 2026.

More of each: [solids for CAD](#solids-for-cad), [the train for gear programs](rexs.md), [loads](loads.md), [the balancing sheet](balancing.md).
The way back: [what the bench measured](measurements.md), and [inputs found from it](fits.md).

## One frame for all files

![The axes of all files: up, to the side, along the crank](pictures/frame.png)

All files that hold places or directions share one right-handed frame, so that they lie on one another.

- The origin is on the crank's axis at mid-engine. Lengths are in millimetres.
- X is up and Z runs along the crank to the flywheel.
- Y is the side of the design where the engine turns clockwise seen from the front. The crank then turns about +Z.
- An engine that turns anticlockwise has Y the other way, and its crank turns about −Z. In a design angles count in the sense in which the crank
  turns, so that the design's own axes are left-handed there. Vectors become (F_x, ±F_y, F_z), moments (±M_x, M_y, ±M_z), angles from up ±φ;
  the lower sign is that of the anticlockwise engine.
- `rotation_seen_from_front` of `[mounting]` says which way it turns. Without it clockwise is taken, and the file says so.
- A part by itself has its origin on its own axis, Z = 0 at mid-shaft, and stands as it does when cylinder 1 is at top dead centre.
- The hand of a tooth belongs to the part: it does not change with Y. On a right-handed driver that turns about +Z the thrust points to +Z.
- Products of inertia are −∫XY dm, about the centre of gravity.
- Harmonics are a(t) = Re(â·e^(iΩt)) with Ω the order times the crank's speed, and t = 0 at the firing top dead centre of cylinder 1.
  Amplitudes are peaks: an rms value is smaller by √2.

## Solids for CAD

![A module, drawn from its STEP file: two balance shafts with their wheels, driven by the crank over one idler and over two](pictures/module.png)

`--step` writes the shafts, one file each; a mirror image has its own where it is another part. With further options:

- `--wheel NAME`: one wheel, cut as its tool cuts it: fillets and flanks as curves through points of their own, arcs as arcs. `--allowance max` or
  `min` takes the teeth at an end of their allowance. `--blank` gives the cylinder of the reference diameter, which is what the program weighs.
- `--teeth`: the teeth in place of the blank that the shaft has for its wheel. What that changes in mass and in moment of inertia is printed.
- `--module`: all shafts and wheels where they stand, a named part each, with cylinder 1 at top dead centre. Every wheel that meshes has its tooth in the
  gap of the other: that and the hands of the helices are those of the design. A wheel of no known place is left out, and named. The shafts' axes
  come from `axis_mm`, or from `position_mm` of the wheel on them. Without `--teeth` the wheel that is part of a shaft is a blank, which cuts into the
  teeth of its mate.
- A shaft that turns inside its wheel, or ends before it, has the wheel as a body of its own.
- Not in the solids: fillets of shoulders, threads, keys, and the web of a wheel of which the rim is given. `[[shafts.extras]]` are points for the results and no part
  of the file either.

What each solid weighs by the geometry kernel is printed beside the program's own numbers. Where they differ, nothing is written.
"""


def exchange_page() -> str:
    return HEAD.format(kinds="\n".join(row for kind in KINDS.values() for row in _rows(kind)))


def _rows(kind: FileKind) -> list[str]:
    endings = ", ".join(f"`.{ending}`" for ending in kind.endings)
    needs = f"the extra `{kind.extra[0]}`" if kind.extra is not None else ""
    rows = [f"| `--{kind.name}` | {endings} | {kind.what} | {needs} |"]
    return rows + [f"| `--{kind.name} --{name}` | {endings} | {what} | {needs} |" for name, what in kind.rows.items()]
