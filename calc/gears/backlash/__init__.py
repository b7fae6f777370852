# SPDX-License-Identifier: Apache-2.0
"""Backlash over the tolerances of the centre distance and over temperature, and what it means for the last wheel."""
