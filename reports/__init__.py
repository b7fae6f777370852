# SPDX-License-Identifier: Apache-2.0
"""What leaves on paper or in a file: the report as PDF and Word, the comparison, drawings for CAD; and its
verification.

It is made from what the sheet of each step has (values, checks, curves, tables), and imports no step."""
