# SPDX-License-Identifier: Apache-2.0
"""The rating of every mesh of a train, once its torque is known: load, nominal stresses, influence factors, strength,
screening."""

from collections.abc import Iterator, Mapping
from functools import cache

from ...library.catalogue import Material
from ...sheet.deferred import Later
from ...sheet.formula import formula
from ...sheet.quantity import Described, Stated
from ...sheet.record import record, replace
from ...sheet.step import Outcome, Table, finite
from ...sheet.text import Text
from ...sheet.units import Newton, NewtonMetre, Number, Pascal, RevPerSecond
from ...sheet.value import about, recorded, trace
from ..inputs import GearsInputs
from ..limits import EXTREME
from ..result import MeshResult, TrainResult
from ..stages import least_strand_force, slack_checks, slack_notes
from . import curves, source_sheet
from . import mesh_strength as nominal
from . import stress as s
from .checks import checks
from .influence import influence
from .load import (
    REFERENCE_NU,
    Power,
    RatingContext,
    RatingLoad,
    Surroundings,
    loads,
    mean_torques,
    rating_context,
)
from .mesh_strength import MeshLoad, mesh_strength
from .notes import notes
from .result import Influence, MeshRating, MeshStrength, RatingResult, WheelStrength
from .screening.scuffing import screening
from .strength import contacts_per_turn, load_cycles, loading_of, rim_of

ALONE = Surroundings()


@formula(
    "n",
    "kinematics: all wheels turn in proportion to the crank",
    unit="rpm",
    names={"n": "n_r", "r": "r_n"},
    meanings={"r": "Speed of the crank over that of the rating"},
)
def speed_there(n: RevPerSecond, r: Number) -> RevPerSecond:
    """`r`: speed of the crank over that of the rating.

    >>> speed_there(n=-40.0, r=0.5)
    -20.0
    """
    return n * r


@formula("K_H", "ISO 6336-1: product of the load factors, contact", names={"beta": "K_Hβ", "alpha": "K_Hα"})
def contact_load_factor(K_A: Number, K_V: Number, beta: Number, alpha: Number) -> Number:
    return K_A * K_V * beta * alpha


@formula("K_F", "ISO 6336-1: product of the load factors, root", names={"beta": "K_Fβ", "alpha": "K_Fα"})
def root_load_factor(K_A: Number, K_V: Number, beta: Number, alpha: Number) -> Number:
    return K_A * K_V * beta * alpha


def rating(
    gears: GearsInputs,
    train: TrainResult,
    torque: Mapping[str, NewtonMetre] | NewtonMetre | Power,
    materials: Mapping[str, Material],
    around: Surroundings = ALONE,
) -> Outcome[RatingResult]:
    """Stresses, load factors and safeties of every mesh by the edition of the inputs.

    `torque` is the mean of the first driver, handed on without loss, or that of the driver in every mesh: by the mesh
    ("a_b"), else by the driver's name; or the power of the one or the others."""
    with trace() as lines:
        mean = mean_torques(train, torque)
        load = loads(gears, train, mean, around.uneven)
        context = rating_context(gears, train, materials, around)
        rated = {key: _mesh(context, mesh, load[key], mean) for key, mesh in train.meshes.items()}
        strands = {}
        for name, stage in train.stages.items():
            if name in load and (T_min := load[name].least) is not None:
                with about(Text("stage {name}", name=name)):
                    strands[name] = least_strand_force(T_min=T_min, d=stage.pitch_diameter_driver)
    result = RatingResult(meshes=rated, least_strand_forces=strands, context=context)
    finite(result, "gears", EXTREME)
    strengths = {key: mesh_rating.strength for key, mesh_rating in rated.items() if mesh_rating.strength is not None}
    uneven = _if_uneven(context, rated, load)
    influences = {key: mesh_rating.influence for key, mesh_rating in rated.items() if mesh_rating.influence is not None}

    def tables() -> Iterator[Table]:
        if influences:
            yield from (curves.influence_table(influences), *curves.strength_tables(strengths))
        yield curves.classes_table(context.classes)
        if gears.source_sheet == "finotti":
            yield source_sheet.comparison(train, rated)

    return Outcome(
        "gears",
        result=result,
        checks=(*checks(context, rated, load, uneven), *slack_checks(gears, strands)),
        lines=tuple(lines),
        curves=Later(lambda: curves.curves(rated)),
        tables=Later(tables),
        errata=Later(lambda: source_sheet.errata(train, rated)),
        notes=Later(lambda: (*notes(context, rated, load), *slack_notes(gears, strands))),
    )


