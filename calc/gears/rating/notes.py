# SPDX-License-Identifier: Apache-2.0
"""What the rating rests on, in words: what was chosen where nothing is given, and where a method leaves its range."""

from collections.abc import Iterable, Iterator, Mapping

from ...sheet.number import short
from ...sheet.text import COMMA, Amount, Text, plural
from ...sheet.units import Number
from ..result import ToothSystem
from .classes import classes_of
from .dynamic import LIGHT
from .load import RatingContext, RatingLoad
from .result import Influence, MeshRating, MeshStrength
from .screening.load import Screening
from .screening.scuffing import LOAD_STAGE, PERMISSIBLE_FILM
from .strength import LONGEST, endurance, flank_knees, root_knees

TESTED = Text("modules of 3 to 11 mm and 8 to 60 m/s")


def notes(context: RatingContext, rated: Mapping[str, MeshRating], load: Mapping[str, RatingLoad]) -> tuple[Text, ...]:
    """All notes of the rating, each once; `rated` and `load` by DRIVER_DRIVEN."""
    gears, train = context.gears, context.train
    notes = [*_load_notes(context, next(iter(load.values())))]
    for w in gears.wheels:
        if w.name not in context.classes:
            usual = classes_of(w.material)
            notes.append(
                Text(
                    "Wheel {name}: no strength class is given, and that of {material} is not plain: its meshes have no "
                    "load factors and no safety. Give gears.wheels.{name}.gear_material{choices}.",
                    name=w.name,
                    material=w.material,
                    choices=Text(" ({usual})", usual=Text(" or ").join(usual)) if usual else "",
                )
            )
    title = {key: train.meshes[key].title for key in rated}
    notes += influence_notes(
        {title[key]: rating.influence for key, rating in rated.items() if rating.influence is not None},
        gears.accuracy_grade,
    )
    if idle := [
        title[key] for key, rating in rated.items() if rating.influence is None and not rating.tangential_force
    ]:
        notes.append(
            plural(
                "Mesh {pairs}: no load, so no load factors and no safety.",
                "Meshes {pairs}: no load, so no load factors and no safety.",
                n=len(idle),
                pairs=COMMA.join(idle),
            )
        )
    notes += strength_notes(
        {key: rating.strength for key, rating in rated.items() if rating.strength is not None}, gears.iso_6336_edition
    )
    screened = [rating.screening for rating in rated.values() if rating.screening is not None]
    if context.oil is not None:
        notes += screening_notes(train.system, screened, context.oil.lubricant.oil.base)
    return tuple(dict.fromkeys(notes))


def _load_notes(context: RatingContext, load: RatingLoad) -> Iterator[Text]:
    gears = context.gears
    K_A = Amount(load.K_A, form="g")
    yield Text(
        "Rating by ISO 6336:{iso_6336_edition}, method B; contact and root stress are nominal, K = 1.",
        iso_6336_edition=gears.iso_6336_edition,
    )
    if gears.application_factor is not None:
        yield Text(
            "Load: the mean torque times the given application factor {application_factor}.", application_factor=K_A
        )
    elif load.dynamic is not None:
        yield Text("Load: the mean torque plus the dynamic torque of the crank's irregularity, its peak; K_A = 1.")
    else:
        yield Text(
            "Application factor: not given; chosen: {k_a} on the mean torque. The torque by the crank's irregularity "
            "is the larger load of such a train: a safety is verified where {worst} in its place leaves enough. Give "
            "the irregularity of the first driver's speed, or the gas and the inertia of the flywheel.",
            k_a=K_A,
            worst=Amount(load.at_worst, form=".3g"),
        )
    if gears.flank_rz is None:
        yield Text(
            "Flank roughness: not given; chosen: Rz {flank_rz} µm.", flank_rz=Amount(context.flank_rz * 1e6, form="g")
        )
    if context.nu_40 is None:
        yield Text(
            "No oil is known: the lubricant factor is that of 100 mm²/s at 40 °C, and film and flash temperature have "
            "no value."
        )


def influence_notes(factors: Mapping[str, Influence], grade: Number) -> Iterator[Text]:
    """What was assumed, and what is outside its range; `factors` by the titles of their meshes."""
    misaligned = [
        Text("{pair} {size}", pair=pair, size=Amount(influence.manufacturing_misalignment * 1e6, "µm", form=".3g"))
        for pair, influence in factors.items()
        if not influence.misalignment_given
    ]
    if misaligned:
        yield Text(
            "Misalignment by manufacture not given; chosen: {meshes} from the helix slopes that grade {grade} of ISO "
            "1328-1 permits both wheels of a mesh; no crowning.",
            meshes=COMMA.join(misaligned),
            grade=Amount(grade, form="g"),
        )
    lighter = [
        Text(
            "{pair} {now} ({held})",
            pair=pair,
            now=Amount(influence.face_load_factor_flank, form=".3g"),
            held=Amount(held, form=".3g"),
        )
        for pair, influence in factors.items()
        if (held := influence.face_load_factor_at_100) is not None
    ]
    if lighter:
        yield Text(
            "K_Hβ is that of the load as it is; in brackets what it would be held at 100 N/mm, as DIN 3990-11 does: "
            "{meshes}.",
            meshes=COMMA.join(lighter),
        )
    beyond: dict[Text, list[str]] = {}
    for pair, influence in factors.items():
        if influence.out_of_range:
            beyond.setdefault(COMMA.join(influence.out_of_range), []).append(pair)
    for sizes, pairs in beyond.items():
        yield plural(
            "Mesh {pairs}: ISO 1328-1 has no tolerances for {out_of_range}: they are extrapolated.",
            "Meshes {pairs}: ISO 1328-1 has no tolerances for {out_of_range}: they are extrapolated.",
            n=len(pairs),
            pairs=COMMA.join(pairs),
            out_of_range=sizes,
        )


