# SPDX-License-Identifier: Apache-2.0
"""[[fits]] as a file has it: what is refused, each at its place, all at once."""

import pytest

from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.studies.shipped import DESIGNS

GAMMA = read(DESIGNS / "r753ie4_gamma.toml")
FRONT, OIL = "shafts.shaft.bearings.front.clearance_um", "bearings.supply_temperature_C"
RUNS = "speed_rpm,t,P\n1000,110,30\n2000,112,120\n"


@pytest.fixture
def fitted_to(tmp_path):
    """The design with a run in a file beside it, and these rows of [[fits]]."""
    (tmp_path / "drag.csv").write_text(RUNS)

    def made(*fits: dict[str, object], conditions: tuple[str, ...] = ()):
        run = {
            "name": "drag-run",
            "file": "drag.csv",
            "speed": "speed_rpm",
            "conditions": [{"column": "t", "key": key} for key in conditions],
            "columns": [{"column": "P", "value": "friction.bearing_loss", "uncertainty_percent": 2}],
        }
        return design(Document(GAMMA.data | {"measurements": [run], "fits": list(fits)}, str(tmp_path / "design.toml")))

    return made


def free(key: str = FRONT, low: float = 50, high: float = 140, **more: object) -> dict[str, object]:
    return {"key": key, "low": low, "high": high, **more}


def fit(*rows: dict[str, object], **more: object) -> dict[str, object]:
    return {"name": "drag", "free": list(rows), **more}


def test_a_fit_is_read(fitted_to):
    (row,) = fitted_to(fit(free(start=80, prior=85, prior_sd=8), of=["drag-run"])).fits
    assert (row.name, row.of, row.free[0].key, row.free[0].prior_sd) == ("drag", ("drag-run",), FRONT, 8)


REFUSED = {
    "no such key": (fit(free("shafts.shaft.bearings.front.clearence_um")), f'did you mean "{FRONT}"'),
    "a word": (fit(free("bearings.oil")), "one number"),
    "a whole number": (fit(free("engine.cylinders", 1, 4)), "whole number"),
    "a list": (fit(free("countershaft.bearing_positions_mm")), "is no input of this design"),
    "no table": (fit(free("document.number")), "is no input of this design"),
    "low above high": (fit(free(low=140, high=50)), "must be larger than low"),
    "low is high": (fit(free(low=50, high=50)), "must be larger than low"),
    "below what the key allows": (fit(free(low=-10)), "must be"),
    "start outside": (fit(free(start=150)), "must lie from low to high"),
    "prior outside": (fit(free(prior=20, prior_sd=3)), "must lie from low to high"),
    "prior alone": (fit(free(prior=80)), "stand together"),
    "prior_sd alone": (fit(free(prior_sd=80)), "stand together"),
    "prior_sd of nothing": (fit(free(prior=80, prior_sd=0)), "above 0"),
    "nothing free": (fit(), "needs 1 to 4"),
    "five": (fit(*[free(f"engine.{k}_mm", 20, 90) for k in "abcde"]), "has 5 inputs; needs 1 to 4"),
    "twice": (fit(free(), free()), "is free already"),
    "no such run": (fit(free(), of=["drag-rum"]), 'did you mean "drag-run"'),
    "a run twice": (fit(free(), of=["drag-run", "drag-run"]), "stands twice"),
    "not known": (fit(free(lower=3)), "lower"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused(fitted_to, case):
    row, reason = REFUSED[case]
    with pytest.raises(BadInput, match=reason) as bad:
        fitted_to(row)
    assert all(error.key.startswith("fits.0") for error in bad.value.errors)


def test_what_a_condition_sets_is_not_free(fitted_to):
    with pytest.raises(BadInput, match="is set by a condition of drag-run"):
        fitted_to(fit(free(OIL, 90, 130)), conditions=(OIL,))
    fitted_to(fit(free(OIL, 90, 130)))


def test_two_of_one_name(fitted_to):
    with pytest.raises(BadInput, match="stands twice"):
        fitted_to(fit(free()), fit(free()))


def test_all_mistakes_at_once(fitted_to):
    with pytest.raises(BadInput) as bad:
        fitted_to(fit(free(start=150), free("bearings.oil"), of=["x"]), {"name": "b", "free": [free(low=200)]})
    assert len(bad.value.errors) >= 3


def test_a_fit_without_a_run():
    with pytest.raises(BadInput, match=r"add \[\[measurements\]\]"):
        design(Document(GAMMA.data | {"fits": [fit(free())]}, "gamma"))
