# SPDX-License-Identifier: Apache-2.0
"""Backlash: over the tolerances of the centre distance, over temperature, and what it means for the last wheel."""
