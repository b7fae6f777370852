# SPDX-License-Identifier: Apache-2.0
"""Bearings to choose from: a search over length, clearance, oil and supply, judged at the worst corner of the
tolerances."""
