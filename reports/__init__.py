# SPDX-License-Identifier: Apache-2.0
"""What leaves on paper or in a file: the report as PDF and Word, the comparison, drawings for CAD; and its
verification.

It is made from what the sheet of each step has (values, checks, curves, tables), and imports no step."""

from typing import TYPE_CHECKING

from calc.sheet.offered import offer

if TYPE_CHECKING:
    from .report import write_report as write_report

offer(globals())