def _if_uneven(
    context: RatingContext, rated: Mapping[str, MeshRating], load: Mapping[str, RatingLoad]
) -> dict[str, MeshStrength]:
    """The strengths at the application factor of the worst irregularity, which may load the roots from both sides; none
    where it is not assumed."""
    worst = {}
    with recorded(False):
        for key, rating in rated.items():
            if not load[key].assumed or rating.strength is None:
                continue
            driver, driven = rating.strength.sides
            if load[key].worst_reverses:
                driver, driven = (replace(of, loading=loading_of(0, 0, reverses=True)) for of in (driver, driven))
            assert rating.influence is not None  # as the strength
            of_mesh, K_A = context.train.meshes[key], load[key].at_worst
            like = Loaded(rating.influence, 1.0, 1.0, rating.strength, context)
            worst[key] = loaded(context, of_mesh, _nominal_of(rating), K_A, (driver, driven), like).strength
    return worst


# --- one mesh


@record
class Nominal:
    """What a force makes of a mesh without load factors, as far as these ask for it."""

    F_t: Newton
    sigma_H0: Pascal
    Z_eps: Number


Stresses = tuple[nominal.Contact, dict[str, nominal.Root]]  # nominal ones


@record
class Loaded:
    """A mesh under a force: its influence factors, K_H, K_F, and what they leave of its strength."""

    influence: Influence
    K_H: Number
    K_F: Number
    strength: MeshStrength
    at: RatingContext  # with the speed of its wheels
    nominal: Stresses | None = None

    @property
    def contact(self) -> Number | None:
        """S_H, the smaller of both wheels."""
        return self.strength.safety_contact

    @property
    def bending(self) -> dict[str, Number | None]:
        """S_F by wheel."""
        return {name: root.S_F for name, root in self.strength.bending.items()}


def _nominal_of(rating: MeshRating) -> Nominal:
    return Nominal(rating.tangential_force, rating.contact_stress, rating.contact_ratio_factor)


def nominal_stresses(context: RatingContext, mesh: MeshResult, F_t: Newton, like: Stresses | None = None) -> Stresses:
    """Stresses of a tangential force, K = 1: of the contact, and of the root of each wheel.  `like`: those of another
    force."""
    train, system = context.train, context.train.system
    driver, driven = wheels = train.wheels[mesh.driver], train.wheels[mesh.driven]
    pair = Text("mesh {pair}", pair=mesh.title)
    with about(pair):
        same = None if like is None else like[0]
        contact = nominal.nominal_contact(system, mesh, driver, driven, F_t, context.materials, same)
    roots = dict[str, nominal.Root]()
    for wheel in wheels:
        with about(Text("root of {name} in {name2}", name=wheel.name, name2=pair)):
            of, edition = None if like is None else like[1][wheel.name], context.gears.iso_6336_edition
            roots[wheel.name] = nominal.nominal_root(system, mesh, wheel, F_t, edition, of)
    return contact, roots


def _mesh(context: RatingContext, mesh: MeshResult, load: RatingLoad, mean: Mapping[str, NewtonMetre]) -> MeshRating:
    gears, train = context.gears, context.train
    wheels = train.wheels[mesh.driver], train.wheels[mesh.driven]
    with about(Text("mesh {pair}", pair=mesh.title)):
        F_t = s.tangential_force(load.rated, wheels[0].pitch_diameter)
    contact, roots = nominal_stresses(context, mesh, F_t)
    first = next(iter(mean.values()))
    sheet = source_sheet.sheet(train.system, mesh, wheels, first) if gears.source_sheet == "finotti" else None
    rating = MeshRating(
        mean_torque=load.mean,
        dynamic_torque=load.dynamic,
        least_torque=load.least,
        application_factor=load.K_A,
        tangential_force=F_t,
        zone_factor=contact.Z_H,
        contact_ratio_factor=contact.Z_eps,
        helix_factor=contact.Z_beta,
        contact_stress=contact.sigma_H0,
        root_helix_factor=roots[mesh.driven].Y_beta,
        form={id: stated for wheel, root in roots.items() for id, stated in _stated_form(wheel, root).items()},
        root_stress={f"root_stress_{wheel}": Stated(_labels(wheel)[3], root.sigma_F0) for wheel, root in roots.items()},
        sheet=sheet,
        torque=load.rated,
        forms={wheel: root.form for wheel, root in roots.items()},
    )
    rated = F_t and {mesh.driver, mesh.driven} <= context.classes.keys()
    return _with_strength(context, mesh, load, rating, roots) if rated else rating


def _stated_form(wheel: str, root: nominal.Root) -> dict[str, Stated]:
    ids, form = ("form_factor", "stress_correction", "notch_parameter"), root.form
    return {
        f"{id}_{wheel}": Stated(about, x) for id, about, x in zip(ids, _labels(wheel), (form.Y_F, form.Y_S, form.q_s))
    }


@cache
def _labels(wheel: str) -> tuple[Described, ...]:
    return (
        Described(Text("Form factor of {wheel}", wheel=wheel), "", "Y_F"),
        Described(Text("Stress correction factor of {wheel}", wheel=wheel), "", "Y_S"),
        Described(Text("Notch parameter of {wheel}", wheel=wheel), "", "q_s"),
        Described(Text("Nominal root stress of {wheel}, K = 1", wheel=wheel), "MPa", "σ_F0"),
    )


