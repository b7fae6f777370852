# SPDX-License-Identifier: Apache-2.0
"""An input is found and changed by the keys that `--set` knows."""

import pytest

from calc.design.toml_file import load_design
from calc.sheet.inputs_at import content_at, with_content
from tests.conftest import GAMMA


@pytest.mark.parametrize("mesh", ["2", "idler_shaft"])
def test_a_mesh_by_its_wheels_or_its_place(mesh):
    design = load_design(GAMMA)
    key = f"gears.meshes.{mesh}.tolerance_um"
    assert content_at(design, key)[0] == design.gears.meshes[2].tolerance
    assert with_content(design, key, 1e-5).gears.meshes[2].tolerance == 1e-5
    assert content_at(design, "gears.meshes.9.tolerance_um") == (None, None)
    with pytest.raises(LookupError):
        with_content(design, "gears.meshes.9.tolerance_um", 1e-5)
