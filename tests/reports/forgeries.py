# SPDX-License-Identifier: Apache-2.0
"""All kinds of forgeries, each known by its name as soon as its file is loaded."""

from tests.reports import forged_files, forged_looks, forged_parts, forged_structure
from tests.reports.forging import EMPTY, KINDS, Update, streamed

__all__ = ["EMPTY", "KINDS", "Update", "forged_files", "forged_looks", "forged_parts", "forged_structure", "streamed"]
