# SPDX-License-Identifier: Apache-2.0
"""The checks of the rating: load, notch, influence factors, strength classes, safeties, and the screening by film and
temperature."""

import math
from collections.abc import Iterator, Mapping

from ...sheet.check import Check
from ...sheet.quantity import dotted
from ...sheet.remedy import by_key
from ...sheet.shim_check import check
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import Kelvin, Metre, NewtonPerMetre, Number, Pascal
from ..inputs import GearsInputs
from ..result import MeshResult
from ..wheel_inputs import Wheel
from . import strength as iso6336
from .classes import StrengthClass
from .distribution import CLAUSE_7
from .dynamic import CLAUSE_6, CLAUSE_9, MAIN_TO
from .load import RatingContext, RatingLoad
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


def checks(context: RatingContext, rated: Mapping[str, MeshRating], load: Mapping[str, RatingLoad]) -> Iterator[Check]:
    """Of each mesh by itself, then of the safeties of all and of what they stand on."""
    gears, meshes = context.gears, context.train.meshes
    for key, mesh_rating in rated.items():
        yield from mesh_checks(key, meshes[key], mesh_rating, load[key])
    yield from strength_checks({key: mesh.strength for key, mesh in rated.items() if mesh.strength is not None})
    for wheel in gears.wheels:
        if wheel.name not in context.classes:
            yield check(
                f"gears.{wheel.name}.safety_bending",
                Text("Safety of {wheel} against tooth breakage", wheel=wheel.name),
                math.nan,
                ">=",
                S_F_LEAST,
                "",
                MINIMUM_F,
                Text("Without a strength class the wheel and its meshes have no safety."),
                missing=(dotted("gears", GearsInputs.wheels, wheel.name, Wheel.gear_material),),
            )
    yield roughness_check(gears.root_rz)
    for name, cls in context.classes.items():
        yield from hardness_checks(name, cls)


def mesh_checks(key: str, mesh: MeshResult, rated: MeshRating, load: RatingLoad) -> Iterator[Check]:
    """Of one mesh, its strength excepted; `key`: DRIVER_DRIVEN."""
    pair = mesh.title
    for wheel, form in rated.forms.items():
        yield check(
            f"gears.{key}.notch_{wheel}",
            Text("Notch parameter q_s of {wheel}", wheel=wheel),
            form.q_s,
            "in",
            (1.0, 8.0),
            "",
            Text("ISO 6336-3: range of Y_S"),
            Text("The stress correction factor is outside its range: choose a larger tip radius of the tool."),
        )
    if (factor_check := application_factor_check(key, pair, load)) is not None:
        yield factor_check
    if rated.least_torque is not None:
        yield check(
            f"gears.{key}.flank_reversal",
            Text("Least torque of {name} over the cycle", name=pair),
            rated.least_torque,
            ">=",
            0.0,
            "N·m",
            Text("the flanks stay in touch while the torque does not change its sign"),
            Text(
                "The teeth rattle: hold the backlash small, prefer helical teeth with a large overlap, or take a "
                "heavier flywheel or a wheel that is sprung against play."
            ),
        )
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
    source, effect = Text("mean and dynamic torque over the mean"), Text("the peak of both is then rated")
    left_out = by_key(GearsInputs, dotted("gears", GearsInputs.application_factor), None, effect=effect)
    return check(f"gears.{key}.application_factor", name, load.K_A, ">=", needed, "", source, remedies=left_out)


def influence_checks(key: str, mesh: MeshResult, factors: Influence) -> Iterator[Check]:
    id, pair = f"gears.{key}", mesh.title
    below = factors.resonance_ratio <= 1
    yield check(
        f"{id}.line_load",
        Text("Load per face width {pair}", pair=pair),
        factors.line_load,
        ">=",
        LEAST_LOAD,
        "N/mm",
        Text("{iso}: below 50 N/mm flanks can part and hammer; the factors are made for 100 N/mm and more", iso=ISO),
        Text(
            "K_V, K_Hβ and K_Hα are outside their validity here: small deviations over a small load. "
            "What governs is the torque of the speed's irregularity "
            "or the application factor; a narrower face width raises the load per width."
        ),
    )
    yield check(
        f"{id}.resonance",
        Text("Speed of {pair} over its main resonance, {speed_range}", pair=pair, speed_range=factors.speed_range),
        factors.resonance_ratio,
        "<=" if below else ">=",
        factors.lower_resonance if below else MAIN_TO,
        "",
        Text("{clause_6}: the main resonance lies from N_S to 1.15", clause_6=CLAUSE_6),
        Text(
            "Change the number of teeth, or the mass of the wheels, so that the teeth do not meet at the natural "
            "frequency of the pair."
        ),
    )
    yield check(
        f"{id}.shift_sum",
        Text("Sum of the profile shifts {pair}", pair=pair),
        mesh.shift_sum,
        "in",
        (-0.5, 2.0),
        "",
        Text("{clause_9}: range of the stiffness of the teeth", clause_9=CLAUSE_9),
        Text("The stiffness of the teeth is extrapolated; the factors K are uncertain."),
    )
    if factors.line_load >= LEAST_LOAD:  # below it no teeth are pressed together over their whole width
        yield check(
            f"{id}.contact_width",
            Text("Face width that touches, {pair}", pair=pair),
            factors.contact_width_share,
            ">=",
            1.0,
            "%",
            Text("{clause_7}: K_Hβ up to 2", clause_7=CLAUSE_7),
            Text(
                "The load is too small to press the misaligned teeth together over the whole face width: crown or "
                "end-relieve the teeth, or hold the axes more parallel (misalignment of the mesh, accuracy grade)."
            ),
        )


