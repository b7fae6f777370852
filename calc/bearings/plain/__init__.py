# SPDX-License-Identifier: Apache-2.0
"""Plain bearings: film, friction, oil flow, temperature, clearance, what suits them, and a search for better ones."""
