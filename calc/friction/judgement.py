# SPDX-License-Identifier: Apache-2.0
"""What is to be said about solved friction: checks, where the source is wrong, notes and curves."""

from collections.abc import Iterator

import numpy as np

from ..sheet.check import Check, check
from ..sheet.number import short
from ..sheet.step import Curve, Erratum, Series
from ..sheet.trace import untraced
from .film import ELLIPTICAL, LEAST_FACTOR, Oil
from .inputs import FrictionInputs
from .loss import THESIS, MeshLoss, solve_mesh
from .result import FrictionResult, MeshResult

OWN = "rule of this program"
BALANCE_LIMIT = 1e-6  # W
BULK_LIMIT = 10.0  # K


def by_regime(mesh: MeshResult) -> MeshLoss:
    return mesh.by_regime or mesh.judged


# --- checks ----------------------------------------------------------------------------------------------------------------
def checks(friction: FrictionInputs, result: FrictionResult) -> tuple[Check, ...]:
    balance = check(
        "friction.train.balance", "Power balance of the train: what is left over", abs(result.residual), "<=", BALANCE_LIMIT, "W",
        "conservation of energy", "A fault of the program, not of the design: please report it.",
    )  # fmt: skip
    return (balance, *(c for name, mesh in result.meshes.items() for c in _of_mesh(f"friction.{name}", friction, mesh)))


def _of_mesh(id: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Check]:
    """Advice: where the model leaves its range, and what the flanks would like."""
    yield check(
        f"{id}.regime", "EHL film over rigid isoviscous film at the pitch point", by_regime(mesh).lead_at_pitch, ">=", 1.0, "",
        "Johnson 1970, regimes of fluid-film lubrication",
        "EHL formula outside its validity: the load is so light that the rigid isoviscous film governs. "
        + ("The rolling loss is an upper bound." if friction.film == "judged" else 'Choose film = "judged".'), kind="advice",
    )  # fmt: skip
    yield check(
        f"{id}.lambda", "Smallest film over roughness", mesh.judged.lambda_min, ">=", 1.0, "",
        "mixed friction below about 1 (AGMA 925-A03, as generally published)",
        "The flanks touch: smoother flanks, thicker or cooler oil, more speed. Below 0.8 the mixed law is harsher than Schlenk's tests.",
        kind="advice",
    )  # fmt: skip
    yield check(
        f"{id}.deborah", "Largest Deborah number", mesh.judged.deborah_max, "<=", 1.0, "", f"{THESIS}: range of Eyring's law",
        "The oil answers as a solid: its friction is overestimated.", kind="advice",
    )  # fmt: skip
    yield check(
        f"{id}.inlet_heating", "Smallest thermal reduction of the film", mesh.judged.thermal_reduction_min, ">", LEAST_FACTOR, "", OWN,
        "The inlet is hotter than Gupta's formula allows, the film is held at 5 %: less speed or a thinner oil.", kind="advice",
    )  # fmt: skip
    if friction.bulk_temperature is None:
        yield check(
            f"{id}.bulk", "Estimated warming of the teeth above the oil", mesh.bulk_rise, "<=", BULK_LIMIT, "K", OWN,
            "The teeth run hotter than the oil: give bulk_temperature_C.", kind="advice",
        )  # fmt: skip


# --- where the source is wrong ---------------------------------------------------------------------------------------------
def errata(friction: FrictionInputs, result: FrictionResult) -> tuple[Erratum, ...]:
    return tuple(e for name, mesh in result.meshes.items() for e in _errata(f"friction.{name}", friction, mesh))


