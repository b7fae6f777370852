# SPDX-License-Identifier: Apache-2.0
"""Bearings to choose from: a search over length, clearance, oil and supply at the worst corner of tolerances."""