def strength_notes(meshes: Mapping[str, MeshStrength], edition: int) -> Iterator[Text]:
    """What was assumed: classes, life, and what an edition or a range leaves open."""
    sides = [side for mesh in meshes.values() for side in mesh.sides]
    noted: dict[Text, dict[str, None]] = {}  # the wheels of each note, each once
    for side in sides:
        for note in side.strength.notes:
            noted.setdefault(note, {})[side.name] = None
    for note, names in noted.items():
        yield plural(
            "Wheel {names}: {note}.", "Wheels {names}: {note}.", n=len(names), names=COMMA.join(names), note=note
        )
    if any(side.cycles is None for side in sides):
        knees = sorted({endurance(flank_knees(side.strength.kind)) for side in sides})
        yield Text(
            "No life is given: flanks by their strength at {map} cycles (Z_NT = 1), roots at 3·10⁶ (Y_NT = 1). A "
            "given life past these takes up to 15 % off, down to 0.85 at 10¹⁰ cycles.",
            map=Text(" or ").join(map(short, knees)),
        )
    lives = [(s.name, s.cycles, endurance(root_knees(s.strength.kind))) for s in sides if s.cycles is not None]
    if brief := dict.fromkeys(name for name, cycles, knee in lives if cycles < knee):
        yield Text(
            "Short life of {brief}: film, notch and surface factors are kept as for long life, which the standard "
            "lets fade towards static strength.",
            brief=", ".join(brief),
        )
    if beyond := dict.fromkeys(name for name, cycles, _ in lives if cycles > LONGEST):
        yield Text(
            "More than 10¹⁰ cycles of {beyond}: the life curves of ISO 6336 end there; their last lines are continued.",
            beyond=", ".join(beyond),
        )
    yield Text(
        "Safety: S_H ≥ 1.0 and S_F ≥ 1.4 are limits, 1.2 and 1.6 advice: a rule of this program from the usual values; "
        "ISO 6336 leaves them to agreement."
    )
    if edition >= 2019:
        yield Text(
            "ISO 6336-2:2019 adds f_ZCa to the flanks of helical wheels without tip relief (from memory up to 1.2 on "
            "the square of the contact stress): not applied."
        )


def screening_notes(system: ToothSystem, screened: list[Screening], base: str) -> Iterator[Text]:
    """What the screening of all meshes rests on; `base` is the base stock of the oil."""
    if not screened:
        return
    loads = [s.line_load for s in screened]
    light = Text(
        ", and the line loads of {span} N/mm, with all load factors, are far below those of the tests.",
        span=_span([w / 1e3 for w in loads]),
    )
    yield Text(
        "Film against micropitting and flash temperature against scuffing are a screening, not a rating: that of "
        "the film is made from tests with {tested} (ISO/TS 6336-22:2018); here m_n is {m_n} mm, {span} m/s",
        tested=TESTED,
        m_n=Amount(system.m_n * 1e3),
        span=_span([s.pitch_line_speed for s in screened]),
    ) + (light if max(loads) < LIGHT else ".")
    if not all(s.load_stage_given for s in screened):
        yield Text(
            "No FZG load stage of the oil is given: stage {load_stage} of the test A/8.3/90 is assumed for its "
            "scuffing temperature.",
            load_stage=Amount(LOAD_STAGE, form="g"),
        )
    if not all(s.permissible_given for s in screened):
        yield Text(
            "No micropitting test of the oil is given: a specific film thickness of {permissible_film} is taken as "
            "permissible.",
            permissible_film=Amount(PERMISSIBLE_FILM, form="g"),
        )
    if base not in ("mineral", "PAO", "PAG"):
        yield Text("The lubricant factor of {base} oil is not in the methods: it counts as mineral oil.", base=base)
    if alone := [s.title for s in screened if not s.method_applies]:
        yield plural(
            "Mesh {pairs}: with ε_α of 2 or more the methods give no load sharing; one pair is taken to carry all, on "
            "the safe side.",
            "Meshes {pairs}: with ε_α of 2 or more the methods give no load sharing; one pair is taken to carry all, "
            "on the safe side.",
            n=len(alone),
            pairs=COMMA.join(alone),
        )
    if hot := [s.title for s in screened if s.specific_film_min is None]:
        yield plural(
            "Mesh {pairs}: a contact hotter than 500 °C is beyond the law of the oil: no film is given.",
            "Meshes {pairs}: contacts hotter than 500 °C are beyond the law of the oil: no film is given.",
            n=len(hot),
            pairs=COMMA.join(hot),
        )


def _span(numbers: Iterable[float]) -> Text:
    low, high = (Amount(extreme(numbers), form=".3g") for extreme in (min, max))
    return Text("{low}", low=low) if low.written() == high.written() else Text("{low} to {high}", low=low, high=high)
