# SPDX-License-Identifier: Apache-2.0
"""The checks of the rating: load, notch, influence factors, strength classes, safeties, and the screening by film and
temperature."""

import math
from collections.abc import Iterator, Mapping
from operator import itemgetter

from ...engine.inputs import EngineInputs
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.quantity import dotted
from ...sheet.remedy import by_key
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import Kelvin, Metre, NewtonPerMetre, Number, Pascal
from ..inputs import GearsInputs, Mesh, wheel_key
from ..result import MeshResult
from ..wheel_inputs import Wheel
from . import strength as iso6336
from .classes import StrengthClass
from .distribution import CLAUSE_7
from .dynamic import CLAUSE_6, CLAUSE_9, MAIN_TO
from .load import USUAL, RatingContext, RatingLoad
from .mesh_strength import S_F_LEAST, S_H_LEAST
from .result import Influence, MeshRating, MeshStrength
from .screening.load import Screening

S_H_USUAL, S_F_USUAL = 1.2, 1.6
MINIMUM = (
    "ISO 6336-1 leaves the minimum to agreement; rule of this program: limit at the lower, advice at the upper end of "
    "the usual {least} to {usual} (IACS UR M56 for auxiliary gears: {auxiliary})"
)
MINIMUM_H = Text(MINIMUM, least=S_H_LEAST, usual=S_H_USUAL, auxiliary=Text("{low} to {high}", low=1.15, high=1.2))
MINIMUM_F = Text(MINIMUM, least=S_F_LEAST, usual=S_F_USUAL, auxiliary=Text("{low} to {high}", low=1.4, high=1.45))
ISO = Text("ISO 6336-1")
LEAST_LOAD: NewtonPerMetre = 50e3  # below, flanks may part and hammer
MARGIN: Kelvin = 50.0  # ISO/TR 13989-1:2000, 10.5
LOWEST_TEST_PRESSURE: Pascal = 800e6  # load stage 5 of the FZG test C-GF, from memory


# --- what is known of each check

K_A = dotted("gears", GearsInputs.application_factor)
DELTA_S = dotted("gears", GearsInputs.speed_irregularity)
FACE = dotted("gears", GearsInputs.face_width)
GRADE = dotted("gears", GearsInputs.accuracy_grade)
DRIVER_CLASS = dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.gear_material)
DRIVEN_CLASS = dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.gear_material)
CLASS = dotted("gears", GearsInputs.wheels, "W", Wheel.gear_material)
OWN_FACE = dotted("gears", GearsInputs.wheels, "W", Wheel.face_width)
OIL_TEMPERATURE = "friction.oil_temperature_C"  # of a step that comes later

