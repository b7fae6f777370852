"""Each check of the friction just inside and just outside its limit."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from calc.friction.checks import checks, errata, oil_level_checks
from calc.friction.inputs import FrictionInputs
from calc.friction.losses.turning_masses import MassLoss
from calc.friction.models import Regression
from calc.sheet.quantity import dotted
from tests.calc.friction.pairs import closed, friction, fzg, oil

MESH = "pinion_gear"
SOLVED = closed(
    shaft_power=None,
    power=41e3,
    speed=36.0,
    T=90.0,
    oil="FVA 3 (ref mineral)",
    meshes={MESH: fzg(20e-3)},
    flank_roughness=(0.4e-6,),
)
RESULT = SOLVED.result
JUDGED = RESULT.meshes[MESH].judged
MODELS = tuple(RESULT.meshes[MESH].published_models)


class AnOil:
    """Of which the checks ask for its viscosity, its temperature and how far its rows reach."""

    def __init__(self, nu=20e-6, T_m=90.0, reach=None, constant=False):
        self.T_m = T_m
        self.lubricant = SimpleNamespace(nu=lambda T: nu, reach=reach, constant=constant)


def found(oil=None, mesh=(), judged=(), said=(), **changes):
    """The checks by their ids, of the train with some of its results replaced; `said`: of the inputs."""
    meshes = {MESH: replace(RESULT.meshes[MESH], **{"judged": replace(JUDGED, **dict(judged)), **dict(mesh)})}
    result = replace(RESULT, **{"meshes": meshes, **changes})
    return {check.id: check for check in checks(friction(**dict(said)), result, oil or AnOil())}


def judged(said=(), **changes):
    return found(judged=changes, said=said)


def lost(share):
    """A bracket as wide as this share of all losses."""
    return MassLoss(mass_loss_low=1.0, mass_loss_high=1.0 + share * RESULT.total_loss, mass_loss=1.0)


def published(*losses, outside=""):
    """As many regressions as there are, all inside their range at a sliding loss of 100 W, but for `outside`."""
    models = {name: Regression(loss=loss, friction_mean=0.05) for name, loss in zip(MODELS, losses)}
    models |= {name: None for name in MODELS[len(losses) :]}
    if outside:
        models[MODELS[0]] = replace(models[MODELS[0]], outside=outside)
    return found(mesh=dict(published_models=models), judged=dict(sliding_loss=100.0))


CASES = [
    ("friction.train.balance", found(residual=-0.9e-6), found(residual=-1.03e-6), "fail"),
    ("friction.train.balance", found(residual=0.9e-6), found(residual=1.03e-6), "fail"),
    ("friction.train.delivered", found(delivered_power=0.06 * RESULT.crank_power), found(delivered_power=0.0), "fail"),
    ("friction.train.mass_bracket", found(masses=lost(0.099)), found(masses=lost(0.101)), "note"),
    ("friction.train.models", published(*[100.0] * len(MODELS)), published(*[100.0] * (len(MODELS) - 1)), "note"),
    ("friction.train.models", published(*[100.0] * 4), published(*[100.0] * 4, outside="speed"), "note"),
    ("friction.train.oil_rows", found(AnOil(reach=(0.0, 90.1))), found(AnOil(reach=(0.0, 89.9))), "note"),
    ("friction.train.oil_rows", found(AnOil(reach=(89.9, 150.0))), found(AnOil(reach=(90.1, 150.0))), "note"),
    (f"friction.{MESH}.power_out", found(mesh=dict(power_out=2100.0)), found(mesh=dict(power_out=0.0)), "fail"),
    (f"friction.{MESH}.regime", judged(lead_at_pitch=1.001), judged(lead_at_pitch=0.999), "note"),
    (f"friction.{MESH}.lambda", judged(lambda_min=1.001), judged(lambda_min=0.999), "note"),
    (f"friction.{MESH}.models", published(129.9, 100.0), published(100.0, 130.1), "warn"),
    (f"friction.{MESH}.models", published(100.0, 77.0), published(76.8, 100.0), "warn"),
    (f"friction.{MESH}.deborah", judged(deborah_max=0.999), judged(deborah_max=1.001), "note"),
    (
        f"friction.{MESH}.inlet_heating",
        judged(thermal_reduction_min=0.0501),
        judged(thermal_reduction_min=0.05),
        "note",
    ),
    (f"friction.{MESH}.bulk", found(mesh=dict(bulk_rise=9.99)), found(mesh=dict(bulk_rise=10.01)), "note"),
    (f"friction.{MESH}.bulk_temperature", judged(bulk_temperature=149.9), judged(bulk_temperature=150.1), "warn"),
]


@pytest.mark.parametrize("id, inside, outside, verdict", CASES)
def test_inside_and_outside(id, inside, outside, verdict):
    assert (inside[id].verdict, outside[id].verdict) == ("pass", verdict)


@pytest.mark.parametrize(
    "id, quoted",
    [
        ("friction.train.balance", "conservation of energy"),
        ("friction.train.delivered", "conservation of energy"),
        ("friction.train.mass_bracket", "no measurement of half-moon masses was found"),
        ("friction.train.models", "ranges of Schlenk 1994, Niemann & Winter, Xu and Kahraman 2005"),
        ("friction.train.oil_rows", "beyond its rows the viscosity is that of the outermost line carried on"),
        (f"friction.{MESH}.power_out", "conservation of energy"),
        (f"friction.{MESH}.regime", "Johnson 1970, regimes of fluid-film lubrication"),
        (f"friction.{MESH}.lambda", "AGMA 925-A03: mixed friction below about 1"),
        (f"friction.{MESH}.models", "published models of tooth friction differ by as much among themselves"),
        (f"friction.{MESH}.deborah", "4.4: range of Eyring's law"),
        (f"friction.{MESH}.inlet_heating", "rule of this program"),
        (f"friction.{MESH}.bulk", "rule of this program"),
        (f"friction.{MESH}.bulk_temperature", "case-hardened steel loses hardness from about 150 to 180 °C on"),
    ],
)
def test_sources(id, quoted):
    inside = next(inside for case, inside, *_ in CASES if case == id)
    assert quoted in str(inside[id].source)


OUTLINE = SimpleNamespace(
    pieces=[
        SimpleNamespace(what=what, outer_radius=R) for what, R in (("journal", 0.03), ("sector", 0.022), ("full", 0.04))
    ]
)


def sectors_over_oil(level, outline=OUTLINE, **said):
    inputs = SimpleNamespace(axis=(0.1, 0.05), outer_radius=None)
    return list(oil_level_checks(SimpleNamespace(**{**vars(inputs), **said}), outline, level))


def test_the_oil_stays_below_what_the_sectors_sweep():
    (dry,), (wet,) = sectors_over_oil(0.0779), sectors_over_oil(0.0781)
    assert (dry.verdict, wet.verdict) == ("pass", "warn") and dry.id == "countershaft.oil_level"
    assert (dry.value, dry.limit) == (pytest.approx(78.0), pytest.approx(77.9))
    (unknown,) = sectors_over_oil(0.0, axis=None)
    assert unknown.verdict == "not_verified"
    (nobody_knows,) = sectors_over_oil(0.0, outline=None)
    assert nobody_knows.verdict == "not_verified" and nobody_knows.missing == ("shafts.S.outer_radius_mm",)
    (by_envelope,) = sectors_over_oil(0.0, outline=None, outer_radius=0.03)
    assert by_envelope.value == pytest.approx(70.0)


def test_a_microwatt_may_be_left_over():
    assert [found(residual=x)["friction.train.balance"].holds for x in (0.98e-6, 1.02e-6)] == [True, False]


@pytest.mark.parametrize("nu, asked", [(2.01e-6, False), (1.99e-6, True), (0.0999, False), (0.1001, True)])
def test_a_viscosity_outside_its_law_is_noted(nu, asked):
    check = found(AnOil(nu=nu)).get("friction.train.viscosity_range")
    assert (check is not None) is asked
    if asked:
        assert check.verdict == "note" and "range of the viscosity law" in str(check.source)
        assert "friction.train.viscosity_range" not in found(AnOil(nu=nu, constant=True))


def test_power_is_measured_against_the_power_that_comes_in():
    taken_in, first = RESULT.meshes[MESH].power_in, RESULT.crank_power
    made = found(mesh=dict(power_out=0.04 * taken_in), delivered_power=0.04 * first)
    for id in (f"friction.{MESH}.power_out", "friction.train.delivered"):
        assert made[id].verdict == "warn" and made[id].margin == pytest.approx(0.04)


def test_the_models_are_compared_only_where_the_film_is_ehl_and_something_slides():
    id = f"friction.{MESH}.models"
    assert id in found()
    assert id not in judged(lead_at_pitch=0.999) and id not in judged(sliding_loss=0.0)
    assert id not in published(*[0.0] * len(MODELS))
    # however light: a wheel of a model of an engine
    assert id in judged(lead_at_pitch=1.001, sliding_loss=0.5)
    assert published(0.4).get(id) is not None


@pytest.mark.parametrize("film, rolling, ways", [("judged", True, 0), ("source", False, 1)])
def test_a_rigid_film_is_answered_by_the_film_that_knows_it(film, rolling, ways):
    """Where the regime is judged already, its rolling is an upper bound and nothing is to be changed."""
    check = judged(said=dict(film=film), lead_at_pitch=0.999)[f"friction.{MESH}.regime"]
    assert ("The rolling loss is an upper bound." in str(check.advice)) is rolling
    key = dotted("friction", FrictionInputs.film)
    assert [remedy.changes for remedy in check.remedies] == [((key, "judged"),)] * ways


@pytest.mark.parametrize(
    "lead, said, expected",
    [
        (0.999, {}, "film_min"),
        (1.001, {}, ""),
        (0.999, dict(film="source"), ""),
        (1.001, dict(film="source"), ""),
    ],
)
def test_what_is_wrong_in_the_source_of_the_film(lead, said, expected):
    """Its film where a rigid one governs."""
    mesh = replace(RESULT.meshes[MESH], judged=replace(JUDGED, lead_at_pitch=lead))
    rows = errata(friction(**said), replace(RESULT, meshes={MESH: mesh}), oil("FVA 3 (ref mineral)", 90.0))
    theirs = {row.about: row.source_value for row in rows if row.about.endswith(".film_min")}
    film = pytest.approx(mesh.source.film_min / 1e-6)
    assert theirs == ({f"friction.{MESH}.{expected}": film} if expected else {})


def test_the_warming_of_the_teeth_is_asked_only_where_it_is_not_taken():
    id = f"friction.{MESH}.bulk"
    assert id in found()
    assert id not in found(said=dict(bulk_temperature=100.0)) and id not in found(said=dict(bulk="estimated"))