def _with_strength(
    context: RatingContext, mesh: MeshResult, load: RatingLoad, rating: MeshRating, roots: Mapping[str, nominal.Root]
) -> MeshRating:
    """The same with load factors, strength and screening: of a mesh that carries something, whose wheels have a
    strength class."""
    gears, train, driver, driven = context.gears, context.train, mesh.driver, mesh.driven
    sides = (
        side(context, driver, roots[driver], contact_cycles(context, driver), load.reverses),
        side(context, driven, roots[driven], contact_cycles(context, driven), load.reverses),
    )
    under = loaded(context, mesh, _nominal_of(rating), load.K_A, sides)
    screened = None
    if context.oil is not None:
        mates = max(sum(name in (m.driver, m.driven) for m in gears.meshes) for name in (driver, driven))
        screened = screening(
            train.system,
            mesh,
            train.wheels[driver],
            train.wheels[driven],
            F_t=rating.tangential_force,
            oil=context.oil,
            materials=context.materials,
            roughness=context.flank_ra,
            load_factor=under.K_H,
            application_factor=load.K_A,
            accuracy_grade=gears.accuracy_grade,
            mates=mates,
            load_stage=gears.scuffing_load_stage,
            permissible_film=gears.permissible_film,
            mesh_stiffness=under.influence.mesh_stiffness,
            structural_factor=min(context.structural[driver], context.structural[driven]),
        )
    return replace(
        rating,
        influence=under.influence,
        contact_load_factor=under.K_H,
        root_load_factor=under.K_F,
        strength=under.strength,
        screening=screened,
    )


def loaded(
    context: RatingContext,
    mesh: MeshResult,
    under: Nominal,
    K_A: Number,
    sides: tuple[WheelStrength, WheelStrength],
    like: Loaded | None = None,
) -> Loaded:
    """Influence factors and strength of a mesh by its nominal stresses and an application factor, at the speed of the
    wheels in the context.

    `like`: the same mesh at the same speed and lives under another load; what no load changes is taken from it."""
    gears, system = context.gears, context.train.system
    given = next(m for m in gears.meshes if (m.driver, m.driven) == (mesh.driver, mesh.driven))
    K = influence(
        system,
        mesh,
        context.bodies[mesh.driver],
        context.bodies[mesh.driven],
        F_t=under.F_t,
        K_A=K_A,
        grade=gears.accuracy_grade,
        f_sh=given.shaft_deflection or 0.0,
        f_ma=given.mesh_misalignment,
        C_a=gears.tip_relief,
        Z_eps=under.Z_eps,
        like=None if like is None else like.influence,
    )
    with about(Text("mesh {pair}", pair=mesh.title)):
        K_H = contact_load_factor(K_A, K.dynamic_factor, K.face_load_factor_flank, K.transverse_load_factor_flank)
        K_F = root_load_factor(K_A, K.dynamic_factor, K.face_load_factor_root, K.transverse_load_factor_root)
        eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
    load = MeshLoad(
        under.sigma_H0,
        K_H,
        K_F,
        mesh.working_pressure_angle,
        mesh.transverse_contact_ratio,
        eps_alphan,
        mesh.overlap_ratio,
        system.m_n,
        K.pitch_line_velocity,
        REFERENCE_NU if context.nu_40 is None else context.nu_40,
        context.flank_rz,
        gears.root_rz,
        gears.accuracy_grade,
    )
    return Loaded(K, K_H, K_F, mesh_strength(*sides, load, None if like is None else like.strength), context)


def contact_cycles(context: RatingContext, name: str, speed_ratio: Number = 1.0) -> Number | None:
    """Load cycles of a wheel whose every contact counts; None: no life is given.  `speed_ratio`: its speed over that of
    the rating."""
    gears, wheel = context.gears, context.train.wheels[name]
    if gears.life is None:
        return None
    n, c = abs(wheel.speed), float(contacts_per_turn(*_meshes(context, name)))
    with about(Text("wheel {name}", name=name)):
        if speed_ratio != 1.0:
            n = speed_there(n=n, r=speed_ratio)
        return load_cycles(n=n, L_h=gears.life, c=c)


def _meshes(context: RatingContext, name: str) -> tuple[int, int]:
    """How many meshes drive a wheel, and how many it drives."""
    meshes = context.gears.meshes
    return sum(m.driven == name for m in meshes), sum(m.driver == name for m in meshes)


def side(context: RatingContext, name: str, root: nominal.Root, cycles: Number | None, reverses: bool) -> WheelStrength:
    """A wheel under its nominal root stress; `reverses`: its torque changes its sign."""
    wheel = context.train.wheels[name]
    given = next(w for w in context.gears.wheels if w.name == name)
    return WheelStrength(
        name,
        context.classes[name],
        wheel.teeth,
        wheel.tip_diameter,
        wheel.base_diameter,
        wheel.tooth_depth,
        rim_of(wheel.root_diameter, given.bore_diameter, given.rim_thickness),
        root.form.q_s,
        root.sigma_F0,
        loading_of(*_meshes(context, name), reverses),
        cycles,
    )