SAFETY_CONTACT = CheckRule(
    "gears.M.safety_contact",
    "limit",
    "The flanks pit.",
    source=MINIMUM_H,
    role="physics",
    demand=True,
    value_id=dotted("gears", "M", MeshStrength.safety_contact),
    moved_by=(FACE, DRIVER_CLASS, DRIVEN_CLASS, GRADE, K_A),
    short=Text("S_H"),
    proven=("σ_H0", "K_H", "K_V", "K_Hβ", "K_Hα"),
)
SAFETY_CONTACT_USUAL = CheckRule(
    "gears.M.safety_contact_usual",
    "advice",
    "The usual safety.",
    source=MINIMUM_H,
    demand=True,
    cause=SAFETY_CONTACT.id,
    value_id=SAFETY_CONTACT.value_id,
    moved_by=(FACE, DRIVER_CLASS, DRIVEN_CLASS, GRADE),
)
SAFETY_BENDING = CheckRule(
    "gears.W.safety_bending",
    "limit",
    "The teeth break.",
    source=MINIMUM_F,
    role="physics",
    demand=True,
    moved_by=(OWN_FACE, FACE, CLASS, GRADE, K_A),
    short=Text("S_F"),
    proven=("σ_F0", "K_F", "K_V", "K_Fβ", "K_Fα"),
)
SAFETY_BENDING_USUAL = CheckRule(
    "gears.W.safety_bending_usual",
    "advice",
    "The usual safety.",
    source=MINIMUM_F,
    demand=True,
    cause=SAFETY_BENDING.id,
    moved_by=(OWN_FACE, FACE, CLASS, GRADE),
)
APPLICATION_FACTOR = CheckRule(
    "gears.M.application_factor",
    "caution",
    "The teeth are rated with less than the torque that is known.",
    source=Text("mean and dynamic torque over the mean"),
    demand=True,
    moved_by=(K_A,),
)
FLANK_REVERSAL = CheckRule(
    "gears.M.flank_reversal",
    "advice",
    "The teeth rattle: noise, not breakage.",
    unit="N·m",
    source=Text("dynamics: the flanks stay in touch while the torque does not change its sign"),
    zero="mean torque of the mesh",
    cause="gears.rattle",
    moved_by=(dotted("engine", EngineInputs.flywheel_inertia), DELTA_S),
)
LINE_LOAD = CheckRule(
    "gears.M.line_load",
    "method",
    "The load factors of ISO 6336 are not made for so small a load.",
    unit="N/mm",
    source=Text("{iso}: below 50 N/mm flanks can part and hammer; the factors are made for 100 N/mm and more", iso=ISO),
    advice=Text(
        "K_V, K_Hβ and K_Hα are outside their validity here: small deviations over a small load. "
        "What governs is the torque of the speed's irregularity "
        "or the application factor; a narrower face width raises the load per width."
    ),
    cause="gears.line_load",
    value_id=dotted("gears", "M", Influence.line_load),
    moved_by=(FACE, K_A, DELTA_S),
    weakens=((SAFETY_BENDING, 2.0), (SAFETY_CONTACT, math.sqrt(2.0))),
)
RESONANCE = CheckRule(
    "gears.M.resonance",
    "caution",
    "Near its resonance the load of the teeth rises beyond the factor of a formula.",
    source=Text("{clause_6}: the main resonance lies from N_S to 1.15", clause_6=CLAUSE_6),
    advice=Text(
        "Change the number of teeth, or the mass of the wheels, so that the teeth do not meet at the natural "
        "frequency of the pair."
    ),
    value_id=dotted("gears", "M", Influence.resonance_ratio),
    moved_by=(
        dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.teeth),
        dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.teeth),
        dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.rim_thickness),
        dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.rim_thickness),
    ),
)
SHIFT_SUM = CheckRule(
    "gears.M.shift_sum",
    "method",
    "Outside its range the stiffness of the teeth is an extrapolation.",
    sense="in",
    source=Text("{clause_9}: range of the stiffness of the teeth", clause_9=CLAUSE_9),
    advice=Text("The stiffness of the teeth is extrapolated; the factors K are uncertain."),
    value_id=dotted("gears", "M", MeshResult.shift_sum),
    moved_by=(
        dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.profile_shift),
        dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.profile_shift),
        dotted("gears", GearsInputs.meshes, "#", Mesh.centre_distance),
    ),
    weakens=((SAFETY_BENDING, 1.3),),
)
CONTACT_WIDTH = CheckRule(
    "gears.M.contact_width",
    "caution",
    "A part of the face does not carry; the safeties count with it.",
    unit="%",
    source=Text("{clause_7}: K_Hβ up to 2", clause_7=CLAUSE_7),
    advice=Text(
        "The load is too small to press the misaligned teeth together over the whole face width: crown or "
        "end-relieve the teeth, or hold the axes more parallel (misalignment of the mesh, accuracy grade)."
    ),
    value_id=dotted("gears", "M", Influence.contact_width_share),
    moved_by=(dotted("gears", GearsInputs.meshes, "#", Mesh.mesh_misalignment), GRADE, FACE),
)
NOTCH = CheckRule(
    "gears.M.notch_W",
    "method",
    "Outside its range the stress correction factor is an extrapolation.",
    sense="in",
    source=Text("ISO 6336-3: range of Y_S"),
    advice=Text("The stress correction factor is outside its range: choose a larger tip radius of the tool."),
    cause="gears.M.notch",
    value_id=dotted("gears", "M", "notch_parameter_W"),
    moved_by=(dotted("gears", GearsInputs.tool_tip_radius),),
    weakens=((SAFETY_BENDING, 1.3),),
)
ROOT_ROUGHNESS = CheckRule(
    "gears.train.root_roughness",
    "method",
    "Outside its range the surface factor is an extrapolation.",
    Text("Roughness Rz of the roots"),
    "<=",
    "µm",
    Text("ISO 6336-3: Y_RrelT was found up to 40 µm"),
    moved_by=(dotted("gears", GearsInputs.root_rz),),
    weakens=((SAFETY_BENDING, 1.1),),
)
HARDNESS = CheckRule(
    "gears.W.hardness",
    "limit",
    "The strength that the safeties count with is not there.",
    unit="HV",
    advice=Text("A softer flank does not reach the class: choose another strength class."),
    role="self",
    moved_by=(dotted("gears", GearsInputs.wheels, "W", Wheel.hardness), CLASS),
)
HARDNESS_MOST = CheckRule(
    "gears.W.hardness_most",
    "advice",
    "More hardness than the class has adds nothing.",
    sense="<=",
    unit="HV",
    advice=Text("The strength is that of the upper end: more hardness adds none, and may make the teeth brittle."),
    cause=HARDNESS.id,
    moved_by=HARDNESS.moved_by,
)
MICROPITTING_FILM = CheckRule(
    "gears.M.micropitting_film",
    "advice",
    "A screening; a thin film alone need not harm.",
    cause="gears.thin_film",
    value_id=dotted("gears", "M", Screening.specific_film_min),
    moved_by=(dotted("gears", GearsInputs.flank_rz), OIL_TEMPERATURE, "bearings.supply_temperature_C"),
)
SCUFFING = CheckRule(
    "gears.M.scuffing",
    "caution",
    "A screening: the oil may break down between the flanks.",
    unit="K",
    advice=Text(
        "Cooler oil, an oil of a higher load stage, smoother flanks, less sliding (shorter addenda), or more "
        "face width."
    ),
    moved_by=(
        OIL_TEMPERATURE,
        dotted("gears", GearsInputs.scuffing_load_stage),
        dotted("gears", GearsInputs.flank_rz),
        FACE,
    ),
)

