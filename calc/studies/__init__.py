# SPDX-License-Identifier: Apache-2.0
"""What is asked of whole designs: comparing, explaining, sweeping, searching, repairing, beginning, drawing,
validating.

`shipped.py` has the designs and engines that come with the program, `processes.py` spreads long work."""
