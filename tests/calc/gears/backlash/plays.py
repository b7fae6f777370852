"""Trains whose play is looked at."""

from dataclasses import replace

from calc.gears.backlash.solve import play
from calc.gears.inputs import Contributor
from calc.library.catalogue import Material, materials
from tests.calc.gears.trains import pair_1, solved

SHAVED = ((-20, -30), (-20, -30))  # the allowances that the text of Finotti 2013 means for both wheels
ALUMINIUM = Material(name="aluminium", E=70e9, density=2700.0, expansion=23e-6)
IRON = Material(name="iron", E=110e9, density=7200.0, expansion=11e-6)
SOLIDS = {**materials(), "aluminium": ALUMINIUM, "iron": IRON}

# Finotti 2013, Table 4.7, [mm]: the support of the 36 and that of the 39
CENTRAL = {
    "centre position": 0.05,
    "seat": 0.025,
    "pin diameter": 0.018,
    "pin concentricity": 0.02,
    "circularity": 0.01,
}
CENTRAL |= {"coaxiality": 0.01, "support pin": 0.02, "gear bore": 0.046, "bearing bore": 0.019}
IDLER = {"centre position": 0.05, "seat": 0.025, "pin diameter": 0.013, "pin concentricity": 0.02, "circularity": 0.01}
IDLER |= {"coaxiality": 0.01, "support pin": 0.016, "gear bore": 0.02}


def played(gears, housing=None):
    return play(gears, solved(gears), SOLIDS, housing)


def parts(kind="radial", *columns):
    return tuple(
        Contributor(name=name, field=field * 1e-3, kind=kind) for column in columns for name, field in column.items()
    )


def changed(gears, mesh=0, wheels=None, **said):
    """The same train with keys of one mesh changed (`said`), or of wheels by their names."""
    meshes = [replace(m, **said) if i == mesh else m for i, m in enumerate(gears.meshes)]
    new = tuple(replace(w, **(wheels or {}).get(w.name, {})) for w in gears.wheels)
    return replace(gears, meshes=tuple(meshes), wheels=new)


def true(gears):
    """The same train of wheels without runout."""
    return replace(gears, wheels=tuple(replace(wheel, runout=0.0) for wheel in gears.wheels))


def alone(allowances=SHAVED, **said):
    """The play of the source's first pair alone, of wheels without runout, and its mesh."""
    housing = said.pop("housing", None)
    found = played(replace(true(pair_1(allowances=allowances)), **said), housing)
    return found, found.meshes["central_idler"]