# what is not given of the irregularity: each of them would do; and what stands for it
IRREGULARITY = K_A, DELTA_S
TAKEN = (Text("application factor {k_a}", k_a=Amount(USUAL)),)
KNOW_THE_ENGINE = Text(
    "How unevenly the engine turns is not known: give the irregularity of the first driver's speed, or the gas "
    "and the inertia of the flywheel."
)


# --- all of them


def checks(
    context: RatingContext,
    rated: Mapping[str, MeshRating],
    load: Mapping[str, RatingLoad],
    uneven: Mapping[str, MeshStrength],
) -> Iterator[Check]:
    """Of each mesh by itself, then of the safeties of all and of what they stand on.

    `uneven`: the strengths at the application factor of an engine whose irregularity is not known; none where it is."""
    gears, meshes = context.gears, context.train.meshes
    for key, mesh_rating in rated.items():
        yield from mesh_checks(key, meshes[key], mesh_rating, load[key])
    strengths = {key: mesh.strength for key, mesh in rated.items() if mesh.strength is not None}
    yield from strength_checks(strengths, uneven)
    for wheel in gears.wheels:
        if wheel.name not in context.classes:
            yield SAFETY_BENDING(
                None,
                S_F_LEAST,
                at=wheel.name,
                name=Text("Safety of {wheel} against tooth breakage", wheel=wheel.name),
                advice=Text("Without a strength class the wheel and its meshes have no safety."),
                missing=Missing((wheel_key(wheel.name, Wheel.gear_material),), (), "none", "none"),
            )
    yield roughness_check(gears.root_rz)
    for name, cls in context.classes.items():
        yield from hardness_checks(name, cls)


def mesh_checks(key: str, mesh: MeshResult, rated: MeshRating, load: RatingLoad) -> Iterator[Check]:
    """Of one mesh, its strength excepted; `key`: DRIVER_DRIVEN."""
    pair = mesh.title
    for wheel, form in rated.forms.items():
        yield NOTCH(form.q_s, (1.0, 8.0), at=(key, wheel), name=Text("Notch parameter q_s of {wheel}", wheel=wheel))
    if (factor_check := application_factor_check(key, pair, load)) is not None:
        yield factor_check
    if (reversal_check := flank_reversal_check(key, pair, load)) is not None:
        yield reversal_check
    if rated.influence is not None:
        yield from influence_checks(key, mesh, rated.influence)
    if rated.screening is not None:
        yield from screening_checks(key, rated.screening)


# --- the load


def application_factor_check(key: str, pair: str, load: RatingLoad) -> Check | None:
    """Whether a given application factor covers the torque that is known."""
    if load.dynamic is None or load.of_peak or not load.mean:
        return None
    name, needed = Text("Application factor {name}", name=pair), 1 + load.dynamic / abs(load.mean)
    left_out = by_key(GearsInputs, K_A, None, effect=Text("the peak of both is then rated"))
    return APPLICATION_FACTOR(load.K_A, needed, at=key, name=name, remedies=left_out)