# --- strength


def strength_checks(meshes: Mapping[str, MeshStrength]) -> Iterator[Check]:
    """Of every mesh its flanks, of every wheel the weakest of its roots; none where there is no load."""
    roots: dict[str, tuple[Number, str]] = {}
    for key, mesh in meshes.items():
        yield from _contact_checks(key, mesh)
        for wheel, strength in mesh.bending.items():
            if strength.S_F is not None and (wheel not in roots or strength.S_F < roots[wheel][0]):
                roots[wheel] = strength.S_F, mesh.pair
    for wheel, (S_F, pair) in roots.items():
        id, name = f"gears.{wheel}.safety_bending", Text("Safety of {wheel} against tooth breakage", wheel=wheel)
        for suffix, label, least in (
            ("", Text("{name}, in {pair}", name=name, pair=pair), S_F_LEAST),
            ("_usual", Text("{name}, usual", name=name), S_F_USUAL),
        ):
            yield check(f"{id}{suffix}", label, S_F, ">=", least, "", MINIMUM_F, _advice(wheel, least / S_F))


def _contact_checks(key: str, mesh: MeshStrength) -> Iterator[Check]:
    safeties = {wheel: flank.S_H for wheel, flank in mesh.contact.items() if flank.S_H is not None}
    if not safeties:
        return
    weak = min(safeties, key=safeties.__getitem__)
    S_H, (one, two), id = safeties[weak], mesh.sides, dotted("gears", key, MeshStrength.safety_contact)
    name = Text(
        "Safety against pitting {name}–{name2}, on stress (on load {s_h}), weaker: {weak}",
        name=one.name,
        name2=two.name,
        s_h=Amount(S_H**2, form=".3g"),
        weak=weak,
    )
    for suffix, label, least in (("", name, S_H_LEAST), ("_usual", Text("{name}, usual", name=name), S_H_USUAL)):
        yield check(f"{id}{suffix}", label, S_H, ">=", least, "", MINIMUM_H, _advice(weak, (least / S_H) ** 2))


def _advice(wheel: str, width: Number) -> Text:
    """`width`: by how much the face width, or the load, would have to change."""
    if width <= 1:
        return EMPTY
    return Text(
        "Give more than {width} times the face width, or bring the load to less than {width2} of it (the load "
        "factors rise as the load per width falls), {better}, or a finer accuracy grade.",
        width=Amount(width, form=".3g"),
        width2=Amount(1 / width, form=".3g"),
        better=Text("a stronger class of {wheel} or a better quality", wheel=wheel),
    )


def roughness_check(root_rz: Metre) -> Check:
    """Whether the surface factor of the root holds."""
    name, most = Text("Roughness Rz of the roots"), iso6336.ROUGHEST_ROOT
    source = Text("ISO 6336-3: Y_RrelT was found up to 40 µm")
    smoother = by_key(GearsInputs, dotted("gears", GearsInputs.root_rz), round(most * 1e6, 6), bound="<=")
    return check("gears.train.root_roughness", name, root_rz, "<=", most, "µm", source, remedies=smoother)


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
    id, name = f"gears.{wheel}.hardness", Text("Hardness of {wheel} for its strength class", wheel=wheel)
    advice = Text("A softer flank does not reach the class: choose another strength class.")
    yield check(id, name, cls.hardness, ">=", cls.low / factor, "HV", source, advice)
    name = Text("{name}, upper end", name=name)
    advice = Text("The strength is that of the upper end: more hardness adds none, and may make the teeth brittle.")
    yield check(f"{id}_most", name, cls.hardness, "<=", cls.high / factor, "HV", source, advice)


# --- screening


def screening_checks(key: str, screened: Screening) -> Iterator[Check]:
    """Of the film, where there is one, and of the contact temperature."""
    title = screened.title
    if screened.specific_film_min is not None:
        limit = Text("λ_GFP by a rule of this program; a test of the oil gives its own")
        if screened.permissible_given:
            limit = Text("λ_GFP of the oil's test")
        place = screened.film_place
        yield check(
            f"gears.{key}.micropitting_film",
            Text("Specific film thickness {title} at {film_place} (screening)", title=title, film_place=place),
            screened.specific_film_min,
            ">=",
            screened.permissible_film,
            "",
            Text("ISO/TR 15144-1:2014, ISO/TS 6336-22:2018, method B; {limit}", limit=limit),
            Text(
                "Smoother flanks (gears.flank_rz_um), cooler or thicker oil, more speed; stronger steel does not help. "
                "{pressure}",
                pressure=_pressure(screened.film_pressure or 0.0),
            ),
        )
    assumed = "" if screened.load_stage_given else Text(", assumed by a rule of this program")
    stage = Text("FZG load stage {load_stage}", load_stage=Amount(screened.load_stage, form="g")) + assumed
    yield check(
        f"gears.{key}.scuffing",
        Text("Scuffing temperature above the contact temperature {title} (screening)", title=title),
        screened.scuffing_margin,
        ">=",
        MARGIN,
        "K",
        Text("ISO/TR 13989-1:2000 (ISO/TS 6336-20), 10.5: for instance 50 K; {stage}", stage=stage),
        Text(
            "Cooler oil, an oil of a higher load stage, smoother flanks, less sliding (shorter addenda), or more "
            "face width."
        ),
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