def _errata(id: str, friction: FrictionInputs, mesh: MeshResult) -> Iterator[Erratum]:
    if by_regime(mesh).lead_at_pitch < 1 and friction.film == "judged":
        yield Erratum(
            f"{id}.film_min", "Thinnest film", mesh.source.film_min * 1e6, "µm", f"{THESIS}, section on film thickness",
            "The source takes the EHL formula everywhere. At this load the flanks stay round and the oil as thin as without pressure: "
            "the rigid isoviscous film is thicker, and it costs rolling power that the source does not count.",
        )  # fmt: skip
    with untraced():
        elliptical = solve_mesh(mesh.case, mesh.judged.load, False, ELLIPTICAL)
    yield Erratum(
        f"{id}.source.loss", "Power lost in the mesh, EHL film", elliptical.loss, "W", f"{THESIS}, eq. 26",
        "The printed exponent of the materials parameter, 0.53, belongs to elliptical contacts; line contacts have 0.56.",
    )  # fmt: skip
    yield Erratum(
        f"{id}.efficiency", "Efficiency of the mesh", 1 - mesh.judged.efficiency, "", f"{THESIS}, eq. 1",
        "The printed quotient is the share that is lost, not the efficiency.",
    )  # fmt: skip


# --- notes -----------------------------------------------------------------------------------------------------------------
def notes(friction: FrictionInputs, result: FrictionResult, oil: Oil) -> tuple[str, ...]:
    found = []
    if friction.bulk_temperature is None:
        found.append(f"The teeth are taken as warm as the oil, {short(oil.T_m)} °C; their warming is estimated beside.")
    for mesh in result.meshes.values():
        share = by_regime(mesh).rigid_share
        rigid = f"a rigid isoviscous film on {share * 100:.0f} % of the path"
        found.append(f"Mesh {mesh.case.mesh.title}: {rigid if share else 'no rigid isoviscous film, the EHL formula holds'}.")
    if friction.load_sharing != "linear" and not all(mesh.case.mesh.spur for mesh in result.meshes.values()):
        found.append("The load of a helical mesh is uniform along its contact lines: load_sharing counts for spur pairs only.")
    if friction.film == "source":
        found.append("The friction source's film is judged: EHL everywhere, no rolling loss.")
    elif any(mesh.judged.rolling_loss for mesh in result.meshes.values()):
        found.append("The rolling loss of the rigid film supposes a full inlet: it is an upper bound.")
    Lambda, base = short(oil.lubricant.limiting_shear), oil.lubricant.oil.base
    found.append(f"Limiting shear {Lambda} of the pressure ({base}) is an assumption, ±40 %; steel is taken to conduct 46 W/(m·K).")
    found.append("Churning of wheels that dip into oil and rolling bearings are not counted, unless given as other losses.")
    found.append(f"Windage in {short(friction.mist_density)} kg/m³; the tests behind its formula ran in mist twenty times as dense as air.")
    if friction.other_losses:
        found.append("Another loss is carried by the wheel with whose name its own begins, else by the last wheel, through all meshes.")
    return tuple(found)


# --- curves ----------------------------------------------------------------------------------------------------------------
def curves(result: FrictionResult) -> tuple[Curve, ...]:
    return tuple(c for name, mesh in result.meshes.items() for c in _curves(name, mesh))


def _curves(name: str, mesh: MeshResult) -> Iterator[Curve]:
    """Along the path in the middle of the face, judged and by the other model."""
    title, letters = f"Mesh {mesh.case.mesh.title}", "ABCDE" if mesh.case.mesh.spur else "ACE"
    marks = ", ".join(f"{letter} {x * 1e3:.2f}" for letter, x in zip("ABCDE", mesh.case.path.marks) if letter in letters)
    way = f"x from T₁, mm ({marks})"
    models = (("judged", mesh.judged), ("by regime", mesh.by_regime) if mesh.by_regime else ("source", mesh.source))

    def lines(quantity: str, factor: float = 1.0) -> tuple[Series, ...]:
        return tuple(Series(label, np.asarray(m.local.x) * 1e3, np.asarray(getattr(m.local, quantity)) * factor) for label, m in models)

    roughness = (("combined roughness", mesh.case.sigma * 1e6),)
    yield Curve(f"{name}.friction", f"{title}: coefficient of friction along the path", way, "μ", lines("mu"))
    yield Curve(f"{name}.film", f"{title}: film along the path", way, "h, µm", lines("h", 1e6), roughness)
    yield Curve(f"{name}.heat", f"{title}: friction power along the path", way, "q, W/mm of contact line", lines("q", 1e-3))
    yield Curve(f"{name}.temperature", f"{title}: film temperature along the path", way, "T_f, °C", lines("T_f"))