def flank_reversal_check(key: str, pair: str, load: RatingLoad) -> Check | None:
    """Whether the flanks leave each other; none where a given application factor stands for the irregularity, or
    nothing is carried."""
    name = Text("Least torque of {name} over the cycle", name=pair)
    if load.least is not None:
        advice = Text(
            "The teeth rattle: hold the backlash small, prefer helical teeth with a large overlap, or take a "
            "heavier flywheel or a wheel that is sprung against play."
        )
        return FLANK_REVERSAL(load.least, 0.0, at=key, name=name, advice=advice, scale=abs(load.mean))
    if not load.assumed or not load.mean:
        return None
    return FLANK_REVERSAL(
        None,
        0.0,
        at=key,
        name=Text("{name}, not known", name=name),
        advice=KNOW_THE_ENGINE,
        scale=abs(load.mean),
        missing=Missing(IRREGULARITY, TAKEN, "none", "none"),
    )


def influence_checks(key: str, mesh: MeshResult, factors: Influence) -> Iterator[Check]:
    pair, below = mesh.title, factors.resonance_ratio <= 1
    yield LINE_LOAD(factors.line_load, LEAST_LOAD, at=key, name=Text("Load per face width {pair}", pair=pair))
    yield RESONANCE(
        factors.resonance_ratio,
        factors.lower_resonance if below else MAIN_TO,
        at=key,
        name=Text("Speed of {pair} over its main resonance, {speed_range}", pair=pair, speed_range=factors.speed_range),
        sense="<=" if below else ">=",
    )
    yield SHIFT_SUM(mesh.shift_sum, (-0.5, 2.0), at=key, name=Text("Sum of the profile shifts {pair}", pair=pair))
    if factors.line_load >= LEAST_LOAD:  # below it no teeth are pressed together over their whole width
        yield CONTACT_WIDTH(
            factors.contact_width_share, 1.0, at=key, name=Text("Face width that touches, {pair}", pair=pair)
        )


# --- strength


def strength_checks(
    meshes: Mapping[str, MeshStrength], uneven: Mapping[str, MeshStrength] | None = None
) -> Iterator[Check]:
    """Of every mesh its flanks, of every wheel the weakest of its roots; none where there is no load.

    `uneven`: the same at the application factor of an irregularity that is not known."""
    flanks, at_worst = _weakest_flanks(meshes), _weakest_flanks(uneven or {})
    for key, (S_H, weak) in flanks.items():
        driver, driven = meshes[key].sides
        name = Text(
            "Safety against pitting {name}–{name2}, on stress (on load {s_h}), weaker: {weak}",
            name=driver.name,
            name2=driven.name,
            s_h=Amount(S_H**2, form=".3g"),
            weak=weak,
        )
        usual, missing = Text("{name}, usual", name=name), _irregularity(S_H, at_worst.get(key))
        advice, better = (_advice(weak, (least / S_H) ** 2, missing) for least in (S_H_LEAST, S_H_USUAL))
        yield SAFETY_CONTACT(S_H, S_H_LEAST, at=key, name=name, advice=advice, missing=missing)
        yield SAFETY_CONTACT_USUAL(S_H, S_H_USUAL, at=key, name=usual, advice=better)
    roots, at_worst = _weakest_roots(meshes), _weakest_roots(uneven or {})
    for wheel, (S_F, pair) in roots.items():
        name = Text("Safety of {wheel} against tooth breakage", wheel=wheel)
        weakest, usual = Text("{name}, in {pair}", name=name, pair=pair), Text("{name}, usual", name=name)
        missing = _irregularity(S_F, at_worst.get(wheel))
        advice, better = (_advice(wheel, least / S_F, missing) for least in (S_F_LEAST, S_F_USUAL))
        yield SAFETY_BENDING(S_F, S_F_LEAST, at=wheel, name=weakest, advice=advice, missing=missing)
        yield SAFETY_BENDING_USUAL(S_F, S_F_USUAL, at=wheel, name=usual, advice=better)


def _weakest_flanks(meshes: Mapping[str, MeshStrength]) -> dict[str, tuple[Number, str]]:
    """Of every mesh that carries something the smaller safety of its flanks, and the wheel that has it."""
    weakest = {}
    for key, mesh in meshes.items():
        safeties = [(flank.S_H, wheel) for wheel, flank in mesh.contact.items() if flank.S_H is not None]
        if safeties:
            weakest[key] = min(safeties, key=itemgetter(0))
    return weakest


def _weakest_roots(meshes: Mapping[str, MeshStrength]) -> dict[str, tuple[Number, str]]:
    """Of every wheel that carries something the least safety of its root, and the mesh that it has it in."""
    weakest: dict[str, tuple[Number, str]] = {}
    for mesh in meshes.values():
        for wheel, root in mesh.bending.items():
            if root.S_F is not None and (wheel not in weakest or root.S_F < weakest[wheel][0]):
                weakest[wheel] = root.S_F, mesh.pair
    return weakest


def _irregularity(as_taken: Number, at_worst: tuple[Number, str] | None) -> Missing | None:
    """That nothing is known of the irregularity, where nothing is: at the least there is what is taken."""
    return None if at_worst is None else Missing(IRREGULARITY, TAKEN, as_taken, at_worst[0])


def _advice(wheel: str, width: Number, missing: Missing | None) -> Text:
    """`width`: by how much the face width, or the load, would have to change."""
    if width <= 1:
        return EMPTY if missing is None else KNOW_THE_ENGINE
    return Text(
        "Give more than {width} times the face width, or bring the load to less than {width2} of it (the load "
        "factors rise as the load per width falls), {better}, or a finer accuracy grade.",
        width=Amount(width, form=".3g"),
        width2=Amount(1 / width, form=".3g"),
        better=Text("a stronger class of {wheel} or a better quality", wheel=wheel),
    )


def roughness_check(root_rz: Metre) -> Check:
    """Whether the surface factor of the root holds."""
    most = iso6336.ROUGHEST_ROOT
    smoother = by_key(GearsInputs, dotted("gears", GearsInputs.root_rz), round(most * 1e6, 6), bound="<=")
    return ROOT_ROUGHNESS(root_rz, most, remedies=smoother)


def hardness_checks(wheel: str, cls: StrengthClass) -> Iterator[Check]:
    """Whether a given hardness lies in the range of its class; none where it is not given."""
    if cls.hardness is None:
        return
    factor = 1.0 if cls.scale == "HV" else 0.95
    source = Text(
        "ISO 6336-5:2016, Table 1: {name}, {quality}, {low} to {high} {scale}",
        name=cls.name,
        quality=cls.quality,
        low=Amount(cls.low, form="g"),
        high=Amount(cls.high, form="g"),
        scale=cls.scale,
    )
    name = Text("Hardness of {wheel} for its strength class", wheel=wheel)
    upper = Text("{name}, upper end", name=name)
    yield HARDNESS(cls.hardness, cls.low / factor, at=wheel, name=name, source=source)
    yield HARDNESS_MOST(cls.hardness, cls.high / factor, at=wheel, name=upper, source=source)


# --- screening


def screening_checks(key: str, screened: Screening) -> Iterator[Check]:
    """Of the film, where there is one, and of the contact temperature."""
    title = screened.title
    if screened.specific_film_min is not None:
        limit = Text("λ_GFP by a rule of this program; a test of the oil gives its own")
        if screened.permissible_given:
            limit = Text("λ_GFP of the oil's test")
        place = screened.film_place
        yield MICROPITTING_FILM(
            screened.specific_film_min,
            screened.permissible_film,
            at=key,
            name=Text("Specific film thickness {title} at {film_place} (screening)", title=title, film_place=place),
            source=Text("ISO/TR 15144-1:2014, ISO/TS 6336-22:2018, method B; {limit}", limit=limit),
            advice=Text(
                "Smoother flanks, cooler or thicker oil, more speed; stronger steel does not help. {pressure}",
                pressure=_pressure(screened.film_pressure or 0.0),
            ),
        )
    assumed = "" if screened.load_stage_given else Text(", assumed by a rule of this program")
    stage = Text("FZG load stage {load_stage}", load_stage=Amount(screened.load_stage, form="g")) + assumed
    yield SCUFFING(
        screened.scuffing_margin,
        MARGIN,
        at=key,
        name=Text("Scuffing temperature above the contact temperature {title} (screening)", title=title),
        source=Text("ISO/TR 13989-1:2000 (ISO/TS 6336-20), 10.5: for instance 50 K; {stage}", stage=stage),
    )


def _pressure(pressure: Pascal) -> Text:
    """How a Hertzian pressure stands to that of the test of oils."""
    if pressure >= LOWEST_TEST_PRESSURE:
        return Text("Have the oil tested (FZG C-GF/8.3/90): its result gives the permissible film.")
    return Text(
        "The pressure is below that of the first stage of the test of oils against micropitting (FZG C-GF, about "
        "{lowest}, from memory): a thin film alone then need not harm.",
        lowest=Text("{lowest_test_pressure} MPa", lowest_test_pressure=Amount(LOWEST_TEST_PRESSURE / 1e6, form=".0f")),
    )
